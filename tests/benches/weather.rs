//! Weather: `cargo bench -p cloudwright-tests --bench weather`.
//!
//! Targets on an idle machine of two cores: 500 tracks of 50 keys at one time on one core in 0.2 ms; a picture of
//! `overcast` in wind, dry and churning air within 1.15 times that of the same at rest, 4,000 drifting clouds within 1.1
//! times, a scrub's first picture no dearer than its next; a key edited in `overcast` in 5 ms to the new draw list. Ratios
//! are of medians taken in turns within one run, so that they hold on a busy machine too.

use cloudwright_core::derived::Derived;
use cloudwright_core::document::{Document, Edit, ListEdit};
use cloudwright_core::frame::Frame;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::raster::fast;
use cloudwright_core::scene::{KeyValue, Scene, Track, TrackId, TrackKey, Weather};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::{Moment, SceneNow, Timeline, WeatherRules};
use cloudwright_tests::authoring;
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

/// Keys of the wind beside it, and gusts that come again and again, after so many seconds.
fn windy(scene: &Scene, gusts_s: f64) -> Scene {
    let mut scene = scene.clone();
    let mut add = |property: &str, values: &[f64], every_s: f64| {
        let key = |(i, value): (usize, &f64)| TrackKey::new(i as f64 * every_s, KeyValue::One(*value));
        let keys = values.iter().enumerate().map(key).collect();
        let mut track = Track::new(TrackId::new(&mut scene.next_id), property, keys);
        track.after = cloudwright_core::scene::Beyond::Repeat;
        scene.tracks.push(track);
    };
    add("weather/wind_speed_mps", &[6.0, 11.0, 7.0, 9.0, 6.0], gusts_s / 4.0);
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
    frames();
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
    for (gusts, gusts_s) in [("fit", 12.0), ("don't", 12.345_678)] {
        let blown = windy(&scene, gusts_s);
        let making = least(|_| drop(black_box(Timeline::new(&blown))));
        println!("… with a wind that veers in periods that {gusts:<5} {:>8.3} ms", ms(making));
    }

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

/// Medians of `runs` of each, taken in turns.
fn medians<const N: usize>(runs: usize, mut each: [&mut dyn FnMut(usize); N]) -> [Duration; N] {
    let mut times = vec![Vec::with_capacity(runs); N];
    for i in 0..runs {
        for (run, times) in each.iter_mut().zip(&mut times) {
            let began = Instant::now();
            run(i);
            times.push(began.elapsed());
        }
    }
    times.iter_mut().for_each(|times| times.sort_unstable());
    std::array::from_fn(|n| times[n][runs / 2])
}

fn overcast() -> Scene {
    authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make()).expect("it is shipped")
}

#[allow(clippy::print_stdout, reason = "what it measured is its answer")]
fn frames() {
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    let picture = |scene: &Scene, derived: &Derived, clock_s: f64| {
        let sight = Sight { moment: Moment::at(clock_s), ..Sight::still(&scene.cameras[0], [1280, 720]) };
        drop(black_box(fast::picture(&Frame::new(scene, derived, Atlas::built_in(), &sight))));
    };
    let in_weather = |still: &Scene, weather: Weather| {
        let scene = Scene { weather, ..still.clone() };
        let derived = Derived::new(&scene);
        (scene, derived)
    };
    let windy = Weather { wind_speed_mps: 9.0, ..Weather::default() };
    for (name, still, weather, runs, limit) in [
        ("overcast", overcast(), Weather { humidity: 0.97, turbulence: 0.5, ..windy }, 41, 1.15),
        ("4000 clouds", crowd(4000), windy, 41, 1.1),
    ] {
        let at_rest = Derived::new(&still);
        let (scene, derived) = in_weather(&still, weather);
        picture(&scene, &derived, 0.0);
        let mut rest = |i: usize| picture(&still, &at_rest, i as f64);
        let mut moving = |i: usize| picture(&scene, &derived, i as f64 * 0.1);
        let [rest, moving] = medians(runs, [&mut rest, &mut moving]);
        let ratio = ms(moving) / ms(rest);
        println!(
            "{name:<12} at rest {:>7.2} ms, in weather {:>7.2} ms   ratio {ratio:.3}   limit {limit}",
            ms(rest),
            ms(moving)
        );
        let mut first = |i: usize| picture(&scene, &derived, ((i * 7919) % 1000) as f64 * 97.0);
        let mut next = |i: usize| picture(&scene, &derived, ((i * 7919) % 1000) as f64 * 97.0 + 1.0 / 30.0);
        let [first, next] = medians(runs, [&mut first, &mut next]);
        println!("{name:<12} first after a scrub to the next          ratio {:.3}", ms(first) / ms(next));
    }
    let mut document = Document::new(overcast());
    let keys = (0..50).map(|i| TrackKey::new(f64::from(i), KeyValue::One(8.0 + f64::from(i % 7)))).collect();
    let mut counter = document.scene().next_id;
    let mut track = Track::new(TrackId::new(&mut counter), "weather/wind_speed_mps", keys);
    let added = Edit::Track(ListEdit::Insert { at: 0, value: track.clone() });
    document.edit("Key", [Edit::NextId(counter), added]).expect("a sound track");
    let mut derived = Derived::new(document.scene());
    let mut edit = |i: usize| {
        track.keys[20].value = KeyValue::One(5.0 + i as f64 * 0.1);
        let change = document.edit("Key", [Edit::Track(ListEdit::Replace(track.clone()))]).expect("a sound track");
        derived.update(document.scene(), &change);
        let sight = Sight { moment: Moment::at(20.0), ..Sight::still(&document.scene().cameras[0], [1280, 720]) };
        drop(black_box(Frame::new(document.scene(), &derived, Atlas::built_in(), &sight)));
    };
    let [edit] = medians(41, [&mut edit]);
    println!("overcast     a key edited, to the new draw list   {:>7.2} ms   limit 5", ms(edit));
}
