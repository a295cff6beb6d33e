//! All sprites of a scene for other tools, as JSON (`"format": "cloudwright-sprites"`, version 1).
//!
//! Metres in the world; angles in degrees counter-clockwise as seen; colours linear with straight alpha; heights of
//! levels and corners from 0 at the cloud's bottom to 1 at its top; tiles 0 to 15 row by row.

use super::pretty_json::LongObject;
use super::schema;
use crate::color::{Rgb, Rgba, shortest_f64};
use crate::posed_sprite::{PosedSprite, Still};
use crate::scene::{BoxId, Category, CloudId, ColorLevel};
use crate::sprites::Group;
use crate::watch::Watch;
use crate::weather::CloudNow;
use glam::{DVec3, Vec3};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::to_value;
use std::io::{self, Write};

/// The file's shape. It is written piece by piece: as a whole it would be held in memory several times.
#[derive(JsonSchema)]
#[schemars(title = "cloudwright-sprites", deny_unknown_fields)]
#[expect(dead_code, reason = "only its shape is wanted")]
struct FileOut {
    /// `cloudwright-sprites`.
    format: String,
    /// 1.
    version: u32,
    /// The light on the corners; only with those.
    #[schemars(skip_serializing_if = "Option::is_none")]
    light: Option<LightOut>,
    clouds: Vec<CloudOut>,
}

#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "only its shape is wanted")]
struct CloudOut {
    id: CloudId,
    name: String,
    category: Category,
    /// Of the box that holds its sprites' centres.
    center: [f64; 3],
    /// Half that box's diagonal.
    radius: f64,
    /// Altitude of its lowest sprite's sphere.
    bottom: f64,
    /// Altitude of its highest sprite's sphere.
    top: f64,
    color_levels: [LevelOut; 5],
    groups: Vec<GroupOut>,
    sprites: Vec<SpriteOut>,
}

#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct LightOut {
    time: String,
    sun_direction: [f64; 3],
    ambient_max: Rgba,
    directional_max: Rgb,
}

#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct LevelOut {
    height: f64,
    rgba: Rgba,
}

#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct GroupOut {
    id: String,
    #[schemars(with = "[f64; 3]")]
    center: DVec3,
    c_min: f64,
    c_med: f64,
    c_max: f64,
}

#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct SpriteOut {
    #[serde(rename = "box")]
    box_id: BoxId,
    index: u32,
    #[schemars(with = "[f64; 3]")]
    position: DVec3,
    width: f64,
    height: f64,
    rotation_deg: f64,
    tile: u8,
    group: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    corners: Option<[CornerOut; 4]>,
}

#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct CornerOut {
    #[schemars(with = "[f64; 3]")]
    position: DVec3,
    height: f64,
    ambient: Rgba,
    directional: Rgb,
    color: Rgba,
}

/// The JSON Schema of what [`write()`] writes.
///
/// # Errors
/// None in practice: every schema can be said in JSON.
pub fn json_schema() -> Result<String, serde_json::Error> {
    schema::text_of::<FileOut>()
}

/// Writes all `clouds` as text. With `shaded`, each sprite has its corners as that still shows them. The text ends early
/// if `watch` is cancelled.
///
/// # Errors
/// Those of `out`. None of its own in practice: every number of a placed cloud is finite.
pub fn write(
    out: &mut impl Write,
    clouds: &[CloudNow<'_>],
    shaded: Option<Still<'_>>,
    watch: &Watch,
) -> io::Result<()> {
    watch.expect(clouds.iter().map(|cloud| cloud.placed.sprites.len() as u64).sum());
    let mut file = LongObject::begin(out, 0)?;
    file.field("format", &"cloudwright-sprites".into())?;
    file.field("version", &1.into())?;
    if let Some(Still { light, .. }) = shaded {
        let light = LightOut {
            time: crate::math::clock(light.time_h),
            sun_direction: light.direction.to_array().map(shortest_f64),
            ambient_max: light.ambient_max,
            directional_max: light.directional_max,
        };
        file.field("light", &to_value(light)?)?;
    }
    file.list_by("clouds", clouds.iter(), |out, cloud| write_cloud(out, cloud, shaded, watch))?;
    file.end()?;
    writeln!(out)
}

fn write_cloud(out: &mut impl Write, cloud: &CloudNow<'_>, shaded: Option<Still<'_>>, watch: &Watch) -> io::Result<()> {
    let placed = cloud.placed;
    let levels = cloud.color_levels().map(|ColorLevel { height, color }| LevelOut { height, rgba: color });
    let altitude = |y: f32| ten_thousandths(cloud.origin().y + f64::from(cloud.point_now(placed.center.with_y(y)).y));
    let mut object = LongObject::begin(out, 4)?;
    object.field("id", &to_value(placed.id)?)?;
    object.field("name", &placed.name.as_str().into())?;
    object.field("category", &to_value(placed.category)?)?;
    object.field("center", &to_value(in_world(cloud, cloud.center_now()))?)?;
    object.field("radius", &shortest_f64(placed.radius * cloud.scale).into())?;
    object.field("bottom", &altitude(placed.bottom).into())?;
    object.field("top", &altitude(placed.top).into())?;
    object.field("color_levels", &to_value(levels)?)?;
    object.list("groups", cloud.groups().iter(), |group| to_value(group_out(cloud, group)))?;
    let indices: Vec<usize> = (0..placed.sprites.len()).collect();
    let sprites = watch.along(1, &indices);
    object.list("sprites", sprites, |index| to_value(sprite_out(cloud, *index, shaded)))?;
    object.end()
}

fn group_out(cloud: &CloudNow<'_>, group: &Group) -> GroupOut {
    let [c_min, c_med, c_max] = group.c.map(shortest_f64);
    GroupOut { id: group.key.to_string(), center: in_world(cloud, cloud.point_now(group.center)), c_min, c_med, c_max }
}

fn sprite_out(cloud: &CloudNow<'_>, index: usize, shaded: Option<Still<'_>>) -> SpriteOut {
    let sprite = cloud.sprite_now(index);
    SpriteOut {
        box_id: sprite.box_id,
        index: sprite.index,
        position: in_world(cloud, sprite.position),
        width: shortest_f64(sprite.width),
        height: shortest_f64(sprite.height),
        rotation_deg: shortest_f64(sprite.rotation.to_degrees()),
        tile: sprite.tile,
        group: cloud.groups()[sprite.group as usize].key.to_string(),
        corners: shaded.map(|still| corners_out(cloud, &still.posed(cloud, index))),
    }
}

fn corners_out(cloud: &CloudNow<'_>, posed: &PosedSprite<'_>) -> [CornerOut; 4] {
    posed.corners(Vec3::ZERO).map(|offset| {
        let (point, lit) = (posed.sprite.position + offset, posed.light_at(offset));
        CornerOut {
            position: in_world(cloud, point),
            height: shortest_f64(lit.height),
            ambient: lit.ambient,
            directional: lit.directional,
            color: lit.color(),
        }
    })
}

/// A point of the cloud in the world, to a tenth of a millimetre: f32 holds no more within a cloud.
fn in_world(cloud: &CloudNow<'_>, point: Vec3) -> DVec3 {
    (cloud.origin() + point.as_dvec3()).map(ten_thousandths)
}

fn ten_thousandths(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}
