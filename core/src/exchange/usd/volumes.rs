//! Clouds as volumes of OpenVDB files that lie beside the stage.
//!
//! The first cloud's file has the stage's own name, `sky.vdb` beside `sky.usda`, those of the others are numbered,
//! `sky_2.vdb`: as `export SCENE -o sky.vdb` names them. Each has a grid called `density`, which stands where the cloud is at
//! the moment; the cloud's Xform carries it from there.

use super::{ROOT, display_name, placed, scope};
use crate::exchange::motion::Course;
use crate::exchange::{Leaving, numbered, volume};
use crate::formats::usda::{Text, Tuple, beside};

/// The grid of such a file.
const GRID: &str = "density";

/// Writes the clouds, whose courses are given in their order; none if it was cancelled.
pub(super) fn write(text: &mut Text, leaving: &Leaving<'_>, stem: &str, courses: &[Course]) -> Option<()> {
    scope(text, "Clouds", |text, names| {
        let origin = volume::origin(leaving);
        let clouds = leaving.now.clouds.iter().zip(courses).filter(|(cloud, _)| volume::is_written(cloud));
        for (at, (cloud, course)) in clouds.enumerate() {
            let name = names.free(&cloud.placed.name);
            text.prim(&format!("def Xform \"{name}\""), &[display_name(&cloud.placed.name)], |text| {
                let at_rest = cloud.origin() - origin;
                let places: Vec<_> = course.places.iter().map(|(time, place)| (*time, *place - at_rest)).collect();
                placed(text, (cloud.origin() - at_rest, &places), None);
                let (center, reach) = (at_rest + cloud.center_now().as_dvec3(), f64::from(cloud.reach_now()));
                let [low, high] = [center - reach, center + reach].map(|corner| Tuple::of(corner.to_array(), 1.0));
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
