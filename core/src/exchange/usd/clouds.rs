//! Clouds as Xforms, each with a mesh of its sprites.

use super::materials::{Materials, OfMesh};
use super::{FINE_STEPS, code, display_name, placed, scope};
use crate::exchange::motion::Course;
use crate::exchange::quads::{Quad, quads};
use crate::exchange::{Leaving, sheet, tiles};
use crate::formats::usda::{Number, Text, Tuple};
use crate::sprites::TILES;
use glam::Vec3;

/// Corners are in steps of a centimetre.
const CORNER_STEPS: f64 = 1e2;
const COLOR_STEPS: f64 = 1e4;
/// The order of a quad's corners, counter-clockwise as it is seen.
const ORDER: [usize; 4] = [0, 3, 2, 1];

/// Writes the clouds, whose courses are given in their order, and the materials of their meshes; none if it was cancelled.
pub(super) fn write(text: &mut Text, leaving: &Leaving<'_>, sheet_name: &str, courses: &[Course]) -> Option<()> {
    let Leaving { now, watch, .. } = *leaving;
    let still = leaving.still()?;
    let means = sheet::means(leaving.atlas);
    let mut materials = Materials::default();
    watch.expect(now.clouds.len() as u64);
    scope(text, "Clouds", |text, names| {
        for ((at, cloud), course) in watch.along(1, &now.clouds).enumerate().zip(courses) {
            let name = &cloud.placed.name;
            let prim = names.free(name);
            let forms = !course.formed.is_empty();
            let quads = quads(cloud, forms, still, now.exposure);
            let metadata = [display_name(name), "kind = \"component\"".into()];
            text.prim(&format!("def Xform \"{prim}\""), &metadata, |text| {
                if forms {
                    visibility(text, course);
                }
                placed(text, (cloud.origin(), &course.places), None);
                if !quads.is_empty() {
                    mesh(text, &prim, &quads, &means, &materials.of(&quads, forms.then_some((at, course))));
                }
            });
        }
    });
    (!watch.is_cancelled()).then(|| materials.write(text, sheet_name))
}

/// A cloud is not there while nothing of it has formed.
fn visibility(text: &mut Text, course: &Course) {
    let is_there = |at: usize| course.formed.get(at).is_some_and(|(_, share)| *share > 0.0);
    let mut samples: Vec<(f64, &str)> = Vec::new();
    for (at, (time, _)) in course.formed.iter().enumerate() {
        let value = if is_there(at) || is_there(at + 1) { "\"inherited\"" } else { "\"invisible\"" };
        if samples.last().is_none_or(|(_, last)| *last != value) {
            samples.push((code(*time), value));
        }
    }
    text.samples("token visibility", samples.into_iter());
}

/// A cloud's mesh, with its name: programs that leave out an Xform with one child keep the child's.
fn mesh(text: &mut Text, name: &str, quads: &[Quad], means: &[[f32; 3]; TILES], materials: &OfMesh) {
    let metadata = ["prepend apiSchemas = [\"MaterialBindingAPI\"]".into()];
    text.prim(&format!("def Mesh \"{name}\""), &metadata, |text| {
        text.set("uniform bool doubleSided", 1);
        let corners = || quads.iter().flat_map(|quad| quad.corners);
        let ends = [Vec3::min as fn(Vec3, Vec3) -> Vec3, Vec3::max].map(|choose| corners().reduce(choose));
        let [low, high] = ends.map(|end| corner(end.unwrap_or_default()));
        text.set("float3[] extent", format!("[{low}, {high}]"));
        text.list("int[] faceVertexCounts", quads.iter().map(|_| [4]), "");
        text.list("int[] faceVertexIndices", (0..quads.len()).map(|at| [0, 1, 2, 3].map(|i| 4 * at + i)), "");
        text.list("point3f[] points", quads.iter().map(|quad| ORDER.map(|i| corner(quad.corners[i]))), "");
        let color = |quad: &Quad| {
            let mean = means[usize::from(quad.tile) % TILES];
            ORDER.map(|i| Tuple::of([0, 1, 2].map(|part| f64::from(quad.colors[i][part] * mean[part])), COLOR_STEPS))
        };
        text.list("color3f[] primvars:displayColor", quads.iter().map(color), VERTEX);
        let opacity = |quad: &Quad| ORDER.map(|i| Number(quad.colors[i][3].into(), COLOR_STEPS));
        text.list("float[] primvars:displayOpacity", quads.iter().map(opacity), VERTEX);
        text.list("texCoord2f[] primvars:st", (0..TILES as u8).map(tile_corners), VERTEX);
        let of_tile = |quad: &Quad| [0, 1, 2, 3].map(|i| 4 * usize::from(quad.tile) + i);
        text.list("int[] primvars:st:indices", quads.iter().map(of_tile), "");
        text.set("uniform token subdivisionScheme", "\"none\"");
        materials.bind(text);
    });
}

const VERTEX: &str = " (interpolation = \"vertex\")";

fn corner(point: Vec3) -> Tuple<3> {
    Tuple::of(point.to_array().map(f64::from), CORNER_STEPS)
}

/// Where a quad's corners lie on the sheet, from its bottom left.
fn tile_corners(tile: u8) -> [Tuple<2>; 4] {
    let [left, top, right, bottom] = tiles::edges(tile).map(f64::from);
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    ORDER.map(|i| Tuple::of([corners[i][0], 1.0 - corners[i][1]], FINE_STEPS))
}
