//! The scene as a tree: folders with their clouds, models with their boxes, cameras, flights. What a command works on is
//! chosen here.
//!
//! A click chooses; with Ctrl one more, with Shift all up to there; so do the arrow keys. F2 or a double click renames, a
//! drag gives another place in the list or puts clouds into a folder, the right button offers what can be done. Only the
//! rows in sight are laid out.

mod drag;
mod lines;
mod memory;
mod row;

use crate::command::context;
use crate::state::{Action, Choose, Item, Reading, ViewChange};
use crate::widget::{combo, context_menu, name_it};
use cloudwright_core::arrange::rename;
use cloudwright_core::scene::ModelId;
use egui::{Key, Modifiers, Response, ScrollArea, TextEdit, TextWrapMode, Ui};
use lines::Line;
use memory::{Memory, row_of};
use row::Shown;
use std::collections::HashSet;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let memory = Memory::of(ui.ctx());
    let memory = &mut *memory.lock();
    find(ui, memory);
    let scene = reading.session.scene();
    memory.follow(&reading.view.selection, scene);
    take_up_renaming(memory, reading);
    let lines = lines::lines(scene, memory);
    by_keys(ui, &lines, memory, reading, actions);
    let pitch = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let mut area = ScrollArea::vertical().auto_shrink(false);
    if let Some(offset) = offset_to_reveal(&lines, pitch, memory) {
        area = area.vertical_scroll_offset(offset);
    }
    let used: HashSet<ModelId> = scene.clouds.iter().map(|cloud| cloud.model).collect();
    let had_keys = std::mem::take(&mut memory.has_keys);
    let output = area.show_rows(ui, ui.spacing().interact_size.y, lines.len(), |ui, in_sight| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        let top = ui.max_rect().top() - pitch * in_sight.start as f32;
        for line in lines.get(in_sight).unwrap_or_default() {
            show_line(ui, line, &lines, &used, memory, reading, actions);
        }
        drag::follow(ui, &lines, (top, pitch), ui.clip_rect(), memory, reading, actions);
    });
    memory.scrolled = [output.state.clamped_offset().y, output.inner_rect.height()];
    if had_keys && memory.focus.is_some() {
        // It is laid out in the next frame.
        memory.has_keys = true;
        ui.ctx().request_repaint();
    }
}

/// By name, and by kind.
fn find(ui: &mut Ui, memory: &mut Memory) {
    ui.horizontal(|ui| {
        let name = |only: Option<&str>| only.map_or("All kinds".into(), row::titled);
        let kinds = std::iter::once(None).chain(lines::kinds().into_iter().map(Some));
        let kinds: Vec<_> = kinds.map(|only| (only, name(only))).collect();
        let shown = name(memory.only);
        if let Some(only) = combo(ui, "Kinds shown", "Of which kind.", &shown, &kinds, |only| *only == memory.only) {
            memory.only = only;
        }
        let field = TextEdit::singleline(&mut memory.typed).hint_text("Find by name").desired_width(f32::INFINITY);
        let field = ui.add(field);
        name_it(ui, &field, "Find in the outline");
    });
}

/// The row of what is to be renamed becomes a field.
fn take_up_renaming(memory: &mut Memory, reading: &Reading<'_>) {
    match (reading.view.renaming, &memory.renamed) {
        (Some(item), None) => {
            let name = rename::name_of(reading.session.scene(), item).unwrap_or_default();
            memory.renamed = Some((item, name.into()));
            (memory.reveal, memory.focus) = (Some(item), Some(item));
        }
        (None, Some(_)) => memory.renamed = None,
        _ => {}
    }
}

/// Where to scroll to so that what is to be seen is.
fn offset_to_reveal(lines: &[Line<'_>], pitch: f32, memory: &mut Memory) -> Option<f32> {
    let item = memory.reveal.take()?;
    let at = lines.iter().position(|line| line.item() == Some(item))? as f32 * pitch;
    let [from, height] = memory.scrolled;
    let in_sight = (from..=from + height - pitch).contains(&at);
    (!in_sight && height > 0.0).then(|| (at - 0.4 * height).max(0.0))
}

fn show_line(
    ui: &mut Ui,
    line: &Line<'_>,
    lines: &[Line<'_>],
    used: &HashSet<ModelId>,
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let folded = line.fold().is_some_and(|fold| memory.folded.contains(&fold));
    match *line {
        Line::Heading { list, shown, of } => {
            ui.push_id(list, |ui| {
                if row::heading(ui, list, [shown, of], folded)
                    && let Some(fold) = line.fold()
                {
                    memory.toggle(fold);
                }
            });
        }
        Line::Thing { .. } | Line::Folder { .. } => {
            let Some((item, name)) = line.item().zip(line.name()) else { return };
            let unused = matches!(item, Item::Model(id) if !used.contains(&id));
            let shown = Shown { folded, unused };
            let response =
                ui.push_id(item, |ui| row::thing(ui, line, (item, name), &shown, memory, reading, actions)).inner;
            if let Some(response) = response {
                by_pointer(ui, response, item, lines, memory, reading, actions);
            }
        }
    }
}

/// What clicks and drags of a row do.
fn by_pointer(
    ui: &Ui,
    response: Response,
    item: Item,
    lines: &[Line<'_>],
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let selection = &reading.view.selection;
    let response = match item {
        Item::Camera(_) => response.on_hover_text("Double-click to look through it"),
        _ => response,
    };
    if response.double_clicked() {
        actions.push(match item {
            Item::Camera(id) => Action::LookThrough(id),
            other => Action::View(ViewChange::Renaming(Some(other))),
        });
    } else if response.clicked() {
        let modifiers = ui.input(|input| input.modifiers);
        actions.push(choice(item, modifiers, lines, reading));
        response.request_focus();
    } else if response.secondary_clicked() && !selection.contains(item) {
        actions.push(Action::select(item));
    }
    if response.drag_started() && memory.typed.is_empty() {
        let beside = selection.items().iter().copied().filter(|other| drag::is_beside(*other, item));
        memory.dragged = if selection.contains(item) { beside.collect() } else { vec![item] };
    }
    actions.extend(context_menu(&response, context::OUTLINE, reading.offered).map(Action::Command));
}

/// A click chooses the row; with Shift all from the one chosen last to it; with Ctrl it too, or no longer.
fn choice(item: Item, modifiers: Modifiers, lines: &[Line<'_>], reading: &Reading<'_>) -> Action {
    let last = reading.view.selection.primary().map(row_of);
    let at = |item: Item| lines.iter().position(|line| line.item() == Some(item));
    if modifiers.shift
        && let (Some(from), Some(to)) = (last.and_then(at), at(item))
    {
        let mut items: Vec<Item> =
            lines[from.min(to)..=from.max(to)].iter().filter_map(Line::item).filter(|each| *each != item).collect();
        items.retain(|each| drag::is_beside(*each, item));
        items.push(item);
        return Action::Select { items, through: None, how: Choose::Too };
    }
    let how = if modifiers.command || modifiers.shift { Choose::Toggle } else { Choose::Only };
    Action::Select { items: vec![item], through: None, how }
}

/// Up and down choose the next row, with Shift that one too; left and right fold and unfold.
fn by_keys(ui: &Ui, lines: &[Line<'_>], memory: &mut Memory, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    if !memory.has_keys || ui.ctx().text_edit_focused() {
        return;
    }
    let (step, fold, shift) = ui.input(|input| {
        let pressed = |plus, minus| i32::from(input.key_pressed(plus)) - i32::from(input.key_pressed(minus));
        (pressed(Key::ArrowDown, Key::ArrowUp), pressed(Key::ArrowRight, Key::ArrowLeft), input.modifiers.shift)
    });
    let Some(primary) = reading.view.selection.primary().map(row_of) else { return };
    let Some(at) = lines.iter().position(|line| line.item() == Some(primary)) else { return };
    let next = if step > 0 {
        lines.iter().skip(at + 1).find_map(Line::item)
    } else {
        lines.iter().take(at).rev().find_map(Line::item)
    };
    if let Some(next) = next.filter(|_| step != 0) {
        let how = if shift { Choose::Too } else { Choose::Only };
        actions.push(Action::Select { items: vec![next], through: None, how });
        memory.focus = Some(next);
    }
    match (lines[at].fold(), fold) {
        (Some(its), 1) => drop(memory.folded.remove(&its)),
        (Some(its), -1) => drop(memory.folded.insert(its)),
        (None, -1) if lines[at].depth() > 1 => {
            let above = lines.iter().take(at).rev().find(|line| line.depth() == 1).and_then(Line::item);
            actions.extend(above.map(Action::select));
            memory.focus = above;
        }
        _ => {}
    }
}
