//! A cloud as Flight Simulator 2004's, and back.
//!
//! How what the file does not say is taken ([`cld`] says what that is): a unit is a metre unless `unit_m` says otherwise;
//! x is right, y up and z forward, so that z changes its sign; the shading number is a shading group, the group number a
//! box; levels within 0 to 1 are shares of the cloud's height, others are heights; colours are sRGB, alpha in the highest
//! byte, blue in the lowest.
//!
//! A sprite that comes in is one that was placed by hand: its box keeps it where it is, with its tile. Where the file has a
//! range for its size or turn, that becomes its box's, and one is drawn from it as in the simulator.

use super::left_sprites::{LeftSprite, left_sprites};
use super::placed_by_hand::{Hand, HandSprite, SIZE_M};
use super::{
    Arrived, ArrivedCloud, Arriving, Content, ExportError, Files, Leaving, Note, OptionKind, OptionRow, numbered,
    shorts, tiles,
};
use crate::color::{Rgba, linear_from_srgb, srgb_from_linear};
use crate::formats::Misread;
use crate::formats::cld::{self, Cld, CldLevel, CldSprite};
use crate::property::Number;
use crate::scene::{BoxId, Category, CloudBox, CloudModel, ColorLevel, ColorLevels, ModelId, SpriteEdit};
use crate::weather::CloudNow;
use glam::DVec3;
use rustc_hash::FxHashMap;

const UNIT: Number = Number::new("Unit", &(1e-6..=1e3), "m", "A length of 1 in the file.");
const UNIT_M: OptionRow = OptionRow {
    name: "unit_m",
    kind: OptionKind::Number(UNIT, 1.0),
    doc: "How long a length of 1 in the file is, which no file says;",
};

pub(super) const READ_OPTIONS: &[OptionRow] = &[UNIT_M];
pub(super) const WRITE_OPTIONS: &[OptionRow] = &[
    UNIT_M,
    OptionRow {
        name: "ranges",
        kind: OptionKind::Flag(false),
        doc: "Whether sizes and turns are their boxes' ranges, for the simulator to draw from:",
    },
];

/// What the file calls its sheet of tiles.
const TEXTURE: &str = "clouds.bmp";
/// Farther from the model's origin nothing is a sprite's place, metres.
const REACH_M: f64 = 1e6;

/// Each cloud into a file of its own: the first into the one that was asked for.
pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let mut losses = Losses::default();
    let mut place = 0;
    for cloud in leaving.now.clouds.iter().filter(|cloud| !cloud.placed.sprites.is_empty()) {
        place += 1;
        let bytes = cld::write(&of_cloud(leaving, cloud, &mut losses)?);
        files.add(&numbered(leaving.name, place), &mut |out| out.write_all(&bytes))?;
    }
    if place == 0 {
        return Err(ExportError::Nothing("sprites"));
    }
    let mut notes = losses.notes(leaving.options.number(UNIT_M.name));
    if place > 1 {
        let last = numbered(leaving.name, place);
        notes.push(Note::changed(format!("{place} clouds"), format!("each has a file of its own, the last is {last}")));
    }
    notes.push(Note::left_out("the tiles", format!("the files name the sheet {TEXTURE}; put yours beside them")));
    Ok(notes)
}

/// What of sprites was not as the file has it.
#[derive(Default)]
struct Losses {
    rounded: usize,
    clamped: usize,
    bright: usize,
}

impl Losses {
    fn notes(&self, unit_m: f64) -> Vec<Note> {
        let note = |count: usize, how: String| (count > 0).then(|| Note::changed(format!("{count} sprites"), how));
        let bright = || Note::changed(format!("{} colour levels", self.bright), "the file knows none above white");
        let notes = [
            note(self.rounded, format!("sizes are rounded to {unit_m} m, turns to 1°")),
            note(self.clamped, format!("sizes are cut to {} m", shorts::MOST * unit_m)),
            (self.bright > 0).then(bright),
        ];
        notes.into_iter().flatten().collect()
    }
}

fn of_cloud(leaving: &Leaving<'_>, cloud: &CloudNow<'_>, losses: &mut Losses) -> Result<Cld, ExportError> {
    let (unit_m, ranges) = (leaving.options.number(UNIT_M.name), leaving.options.flag("ranges"));
    let drawn = Drawn::of(leaving.scene.model(cloud.placed.cloud.model).filter(|_| ranges));
    let mut boxes: Vec<BoxId> = Vec::new();
    let mut write = |sprite: LeftSprite| {
        let group = boxes.iter().rposition(|id| *id == sprite.box_id).unwrap_or_else(|| {
            boxes.push(sprite.box_id);
            boxes.len() - 1
        });
        let scale = cloud.placed.cloud.scale * f64::from(cloud.scale);
        let [width_m, height_m, rotation_deg] = drawn.spans(&sprite, scale);
        let mut clamped = false;
        let mut rounded = false;
        let mut lengths = |span: [f64; 2]| {
            span.map(|metres| {
                let (short, off) = shorts::nearest((metres / unit_m).max(1.0));
                clamped |= metres / unit_m > shorts::MOST;
                rounded |= (off * unit_m).abs() > 1e-3;
                short
            })
        };
        let (width, length) = (lengths(width_m), lengths(height_m));
        let rotation_deg = rotation_deg.map(|deg| {
            let (short, off) = shorts::nearest(deg);
            rounded |= off.abs() > 1e-3;
            short
        });
        losses.clamped += usize::from(clamped);
        losses.rounded += usize::from(rounded && !clamped);
        let DVec3 { x, y, z } = sprite.position / unit_m;
        let [left, top, right, bottom] = tiles::edges(sprite.tile);
        Ok(CldSprite {
            position: [x as f32, y as f32, -z as f32],
            shading: shorts::index(sprite.group, "shading groups")?,
            group: shorts::index(group, "boxes")?,
            width,
            length,
            rotation_deg,
            uv: [[left, 1.0 - bottom], [right, 1.0 - top]],
        })
    };
    let sprites = left_sprites(cloud).map(&mut write).collect::<Result<Vec<CldSprite>, ExportError>>()?;
    let levels = cloud.color_levels();
    losses.bright += levels.iter().filter(|level| level.color.rgb.to_array().iter().any(|c| *c > 1.0)).count();
    let level = |level: &ColorLevel| CldLevel { level: level.height as f32, color: packed(level.color) };
    Ok(Cld { texture: TEXTURE.into(), levels: levels.iter().map(level).collect(), sprites, rest: Vec::new() })
}

/// The boxes that sprites were drawn from, and what was set of them by hand; nothing of no model.
struct Drawn<'a> {
    boxes: FxHashMap<BoxId, &'a CloudBox>,
    edits: FxHashMap<(BoxId, u32), &'a SpriteEdit>,
}

impl<'a> Drawn<'a> {
    fn of(model: Option<&'a CloudModel>) -> Self {
        let boxes = || model.into_iter().flat_map(|model| &model.boxes);
        let edits = boxes().flat_map(|each| each.sprite_edits.iter().map(|edit| ((each.id, edit.index), edit)));
        Self { boxes: boxes().map(|each| (each.id, each)).collect(), edits: edits.collect() }
    }

    /// Width, height and turn of a sprite: as they are, or the range of the box that they were drawn from.
    fn spans(&self, sprite: &LeftSprite, scale: f64) -> [[f64; 2]; 3] {
        let own = [sprite.width, sprite.height, sprite.rotation_deg].map(|value| [value; 2]);
        let Some(cloud_box) = self.boxes.get(&sprite.box_id) else { return own };
        let edit = self.edits.get(&(sprite.box_id, sprite.index));
        let by_hand = edit.map_or([None; 3], |edit| [edit.width, edit.height, edit.rotation_deg]);
        let scaled = |span: [f64; 2]| span.map(|metres| metres * scale);
        let drawn = [scaled(cloud_box.width), scaled(cloud_box.height), cloud_box.rotation_deg];
        [0, 1, 2].map(|at| if by_hand[at].is_some() { own[at] } else { drawn[at] })
    }
}

/// Alpha, red, green and blue as bytes of sRGB; alpha as it is.
fn packed(color: Rgba) -> u32 {
    let byte = |share: f32| (share.clamp(0.0, 1.0) * 255.0).round() as u32;
    let [r, g, b] = color.rgb.to_array().map(|linear| byte(srgb_from_linear(linear.clamp(0.0, 1.0))));
    byte(color.a) << 24 | r << 16 | g << 8 | b
}

fn unpacked(color: u32) -> Rgba {
    let share = |shift: u32| (color >> shift & 255) as f32 / 255.0;
    let [r, g, b] = [16, 8, 0].map(|shift| linear_from_srgb(share(shift)));
    Rgba::new(r, g, b, share(24))
}

/// One model with a cloud of it.
pub(super) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let cld = cld::read(arriving.bytes)?;
    let unit_m = arriving.options.number(UNIT_M.name);
    if cld.sprites.is_empty() {
        return Err(Misread::new("byte 4", "the cloud has no sprites"));
    }
    let (mut odd_tiles, mut odd_sizes) = (0, 0);
    let mut hands = Vec::with_capacity(cld.sprites.len());
    for (number, sprite) in cld.sprites.iter().enumerate() {
        let [x, y, z] = sprite.position.map(|length| f64::from(length) * unit_m);
        let position = DVec3::new(x, y, 0.0 - z);
        if position.abs().max_element() > REACH_M {
            let message = format!("it lies more than {} km from the cloud's origin", REACH_M / 1e3);
            return Err(Misread::new(format!("sprite {number}"), message));
        }
        let [[left, bottom], [right, top]] = sprite.uv;
        let (tile, is_whole) = tiles::of_edges([left, 1.0 - top, right, 1.0 - bottom]);
        let sizes = [sprite.width, sprite.length].map(|span| span.map(|short| f64::from(short) * unit_m));
        odd_tiles += usize::from(!is_whole);
        odd_sizes += usize::from(sizes.iter().any(|[from, to]| !(SIZE_M.min..=SIZE_M.max).contains(from) || to < from));
        let [width, height] = sizes.map(|[from, to]| {
            let [from, to] = [from, to].map(|size| size.clamp(SIZE_M.min, SIZE_M.max));
            [from, to.max(from)]
        });
        let rotation_deg = turn(sprite.rotation_deg);
        let (box_number, group) = (sprite.group.into(), Some(sprite.shading.into()));
        hands.push(HandSprite { position, width, height, rotation_deg, tile, box_number, group });
    }
    let (levels, mut notes) = levels(&cld, &hands, unit_m);
    let model = Hand { name: arriving.name, sprites: &hands, color_levels: levels }.model();
    if !cld.texture.is_empty() {
        let name: String = String::from_utf8_lossy(&cld.texture).into_owned();
        notes.push(Note::left_out(format!("the sheet “{name}”"), "the scene's tiles are shown at the same places"));
    }
    let told = [
        (odd_tiles, "they show another part of the sheet than a sixteenth; the nearest tile is taken"),
        (odd_sizes, "their sizes are not above 0, or run backwards; they are mended"),
    ];
    let odd = told.into_iter().filter(|(count, _)| *count > 0);
    notes.extend(odd.map(|(count, how)| Note::changed(format!("{count} sprites"), how)));
    if !cld.rest.is_empty() {
        notes.push(Note::left_out(format!("{} bytes", cld.rest.len()), "what stands behind the last sprite"));
    }
    notes.push(Note::assumed("lengths", format!("a length of 1 is {unit_m} m, which the file does not say")));
    let content = Content::Clouds(vec![ArrivedCloud { model, places: vec![DVec3::ZERO] }]);
    Ok(Arrived { content, notes })
}

/// Within what a box may have.
fn turn([from, to]: [i16; 2]) -> [f64; 2] {
    let (from, to) = (f64::from(from.min(to)), f64::from(from.max(to)));
    if to - from >= 360.0 {
        return [0.0, 360.0];
    }
    let is_within = |deg: f64| deg.abs() <= 360.0;
    let whole = if is_within(from) && is_within(to) { 0.0 } else { 360.0 * (to / 360.0).floor() };
    [from - whole, to - whole]
}

/// The file's levels as five over the cloud's height.
fn levels(cld: &Cld, sprites: &[HandSprite], unit_m: f64) -> (ColorLevels, Vec<Note>) {
    let mut notes = Vec::new();
    let mut found: Vec<(f64, Rgba)> =
        cld.levels.iter().map(|level| (f64::from(level.level), unpacked(level.color))).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    if found.is_empty() {
        notes.push(Note::assumed("colour levels", "the file has none; a new cloud's are taken"));
        return (CloudModel::new(ModelId(1), "", Category::CumulusCongestus).color_levels, notes);
    }
    let are_shares = found.iter().all(|(level, _)| (0.0..=1.0).contains(level));
    if !are_shares {
        let reach = |sprite: &HandSprite| 0.5 * sprite.width[1].max(sprite.height[1]);
        let bottom = sprites.iter().map(|each| each.position.y - reach(each)).fold(f64::INFINITY, f64::min);
        let top = sprites.iter().map(|each| each.position.y + reach(each)).fold(f64::NEG_INFINITY, f64::max);
        let height = (top - bottom).max(1e-9);
        found.iter_mut().for_each(|(level, _)| *level = ((*level * unit_m - bottom) / height).clamp(0.0, 1.0));
        notes.push(Note::assumed("colour levels", "they lie beyond 0 to 1, so they are taken as heights"));
    }
    if found.len() != 5 {
        notes.push(Note::changed(format!("{} colour levels", found.len()), "a cloud has five here"));
    }
    let count = found.len();
    let at = |place: usize| if count <= 5 { place.min(count - 1) } else { place * (count - 1) / 4 };
    let level = |place: usize| ColorLevel { height: found[at(place)].0, color: found[at(place)].1 };
    ([0, 1, 2, 3, 4].map(level), notes)
}
