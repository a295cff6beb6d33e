//! A tour of seven steps round the window. It stands beside the work, which can be tried at each step, and is left at any time.

use super::Panel;
use crate::theme;
use egui::{Align2, Context, Id, Key, LayerId, Order, Pos2, Rect, StrokeKind, Window};

/// A step: where it is about, and what is said.
pub(crate) struct Step {
    /// The panel that it is about.
    pub(crate) panel: Panel,
    title: &'static str,
    text: &'static str,
}

/// All of them.
pub(crate) const STEPS: [Step; 7] = [
    Step {
        panel: Panel::Viewport,
        title: "The picture",
        text: "Drag with the middle button, or with Alt and the left one, to turn the view; the wheel goes nearer. Hold the right \
               button and press W, S, A, D to fly. Click a cloud to choose it.",
    },
    Step {
        panel: Panel::Outline,
        title: "What is in the scene",
        text: "Clouds are placements of models; models are made of boxes. A click here chooses as one in the picture does.",
    },
    Step {
        panel: Panel::Viewport,
        title: "Boxes of sprites",
        text: "Press B, drag a footprint in the picture, let go, pull the height, and click: a cloud grows under your hand. Q goes \
               back to choosing, Ctrl+Z takes it back.",
    },
    Step {
        panel: Panel::Inspector,
        title: "Values",
        text: "Drag a number sideways, or click it and type. The diamond before a value keys it over time. Parts fold away by \
               their titles.",
    },
    Step {
        panel: Panel::ColorLevels,
        title: "Colour",
        text: "Five levels say which colour a cloud has at which height. Drag their handles here, or on the cloud; Presets has \
               moods from bright noon to storm.",
    },
    Step {
        panel: Panel::Sky,
        title: "Light and weather",
        text: "Drag the hour, or press P and watch the day pass. Plugins makes whole skies, also out of weather reports.",
    },
    Step {
        panel: Panel::History,
        title: "Nothing is lost",
        text: "Each change stands here; a click goes back to it. Ctrl+S saves. F1 opens the manual, each panel's ? its own page, and \
               Ctrl+Shift+P finds any command.",
    },
];

/// What is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TourAnswer {
    Go(usize),
    Leave,
}

/// Shows a step beneath the upper rim of `picture`, and a rim around what it is about.
pub(crate) fn tour(
    context: &Context,
    at: usize,
    picture: Rect,
    about: Option<Rect>,
    takes_esc: bool,
) -> Option<TourAnswer> {
    let step = STEPS.get(at)?;
    if let Some(about) = about {
        let painter = context.layer_painter(LayerId::new(Order::Middle, Id::unique("tour's rim")));
        painter.rect_stroke(about.shrink(1.5), 4.0, theme::tour(context), StrokeKind::Inside);
    }
    let place: Pos2 = picture.center_top() + egui::vec2(0.0, theme::DIALOG_MARGIN);
    let width = theme::DIALOG_WIDTH.min(context.content_rect().width() - theme::DIALOG_MARGIN);
    let shown = Window::new("Tour")
        .id(Id::unique("tour"))
        .frame(theme::dialog(context))
        .title_bar(false)
        .resizable(false)
        .pivot(Align2::CENTER_TOP)
        .fixed_pos(place)
        .constrain_to(context.content_rect())
        .show(context, |ui| {
            ui.set_width(width);
            ui.horizontal(|ui| {
                ui.heading(step.title);
                ui.weak(format!("{} of {}", at + 1, STEPS.len()));
            });
            ui.label(step.text);
            ui.add_space(theme::GAP);
            ui.horizontal(|ui| {
                let is_last = at + 1 == STEPS.len();
                let back = ui.add_enabled(at > 0, egui::Button::new("Back")).clicked();
                let next = ui.button(if is_last { "Done" } else { "Next" }).clicked();
                let leave = !is_last && ui.button("Leave the tour").clicked();
                if leave || (next && is_last) {
                    Some(TourAnswer::Leave)
                } else if next {
                    Some(TourAnswer::Go(at + 1))
                } else {
                    back.then(|| TourAnswer::Go(at - 1))
                }
            })
            .inner
        });
    let escaped = takes_esc && context.input(|input| input.key_pressed(Key::Escape));
    shown.and_then(|shown| shown.inner).flatten().or(escaped.then_some(TourAnswer::Leave))
}
