//! The scene's clock in seconds: by it clouds form and dissipate, aircraft go their way, and a path is flown.
//!
//! It runs in the view alone, as the time of day does: nothing can be undone or is unsaved. It runs from 0 to the chosen
//! path's end; without a path that can be flown, until the last cloud has formed or gone.

use super::selection::Item;
use super::time_play::MAX_STEP_S;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::property::Number;
use cloudwright_core::scene::{CameraPath, Formation, InScene, PathId, Scene};

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
}

impl Default for Clock {
    fn default() -> Self {
        Self {
            time_s: 0.0,
            plays: false,
            loops: false,
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
                scene.clouds.iter().filter_map(|cloud| Some(end_s(cloud.formation.as_ref()?))).fold(LEAST_S, f64::max)
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
        if to_s < length_s {
            self.time_s = to_s;
        } else if self.loops && length_s > 0.0 {
            self.time_s = to_s.rem_euclid(length_s);
        } else {
            self.time_s = length_s;
            self.plays = false;
        }
    }

    /// Begins to run; from the start if it is at its end.
    pub(crate) fn play(&mut self, length_s: f64) {
        if self.time_s >= length_s {
            self.time_s = 0.0;
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

/// When nothing of a change is left to come, seconds.
fn end_s(formation: &Formation) -> f64 {
    let Formation { start_s, core_s, edges_s, threshold, .. } = *formation;
    start_s + core_s.max(threshold * core_s + edges_s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::starter_scene;

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
    }
}
