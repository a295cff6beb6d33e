//! How the view is moved: from buttons, wheel and keys to [`Navigation`].
//!
//! As level editors have it: the middle button (or Alt and the primary one) turns, and moves with Shift; the wheel goes
//! nearer. The primary button alone belongs to the tools, the right one to the [fly_control](super::fly_control).

use super::navigation::Navigation;
use super::pick;
use super::screen::Screen;
use crate::state::Reading;
use egui::{EventFilter, Key, Modifiers, PointerButton, Response, Ui, vec2};

/// Of turn an arrow key.
const POINTS_PER_KEY: f32 = 20.0;

/// Moves the view as buttons, wheel and keys say.
pub(super) fn steer(navigation: &mut Navigation, ui: &Ui, response: &Response, screen: &Screen, reading: &Reading<'_>) {
    let modifiers = ui.input(|input| input.modifiers);
    let by = |button| response.dragged_by(button);
    let moved = response.drag_delta();
    let turns = by(PointerButton::Middle) || (modifiers.alt && by(PointerButton::Primary));
    let is_pinned = navigation.pinned().is_some();
    if (modifiers.shift || is_pinned) && turns {
        navigation.pan(moved, &screen.view);
    } else if turns {
        navigation.orbit(moved);
    }
    if response.hovered()
        && let Some(at) = response.hover_pos()
    {
        let turned = ui.input(|input| input.smooth_scroll_delta().y + 100.0 * (input.zoom_delta() - 1.0));
        if turned != 0.0 {
            let ray = screen.ray(at);
            let depth = pick::depth(screen, ray, reading).unwrap_or(navigation.distance() as f32);
            navigation.zoom(turned, ray * depth);
        }
    }
    if response.has_focus() {
        steer_by_keys(navigation, ui, response, screen);
    }
}

/// The keyboard's way, for who has no wheel.
fn steer_by_keys(navigation: &mut Navigation, ui: &Ui, response: &Response, screen: &Screen) {
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let step = |plus: Key, minus: Key| {
        ui.input_mut(|input| {
            f32::from(input.consume_key(Modifiers::NONE, plus)) - f32::from(input.consume_key(Modifiers::NONE, minus))
        })
    };
    let turn = vec2(step(Key::ArrowRight, Key::ArrowLeft), step(Key::ArrowDown, Key::ArrowUp));
    if navigation.pinned().is_some() {
        navigation.pan(-turn * POINTS_PER_KEY, &screen.view);
    } else {
        navigation.orbit(turn * POINTS_PER_KEY);
    }
    let closer = step(Key::Plus, Key::Minus) * 50.0;
    if closer != 0.0 {
        navigation.zoom(closer, screen.view.forward * navigation.distance() as f32);
    }
}
