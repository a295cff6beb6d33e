//! A handle of one number: dragged, or moved by arrow keys and by screen readers.
//!
//! Where it lies and how it looks is its owner's; here is what a hand, a key or a reader wants of it. Tab reaches it,
//! arrows move it by a step, with Shift by ten.

use cloudwright_core::property::Number;
use egui::accesskit::{self, ActionData, Role};
use egui::{EventFilter, Id, Key, Modifiers, Rect, Response, Sense, Ui, Vec2};

/// Shift makes arrow keys so much coarser.
const COARSE: f64 = 10.0;

/// A handle that is there in this frame.
pub(crate) struct Handle<'a> {
    /// The same one in every frame.
    pub(crate) id: Id,
    /// Where it is taken.
    pub(crate) rect: Rect,
    /// What screen readers call it, and tests.
    pub(crate) name: &'a str,
    /// Range and meaning.
    pub(crate) number: &'a Number,
    /// Where it is now.
    pub(crate) value: f64,
    /// Of an arrow key.
    pub(crate) step: f64,
}

/// What was done with a handle.
pub(crate) struct Handled {
    /// Clicks and the like.
    pub(crate) response: Response,
    /// The value that is asked for, within no range yet.
    pub(crate) wanted: Option<f64>,
    /// Whether the button is still down.
    pub(crate) live: bool,
}

impl Handle<'_> {
    /// Takes it to the window. `dragged` is the value to which the pointer's way since the press leads from another one.
    pub(crate) fn show(self, ui: &Ui, dragged: impl FnOnce(f64, Vec2) -> f64) -> Handled {
        let response = ui.interact(self.rect, self.id, Sense::click_and_drag());
        self.describe(ui);
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        let at_start = self.id.with("value at the start of a drag");
        if response.drag_started() {
            ui.data_mut(|data| data.insert_temp(at_start, self.value));
        }
        let way = response.interact_pointer_pos().zip(ui.input(|input| input.pointer.press_origin()));
        let wanted = match way.filter(|_| response.dragged()) {
            Some((now, pressed)) => {
                let start = ui.data(|data| data.get_temp(at_start)).unwrap_or(self.value);
                Some(dragged(start, now - pressed))
            }
            None => self.by_reader(ui).or_else(|| self.by_keys(ui, &response)),
        };
        let live = ui.input(|input| input.pointer.any_down());
        Handled { response, wanted: wanted.filter(|value| value.is_finite()), live }
    }

    fn describe(&self, ui: &Ui) {
        ui.ctx().accesskit_node_builder(self.id, |node| {
            node.set_role(Role::Slider);
            node.set_label(self.name);
            node.set_description(self.number.doc);
            node.set_numeric_value(self.value);
            node.set_min_numeric_value(self.number.min);
            node.set_max_numeric_value(self.number.max);
            node.set_numeric_value_step(self.step);
            for action in [accesskit::Action::SetValue, accesskit::Action::Increment, accesskit::Action::Decrement] {
                node.add_action(action);
            }
        });
    }

    fn by_reader(&self, ui: &Ui) -> Option<f64> {
        ui.input(|input| {
            let set = input.accesskit_action_requests(self.id, accesskit::Action::SetValue).last();
            if let Some(Some(ActionData::NumericValue(value))) = set.map(|request| &request.data) {
                return Some(*value);
            }
            let count = |action| input.num_accesskit_action_requests(self.id, action) as f64;
            let steps = count(accesskit::Action::Increment) - count(accesskit::Action::Decrement);
            (steps != 0.0).then_some(self.value + steps * self.step)
        })
    }

    fn by_keys(&self, ui: &Ui, response: &Response) -> Option<f64> {
        if !response.has_focus() {
            return None;
        }
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(self.id, arrows));
        let steps = ui.input_mut(|input| {
            let coarse = if input.modifiers.shift { COARSE } else { 1.0 };
            let mut count = |key| input.count_and_consume_key(Modifiers::NONE, key) as f64;
            let up = count(Key::ArrowUp) + count(Key::ArrowRight);
            (up - count(Key::ArrowDown) - count(Key::ArrowLeft)) * coarse
        });
        (steps != 0.0).then_some(self.value + steps * self.step)
    }
}
