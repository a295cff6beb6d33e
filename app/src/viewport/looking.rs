//! From where the viewport looks: put there by commands, carried by a path or a camera, or left to the hand.

use super::Viewport;
use super::bounds;
use super::navigation::Navigation;
use super::on_board::{OnBoard, PathView};
use super::parallel;
use super::side::Side;
use super::through::{self, Through};
use crate::command::Command;
use crate::state::{Reading, Selection, Session};
use cloudwright_core::camera::View;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::scene::{Camera, PathId};
use egui::Rect;

impl Viewport {
    /// Sees what the scene's first camera does, or all of it.
    pub(crate) fn see(&mut self, session: &Session) {
        self.sides.clear();
        match session.scene().cameras.first() {
            Some(camera) => self.stand_at(camera, session),
            None => self.frame(&Selection::default(), session, 0.0),
        }
    }

    /// Looks through a camera of the scene, where it is now, and goes with it from then on.
    pub(crate) fn look_through(&mut self, camera: &Camera, session: &Session) {
        self.stand_at(camera, session);
        self.through = Some(Through::new(camera));
    }

    /// Sees what `camera` sees; turns about the nearest cloud before it.
    pub(crate) fn stand_at(&mut self, camera: &Camera, session: &Session) {
        let view = View::new(camera, 1, 1);
        let depth = session.derived().clouds().iter().map(|cloud| {
            let center = (cloud.origin - view.eye).as_vec3() + cloud.center;
            f64::from(view.depth(center))
        });
        let nearest = depth.filter(|depth| *depth > 1.0).reduce(f64::min);
        self.leave();
        self.canvas.begin_anew();
        self.navigation = Navigation::new(camera.clone(), nearest.unwrap_or(2000.0));
    }

    /// Brings a selection, as it is at `clock_s`, into view; all clouds for nothing.
    pub(crate) fn frame(&mut self, selection: &Selection, session: &Session, clock_s: f64) {
        if let Some((center, radius)) = bounds::bounds(selection, session, clock_s) {
            self.leave();
            self.canvas.begin_anew();
            self.navigation.frame(center, radius);
            for side in &mut self.sides {
                side.navigation.frame(center, radius);
            }
        }
    }

    /// Looks from the side that a command means at what is looked at: the selection, or what is in the picture's middle.
    pub(crate) fn look_from(&mut self, command: Command, selection: &Selection, session: &Session, clock_s: f64) {
        let Some(side) = Side::of(command) else { return };
        self.leave();
        self.canvas.begin_anew();
        let (view, pivot) = (View::new(self.camera(), 1, 1), self.navigation.pivot());
        if let Some((center, radius)) = bounds::looked_at(selection, session, clock_s, &view, pivot) {
            self.navigation.turn_about(center, radius);
        }
        self.navigation.look_from(side);
    }

    /// Whether rays run side by side.
    pub(crate) fn is_orthographic(&self) -> bool {
        self.navigation.is_orthographic()
    }

    /// From an orthographic view to one with an eye, and back.
    pub(crate) fn toggle_orthographic(&mut self) {
        self.leave();
        self.canvas.begin_anew();
        self.navigation.set_orthographic(!self.is_orthographic());
    }

    /// The view goes along a path from now on, at the clock's time.
    pub(crate) fn board(&mut self, path: PathId) {
        if self.on_board.as_ref().is_some_and(|on_board| on_board.path == path) {
            return;
        }
        let before = self.on_board.take().map_or_else(|| self.navigation.clone(), |on_board| on_board.before);
        self.leave();
        self.on_board = Some(OnBoard::new(path, before));
    }

    /// Whether the view goes along a path.
    pub(crate) fn is_on_board(&self) -> bool {
        self.on_board.is_some()
    }

    /// Ends a flight of any kind where it is, and the look through a camera.
    pub(crate) fn leave(&mut self) {
        self.fly_control.stop();
        self.on_board = None;
        self.through = None;
    }

    /// Ends the flight along a path; the view is the one from before.
    pub(crate) fn get_off(&mut self) {
        if let Some(on_board) = self.on_board.take() {
            self.canvas.begin_anew();
            self.navigation = on_board.before;
        }
    }

    /// The eye that a picture of the view is taken from, and what can't be seen from it: an orthographic view's is far.
    pub(crate) fn picture_eye(&self) -> (Camera, Hidden) {
        let mut hidden = Hidden::default();
        if !self.is_orthographic() {
            return (self.camera().clone(), hidden);
        }
        let eye = self.navigation.eye();
        parallel::hide(&eye, &mut hidden);
        (eye, hidden)
    }

    /// The camera that sees the picture in `rect`.
    pub(super) fn eye(&self, rect: Rect, reading: &Reading<'_>) -> Camera {
        match self.through {
            Some(_) => through::eye(self.camera(), rect, reading.picture_size),
            None => self.navigation.eye(),
        }
    }

    /// Puts the view where the camera is that it looks through, unless it was moved since, or the pointer has the camera.
    pub(super) fn go_with_camera(&mut self, reading: &Reading<'_>) {
        let through = self.through.take().filter(|through| *self.navigation.camera() == through.last);
        let now = through.as_ref().and_then(|through| through.now(reading));
        self.through = through.zip(now).map(|(through, now)| {
            if self.grab.is_on() {
                return through;
            }
            self.navigation = Navigation::new(now.clone(), self.navigation.distance());
            Through::new(&now)
        });
    }

    /// Puts the view where the clock says, while it is on board.
    pub(super) fn take_path_view(&mut self, reading: &Reading<'_>) -> Option<PathView> {
        let path_view = self.on_board.as_mut().and_then(|on_board| on_board.path_view(reading));
        match &path_view {
            Some(path_view) => self.navigation = Navigation::new(path_view.camera.clone(), self.navigation.distance()),
            None => self.on_board = None,
        }
        path_view
    }

    /// A hand that has moved the view since ends the flight here.
    pub(super) fn keep_path_view(&mut self, path_view: Option<PathView>) -> Option<PathView> {
        let path_view = path_view?;
        if *self.navigation.camera() == path_view.camera {
            return Some(path_view);
        }
        self.on_board = None;
        None
    }
}
