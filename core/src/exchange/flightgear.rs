//! FlightGear's clouds as models and back, and its layers as clouds side by side.
//!
//! A kind of cloud becomes a model of one box: as wide and high as the middle of its ranges, less the least sprite, as in
//! SimGear; sprites and counts as they are, culled within SimGear's 0.316 of their height. Factors of light become colour
//! levels (times [`WHITE`], under our ambient light) and, on the shady side, the box's own light: with [`AMBIENT`] times as
//! much ambient as direct light, `shade` of the light is left there.
//!
//! The simulator shows one kind of layer at a height and draws its groups by chance. Here each layer is a row from west to
//! east, with as many of each group as it weighs, and the next layer lies south of it.

use super::{Arrived, ArrivedCloud, Arriving, Content, ExportError, Files, Leaving, Note};
use crate::color::Rgba;
use crate::formats::Misread;
use crate::formats::flightgear::{self, FgBox, FgCloud, FgLayer, FgLayers};
use crate::random::{draw, unit};
use crate::scene::{
    BoxId, Category, CloudBox, CloudModel, ColorLevel, ColorLevels, CullRadius, GroupLight, IdCounter, ModelId,
};
use crate::weather::CloudNow;
use glam::DVec3;
use std::collections::BTreeMap;

/// Of a colour level that takes all the light; a new cloud's highest is as bright.
const WHITE: f64 = 0.76;
/// Ambient light by direct light, at noon.
const AMBIENT: f64 = 0.75;
/// Of a sprite's height: SimGear's √0.1.
const CULL: f64 = 0.316;
/// From one group of a layer to the next, and from one layer to the next, metres.
const GROUP_M: f64 = 6000.0;
const LAYER_M: f64 = 12_000.0;
/// Groups of a layer: of more, the first.
const MOST_GROUPS: usize = 24;
const MOST_CLOUDS: usize = 4000;
const MOST_SPRITES: u64 = 1_000_000;
const MOST_M: f64 = 100_000.0;
/// A sheet of four by four tiles in the simulator's data.
const TEXTURE: &str = "/Textures/Sky/cl_cumulus2.png";

/// All kinds of cloud as models, with clouds where the layers have them.
pub(super) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let layers = flightgear::read(arriving.bytes)?;
    if layers.clouds.is_empty() {
        return Err(Misread::new("clouds", "it has none"));
    }
    layers.clouds.iter().try_for_each(check)?;
    let mut places: BTreeMap<&str, Vec<DVec3>> = BTreeMap::new();
    let mut notes = Vec::new();
    for (row, layer) in layers.layers.iter().enumerate() {
        lay(&layers, layer, row, &mut places, &mut notes)?;
    }
    let clouds: Vec<ArrivedCloud> = layers
        .clouds
        .iter()
        .map(|cloud| ArrivedCloud {
            model: model(cloud),
            places: places.remove(cloud.name.as_str()).unwrap_or_default(),
        })
        .collect();
    let sprites: u64 = layers
        .clouds
        .iter()
        .zip(&clouds)
        .map(|(cloud, made)| u64::from(cloud.sprites) * made.places.len() as u64)
        .sum();
    if sprites > MOST_SPRITES {
        return Err(Misread::new("layers", format!("they ask for {sprites} sprites, and {MOST_SPRITES} is the most")));
    }
    let varied = layers.clouds.iter().filter(|cloud| cloud.width_m[0] != cloud.width_m[1]).count();
    if varied > 0 {
        notes.push(Note::changed(
            format!("{varied} kinds of cloud"),
            "their sizes vary; the middle of the range is taken",
        ));
    }
    notes.push(Note::left_out("sheets of tiles", "the scene's tiles of a like kind are shown"));
    if !layers.unknown.is_empty() {
        let names: Vec<&str> = layers.unknown.iter().take(8).map(String::as_str).collect();
        notes.push(Note::left_out(names.join(", "), "they are not understood"));
    }
    Ok(Arrived { content: Content::Clouds(clouds), notes })
}

/// That its numbers are a cloud's.
fn check(cloud: &FgCloud) -> Result<(), Misread> {
    let wrong = |message: String| Err(Misread::new(format!("clouds/{}", cloud.name), message));
    for (what, [from, to], least) in [
        ("the width", cloud.width_m, 0.0),
        ("the height", cloud.height_m, 0.0),
        ("the sprites' width", cloud.sprite_width_m, 0.001),
        ("the sprites' height", cloud.sprite_height_m, 0.001),
    ] {
        if from < least || to < from || to > MOST_M {
            return wrong(format!("{what} goes from {from} to {to} m; it is {least} to {MOST_M}"));
        }
    }
    if cloud.sprites > 10_000 {
        return wrong(format!("it has {} sprites, and 10000 is the most", cloud.sprites));
    }
    let is_factor = |span: &[f64; 2]| span.iter().all(|factor| (0.0..=10.0).contains(factor));
    if ![cloud.bottom, cloud.middle, cloud.top, cloud.shade].iter().all(is_factor) {
        return wrong("a factor of light is beyond 0 to 10".into());
    }
    if !(0.01..=100.0).contains(&cloud.z_scale) {
        return wrong(format!("z-scale is {}; it is 0.01 to 100", cloud.z_scale));
    }
    Ok(())
}

fn mean([from, to]: [f64; 2]) -> f64 {
    0.5 * (from + to)
}

fn model(cloud: &FgCloud) -> CloudModel {
    let mut ids = IdCounter::default();
    let mut model = CloudModel::new(ModelId::new(&mut ids), &cloud.name, category(&cloud.name));
    let z = cloud.z_scale;
    let [sprite_width, sprite_height] = [cloud.sprite_width_m[0], cloud.sprite_height_m[0]];
    let width = (mean(cloud.width_m) - sprite_width).max(0.0);
    let height = (mean(cloud.height_m) - sprite_height).max(0.0) * z;
    // The middles of the sprites are in it, and their lower edges on the cloud's base.
    let mut own = CloudBox::new(BoxId::new(&mut ids), DVec3::Y * 0.5 * (height + sprite_height * z));
    own.name = "body".into();
    own.size = DVec3::new(width, height, width);
    own.sprite_count = cloud.sprites;
    own.width = cloud.sprite_width_m;
    own.height = cloud.sprite_height_m.map(|height| (height * z).clamp(0.001, MOST_M));
    own.rotation_deg = [0.0, 0.0];
    let c_min = (mean(cloud.shade) * (AMBIENT + 1.0) - AMBIENT).clamp(-4.0, 4.0);
    own.light = GroupLight { c_min, c_med: 0.5 * (c_min + 1.0), ..GroupLight::default() };
    model.boxes.push(own);
    model.cull_radius = CullRadius::Metres(CULL * sprite_height * z);
    model.color_levels = levels([cloud.bottom, cloud.middle, cloud.top].map(mean));
    model
}

fn levels([bottom, middle, top]: [f64; 3]) -> ColorLevels {
    let level = |height: f64, factor: f64| {
        let grey = (WHITE * factor) as f32;
        ColorLevel { height, color: Rgba::new(grey, grey, grey, 1.0) }
    };
    [
        level(0.0, bottom),
        level(0.25, 0.5 * (bottom + middle)),
        level(0.5, middle),
        level(0.75, 0.5 * (middle + top)),
        level(1.0, top),
    ]
}

/// What tiles a kind of cloud shows, by its name's beginning.
fn category(name: &str) -> Category {
    match name.get(..2).unwrap_or_default() {
        "cb" => Category::Cumulonimbus,
        "cu" if name.contains("con") || name.contains("large") => Category::CumulusCongestus,
        "ns" => Category::Nimbostratus,
        "sc" => Category::Stratocumulus,
        "st" => Category::Stratus,
        "ac" => Category::Altocumulus,
        _ => Category::CumulusHumilis,
    }
}

/// The layer that the simulator looks for clouds of that kind in.
fn layer_name(category: Category) -> &'static str {
    match category {
        Category::Cumulonimbus => "cb",
        Category::Nimbostratus => "ns",
        Category::Stratocumulus => "sc",
        Category::Stratus => "st",
        Category::Altocumulus => "ac",
        _ => "cu",
    }
}

/// Adds a layer's clouds, by the names of their kinds.
fn lay<'a>(
    layers: &'a FgLayers,
    layer: &FgLayer,
    row: usize,
    places: &mut BTreeMap<&'a str, Vec<DVec3>>,
    notes: &mut Vec<Note>,
) -> Result<(), Misread> {
    let times = |count: f64| (count.round().clamp(1.0, MOST_GROUPS as f64)) as usize;
    let all: Vec<&str> =
        layer.groups.iter().flat_map(|(name, count)| std::iter::repeat_n(name.as_str(), times(*count))).collect();
    let shown = all.len().min(MOST_GROUPS);
    for (column, name) in all[..shown].iter().enumerate() {
        let Some((_, boxes)) = layers.groups.iter().find(|(own, _)| own == name) else {
            notes.push(Note::left_out(format!("“{name}” in layer “{}”", layer.name), "no boxes have that name"));
            continue;
        };
        let mut dice = Dice { key: (row * MOST_GROUPS + column) as u64, drawn: 0 };
        let x = (column as f64 - 0.5 * (shown as f64 - 1.0)) * GROUP_M;
        let uneven = layer.uneven_m.clamp(-MOST_M, MOST_M) * (dice.mean_of(1) - 0.5);
        let middle = DVec3::new(x, uneven, row as f64 * LAYER_M);
        for FgBox { cloud, count, width_m, height_m, gathered, gathered_up } in boxes {
            let Some(kind) = layers.clouds.iter().find(|kind| kind.name == *cloud) else {
                notes.push(Note::left_out(format!("“{cloud}” in “{name}”"), "no cloud has that name"));
                continue;
            };
            let [width_m, height_m] = [width_m, height_m].map(|metres| metres.clamp(0.0, MOST_M));
            let own = places.entry(kind.name.as_str()).or_default();
            for _ in 0..count.round().clamp(0.0, MOST_CLOUDS as f64) as usize {
                let x = width_m * (dice.mean_of(*gathered) - 0.5);
                let z = width_m * (dice.mean_of(*gathered) - 0.5);
                own.push(middle + DVec3::new(x, height_m * dice.mean_of(*gathered_up), z));
                if own.len() > MOST_CLOUDS {
                    return Err(Misread::new("layers", format!("more than {MOST_CLOUDS} clouds are “{cloud}”")));
                }
            }
        }
    }
    Ok(())
}

/// Random numbers, the same on every machine.
struct Dice {
    key: u64,
    drawn: u32,
}

impl Dice {
    /// The mean of so many numbers from 0 to 1.
    fn mean_of(&mut self, count: u32) -> f64 {
        let count = count.clamp(1, 16);
        let mut sum = 0.0;
        for _ in 0..count {
            sum += unit(draw(1, self.key, self.drawn, 0)[0]);
            self.drawn += 1;
        }
        sum / f64::from(count)
    }
}

/// A kind of cloud for each model that is placed, a box that holds its clouds, and layers by what they are.
pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let models = leaving.scene.models_by_id();
    let mut of_model: BTreeMap<ModelId, Vec<&CloudNow<'_>>> = BTreeMap::new();
    for cloud in leaving.now.clouds.iter().filter(|cloud| !cloud.placed.sprites.is_empty()) {
        of_model.entry(cloud.placed.cloud.model).or_default().push(cloud);
    }
    let mut layers = FgLayers::default();
    for (model, clouds) in of_model.iter().filter_map(|(id, clouds)| Some((models.get(id)?, clouds))) {
        let name = free_name(&layers.clouds, tag(&model.name));
        layers.clouds.push(kind(&name, model, clouds));
        let group = FgBox {
            cloud: name.clone(),
            count: clouds.len() as f64,
            width_m: extent(clouds, |at| [at.x, at.z]),
            height_m: extent(clouds, |at| [at.y, at.y]),
            gathered: 1,
            gathered_up: 1,
        };
        layers.groups.push((name.clone(), vec![group]));
        let of = layer_name(model.category);
        let at = layers.layers.iter().position(|layer| layer.name == of).unwrap_or_else(|| {
            layers.layers.push(FgLayer { name: of.into(), ..FgLayer::default() });
            layers.layers.len() - 1
        });
        layers.layers[at].groups.push((name, 1.0));
    }
    if layers.clouds.is_empty() {
        return Err(ExportError::Nothing("sprites"));
    }
    let bytes = flightgear::write(&layers);
    files.add(leaving.name, &mut |out| out.write_all(&bytes))?;
    Ok(vec![
        Note::changed(
            "clouds",
            "the simulator strews them, and their sprites, by chance: how large and many they are stays",
        ),
        Note::left_out("the tiles", format!("the simulator's {TEXTURE} are shown")),
    ])
}

/// A model as a kind of cloud: as large as its boxes, with as many sprites as its first cloud.
fn kind(name: &str, model: &CloudModel, clouds: &[&CloudNow<'_>]) -> FgCloud {
    let scale = clouds.first().map_or(1.0, |cloud| cloud.placed.cloud.scale);
    let over = |of: fn(&CloudBox) -> [f64; 2]| {
        let spans = model.boxes.iter().map(of);
        let [from, to] = spans.fold([f64::INFINITY, 0.0_f64], |[from, to], [a, b]| [from.min(a), to.max(b)]);
        [from * scale, to * scale]
    };
    let (sprite_width_m, sprite_height_m) = (over(|each| each.width), over(|each| each.height));
    let corners = model.boxes.iter().flat_map(|each| {
        let half = 0.5 * each.size;
        [-1.0, 1.0].into_iter().flat_map(move |x| {
            [-1.0, 1.0]
                .into_iter()
                .flat_map(move |y| [-1.0, 1.0].map(|z| each.center + each.orientation * (half * DVec3::new(x, y, z))))
        })
    });
    let bounds = corners.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    let size = (bounds[1] - bounds[0]) * scale;
    let width = 0.5 * (size.x + size.z) + sprite_width_m[0];
    let height = size.y + sprite_height_m[0];
    let level = |height: f64| {
        let levels = &model.color_levels;
        let above = levels.iter().position(|level| level.height > height).unwrap_or(4).max(1);
        let (from, to) = (&levels[above - 1], &levels[above]);
        let share = ((height - from.height) / (to.height - from.height).max(1e-9)).clamp(0.0, 1.0) as f32;
        let grey = from.color.mix(to.color, share).rgb.to_array().iter().sum::<f32>() / 3.0;
        [(f64::from(grey) / WHITE).clamp(0.0, 1.0); 2]
    };
    let c_min = model.boxes.first().map_or(0.0, |each| each.light.c_min);
    FgCloud {
        width_m: [width; 2],
        height_m: [height; 2],
        sprites: clouds.first().map_or(0, |cloud| cloud.placed.candidate_count as u32),
        sprite_width_m,
        sprite_height_m,
        texture: TEXTURE.into(),
        tiles: [4, 4],
        rows_by_height: true,
        bottom: level(0.0),
        middle: level(0.5),
        top: level(1.0),
        shade: [((c_min + AMBIENT) / (AMBIENT + 1.0)).clamp(0.0, 1.0); 2],
        ..FgCloud::new(name)
    }
}

/// `name`, or with a number behind it if a cloud has it already.
fn free_name(clouds: &[FgCloud], name: String) -> String {
    let is_free = |name: &String| clouds.iter().all(|cloud| cloud.name != *name);
    if is_free(&name) {
        return name;
    }
    (2..).map(|number| format!("{name}-{number}")).find(is_free).unwrap_or(name)
}

/// How far clouds lie apart, along the axis along which that is farthest, metres.
fn extent(clouds: &[&CloudNow<'_>], along: impl Fn(DVec3) -> [f64; 2]) -> f64 {
    let places = clouds.iter().map(|cloud| along(cloud.placed.cloud.position + cloud.displacement));
    let ends = places.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], [a, b]| {
        [[low[0].min(a), low[1].min(b)], [high[0].max(a), high[1].max(b)]]
    });
    (ends[1][0] - ends[0][0]).max(ends[1][1] - ends[0][1]).max(0.0)
}

/// A name as an element may have it: small letters, digits and strokes, a letter first.
fn tag(name: &str) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' });
    let tag: String = letters.collect();
    let tag = tag.trim_matches('-');
    if tag.starts_with(|c: char| c.is_ascii_lowercase()) {
        tag.into()
    } else {
        format!("cloud-{tag}").trim_end_matches('-').into()
    }
}
