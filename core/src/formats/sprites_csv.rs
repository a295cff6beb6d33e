//! All sprites of a scene as a table, a line each: for spreadsheets and quick scripts.
//!
//! Units and order as in [`super::sprites_json`]. With light, the four corners' colours follow, each as four columns.

use crate::color::Rgba;
use crate::posed_sprite::Still;
use crate::watch::Watch;
use crate::weather::CloudNow;
use glam::Vec3;
use std::io::{self, Write};

const CORNER_NAMES: [&str; 4] = ["top_left", "top_right", "bottom_right", "bottom_left"];

/// Writes all `clouds` as comma-separated text with a line of heads. With `shaded`, corner colours as that still shows
/// them. The text ends early if `watch` is cancelled.
///
/// # Errors
/// Those of `out`.
pub fn write(
    out: &mut impl Write,
    clouds: &[CloudNow<'_>],
    shaded: Option<Still<'_>>,
    watch: &Watch,
) -> io::Result<()> {
    watch.expect(clouds.iter().map(|cloud| cloud.placed.sprites.len() as u64).sum());
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
        let name = quoted(&cloud.placed.name);
        for index in watch.along(1, &(0..cloud.placed.sprites.len()).collect::<Vec<_>>()) {
            let sprite = cloud.sprite_now(*index);
            let position = cloud.origin() + sprite.position.as_dvec3();
            write!(
                out,
                "{},{name},{},{},{},{:.4},{:.4},{:.4},{},{},{},{},{}",
                cloud.placed.id,
                cloud.placed.category.name(),
                sprite.box_id,
                sprite.index,
                position.x,
                position.y,
                position.z,
                sprite.width,
                sprite.height,
                sprite.rotation.to_degrees(),
                sprite.tile,
                cloud.groups()[sprite.group as usize].key
            )?;
            if let Some(posed) = shaded.map(|still| still.posed(cloud, *index)) {
                for corner in posed.corners(Vec3::ZERO) {
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
