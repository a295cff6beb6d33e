//! All sprites of a scene as a table, a line each: for spreadsheets and quick scripts.
//!
//! Units and order as in [`super::sprites_json`]. With light, the four corners' colours follow, each as four columns.

use super::sprites_json::Shaded;
use crate::color::Rgba;
use crate::facing::{Pose, corners};
use crate::shading::corner_light;
use crate::sprites::PlacedCloud;
use crate::weather::{CloudNow, FormingRule};
use std::fmt::Write;

const CORNER_NAMES: [&str; 4] = ["top_left", "top_right", "bottom_right", "bottom_left"];

/// All `clouds` as comma-separated text with a line of heads. With `shaded`, corner colours as that eye sees them.
pub fn write(clouds: &[PlacedCloud], shaded: Option<Shaded<'_>>) -> String {
    let mut out = String::from("cloud,name,category,box,index,x,y,z,width,height,rotation_deg,tile,group");
    if shaded.is_some() {
        for name in CORNER_NAMES {
            for channel in ["r", "g", "b", "a"] {
                let _ = write!(out, ",{name}_{channel}");
            }
        }
    }
    out.push('\n');
    for cloud in clouds {
        for sprite in cloud.sprites.iter() {
            let position = cloud.origin + sprite.position.as_dvec3();
            let group = &cloud.groups[sprite.group as usize];
            let _ = write!(
                out,
                "{},{},{},{},{},{:.4},{:.4},{:.4},{},{},{},{},{}",
                cloud.id,
                quoted(&cloud.name),
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
                group.key
            );
            if let Some(Shaded { view, light, clock_s }) = shaded {
                let now = CloudNow::at(cloud, clock_s, FormingRule::ClosedForm);
                let pose = Pose::still(now.from_eye(view.eye) + sprite.position, sprite.radius(), view);
                for point in corners(sprite.position, pose.facing(sprite.rotation), sprite.width, sprite.height) {
                    let Rgba { rgb, a } = corner_light(point, &now, group, light).color();
                    let _ = write!(out, ",{},{},{},{}", rgb.r, rgb.g, rgb.b, a * pose.fade);
                }
            }
            out.push('\n');
        }
    }
    out
}

/// RFC 4180: quoted where it must be.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
}
