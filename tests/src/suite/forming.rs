//! Clouds that come and go while nobody moves.

use super::Situation;
use super::bounds::{Bound, ROUNDING, exact};
use super::figure::Figure;
use super::stage::{Look, Stage};
use super::studio::{Plate, ahead, plates, solid_atlas, studio};
use cloudwright_core::scene::{Camera, Formation, FormationChange};
use glam::DVec3;
use std::borrow::Cow;

pub(super) const SITUATIONS: &[Situation] = &[
    Situation {
        name: "forming, with a stall",
        about: "The core takes two seconds, the edges three; four looks a second, and one after a stall of 30 s.",
        stage: || forming(FormationChange::Forming, [2.0, 3.0], looks(4.0, 20).chain([35.0])),
        bound: exact(Figure::Opacity, "The truth forms by the same closed form, so only rounding is left."),
        breaks: &["stepped-as-printed", "stepped-mended"],
    },
    Situation {
        name: "forming, from look to look",
        about: "Two seconds and three again; ten looks a second.",
        stage: || forming(FormationChange::Forming, [2.0, 3.0], looks(10.0, 60)),
        bound: Bound {
            figure: Figure::Steps,
            at_most: 3.0 * 0.8 * (1.0 / 2.0 + 2.0 * 0.5 * 0.15 / 3.0) * 0.1 + ROUNDING,
            because: "A corner 0.15 radii out changes by 1/core_s + 2θ · 0.15/edges_s a second at most, its plate by 0.8 \
                      of that, and three plates by no more than three times as much.",
        },
        breaks: &["stepped-as-printed"],
    },
    Situation {
        name: "forming within a frame",
        about: "The core takes 20 ms, the edges 30 ms; 120 looks a second.",
        stage: || forming(FormationChange::Forming, [0.02, 0.03], looks(120.0, 12)),
        bound: exact(Figure::Opacity, "The closed form has no step that could be too long for it."),
        breaks: &["stepped-as-printed", "stepped-mended"],
    },
    Situation {
        name: "dissipating",
        about: "As long as forming took: two seconds and three, backwards.",
        stage: || forming(FormationChange::Dissipating, [2.0, 3.0], looks(4.0, 20)),
        bound: exact(Figure::Opacity, "Backwards, the closed form is the same one."),
        breaks: &["stepped-as-printed", "stepped-mended"],
    },
    Situation {
        name: "forming at any frame rate",
        about: "Two and three seconds, looked at between the frames of all three rates.",
        stage: || forming(FormationChange::Forming, [2.0, 3.0], looks(4.0, 20).map(|clock_s| clock_s + 0.07)),
        bound: Bound {
            figure: Figure::Rates,
            at_most: 1e-6,
            because: "The closed form does not know how often it is asked: what is left are roundings of f32.",
        },
        breaks: &["stepped-as-printed", "stepped-mended"],
    },
];

fn looks(a_second: f64, last: u32) -> impl Iterator<Item = f64> {
    (0..=last).map(move |i| f64::from(i) / a_second)
}

/// Three plates at the middle of a cloud whose other two stand 400 m to the left and to the right, out of view: its radius
/// is 400 m, and their corners are 57 m from its centre, 0.14 of that.
fn forming(change: FormationChange, [core_s, edges_s]: [f64; 2], looks: impl Iterator<Item = f64>) -> Stage {
    let beside = |x: f64| Plate { center: DVec3::new(x, 0.0, -62.0), side_m: 1.0, light: 0.0 };
    let middle = [60.0, 62.0, 64.0].map(|distance_m| ahead(distance_m, 80.0, 1.0));
    let mut scene = studio(&[plates(0.8, middle.into_iter().chain([beside(-400.0), beside(400.0)]))]);
    let formation = Formation { change, start_s: 0.0, core_s, edges_s, threshold: 0.5 };
    scene.clouds.iter_mut().for_each(|cloud| cloud.formation = Some(formation));
    let camera = Camera { field_of_view_deg: 16.0, ..Camera::free(DVec3::ZERO) };
    let looks = looks.map(|clock_s| Look { camera: camera.clone(), clock_s, drawn: true }).collect();
    Stage { scene, atlas: Cow::Owned(solid_atlas()), size: [24, 14], flies: false, looks }
}
