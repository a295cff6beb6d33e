//! From where a scene is looked at when it is thinned: its cameras, along its paths, and around its clouds, each alone.
//!
//! Each view is drawn again for each try and its first picture kept, so there are not as many as a scene likes. Of many
//! cameras and moments on paths, some evenly between the first and the last look. Of many clouds, one of each model
//! comes before a second one of any, and the models of which most sprites are drawn come first: there is most to drop.
//! A model that no view is around keeps its sprites, as nobody would see what it loses.

use crate::flight::PathCurve;
use crate::scene::{Camera, CloudId, ModelId, Scene};
use crate::sight::Sight;
use crate::sprites::PlacedCloud;
use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;

/// Around each cloud.
const AROUND: u32 = 8;
/// Clouds at most that are looked at from around: 1,200 views, some 160 MB of pictures.
pub(super) const MOST_CLOUDS: usize = 150;
/// Views at most from cameras and along paths.
const MOST_OF_ALL: usize = 200;
/// Along each path, evenly in time from its first key to its last.
const ALONG: u32 = 8;
/// A cloud seen from around fills this share of the picture's height.
const FILLED: f64 = 0.9;
/// Width and height of the pictures that are compared.
const SIZE: [u32; 2] = [240, 135];
/// Metres that an eye stays above the ground.
const ABOVE_GROUND_M: f64 = 2.0;

/// A place to look from.
#[derive(Debug, Clone)]
pub(super) struct Vantage {
    /// For messages.
    pub(super) name: String,
    pub(super) sight: Sight,
    /// Around a cloud, its index: others would stand before it, or around the eye.
    pub(super) alone: Option<usize>,
    /// How many sprites may be drawn.
    pub(super) sprites: usize,
}

/// All from where it is looked.
pub(super) struct Vantages {
    pub(super) list: Vec<Vantage>,
    /// Whose sprites may be dropped: some view is around a cloud of theirs.
    pub(super) models: FxHashSet<ModelId>,
}

impl Vantages {
    /// Of `scene`, which `clouds` are of; `models` are theirs.
    pub(super) fn new(scene: &Scene, clouds: &[PlacedCloud], models: &FxHashMap<CloudId, ModelId>) -> Self {
        let mut list = of_all(scene, clouds.iter().map(|cloud| cloud.sprites.len()).sum());
        let chosen = chosen(clouds, models);
        for &index in &chosen {
            let cloud = &clouds[index];
            list.extend((0..AROUND).map(|i| {
                let heading_deg = f64::from(i) * 360.0 / f64::from(AROUND);
                let name = format!("cloud {} looking {heading_deg}°", cloud.name);
                let sight = Sight::still(&camera_around(scene, cloud, heading_deg), SIZE);
                Vantage { name, sight, alone: Some(index), sprites: cloud.sprites.len() }
            }));
        }
        Self { list, models: chosen.iter().map(|&index| models[&clouds[index].id]).collect() }
    }
}

/// From the scene's cameras and along its paths.
fn of_all(scene: &Scene, sprites: usize) -> Vec<Vantage> {
    let cameras = scene.cameras.iter().map(|camera| (format!("camera {}", camera.name), camera.clone()));
    let paths = scene.paths.iter().filter(|path| !path.keys.is_empty()).flat_map(|path| {
        let curve = PathCurve::new(path);
        (0..ALONG).map(move |i| {
            let t_s = curve.duration_s() * f64::from(i) / f64::from(ALONG - 1);
            (format!("path {} at {t_s:.1} s", path.name), curve.camera_at(t_s))
        })
    });
    let all: Vec<_> = cameras.chain(paths).collect();
    let chosen: FxHashSet<usize> = evenly(all.len(), MOST_OF_ALL).collect();
    let chosen = all.into_iter().enumerate().filter(|(index, _)| chosen.contains(index));
    let vantage = |(name, camera)| Vantage { name, sight: Sight::still(&camera, SIZE), alone: None, sprites };
    chosen.map(|(_, named)| vantage(named)).collect()
}

/// The clouds that are looked at from around, by index: all that show anything, or as many as may be.
fn chosen(clouds: &[PlacedCloud], models: &FxHashMap<CloudId, ModelId>) -> Vec<usize> {
    let mut of_model: FxHashMap<ModelId, Vec<usize>> = FxHashMap::default();
    for (index, cloud) in clouds.iter().enumerate().filter(|(_, cloud)| !cloud.sprites.is_empty()) {
        of_model.entry(models[&cloud.id]).or_default().push(index);
    }
    let mut of_model: Vec<Vec<usize>> = of_model.into_values().collect();
    let drawn = |of_model: &[usize]| of_model.iter().map(|&index| clouds[index].sprites.len()).sum::<usize>();
    of_model.sort_by_cached_key(|of_model| (Reverse(drawn(of_model)), of_model[0]));
    let rounds = (1..=MOST_CLOUDS)
        .take_while(|&most| of_model.iter().map(|of| of.len().min(most)).sum::<usize>() <= MOST_CLOUDS);
    let each = rounds.last().unwrap_or(0);
    let mut left = MOST_CLOUDS - of_model.iter().map(|of| of.len().min(each)).sum::<usize>();
    let mut chosen: Vec<usize> = Vec::new();
    for of_model in &of_model {
        let one_more = usize::from(left > 0 && of_model.len() > each);
        left -= one_more;
        chosen.extend(evenly(of_model.len(), each + one_more).map(|at| of_model[at]));
    }
    chosen.sort_unstable();
    chosen
}

/// `most` of so many in a row, the first and the last included where two fit; all if they are no more.
fn evenly(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let chosen = count.min(most);
    (0..chosen).map(move |i| if chosen > 1 { i * (count - 1) / (chosen - 1) } else { 0 })
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
    use crate::scene::{Cloud, CloudModel};

    fn of(scene: &Scene) -> (Derived, Vantages) {
        let derived = Derived::new(scene);
        let models = scene.clouds.iter().map(|cloud| (cloud.id, cloud.model)).collect();
        let vantages = Vantages::new(scene, derived.clouds(), &models);
        (derived, vantages)
    }

    #[test]
    fn every_cloud_is_in_the_middle_of_its_eight_views_and_fits() {
        let scene = Preset::ALL[0].scene();
        let (derived, Vantages { list, .. }) = of(&scene);
        let cloud = &derived.clouds()[0];
        assert_eq!(list.len(), scene.cameras.len() + 8 * derived.clouds().len());
        for Vantage { name, sight, .. } in list.iter().filter(|vantage| vantage.alone.is_some()) {
            let view = View::new(&sight.camera, 200, 200);
            let center = (cloud.origin - view.eye).as_vec3() + cloud.center;
            let at = view.project(center).expect("before the eye");
            assert!((at - glam::Vec2::splat(100.0)).length() < 0.5, "{name}: {at}");
            // The sphere's rim stands at the tangent's angle.
            let rim = center.length() * (cloud.reach / center.length()).asin().tan() / center.length();
            assert!(rim < view.tan_half_height && rim > 0.8 * view.tan_half_height, "{name}: {rim}");
        }
    }

    /// So many clouds of each of three models, of which the later ones have more sprites a cloud.
    fn crowd(counts: [usize; 3]) -> Scene {
        let mut scene = Preset::ALL[0].scene();
        let (model, cloud) = (scene.models[0].clone(), scene.clouds[0].clone());
        scene.models.clear();
        scene.clouds.clear();
        for (kind, count) in (1..).zip(counts) {
            let mut model = CloudModel { id: ModelId::new(&mut scene.next_id), ..model.clone() };
            model.boxes.truncate(1);
            model.boxes[0].sprite_count = 5 * kind;
            for _ in 0..count {
                let id = CloudId::new(&mut scene.next_id);
                scene.clouds.push(Cloud { id, model: model.id, ..cloud.clone() });
            }
            scene.models.push(model);
        }
        scene
    }

    #[test]
    fn of_many_clouds_each_model_has_its_share() {
        for (counts, want) in [
            ([50, 60, 40], [50, 60, 40]),
            ([1, 1, 1000], [1, 1, 148]),
            ([1000, 0, 1000], [75, 0, 75]),
            // What doesn't divide goes to the model with the most sprites.
            ([500, 700, 900], [50, 50, 50]),
            ([2, 700, 900], [2, 74, 74]),
            ([3, 700, 900], [3, 73, 74]),
        ] {
            let scene = crowd(counts);
            let (derived, Vantages { list, models }) = of(&scene);
            let around: Vec<usize> = list.iter().filter_map(|vantage| vantage.alone).collect();
            let of_model = |model: &CloudModel| {
                let is_its = |at: &&usize| {
                    scene.clouds[**at].model == model.id && derived.clouds()[**at].id == scene.clouds[**at].id
                };
                around.iter().filter(is_its).count() / AROUND as usize
            };
            assert_eq!(scene.models.iter().map(of_model).collect::<Vec<_>>(), want, "{counts:?}");
            assert_eq!(models.len(), want.iter().filter(|count| **count > 0).count());
        }
    }

    #[test]
    fn of_many_models_those_with_most_sprites_are_looked_at() {
        let mut scene = crowd([MOST_CLOUDS, 1, 1]);
        for at in 0..MOST_CLOUDS {
            let own = CloudModel { id: ModelId::new(&mut scene.next_id), ..scene.models[0].clone() };
            scene.clouds[at].model = own.id;
            scene.models.push(own);
        }
        let (_, Vantages { list, models }) = of(&scene);
        assert_eq!((list.len(), models.len()), (scene.cameras.len() + 1200, MOST_CLOUDS));
        assert!([1, 2].iter().all(|&large| models.contains(&scene.models[large].id)));
    }

    #[test]
    fn of_many_cameras_some_look() {
        let mut scene = crowd([1, 0, 0]);
        let camera = scene.cameras[0].clone();
        scene.cameras.extend((0..999).map(|i| Camera { name: i.to_string(), ..camera.clone() }));
        let (_, Vantages { list, .. }) = of(&scene);
        assert_eq!(list.len(), MOST_OF_ALL + 8);
        assert_eq!(
            [&list[0], &list[MOST_OF_ALL - 1]].map(|each| &each.name[..]),
            [&format!("camera {}", camera.name), "camera 998"]
        );
    }
}
