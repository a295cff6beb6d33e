//! What can be measured of the scene as it is now: how much of the sky clouds cover, how far a cloud reaches.

use super::convert::{count, list, number, of_vector, vector};
use super::placed::Placed;
use super::{Answer, Shared, Usage};
use crate::error::{Said, did_you_mean};
use cloudwright_core::derived::Derived;
use cloudwright_core::measure::{Observer, sky_cover};
use cloudwright_core::scene::{CloudId, Scene, Thing};
use cloudwright_core::sprites::PlacedCloud;
use cloudwright_core::weather::Moment;
use glam::DVec3;
use rhai::{Array, Dynamic, Engine, Map};
use std::collections::BTreeSet;
use std::rc::Rc;
use std::time::Duration;

pub(super) const USAGE: &[Usage] = &[
    (
        "coverage_oktas",
        "coverage_oktas(), or coverage_oktas(#{ clouds: ids, base_m: [0, 2000], from: [0, 0, 0], \
         least_elevation_deg: 8, at_s: 0 })",
        "Eighths of the sky that clouds cover, 0 to 8, as an observer on the ground sees it, from 10° or another \
         elevation up: of all clouds, of some, or of those whose bases lie in a band of heights.",
    ),
    ("bounds", "bounds(cloud)", "The lowest corner and the highest of the box that a cloud's sprites fill."),
];

/// Whose coverage, from where.
struct Looked {
    clouds: Option<BTreeSet<CloudId>>,
    base_m: [f64; 2],
    from: Option<DVec3>,
    least_elevation_deg: f64,
    at_s: f64,
}

impl Looked {
    fn read(fields: &Map, scene: &Scene) -> Result<Self, Said> {
        const NAMES: [&str; 5] = ["clouds", "base_m", "from", "least_elevation_deg", "at_s"];
        if let Some(name) = fields.keys().find(|name| !NAMES.contains(&name.as_str())) {
            return Err(Said::script(format!("coverage_oktas: there is no `{name}`"), did_you_mean(name, NAMES)));
        }
        let cloud = |id: &Dynamic| {
            let id = CloudId(count("a cloud", id)?);
            match Thing::Cloud(id).is_in(scene) {
                true => Ok(id),
                false => Err(Said::script(format!("cloud/{id}: the scene has none"), "clouds() lists them")),
            }
        };
        let clouds = fields.get("clouds").map(|ids| list("clouds", ids)?.iter().map(cloud).collect());
        let base_m = match fields.get("base_m") {
            None => [f64::NEG_INFINITY, f64::INFINITY],
            Some(band) => match list("base_m", band)?.as_slice() {
                [low, high] => [number("base_m", low)?, number("base_m", high)?],
                _ => return Err(Said::script("base_m is no band", "[lowest, highest], metres")),
            },
        };
        let elevation = fields
            .get("least_elevation_deg")
            .map_or(Ok(Observer::LEAST_ELEVATION_DEG), |given| number("an elevation", given))?;
        if !(0.0..90.0).contains(&elevation) {
            return Err(Said::script(format!("least_elevation_deg is {elevation}"), "0 to less than 90 above level"));
        }
        Ok(Self {
            clouds: clouds.transpose()?,
            base_m,
            from: fields.get("from").map(|from| vector("from", from).map(DVec3::from)).transpose()?,
            least_elevation_deg: elevation,
            at_s: fields.get("at_s").map_or(Ok(0.0), |given| number("at_s", given))?,
        })
    }

    fn is_meant(&self, cloud: &PlacedCloud) -> bool {
        let [low, high] = self.base_m;
        (low..=high).contains(&cloud.cloud.position.y) && self.clouds.as_ref().is_none_or(|ids| ids.contains(&cloud.id))
    }

    fn oktas(&self, scene: &Scene, derived: &Derived) -> f64 {
        let observer =
            Observer { from: self.from, least_elevation_deg: self.least_elevation_deg, moment: Moment::at(self.at_s) };
        8.0 * sky_cover(scene, derived, &observer, |cloud| self.is_meant(cloud)).covered
    }
}

fn oktas(recorder: &Shared, placed: &Placed, fields: &Map) -> Result<f64, Said> {
    recorder.borrow_mut().settle()?;
    let recorder = recorder.borrow();
    let scene = recorder.scene();
    let looked = Looked::read(fields, scene)?;
    let oktas = placed.tell(&recorder, |derived| Ok(looked.oktas(scene, derived)))?;
    placed.look(Duration::ZERO)?;
    Ok(oktas)
}

fn bounds(recorder: &Shared, placed: &Placed, cloud: &Dynamic) -> Result<Array, Said> {
    let id = CloudId(count("the cloud", cloud)?);
    let recorder = recorder.borrow();
    recorder.need(Thing::Cloud(id))?;
    placed.tell(&recorder, |derived| {
        let cloud = derived.cloud(id).filter(|cloud| !cloud.sprites.is_empty());
        let cloud =
            cloud.ok_or_else(|| Said::script(format!("cloud/{id} has no sprites"), "its model has no boxes"))?;
        let corners = cloud.sprites.iter().map(|sprite| {
            let half = DVec3::new(sprite.width.into(), sprite.height.into(), sprite.width.into()) * 0.5;
            let middle = cloud.origin + sprite.position.as_dvec3();
            [middle - half, middle + half]
        });
        let whole = corners.reduce(|[low, high], [a, b]| [low.min(a), high.max(b)]).unwrap_or_default();
        Ok(whole.map(|corner| of_vector(corner.to_array())).to_vec())
    })
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared, placed: &Rc<Placed>) {
    let with = || (Rc::clone(recorder), Rc::clone(placed));
    let (own, all) = with();
    engine.register_fn("coverage_oktas", move || -> Answer<f64> { Ok(oktas(&own, &all, &Map::new())?) });
    let (own, some) = with();
    engine.register_fn("coverage_oktas", move |fields: Map| -> Answer<f64> { Ok(oktas(&own, &some, &fields)?) });
    let (own, placed) = with();
    engine.register_fn("bounds", move |cloud: Dynamic| -> Answer<Array> { Ok(bounds(&own, &placed, &cloud)?) });
}
