//! Four views at once: beside the free one, orthographic ones from the top, the front and the right, each with all tools.
//!
//! Each of the three is a viewport of its own that can't be turned or flown. Commands that turn the view mean the free one,
//! a grab that which the pointer is in, and framing all four.

use super::Viewport;
use super::side::Side;
use crate::state::{Action, Reading};
use egui::{Context, Rect, Ui, UiBuilder, Vec2, pos2};

/// Upper left, lower left, lower right; the free one is the fourth.
const SIDES: [Side; 3] = [Side::Top, Side::South, Side::East];
/// Between two views, points.
const GAP: f32 = 2.0;
/// A viewport that is less high and wide has one view, points.
const LEAST_ROOM: Vec2 = Vec2::new(400.0, 300.0);

impl Viewport {
    /// Shows the view, or all four.
    pub(crate) fn show(&mut self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let rect = ui.available_rect_before_wrap();
        if !reading.view.quad || rect.width() < LEAST_ROOM.x || rect.height() < LEAST_ROOM.y {
            self.sides.clear();
            return self.show_one(ui, reading, actions);
        }
        if self.sides.is_empty() {
            self.sides = SIDES.into_iter().map(|side| self.pinned_to(side, ui.ctx())).collect();
        }
        let [upper_left, free, lower_left, lower_right] = quarters(rect);
        ui.allocate_rect(rect, egui::Sense::hover());
        ui.painter().rect_filled(rect, 0.0, ui.visuals().window_stroke.color);
        let mut sides = std::mem::take(&mut self.sides);
        {
            let places = [upper_left, lower_left, lower_right];
            let mut views: Vec<(&mut Self, Rect)> = sides.iter_mut().zip(places).collect();
            views.insert(0, (&mut *self, free));
            // Who is in the middle of something has the keys first; then who has the pointer.
            views.sort_by_key(|(view, _)| (!(view.own_gesture() || view.own_keys()), !view.has_pointer));
            for (view, place) in views {
                // Whose turn it is, its widgets keep their names.
                let builder = UiBuilder::new().scope_id(ui.scope_id().with(view.label())).max_rect(place);
                ui.scope_builder(builder, |ui| view.show_one(ui, reading, actions));
            }
        }
        self.sides = sides;
    }

    /// One that looks from a side at what this one looks at.
    fn pinned_to(&self, side: Side, context: &Context) -> Self {
        let mut view = Self::blank(context, self.renderer, self.device.clone());
        view.navigation = self.navigation.clone();
        view.navigation.set_orthographic(true);
        view.navigation.pin_to(side);
        view
    }

    /// For people, and for who listens.
    pub(super) fn label(&self) -> String {
        self.navigation.pinned().map_or_else(|| "Viewport".into(), |side| format!("Viewport {}", side.words()))
    }
}

/// Upper left, upper right, lower left, lower right.
fn quarters(rect: Rect) -> [Rect; 4] {
    let (middle, half) = (rect.center().round(), 0.5 * GAP);
    let left_of = |min: f32| Rect::from_min_max(pos2(rect.left(), min), pos2(middle.x - half, min));
    let right_of = |min: f32| Rect::from_min_max(pos2(middle.x + half, min), pos2(rect.right(), min));
    let rows = [(rect.top(), middle.y - half), (middle.y + half, rect.bottom())];
    let of_row =
        |(top, bottom): (f32, f32)| [left_of(top), right_of(top)].map(|at| Rect { max: pos2(at.max.x, bottom), ..at });
    let [[a, b], [c, d]] = rows.map(of_row);
    [a, b, c, d]
}
