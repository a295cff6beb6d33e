//! Short messages at the picture's lower right, where they cover no field: what was done, and why something was not.
//!
//! Questions and menus are before them. They are ordinary labels, so that a screen reader finds them, and wrap. What was done goes by itself; what was not
//! stays until it is closed, or until something succeeds.

use crate::theme::{self, icon};
use crate::visible;
use egui::{Align2, Area, Context, Frame, Id, Order, Rect, RichText, ScrollArea, vec2};
use std::collections::VecDeque;

/// How long a message about something done stays, seconds.
const STAY_S: f64 = 5.0;
/// Older ones go when there are more.
const MOST: usize = 4;
/// So many are kept for a report.
const MOST_KEPT: usize = 50;

/// The messages on the screen, oldest first.
#[derive(Debug, Default)]
pub(super) struct Toasts {
    shown: Vec<Toast>,
    next: u64,
    /// What was said, also what is no longer shown.
    said: VecDeque<String>,
}

#[derive(Debug)]
struct Toast {
    number: u64,
    text: String,
    is_error: bool,
    /// When it goes, on egui's clock; set when it is first shown.
    ends_s: Option<f64>,
}

impl Toasts {
    /// Says something; the same words twice stand once.
    pub(super) fn say(&mut self, text: &str, is_error: bool) {
        let text = visible::lines(text);
        self.shown.retain(|toast| toast.text != text);
        self.said.push_back(if is_error { format!("trouble: {text}") } else { text.clone() });
        self.said.drain(..self.said.len().saturating_sub(MOST_KEPT));
        self.next += 1;
        self.shown.push(Toast { number: self.next, text, is_error, ends_s: None });
        let too_many = self.shown.len().saturating_sub(MOST);
        self.shown.drain(..too_many);
    }

    /// The last messages, oldest first.
    pub(super) fn said(&self) -> impl Iterator<Item = &str> {
        self.said.iter().map(String::as_str)
    }

    /// Takes complaints away: something else went well since.
    pub(super) fn forget_errors(&mut self) {
        self.shown.retain(|toast| !toast.is_error);
    }

    /// Shows all; asks for another frame when the next one goes.
    pub(super) fn show(&mut self, context: &Context, picture: Rect) {
        let now_s = context.input(|input| input.time);
        for toast in self.shown.iter_mut().filter(|toast| !toast.is_error) {
            toast.ends_s.get_or_insert(now_s + STAY_S);
        }
        self.shown.retain(|toast| toast.ends_s.is_none_or(|end| end > now_s));
        if let Some(next) = self.shown.iter().filter_map(|toast| toast.ends_s).reduce(f64::min) {
            context.request_repaint_after(std::time::Duration::from_secs_f64(next - now_s));
        }
        if self.shown.is_empty() {
            return;
        }
        let mut closed = None;
        let width = theme::TOAST_WIDTH.min(picture.width() - 4.0 * theme::TOAST_MARGIN).max(theme::LEAST_TOAST_WIDTH);
        Area::new(Id::unique("toasts"))
            .order(Order::Middle)
            .pivot(Align2::RIGHT_BOTTOM)
            .fixed_pos(picture.right_bottom() - vec2(theme::TOAST_MARGIN, theme::TOAST_MARGIN + theme::HUD_HEIGHT))
            .constrain_to(picture)
            .show(context, |ui| {
                let height = picture.height() - 2.0 * theme::HUD_HEIGHT;
                ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                    for toast in &self.shown {
                        Frame::popup(ui.style()).show(ui, |ui| {
                            ui.set_width(width);
                            ui.horizontal_top(|ui| {
                                let (glyph, color) = if toast.is_error {
                                    (icon::WARNING_CIRCLE, theme::error(ui))
                                } else {
                                    (icon::CHECK_CIRCLE, theme::good(ui))
                                };
                                ui.label(RichText::new(glyph).color(color).size(16.0));
                                ui.vertical(|ui| {
                                    ui.set_width(width - 56.0);
                                    ui.add(egui::Label::new(&toast.text).wrap());
                                });
                                let close = ui.add(egui::Button::new(icon::X).frame(false));
                                ui.ctx().accesskit_node_builder(close.id, |node| node.set_label("Dismiss"));
                                if close.clicked() {
                                    closed = Some(toast.number);
                                }
                            });
                        });
                    }
                });
            });
        self.shown.retain(|toast| Some(toast.number) != closed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_words_stand_once_and_old_ones_go() {
        let mut toasts = Toasts::default();
        for text in ["a", "b", "a", "c", "d", "e"] {
            toasts.say(text, text == "e");
        }
        let texts: Vec<&str> = toasts.shown.iter().map(|toast| toast.text.as_str()).collect();
        assert_eq!(texts, ["a", "c", "d", "e"]);
        toasts.forget_errors();
        assert_eq!(toasts.shown.len(), 3);
    }
}
