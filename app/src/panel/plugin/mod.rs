//! What can be chosen of a plugin, from what it says of itself, and what its run came to: as a question, and as the panel
//! in which the last run can be had with other values. And the menu of all that there are.

mod curve;
mod menu;
mod parameters;

pub(super) use menu::{kind_in_words, kind_name, menus};

use super::corner::{self, Answer};
use crate::plugins::Origin;
use crate::theme::{self, icon};
use crate::units::Units;
use crate::visible;
use crate::widget::fitted;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::{Plugin, PluginKind, Values};
use egui::{Align2, Context, Id, RichText, ScrollArea, Spinner, Ui, Window, vec2};

/// What is shown of a plugin.
#[derive(Clone, Copy)]
pub(crate) struct PluginForm<'a> {
    pub(crate) plugin: &'a Plugin,
    /// What it is called.
    pub(crate) title: &'a str,
    pub(crate) origin: &'a Origin,
    /// Whose clouds and models there are to choose from.
    pub(crate) scene: &'a Scene,
    pub(crate) units: Units,
    pub(crate) said: Said<'a>,
}

/// What is to be told of its run and of its file.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Said<'a> {
    /// Why the last run came to nothing, with line and column.
    pub(crate) error: Option<&'a str>,
    /// What the last run printed.
    pub(crate) printed: &'a [String],
    /// A run has gone on for a while.
    pub(crate) runs: bool,
    /// What has become of its file.
    pub(crate) notice: Option<&'a str>,
}

/// Asks in a corner, so that the scene can be seen as it would be.
pub(crate) fn ask_plugin(context: &Context, form: &PluginForm<'_>, values: &mut Values) -> Option<Answer> {
    corner::ask(context, Id::unique("plugin"), theme::DIALOG_WIDTH, |ui| {
        ui.heading(visible::one_line(form.title));
        ui.weak(visible::one_line(&form.plugin.description.sentence));
        if let Origin::File(path) = form.origin {
            ui.add(
                egui::Label::new(RichText::new(visible::one_line(&path.display().to_string())).small().weak())
                    .truncate(),
            );
        }
        ui.add_space(theme::GAP);
        self::form(ui, form, values);
        let exports = form.plugin.description.kind == PluginKind::Exporter;
        corner::buttons(ui, if exports { "Export…" } else { "OK" }, form.said.error.is_none())
    })
}

/// Shows the last run's values to be changed, over the panels. Whether it stays open.
pub(crate) fn show_last_run(context: &Context, form: &PluginForm<'_>, values: &mut Values) -> bool {
    let mut open = true;
    Window::new(visible::one_line(&format!("Last run: {}", form.title)))
        .id(Id::unique("last run"))
        .frame(theme::dialog(context))
        .anchor(Align2::LEFT_BOTTOM, vec2(1.0, -1.0) * theme::DIALOG_MARGIN)
        .resizable(false)
        .default_open(false)
        .open(&mut open)
        .show(context, |ui| {
            fitted(ui, theme::DIALOG_WIDTH, |ui| self::form(ui, form, values));
        });
    open
}

fn form(ui: &mut Ui, form: &PluginForm<'_>, values: &mut Values) {
    let parameters = &form.plugin.description.parameters;
    let height = ui.ctx().content_rect().height() * theme::FORM_SHARE;
    ScrollArea::vertical().max_height(height).show(ui, |ui| {
        ui.set_width(theme::DIALOG_WIDTH);
        parameters::rows(ui, parameters, form.scene, form.units, values);
    });
    ui.add_space(theme::GAP);
    said(ui, &form.said);
}

/// So high that no field moves under the pointer when something is said.
pub(super) fn said(ui: &mut Ui, said: &Said<'_>) {
    ui.vertical(|ui| {
        ui.set_min_height(theme::SAID_HEIGHT);
        ScrollArea::vertical().id_salt("said").max_height(theme::DIALOG_LIST_HEIGHT / 3.0).show(ui, |ui| {
            ui.set_width(ui.available_width());
            said_lines(ui, said);
        });
    });
}

fn said_lines(ui: &mut Ui, said: &Said<'_>) {
    if let Some(notice) = said.notice {
        ui.colored_label(theme::warning(ui), visible::lines(notice));
    }
    if let Some(error) = said.error {
        ui.horizontal_top(|ui| {
            ui.colored_label(theme::error(ui), icon::WARNING_CIRCLE);
            ui.add(egui::Label::new(RichText::new(visible::lines(error)).color(theme::error(ui))).wrap());
        });
    }
    if said.runs {
        ui.horizontal(|ui| {
            ui.add(Spinner::new().size(theme::SMALL_TEXT));
            ui.weak("running…");
        });
    }
    for line in said.printed {
        ui.weak(visible::one_line(line));
    }
}
