//! Small scenes seen from places where drawing goes wrong: inside, straight up and down, through the near plane, far
//! from the origin.

use cloudwright_core::color::Rgba;
use cloudwright_core::derived::Derived;
use cloudwright_core::detail::Detail;
use cloudwright_core::draw_list::{DrawList, Hidden, Run};
use cloudwright_core::frame::Frame;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{
    BoxId, Camera, Category, Cloud, CloudBox, CloudId, CloudModel, ColorLevel, GroupCenter, GroupId, GroupLight,
    KeyValue, ModelId, Scene, ShadingGroup, Sun, Track, TrackId, TrackKey, Weather,
};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{Moment, SceneNow, Turn, WeatherRules};
use glam::{DQuat, DVec3};

/// One picture to draw.
#[derive(Debug, Clone)]
pub struct Case {
    /// For test names.
    pub name: &'static str,
    /// What is drawn.
    pub scene: Scene,
    /// From where.
    pub camera: Camera,
    /// Local civil hours.
    pub time_h: f64,
    /// Seconds of the scene's clock.
    pub clock_s: f64,
    /// What else the moment does.
    pub now: fn(&mut SceneNow<'_>),
    /// And the list.
    pub list: fn(&mut DrawList),
    /// What is left out.
    pub hidden: Hidden,
    /// How much of each cloud is drawn.
    pub detail: Detail,
}

const SIZE: [u32; 2] = [192, 128];
/// So much that in each picture some sprites are merged and some fade over.
const MERGED: Detail = Detail { tolerance_px: 7.0, ..Detail::FULL };

impl Case {
    /// Gives the case's frame to `draw`.
    pub fn with_frame<T>(&self, draw: impl FnOnce(&Frame<'_>) -> T) -> T {
        let derived = Derived::new(&self.scene);
        derived.bake(&Watch::default());
        let moment = Moment { clock_s: self.clock_s, time_h: Some(self.time_h) };
        let mut now =
            SceneNow::new(&self.scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
        (self.now)(&mut now);
        let rules = Rules { detail: self.detail, ..Rules::SHIPPED };
        let sight = Sight { hidden: self.hidden.clone(), rules, ..Sight::still(&self.camera, SIZE) };
        let mut frame = Frame::of(now, &derived, Atlas::built_in(), &sight);
        (self.list)(&mut frame.list);
        draw(&frame)
    }

    /// The same with another camera and another name.
    fn seen(&self, name: &'static str, position: [f64; 3], turn: impl FnOnce(&mut Camera)) -> Self {
        let mut case = self.clone();
        (case.name, case.camera.position) = (name, DVec3::from_array(position));
        turn(&mut case.camera);
        case
    }
}

/// All of them.
pub fn cases() -> Vec<Case> {
    let noon = Case {
        name: "noon_beside",
        scene: clouds(),
        camera: Camera::free(DVec3::new(0.0, 900.0, 1800.0)),
        time_h: 12.0,
        clock_s: 0.0,
        now: |_| (),
        list: |_| (),
        hidden: Hidden::default(),
        detail: Detail::FULL,
    };
    let mut dusk = noon.seen("dusk_towards_the_sun", [300.0, 700.0, 1500.0], |camera| camera.heading_deg = -50.0);
    dusk.time_h = 20.6;
    let mut no_ground = noon.seen("no_ground", [0.0, 1000.0, 1800.0], |camera| camera.pitch_deg = -30.0);
    no_ground.scene.ground = None;
    vec![
        noon.seen("inside", [20.0, 1010.0, -15.0], |camera| camera.heading_deg = 70.0),
        noon.seen("straight_up", [30.0, 300.0, 10.0], |camera| camera.pitch_deg = 90.0),
        noon.seen("straight_down", [-40.0, 2500.0, 20.0], |camera| camera.pitch_deg = -90.0),
        noon.seen("rolled", [900.0, 1200.0, 900.0], |camera| {
            (camera.heading_deg, camera.pitch_deg, camera.roll_deg) = (-45.0, -10.0, 130.0);
        }),
        through_the_near_plane(&noon),
        steps_and_far_haze(&noon),
        background("background_noon_with_sun", &noon, 14.0),
        background("background_dusk_with_sun", &noon, 20.9),
        background("background_night", &noon, 1.0),
        suns_disc(&noon),
        stars(&noon),
        moons_disc(&noon),
        Case { name: "without_haze", hidden: Hidden { haze: true, ..Hidden::default() }, ..steps_and_far_haze(&noon) },
        Case {
            hidden: Hidden { haze: true, ground: true, ..Hidden::default() },
            ..noon.seen("from_far_off_without_ground", [0.0, 1000.0, 2.4e6], |camera| camera.field_of_view_deg = 0.029)
        },
        noon.seen("from_far_above", [0.0, 2.4e6, 0.0], |camera| {
            (camera.pitch_deg, camera.field_of_view_deg) = (-90.0, 0.029);
        }),
        moved(&noon, "moved_1000_km", DVec3::new(1.0e6, 0.0, -1.0e6)),
        dusk,
        no_ground,
        Case {
            name: "carried_grown_and_faded",
            now: |now| {
                for (cloud, step) in now.clouds.iter_mut().zip(1..) {
                    cloud.displacement = DVec3::new(40.0, 25.0, -60.0) * f64::from(step);
                    (cloud.growth, cloud.opacity) = (1.4, 0.7);
                }
            },
            ..noon.clone()
        },
        Case {
            name: "turned_and_scaled",
            now: |now| {
                for (cloud, turn_deg) in now.clouds.iter_mut().zip([35.0_f32, -100.0, 170.0]) {
                    let (sin, cos) = turn_deg.to_radians().sin_cos();
                    (cloud.turn, cloud.scale) = (Turn::by(sin, cos), 1.3);
                }
            },
            ..noon.clone()
        },
        weather("in_wind_and_dry_air", &noon, [2400.0, 0.75, 0.0]),
        weather("in_churning_air", &noon, [77.7, 1.0, 1.0]),
        keyed_look(&noon),
        shading_itself(&noon),
        Case { detail: MERGED, ..shading_itself(&noon).seen("merged", [0.0, 1100.0, 6000.0], |_| ()) },
        Case { name: "merged_in_wind", detail: MERGED, ..weather("in_wind", &noon, [2400.0, 0.75, 0.3]) },
        Case {
            name: "in_two_runs",
            list: |list| {
                let from = list.sprites.len() / 2;
                list.runs = vec![Run::Sprites { from: 0, fade: 0.4 }, Run::Sprites { from, fade: 0.8 }];
            },
            ..noon.seen("in_two_runs", [20.0, 1010.0, -15.0], |camera| camera.heading_deg = 70.0)
        },
        noon,
    ]
}

/// `case` with clouds and camera elsewhere; by whole periods of the ground, the picture is the same.
pub fn moved(case: &Case, name: &'static str, by: DVec3) -> Case {
    let mut case = Case { name, ..case.clone() };
    case.camera.position += by;
    for cloud in &mut case.scene.clouds {
        cloud.position += by;
    }
    case
}

/// `case` in a wind that shears, at so many seconds, in air of that humidity and turbulence.
fn weather(name: &'static str, case: &Case, [clock_s, humidity, turbulence]: [f64; 3]) -> Case {
    let mut case = Case { name, clock_s, ..case.clone() };
    case.scene.weather = Weather { humidity, turbulence, wind_speed_mps: 14.0, wind_shear: 1.0, ..case.scene.weather };
    case.scene.clouds.iter_mut().for_each(|cloud| cloud.wind_share = 0.0);
    case
}

/// `case` with a colour level and a group's light that tracks have changed.
fn keyed_look(case: &Case) -> Case {
    let mut case = Case { name: "keyed_look", clock_s: 5.0, ..case.clone() };
    let model = &case.scene.models[0];
    let (level, each) = (format!("model/{}/color_levels/3/color", model.id), model.boxes[0].id);
    let light = format!("model/{}/box/{each}/light/c_max", model.id);
    for (property, value) in [(level, KeyValue::Three([0.9, 0.2, 0.1])), (light, KeyValue::One(0.2))] {
        let id = TrackId::new(&mut case.scene.next_id);
        case.scene.tracks.push(Track::new(id, property, vec![TrackKey::new(0.0, value)]));
    }
    case
}

/// Models that shade themselves to a different degree, one not at all, turned, seen from within a cloud towards a low sun.
fn shading_itself(noon: &Case) -> Case {
    let mut case = noon.seen("shading_itself", [20.0, 1010.0, 60.0], |camera| camera.heading_deg = -60.0);
    case.time_h = 19.5;
    for (model, [self_shadow, halo]) in case.scene.models.iter_mut().zip([[0.8, 1.0], [0.0, 0.6]]) {
        (model.self_shadow, model.halo) = (self_shadow, halo);
    }
    for (cloud, heading_deg) in case.scene.clouds.iter_mut().zip([70.0, 0.0, 200.0]) {
        cloud.heading_deg = heading_deg;
    }
    case.now = |now| now.clouds.iter_mut().take(1).for_each(|cloud| cloud.turn = Turn::by(0.6, 0.8));
    case
}

/// The eye a few metres before and behind the centres of sprites as large as houses.
fn through_the_near_plane(noon: &Case) -> Case {
    let mut case = noon.seen("through_the_near_plane", [0.0, 0.0, 0.0], |camera| {
        (camera.pitch_deg, camera.field_of_view_deg) = (10.0, 90.0);
    });
    let mut model = CloudModel::new(ModelId::new(&mut case.scene.next_id), "near", Category::CumulusCongestus);
    let mut cloud_box = CloudBox::new(BoxId::new(&mut case.scene.next_id), DVec3::ZERO);
    (cloud_box.size, cloud_box.sprite_count) = (DVec3::splat(3.0), 12);
    (cloud_box.width, cloud_box.height) = ([8.0, 14.0], [8.0, 14.0]);
    model.boxes.push(cloud_box);
    // And small ones around the eye itself, some of them cut at the near plane's 0.1 m.
    let mut close = CloudBox::new(BoxId::new(&mut case.scene.next_id), DVec3::new(0.3, 0.2, 0.3));
    (close.size, close.sprite_count) = (DVec3::splat(0.6), 12);
    (close.width, close.height) = ([0.3, 0.8], [0.3, 0.8]);
    model.boxes.push(close);
    model.cull_radius = cloudwright_core::scene::CullRadius::Metres(0.0);
    case.scene.clouds = vec![cloud(&mut case.scene, &model, DVec3::new(0.0, 900.0, 0.0))].into();
    case.scene.models = vec![model].into();
    case.camera.position = DVec3::new(0.3, 900.2, 0.4);
    case
}

/// Colour levels that step, and clouds far enough to haze, down to less than a pixel.
fn steps_and_far_haze(noon: &Case) -> Case {
    let mut case = noon.seen("steps_and_far_haze", [0.0, 1100.0, 6000.0], |_| ());
    case.scene.sky.haze_length_m = 15_000.0;
    let grey = |height: f64, value: f32, alpha: f32| ColorLevel { height, color: Rgba::new(value, value, 0.4, alpha) };
    for model in &mut case.scene.models {
        model.color_levels =
            [grey(0.1, 0.2, 0.5), grey(0.4, 0.3, 1.0), grey(0.4, 1.0, 0.7), grey(0.4, 0.8, 0.9), grey(0.9, 0.5, 1.0)];
    }
    for (i, x) in [-9000.0, -3000.0, 4000.0, 12_000.0].into_iter().enumerate() {
        let model = case.scene.models[0].clone();
        let position = DVec3::new(x, 1200.0, -10_000.0 * (i as f64 + 1.0) - 20_000.0);
        let far = cloud(&mut case.scene, &model, position);
        case.scene.clouds.push(far);
    }
    case
}

fn background(name: &'static str, noon: &Case, time_h: f64) -> Case {
    let mut case = noon.seen(name, [12_345.0, 700.0, -54_321.0], |camera| camera.field_of_view_deg = 100.0);
    case.scene.clouds.clear();
    case.time_h = time_h;
    let to_sun = cloudwright_core::weather::sun_direction(case.scene.sun, &case.scene.site, time_h).as_dvec3();
    case.camera.heading_deg = to_sun.x.atan2(-to_sun.z).to_degrees();
    case.camera.pitch_deg = to_sun.y.asin().to_degrees() - 20.0;
    case
}

/// The sun fills a quarter of the picture.
fn suns_disc(noon: &Case) -> Case {
    let mut case = background("background_suns_disc", noon, 14.0);
    case.camera.field_of_view_deg = 1.0;
    case.camera.pitch_deg += 20.0;
    case
}

/// A dozen degrees of a night's sky.
fn stars(noon: &Case) -> Case {
    let mut case = background("background_stars", noon, 1.0);
    (case.camera.heading_deg, case.camera.pitch_deg, case.camera.field_of_view_deg) = (200.0, 50.0, 12.0);
    case
}

/// A gibbous moon fills a tenth of the picture.
fn moons_disc(noon: &Case) -> Case {
    let mut case = background("background_moons_disc", noon, 23.0);
    case.scene.site.date = cloudwright_core::scene::Date { year: 2004, month: 6, day: 29 };
    let light = cloudwright_core::weather::Light::at(&case.scene, case.time_h);
    let to_moon = light.night.map_or(DVec3::NEG_Z, |night| night.moon_direction.as_dvec3());
    case.camera.heading_deg = to_moon.x.atan2(-to_moon.z).to_degrees();
    (case.camera.pitch_deg, case.camera.field_of_view_deg) = (to_moon.y.asin().to_degrees(), 1.2);
    case
}

/// Three clouds of two models: boxes that are turned, one of lumps, a group of its own with a centre by hand.
fn clouds() -> Scene {
    let mut scene = Scene { sun: Sun::ByPlace, ..Scene::default() };
    let group = ShadingGroup {
        id: GroupId::new(&mut scene.next_id),
        name: "shaded".into(),
        light: GroupLight {
            c_min: 0.05,
            c_med: 0.3,
            c_max: 0.9,
            center: GroupCenter::At(DVec3::new(40.0, 60.0, -20.0)),
        },
    };
    let mut cumulus = CloudModel::new(ModelId::new(&mut scene.next_id), "cumulus", Category::CumulusCongestus);
    for (x, y, count) in [(-200.0, 0.0, 60), (150.0, 60.0, 40), (0.0, 220.0, 30)] {
        let mut cloud_box = CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::new(x, y, 0.0));
        (cloud_box.size, cloud_box.sprite_count) = (DVec3::new(400.0, 180.0, 350.0), count);
        cloud_box.orientation = DQuat::from_rotation_z(0.3);
        cloud_box.lumps = [2, 1, 2];
        cumulus.boxes.push(cloud_box);
    }
    cumulus.boxes[2].group = Some(group.id);
    cumulus.boxes[2].light.c_max = 1.2;
    cumulus.groups.push(group);
    let mut stratus = CloudModel::new(ModelId::new(&mut scene.next_id), "stratus", Category::Stratus);
    let mut sheet = CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::ZERO);
    (sheet.size, sheet.sprite_count) = (DVec3::new(1500.0, 60.0, 900.0), 50);
    (sheet.width, sheet.height) = ([300.0, 500.0], [80.0, 160.0]);
    sheet.rotation_deg = [-5.0, 5.0];
    stratus.boxes.push(sheet);
    scene.clouds = vec![
        cloud(&mut scene, &cumulus, DVec3::new(0.0, 1000.0, 0.0)),
        cloud(&mut scene, &stratus, DVec3::new(-300.0, 1500.0, -2500.0)),
        cloud(&mut scene, &cumulus, DVec3::new(900.0, 1100.0, -900.0)),
    ]
    .into();
    (scene.clouds[2].heading_deg, scene.clouds[2].scale, scene.clouds[2].seed) = (77.0, 1.6, Some(9));
    scene.models = vec![cumulus, stratus].into();
    scene
}

fn cloud(scene: &mut Scene, model: &CloudModel, position: DVec3) -> Cloud {
    Cloud::new(CloudId::new(&mut scene.next_id), model, position)
}

/// `side` × `side` clouds in a field 1,600 m apart before the eye, for benches.
pub fn field(side: u32) -> Scene {
    let mut scene = clouds();
    let cumulus = scene.models[0].clone();
    scene.clouds.clear();
    for i in 0..side * side {
        let (x, z) = (f64::from(i % side) - 0.5 * f64::from(side), -f64::from(i / side) - 1.0);
        let mut one = cloud(&mut scene, &cumulus, DVec3::new(x * 1600.0, 1000.0, z * 1600.0));
        one.heading_deg = f64::from(i * 37 % 360);
        scene.clouds.push(one);
    }
    scene
}
