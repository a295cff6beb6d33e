//! Rows dragged to another place of their list.

use super::lines::Line;
use super::memory::Memory;
use crate::state::{Action, Item, Reading};
use cloudwright_core::arrange::order;
use egui::{CursorIcon, Key, Rect, Stroke, Ui};

/// From the edge of the rows, points in which a row that is held there scrolls them.
const EDGE: f32 = 16.0;

/// Whether two things stand in one list.
pub(super) fn is_beside(a: Item, b: Item) -> bool {
    match (a, b) {
        (Item::Box(a, _), Item::Box(b, _)) => a == b,
        _ => a.word() == b.word(),
    }
}

/// Follows the hand: a line shows where the rows would go. `top` is the first row's upper edge, `pitch` from one to the next.
pub(super) fn follow(
    ui: &mut Ui,
    lines: &[Line<'_>],
    (top, pitch): (f32, f32),
    sight: Rect,
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let Some(held) = memory.dragged.last().copied() else { return };
    let (at, down, dropped) =
        ui.input(|input| (input.pointer.latest_pos(), input.pointer.primary_down(), input.key_pressed(Key::Escape)));
    let Some(at) = at.filter(|_| !dropped) else { return memory.dragged.clear() };
    if at.y < sight.top() + EDGE || at.y > sight.bottom() - EDGE {
        ui.scroll_with_delta(egui::vec2(0.0, if at.y < sight.center().y { 8.0 } else { -8.0 }));
        ui.ctx().request_repaint();
    }
    let place = ((at.y - top) / pitch).round().max(0.0) as usize;
    let of_list = |line: &Line<'_>| line.item().filter(|item| is_beside(*item, held));
    let first = lines.iter().position(|line| of_list(line).is_some());
    let last = lines.iter().rposition(|line| of_list(line).is_some());
    let (Some(first), Some(last)) = (first, last) else { return memory.dragged.clear() };
    // Below the last model are its boxes.
    let end =
        last + lines.iter().skip(last + 1).take_while(|line| line.depth() > 1 && lines[last].depth() == 1).count();
    let within = (first..=end + 1).contains(&place) && sight.expand(EDGE).contains(at);
    let next = (place..lines.len()).find(|at| of_list(&lines[*at]).is_some());
    if within {
        let y = top + pitch * next.unwrap_or(end + 1) as f32 - 0.5 * ui.spacing().item_spacing.y;
        ui.painter().hline(sight.x_range(), y, Stroke::new(2.0, ui.visuals().selection.stroke.color));
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
    } else {
        ui.ctx().set_cursor_icon(CursorIcon::NoDrop);
    }
    if !down {
        let things = std::mem::take(&mut memory.dragged);
        if within {
            let before = next.and_then(|at| lines[at].item());
            let edits = order::moved(reading.session.scene(), &things, before).edits;
            if !edits.is_empty() {
                actions.push(Action::Change { name: "Change the order", edits, live: false });
            }
        }
    }
}
