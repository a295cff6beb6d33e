//! The plugins that there are, by what they make; and what should be one and can't be read.

use crate::plugins::{Entry, Library, Origin};
use crate::state::Action;
use crate::theme::{self, icon};
use crate::visible;
use crate::widget::name_it;
use cloudwright_scripts::PluginKind;
use egui::{Button, Label, RichText, Ui};

/// The submenu of those that are broken.
const BROKEN: &str = "Can't be read";

/// What plugins of a kind are called together.
pub(crate) fn kind_name(kind: PluginKind) -> &'static str {
    match kind {
        PluginKind::Generator => "Generators",
        PluginKind::Edit => "Edits",
        PluginKind::Look => "Looks",
        PluginKind::Weather => "Weather",
        PluginKind::Exporter => "Exporters",
    }
}

/// What one plugin of a kind is called.
pub(crate) fn kind_in_words(kind: PluginKind) -> &'static str {
    match kind {
        PluginKind::Generator => "Generator",
        PluginKind::Edit => "Edit",
        PluginKind::Look => "Look",
        PluginKind::Weather => "Weather",
        PluginKind::Exporter => "Exporter",
    }
}

/// A submenu a kind, and one of those that are broken.
pub(crate) fn menus(ui: &mut Ui, library: &Library, actions: &mut Vec<Action>) {
    if library.entries().is_empty() {
        ui.weak("They are still being read");
    }
    for kind in PluginKind::ALL {
        let plugins = library.of_kind(*kind);
        if plugins.is_empty() {
            continue;
        }
        let menu = ui.menu_button(kind_name(*kind), |ui| {
            for (Entry { origin, .. }, plugin) in plugins {
                let button = ui.button(visible::one_line(&library.label(origin, plugin)));
                let tooltip = |ui: &mut Ui| {
                    ui.label(visible::one_line(&plugin.description.sentence));
                    ui.weak(visible::one_line(&origin.to_string()));
                };
                if button.on_hover_ui(tooltip).clicked() {
                    actions.push(Action::Plugin(origin.clone()));
                }
            }
        });
        name_it(ui, &menu.response, kind_name(*kind));
    }
    if library.broken().next().is_some() {
        let menu = ui.menu_button(BROKEN, |ui| broken(ui, library, actions));
        name_it(ui, &menu.response, BROKEN);
    }
}

/// Each with what is wrong beneath it.
fn broken(ui: &mut Ui, library: &Library, actions: &mut Vec<Action>) {
    ui.set_width(theme::DIALOG_WIDTH);
    for (origin, error) in library.broken() {
        let name = visible::one_line(&origin.in_short());
        let warning = RichText::new(icon::WARNING).color(theme::warning(ui));
        let button = ui.add(Button::new((warning, name.as_str())).min_size([ui.available_width(), 0.0].into()));
        name_it(ui, &button, &name);
        let error = visible::one_line(&error.to_string());
        ui.add(Label::new(RichText::new(error).weak()).wrap());
        if button.on_hover_text(visible::one_line(&origin.to_string())).clicked() {
            actions.push(Action::Plugin(Origin::clone(origin)));
        }
    }
}
