//! The scene at a time: what its tracks make of it.
//!
//! On the edit clock each track becomes a [`Curve`]; on the camera clock those are set into a copy of the scene, by the
//! property table, as a hand would set them. The copy shares what no track moves. So whatever reads a scene reads this
//! one, and a property that can be keyed needs no more than its row.

use super::sums::Sums;
use super::{Curve, Wind, WindTracks};
use crate::property::{Change, Described, Owner, Target, change};
use crate::scene::{
    Camera, Cloud, CloudId, CloudModel, ColorLevels, List, ModelId, Scene, Thing, Track, TrackKey, Weather,
};
use glam::DVec2;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// The tracks of a scene, ready to be asked for any time.
#[derive(Debug, Clone, Default)]
pub struct Timeline {
    /// Of one owner behind one another.
    moves: Vec<Move>,
    /// Which of them are each cloud's.
    of_clouds: FxHashMap<CloudId, Range<usize>>,
    /// Models whose looks have tracks, and which those are.
    of_looks: FxHashMap<ModelId, (Arc<CloudModel>, Vec<usize>)>,
    /// Which are of the scene's own values, and of what else shows without a cloud.
    of_others: Vec<usize>,
    /// The air as the scene has it.
    weather: Weather,
    wind: Option<Wind>,
    /// The ways of clouds whose share of the wind is keyed.
    ways: FxHashMap<CloudId, Sums<2>>,
}

/// A track whose property there is.
#[derive(Debug, Clone)]
struct Move {
    target: Target,
    curve: Arc<Curve>,
}

impl Timeline {
    /// Of `scene`. Tracks of what is not there or can't be keyed, and those whose keys the checks refuse, move nothing; of
    /// two of one property the first does.
    pub fn new(scene: &Scene) -> Self {
        let moving = |track: &Track| {
            let target: Target = track.property.parse().ok()?;
            is_sound(track, &target).then(|| Move { target, curve: Arc::new(Curve::of(track, &target)) })
        };
        let mut moves: Vec<Move> = scene.tracks.iter().filter_map(moving).collect();
        moves.sort_by_key(|each| each.target.owner);
        let mut only: Vec<Move> = Vec::with_capacity(moves.len());
        for each in moves {
            let of_owner = only.iter().rev().take_while(|other| other.target.owner == each.target.owner);
            if of_owner.into_iter().all(|other| !other.target.property.is_the_same(each.target.property)) {
                only.push(each);
            }
        }
        let mut timeline = Self { moves: only, weather: scene.weather, ..Self::default() };
        timeline.sort_out(scene);
        timeline.blow();
        timeline
    }

    /// Which moves are whose.
    fn sort_out(&mut self, scene: &Scene) {
        for (at, each) in self.moves.iter().enumerate() {
            match each.target.owner {
                Owner::Thing(Thing::Cloud(id)) => self.of_clouds.entry(id).or_insert(at..at).end = at + 1,
                Owner::Level(model, _) | Owner::Thing(Thing::Group(model, _) | Thing::Box(model, _)) => {
                    let Some(rest) = scene.models.position(model).map(|at| &scene.models.as_slice()[at]) else {
                        continue;
                    };
                    self.of_looks.entry(model).or_insert_with(|| (Arc::clone(rest), Vec::new())).1.push(at);
                }
                _ => self.of_others.push(at),
            }
        }
    }

    fn blow(&mut self) {
        let weather = &self.weather;
        let or_constant = |path: &str, value: f64| {
            self.curve(Owner::Weather, path).cloned().unwrap_or_else(|| Arc::new(Curve::constant(value)))
        };
        let tracks = WindTracks {
            from_deg: or_constant("wind_from_deg", weather.wind_from_deg),
            speed_mps: or_constant("wind_speed_mps", weather.wind_speed_mps),
            shear: or_constant("wind_shear", weather.wind_shear),
        };
        self.wind = Wind::new(tracks, weather.lag_s);
        if let Some(wind) = &self.wind {
            let shared = |id: &CloudId| {
                let share = self.curve(Owner::Thing(Thing::Cloud(*id)), "wind_share")?;
                Some((*id, wind.shared(share)))
            };
            self.ways = self.of_clouds.keys().filter_map(shared).collect();
        }
    }

    /// The air as the scene has it, without tracks.
    pub fn weather(&self) -> &Weather {
        &self.weather
    }

    /// The wind, if there ever is any.
    pub fn wind(&self) -> Option<&Wind> {
        self.wind.as_ref()
    }

    /// The air's numbers at `clock_s`.
    pub fn weather_at(&self, clock_s: f64) -> Weather {
        let mut now = self.weather;
        let of_air = |at: &&usize| self.moves[**at].target.owner == Owner::Weather;
        for at in self.of_others.iter().filter(of_air) {
            Set { moves: &self.moves[*at..=*at], clock_s }.thing(&mut now);
        }
        now
    }

    /// What `cloud` is at `clock_s`; none if it has no track.
    pub fn cloud_at(&self, cloud: &Cloud, clock_s: f64) -> Option<Cloud> {
        let moves = &self.moves[self.of_clouds.get(&cloud.id)?.clone()];
        let mut now = cloud.clone();
        Set { moves, clock_s }.thing(&mut now);
        Some(now)
    }

    /// `camera` at `clock_s`.
    pub fn camera_at(&self, camera: &Camera, clock_s: f64) -> Camera {
        let mut now = camera.clone();
        for at in &self.of_others {
            if self.moves[*at].target.owner == Owner::Thing(Thing::Camera(camera.id)) {
                Set { moves: &self.moves[*at..=*at], clock_s }.thing(&mut now);
            }
        }
        now
    }

    /// How far the wind has carried a cloud whose share of it is keyed, metres east and south.
    pub fn way_m(&self, cloud: CloudId, clock_s: f64) -> Option<DVec2> {
        self.ways.get(&cloud).map(|way| DVec2::from_array(way.at(clock_s)))
    }

    /// Whether any model's colours or light have a track.
    pub fn moves_looks(&self) -> bool {
        !self.of_looks.is_empty()
    }

    /// The model of that id with the colours and light that it has at `clock_s`; none if they have no track.
    pub fn model_at(&self, model: ModelId, clock_s: f64) -> Option<CloudModel> {
        let (rest, moves) = self.of_looks.get(&model)?;
        let mut now = CloudModel::clone(rest);
        for at in moves {
            let mut set = Set { moves: &self.moves[*at..=*at], clock_s };
            match self.moves[*at].target.owner {
                Owner::Level(_, i) => now.color_levels.get_mut(i).map(|level| set.thing(level)),
                Owner::Thing(Thing::Group(_, id)) => now.groups.with_id_mut(id).map(|group| set.thing(group)),
                Owner::Thing(Thing::Box(_, id)) => now.boxes.with_id_mut(id).map(|each| set.thing(each)),
                _ => None,
            };
        }
        lift_levels(&mut now.color_levels);
        Some(now)
    }

    /// `scene`, whose timeline this is, at `clock_s`; without its clouds and their models, if anything else moves: what
    /// those are now is [`super::CloudNow`]'s, and thousands of them are not copied for each frame.
    pub fn surroundings_at<'s>(&self, scene: &'s Scene, clock_s: f64) -> Cow<'s, Scene> {
        if self.of_others.is_empty() {
            return Cow::Borrowed(scene);
        }
        let mut now = Scene {
            name: scene.name.clone(),
            next_id: scene.next_id,
            time_of_day_h: scene.time_of_day_h,
            site: scene.site.clone(),
            sun: scene.sun,
            sky: scene.sky.clone(),
            weather: scene.weather,
            ground: scene.ground.clone(),
            atlas: scene.atlas.clone(),
            cameras: scene.cameras.clone(),
            models: List::new(),
            folders: List::new(),
            clouds: List::new(),
            paths: scene.paths.clone(),
            aircraft: scene.aircraft.clone(),
            props: scene.props.clone(),
            tracks: List::new(),
        };
        for at in &self.of_others {
            let moves = &self.moves[*at..=*at];
            change(&mut now, moves[0].target.owner, &mut Set { moves, clock_s });
        }
        Cow::Owned(now)
    }

    /// Local civil hours at `clock_s`: as keyed, or as the scene's hour runs.
    pub fn time_of_day_h(&self, scene: &Scene, clock_s: f64) -> f64 {
        match self.curve(Owner::Scene, "time_of_day_h") {
            Some(curve) => curve.at(clock_s, 0).rem_euclid(24.0),
            None if self.weather.day_speed == 0.0 => scene.time_of_day_h,
            None => {
                let hour = (scene.time_of_day_h + clock_s * self.weather.day_speed / 3600.0).rem_euclid(24.0);
                // Beyond all time there is no hour.
                if hour.is_finite() { hour } else { scene.time_of_day_h }
            }
        }
    }

    /// Whether the clock moves anything.
    pub fn moves(&self) -> bool {
        let Weather { turbulence, day_speed, .. } = self.weather;
        !self.moves.is_empty() || self.wind.is_some() || turbulence != 0.0 || day_speed != 0.0
    }

    /// The curve of what is at that address, if it is keyed.
    pub fn curve(&self, owner: Owner, path: &str) -> Option<&Arc<Curve>> {
        let from = self.moves.partition_point(|each| each.target.owner < owner);
        let of_owner = self.moves[from..].iter().take_while(|each| each.target.owner == owner);
        of_owner.into_iter().find(|each| each.target.property.path == path).map(|each| &each.curve)
    }

    /// `scene`, whose timeline this is, at `clock_s`, seconds of its clock.
    pub fn scene_at<'s>(&self, scene: &'s Scene, clock_s: f64) -> Cow<'s, Scene> {
        if self.moves.is_empty() {
            return Cow::Borrowed(scene);
        }
        let mut now = scene.clone();
        for of_owner in self.moves.chunk_by(|a, b| a.target.owner == b.target.owner) {
            change(&mut now, of_owner[0].target.owner, &mut Set { moves: of_owner, clock_s });
        }
        let models = self.moves.iter().filter_map(|each| match each.target.owner {
            Owner::Level(model, _) => Some(model),
            _ => None,
        });
        let mut before = None;
        for model in models.filter(|model| before.replace(*model) != Some(*model)) {
            if let Some(model) = now.models.with_id_mut(model) {
                lift_levels(&mut model.color_levels);
            }
        }
        Cow::Owned(now)
    }
}

/// Sets what the tracks of one owner say.
struct Set<'a> {
    moves: &'a [Move],
    clock_s: f64,
}

impl Change for Set<'_> {
    fn thing<T: Described>(&mut self, thing: &mut T) {
        for Move { target, curve } in self.moves {
            // Not by the row's own place in memory: there may be a copy of the table for each that reads it.
            let Some(row) = T::rows().find(|row| row.property.is_the_same(target.property)) else { continue };
            let numbers = curve.all_at(self.clock_s);
            for (part, number) in numbers.into_iter().take(target.parts()).enumerate() {
                row.set_number(thing, part, target.bring_within(number));
            }
        }
    }
}

/// Whether the keys of `track` are numbers in order of time, as many each as `target` has.
fn is_sound(track: &Track, target: &Target) -> bool {
    let is_number = |key: &TrackKey| {
        let parts = key.value.parts();
        key.time_s.is_finite() && parts.len() == target.parts() && parts.iter().all(|part| part.is_finite())
    };
    let in_order = track.keys.windows(2).all(|pair| pair[0].time_s < pair[1].time_s);
    !track.keys.is_empty() && in_order && track.keys.iter().all(is_number)
}

/// Levels that tracks have put past one another are lifted to the one below.
fn lift_levels(levels: &mut ColorLevels) {
    for i in 1..levels.len() {
        levels[i].height = levels[i].height.max(levels[i - 1].height);
    }
}
