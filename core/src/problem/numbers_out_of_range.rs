//! Every number must be one, and within the range of its [`Parameter`].
//!
//! NaN and infinities would spread through every sum; numbers beyond the ranges would overflow f32 or ask for more
//! memory than there is. Places are put into words only where something is wrong: a drag asks at every step.

use super::Problem;
use super::scope::Scope;
use crate::color::{Rgb, Rgba};
use crate::parameter::{self as p, Parameter};
use crate::scene::{
    Aircraft, Camera, CameraPath, Cloud, CloudModel, CullRadius, Formation, GroupCenter, GroupLight, Scene, Sky, Sun,
};
use glam::DVec3;
use std::fmt::Arguments;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    let Scope { scene, change } = scope;
    let mut walk = Walk { problems };
    if change.touches_head() {
        walk.head(scene);
    }
    if let Some(ground) = scene.ground.as_ref().filter(|_| change.touches_ground()) {
        walk.number(format_args!("ground.altitude_m"), &p::POSITION, ground.altitude_m);
        walk.rgb(format_args!("ground.dark"), ground.dark);
        walk.rgb(format_args!("ground.bright"), ground.bright);
    }
    for (i, camera) in scope.all::<Camera>() {
        walk.point(format_args!("cameras[{i}].position"), &p::POSITION, camera.position);
        walk.number(format_args!("cameras[{i}].heading_deg"), &p::HEADING_DEG, camera.heading_deg);
        walk.number(format_args!("cameras[{i}].pitch_deg"), &p::PITCH_DEG, camera.pitch_deg);
        walk.number(format_args!("cameras[{i}].roll_deg"), &p::ROLL_DEG, camera.roll_deg);
        walk.number(format_args!("cameras[{i}].field_of_view_deg"), &p::FIELD_OF_VIEW_DEG, camera.field_of_view_deg);
    }
    for (i, model) in scope.models() {
        walk.model(format_args!("models[{i}]"), model);
    }
    for (i, cloud) in scope.all::<Cloud>() {
        walk.point(format_args!("clouds[{i}].position"), &p::POSITION, cloud.position);
        walk.number(format_args!("clouds[{i}].heading_deg"), &p::HEADING_DEG, cloud.heading_deg);
        walk.number(format_args!("clouds[{i}].scale"), &p::CLOUD_SCALE, cloud.scale);
        if let Some(formation) = &cloud.formation {
            walk.formation(format_args!("clouds[{i}].formation"), formation);
        }
    }
    for (i, path) in scope.all::<CameraPath>() {
        walk.path(format_args!("paths[{i}]"), path);
    }
    for (i, aircraft) in scope.all::<Aircraft>() {
        walk.number(format_args!("aircraft[{i}].ahead_s"), &p::AIRCRAFT_AHEAD_S, aircraft.ahead_s);
        walk.number(format_args!("aircraft[{i}].scale"), &p::AIRCRAFT_SCALE, aircraft.scale);
    }
}

struct Walk<'a> {
    problems: &'a mut Vec<Problem>,
}

impl Walk<'_> {
    fn head(&mut self, scene: &Scene) {
        self.number(format_args!("time_of_day_h"), &p::TIME_OF_DAY_H, scene.time_of_day_h);
        self.number(format_args!("place.latitude_deg"), &p::LATITUDE_DEG, scene.place.latitude_deg);
        self.number(format_args!("place.longitude_deg"), &p::LONGITUDE_DEG, scene.place.longitude_deg);
        self.number(format_args!("place.utc_offset_h"), &p::UTC_OFFSET_H, scene.place.utc_offset_h);
        if let Sun::ByHand { heading_deg, elevation_deg } = scene.sun {
            self.number(format_args!("sun.by_hand.heading_deg"), &p::HEADING_DEG, heading_deg);
            self.number(format_args!("sun.by_hand.elevation_deg"), &p::ELEVATION_DEG, elevation_deg);
        }
        self.sky(&scene.sky);
    }

    fn number(&mut self, place: Arguments<'_>, parameter: &Parameter, value: f64) {
        if parameter.allows(value) {
            return;
        }
        let Parameter { min, max, unit, doc, .. } = parameter;
        let space = if unit.is_empty() { "" } else { " " };
        self.problems.push(Problem::error(
            place.to_string(),
            format!("{value} is out of range"),
            format!("use {min} to {max}{space}{unit}. {doc}"),
        ));
    }

    fn point(&mut self, place: Arguments<'_>, parameter: &Parameter, point: DVec3) {
        for (axis, value) in ["x", "y", "z"].into_iter().zip(point.to_array()) {
            self.number(format_args!("{place}.{axis}"), parameter, value);
        }
    }

    fn rgb(&mut self, place: Arguments<'_>, color: Rgb) {
        for (channel, value) in ["r", "g", "b"].into_iter().zip(color.to_array()) {
            self.number(format_args!("{place}.{channel}"), &p::COLOR, value.into());
        }
    }

    fn rgba(&mut self, place: Arguments<'_>, color: Rgba) {
        self.rgb(place, color.rgb);
        self.number(format_args!("{place}.a"), &p::ALPHA, color.a.into());
    }

    fn sky(&mut self, sky: &Sky) {
        for (i, key) in sky.ambient.keys.iter().enumerate() {
            self.number(format_args!("sky.ambient[{i}].hour"), &p::TIME_OF_DAY_H, key.hour);
            self.rgba(format_args!("sky.ambient[{i}].value"), key.value);
        }
        for (i, key) in sky.directional.keys.iter().enumerate() {
            self.number(format_args!("sky.directional[{i}].hour"), &p::TIME_OF_DAY_H, key.hour);
            self.rgb(format_args!("sky.directional[{i}].value"), key.value);
        }
        self.number(format_args!("sky.turbidity"), &p::TURBIDITY, sky.turbidity);
        self.number(format_args!("sky.gain"), &p::SKY_GAIN, sky.gain);
        self.number(format_args!("sky.haze_length_m"), &p::HAZE_LENGTH_M, sky.haze_length_m);
        self.number(format_args!("sky.exposure_ev"), &p::EXPOSURE_EV, sky.exposure_ev);
        self.number(format_args!("sky.inside_density"), &p::INSIDE_DENSITY, sky.inside_density);
    }

    fn formation(&mut self, place: Arguments<'_>, formation: &Formation) {
        self.number(format_args!("{place}.start_s"), &p::FORMATION_START_S, formation.start_s);
        self.number(format_args!("{place}.core_s"), &p::FORMATION_CORE_S, formation.core_s);
        self.number(format_args!("{place}.edges_s"), &p::FORMATION_EDGES_S, formation.edges_s);
        self.number(format_args!("{place}.threshold"), &p::FORMATION_THRESHOLD, formation.threshold);
    }

    fn path(&mut self, place: Arguments<'_>, path: &CameraPath) {
        self.number(format_args!("{place}.field_of_view_deg"), &p::FIELD_OF_VIEW_DEG, path.field_of_view_deg);
        for (i, key) in path.keys.iter().enumerate() {
            self.number(format_args!("{place}.keys[{i}].time_s"), &p::KEY_TIME_S, key.time_s);
            self.point(format_args!("{place}.keys[{i}].position"), &p::POSITION, key.position);
            self.number(format_args!("{place}.keys[{i}].heading_deg"), &p::HEADING_DEG, key.heading_deg);
            self.number(format_args!("{place}.keys[{i}].pitch_deg"), &p::PITCH_DEG, key.pitch_deg);
            self.number(format_args!("{place}.keys[{i}].roll_deg"), &p::ROLL_DEG, key.roll_deg);
        }
    }

    fn group_light(&mut self, place: Arguments<'_>, light: &GroupLight) {
        self.number(format_args!("{place}.c_min"), &p::C_MIN, light.c_min);
        self.number(format_args!("{place}.c_med"), &p::C_MED, light.c_med);
        self.number(format_args!("{place}.c_max"), &p::C_MAX, light.c_max);
        match light.center {
            GroupCenter::Mean => {}
            GroupCenter::Pulled(share) => self.number(format_args!("{place}.center.pulled"), &p::PULL, share),
            GroupCenter::At(point) => self.point(format_args!("{place}.center.at"), &p::POSITION, point),
        }
    }

    fn model(&mut self, place: Arguments<'_>, model: &CloudModel) {
        match model.cull_radius {
            CullRadius::SpriteFraction(share) => {
                self.number(format_args!("{place}.cull_radius.sprite_fraction"), &p::CULL_FRACTION, share);
            }
            CullRadius::CloudHeightFraction(share) => {
                self.number(format_args!("{place}.cull_radius.cloud_height_fraction"), &p::CULL_FRACTION, share);
            }
            CullRadius::Metres(metres) => {
                self.number(format_args!("{place}.cull_radius.metres"), &p::CULL_METRES, metres);
            }
        }
        for (i, level) in model.color_levels.iter().enumerate() {
            self.number(format_args!("{place}.color_levels[{i}].height"), &p::LEVEL_HEIGHT, level.height);
            self.rgba(format_args!("{place}.color_levels[{i}].color"), level.color);
        }
        for (i, group) in model.groups.iter().enumerate() {
            self.group_light(format_args!("{place}.groups[{i}].light"), &group.light);
        }
        for (i, cloud_box) in model.boxes.iter().enumerate() {
            let place = format_args!("{place}.boxes[{i}]");
            self.point(format_args!("{place}.center"), &p::POSITION, cloud_box.center);
            self.point(format_args!("{place}.size"), &p::BOX_SIZE, cloud_box.size);
            if (cloud_box.orientation.length() - 1.0).abs() > 1e-6 || !cloud_box.orientation.is_finite() {
                let [x, y, z, w] = cloud_box.orientation.to_array();
                self.problems.push(Problem::error(
                    format!("{place}.orientation"),
                    format!("[{x}, {y}, {z}, {w}] is no rotation"),
                    "a unit quaternion x, y, z, w; [0, 0, 0, 1] for none",
                ));
            }
            self.number(format_args!("{place}.sprite_count"), &p::SPRITE_COUNT, cloud_box.sprite_count.into());
            for end in 0..2 {
                self.number(format_args!("{place}.width[{end}]"), &p::SPRITE_SIZE, cloud_box.width[end]);
                self.number(format_args!("{place}.height[{end}]"), &p::SPRITE_SIZE, cloud_box.height[end]);
                self.number(format_args!("{place}.rotation_deg[{end}]"), &p::ROTATION_DEG, cloud_box.rotation_deg[end]);
            }
            for (axis, count) in cloud_box.lumps.into_iter().enumerate() {
                self.number(format_args!("{place}.lumps[{axis}]"), &p::LUMPS, count.into());
            }
            self.group_light(format_args!("{place}.light"), &cloud_box.light);
            for (j, edit) in cloud_box.sprite_edits.iter().enumerate() {
                if let Some(moved) = edit.moved {
                    self.point(format_args!("{place}.sprite_edits[{j}].moved"), &p::SPRITE_PLACE, moved);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, scene_with_flight};
    use super::*;

    #[test]
    fn refuses() {
        type Break = fn(&mut Scene);
        let cases: [(Break, &str); 12] = [
            (|s| s.time_of_day_h = 24.0, "time_of_day_h"),
            (|s| s.clouds[0].position.y = f64::INFINITY, "clouds[0].position.y"),
            (|s| s.models[0].boxes[0].width[1] = -1.0, "models[0].boxes[0].width[1]"),
            (|s| s.models[0].boxes[0].orientation *= 2.0, "models[0].boxes[0].orientation"),
            (|s| s.models[0].color_levels[2].color.rgb.g = f32::NAN, "models[0].color_levels[2].color.g"),
            (|s| s.models[0].boxes[0].sprite_count = 1_000_000_000, "models[0].boxes[0].sprite_count"),
            (|s| s.sky.inside_density = -0.1, "sky.inside_density"),
            (
                |s| s.clouds[0].formation = Some(Formation { threshold: 0.0, ..Formation::default() }),
                "clouds[0].formation.threshold",
            ),
            (
                |s| s.clouds[0].formation = Some(Formation { core_s: f64::NAN, ..Formation::default() }),
                "clouds[0].formation.core_s",
            ),
            (|s| s.paths[0].keys[1].position.z = 1e9, "paths[0].keys[1].position.z"),
            (|s| s.paths[0].keys[1].time_s = 1e5, "paths[0].keys[1].time_s"),
            (|s| s.aircraft[0].scale = 0.0, "aircraft[0].scale"),
        ];
        for (break_it, place) in cases {
            let mut scene = scene_with_flight();
            break_it(&mut scene);
            assert_found(&scene, place, "");
        }
    }
}
