//! Rows dragged elsewhere: to another place of their list, clouds into a folder or out of it, boxes into another model.

use super::lines::Line;
use super::memory::Memory;
use crate::state::{Action, Item, Reading};
use cloudwright_core::arrange::{Arrangement, clip, folders, order};
use cloudwright_core::scene::{Cloud, CloudId, FolderId, Listed, ModelId, Scene};
use egui::{CursorIcon, Key, Rangef, Rect, Stroke, StrokeKind, Ui};

/// From the edge of the rows, points in which a row that is held there scrolls them.
const EDGE: f32 = 16.0;

/// Where what is held would go.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Goal {
    /// Before that one of its list, or to the end; between the rows there.
    Order { before: Option<Item>, row: usize },
    /// Clouds, to a place among those of a folder or of none.
    Among { folder: Option<FolderId>, before: Option<Item>, row: usize },
    /// Clouds, into a folder or out of theirs: the row of that.
    Folder { folder: Option<FolderId>, row: usize },
    /// Boxes, into another model: its row.
    Model { model: ModelId, row: usize },
}

/// Whether two things stand in one list.
pub(super) fn is_beside(a: Item, b: Item) -> bool {
    match (a, b) {
        (Item::Box(a, _), Item::Box(b, _)) => a == b,
        _ => a.word() == b.word(),
    }
}

/// Follows the hand: what would take the rows is marked. `top` is the first row's upper edge, `pitch` from one to the next.
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
    let goal = goal(held, lines, (at.y - top) / pitch).filter(|_| sight.expand(EDGE).contains(at));
    let stroke = Stroke::new(2.0, ui.visuals().selection.stroke.color);
    let edge = |row: usize| top + pitch * row as f32 - 0.5 * ui.spacing().item_spacing.y;
    match goal {
        Some(Goal::Order { row, .. } | Goal::Among { row, .. }) => {
            ui.painter().hline(sight.x_range(), edge(row), stroke);
        }
        Some(Goal::Folder { row, .. } | Goal::Model { row, .. }) => {
            let rect = Rect::from_x_y_ranges(sight.x_range(), Rangef::new(edge(row), edge(row + 1)));
            ui.painter().rect_stroke(rect, 2.0, stroke, StrokeKind::Inside);
        }
        None => {}
    }
    ui.ctx().set_cursor_icon(if goal.is_some() { CursorIcon::Grabbing } else { CursorIcon::NoDrop });
    if !down {
        let things = std::mem::take(&mut memory.dragged);
        actions.extend(goal.and_then(|goal| put(reading.session.scene(), &things, goal)));
    }
}

/// What takes `held` at `place`, rows from the top: there in the upper half of a row, below it in the lower.
fn goal(held: Item, lines: &[Line<'_>], place: f32) -> Option<Goal> {
    // A row's very edge is the row's, whatever the rounding.
    let over = (place + 1e-3).floor().max(0.0) as usize;
    let line = lines.get(over);
    match (held, line.and_then(Line::item)) {
        (Item::Cloud(_), Some(Item::Folder(id))) => return Some(Goal::Folder { folder: Some(id), row: over }),
        (Item::Cloud(_), Some(Item::Cloud(_))) => {
            let folder = line.and_then(Line::folder).map(|folder| folder.id);
            let row = over + usize::from(place - over as f32 > 0.5);
            let next = lines.get(row).filter(|next| next.folder().map(|folder| folder.id) == folder);
            let before = next.and_then(Line::item).filter(|next| is_beside(*next, held));
            return Some(Goal::Among { folder, before, row });
        }
        (Item::Cloud(_), None) if is_heading_of_folders(lines, over) => {
            return Some(Goal::Folder { folder: None, row: over });
        }
        (Item::Box(from, _), Some(Item::Model(model) | Item::Box(model, _))) if model != from => {
            let row = lines.iter().position(|line| line.item() == Some(Item::Model(model)))?;
            return Some(Goal::Model { model, row });
        }
        _ => {}
    }
    let place = place.round().max(0.0) as usize;
    let of_list = |line: &Line<'_>| line.item().filter(|item| is_beside(*item, held));
    let first = lines.iter().position(|line| of_list(line).is_some())?;
    let last = lines.iter().rposition(|line| of_list(line).is_some())?;
    // Below the last are its parts.
    let depth = lines[last].depth();
    let end = last + lines.iter().skip(last + 1).take_while(|line| line.depth() > depth).count();
    if !(first..=end + 1).contains(&place) {
        return None;
    }
    let next = (place..lines.len()).find(|at| of_list(&lines[*at]).is_some());
    let (before, row) = (next.and_then(|at| lines[at].item()), next.unwrap_or(end + 1));
    Some(match held {
        Item::Cloud(_) => Goal::Among { folder: None, before, row },
        _ => Goal::Order { before, row },
    })
}

/// Whether that row is the heading of the clouds, and folders follow: then the first cloud in none is far below.
fn is_heading_of_folders(lines: &[Line<'_>], row: usize) -> bool {
    let is_heading = matches!(lines.get(row), Some(Line::Heading { list, .. }) if *list == Cloud::LIST);
    is_heading && matches!(lines.get(row + 1), Some(Line::Folder { .. }))
}

/// What is to be done for it; none if all is there already.
fn put(scene: &Scene, things: &[Item], goal: Goal) -> Option<Action> {
    let clouds: Vec<CloudId> = things.iter().filter_map(|item| Cloud::id_of(*item)).collect();
    let into = |folder: Option<FolderId>| {
        let moves = clouds.iter().any(|id| scene.cloud(*id).is_some_and(|cloud| cloud.folder != folder));
        if moves { folders::told(scene, clouds.len(), folder) } else { "Change the order".into() }
    };
    let (name, arrangement) = match goal {
        Goal::Order { before, .. } => ("Change the order".into(), order::moved(scene, things, before)),
        Goal::Among { folder, before, .. } => {
            (into(folder), folders::placed(scene, &clouds, folder, before.and_then(Cloud::id_of)))
        }
        Goal::Folder { folder, .. } => (into(folder), folders::put(scene, &clouds, folder)),
        Goal::Model { model, .. } => {
            let count = if things.len() == 1 { "Box" } else { "Boxes" };
            let name = scene.model(model).map_or_else(String::new, |model| model.name.clone());
            (format!("{count} into model {name}"), clip::moved(scene, things, model))
        }
    };
    let Arrangement { edits, made } = arrangement;
    // Boxes are others in another model; all else stays chosen as it is.
    let made = if matches!(goal, Goal::Model { .. }) { made } else { Vec::new() };
    (!edits.is_empty()).then_some(Action::Put { name, edits, made })
}
