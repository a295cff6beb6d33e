//! Clouds as volumes of OpenVDB files that lie beside the stage.
//!
//! The first cloud's file has the stage's own name, `sky.vdb` beside `sky.usda`, those of the others are numbered,
//! `sky_2.vdb`: as `export SCENE -o sky.vdb` names them. Each has a grid called `density`, in metres from its cloud's
//! origin, which the cloud's Xform places and carries.

use super::{ROOT, display_name, placed, scope};
use crate::exchange::motion::Course;
use crate::exchange::{Leaving, numbered};
use crate::formats::usda::{Text, Tuple, beside};
use glam::Vec3;

/// The grid of such a file.
const GRID: &str = "density";

/// Writes the clouds, whose courses are given in their order; none if it was cancelled.
pub(super) fn write(text: &mut Text, leaving: &Leaving<'_>, stem: &str, courses: &[Course]) -> Option<()> {
    scope(text, "Clouds", |text, names| {
        for (at, (cloud, course)) in leaving.now.clouds.iter().zip(courses).enumerate() {
            let name = names.free(&cloud.placed.name);
            text.prim(&format!("def Xform \"{name}\""), &[display_name(&cloud.placed.name)], |text| {
                placed(text, (cloud.origin(), &course.places), None);
                let reach = Vec3::splat(cloud.reach_now());
                let [low, high] = [cloud.center_now() - reach, cloud.center_now() + reach]
                    .map(|corner| Tuple::of(corner.to_array().map(f64::from), 1.0));
                text.prim("def Volume \"volume\"", &[], |text| {
                    text.set("float3[] extent", format!("[{low}, {high}]"));
                    text.set(&format!("rel field:{GRID}"), format!("<{ROOT}/Clouds/{name}/volume/{GRID}>"));
                    text.prim(&format!("def OpenVDBAsset \"{GRID}\""), &[], |text| {
                        text.set("token fieldClass", "\"fogVolume\"");
                        text.set("token fieldName", format!("\"{GRID}\""));
                        text.set("asset filePath", beside(&numbered(&format!("{stem}.vdb"), at + 1)));
                    });
                });
            });
        }
    });
    (!leaving.watch.is_cancelled()).then_some(())
}
