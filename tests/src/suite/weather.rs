//! Weather in which steps are too long: edges that follow the wind, and air that dries at once.

use super::Situation;
use super::bounds::{Bound, exact};
use super::figure::Figure;
use super::heap_flights::stirred;
use super::stage::{Look, Stage};
use super::studio::{Plate, half_atlas, plates, solid_atlas, studio};
use cloudwright_core::scene::{Beyond, Camera, KeyValue, Leaves, Scene, Track, TrackId, TrackKey, Weather};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::MOST_LEAN;
use glam::DVec3;
use std::borrow::Cow;

/// As far as edges may lean, and what f32 may add to it.
const FARTHEST: f64 = MOST_LEAN + 1e-5;
const NO_RATE: Bound = Bound {
    figure: Figure::Rates,
    at_most: 1e-6,
    because: "The closed form does not know how often it is asked: what is left are roundings of f32.",
};

pub(super) const SITUATIONS: &[Situation] = &[
    Situation {
        name: "a wind that jumps",
        about: "From calm to 40 m/s after two seconds, and about; edges follow within 40 ms.",
        stage: || windy(0.04, looks(4.0, 40), solid_atlas()),
        bound: Bound {
            figure: Figure::Moves,
            at_most: FARTHEST,
            because: "What follows is a mean of what it followed, and that is held within the most that edges lean.",
        },
        breaks: &["stepped-wind"],
    },
    Situation {
        name: "a lag of a millisecond",
        about: "The same wind, and edges that follow it within a picture.",
        stage: || windy(0.001, looks(4.0, 40), solid_atlas()),
        bound: exact(Figure::Opacity, "Plates that lean no further than they may still fill the picture."),
        breaks: &["stepped-wind"],
    },
    Situation {
        name: "a stall of ten minutes",
        about: "The same wind and a lag of three seconds; a look after two seconds, and one after ten minutes.",
        stage: || windy(3.0, [2.5, 602.5].into_iter(), half_atlas(64)),
        bound: NO_RATE,
        breaks: &["stepped-wind"],
    },
    Situation {
        name: "a clock at ten million seconds",
        about: "Four months of the same wind, and a lag of three seconds.",
        stage: || windy(3.0, [1e7, 1e7 + 1.3].into_iter(), half_atlas(64)),
        bound: NO_RATE,
        breaks: &["stepped-wind"],
    },
    Situation {
        name: "humidity that falls in a frame",
        about: "All thresholds are crossed from one look to the next: whole before, nothing after.",
        stage: dried,
        bound: exact(Figure::Opacity, "Each sprite's share follows from the humidity of the moment alone."),
        breaks: &[],
    },
    Situation {
        name: "through a cloud in the wind",
        about: "Steps of half a metre through a heap that 15 m/s carry against the eye, in air that churns.",
        stage: stirred,
        bound: Bound {
            figure: Figure::Sprites,
            at_most: 1.0,
            because: "Near the eye a sprite changes by the way between the two alone, whichever of them moves.",
        },
        breaks: &["dot-product"],
    },
];

fn looks(a_second: f64, last: u32) -> impl Iterator<Item = f64> {
    (0..=last).map(move |i| f64::from(i) / a_second)
}

/// Two plates at the edges of a cloud of 200 m, so that both hang loosely, seen by an eye so far before one of them that
/// only its middle shows, wherever it leans.
fn plates_at_the_edges(weather: Weather) -> Scene {
    let plate = |x: f64| Plate { center: DVec3::new(x, 0.0, -3000.0), side_m: 1200.0, light: 0.0 };
    let mut scene = studio(&[plates(0.8, [plate(-200.0), plate(200.0)])]);
    scene.weather = weather;
    scene.clouds.iter_mut().for_each(|cloud| cloud.wind_share = 0.0);
    scene
}

fn stage(scene: Scene, looks: impl Iterator<Item = f64>, atlas: Atlas) -> Stage {
    let camera = Camera { field_of_view_deg: 0.5, ..Camera::free(DVec3::ZERO) };
    let looks = looks.map(|clock_s| Look { camera: camera.clone(), clock_s, drawn: true }).collect();
    Stage { scene, atlas: Cow::Owned(atlas), size: [24, 14], flies: false, looks }
}

fn windy(lag_s: f64, looks: impl Iterator<Item = f64>, atlas: Atlas) -> Stage {
    let mut scene = plates_at_the_edges(Weather { lag_s, wind_from_deg: 300.0, ..Weather::default() });
    let steps = [0.0, 40.0, 5.0, 0.0].into_iter().zip([0.0, 2.0, 3.5, 7.0]);
    track(&mut scene, "weather/wind_speed_mps", steps, Leaves::Step);
    stage(scene, looks, atlas)
}

fn dried() -> Stage {
    let mut scene = plates_at_the_edges(Weather::default());
    track(&mut scene, "weather/humidity", [(1.0, 0.0), (0.0, 1.0)].into_iter(), Leaves::Step);
    scene.tracks[0].after = Beyond::Hold;
    stage(scene, looks(8.0, 16), solid_atlas())
}

/// Values at times, again and again.
fn track(scene: &mut Scene, property: &str, keys: impl Iterator<Item = (f64, f64)>, leaves: Leaves) {
    let key = |(value, time_s): (f64, f64)| TrackKey { leaves, ..TrackKey::new(time_s, KeyValue::One(value)) };
    let id = TrackId::new(&mut scene.next_id);
    scene.tracks.push(Track { after: Beyond::Repeat, ..Track::new(id, property, keys.map(key).collect()) });
}
