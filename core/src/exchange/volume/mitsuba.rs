//! A small scene that Mitsuba 3 renders as it is: the volumes of a moment with the sun, a sky of one colour and the camera.
//!
//! Clouds scatter all light, by Henyey and Greenstein's phase function, as droplets do. The sun is as bright as our
//! directional light on a white, matt face that looks at it; the sky has the mean of ours above the horizon. All of it is linear light times the scene's exposure; tone is the viewer's.

use super::Volume;
use crate::color::Rgb;
use crate::exchange::Leaving;
use crate::formats::xml::{self, Element, Node, Style};
use crate::sky::Dome;
use crate::weather::SceneNow;
use glam::DVec3;
use std::fmt::Display;

const STYLE: Style = Style { byte_order_mark: false, line_end: "\n", indent: "  ", closes: false, declares: false };
/// What can be given on Mitsuba's command line instead (-D spp=256): the picture's size, samples a pixel, and how much light
/// goes on nearly as it came. Of droplets that is 0.85, which takes many times the samples for nearly the same picture.
const DEFAULTS: [(&str, &str); 4] = [("width", "640"), ("height", "360"), ("spp", "64"), ("g", "0.4")];

/// The name of the scene beside a volume.
pub(super) fn name_of(volume: &str) -> String {
    format!("{}.xml", volume.rsplit_once('.').map_or(volume, |(stem, _)| stem))
}

/// The scene's file; positions count from `origin`, metres in the world.
pub(super) fn scene(leaving: &Leaving<'_>, now: &SceneNow<'_>, volumes: &[Volume], origin: DVec3) -> Vec<u8> {
    let mut root = Element::new("scene").with("version", "3.0.0");
    root.children.push(Node::Comment(format!(
        "{} at {} s: metres, y up, x east, z south. mitsuba -D spp=256 THIS_FILE",
        leaving.scene.name.replace("--", ""),
        leaving.moment.clock_s
    )));
    for (name, value) in DEFAULTS {
        root.push(Element::new("default").with("name", name).with("value", value));
    }
    // Light goes on for long in a cloud.
    root.push(plugin("integrator", "volpath", [value("integer", "max_depth", 400), value("integer", "rr_depth", 60)]));
    root.children.extend(camera(leaving, origin).map(Node::Element));
    let exposed = |color: Rgb| color * now.exposure;
    let direction = -now.light.direction;
    root.push(plugin(
        "emitter",
        "directional",
        [
            Element::new("vector").with("name", "direction").with("value", listed(direction.as_dvec3())),
            rgb("irradiance", exposed(now.light.directional_max) * std::f32::consts::PI),
        ],
    ));
    root.push(plugin("emitter", "constant", [rgb("radiance", exposed(mean_sky(now)))]));
    for volume in volumes {
        root.push(cloud(volume, origin));
    }
    xml::write(&root, STYLE)
}

/// Who looks; none if nobody does.
fn camera(leaving: &Leaving<'_>, origin: DVec3) -> Option<Element> {
    let view = leaving.view?;
    let eye = view.eye - origin;
    let look = Element::new("lookat")
        .with("origin", listed(eye))
        .with("target", listed(eye + view.forward.as_dvec3() * 1000.0))
        .with("up", listed(view.up.as_dvec3()));
    let mut to_world = Element::new("transform").with("name", "to_world");
    to_world.push(look);
    let fov_deg = 2.0 * libm::atan(f64::from(view.tan_half_height)).to_degrees();
    let film = plugin("film", "hdrfilm", [value("integer", "width", "$width"), value("integer", "height", "$height")]);
    let sampler = plugin("sampler", "independent", [value("integer", "sample_count", "$spp")]);
    let fov = [value("string", "fov_axis", "y"), value("float", "fov", fov_deg)];
    let far = [value("float", "near_clip", 1.0), value("float", "far_clip", 1e6)];
    Some(plugin("sensor", "perspective", fov.into_iter().chain(far).chain([to_world, film, sampler])))
}

/// A box without a surface, filled with a volume.
fn cloud(volume: &Volume, origin: DVec3) -> Element {
    let grid = &volume.grid;
    let half = grid.size.as_dvec3() * f64::from(grid.voxel_m) * 0.5;
    let middle = grid.corner - origin + half;
    let mut to_world = Element::new("transform").with("name", "to_world");
    // A cube is from −1 to 1.
    to_world.push(Element::new("scale").with("value", listed(half)));
    to_world.push(Element::new("translate").with("value", listed(middle)));
    let sigma = named(
        "sigma_t",
        plugin(
            "volume",
            "gridvolume",
            [value("string", "filename", &volume.name), value("boolean", "use_grid_bbox", true)],
        ),
    );
    let medium = plugin(
        "medium",
        "heterogeneous",
        [sigma, value("float", "albedo", 1.0), plugin("phase", "hg", [value("float", "g", "$g")])],
    );
    plugin("shape", "cube", [to_world, plugin("bsdf", "null", []), named("interior", medium)])
}

/// The mean of the sky above the horizon, without the sun's disc.
fn mean_sky(now: &SceneNow<'_>) -> Rgb {
    let albedo = now.ground.as_ref().map_or(Rgb::grey(0.1), |ground| ground.dark.mix(ground.bright, 0.5));
    let dome = Dome::new(now.light.sun_direction, now.turbidity, albedo, now.sky_gain, now.light.directional_max);
    dome.mean_above_horizon()
}

fn plugin(kind: &str, name: &str, inner: impl IntoIterator<Item = Element>) -> Element {
    let mut element = Element::new(kind).with("type", name);
    inner.into_iter().for_each(|child| element.push(child));
    element
}

fn named(name: &str, mut element: Element) -> Element {
    element.attributes.insert(0, ("name".into(), name.into()));
    element
}

fn value(kind: &str, name: &str, value: impl Display + Copy) -> Element {
    Element::new(kind).with("name", name).with("value", value.to_string())
}

fn rgb(name: &str, color: Rgb) -> Element {
    value("rgb", name, &color.to_array().map(|channel| channel.to_string()).join(" "))
}

fn listed(vector: DVec3) -> String {
    vector.to_array().map(|number| number.to_string()).join(" ")
}
