//! Sprites that meet, pile up, are far, tiny, huge, bright; suns where formulas end.

use super::Situation;
use super::bounds::{Bound, ROUNDING, STOP, exact, swapped};
use super::figure::Figure;
use super::stage::Stage;
use super::studio::{Plate, PlateCloud, SOLID, ahead, checkered_atlas, plates, solid_atlas, studio};
use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::scene::{Camera, DailyTable, GroupCenter, Scene, Sky, Sun};
use glam::DVec3;
use std::borrow::Cow;

pub(super) const SITUATIONS: &[Situation] = &[
    Situation {
        name: "equal distances",
        about: "A black plate and a white one, of opacity 0.6, as far away the one as the other, crossing in the \
                picture's middle.",
        stage: || still(crossing(0.6, [[0.0, 60.0], [1.0, 60.0]]), 16.0),
        bound: Bound {
            figure: Figure::Light,
            at_most: 0.5 * swapped(0.6) + ROUNDING,
            because: "Each pixel has its own order. Where the planes cross within one, the truth's samples lie on both sides, \
                      at most half of them on the other than the pixel's middle, and those cost α² times the difference of \
                      their colours.",
        },
        breaks: &["half", "quarter", "by-sprites"],
    },
    Situation {
        name: "coincident sprites",
        about: "Sixteen plates of opacity 0.15 in one place, white and black in turn.",
        stage: || still(studio(&[plates(0.15, (0..16).map(|i| ahead(60.0, 80.0, f64::from(i % 2))))]), 16.0),
        bound: exact(Figure::Light, "All are equally far along each ray, and ties go by index here as in the truth."),
        breaks: &["eight-bits", "half", "quarter", "three-quarters"],
    },
    Situation {
        name: "intersecting at dusk, light",
        about: "Two plates of opacity 0.6 that cross, one lit by the low sun, the other turned away from it.",
        stage: || still(dusk(), 16.0),
        bound: Bound {
            figure: Figure::Light,
            at_most: 0.5 * swapped(0.6) * DUSK.r as f64 + 2.0 * ROUNDING,
            because: "Where the planes cross within a pixel, half of the truth's samples at most are in the other order, which \
                      costs α² times the difference of their colours, at most the sun's red of 1.2.",
        },
        breaks: &["half", "quarter", "by-sprites"],
    },
    Situation {
        name: "intersecting at dusk, opacity",
        about: "The same two.",
        stage: || still(dusk(), 16.0),
        bound: exact(Figure::Opacity, "1 − Π(1 − α) does not depend on the order: only rounding is left."),
        breaks: &["half", "quarter"],
    },
    Situation {
        name: "sun at the horizon",
        about: "Three plates of opacity 0.5 before the sun that sets, under the real sky and in its haze.",
        stage: || still(before_sun(0.0), 16.0),
        bound: BEFORE_SUN,
        breaks: &["half", "quarter"],
    },
    Situation {
        name: "sun straight above",
        about: "The same before the sun at the zenith, seen looking straight up.",
        stage: || still(before_sun(90.0), 16.0),
        bound: BEFORE_SUN,
        breaks: &["half", "quarter"],
    },
    Situation {
        name: "eye at a sprite's centre",
        about: "A white plate around the eye, whose centre it is, before a grey one.",
        stage: || {
            let around = Plate { center: DVec3::ZERO, side_m: 80.0, light: 1.0 };
            still(studio(&[plates(0.9, [around, ahead(60.0, 80.0, 0.5)])]), 16.0)
        },
        bound: exact(Figure::Light, "A sprite in whose plane the eye lies has faded away, and the other one is alone."),
        breaks: &["half", "quarter"],
    },
    Situation {
        name: "a cloud 200 km away",
        about: "One plate whose texels are solid and clear in turn, seventeen of them a pixel.",
        stage: far_checkers,
        bound: exact(
            Figure::Light,
            "From the first halving on, all texels are the mean of solid and clear, for one sample a pixel as for sixteen, \
             which are four texels apart.",
        ),
        breaks: &["no-mips"],
    },
    Situation {
        name: "10,000 sprites at one point",
        about: "White plates of opacity 0.0002, all in one place.",
        stage: crowd,
        bound: Bound {
            figure: Figure::Light,
            at_most: ROUNDING + 10_000.0 * 4.0 / (1 << 25) as f64,
            because: "Each layer rounds colour and transmittance to half a unit of 2⁻²⁴, here and in the truth.",
        },
        breaks: &["eight-bits", "three-quarters", "half", "quarter"],
    },
    Situation {
        name: "eighty layers",
        about: "Eighty plates of opacity 0.1, one behind the other.",
        stage: || {
            let layers = (0..80).map(|i| ahead(60.0 + 0.25 * f64::from(i), 80.0, f64::from(i % 2)));
            still(studio(&[plates(0.1, layers)]), 16.0)
        },
        bound: Bound {
            figure: Figure::Opacity,
            at_most: STOP + ROUNDING,
            because: "A pixel is done where less than 1/1024 gets through, which is all that may be missing.",
        },
        breaks: &["early-stop", "three-quarters", "half", "quarter"],
    },
    Situation {
        name: "from 1 cm to 50 km",
        about: "Eight clouds of one plate each, of opacity 0.4, white and black in turn, from 1 cm to 50 km and each 30 of \
                its sides away.",
        stage: || {
            let sides = [0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 5e4];
            let plate = |(i, side_m): (usize, f64)| plates(0.4, [ahead(30.0 * side_m, side_m, 1.0 - (i % 2) as f64)]);
            // The solid part of each, and no more: 16 : 9, and a twentieth to spare.
            let half_height = 0.95 * SOLID / 30.0 * 9.0 / 16.0;
            still(
                studio(&sides.into_iter().enumerate().map(plate).collect::<Vec<_>>()),
                2.0 * half_height.atan().to_degrees(),
            )
        },
        bound: exact(Figure::Light, "All look alike but for their order, and that is one of distance at any size."),
        breaks: &["early-stop"],
    },
    Situation {
        name: "alpha 0 and 1",
        about: "A white plate of opacity 0 before a solid one, of a grey between two bytes of sRGB, before a white one.",
        stage: || {
            let clouds = [plates(0.0, [ahead(60.0, 80.0, 1.0)]), plates(1.0, [ahead(61.0, 80.0, 0.22)])];
            still(studio(&[clouds[0].clone(), clouds[1].clone(), plates(1.0, [ahead(62.0, 80.0, 1.0)])]), 16.0)
        },
        bound: exact(Figure::Light, "What is clear adds nothing, and nothing gets through what is solid."),
        breaks: &["eight-bits"],
    },
    Situation {
        name: "extreme colour levels",
        about: "A plate at the limit of all colours, a million, behind five black ones of opacity 0.6.",
        stage: limits,
        bound: Bound {
            figure: Figure::Light,
            at_most: BRIGHTEST * (STOP + ROUNDING),
            because: "Of the brightest light there is, 1,004,000, less than 1/1024 may be left out, besides rounding.",
        },
        breaks: &["early-stop", "three-quarters", "half", "quarter", "eight-bits"],
    },
];

/// Of the sun at 20.6 h.
const DUSK: Rgb = Rgb::new(1.2, 0.54, 0.16);
/// Colours and lights are 1,000 at most, and shares of the sun 4.
const BRIGHTEST: f64 = 1000.0 * 1000.0 + 4.0 * 1000.0;

const BEFORE_SUN: Bound = Bound {
    figure: Figure::Clouds,
    at_most: 2.0 * ROUNDING,
    because: "None crosses another and none has an edge in view; rounding is of light below 2.",
};

fn still(scene: Scene, field_of_view_deg: f64) -> Stage {
    let looks_up = matches!(scene.sun, Sun::ByHand { elevation_deg: 90.0, .. });
    let pitch_deg = if looks_up { 90.0 } else { 0.0 };
    let camera = Camera { field_of_view_deg, pitch_deg, ..Camera::free(DVec3::ZERO) };
    Stage::still(scene, Cow::Owned(solid_atlas()), camera)
}

/// Two plates that cross, each with its light and how far north of the eye it stands.
fn crossing(alpha: f32, of: [[f64; 2]; 2]) -> Scene {
    let plate =
        |(x, [light, north_m]): (f64, [f64; 2])| Plate { center: DVec3::new(x, 0.0, -north_m), side_m: 80.0, light };
    studio(&[plates(alpha, [-8.0, 8.0].into_iter().zip(of).map(plate))])
}

/// The sun stands in the west. Both plates' shading groups have their centres far off, so that one is all on its
/// sunny side, and the other all on its dark side.
fn dusk() -> Scene {
    let mut scene = crossing(0.6, [[0.0, 60.0], [0.0, 61.0]]);
    scene.time_of_day_h = 20.6;
    scene.sun = Sun::ByHand { heading_deg: 270.0, elevation_deg: 2.0 };
    scene.sky.directional = Sky::default().directional;
    let boxes = scene.models.iter_mut().flat_map(|model| &mut model.boxes);
    for (plate, x) in boxes.zip([-1e4, 1e4]) {
        (plate.light.c_min, plate.light.c_med, plate.light.c_max) = (0.0, 0.42, 1.0);
        plate.light.center = GroupCenter::At(DVec3::new(x, 0.0, -60.0));
    }
    scene
}

fn before_sun(elevation_deg: f64) -> Scene {
    let forward = if elevation_deg == 90.0 { DVec3::Y } else { DVec3::NEG_Z };
    let plate = |distance_m: f64| Plate { center: forward * distance_m, ..ahead(distance_m, 80.0, 0.0) };
    let level = Rgba::new(0.6, 0.6, 0.6, 0.5);
    let mut scene = studio(&[PlateCloud { level, plates: [60.0, 62.0, 64.0].map(plate).into() }]);
    scene.sky = Sky { inside_density: 0.0, ..Sky::default() };
    scene.sun = Sun::ByHand { heading_deg: 0.0, elevation_deg };
    for plate in scene.models.iter_mut().flat_map(|model| &mut model.boxes) {
        (plate.light.c_min, plate.light.c_med, plate.light.c_max) = (0.0, 0.42, 1.0);
    }
    scene
}

/// A truth's sample, a quarter of a pixel, still takes more than two texels.
fn far_checkers() -> Stage {
    const DISTANCE_M: f64 = 200_000.0;
    const SIDE_M: f64 = 2_000.0;
    const TEXELS_A_PIXEL: f64 = 17.0;
    let size = [5, 3];
    let half_height = 0.5 * f64::from(size[1]) * TEXELS_A_PIXEL * SIDE_M / 128.0 / DISTANCE_M;
    let camera = Camera { field_of_view_deg: 2.0 * half_height.atan().to_degrees(), ..Camera::free(DVec3::ZERO) };
    let scene = studio(&[plates(1.0, [ahead(DISTANCE_M, SIDE_M, 1.0)])]);
    Stage { size, ..Stage::still(scene, Cow::Owned(checkered_atlas()), camera) }
}

fn crowd() -> Stage {
    let mut scene = studio(&[plates(2e-4, [ahead(60.0, 80.0, 1.0)])]);
    scene.models.iter_mut().flat_map(|model| &mut model.boxes).for_each(|plate| plate.sprite_count = 10_000);
    Stage { size: [8, 4], ..still(scene, 16.0) }
}

fn limits() -> Stage {
    let lamp = PlateCloud { level: Rgba::new(1000.0, 1000.0, 1000.0, 1.0), plates: vec![ahead(66.0, 80.0, 4.0)] };
    let mut scene = studio(&[plates(0.6, (0..5).map(|i| ahead(60.0 + f64::from(i), 80.0, 0.0))), lamp]);
    scene.sky.ambient = DailyTable::constant(Rgba::new(1000.0, 1000.0, 1000.0, 1.0));
    scene.sky.directional = DailyTable::constant(Rgb::grey(1000.0));
    still(scene, 16.0)
}
