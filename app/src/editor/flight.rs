//! The clock from frame to frame, and who is on board.
//!
//! While the view is on board, the viewport takes its camera and what it has seen from the path at the clock's time. A
//! hand that moves the view ends that where it is; Esc gives the view from before back. Either stops the clock.

use super::Editor;
use crate::state::{ClockChange, Item, Selection};
use cloudwright_core::scene::{Camera, PathId, PathKey};

impl Editor {
    /// A frame's worth of the clock; the next frame is asked for only while it runs.
    pub(super) fn run_clock(&mut self, context: &egui::Context) {
        let scene = self.session.scene();
        self.clock.choose(self.view.selection.primary(), scene);
        let length_s = self.clock.length_s(scene);
        self.clock.stay_within(length_s);
        if self.clock.on_board() && !self.viewport.is_on_board() {
            self.clock.set_on_board(false);
            self.clock.pause();
        }
        if !context.input(|input| input.pointer.any_down()) {
            self.clock.let_go();
        }
        if self.escape_is_for_the_clock(context) {
            self.clock.pause();
            self.viewport.get_off();
        }
        if self.clock.plays() {
            self.clock.advance(context.input(|input| f64::from(input.stable_dt)), length_s);
            context.request_repaint();
        }
    }

    /// Esc takes the nearest thing back: a dialog, a text, a gesture and a flight by hand come before.
    fn escape_is_for_the_clock(&self, context: &egui::Context) -> bool {
        let taken = self.is_asking() || self.gesture_dropped || self.viewport.has_keys() || context.text_edit_focused();
        let runs = self.clock.plays() || self.viewport.is_on_board();
        runs && !taken && context.input(|input| input.key_pressed(egui::Key::Escape))
    }

    /// Starts the clock where it is, or stops it there.
    pub(super) fn toggle_flight(&mut self) {
        if self.clock.plays() {
            return self.clock.pause();
        }
        if let Some(path) = self.clock.path(self.session.scene()).filter(|_| self.clock.boards())
            && self.clock.path_to_fly(self.session.scene()).is_none()
        {
            let text = format!("“{}” leads nowhere yet: move the view, and give it another key", path.name);
            return self.tell_error(text);
        }
        self.stop_recording();
        let length_s = self.clock.length_s(self.session.scene());
        self.clock.play(length_s);
        self.board();
    }

    /// Puts the clock somewhere; the view goes there too.
    pub(super) fn seek(&mut self, time_s: f64) {
        let length_s = self.clock.length_s(self.session.scene());
        self.clock.seek(time_s, length_s);
        if self.recording.is_none() {
            self.board();
        }
    }

    pub(super) fn change_clock(&mut self, change: ClockChange) {
        match change {
            ClockChange::Seek(time_s) => self.seek(time_s),
            ClockChange::Speed(speed) => self.clock.set_speed(speed),
            ClockChange::Marks(marks) => self.clock.set_marks(marks),
        }
    }

    /// Whether the view goes along; one that does comes back.
    pub(super) fn toggle_boarding(&mut self) {
        self.clock.toggle_boards();
        if !self.clock.boards() {
            self.clock.set_on_board(false);
            self.viewport.get_off();
        } else if self.clock.plays() {
            self.board();
        }
    }

    fn board(&mut self) {
        if let Some(path) = self.clock.path_to_fly(self.session.scene()).filter(|_| self.clock.boards()) {
            self.viewport.board(path.id);
            self.clock.set_on_board(true);
        }
    }

    /// Sees what a key sees, at its time.
    pub(super) fn go_to_key(&mut self, id: PathId, index: usize) {
        let Some(path) = self.session.scene().path(id) else { return };
        let (Some(first), Some(key)) = (path.keys.first(), path.keys.get(index)) else { return };
        let PathKey { position, heading_deg, pitch_deg, roll_deg, time_s } = *key;
        let field_of_view_deg = path.field_of_view_deg;
        let camera = Camera { heading_deg, pitch_deg, roll_deg, field_of_view_deg, ..Camera::free(position) };
        let since_start_s = time_s - first.time_s;
        self.select(Selection::of([Item::Path(id)]));
        self.view.path_key = Some((id, index));
        self.clock.choose(self.view.selection.primary(), self.session.scene());
        self.clock.pause();
        let length_s = self.clock.length_s(self.session.scene());
        self.clock.seek(since_start_s, length_s);
        self.viewport.stand_at(&camera, &self.session);
    }
}
