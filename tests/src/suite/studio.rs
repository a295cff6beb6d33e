//! Scenes in which every pixel can be worked out on paper: plates of one alpha and one colour before a black sky.
//!
//! The tile is solid in its middle and clear around it, the same at every mip level. A picture that shows the middle of
//! every plate alone has no edge to sample and nothing to filter: what a method gets wrong there is its order, its
//! rounding, what it drops, or how it turns and fades what is near. There is neither haze nor veil; the light is white,
//! the same from everywhere.

use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::scene::{
    BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, CullRadius, DailyTable, GroupCenter, GroupLight, IdCounter,
    List, ModelId, Scene, Sky, Sun,
};
use cloudwright_core::sprites::Atlas;
use glam::DVec3;

/// Half of what shows no edge of a plate at any mip level, in its sides: the tile is solid from its 16th texel to its
/// 112th of 128, and at the coarsest level, 16 times as coarse, a filter reaches half a texel, 8, into that.
pub const SOLID: f64 = 40.0 / 128.0;

/// A square sprite.
#[derive(Debug, Clone, Copy)]
pub struct Plate {
    /// Metres in the world.
    pub center: DVec3,
    /// Its side, metres.
    pub side_m: f64,
    /// The share of the directional light that it takes: its colour.
    pub light: f64,
}

/// A cloud of plates.
#[derive(Debug, Clone)]
pub struct PlateCloud {
    /// Its colour in ambient light, the same at every height, and its opacity.
    pub level: Rgba,
    /// Its sprites, in order of their indices.
    pub plates: Vec<Plate>,
}

/// Black plates of opacity `alpha`, but for what light each takes.
pub fn plates(alpha: f32, plates: impl IntoIterator<Item = Plate>) -> PlateCloud {
    PlateCloud { level: Rgba::new(0.0, 0.0, 0.0, alpha), plates: plates.into_iter().collect() }
}

/// A plate straight ahead of an eye at the origin that looks north.
pub fn ahead(distance_m: f64, side_m: f64, light: f64) -> Plate {
    Plate { center: DVec3::NEG_Z * distance_m, side_m, light }
}

/// A scene of these clouds under a black sky.
pub fn studio(clouds: &[PlateCloud]) -> Scene {
    let mut scene = Scene {
        name: "studio".into(),
        next_id: IdCounter::default(),
        sun: Sun::ByHand { heading_deg: 180.0, elevation_deg: 45.0 },
        sky: Sky {
            ambient: DailyTable::constant(Rgba::new(1.0, 1.0, 1.0, 1.0)),
            directional: DailyTable::constant(Rgb::grey(1.0)),
            gain: 0.0,
            haze_length_m: 1e9,
            inside_density: 0.0,
            ..Sky::default()
        },
        ground: None,
        cameras: List::new(),
        ..Scene::default()
    };
    for cloud in clouds {
        let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "plates", Category::SolidCumulus);
        model.cull_radius = CullRadius::Metres(0.0);
        model.color_levels.iter_mut().for_each(|level| level.color = cloud.level);
        model.boxes = cloud.plates.iter().map(|plate| plate_box(&mut scene.next_id, plate)).collect();
        scene.clouds.push(Cloud::new(CloudId::new(&mut scene.next_id), &model, DVec3::ZERO));
        scene.models.push(model);
    }
    scene
}

fn plate_box(next_id: &mut IdCounter, plate: &Plate) -> CloudBox {
    let Plate { center, side_m, light } = *plate;
    CloudBox {
        size: DVec3::ZERO,
        sprite_count: 1,
        width: [side_m; 2],
        height: [side_m; 2],
        rotation_deg: [0.0; 2],
        light: GroupLight { c_min: light, c_med: light, c_max: light, center: GroupCenter::Mean },
        ..CloudBox::new(BoxId::new(next_id), center)
    }
}

/// Sixteen white tiles that are solid in their middle.
pub fn solid_atlas() -> Atlas {
    atlas(|_, _| 255)
}

/// The same with every other texel clear: half as opaque as soon as two are filtered into one.
pub fn checkered_atlas() -> Atlas {
    atlas(|x, y| if (x + y) % 2 == 0 { 255 } else { 0 })
}

/// The same with all clear to the left of `texel`.
pub fn half_atlas(texel: usize) -> Atlas {
    atlas(|x, _| if x % 128 >= texel { 255 } else { 0 })
}

fn atlas(alpha: impl Fn(usize, usize) -> u8) -> Atlas {
    let inside = |t: usize| (16..112).contains(&(t % 128));
    let texel = |i: usize| {
        let (x, y) = (i % 512, i / 512);
        [255, 255, 255, if inside(x) && inside(y) { alpha(x, y) } else { 0 }]
    };
    Atlas::from_sheet(&(0..512 * 512).map(texel).collect::<Vec<_>>())
}
