//! Weather: `cargo bench -p cloudwright-tests --bench weather`.
//!
//! Targets on an idle machine of two cores: 500 tracks of 50 keys at one time on one core in 0.2 ms. The table of ratios
//! compares within one run, so that it holds on a busy machine too.

use cloudwright_core::derived::Derived;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::scene::{KeyValue, Scene, Track, TrackId, TrackKey};
use cloudwright_core::weather::{Moment, SceneNow, Timeline, WeatherRules};
use cloudwright_tests::small_scenes::crowd;
use std::hint::black_box;
use std::time::{Duration, Instant};

const TRACKS: usize = 500;
const KEYS: u32 = 50;

/// A hundred clouds that five tracks each move, smoothly.
fn keyed() -> Scene {
    let mut scene = crowd(100);
    let ids: Vec<_> = scene.clouds.iter().map(|cloud| cloud.id).collect();
    for id in ids {
        for property in ["position", "heading_deg", "scale", "opacity", "growth"] {
            let roll = |i: u32| unit(draw(id.0, property.len() as u64, i, 0)[0]);
            let value = |i: u32| match property {
                "position" => {
                    KeyValue::Three([roll(3 * i), roll(3 * i + 1), roll(3 * i + 2)].map(|share| 900.0 * share))
                }
                _ => KeyValue::One(0.5 + 0.5 * roll(i)),
            };
            let keys = (0..KEYS).map(|i| TrackKey::new(f64::from(i) * 2.0 + roll(i + 500), value(i))).collect();
            let track = Track::new(TrackId::new(&mut scene.next_id), format!("cloud/{id}/{property}"), keys);
            scene.tracks.push(track);
        }
    }
    assert_eq!(scene.tracks.len(), TRACKS);
    scene
}

/// Keys of the wind beside it, and gusts that come again and again.
fn windy(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    let mut add = |property: &str, values: &[f64], every_s: f64| {
        let key = |(i, value): (usize, &f64)| TrackKey::new(i as f64 * every_s, KeyValue::One(*value));
        let keys = values.iter().enumerate().map(key).collect();
        let mut track = Track::new(TrackId::new(&mut scene.next_id), property, keys);
        track.after = cloudwright_core::scene::Beyond::Repeat;
        scene.tracks.push(track);
    };
    add("weather/wind_speed_mps", &[6.0, 11.0, 7.0, 9.0, 6.0], 3.0);
    add("weather/wind_from_deg", &[200.0, 260.0, 320.0, 200.0], 20.0);
    scene
}

/// The least of 200 runs: what it takes undisturbed.
fn least(mut run: impl FnMut(f64)) -> Duration {
    let time = |i: u32| {
        let clock_s = f64::from(i % 97) * 1.013;
        let began = Instant::now();
        run(clock_s);
        began.elapsed()
    };
    (0..200).map(time).min().unwrap_or_default()
}

fn main() {
    // `cargo test` builds benches too, and runs them.
    if !std::env::args().any(|arg| arg == "--bench") {
        return;
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    pool.install(run);
}

#[allow(clippy::print_stdout, reason = "what it measured is its answer")]
fn run() {
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    let scene = keyed();
    let timeline = Timeline::new(&scene);
    let at_a_time = least(|clock_s| drop(black_box(timeline.scene_at(&scene, clock_s))));
    println!("{TRACKS} tracks of {KEYS} keys at one time, one core   {:>8.3} ms   limit 0.2", ms(at_a_time));
    let making = least(|_| drop(black_box(Timeline::new(&scene))));
    println!("making their timeline                          {:>8.3} ms", ms(making));
    let blown = windy(&scene);
    let making_wind = least(|_| drop(black_box(Timeline::new(&blown))));
    println!("… with a keyed wind that repeats               {:>8.3} ms", ms(making_wind));

    let still = crowd(4000);
    let mut drifting = still.clone();
    drifting.weather.wind_speed_mps = 9.0;
    let mut graded = still.clone();
    let keys = [0.0, 100.0].map(|time_s| TrackKey::new(time_s, KeyValue::One(0.01 * time_s)));
    graded.tracks.push(Track::new(TrackId::new(&mut graded.next_id), "sky/exposure_ev", keys.to_vec()));
    let mut times = Vec::new();
    for (name, scene) in [("still", &still), ("drifting", &drifting), ("graded", &graded)] {
        let derived = Derived::new(scene);
        // What is made once, the first time, is no part of it.
        drop(derived.clouds_at(0.0, WeatherRules::default()));
        let clouds = least(|clock_s| drop(black_box(derived.clouds_at(clock_s, WeatherRules::default()))));
        let whole = least(|clock_s| {
            let (parts, moment) = ((derived.clouds(), derived.timeline().as_ref()), Moment::at(clock_s));
            drop(black_box(SceneNow::new(scene, parts, moment, WeatherRules::default())));
        });
        println!(
            "4000 clouds, {name:<9} at one time               {:>8.3} ms   scene {:>8.3} ms",
            ms(clouds),
            ms(whole)
        );
        times.push(ms(clouds));
    }
    println!("drifting to still                              {:>8.2}", times[1] / times[0]);
}
