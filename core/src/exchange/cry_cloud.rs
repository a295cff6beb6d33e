//! A cloud as CryEngine's and Lumberyard's, and back.

use super::left_sprites::{LeftSprite, left_sprites};
use super::placed_by_hand::{Hand, HandSprite, SIZE_M};
use super::{Arrived, ArrivedCloud, Arriving, Content, ExportError, Files, Leaving, Note, numbered, tiles};
use crate::formats::Misread;
use crate::formats::cry_cloud::{self, CryCloud, CrySprite};
use crate::scene::{Category, CloudModel, ModelId};
use glam::DVec3;

/// Of our sheet.
const SIDE: u32 = 4;
/// Farther from the cloud's origin nothing is a sprite's place, metres.
const REACH_M: f64 = 1e6;

/// Each cloud into a file of its own: the first into the one that was asked for.
pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let (mut place, mut squared) = (0, 0);
    for cloud in leaving.now.clouds.iter().filter(|cloud| !cloud.placed.sprites.is_empty()) {
        place += 1;
        let sprites = left_sprites(cloud).map(|sprite| {
            squared += usize::from((sprite.width - sprite.height).abs() > 1e-3);
            of_sprite(&sprite)
        });
        let cloud = CryCloud {
            rows: SIDE,
            columns: SIDE,
            density: Some(1.0),
            sprites: sprites.collect(),
            ..CryCloud::default()
        };
        let bytes = cry_cloud::write(&cloud);
        files.add(&numbered(leaving.name, place), &mut |out| out.write_all(&bytes))?;
    }
    if place == 0 {
        return Err(ExportError::Nothing("sprites"));
    }
    let mut notes = Vec::new();
    if squared > 0 {
        notes.push(Note::changed(
            format!("{squared} sprites"),
            "they are squares of the same area: the file knows no others",
        ));
    }
    if place > 1 {
        let last = numbered(leaving.name, place);
        notes.push(Note::changed(format!("{place} clouds"), format!("each has a file of its own, the last is {last}")));
    }
    notes.push(Note::left_out("the tiles", "give the cloud a material with a sheet of four by four tiles"));
    Ok(notes)
}

fn of_sprite(sprite: &LeftSprite) -> CrySprite {
    let DVec3 { x, y, z } = sprite.position;
    CrySprite {
        position: [x, -z, y],
        tile: sprite.tile.into(),
        radius: 0.5 * (sprite.width * sprite.height).sqrt(),
        angle_deg: sprite.rotation_deg,
    }
}

/// One model with a cloud of it.
pub(super) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let cloud = cry_cloud::read(arriving.bytes)?;
    if cloud.sprites.is_empty() {
        return Err(Misread::new("Cloud", "it has no sprites"));
    }
    let (mut odd_tiles, mut odd_sizes) = (0, 0);
    let mut hands = Vec::with_capacity(cloud.sprites.len());
    for (number, sprite) in cloud.sprites.iter().enumerate() {
        let [x, y, z] = sprite.position;
        if sprite.position.iter().any(|coordinate| coordinate.abs() > REACH_M) {
            let message = format!("it lies more than {} km from the cloud's origin", REACH_M / 1e3);
            return Err(Misread::new(format!("sprite {number}"), message));
        }
        let (tile, is_whole) = tiles::of_sheet(sprite.tile as usize, cloud.columns as usize, cloud.rows as usize);
        let side = (2.0 * sprite.radius).clamp(SIZE_M.min, SIZE_M.max);
        odd_tiles += usize::from(!is_whole);
        odd_sizes += usize::from(side != 2.0 * sprite.radius);
        let turn = (sprite.angle_deg + 180.0).rem_euclid(360.0) - 180.0;
        hands.push(HandSprite {
            position: DVec3::new(x, z, 0.0 - y),
            width: [side; 2],
            height: [side; 2],
            rotation_deg: [turn; 2],
            tile,
            box_number: 0,
            group: None,
        });
    }
    let mut notes = Vec::new();
    for (count, how) in [
        (odd_tiles, "they show another part of the sheet than a sixteenth; the nearest tile is taken"),
        (odd_sizes, "their radii are none for a sprite; they are mended"),
    ] {
        if count > 0 {
            notes.push(Note::changed(format!("{count} sprites"), how));
        }
    }
    let dropped: Vec<&str> =
        [("material", !cloud.material.is_empty()), ("density", cloud.density.is_some_and(|density| density != 1.0))]
            .into_iter()
            .filter_map(|(what, is_there)| is_there.then_some(what))
            .chain(cloud.unknown.iter().map(String::as_str).take(8))
            .collect();
    if !dropped.is_empty() {
        notes.push(Note::left_out(dropped.join(", "), ""));
    }
    notes.push(Note::assumed("light", "sprites fall into lumps, and colour levels are a new cloud's"));
    let color_levels = CloudModel::new(ModelId(1), "", Category::CumulusCongestus).color_levels;
    let model = Hand { name: arriving.name, sprites: &hands, color_levels }.model();
    let content = Content::Clouds(vec![ArrivedCloud { model, places: vec![DVec3::ZERO] }]);
    Ok(Arrived { content, notes })
}
