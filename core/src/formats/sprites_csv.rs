//! All sprites of a scene as a table, a line each: for spreadsheets and quick scripts.
//!
//! Units and order as in [`super::sprites_json`]. With light, the four corners' colours follow, each as four columns.

use crate::color::Rgba;
use crate::posed_sprite::Still;
use crate::sprites::PlacedCloud;
use crate::watch::Watch;
use std::io::{self, Write};

const CORNER_NAMES: [&str; 4] = ["top_left", "top_right", "bottom_right", "bottom_left"];

/// Writes all `clouds` as comma-separated text with a line of heads. With `shaded`, corner colours as that still shows
/// them. The text ends early if `watch` is cancelled.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut impl Write, clouds: &[PlacedCloud], shaded: Option<Still<'_>>, watch: &Watch) -> io::Result<()> {
    watch.expect(clouds.iter().map(|cloud| cloud.sprites.len() as u64).sum());
    write!(out, "cloud,name,category,box,index,x,y,z,width,height,rotation_deg,tile,group")?;
    if shaded.is_some() {
        for name in CORNER_NAMES {
            for channel in ["r", "g", "b", "a"] {
                write!(out, ",{name}_{channel}")?;
            }
        }
    }
    writeln!(out)?;
    for cloud in clouds {
        let name = quoted(&cloud.name);
        for sprite in watch.along(1, cloud.sprites.iter()) {
            let position = cloud.origin + sprite.position.as_dvec3();
            write!(
                out,
                "{},{name},{},{},{},{:.4},{:.4},{:.4},{},{},{},{},{}",
                cloud.id,
                cloud.category.name(),
                sprite.box_id,
                sprite.index,
                position.x,
                position.y,
                position.z,
                sprite.width,
                sprite.height,
                sprite.rotation.to_degrees(),
                sprite.tile,
                cloud.groups[sprite.group as usize].key
            )?;
            if let Some(posed) = shaded.map(|still| still.posed(cloud, sprite)) {
                for corner in posed.corners(sprite.position) {
                    let Rgba { rgb, a } = posed.light_at(corner).color();
                    write!(out, ",{},{},{},{a}", rgb.r, rgb.g, rgb.b)?;
                }
            }
            writeln!(out)?;
        }
    }
    Ok(())
}

/// RFC 4180: quoted where it must be.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
}
