//! A scene in the making: gives ids, keeps a seeded dice, adds boxes with the usual settings.

use cloudwright_core::random::{draw, unit};
use cloudwright_core::scene::{
    Beyond, BoxId, Camera, CameraId, CameraPath, Category, Cloud, CloudBox, CloudId, CloudModel, ColorLevels,
    CullRadius, GroupCenter, GroupLight, IdCounter, KeyValue, Leaves, List, ModelId, PathId, PathKey, Scene, Track,
    TrackId, TrackKey,
};
use glam::{DQuat, DVec3};

/// A scene with the means to fill it.
pub struct Sketch {
    /// The scene so far.
    pub scene: Scene,
    seed: u64,
    rolls: std::cell::Cell<u32>,
}

/// A box in few words.
#[derive(Clone, Copy)]
pub struct Strew {
    /// Middle, metres in the model.
    pub center: DVec3,
    /// Full extent, metres.
    pub size: DVec3,
    /// Sprites tried.
    pub count: u32,
    /// Smallest and largest side of the sprites, metres.
    pub sprite: [f64; 2],
    /// Height over width.
    pub squash: f64,
    /// Tiles.
    pub category: Category,
    /// Share of the sun away from it, across, towards it.
    pub light: [f64; 3],
    /// Share of the way that the group's centre is moved to the cloud's.
    pub pull: f64,
    /// The group's centre put here instead, metres in the model: the side of the cloud that the lumps belong to.
    pub heart: Option<DVec3>,
    /// Lumps along the box's axes.
    pub lumps: [u32; 3],
    /// Turn about the vertical, degrees.
    pub turn_deg: f64,
}

impl Default for Strew {
    fn default() -> Self {
        Self {
            center: DVec3::ZERO,
            size: DVec3::splat(100.0),
            count: 20,
            sprite: [100.0, 150.0],
            squash: 1.0,
            category: Category::SolidCumulus,
            light: [0.0, 0.42, 1.0],
            pull: 0.33,
            heart: None,
            lumps: [1, 1, 1],
            turn_deg: 0.0,
        }
    }
}

impl Sketch {
    /// An empty scene without cameras.
    pub fn new(name: &str, seed: u64) -> Self {
        let scene = Scene { name: name.into(), cameras: List::new(), next_id: Default::default(), ..Scene::default() };
        Self { scene, seed, rolls: Default::default() }
    }

    /// The next number of the dice, uniform between `from` and `to`.
    pub fn roll(&self, from: f64, to: f64) -> f64 {
        self.rolls.set(self.rolls.get() + 1);
        from + (to - from) * unit(draw(self.seed, 0, self.rolls.get(), 0)[0])
    }

    /// The dice's seed, and how often it was rolled.
    pub(super) fn dice(&self) -> (u64, u32) {
        (self.seed, self.rolls.get())
    }

    /// Somebody else has rolled the dice meanwhile, and taken ids.
    pub(super) fn go_on(&mut self, rolls: u32, next_id: IdCounter) {
        self.rolls.set(rolls);
        self.scene.next_id = next_id;
    }

    /// A new camera that looks from `position` to `target`.
    pub fn camera(&mut self, name: &str, position: DVec3, target: DVec3, field_of_view_deg: f64) {
        let to = target - position;
        let round = |x: f64| (x * 100.0).round() / 100.0;
        let mut camera = Camera::new(CameraId::new(&mut self.scene.next_id), name, position);
        camera.heading_deg = round(to.x.atan2(-to.z).to_degrees().rem_euclid(360.0));
        camera.pitch_deg = round(to.y.atan2(to.x.hypot(to.z)).to_degrees());
        camera.field_of_view_deg = field_of_view_deg;
        self.scene.cameras.push(camera);
    }

    /// A new path whose keys look ahead along it, but for what each adds: seconds, place, and by how many degrees the
    /// look turns right and up.
    pub fn path(&mut self, name: &str, field_of_view_deg: f64, keys: &[(f64, DVec3, [f64; 2])]) -> PathId {
        let id = PathId::new(&mut self.scene.next_id);
        let round = |x: f64| (x * 10.0).round() / 10.0;
        let key = |(i, (time_s, position, [right_deg, up_deg])): (usize, &(f64, DVec3, [f64; 2]))| {
            let (from, to) = (keys[i.saturating_sub(1)].1, keys[(i + 1).min(keys.len() - 1)].1);
            let way = to - from;
            PathKey {
                time_s: *time_s,
                position: position.round(),
                heading_deg: round((way.x.atan2(-way.z).to_degrees() + right_deg).rem_euclid(360.0)),
                pitch_deg: round(way.y.atan2(way.x.hypot(way.z)).to_degrees() + up_deg),
                roll_deg: 0.0,
            }
        };
        let keys = keys.iter().enumerate().map(key).collect();
        self.scene.paths.push(CameraPath { id, name: name.into(), field_of_view_deg, keys });
        id
    }

    /// A new model without boxes; its seed is of the dice.
    pub fn model(&mut self, name: &str, category: Category, cull_share: f64, levels: ColorLevels) -> CloudModel {
        let mut model = CloudModel::new(ModelId::new(&mut self.scene.next_id), name, category);
        model.seed = self.roll(1.0, 1e6) as u64;
        model.cull_radius = CullRadius::SpriteFraction(cull_share);
        model.color_levels = levels;
        model
    }

    /// Adds a box to `model`; numbers are rounded as an artist would type them.
    pub fn strew(&mut self, model: &mut CloudModel, name: &str, strew: Strew) {
        let metre = |v: DVec3| v.round();
        let [c_min, c_med, c_max] = strew.light;
        let flat = strew.category == Category::FlatBase;
        let mut cloud_box = CloudBox::new(BoxId::new(&mut self.scene.next_id), metre(strew.center));
        cloud_box.name = name.into();
        cloud_box.size = metre(strew.size);
        if strew.turn_deg != 0.0 {
            cloud_box.orientation = DQuat::from_rotation_y(strew.turn_deg.to_radians());
        }
        cloud_box.sprite_count = strew.count;
        cloud_box.width = strew.sprite.map(f64::round);
        cloud_box.height = strew.sprite.map(|side| (side * strew.squash).round());
        let square = (0.8..1.25).contains(&strew.squash);
        cloud_box.rotation_deg = if flat || !square { [-5.0, 5.0] } else { [0.0, 360.0] };
        cloud_box.category = (strew.category != model.category).then_some(strew.category);
        cloud_box.lumps = strew.lumps;
        cloud_box.light = GroupLight {
            c_min,
            c_med,
            c_max,
            center: match strew.heart {
                Some(heart) => GroupCenter::At(metre(heart)),
                None if strew.pull > 0.0 => GroupCenter::Pulled(strew.pull),
                None => GroupCenter::Mean,
            },
        };
        model.boxes.push(cloud_box);
    }

    /// Places `model` (already in the scene).
    pub fn place(
        &mut self,
        model: ModelId,
        name: &str,
        position: DVec3,
        heading_deg: f64,
        scale: f64,
        seed: Option<u64>,
    ) {
        let id = CloudId::new(&mut self.scene.next_id);
        let cloud = Cloud {
            name: name.into(),
            position: position.round(),
            heading_deg: heading_deg.round(),
            scale: (scale * 100.0).round() / 100.0,
            seed,
            ..Cloud::new(id, self.scene.model(model).expect("a model"), position)
        };
        self.scene.clouds.push(cloud);
    }

    /// A new track of the property of that address: seconds and values.
    pub fn key(&mut self, property: &str, leaves: Leaves, beyond: Beyond, keys: &[(f64, f64)]) {
        let key = |(time_s, value): &(f64, f64)| TrackKey { leaves, ..TrackKey::new(*time_s, KeyValue::One(*value)) };
        let id = TrackId::new(&mut self.scene.next_id);
        let track = Track::new(id, property, keys.iter().map(key).collect());
        self.scene.tracks.push(Track { before: beyond, after: beyond, ..track });
    }

    /// The same of the cloud that was placed last, smooth, and as its first key before and its last key after.
    pub fn key_cloud(&mut self, property: &str, keys: &[(f64, f64)]) {
        let id = self.scene.clouds.last().expect("a cloud").id;
        self.key(&format!("cloud/{id}/{property}"), Leaves::Smooth, Beyond::Hold, keys);
    }
}
