//! FlightGear's clouds and layers, `cloudlayers.xml`: a property list of clouds (how many sprites in how large a heap), of
//! boxes that group them, and of the layers that are made of boxes.
//!
//! Source: FlightGear's Docs/README.3DClouds, and how SimGear reads it (newcloud.cxx), whose values hold where the file
//! has none. Lengths are metres, and a cloud's width holds its sprites' edges, not only their middles.

use super::Misread;
use super::xml::{self, Element, Style};

/// The largest file, bytes.
pub const MAX_BYTES: usize = 4 << 20;

const ROOT: &str = "PropertyList";
const STYLE: Style = Style { byte_order_mark: false, line_end: "\n", indent: "  ", closes: false, declares: true };

/// All that a file says.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FgLayers {
    /// Kinds of cloud.
    pub clouds: Vec<FgCloud>,
    /// Groups of clouds, each with a name.
    pub groups: Vec<(String, Vec<FgBox>)>,
    /// Layers, each with a name that the simulator chooses it by.
    pub layers: Vec<FgLayer>,
    /// Names of what is not understood.
    pub unknown: Vec<String>,
}

/// A kind of cloud.
#[derive(Debug, Clone, PartialEq)]
pub struct FgCloud {
    /// Its tag.
    pub name: String,
    /// From, to, metres.
    pub width_m: [f64; 2],
    /// From, to, metres.
    pub height_m: [f64; 2],
    /// On the average.
    pub sprites: u32,
    /// From, to, metres.
    pub sprite_width_m: [f64; 2],
    /// From, to, metres.
    pub sprite_height_m: [f64; 2],
    /// The sheet of tiles, a path in the simulator's data.
    pub texture: String,
    /// Columns and rows of the sheet.
    pub tiles: [u32; 2],
    /// Whether the sheet's rows go with the height in the cloud.
    pub rows_by_height: bool,
    /// Light at the bottom, from and to.
    pub bottom: [f64; 2],
    /// Light half-way up, from and to.
    pub middle: [f64; 2],
    /// Light at the top, from and to.
    pub top: [f64; 2],
    /// Light on the side away from the sun, from and to.
    pub shade: [f64; 2],
    /// What heights are multiplied with.
    pub z_scale: f64,
}

/// Clouds of a kind, strewn in a box.
#[derive(Debug, Clone, PartialEq)]
pub struct FgBox {
    /// Which kind.
    pub cloud: String,
    /// How many, on the average.
    pub count: f64,
    /// How far they lie apart, east and north, metres.
    pub width_m: f64,
    /// How far they lie apart, up, metres.
    pub height_m: f64,
    /// Of how many random numbers a place east and north is the mean: more gather in the middle.
    pub gathered: u32,
    /// The same of a height.
    pub gathered_up: u32,
}

/// A layer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FgLayer {
    /// `cu`, `cb`, `ac`, `st`, `sc`, `ns`.
    pub name: String,
    /// Groups, and how often each is chosen.
    pub groups: Vec<(String, f64)>,
    /// How far groups lie apart, up, metres.
    pub uneven_m: f64,
}

impl FgCloud {
    /// As the simulator has it where a file says nothing.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.into(),
            width_m: [500.0, 1000.0],
            height_m: [400.0, 800.0],
            sprites: 20,
            sprite_width_m: [200.0, 300.0],
            sprite_height_m: [150.0, 225.0],
            texture: "cl_cumulus.png".into(),
            tiles: [4, 4],
            rows_by_height: false,
            bottom: [1.0, 1.0],
            middle: [1.0, 1.0],
            top: [1.0, 1.0],
            shade: [0.5, 0.6],
            z_scale: 1.0,
        }
    }
}

/// Whether bytes look like such a file.
pub fn looks_like(bytes: &[u8]) -> bool {
    bytes.windows(ROOT.len()).take(16_384).any(|window| window == ROOT.as_bytes())
}

/// Reads a file.
///
/// # Errors
/// If it is no XML, no property list, or has a number that is none.
pub fn read(bytes: &[u8]) -> Result<FgLayers, Misread> {
    let root = xml::read(bytes)?;
    if root.name != ROOT {
        return Err(root.misread(format_args!("it is no property list: <{ROOT}>")));
    }
    let mut layers = FgLayers::default();
    for part in root.elements() {
        match part.name.as_str() {
            "clouds" => {
                layers.clouds =
                    part.elements().map(|each| cloud(each, &mut layers.unknown)).collect::<Result<_, _>>()?;
            }
            "boxes" => {
                layers.groups =
                    part.elements().map(|each| group(each, &mut layers.unknown)).collect::<Result<_, _>>()?;
            }
            "layers" => {
                layers.layers =
                    part.elements().map(|each| layer(each, &mut layers.unknown)).collect::<Result<_, _>>()?;
            }
            other => layers.unknown.push(other.into()),
        }
    }
    layers.unknown.sort_unstable();
    layers.unknown.dedup();
    Ok(layers)
}

/// The file's bytes; what was not understood is not in them.
pub fn write(layers: &FgLayers) -> Vec<u8> {
    let mut root = Element::new(ROOT);
    let mut clouds = Element::new("clouds");
    layers.clouds.iter().for_each(|cloud| clouds.push(cloud_out(cloud)));
    let mut boxes = Element::new("boxes");
    for (name, parts) in &layers.groups {
        let mut element = Element::new(name);
        for part in parts {
            let mut own = Element::new("box");
            own.push(Element::with_text("type", &part.cloud));
            for (name, number) in [
                ("count", part.count),
                ("width", part.width_m),
                ("height", part.height_m),
                ("hdist", part.gathered.into()),
                ("vdist", part.gathered_up.into()),
            ] {
                own.push(number_out(name, number));
            }
            element.push(own);
        }
        boxes.push(element);
    }
    let mut own = Element::new("layers");
    for layer in &layers.layers {
        let mut element = Element::new(&layer.name);
        for (name, count) in &layer.groups {
            let mut cloud = Element::new("cloud");
            cloud.push(Element::with_text("name", name));
            cloud.push(number_out("count", *count));
            element.push(cloud);
        }
        element.push(number_out("grid-z-rand", layer.uneven_m).with("type", "double"));
        own.push(element);
    }
    [clouds, boxes, own].into_iter().for_each(|part| root.push(part));
    xml::write(&root, STYLE)
}

/// Factors of light, as the file calls them.
const LIGHTS: [&str; 4] = ["bottom", "middle", "top", "shade"];

fn cloud(element: &Element, unknown: &mut Vec<String>) -> Result<FgCloud, Misread> {
    let mut cloud = FgCloud::new(&element.name);
    // What goes up to follows from what it begins at, unless it is told.
    let from = |name: &str, usual: f64| number(element, name).map(|found| found.unwrap_or(usual));
    let span = |name: &str, usual: f64, up_to: &dyn Fn(f64) -> f64| {
        let least = from(&format!("min-{name}"), usual)?;
        Ok::<_, Misread>([least, from(&format!("max-{name}"), up_to(least))?])
    };
    cloud.width_m = span("cloud-width-m", 500.0, &|least| 2.0 * least)?;
    cloud.height_m = span("cloud-height-m", 400.0, &|least| 2.0 * least)?;
    cloud.sprite_width_m = span("sprite-width-m", 200.0, &|least| 1.5 * least)?;
    cloud.sprite_height_m = span("sprite-height-m", 150.0, &|least| 1.5 * least)?;
    let light =
        |name: &str, usual: f64| span(&format!("{name}-lighting-factor"), usual, &|least| (least + 0.1).min(1.0));
    cloud.bottom = light("bottom", 1.0)?;
    cloud.middle = light("middle", 1.0)?;
    cloud.top = light("top", 1.0)?;
    cloud.shade = light("shade", 0.5)?;
    cloud.sprites = whole(element, "num-sprites", 20)?;
    cloud.tiles = [whole(element, "num-textures-x", 4)?.max(1), whole(element, "num-textures-y", 4)?.max(1)];
    cloud.z_scale = from("z-scale", 1.0)?;
    if let Some(texture) = element.element("texture") {
        cloud.texture = texture.text();
    }
    cloud.rows_by_height = element.element("height-map-texture").is_some_and(|flag| flag.text() == "true");
    let is_known = |name: &str| {
        let rest = name.strip_prefix("min-").or(name.strip_prefix("max-"));
        let lights = |rest: &str| rest.strip_suffix("-lighting-factor").is_some_and(|light| LIGHTS.contains(&light));
        let sizes = ["cloud-width-m", "cloud-height-m", "sprite-width-m", "sprite-height-m"];
        let others = ["num-sprites", "num-textures-x", "num-textures-y", "z-scale", "texture", "height-map-texture"];
        others.contains(&name) || rest.is_some_and(|rest| lights(rest) || sizes.contains(&rest))
    };
    unknown.extend(element.elements().map(|each| each.name.clone()).filter(|name| !is_known(name)));
    Ok(cloud)
}

fn group(element: &Element, unknown: &mut Vec<String>) -> Result<(String, Vec<FgBox>), Misread> {
    let mut boxes = Vec::new();
    for each in element.elements() {
        if each.name != "box" {
            unknown.push(each.name.clone());
            continue;
        }
        let or = |name: &str, usual: f64| number(each, name).map(|found| found.unwrap_or(usual));
        boxes.push(FgBox {
            cloud: each.element("type").map_or_else(|| "cu-small".into(), Element::text),
            count: or("count", 5.0)?,
            width_m: or("width", 1000.0)?,
            height_m: or("height", 1000.0)?,
            gathered: whole(each, "hdist", 1)?,
            gathered_up: whole(each, "vdist", 1)?,
        });
        let known = ["type", "count", "width", "height", "hdist", "vdist"];
        unknown.extend(each.elements().map(|part| part.name.clone()).filter(|name| !known.contains(&name.as_str())));
    }
    Ok((element.name.clone(), boxes))
}

fn layer(element: &Element, unknown: &mut Vec<String>) -> Result<FgLayer, Misread> {
    let mut layer = FgLayer { name: element.name.clone(), ..FgLayer::default() };
    for each in element.elements() {
        match each.name.as_str() {
            "cloud" => {
                let name = each.element("name").ok_or_else(|| each.misread("it has no name"))?.text();
                layer.groups.push((name, number(each, "count")?.unwrap_or(1.0)));
            }
            "grid-z-rand" => layer.uneven_m = each.number(&each.text())?,
            other => unknown.push(other.into()),
        }
    }
    Ok(layer)
}

fn cloud_out(cloud: &FgCloud) -> Element {
    let mut element = Element::new(&cloud.name);
    let mut span = |name: &str, [from, to]: [f64; 2]| {
        element.push(number_out(&format!("min-{name}"), from));
        element.push(number_out(&format!("max-{name}"), to));
    };
    span("cloud-width-m", cloud.width_m);
    span("cloud-height-m", cloud.height_m);
    span("sprite-width-m", cloud.sprite_width_m);
    span("sprite-height-m", cloud.sprite_height_m);
    for (name, factor) in LIGHTS.iter().zip([cloud.bottom, cloud.middle, cloud.top, cloud.shade]) {
        span(&format!("{name}-lighting-factor"), factor);
    }
    element.push(number_out("num-sprites", cloud.sprites.into()));
    element.push(Element::with_text("texture", &cloud.texture));
    element.push(number_out("num-textures-x", cloud.tiles[0].into()));
    element.push(number_out("num-textures-y", cloud.tiles[1].into()));
    element.push(Element::with_text("height-map-texture", cloud.rows_by_height.to_string()));
    element.push(number_out("z-scale", cloud.z_scale));
    element
}

/// To thousandths.
fn number_out(name: &str, number: f64) -> Element {
    Element::with_text(name, ((number * 1e3).round() / 1e3 + 0.0).to_string())
}

fn number(element: &Element, name: &str) -> Result<Option<f64>, Misread> {
    element.element(name).map(|each| each.number(&each.text())).transpose()
}

fn whole(element: &Element, name: &str, usual: u32) -> Result<u32, Misread> {
    let Some(each) = element.element(name) else { return Ok(usual) };
    let text = each.text();
    text.trim().parse().map_err(|_| each.misread(format_args!("“{text}” is no whole number")))
}
