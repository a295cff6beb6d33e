//! All sprites of a scene for other tools, as JSON (`"format": "cloudwright-sprites"`, version 1).
//!
//! Metres in the world; angles in degrees counter-clockwise as seen; colours linear with straight alpha; heights of
//! levels and corners from 0 at the cloud's bottom to 1 at its top; tiles 0 to 15 row by row.

use super::pretty_json;
use crate::camera::View;
use crate::color::{Rgb, Rgba, shortest_f64};
use crate::facing::{Pose, corners};
use crate::scene::{BoxId, ColorLevel};
use crate::shading::corner_light;
use crate::sprites::{Group, PlacedCloud, Sprite};
use crate::weather::{CloudNow, FormingRule, Light};
use glam::{DVec3, Vec3};
use serde::Serialize;
use serde_json::to_value;

#[derive(Serialize)]
struct LightOut {
    time: String,
    sun_direction: [f64; 3],
    ambient_max: Rgba,
    directional_max: Rgb,
}

#[derive(Serialize)]
struct LevelOut {
    height: f64,
    rgba: Rgba,
}

#[derive(Serialize)]
struct GroupOut {
    id: String,
    center: DVec3,
    c_min: f64,
    c_med: f64,
    c_max: f64,
}

#[derive(Serialize)]
struct SpriteOut {
    #[serde(rename = "box")]
    box_id: BoxId,
    index: u32,
    position: DVec3,
    width: f64,
    height: f64,
    rotation_deg: f64,
    tile: u8,
    group: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    corners: Option<[CornerOut; 4]>,
}

#[derive(Serialize)]
struct CornerOut {
    position: DVec3,
    height: f64,
    ambient: Rgba,
    directional: Rgb,
    color: Rgba,
}

/// How corners are seen, for both formats.
#[derive(Debug, Clone, Copy)]
pub struct Shaded<'a> {
    /// Which eye the sprites face.
    pub view: &'a View,
    /// The light on them.
    pub light: &'a Light,
    /// Seconds of the scene's clock: how far clouds have formed.
    pub clock_s: f64,
}

/// All `clouds` as text. With `shaded`, each sprite has its corners as that eye sees them.
///
/// # Errors
/// None in practice: every number of a placed cloud is finite.
pub fn write(clouds: &[PlacedCloud], shaded: Option<Shaded<'_>>) -> Result<String, serde_json::Error> {
    let mut head = vec![("format", "cloudwright-sprites".into()), ("version", 1.into())];
    if let Some(Shaded { light, .. }) = shaded {
        let light = LightOut {
            time: crate::math::clock(light.time_h),
            sun_direction: light.sun_direction.to_array().map(shortest_f64),
            ambient_max: light.ambient_max,
            directional_max: light.directional_max,
        };
        head.push(("light", to_value(light)?));
    }
    let mut out = String::new();
    pretty_json::write_list(&mut out, 0, &head, ("clouds", clouds.len()), |out, i| {
        write_cloud(out, &clouds[i], shaded)
    })?;
    out.push('\n');
    Ok(out)
}

fn write_cloud(out: &mut String, cloud: &PlacedCloud, shaded: Option<Shaded<'_>>) -> Result<(), serde_json::Error> {
    let levels = cloud.color_levels.map(|ColorLevel { height, color }| LevelOut { height, rgba: color });
    let groups: Vec<GroupOut> = cloud.groups.iter().map(|group| group_out(cloud, group)).collect();
    let altitude = |y: f32| ten_thousandths(cloud.origin.y + f64::from(y));
    let head = [
        ("id", to_value(cloud.id)?),
        ("name", cloud.name.as_str().into()),
        ("category", to_value(cloud.category)?),
        ("center", to_value(in_world(cloud, cloud.center))?),
        ("radius", shortest_f64(cloud.radius).into()),
        ("bottom", altitude(cloud.bottom).into()),
        ("top", altitude(cloud.top).into()),
        ("color_levels", to_value(levels)?),
        ("groups", to_value(groups)?),
    ];
    pretty_json::write_list(out, 4, &head, ("sprites", cloud.sprites.len()), |out, i| {
        pretty_json::write_value(&to_value(sprite_out(cloud, &cloud.sprites[i], shaded))?, 8, out);
        Ok(())
    })
}

fn group_out(cloud: &PlacedCloud, group: &Group) -> GroupOut {
    let [c_min, c_med, c_max] = group.c.map(shortest_f64);
    GroupOut { id: group.key.to_string(), center: in_world(cloud, group.center), c_min, c_med, c_max }
}

fn sprite_out(cloud: &PlacedCloud, sprite: &Sprite, shaded: Option<Shaded<'_>>) -> SpriteOut {
    let group = &cloud.groups[sprite.group as usize];
    SpriteOut {
        box_id: sprite.box_id,
        index: sprite.index,
        position: in_world(cloud, sprite.position),
        width: shortest_f64(sprite.width),
        height: shortest_f64(sprite.height),
        rotation_deg: shortest_f64(sprite.rotation.to_degrees()),
        tile: sprite.tile,
        group: group.key.to_string(),
        corners: shaded.map(|shaded| corners_out(cloud, sprite, group, shaded)),
    }
}

fn corners_out(cloud: &PlacedCloud, sprite: &Sprite, group: &Group, shaded: Shaded<'_>) -> [CornerOut; 4] {
    let Shaded { view, light, clock_s } = shaded;
    let now = CloudNow::at(cloud, clock_s, FormingRule::ClosedForm);
    let center = now.from_eye(view.eye) + sprite.position;
    let pose = Pose::still(center, sprite.radius(), view);
    corners(sprite.position, pose.facing(sprite.rotation), sprite.width, sprite.height).map(|point| {
        let mut lit = corner_light(point, &now, group, light);
        lit.ambient.a *= pose.fade;
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
fn in_world(cloud: &PlacedCloud, point: Vec3) -> DVec3 {
    (cloud.origin + point.as_dvec3()).map(ten_thousandths)
}

fn ten_thousandths(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}
