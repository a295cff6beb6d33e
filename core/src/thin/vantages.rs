//! From where a scene is looked at when it is thinned: its cameras, along its paths, and around each of its clouds, that
//! one alone.

use crate::draw_list::Hidden;
use crate::flight::PathCurve;
use crate::scene::{Camera, Scene};
use crate::sight::Sight;
use crate::sprites::PlacedCloud;
use glam::DVec3;

/// Width and height of the pictures that are compared.
const SIZE: [u32; 2] = [240, 135];
/// Around each cloud.
const AROUND: u32 = 8;
/// Along each path, evenly in time from its first key to its last.
const ALONG: u32 = 8;
/// A cloud seen from around fills this share of the picture's height.
const FILLED: f64 = 0.9;
/// Metres that an eye stays above the ground.
const ABOVE_GROUND_M: f64 = 2.0;

/// A place to look from.
#[derive(Debug, Clone)]
pub(super) struct Vantage {
    /// For messages.
    pub(super) name: String,
    /// Around a cloud, all others are left out: they would stand before it, or around the eye.
    pub(super) sight: Sight,
}

/// All of `scene`'s, which `clouds` are of.
pub(super) fn vantages(scene: &Scene, clouds: &[PlacedCloud]) -> Vec<Vantage> {
    let of_all = |name, camera: &Camera| Vantage { name, sight: Sight::still(camera, SIZE) };
    let cameras = scene.cameras.iter().map(|camera| of_all(format!("camera {}", camera.name), camera));
    let paths = scene.paths.iter().filter(|path| !path.keys.is_empty()).flat_map(|path| {
        let curve = PathCurve::new(path);
        (0..ALONG).map(move |i| {
            let t_s = curve.duration_s() * f64::from(i) / f64::from(ALONG - 1);
            of_all(format!("path {} at {t_s:.1} s", path.name), &curve.camera_at(t_s))
        })
    });
    let around = clouds.iter().filter(|cloud| !cloud.sprites.is_empty()).flat_map(|cloud| {
        let others = clouds.iter().map(|other| other.id).filter(|other| *other != cloud.id);
        let hidden = Hidden { clouds: others.collect(), ..Hidden::default() };
        (0..AROUND).map(move |i| {
            let heading_deg = f64::from(i) * 360.0 / f64::from(AROUND);
            let sight =
                Sight { hidden: hidden.clone(), ..Sight::still(&camera_around(scene, cloud, heading_deg), SIZE) };
            Vantage { name: format!("cloud {} looking {heading_deg}°", cloud.name), sight }
        })
    });
    cameras.chain(paths).chain(around).collect()
}

/// A level camera that looks at the middle of `cloud` from without.
fn camera_around(scene: &Scene, cloud: &PlacedCloud, heading_deg: f64) -> Camera {
    let center = cloud.origin + cloud.center.as_dvec3();
    let mut camera = Camera { heading_deg, ..Camera::free(center) };
    let half_height = libm::sin((camera.field_of_view_deg * 0.5 * FILLED).to_radians());
    let away_m = f64::from(cloud.reach) / half_height;
    let heading = heading_deg.to_radians();
    camera.position -= DVec3::new(libm::sin(heading), 0.0, -libm::cos(heading)) * away_m;
    let lowest = scene.ground.as_ref().map_or(f64::NEG_INFINITY, |ground| ground.altitude_m + ABOVE_GROUND_M);
    if camera.position.y < lowest {
        camera.pitch_deg = libm::atan2(center.y - lowest, away_m).to_degrees();
        camera.position.y = lowest;
    }
    camera
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::View;
    use crate::derived::Derived;
    use crate::preset::Preset;

    #[test]
    fn every_cloud_is_in_the_middle_of_its_eight_views_and_fits() {
        let scene = Preset::ALL[0].scene();
        let derived = Derived::new(&scene);
        let cloud = &derived.clouds()[0];
        let vantages = vantages(&scene, derived.clouds());
        assert_eq!(vantages.len(), scene.cameras.len() + 8 * derived.clouds().len());
        for Vantage { name, sight } in vantages.iter().filter(|vantage| vantage.name.starts_with("cloud")) {
            let view = View::new(&sight.camera, 200, 200);
            let center = (cloud.origin - view.eye).as_vec3() + cloud.center;
            let at = view.project(center).expect("before the eye");
            assert!((at - glam::Vec2::splat(100.0)).length() < 0.5, "{name}: {at}");
            // The sphere's rim stands at the tangent's angle.
            let rim = center.length() * (cloud.reach / center.length()).asin().tan() / center.length();
            assert!(rim < view.tan_half_height && rim > 0.8 * view.tan_half_height, "{name}: {rim}");
        }
    }
}
