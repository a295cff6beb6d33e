//! Windows that come up over the editor: unsaved changes, problems of a file, a path where no dialog can be shown.

use super::Editor;
use super::file_flow::Intent;
use super::files::Ask;
use crate::opening;
use crate::theme;
use cloudwright_core::problem::Problem;
use egui::{Id, Key, Modal, RichText, ScrollArea, TextEdit, Ui};
use std::path::{Path, PathBuf};

/// What is shown; at most one at a time, in this order.
#[derive(Debug, Default)]
pub(super) struct Dialogs {
    pub(super) unsaved: Option<Intent>,
    path: Option<(Ask, String)>,
    trouble: Option<Trouble>,
}

#[derive(Debug)]
struct Trouble {
    title: String,
    problems: Vec<Problem>,
}

enum Choice {
    Save,
    Discard,
    Cancel,
}

impl Dialogs {
    pub(super) fn is_open(&self) -> bool {
        self.unsaved.is_some() || self.path.is_some() || self.trouble.is_some()
    }

    /// Lists what is wrong with a file.
    pub(super) fn list(&mut self, path: &Path, problems: Vec<Problem>) {
        self.trouble = Some(Trouble { title: format!("Problems in {}", path.display()), problems });
    }

    /// Tells that something failed.
    pub(super) fn fail(&mut self, title: &str, error: &dyn std::error::Error) {
        let problem = Problem::error("", error.to_string(), "");
        self.trouble = Some(Trouble { title: title.into(), problems: vec![problem] });
    }

    /// Asks for a path by hand.
    pub(super) fn ask_path(&mut self, ask: Ask) {
        let start = match &ask {
            Ask::Open => String::new(),
            Ask::Save(path) => path.display().to_string(),
        };
        self.path = Some((ask, start));
    }
}

impl Editor {
    pub(super) fn show_dialogs(&mut self, context: &egui::Context) {
        if let Some(intent) = self.dialogs.unsaved {
            match ask_unsaved(context, &self.display_name()) {
                Some(Choice::Save) => {
                    self.dialogs.unsaved = None;
                    self.save_and_go(intent, context);
                }
                Some(Choice::Discard) => {
                    self.dialogs.unsaved = None;
                    self.go(intent, context);
                }
                Some(Choice::Cancel) => self.dialogs.unsaved = None,
                None => {}
            }
        } else if let Some((ask, text)) = &mut self.dialogs.path {
            let ask = ask.clone();
            match ask_path(context, &ask, text) {
                Some(Some(path)) => {
                    self.dialogs.path = None;
                    self.use_path(&ask, path, context);
                }
                Some(None) => {
                    self.dialogs.path = None;
                    self.after_save = None;
                }
                None => {}
            }
        } else if let Some(trouble) = &self.dialogs.trouble
            && show_trouble(context, trouble)
        {
            self.dialogs.trouble = None;
        }
    }
}

fn ask_unsaved(context: &egui::Context, name: &str) -> Option<Choice> {
    let modal = Modal::new(Id::unique("unsaved")).frame(theme::dialog(context)).show(context, |ui| {
        ui.set_width(theme::DIALOG_WIDTH);
        ui.heading("Save the changes?");
        ui.add_space(theme::GAP);
        ui.label(format!("{name} has changes that are not saved. They are lost without saving."));
        buttons(ui, |ui| {
            let save = ui.button("Save").clicked().then_some(Choice::Save);
            let discard = ui.button("Don't save").clicked().then_some(Choice::Discard);
            let cancel = ui.button("Cancel").clicked().then_some(Choice::Cancel);
            save.or(discard).or(cancel)
        })
    });
    let closed = modal.should_close();
    modal.inner.or(closed.then_some(Choice::Cancel))
}

/// Some(None) if the user changed their mind.
fn ask_path(context: &egui::Context, ask: &Ask, text: &mut String) -> Option<Option<PathBuf>> {
    let (title, verb) = match ask {
        Ask::Open => ("Open scene", "Open"),
        Ask::Save(_) => ("Save scene as", "Save"),
    };
    let modal = Modal::new(Id::unique("path")).frame(theme::dialog(context)).show(context, |ui| {
        ui.set_width(theme::DIALOG_WIDTH);
        ui.heading(title);
        ui.add_space(theme::GAP);
        ui.label("This desktop shows no file dialog (it has no portal and no zenity).");
        let label = ui.label("Path of the file");
        let field = ui.add(TextEdit::singleline(text).desired_width(f32::INFINITY)).labelled_by(label.id);
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        // Typing can begin at once.
        if ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        let path = (!text.trim().is_empty()).then(|| PathBuf::from(text.trim()));
        let done = buttons(ui, |ui| {
            let go = ui.add_enabled(path.is_some(), egui::Button::new(verb)).clicked();
            let cancel = ui.button("Cancel").clicked();
            if go { Some(path.clone()) } else { cancel.then_some(None) }
        });
        done.or((entered && path.is_some()).then_some(path))
    });
    let closed = modal.should_close();
    modal.inner.or(closed.then_some(None))
}

/// Whether it was closed.
fn show_trouble(context: &egui::Context, trouble: &Trouble) -> bool {
    let modal = Modal::new(Id::unique("trouble")).frame(theme::dialog(context)).show(context, |ui| {
        ui.set_width(theme::WIDE_DIALOG_WIDTH);
        ui.heading(&trouble.title);
        ui.add_space(theme::GAP);
        ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).show(ui, |ui| {
            for problem in &trouble.problems {
                show_problem(ui, problem);
            }
        });
        buttons(ui, |ui| ui.button("Close").clicked().then_some(())).is_some()
    });
    modal.inner || modal.should_close()
}

fn show_problem(ui: &mut Ui, problem: &Problem) {
    if !problem.place.is_empty() {
        let mark = opening::severity_name(problem);
        ui.label(RichText::new(format!("{mark} at {}", problem.place)).monospace().color(theme::error(ui)));
    }
    ui.label(&problem.message);
    if !problem.hint.is_empty() {
        ui.weak(&problem.hint);
    }
    ui.add_space(theme::GAP);
}

fn buttons<T>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> T) -> T {
    ui.add_space(theme::GAP);
    ui.horizontal(add).inner
}
