//! The scene as a tree: models with their boxes, clouds, cameras, flights. A click selects, with Ctrl or Shift more than one.

use crate::state::{Action, Choose, Item, Reading, ViewChange, ViewState};
use crate::theme::icon;
use crate::widget::name_it;
use cloudwright_core::scene::{Cloud, CloudModel, ForKind, List, Listed, Track, for_each_kind};
use egui::collapsing_header::CollapsingState;
use egui::{Align, Button, Id, Layout, Response, ScrollArea, TextWrapMode, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        section(ui, "clouds", scene.clouds.len(), |ui| {
            rows(ui, &scene.clouds, |ui, cloud| {
                row_of(ui, cloud, reading, actions);
            });
        });
        section(ui, "models", scene.models.len(), |ui| {
            for model in &scene.models {
                model_row(ui, model, reading, actions);
            }
        });
        for_each_kind(&mut Others { ui, reading, actions });
    });
}

/// A section for each kind but clouds and their models.
struct Others<'a, 'r> {
    ui: &'a mut Ui,
    reading: &'a Reading<'r>,
    actions: &'a mut Vec<Action>,
}

impl ForKind for Others<'_, '_> {
    fn kind<T: Listed>(&mut self) {
        // Tracks are in the timeline: there may be hundreds.
        if [Cloud::LIST, CloudModel::LIST, Track::LIST].contains(&T::LIST) {
            return;
        }
        let list = T::list(self.reading.session.scene());
        section(self.ui, T::LIST, list.len(), |ui| {
            for value in list {
                let response = row_of(ui, value, self.reading, self.actions);
                if let Item::Camera(id) = T::thing(value.id())
                    && response.on_hover_text("Double-click to look through it").double_clicked()
                {
                    self.actions.push(Action::LookThrough(id));
                }
            }
        });
    }
}

/// Under the name of its list in files.
fn section(ui: &mut Ui, title: &str, count: usize, body: impl FnOnce(&mut Ui)) {
    let title: String = title.chars().take(1).flat_map(char::to_uppercase).chain(title.chars().skip(1)).collect();
    egui::CollapsingHeader::new(format!("{title} ({count})")).id_salt(title).default_open(true).show(ui, body);
}

/// A row a thing, of which only those in sight are laid out: thousands cost no more than a screenful.
fn rows<T>(ui: &mut Ui, things: &List<T>, mut row: impl FnMut(&mut Ui, &T)) {
    let pitch = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let (top, sight) = (ui.cursor().top(), ui.clip_rect());
    let before = |y: f32| (((y - top) / pitch).floor().max(0.0) as usize).min(things.len());
    let (first, end) = (before(sight.top()), (before(sight.bottom()) + 1).min(things.len()));
    // The space between two rows is not added after a space.
    let skip = |ui: &mut Ui, rows: usize| ui.add_space(rows as f32 * pitch);
    skip(ui, first);
    (first..end).filter_map(|at| things.get(at)).for_each(|thing| row(ui, thing));
    skip(ui, things.len() - end);
}

fn model_row(ui: &mut Ui, model: &CloudModel, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let id = Id::unique(("outline model", model.id));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, true);
    // A box that was chosen in the viewport must be seen here.
    let selection = &reading.view.selection;
    if (selection.has_box_of(model.id) || selection.has_sprite_of(model.id)) && !state.is_open() {
        state.set_open(true);
    }
    let header = state.show_header(ui, |ui| row_of(ui, model, reading, actions));
    header.body(|ui| {
        rows(ui, &model.boxes, |ui, each| {
            row(ui, &named(&each.name, "box", each.id.0), Item::Box(model.id, each.id), reading, actions);
        });
    });
}

fn row_of<T: Listed>(ui: &mut Ui, value: &T, reading: &Reading<'_>, actions: &mut Vec<Action>) -> Response {
    row(ui, &named(value.name(), T::WORD, value.id().into()), T::thing(value.id()), reading, actions)
}

fn row(ui: &mut Ui, text: &str, item: Item, reading: &Reading<'_>, actions: &mut Vec<Action>) -> Response {
    let view = reading.view;
    let hidden = view.hidden.contains(&item);
    ui.allocate_ui_with_layout(
        egui::vec2(ui.available_width(), ui.spacing().interact_size.y),
        Layout::right_to_left(Align::Center),
        |ui| {
            if ViewState::can_hide(item) {
                let locked = view.locked.contains(&item);
                let (glyph, word) =
                    if locked { (icon::LOCK_SIMPLE, "Unlock") } else { (icon::LOCK_SIMPLE_OPEN, "Lock") };
                if small(ui, glyph, &format!("{word} {text}"), locked).clicked() {
                    actions.push(Action::View(ViewChange::Locked(item, !locked)));
                }
                let (glyph, word) = if hidden { (icon::EYE_SLASH, "Show") } else { (icon::EYE, "Hide") };
                if small(ui, glyph, &format!("{word} {text}"), hidden).clicked() {
                    actions.push(Action::View(ViewChange::Hidden(item, !hidden)));
                }
            }
            ui.with_layout(
                Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min),
                |ui| {
                    let mut label = egui::RichText::new(text);
                    if hidden {
                        label = label.weak();
                    }
                    let icon = egui::RichText::new(icon::of_kind(item.word())).weak();
                    let response = ui.add(Button::selectable(view.selection.contains(item), (icon, label)));
                    name_it(ui, &response, text);
                    if response.clicked() {
                        let modifiers = ui.input(|input| input.modifiers);
                        let how = if modifiers.command || modifiers.shift { Choose::Toggle } else { Choose::Only };
                        actions.push(Action::Select { items: vec![item], through: None, how });
                    }
                    response
                },
            )
            .inner
        },
    )
    .inner
}

/// A quiet button: strong only when what it says is so.
fn small(ui: &mut Ui, glyph: &str, name: &str, on: bool) -> Response {
    let text = egui::RichText::new(glyph);
    let response = ui.add(Button::new(if on { text } else { text.weak() }).frame(false));
    name_it(ui, &response, name);
    response.on_hover_text(name)
}

fn named(name: &str, kind: &str, id: u64) -> String {
    if name.is_empty() { format!("{kind} {id}") } else { name.into() }
}
