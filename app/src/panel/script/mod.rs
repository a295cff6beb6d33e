//! Where a plugin is written: its text with what is wrong at its line, find, and what a run said.
//!
//! The text itself is shown by egui_code_editor ([`code`]). What is typed goes back as an action, like all else.

mod code;
mod find;

use crate::plugins::Origin;
use crate::state::{Action, Reading, ScriptChange};
use crate::theme::{self, icon};
use crate::visible;
use crate::widget::name_it;
use cloudwright_scripts::shipped::SHIPPED;
use cloudwright_scripts::{PluginKind, ScriptError};
use egui::{Button, Key, Label, Modifiers, Panel, RichText, ScrollArea, Ui};

pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let (mut asked, mut wanted) = (None, None);
    let script = reading.script;
    ui.horizontal_wrapped(|ui| {
        toolbar(ui, reading, &mut asked);
        wanted = find::show(ui, &script.text);
    });
    if script.changed_on_disk {
        ui.horizontal_wrapped(|ui| {
            ui.colored_label(theme::warning(ui), "Another program has changed the file.");
            if ui.button("Load theirs").clicked() {
                asked = Some(ScriptChange::Reload);
            }
        });
    }
    if script.text.is_empty() && script.file.is_none() {
        ui.weak("Begin with a template, or open a plugin of your own or an example.");
    }
    Panel::bottom("script output")
        .resizable(true)
        .default_size(theme::OUTPUT_HEIGHT)
        .show(ui, |ui| footer(ui, reading));
    if let Some(text) = code::show(ui, script, wanted) {
        asked = Some(ScriptChange::Type(text));
    }
    if ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Enter)) {
        asked = Some(ScriptChange::Run);
    }
    actions.extend(asked.map(Action::Script));
}

fn toolbar(ui: &mut Ui, reading: &Reading<'_>, asked: &mut Option<ScriptChange>) {
    let script = reading.script;
    let menu = ui.menu_button("New plugin", |ui| {
        for kind in PluginKind::ALL {
            if ui.button(super::plugin::kind_in_words(*kind)).clicked() {
                *asked = Some(ScriptChange::New(*kind));
            }
        }
    });
    name_it(ui, &menu.response, "New plugin");
    let menu = ui.menu_button("Open", |ui| {
        for entry in reading.library.entries() {
            if let Origin::File(path) = &entry.origin
                && ui.button(visible::one_line(&entry.origin.in_short())).clicked()
            {
                *asked = Some(ScriptChange::Open(path.clone()));
            }
        }
        ui.separator();
        ui.weak("Examples, to be read and copied");
        for shipped in SHIPPED {
            if ui.button(shipped.name).clicked() {
                *asked = Some(ScriptChange::Example(shipped.name));
            }
        }
    });
    name_it(ui, &menu.response, "Open a script");
    let mut button = |ui: &mut Ui, enabled: bool, text: &str, name: &str, help: &str, change: ScriptChange| {
        let button = ui.add_enabled(enabled, Button::new(text));
        name_it(ui, &button, name);
        if button.on_hover_text(help).clicked() {
            *asked = Some(change);
        }
    };
    let has_text = !script.text.is_empty();
    if script.example.is_some() {
        button(ui, true, "Copy", "Copy the example", "Write on from it.", ScriptChange::Copy);
    } else {
        button(ui, script.is_modified(), "Save", "Save the script", "Write its file.", ScriptChange::Save);
        button(ui, has_text, "Save as…", "Save the script as", "Write it under another name.", ScriptChange::SaveAs);
    }
    let run = format!("{} Run", icon::PLAY);
    button(
        ui,
        has_text && !script.runs,
        &run,
        "Run the script",
        "Run it on the open scene (Ctrl+Enter).",
        ScriptChange::Run,
    );
    let mark = if script.is_modified() { "• " } else { "" };
    ui.add(Label::new(RichText::new(visible::one_line(&format!("{mark}{}", script.title()))).weak()).truncate());
}

/// What is wrong, and what the last run said.
fn footer(ui: &mut Ui, reading: &Reading<'_>) {
    let script = reading.script;
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        if let Some(error) = &script.fault {
            fault(ui, error);
        }
        if let Some(usage) = ui.data(|data| data.get_temp::<String>(code::usage_id())).filter(|told| !told.is_empty()) {
            ui.add(Label::new(RichText::new(usage).weak()).wrap());
        }
        if script.runs {
            ui.weak("running…");
        }
        for line in &script.output {
            ui.label(RichText::new(visible::one_line(line)).monospace().size(theme::SMALL_TEXT));
        }
    });
}

fn fault(ui: &mut Ui, error: &ScriptError) {
    let text = RichText::new(visible::lines(&error.to_string())).color(theme::error(ui));
    ui.add(Label::new(text).wrap());
}
