//! A cloud of CryEngine and Amazon Lumberyard, `NAME.xml`: `<Cloud>` with the columns and rows of its sheet, a density and a
//! material, and a `<Sprite>` for each sprite with its place, tile, radius and angle.
//!
//! Source: how Lumberyard's editor writes such files (CloudGroup.cpp) and its engine reads them (CloudsManager.cpp). As
//! there, a sprite that lacks its place, tile or radius has those of the one before. Metres, x to the right, y forward, z
//! up; the radius is half the side of a square; tiles are numbered row by row; angles are degrees, and the engine turns no
//! sprite by them. It shows the middle of the sprites' bounds where the cloud stands, wherever the file has that.

use super::Misread;
use super::xml::{self, Element, Style};

/// The largest file, bytes.
pub const MAX_BYTES: usize = 32 << 20;

const STYLE: Style = Style { byte_order_mark: false, line_end: "\n", indent: " ", closes: false, declares: false };

/// What a file says.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CryCloud {
    /// Of its sheet of tiles.
    pub rows: u32,
    /// Of its sheet of tiles.
    pub columns: u32,
    /// None if it does not say it.
    pub density: Option<f64>,
    /// The material's name; empty for none.
    pub material: String,
    /// The sprites.
    pub sprites: Vec<CrySprite>,
    /// Names of what is not understood.
    pub unknown: Vec<String>,
}

/// A sprite.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CrySprite {
    /// x right, y forward, z up, metres.
    pub position: [f64; 3],
    /// Its number on the sheet, row by row.
    pub tile: u32,
    /// Half its side, metres.
    pub radius: f64,
    /// Its turn.
    pub angle_deg: f64,
}

/// Whether bytes look like such a file.
pub fn looks_like(bytes: &[u8]) -> bool {
    bytes.windows(7).take(4096).any(|window| [&b"<Cloud "[..], b"<Cloud>", b"<Cloud/"].contains(&window))
}

/// Reads a file.
///
/// # Errors
/// If it is no XML, no cloud, or has a number that is none.
pub fn read(bytes: &[u8]) -> Result<CryCloud, Misread> {
    let root = xml::read(bytes)?;
    if root.name != "Cloud" {
        return Err(root.misread("it is no cloud: <Cloud>"));
    }
    let mut cloud = CryCloud { rows: 1, columns: 1, ..CryCloud::default() };
    for (name, value) in &root.attributes {
        match name.as_str() {
            "TextureNumRows" => cloud.rows = whole(&root, value)?.max(1),
            "TextureNumCols" => cloud.columns = whole(&root, value)?.max(1),
            "Density" => cloud.density = Some(root.number(value)?),
            "Material" => cloud.material.clone_from(value),
            other => cloud.unknown.push(other.into()),
        }
    }
    let mut sprite = CrySprite::default();
    for each in root.elements() {
        if each.name != "Sprite" {
            cloud.unknown.push(each.name.clone());
            continue;
        }
        sprite.angle_deg = 0.0;
        for (name, value) in &each.attributes {
            match name.as_str() {
                "Pos" => sprite.position = point(each, value)?,
                "texID" => sprite.tile = whole(each, value)?,
                "Radius" => sprite.radius = each.number(value)?,
                "Angle" => sprite.angle_deg = each.number(value)?,
                other => cloud.unknown.push(other.into()),
            }
        }
        cloud.sprites.push(sprite);
    }
    cloud.unknown.sort_unstable();
    cloud.unknown.dedup();
    Ok(cloud)
}

/// The file's bytes, as the editor writes them; what was not understood is not in them.
pub fn write(cloud: &CryCloud) -> Vec<u8> {
    let mut root = Element::new("Cloud")
        .with("TextureNumRows", cloud.rows.to_string())
        .with("TextureNumCols", cloud.columns.to_string());
    if let Some(density) = cloud.density {
        root = root.with("Density", short(density));
    }
    if !cloud.material.is_empty() {
        root = root.with("Material", &cloud.material);
    }
    for sprite in &cloud.sprites {
        let mut element = Element::new("Sprite")
            .with("Pos", sprite.position.map(short).join(","))
            .with("texID", sprite.tile.to_string())
            .with("Radius", short(sprite.radius));
        if sprite.angle_deg.abs() >= 1e-4 {
            element = element.with("Angle", short(sprite.angle_deg));
        }
        root.push(element);
    }
    xml::write(&root, STYLE)
}

/// To a tenth of a millimetre.
fn short(number: f64) -> String {
    // Adding 0 turns −0 into 0.
    ((number * 1e4).round() / 1e4 + 0.0).to_string()
}

fn whole(element: &Element, text: &str) -> Result<u32, Misread> {
    text.trim().parse().map_err(|_| element.misread(format_args!("“{text}” is no whole number")))
}

fn point(element: &Element, text: &str) -> Result<[f64; 3], Misread> {
    let numbers = text.split(',').map(|part| element.number(part)).collect::<Result<Vec<f64>, _>>()?;
    numbers.try_into().map_err(|_| element.misread(format_args!("“{text}” is no place of three numbers")))
}
