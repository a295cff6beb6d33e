//! Scenes that leave for other programs, and files that come in from them: what is asked before, how far it has come, and
//! what could not be carried.

mod arriving;
mod leaving;

pub(crate) use arriving::{ArrivingForm, ask_arriving};
pub(crate) use leaving::{LeavingChosen, LeavingForm, ask_leaving};

use crate::theme;
use crate::widget::{fitted, number_field, work_bar};
use cloudwright_core::exchange::{Note, NoteKind, OptionKind, OptionRow, Options};
use egui::{Button, Context, Grid, Id, Modal, ScrollArea, Ui};

/// What is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExchangeAnswer {
    Begin,
    /// The work; it may be asked again.
    Stop,
    Close,
}

/// How far it has come.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Stage<'a> {
    /// It is being chosen; and why the last try came to nothing.
    Choosing(Option<&'a str>),
    /// The share that is done, 0 to 1.
    Working(f32),
    /// What came of it, and what could not be carried.
    Done(&'a [String], &'a [Note]),
}

/// Asks, with what `add` adds while it is chosen; `go` is what begins it, if it can.
pub(super) fn ask(
    context: &Context,
    (title, go): (&str, &str),
    stage: Stage<'_>,
    can_go: bool,
    add: impl FnOnce(&mut Ui),
) -> Option<ExchangeAnswer> {
    let modal = Modal::new(Id::unique(title)).frame(theme::dialog(context));
    let modal = modal.show(context, |ui| {
        fitted(ui, theme::DIALOG_WIDTH, |ui| {
            ui.heading(title);
            ui.add_space(theme::GAP);
            match stage {
                Stage::Done(lines, notes) => outcome(ui, lines, notes),
                Stage::Choosing(_) => add(ui),
                Stage::Working(_) => {
                    ui.add_enabled_ui(false, add);
                }
            }
            if let Stage::Choosing(Some(refusal)) = stage {
                ui.add_space(theme::GAP);
                ui.colored_label(ui.visuals().warn_fg_color, refusal);
            }
            ui.add_space(theme::GAP);
            buttons(ui, stage, go, can_go)
        })
    });
    let in_front = modal.is_top_modal && !modal.any_popup_open;
    let escaped = in_front && context.input(|input| input.key_pressed(egui::Key::Escape));
    modal.inner.or(escaped.then_some(match stage {
        Stage::Working(_) => ExchangeAnswer::Stop,
        Stage::Choosing(_) | Stage::Done(..) => ExchangeAnswer::Close,
    }))
}

fn buttons(ui: &mut Ui, stage: Stage<'_>, go: &str, can_go: bool) -> Option<ExchangeAnswer> {
    ui.horizontal(|ui| match stage {
        Stage::Working(share) => {
            let stop = ui.button("Stop").clicked().then_some(ExchangeAnswer::Stop);
            work_bar(ui, &format!("Progress of {go}"), share);
            stop
        }
        Stage::Choosing(_) => {
            let begin = ui.add_enabled(can_go, Button::new(go)).clicked().then_some(ExchangeAnswer::Begin);
            begin.or(ui.button("Cancel").clicked().then_some(ExchangeAnswer::Close))
        }
        Stage::Done(..) => ui.button("OK").clicked().then_some(ExchangeAnswer::Close),
    })
    .inner
}

/// What came of it.
fn outcome(ui: &mut Ui, lines: &[String], notes: &[Note]) {
    let height = ui.ctx().content_rect().height() * theme::WIDE_FORM_SHARE;
    ScrollArea::vertical().id_salt("outcome").max_height(height).show(ui, |ui| {
        ui.set_width(theme::DIALOG_WIDTH);
        for line in lines {
            ui.label(line);
        }
        let kinds = [
            (NoteKind::LeftOut, "Not carried"),
            (NoteKind::Changed, "Not as it was"),
            (NoteKind::Assumed, "Not said, and taken"),
        ];
        for (kind, title) in kinds {
            let mut of_kind = notes.iter().filter(|note| note.kind == kind).peekable();
            if of_kind.peek().is_some() {
                ui.add_space(theme::GAP);
                ui.strong(title);
            }
            for Note { what, how, .. } in of_kind {
                ui.label(if how.is_empty() { format!("• {what}") } else { format!("• {what}: {how}") });
            }
        }
    });
}

/// What can be set of a format, as rows of a grid of two columns.
fn option_rows(ui: &mut Ui, rows: &[OptionRow], options: &mut Options) {
    for row in rows {
        let doc = row.doc.trim_end_matches(':');
        let name = words(row.name);
        match row.kind {
            OptionKind::Flag(_) => {
                ui.label("");
                let mut on = options.flag(row.name);
                if ui.checkbox(&mut on, &name).on_hover_text(doc).clicked() {
                    set(options, row, if on { "yes" } else { "no" });
                }
            }
            OptionKind::Number(number, _) => {
                ui.label(&name).on_hover_text(doc);
                let mut value = options.number(row.name);
                if number_field(ui, &name, &number, &mut value, false) {
                    set(options, row, &value.to_string());
                }
            }
        }
        ui.end_row();
    }
}

/// What a widget of a row's own kind and range gives is one of its values.
fn set(options: &mut Options, row: &OptionRow, value: &str) {
    let _ = options.set(row.name, value);
}

/// `each_key`: "Each key".
fn words(name: &str) -> String {
    let mut words = name.replace('_', " ");
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    words
}

pub(super) fn grid(ui: &mut Ui, id: &str, rows: impl FnOnce(&mut Ui)) {
    Grid::new(id).num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, rows);
}
