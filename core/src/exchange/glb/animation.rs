//! What the clock moves, as one animation: camera paths, the way of drifting clouds, and how far clouds have formed.

use super::container::{Buffer, Use};
use super::sprites::Written;
use super::{Leaving, Nodes, lens, placed, push};
use crate::exchange::motion::{Course, Flight, Keys, Motion};
use crate::flight::PathCurve;
use glam::DVec3;
use serde_json::{Value, json};

/// The animation's lists.
struct Animation<'a> {
    buffer: &'a mut Buffer,
    channels: Vec<Value>,
    samplers: Vec<Value>,
}

/// Adds nodes for the paths, and the animation of them, of the `cameras` and of the clouds, whose courses are given in
/// their order.
pub(super) fn write(
    root: &mut Value,
    buffer: &mut Buffer,
    nodes: &mut Nodes,
    leaving: &Leaving<'_>,
    (motion, cameras): (&Motion<'_>, &[usize]),
    (clouds, courses): (&Written, &[Course]),
) {
    let mut animation = Animation { buffer, channels: Vec::new(), samplers: Vec::new() };
    for path in &leaving.scene.paths {
        let lens = lens(root, path.field_of_view_deg);
        let start = PathCurve::new(path).at(0.0);
        let mut node = placed(&path.name, start.position, start.turn());
        node["camera"] = json!(lens);
        let node = nodes.add_top(node);
        if let Some(flight) = Flight::of(path) {
            animation.fly(node, &flight);
        }
    }
    for (camera, node) in leaving.scene.cameras.iter().zip(cameras) {
        if let Some(flight) = motion.camera(camera) {
            animation.fly(*node, &flight);
        }
    }
    for (place, course) in clouds.nodes.iter().zip(courses) {
        if !course.places.is_empty() {
            animation.go(place.node, &course.places);
        }
        if let Some(material) = place.material {
            animation.form(material, &course.formed);
        }
    }
    if !animation.channels.is_empty() {
        let Animation { channels, samplers, .. } = animation;
        push(root, "animations", json!({ "name": "timeline", "channels": channels, "samplers": samplers }));
    }
}

impl Animation<'_> {
    fn fly(&mut self, node: usize, flight: &Flight) {
        self.go(node, &flight.places);
        let turn = |(time, turn): &(f64, glam::DQuat)| (*time, turn.as_quat().normalize().to_array());
        let turns: Vec<_> = flight.turns.iter().map(turn).collect();
        self.channel(&json!({ "node": node, "path": "rotation" }), &turns);
    }

    fn go(&mut self, node: usize, places: &Keys<DVec3>) {
        let places: Vec<_> = places.iter().map(|(time, place)| (*time, place.as_vec3().to_array())).collect();
        self.channel(&json!({ "node": node, "path": "translation" }), &places);
    }

    /// Moves the alpha of a cloud's own material.
    fn form(&mut self, material: usize, formed: &Keys<f64>) {
        let factors: Vec<_> = formed.iter().map(|(time, alpha)| (*time, [1.0, 1.0, 1.0, *alpha as f32])).collect();
        let pointer = format!("/materials/{material}/pbrMetallicRoughness/baseColorFactor");
        let target = json!({ "path": "pointer", "extensions": { "KHR_animation_pointer": { "pointer": pointer } } });
        self.channel(&target, &factors);
    }

    fn channel<const N: usize>(&mut self, target: &Value, keys: &[(f64, [f32; N])]) {
        let times: Vec<[f32; 1]> = keys.iter().map(|(time, _)| [*time as f32]).collect();
        let values: Vec<[f32; N]> = keys.iter().map(|(_, value)| *value).collect();
        let sampler = json!({
            "input": self.buffer.floats(&times, Use::Other, true),
            "output": self.buffer.floats(&values, Use::Other, false),
            "interpolation": "LINEAR",
        });
        self.samplers.push(sampler);
        self.channels.push(json!({ "sampler": self.samplers.len() - 1, "target": target }));
    }
}
