//! One line of the outline: how deep it stands, what it is called, whether it is hidden or locked.

use super::lines::Line;
use super::memory::{Fold, Memory};
use crate::state::{Action, Item, Reading, ViewChange, ViewState};
use crate::theme::{self, icon};
use crate::widget::name_it;
use cloudwright_core::arrange::rename;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{Folder, Listed};
use egui::collapsing_header::paint_default_icon;
use egui::text::{CCursor, CCursorRange};
use egui::{
    Align, AtomExt, Button, EventFilter, Key, Layout, Rect, Response, RichText, Role, Sense, TextEdit, Ui, Vec2,
    WidgetInfo, vec2,
};

/// Of a folder's colour along the rows of its clouds, points.
const STRIPE: f32 = 3.0;

/// What is known of a line besides its words.
pub(super) struct Shown {
    /// Whether what it folds is folded.
    pub(super) folded: bool,
    /// Of a model, whether no cloud places it.
    pub(super) unused: bool,
}

/// A heading. Whether it was clicked.
pub(super) fn heading(ui: &mut Ui, list: &str, [shown, of]: [usize; 2], folded: bool) -> bool {
    let count = if shown == of { of.to_string() } else { format!("{shown} of {of}") };
    let title = format!("{} ({count})", titled(list));
    ui.horizontal(|ui| {
        let by_mark = fold_mark(ui, list, folded);
        let text = RichText::new(title.as_str()).strong();
        let response = ui.add(Button::new(text).frame(false));
        name_it(ui, &response, &title);
        by_mark || response.clicked()
    })
    .inner
}

/// A list's name, as a title: "Clouds".
pub(super) fn titled(list: &str) -> String {
    list.chars().take(1).flat_map(char::to_uppercase).chain(list.chars().skip(1)).collect()
}

/// The triangle that folds and unfolds `what`. Whether it was clicked.
fn fold_mark(ui: &mut Ui, what: &str, folded: bool) -> bool {
    let (_, response) = ui.allocate_exact_size(Vec2::splat(ui.spacing().icon_width), Sense::click());
    let name = format!("{} {what}", if folded { "Unfold" } else { "Fold" });
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    paint_default_icon(ui, if folded { 0.0 } else { 1.0 }, &response);
    response.on_hover_text(name).clicked()
}

/// What a thing is called here.
pub(super) fn called(item: Item, name: &str) -> String {
    let id = match item {
        Item::Box(_, id) if name.is_empty() => id.0,
        _ if name.is_empty() => return item.word().into(),
        _ => return name.into(),
    };
    format!("{} {id}", item.word())
}

/// A thing: its button, to be chosen and dragged by.
pub(super) fn thing(
    ui: &mut Ui,
    line: &Line<'_>,
    (item, name): (Item, &str),
    shown: &Shown,
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) -> Option<Response> {
    let height = ui.spacing().interact_size.y;
    let text = called(item, name);
    let size = vec2(ui.available_width(), height);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        stripe(ui, line);
        match line {
            Line::Folder { folder, holds } => folder_marks(ui, folder, *holds, &text, actions),
            _ => marks(ui, item, &text, shown, reading, actions),
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            indent(ui, line, &text, shown, memory);
            if memory.renamed.as_ref().is_some_and(|(renamed, _)| *renamed == item) {
                edit_name(ui, item, memory, reading, actions);
                return None;
            }
            let layout = Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min);
            Some(ui.with_layout(layout, |ui| button(ui, line, (item, &text), memory, reading)).inner)
        })
        .inner
    })
    .inner
}

/// Space for its depth, and the button that folds.
fn indent(ui: &mut Ui, line: &Line<'_>, text: &str, shown: &Shown, memory: &mut Memory) {
    let step = ui.spacing().icon_width;
    ui.add_space(step * line.depth() as f32);
    match line.fold() {
        Some(fold @ (Fold::Model(_) | Fold::Folder(_))) => {
            if fold_mark(ui, text, shown.folded) {
                memory.toggle(fold);
            }
        }
        // As wide as the triangle.
        _ => ui.add_space(step + ui.spacing().item_spacing.x),
    }
}

/// The colour of the folder that it is, or is in.
fn stripe(ui: &Ui, line: &Line<'_>) {
    let Some(folder) = line.folder() else { return };
    let (row, is_within) = (ui.max_rect(), line.depth() > 1);
    let width = if is_within { STRIPE } else { 2.0 * STRIPE };
    let left = row.left() + 0.25 * ui.spacing().icon_width;
    // From one row to the next without a gap.
    let height = row.expand(0.5 * ui.spacing().item_spacing.y).y_range();
    ui.painter().rect_filled(Rect::from_x_y_ranges(left..=left + width, height), 0.0, theme::of_folder(folder));
}

/// Eye and lock of a folder, which are the scene's, and how many clouds are in it.
fn folder_marks(ui: &mut Ui, folder: &Folder, holds: usize, text: &str, actions: &mut Vec<Action>) {
    let mut set = |changed: Folder| {
        actions.push(Action::change(Folder::CHANGE, Edit::Folder(ListEdit::Replace(changed)), false));
    };
    if lock(ui, text, folder.locked) {
        set(Folder { locked: !folder.locked, ..folder.clone() });
    }
    if eye(ui, text, folder.hidden) {
        set(Folder { hidden: !folder.hidden, ..folder.clone() });
    }
    let clouds = if holds == 1 { "1 cloud".into() } else { format!("{holds} clouds") };
    ui.add(egui::Label::new(RichText::new(clouds).weak()).selectable(false));
}

/// Whether it was clicked.
fn lock(ui: &mut Ui, text: &str, locked: bool) -> bool {
    let (glyph, word) = if locked { (icon::LOCK_SIMPLE, "Unlock") } else { (icon::LOCK_SIMPLE_OPEN, "Lock") };
    small(ui, glyph, &format!("{word} {text}"), locked).clicked()
}

/// Whether it was clicked.
fn eye(ui: &mut Ui, text: &str, hidden: bool) -> bool {
    let (glyph, word) = if hidden { (icon::EYE_SLASH, "Show") } else { (icon::EYE, "Hide") };
    small(ui, glyph, &format!("{word} {text}"), hidden).clicked()
}

/// Eye and lock, and that a model is not used.
fn marks(ui: &mut Ui, item: Item, text: &str, shown: &Shown, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    if !ViewState::can_hide(item) {
        return;
    }
    let view = reading.view;
    let locked = view.locked.contains(&item);
    if lock(ui, text, locked) {
        actions.push(Action::View(ViewChange::Locked(item, !locked)));
    }
    let hidden = view.hidden.contains(&item);
    if eye(ui, text, hidden) {
        actions.push(Action::View(ViewChange::Hidden(item, !hidden)));
    }
    if shown.unused {
        let label = egui::Label::new(RichText::new("unused").weak().italics()).selectable(false);
        ui.add(label).on_hover_text("No cloud places this model. Remove unused models takes all such out.");
    }
}

fn button(
    ui: &mut Ui,
    line: &Line<'_>,
    (item, text): (Item, &str),
    memory: &mut Memory,
    reading: &Reading<'_>,
) -> Response {
    let mut label = RichText::new(text);
    if reading.view.hidden.contains(&item) || line.folder().is_some_and(|folder| folder.hidden) {
        label = label.weak();
    }
    let glyph = RichText::new(icon::of_kind(item.word())).weak();
    let button = Button::selectable(reading.view.selection.contains(item), (glyph, label.atom_shrink(true))).truncate();
    let response = ui.add(button.sense(Sense::click_and_drag()));
    name_it(ui, &response, text);
    if memory.focus == Some(item) {
        memory.focus = None;
        response.request_focus();
    }
    if response.has_focus() {
        memory.has_keys = true;
        // Up and down go to other rows, not to other widgets.
        let filter = EventFilter { vertical_arrows: true, horizontal_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    }
    response
}

/// The name as a field, until Enter, Esc or a click elsewhere.
fn edit_name(ui: &mut Ui, item: Item, memory: &mut Memory, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let Some((_, typed)) = &mut memory.renamed else { return };
    let begins = memory.focus == Some(item);
    let mut output = TextEdit::singleline(typed).desired_width(f32::INFINITY).show(ui);
    name_it(ui, &output.response, "New name");
    if begins {
        memory.focus = None;
        output.response.request_focus();
        let all = CCursorRange::two(CCursor::default(), CCursor::new(typed.chars().count()));
        output.state.cursor.set_char_range(Some(all));
        output.state.store(ui.ctx(), output.response.id);
    } else if !output.response.has_focus() {
        let name = std::mem::take(typed);
        memory.renamed = None;
        memory.focus = Some(item);
        actions.push(Action::View(ViewChange::Renaming(None)));
        if !ui.input(|input| input.key_pressed(Key::Escape)) {
            let edits = rename::one(reading.session.scene(), item, name.trim()).edits;
            if !edits.is_empty() {
                actions.push(Action::Change { name: "Rename", edits, live: false });
            }
        }
    }
}

/// A quiet button: strong only when what it says is so.
fn small(ui: &mut Ui, glyph: &str, name: &str, on: bool) -> Response {
    let text = RichText::new(glyph);
    let response = ui.add(Button::new(if on { text } else { text.weak() }).frame(false));
    name_it(ui, &response, name);
    response.on_hover_text(name)
}
