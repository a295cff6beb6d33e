//! Eyes that move: through sprites, past them, and hovering where something changes.

use super::Situation;
use super::bounds::{Bound, ROUNDING, exact};
use super::figure::Figure;
use super::heap_flights::{self, noise};
use super::sprite_changes::CHANGES;
use super::stage::Stage;
use super::studio::{Plate, ahead, plates, solid_atlas, studio};
use cloudwright_core::scene::{Camera, Scene};
use glam::DVec3;
use std::borrow::Cow;

pub(super) const SITUATIONS: &[Situation] = &[
    Situation {
        name: "through",
        about: "A heap of eighty sprites, straight through its middle, half a metre past a sprite's centre.",
        stage: || heap_flights::through(400.0),
        bound: SPRITES,
        breaks: &["no-lock", "lock-without-fade", "dot-product"],
    },
    Situation {
        name: "slowly through",
        about: "The same so slowly that each step is shorter than the miss.",
        stage: || heap_flights::through(9.0),
        bound: SPRITES,
        breaks: &["no-lock", "lock-without-fade", "dot-product"],
    },
    Situation {
        name: "grazing",
        about: "Past the heap, through its outermost sprites.",
        stage: heap_flights::grazing,
        bound: SPRITES,
        breaks: &["lock-without-fade", "dot-product"],
    },
    Situation {
        name: "hovering",
        about: "At the lock distance of one of its sprites, with a millimetre of noise, while the head turns.",
        stage: heap_flights::hovering,
        bound: SPRITES,
        breaks: &["view-plane"],
    },
    Situation {
        name: "looking straight up",
        about: "Below the heap, with a millimetre of noise, while the head turns.",
        stage: heap_flights::looking_up,
        bound: SPRITES,
        breaks: &["view-plane"],
    },
    Situation {
        name: "looking straight down",
        about: "Above the heap, likewise.",
        stage: heap_flights::looking_down,
        bound: SPRITES,
        breaks: &["view-plane"],
    },
    Situation {
        name: "through a sprite's centre, light",
        about: "Straight through a plate of opacity 0.9 that fills the picture, 1 cm past its centre, half a metre a step.",
        stage: through_plate,
        bound: Bound {
            figure: Figure::Excess,
            at_most: 2.0 * ROUNDING,
            because: "The plate stays across the way and fades as the truth's does: both of two pictures are off by \
                      rounding alone.",
        },
        breaks: &["no-lock", "lock-without-fade", "dot-product", "view-plane"],
    },
    Situation {
        name: "through a sprite's centre, opacity",
        about: "The same.",
        stage: through_plate,
        bound: Bound {
            figure: Figure::Steps,
            at_most: 0.9 * CHANGES.fade as f64 / LOCK_M * 0.5 + 2.0 * ROUNDING,
            because: "Its alpha changes by 3.2 / lock distance a metre at most, and by half of that in a step.",
        },
        breaks: &["no-lock", "lock-without-fade", "dot-product", "view-plane"],
    },
    Situation {
        name: "eye in a sprite's plane",
        about: "Into the lock of a plate of opacity 0.9, then aside until the eye is half a metre before its plane.",
        stage: || beside_plate(into_lock().chain(aside()), 190),
        bound: Bound {
            figure: Figure::Opacity,
            at_most: 0.9 * 0.5 / (2.0 * LOCK_M) + ROUNDING,
            because: "Within the lock distance r a sprite shows as far as the eye is before its plane, 0.5 m / 2r of its \
                      opacity, and can be wrong by no more than it shows.",
        },
        breaks: &["no-lock", "lock-without-fade", "view-plane"],
    },
    Situation {
        name: "hovering in a sprite's plane",
        about: "On to the lock distance in that plane, and there with a millimetre of noise.",
        stage: || beside_plate(into_lock().chain(aside()).chain(to_lock_distance()), 210),
        bound: Bound {
            figure: Figure::Excess,
            at_most: 2.0 * ROUNDING,
            because: "The plate turns and fades as the truth's does: both of two pictures are off by rounding alone.",
        },
        breaks: &["lock-without-fade", "dot-product"],
    },
    Situation {
        name: "hovering at equal distances",
        about: "Two crossing plates of opacity 0.6, black and white, as far the one as the other but for a millimetre of \
                noise.",
        stage: changing_places,
        bound: Bound {
            figure: Figure::Excess,
            at_most: 2.0 * ROUNDING,
            because: "Each pixel orders the two by their own depths there, as the truth's rays do, so nothing changes places \
                      at once: both of two pictures are off by rounding alone.",
        },
        breaks: &["by-sprites"],
    },
    Situation {
        name: "past two sprites after a rest",
        about: "A rest of five seconds, then 9.8 m sideways in one, at the end of which the other of two plates is the \
                nearer one all over the picture.",
        stage: past_two,
        bound: exact(Figure::Light, "Sorted for the frame itself, the nearer plate is before the other: it is right."),
        breaks: &["lazy-skyworks", "lazy-simgear"],
    },
];

/// See [`super::CHANGES`].
const SPRITES: Bound = Bound {
    figure: Figure::Sprites,
    at_most: 1.0,
    because: "For each metre flown, times its lock distance, a sprite's alpha changes by 3.2 at most, its facing by 4 and \
              its up by 16, as derived beside the rule.",
};

/// Half the radius of a plate of 100 m.
const LOCK_M: f64 = 25.0;

fn at(position: DVec3, heading_deg: f64, field_of_view_deg: f64) -> Camera {
    Camera { heading_deg, field_of_view_deg, ..Camera::free(position) }
}

/// A hundred metres of opacity 0.9 at the origin, which is faced from the south.
fn one_plate() -> Scene {
    studio(&[plates(0.9, [ahead(0.0, 100.0, 1.0)])])
}

fn through_plate() -> Stage {
    let cameras = (0..120).map(|i| at(DVec3::new(0.01, 0.0, 45.0 - 0.5 * f64::from(i)), 0.0, 22.0));
    Stage::flight(one_plate(), Cow::Owned(solid_atlas()), cameras, |_| true)
}

/// Looking west, along the plate's plane; drawn from a step on.
fn beside_plate(way: impl Iterator<Item = DVec3>, from: usize) -> Stage {
    let cameras = way.map(|position| at(position, 270.0, 22.0));
    Stage::flight(one_plate(), Cow::Owned(solid_atlas()), cameras, |step| step >= from)
}

/// Steps 0 to 130.
fn into_lock() -> impl Iterator<Item = DVec3> {
    (0..=130).map(|i| DVec3::Z * (80.0 - 0.5 * f64::from(i)))
}

/// Steps 131 to 190.
fn aside() -> impl Iterator<Item = DVec3> {
    (1..=60).map(|i| (DVec3::Z * 15.0).lerp(DVec3::new(15.0, 0.0, 0.5), f64::from(i) / 60.0))
}

/// Steps 191 to 210 get there, but for a decimetre; the rest hovers.
fn to_lock_distance() -> impl Iterator<Item = DVec3> {
    let there = DVec3::X * LOCK_M;
    let short = there - DVec3::X * 0.1;
    let gets = (1..=20).map(move |i| DVec3::new(15.0, 0.0, 0.5).lerp(short, f64::from(i) / 20.0));
    gets.chain((0..30).map(move |i| there + noise(i)))
}

fn changing_places() -> Stage {
    let plate = |(x, light): (f64, f64)| Plate { center: DVec3::new(x, 0.0, -60.0), side_m: 80.0, light };
    let scene = studio(&[plates(0.6, [(-8.0, 0.0), (8.0, 1.0)].map(plate))]);
    let cameras = (0..30).map(|i| at(noise(i), 0.0, 16.0));
    Stage::flight(scene, Cow::Owned(solid_atlas()), cameras, |_| true)
}

/// SkyWorks sorts again after 10 m only; SimGear has by then found nothing to do so often that it looks every 128th
/// frame. At the end the distances are as 0.961 : 1 and the centres 9.4° apart, whose cosine is 0.986: as far as 13° to
/// either side of the middle, the plate that is nearer by its centre is nearer along each ray.
fn past_two() -> Stage {
    let plate = |(x, light): (f64, f64)| Plate { center: DVec3::new(x, 0.0, -20.0), side_m: 16.0, light };
    let scene = studio(&[plates(0.6, [(-1.75, 0.0), (1.75, 1.0)].map(plate))]);
    let way = (0..=360_u32).map(|i| -4.9 + 9.8 * f64::from(i.saturating_sub(300)) / 60.0);
    let cameras = way.map(|x| at(DVec3::new(x, 0.0, 0.0), -13.7 * x / 4.9, 6.0));
    Stage::flight(scene, Cow::Owned(solid_atlas()), cameras, |step| step == 360)
}
