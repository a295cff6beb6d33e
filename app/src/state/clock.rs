//! The scene's clock in seconds: by it clouds form and dissipate, aircraft go their way, and a path is flown.
//!
//! It runs in the view alone, as the time of day does: nothing can be undone or is unsaved. It runs from 0 to the chosen
//! path's end; without a path that can be flown, until the last cloud has formed or gone and the last key is passed. An
//! in and an out mark have it play between them.

use super::selection::Item;
use super::time_play::MAX_STEP_S;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::property::Number;
use cloudwright_core::scene::{CameraPath, InScene, PathId, Scene};

/// Without a path the clock runs for so long at least, seconds.
const LEAST_S: f64 = 60.0;

/// How many of the clock's seconds pass in one of the artist's.
pub(crate) const CLOCK_SPEED: Number = Number {
    label: "Speed of play",
    unit: "×",
    min: 0.1,
    max: 10.0,
    doc: "Seconds of the scene's clock in a second of yours.",
};

/// Where the clock is, and how it goes on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    time_s: f64,
    plays: bool,
    loops: bool,
    /// In and out: it plays from the one to the other.
    marks: Option<[f64; 2]>,
    /// A hand has put it somewhere and may go on to.
    is_sought: bool,
    speed: f64,
    /// The view is to go along the path.
    boards: bool,
    /// The view went on board, and has not been seen to leave.
    on_board: bool,
    path: Option<PathId>,
}

/// What is asked of the clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ClockChange {
    /// To that time, seconds.
    Seek(f64),
    /// How many of its seconds pass in one of the artist's.
    Speed(f64),
    /// It plays between those times, or all through.
    Marks(Option<[f64; 2]>),
}

impl Default for Clock {
    fn default() -> Self {
        Self {
            time_s: 0.0,
            plays: false,
            loops: false,
            marks: None,
            is_sought: false,
            speed: 1.0,
            boards: true,
            on_board: false,
            path: None,
        }
    }
}

impl Clock {
    /// Seconds since its start.
    pub(crate) fn time_s(&self) -> f64 {
        self.time_s
    }

    /// Whether it runs.
    pub(crate) fn plays(&self) -> bool {
        self.plays
    }

    /// Whether it changes from picture to picture: it runs, or a hand drags it.
    pub(crate) fn moves(&self) -> bool {
        self.plays || self.is_sought
    }

    /// Whether it begins anew at its end.
    pub(crate) fn loops(&self) -> bool {
        self.loops
    }

    /// Whether the view is to go along the path.
    pub(crate) fn boards(&self) -> bool {
        self.boards
    }

    /// Of its seconds, in one of the artist's.
    pub(crate) fn speed(&self) -> f64 {
        self.speed
    }

    /// The path that was chosen last; the scene's first if none was.
    pub(crate) fn path<'s>(&self, scene: &'s Scene) -> Option<&'s CameraPath> {
        self.path.and_then(|id| scene.path(id)).or(scene.paths.first())
    }

    /// That path, if it leads anywhere.
    pub(crate) fn path_to_fly<'s>(&self, scene: &'s Scene) -> Option<&'s CameraPath> {
        self.path(scene).filter(|path| PathCurve::new(path).duration_s() > 0.0)
    }

    /// Where it ends, seconds.
    pub(crate) fn length_s(&self, scene: &Scene) -> f64 {
        match self.path_to_fly(scene) {
            Some(path) => PathCurve::new(path).duration_s(),
            None => {
                let formed = scene.clouds.iter().filter_map(|cloud| Some(cloud.formation.as_ref()?.end_s()));
                let keyed = scene.tracks.iter().filter_map(|track| Some(track.keys.last()?.time_s));
                formed.chain(keyed).fold(LEAST_S, f64::max)
            }
        }
    }

    /// The selection says which path is chosen: it, or the one that it hangs on.
    pub(crate) fn choose(&mut self, primary: Option<Item>, scene: &Scene) {
        let chosen = match primary {
            Some(Item::Path(id)) => Some(id),
            Some(item) => match item.listed(scene).and_then(InScene::hangs_on) {
                Some((_, Item::Path(id))) => Some(id),
                _ => None,
            },
            None => None,
        };
        self.path = chosen.or(self.path);
    }

    /// Goes on for `seconds` of the artist's; a stall counts as one step.
    pub(crate) fn advance(&mut self, seconds: f64, length_s: f64) {
        let to_s = self.time_s + seconds.clamp(0.0, MAX_STEP_S) * self.speed;
        if !self.plays || to_s.is_nan() || to_s <= self.time_s {
            return;
        }
        let [start_s, end_s] = self.played_s(length_s);
        if to_s < end_s {
            self.time_s = to_s;
        } else if self.loops && end_s > start_s {
            self.time_s = start_s + (to_s - start_s).rem_euclid(end_s - start_s);
        } else {
            self.time_s = end_s;
            self.plays = false;
        }
    }

    /// From where to where it plays, seconds.
    pub(crate) fn played_s(&self, length_s: f64) -> [f64; 2] {
        let [start_s, end_s] = self.marks.unwrap_or([0.0, length_s]).map(|mark| mark.min(length_s).max(0.0));
        if start_s < end_s { [start_s, end_s] } else { [0.0, length_s] }
    }

    /// The in and the out mark.
    pub(crate) fn marks(&self) -> Option<[f64; 2]> {
        self.marks
    }

    /// Other marks, in either order, or none.
    pub(crate) fn set_marks(&mut self, marks: Option<[f64; 2]>) {
        let sound = marks.filter(|marks| marks.iter().all(|mark| mark.is_finite()));
        self.marks = sound.map(|[a, b]| [a.min(b).max(0.0), a.max(b).max(0.0)]);
    }

    /// Begins to run; from the start if it is at its end.
    pub(crate) fn play(&mut self, length_s: f64) {
        let [start_s, end_s] = self.played_s(length_s);
        if self.time_s >= end_s {
            self.time_s = start_s;
        }
        self.plays = true;
    }

    pub(crate) fn pause(&mut self) {
        self.plays = false;
    }

    /// Put somewhere by hand, which may go on with it.
    pub(crate) fn seek(&mut self, time_s: f64, length_s: f64) {
        if !time_s.is_nan() {
            self.time_s = time_s.clamp(0.0, length_s.max(0.0));
            self.is_sought = true;
        }
    }

    /// The hand has let it go.
    pub(crate) fn let_go(&mut self) {
        self.is_sought = false;
    }

    /// The scene may have changed: not beyond its end.
    pub(crate) fn stay_within(&mut self, length_s: f64) {
        self.time_s = self.time_s.min(length_s);
    }

    pub(crate) fn toggle_loop(&mut self) {
        self.loops ^= true;
    }

    pub(crate) fn toggle_boards(&mut self) {
        self.boards ^= true;
    }

    pub(crate) fn set_speed(&mut self, speed: f64) {
        if CLOCK_SPEED.allows(speed) {
            self.speed = speed;
        }
    }

    /// The view goes on board, or was seen to leave.
    pub(crate) fn set_on_board(&mut self, on_board: bool) {
        self.on_board = on_board;
    }

    /// Whether the view was last known to be on board.
    pub(crate) fn on_board(&self) -> bool {
        self.on_board
    }

    /// For another scene. How it is played stays.
    pub(crate) fn begin_anew(&mut self) {
        *self = Self { loops: self.loops, speed: self.speed, boards: self.boards, ..Self::default() };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::starter::starter_scene;
    use cloudwright_core::scene::{Formation, KeyValue, Track, TrackId, TrackKey};

    #[test]
    fn runs_to_its_end_or_round_and_never_jumps() {
        let mut clock = Clock::default();
        clock.advance(0.1, 10.0);
        assert_eq!(clock.time_s(), 0.0, "it stands");
        clock.play(10.0);
        clock.set_speed(2.0);
        clock.advance(0.1, 10.0);
        assert!((clock.time_s() - 0.2).abs() < 1e-12);
        clock.advance(3600.0, 10.0);
        assert!((clock.time_s() - 0.7).abs() < 1e-12, "a stall counts as one step");
        for bad in [f64::NAN, -1.0] {
            clock.advance(bad, 10.0);
            clock.set_speed(bad);
            clock.seek(f64::NAN, 10.0);
        }
        assert!((clock.time_s() - 0.7).abs() < 1e-12 && clock.speed() == 2.0);
        clock.seek(99.0, 10.0);
        assert_eq!(clock.time_s(), 10.0);
        clock.advance(0.1, 10.0);
        assert!(!clock.plays() && clock.time_s() == 10.0, "its end");
        clock.toggle_loop();
        clock.play(10.0);
        clock.seek(9.9, 10.0);
        clock.advance(0.1, 10.0);
        assert!(clock.plays() && (clock.time_s() - 0.1).abs() < 1e-9, "round");
        clock.advance(0.1, 0.0);
        assert!(clock.time_s() == 0.0 && !clock.plays(), "nothing to run through");
    }

    #[test]
    fn it_plays_between_its_marks() {
        let mut clock = Clock::default();
        clock.set_marks(Some([4.0, 2.0]));
        clock.seek(9.0, 10.0);
        clock.play(10.0);
        assert_eq!(clock.time_s(), 2.0, "from the in mark");
        clock.seek(3.9, 10.0);
        clock.advance(0.2, 10.0);
        assert!(!clock.plays() && clock.time_s() == 4.0);
        clock.toggle_loop();
        clock.seek(3.9, 10.0);
        clock.play(10.0);
        clock.advance(0.2, 10.0);
        assert!(clock.plays() && (clock.time_s() - 2.1).abs() < 1e-9);
        clock.set_marks(Some([f64::NAN, 2.0]));
        assert_eq!(clock.marks(), None);
        clock.set_marks(Some([20.0, 30.0]));
        assert_eq!(clock.played_s(10.0), [0.0, 10.0], "beyond the end they mean nothing");
    }

    #[test]
    fn without_a_path_it_lasts_until_all_have_formed() {
        let mut scene = starter_scene();
        scene.paths.clear();
        let clock = Clock::default();
        assert_eq!(clock.length_s(&scene), 60.0);
        let formation =
            Formation { start_s: 100.0, core_s: 20.0, edges_s: 30.0, threshold: 0.5, ..Formation::default() };
        scene.clouds[0].formation = Some(formation);
        assert_eq!(clock.length_s(&scene), 140.0, "half the core, then the edges");
        scene.clouds[0].formation = Some(Formation { edges_s: 5.0, ..formation });
        assert_eq!(clock.length_s(&scene), 120.0, "the core");
        let keys = vec![TrackKey::new(150.0, KeyValue::One(0.0))];
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, "sky/exposure_ev", keys));
        assert_eq!(clock.length_s(&scene), 150.0, "the last key");
    }
}
