//! A scene as a web page in one file, for someone who installs nothing: to fly through, at any time of day, with its clock.
//!
//! The page draws the sprites that we draw, by our rules, with WebGL 2: its source stands in `page/`, where each shader
//! names the one in WGSL whose twin it is. It asks the network for nothing. The numbers that it draws from are a text of
//! JSON ([`header::Header`]) and one block of bytes ([`block::Block`]), deflated, in base 64.
//!
//! What the clock moves is told in keys, light in rows over the day and over the clock ([`moving`], [`light`]); between
//! them the page goes along straight lines.

mod block;
mod clouds;
mod header;
mod light;
mod moving;

use super::{ExportError, Files, Leaving, Note};
use crate::formats::base64;
use block::Block;
use clouds::Clouds;
use header::{Header, Times};

/// The page, with a mark where each of its parts goes.
const PAGE: &str = include_str!("page/page.html");

/// What goes into the page, by the mark that it replaces. Scripts stand behind one another as one.
const PARTS: [(&str, &str); 11] = [
    ("/*STYLE*/", include_str!("page/style.css")),
    ("/*FRAME*/", include_str!("page/frame.glsl")),
    ("/*COVER*/", include_str!("page/cover.vert.glsl")),
    ("/*BACKGROUND*/", include_str!("page/background.frag.glsl")),
    ("/*CLOUDS*/", include_str!("page/clouds.glsl")),
    ("/*SHADOWS_VERTEX*/", include_str!("page/shadows.vert.glsl")),
    ("/*SHADOWS_FRAGMENT*/", include_str!("page/shadows.frag.glsl")),
    ("/*SPRITES_VERTEX*/", include_str!("page/sprites.vert.glsl")),
    ("/*SPRITES_FRAGMENT*/", include_str!("page/sprites.frag.glsl")),
    ("/*TONE*/", include_str!("page/tone.frag.glsl")),
    (
        "/*SCRIPT*/",
        concat!(
            include_str!("page/scene.js"),
            include_str!("page/facing.js"),
            include_str!("page/shadows.js"),
            include_str!("page/sprites.js"),
            include_str!("page/through.js"),
            include_str!("page/veil.js"),
            include_str!("page/gpu.js"),
            include_str!("page/eye.js"),
            include_str!("page/page.js"),
        ),
    ),
];
const HEADER_MARK: &str = "/*HEADER*/";
const BLOCK_MARK: &str = "/*BLOCK*/";

pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let view = leaving.view.ok_or(ExportError::Nothing("cameras"))?;
    let mut block = Block::default();
    block.add("atlas", &atlas(leaving));
    let times_s = moving::times_s(leaving, None);
    let clouds = Clouds::new(leaving, &times_s);
    if leaving.watch.is_cancelled() {
        return Err(ExportError::Cancelled);
    }
    clouds.write(&mut block);
    let days_s = light::days_s(leaving, &times_s);
    block.add("light_by_hour", light::by_hour(leaving, &days_s).as_flattened());
    block.add("light_by_clock", light::by_clock(leaving, &times_s).as_flattened());
    let end_s = if moving::moves(leaving) { times_s.last().copied().unwrap_or(0.0) } else { 0.0 };
    let mut notes = Vec::new();
    if days_s.len() > 1 {
        let how = format!("it is told at {} seconds of the clock, with straight lines between", days_s.len());
        notes.push(Note::changed("light at another hour than the scene's", how));
    }
    if clouds.has_keyed_groups {
        notes.push(Note::left_out("tracks of groups' light", "it is as at the moment"));
    }
    let header = Header::new(leaving, view, &block, Times { end_s, days_s }, clouds.listed);
    let page = page(&serde_json::to_string(&header).map_err(std::io::Error::from)?, &block.packed()?);
    files.add(leaving.name, &mut |out| out.write_all(page.as_bytes()))?;
    Ok(notes)
}

/// The file's text. The header and the block come last, so that no mark is looked for in what a scene's names say.
fn page(header: &str, block: &[u8]) -> String {
    let page = PARTS.iter().fold(PAGE.to_owned(), |page, (mark, part)| page.replacen(mark, part, 1));
    let (before, rest) = page.split_once(HEADER_MARK).unwrap_or((&page, ""));
    let (between, after) = rest.split_once(BLOCK_MARK).unwrap_or((rest, ""));
    // Within JSON a < is always in a text, where it may be written so; else a name could end the page's script.
    let header = header.replace('<', "\\u003c");
    [before, &header, between, &base64::encode(block), after].concat()
}

/// All tiles at each mip level, the finest first.
fn atlas(leaving: &Leaving<'_>) -> Vec<[u8; 4]> {
    use crate::sprites::{MIP_LEVELS, TILES};
    let level = |mip| (0..TILES).flat_map(move |tile| leaving.atlas.level(tile, mip).texels.iter().copied());
    (0..MIP_LEVELS).flat_map(level).collect()
}
