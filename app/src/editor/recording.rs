//! A path of what is flown by hand.
//!
//! Every frame in which the view moves is a sample; while it rests, no time passes. What was flown becomes a new path of
//! a few keys, as one step ([`keys_from_samples`]).

use super::Editor;
use crate::command::Command;
use crate::state::{Item, MAX_STEP_S, Selection};
use cloudwright_core::arrange::Names;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::flight::keys_from_samples;
use cloudwright_core::scene::{Camera, CameraPath, PathId, PathKey};

/// The path misses what was flown by no more, metres and degrees: a sprite is tens of metres wide.
const TOLERANCE_M: f64 = 1.0;
const TOLERANCE_DEG: f64 = 0.5;
/// A view that is put elsewhere goes there so fast, metres a second: as fast as one flies by hand.
const FASTEST_M_S: f64 = 4000.0;
/// No more than what is flown in an hour at 60 frames a second.
const MOST_SAMPLES: usize = 216_000;

/// What was flown so far.
#[derive(Debug)]
pub(super) struct Recording {
    samples: Vec<PathKey>,
    field_of_view_deg: f64,
}

impl Recording {
    fn new(camera: &Camera) -> Self {
        Self { samples: vec![key_of(camera, 0.0)], field_of_view_deg: camera.field_of_view_deg }
    }

    /// A frame later, in which the view may have moved.
    fn follow(&mut self, camera: &Camera, dt_s: f64) {
        let Some(last) = self.samples.last().filter(|_| self.samples.len() < MOST_SAMPLES) else { return };
        let here = key_of(camera, last.time_s);
        if here == *last {
            return;
        }
        let least_s = (last.position.distance(here.position) / FASTEST_M_S).max(0.004);
        let time_s = last.time_s + dt_s.clamp(0.0, MAX_STEP_S).max(least_s);
        self.samples.push(PathKey { time_s, ..here });
    }
}

/// The view as a key at that time, seconds; to the millimetre and a ten-thousandth of a degree, so that files stay short.
pub(super) fn key_of(camera: &Camera, time_s: f64) -> PathKey {
    let short = |number: f64, parts: f64| (number * parts).round() / parts + 0.0;
    PathKey {
        time_s,
        position: (camera.position * 1e3).round() / 1e3,
        heading_deg: short(camera.heading_deg, 1e4),
        pitch_deg: short(camera.pitch_deg, 1e4),
        roll_deg: short(camera.roll_deg, 1e4),
    }
}

impl Editor {
    /// Begins to record, or makes a path of what was recorded.
    pub(super) fn toggle_recording(&mut self) {
        if self.recording.is_some() {
            return self.stop_recording();
        }
        self.clock.pause();
        self.viewport.leave();
        self.recording = Some(Recording::new(self.viewport.camera()));
        self.tell("Recording: fly with the right button held; the time in which the view rests is left out");
    }

    /// A new path of what was recorded, if anything was.
    pub(super) fn stop_recording(&mut self) {
        let Some(Recording { samples, field_of_view_deg }) = self.recording.take() else { return };
        let mut keys = keys_from_samples(&samples, TOLERANCE_M, TOLERANCE_DEG);
        if keys.len() < 2 {
            return self.tell("Nothing was flown, so there is no new path");
        }
        for key in &mut keys {
            key.time_s = (key.time_s * 1e3).round() / 1e3;
        }
        let count = keys.len();
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let name = Names::new(scene.paths.iter().map(|path| path.name.as_str())).free("recorded");
        let said = format!("“{name}” was recorded, with {count} keys");
        let path = CameraPath { field_of_view_deg, ..CameraPath::new(PathId::new(&mut counter), &name, keys) };
        let id = path.id;
        let edits = vec![Edit::NextId(counter), Edit::Path(ListEdit::Insert { at: usize::MAX, value: path })];
        self.edit_and_select(Command::RecordFlight, edits, Selection::of([Item::Path(id)]));
        self.tell(said);
    }

    /// A frame of the recording, after the view was moved by hand.
    pub(super) fn record(&mut self, context: &egui::Context) {
        if let Some(recording) = &mut self.recording {
            recording.follow(self.viewport.camera(), context.input(|input| f64::from(input.stable_dt)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn no_time_passes_while_the_view_rests_and_jumps_take_their_time() {
        let at = |x: f64| Camera::free(DVec3::X * x);
        let mut recording = Recording::new(&at(0.0));
        for (x, dt_s) in [(0.0, 5.0), (10.0, 0.1), (10.0, 99.0), (20.0, 60.0), (8020.0, 0.1), (8021.0, f64::NAN)] {
            recording.follow(&at(x), dt_s);
        }
        let flown: Vec<_> = recording.samples.iter().map(|key| (key.position.x, key.time_s)).collect();
        let wanted = [(0.0, 0.0), (10.0, 0.1), (20.0, 0.35), (8020.0, 2.35), (8021.0, 2.354)];
        assert_eq!(flown.len(), wanted.len());
        for ((x, time), (wanted_x, wanted_time)) in flown.into_iter().zip(wanted) {
            assert!(x == wanted_x && (time - wanted_time).abs() < 1e-9, "{x} at {time} s");
        }
    }
}
