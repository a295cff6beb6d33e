//! What moves with the clock: where tracks put a cloud, how wind, air and humidity have it, and that bounds hold it.

use cloudwright_core::derived::Derived;
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::posed_sprite::PosedSprite;
use cloudwright_core::raster::fast;
use cloudwright_core::scene::{Beyond, Cloud, KeyValue, Leaves, Region, Scene, Track, TrackId, TrackKey, Weather};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::{CloudNow, Light, Moment, WeatherRules};
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};

/// A track whose value is `value` at 10 s, and has another before.
fn keyed(scene: &mut Scene, property: &str, before: KeyValue, value: KeyValue) {
    let keys = vec![TrackKey::new(0.0, before), TrackKey::new(10.0, value)];
    let id = TrackId::new(&mut scene.next_id);
    scene.tracks.push(Track::new(id, property, keys));
}

fn picture(scene: &Scene, clock_s: f64) -> Vec<u8> {
    let derived = Derived::new(scene);
    let sight = Sight { moment: Moment::at(clock_s), ..Sight::still(&scene.cameras[0], [96, 54]) };
    fast::picture(&Frame::new(scene, &derived, Atlas::built_in(), &sight)).as_bytes().to_vec()
}

/// How many steps of a channel two pictures differ by at most.
fn apart(a: &[u8], b: &[u8]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
}

/// What a track says at a time looks as if the scene said so.
#[test]
fn a_keyed_value_looks_as_if_it_were_set() {
    let scene = heap(40);
    let (cloud, model) = (scene.clouds[0].id, scene.models[0].id);
    let each = scene.models[0].boxes[0].id;
    type Set = fn(&mut Scene);
    let one = KeyValue::One;
    // Bytes where nothing but colours changes; where sprites are put elsewhere by another sum, f32 may round otherwise by
    // some 10⁻⁷ of 100 m, and a channel by a step. A cloud that is placed turned has another box about its centres, and so
    // another middle to which groups are pulled: two hundredths of the light.
    let cases: [(String, KeyValue, KeyValue, Set, u8); 14] = [
        ("time_of_day_h".into(), one(9.0), one(18.5), |s| s.time_of_day_h = 18.5, 0),
        ("sky/exposure_ev".into(), one(0.0), one(1.0), |s| s.sky.exposure_ev = 1.0, 0),
        ("sky/haze_length_m".into(), one(9e4), one(3000.0), |s| s.sky.haze_length_m = 3000.0, 0),
        ("sky/ambient_tuning/scale".into(), one(1.0), one(0.5), |s| s.sky.ambient_tuning.scale = 0.5, 0),
        ("weather/humidity".into(), one(1.0), one(0.5), |s| s.weather.humidity = 0.5, 0),
        (format!("cloud/{cloud}/opacity"), one(1.0), one(0.5), |s| s.clouds[0].opacity = 0.5, 0),
        (format!("cloud/{cloud}/growth"), one(1.0), one(1.5), |s| s.clouds[0].growth = 1.5, 0),
        (
            format!("cloud/{cloud}/formed/core"),
            one(1.0),
            one(0.5),
            |s| s.clouds[0].formed.get_or_insert_default().core = 0.5,
            0,
        ),
        (
            format!("cloud/{cloud}/position"),
            KeyValue::Three([0.0, 900.0, 0.0]),
            KeyValue::Three([120.0, 1050.0, -80.0]),
            |s| s.clouds[0].position = DVec3::new(120.0, 1050.0, -80.0),
            1,
        ),
        (format!("cloud/{cloud}/heading_deg"), one(0.0), one(130.0), |s| s.clouds[0].heading_deg = 130.0, 5),
        (format!("cloud/{cloud}/scale"), one(1.0), one(1.4), |s| s.clouds[0].scale = 1.4, 1),
        (
            format!("model/{model}/color_levels/3/color"),
            KeyValue::Three([0.1; 3]),
            KeyValue::Three([0.9, 0.3, 0.2]),
            |s| s.models[0].color_levels[3].color.rgb = cloudwright_core::color::Rgb::new(0.9, 0.3, 0.2),
            0,
        ),
        (
            format!("model/{model}/box/{each}/light/c_max"),
            one(1.0),
            one(0.1),
            |s| s.models[0].boxes[0].light.c_max = 0.1,
            0,
        ),
        (
            "ground/bright".into(),
            KeyValue::Three([0.0; 3]),
            KeyValue::Three([0.5; 3]),
            |s| {
                s.ground.as_mut().expect("a ground").bright = cloudwright_core::color::Rgb::grey(0.5);
            },
            0,
        ),
    ];
    let rest = picture(&scene, 0.0);
    for (property, before, value, set, steps) in cases {
        let (mut by_track, mut by_hand) = (scene.clone(), scene.clone());
        keyed(&mut by_track, &property, before, value);
        set(&mut by_hand);
        let (moved, set) = (picture(&by_track, 10.0), picture(&by_hand, 10.0));
        assert!(apart(&moved, &set) <= steps, "{property}: {} steps apart", apart(&moved, &set));
        assert!(apart(&moved, &rest) > 4, "{property} shows");
    }
}

/// Each sprite, wherever weather and tracks have it, within the sphere by which its cloud is culled.
#[test]
fn bounds_hold_what_moves() {
    let mut scene = heap(60);
    let cloud = scene.clouds[0].id;
    scene.weather = Weather {
        wind_speed_mps: 40.0,
        wind_shear: 3.0,
        turbulence: 1.0,
        lean: 2.0,
        lag_s: 1.0,
        growth: 1.6,
        ..Weather::default()
    };
    keyed(&mut scene, &format!("cloud/{cloud}/heading_deg"), KeyValue::One(0.0), KeyValue::One(170.0));
    keyed(&mut scene, &format!("cloud/{cloud}/scale"), KeyValue::One(0.7), KeyValue::One(2.0));
    let derived = Derived::new(&scene);
    for step in 0..60 {
        let clock_s = f64::from(step) * 0.37;
        let clouds = derived.clouds_at(clock_s, WeatherRules::default());
        let now = &clouds[0];
        for index in 0..now.placed.sprites.len() {
            let sprite = now.sprite_now(index);
            let from_center = sprite.position.distance(now.center_now());
            // Some sums of f32.
            let most = [now.reach_now() - sprite.reach(), now.radius_now()].map(|most| most * (1.0 + 1e-5));
            assert!(from_center <= most[0] && from_center <= most[1], "{clock_s} s, {index}: {from_center}, {most:?}");
        }
    }
}

/// What moves doesn't flicker: at each place of a quad it has the light that it has at rest.
#[test]
fn light_is_taken_at_rest() {
    let mut scene = heap(30);
    scene.weather = Weather { wind_speed_mps: 12.0, turbulence: 1.0, ..Weather::default() };
    let derived = Derived::new(&scene);
    let light = Light::at(&scene, 15.0);
    let pose = Pose { towards: Vec3::Z, up: Vec3::Y, fade: 1.0 };
    let at_rest = CloudNow::at_rest(&derived.clouds()[0]);
    for clock_s in [0.0, 3.3, 1e6] {
        let now = &derived.clouds_at(clock_s, WeatherRules::default())[0];
        let mut moved = 0;
        for index in 0..now.placed.sprites.len() {
            let [now, rest] = [now, &at_rest].map(|cloud| PosedSprite::new(cloud, index, pose, &light));
            moved += usize::from(now.sprite.position.distance(rest.sprite.position) > 0.1);
            for offset in [Vec3::ZERO, Vec3::new(40.0, 25.0, 0.0)] {
                assert_eq!(now.light_at(offset), rest.light_at(offset), "{clock_s} s, sprite {index}");
            }
        }
        assert!(moved > 10, "{moved} moved");
    }
}

/// A cloud that the wind carries out of its region comes in on the other side, and nothing of it shows meanwhile; one that
/// lets go of the wind stays where it has come to, and is not put back.
#[test]
fn nothing_is_seen_to_wrap_round() {
    let mut scene = heap(20);
    let region = Region { width_m: 4000.0, depth_m: 3000.0, border_m: 600.0, ..Region::default() };
    scene.weather = Weather { wind_from_deg: 300.0, wind_speed_mps: 20.0, region: Some(region), ..Weather::default() };
    wraps_unseen(&scene);
    let property = format!("cloud/{}/wind_share", scene.clouds[0].id);
    let keys = [(0.0, 1.0), (180.0, 1.0), (200.0, 0.0)].map(|(at, share)| TrackKey::new(at, KeyValue::One(share)));
    scene.tracks.push(Track::new(TrackId::new(&mut scene.next_id), property, keys.into()));
    wraps_unseen(&scene);
}

fn wraps_unseen(scene: &Scene) {
    let derived = Derived::new(scene);
    let at = |clock_s| {
        let now = &derived.clouds_at(clock_s, WeatherRules::default())[0];
        let middle = now.origin() + now.center_now().as_dvec3();
        (middle, f64::from(now.opacity_at(0.0)), now.shows())
    };
    let (mut before, mut jumps, mut whole) = (at(0.0), 0, 0);
    for step in 1..4000 {
        let now = at(f64::from(step) * 0.1);
        assert!(now.0.x.abs() <= 2000.0 + 1e-6 && now.0.z.abs() <= 1500.0 + 1e-6, "{}", now.0);
        // 2 m a step, and of opacity what 3·(1 + θ)/2 over 600 m allow: the eased share's steepest slope is 1.5.
        if now.0.distance(before.0) > 2.0 + 1e-3 {
            assert!(now.1 < 0.002 && before.1 < 0.002, "{before:?} to {now:?}");
            jumps += 1;
        }
        assert!((now.1 - before.1).abs() <= 2.25 * 2.0 / 600.0 + 1e-6);
        whole += usize::from(now.1 == 1.0 && now.2);
        before = now;
    }
    assert!(jumps >= 2 && whole > 500, "{jumps} jumps, {whole} times whole");
}

/// As humidity rises, each sprite condenses and none goes; at 0 there is nothing, at 1 everything.
#[test]
fn clouds_condense_as_humidity_rises() {
    let mut scene = heap(60);
    scene.weather.turbulence = 0.1;
    keyed(&mut scene, "weather/humidity", KeyValue::One(0.0), KeyValue::One(1.0));
    scene.tracks[0].keys[0].leaves = Leaves::Linear;
    let derived = Derived::new(&scene);
    let shares = |clock_s: f64| {
        let now = &derived.clouds_at(clock_s, WeatherRules::default())[0];
        (0..now.placed.sprites.len()).map(|index| now.condensed(index)).collect::<Vec<f32>>()
    };
    let mut before = shares(0.0);
    assert!(before.iter().all(|share| *share == 0.0));
    for step in 1..=100 {
        let now = shares(f64::from(step) * 0.1);
        assert!(now.iter().zip(&before).all(|(now, before)| now >= before), "at {step} of 100");
        before = now;
    }
    assert!(before.iter().all(|share| *share == 1.0));
    // At half the humidity, half of them.
    let there = shares(5.0).iter().filter(|share| **share >= 0.5).count();
    assert!(there.abs_diff(before.len() / 2) <= 1, "{there} of {} at half", before.len());
}

/// 125 m for each degree that the dew point falls away from the temperature, for who follows.
#[test]
fn bases_rise_as_espy_says() {
    let mut scene = heap(20);
    let other = Cloud {
        base_share: 0.5,
        id: cloudwright_core::scene::CloudId::new(&mut scene.next_id),
        ..scene.clouds[0].clone()
    };
    scene.clouds.push(other);
    (scene.weather.temperature_c, scene.weather.dew_point_c) = (18.0, 10.0);
    keyed(&mut scene, "weather/temperature_c", KeyValue::One(18.0), KeyValue::One(21.0));
    keyed(&mut scene, "weather/dew_point_c", KeyValue::One(10.0), KeyValue::One(9.0));
    let derived = Derived::new(&scene);
    for (clock_s, want_m) in [(0.0, 0.0), (10.0, 500.0)] {
        let clouds = derived.clouds_at(clock_s, WeatherRules::default());
        let lifts = clouds.iter().map(|cloud| cloud.displacement.y).collect::<Vec<_>>();
        assert_eq!(lifts, [want_m, 0.5 * want_m], "at {clock_s} s");
    }
}

/// The hour runs by the clock, and keys of it are in its place.
#[test]
fn hours_run_or_are_keyed() {
    let mut scene = heap(10);
    scene.time_of_day_h = 22.0;
    scene.weather.day_speed = 3600.0;
    let hour = |scene: &Scene, clock_s| Derived::new(scene).timeline().time_of_day_h(scene, clock_s);
    assert_eq!([hour(&scene, 0.0), hour(&scene, 1.5), hour(&scene, 4.0)], [22.0, 23.5, 2.0]);
    keyed(&mut scene, "time_of_day_h", KeyValue::One(4.0), KeyValue::One(28.0));
    scene.tracks[0].keys[0].leaves = Leaves::Linear;
    scene.tracks[0].after = Beyond::Repeat;
    assert_eq!([hour(&scene, 0.0), hour(&scene, 5.0), hour(&scene, 12.5)], [4.0, 16.0, 10.0]);
}
