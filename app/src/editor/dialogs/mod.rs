//! Windows that come up over the editor: questions, lists, and a path where no dialog can be shown.
//!
//! The one that came last is on top and is answered first. Each file shows one kind and returns the answer; what
//! follows from it stands here.

mod about;
mod append;
mod folder;
mod layouts;
mod new_scene;
mod path;
mod preferences;
mod preset;
mod question;
mod recent;
mod recovery;
mod rename;
mod report;
mod trouble;

pub(super) use layouts::LONGEST_NAME;
pub(super) use report::Report;

use super::Editor;
use super::files::Ask;
use super::intent::{Intent, Then};
use crate::storage::{Orphan, Over};
use crate::theme;
use crate::visible;
use crate::widget::fitted;
pub(super) use append::Append;
use cloudwright_core::problem::Problem;
use egui::{Align2, Id, Modal, Ui};
use layouts::Choice;
use question::Question;
use recovery::Fate;
pub(super) use rename::Rename;
use std::mem::discriminant;
use std::path::{Path, PathBuf};
use trouble::Trouble;

/// One window.
#[derive(Debug)]
pub(super) enum Dialog {
    /// Skies for a new scene to begin with, and whether the first of them has got the focus.
    New { has_focus: bool },
    /// This would lose changes.
    Unsaved(Intent),
    /// This would lose what was written of a script.
    UnsavedScript(Then),
    /// Whether to go back to the saved scene.
    Revert,
    /// A file that is not known stands where the scene is to be saved.
    InTheWay { path: PathBuf, reason: String },
    /// Another program changed the file of a modified document.
    ChangedOnDisk,
    /// Scenes that were open, and whether they are still there.
    Recent(Vec<(PathBuf, bool)>),
    /// What other editors left.
    Recovery(Vec<Orphan>),
    /// Ready-made clouds to choose from.
    Preset,
    /// Recent scenes, and skies to begin with.
    StartPage(Vec<PathBuf>),
    /// What the user prefers.
    Preferences,
    /// The name for a layout of the panels.
    LayoutName(String),
    /// Layouts to choose from.
    Layouts,
    /// What is told of a problem.
    Report(Report),
    /// What this is.
    About,
    /// Clouds of another scene to choose from.
    Append(Append),
    /// A folder for the selected clouds to go into.
    IntoFolder,
    /// Names for many things at once.
    Rename(Rename),
    /// A path to be typed.
    Path { ask: Ask, text: String },
    /// Something went wrong.
    Trouble(Trouble),
}

/// All that are open, the top one last.
#[derive(Debug, Default)]
pub(super) struct Dialogs(Vec<Dialog>);

impl Dialogs {
    pub(super) fn is_open(&self) -> bool {
        !self.0.is_empty()
    }

    /// Puts `dialog` on top, in place of one of its kind; a list of troubles replaces none.
    pub(super) fn open(&mut self, dialog: Dialog) {
        let is_trouble = matches!(dialog, Dialog::Trouble(_));
        self.0.retain(|old| is_trouble || discriminant(old) != discriminant(&dialog));
        self.0.push(dialog);
    }

    /// Those are the recent scenes, if the start page is still there to show them.
    pub(super) fn tell_recent(&mut self, scenes: Vec<PathBuf>) {
        if let Some(Dialog::StartPage(recent)) = self.0.iter_mut().find(|each| matches!(each, Dialog::StartPage(_))) {
            *recent = scenes;
        }
    }

    /// Who goes on without it needs no answer.
    pub(super) fn leave_start_page(&mut self) {
        self.0.retain(|each| !matches!(each, Dialog::StartPage(_)));
    }

    /// Lists what is wrong with a file, if anything is.
    pub(super) fn list(&mut self, path: &Path, problems: Vec<Problem>) {
        if !problems.is_empty() {
            self.open(Dialog::Trouble(Trouble { title: format!("Problems in {}", path.display()), problems }));
        }
    }

    /// Tells that something failed.
    pub(super) fn fail(&mut self, title: &str, error: &dyn std::error::Error) {
        let problem = Problem::error("", error.to_string(), "");
        self.open(Dialog::Trouble(Trouble { title: title.into(), problems: vec![problem] }));
    }

    /// Asks for a path by hand.
    pub(super) fn ask_path(&mut self, ask: Ask) {
        let text = match &ask {
            Ask::Open(scene) | Ask::Append(scene) | Ask::Arrive(scene) => match scene.parent() {
                Some(folder) => folder.join("").display().to_string(),
                None => String::new(),
            },
            Ask::Save(path)
            | Ask::Export(path)
            | Ask::Leave(path)
            | Ask::Picture(path)
            | Ask::Video(path)
            | Ask::SaveScript(path)
            | Ask::Report(path) => path.display().to_string(),
            Ask::Frames(scene) => scene.with_file_name("frames").display().to_string(),
            Ask::Model(_, scene) => scene.with_file_name("model.glb").display().to_string(),
        };
        self.open(Dialog::Path { ask, text });
    }
}

impl Editor {
    /// Shows the top one. It stays until it is answered.
    pub(super) fn show_dialogs(&mut self, context: &egui::Context) {
        if let Some(mut dialog) = self.dialogs.0.pop()
            && self.answer(&mut dialog, context).is_none()
        {
            self.dialogs.0.push(dialog);
        }
    }

    /// None if it is not answered yet.
    fn answer(&mut self, dialog: &mut Dialog, context: &egui::Context) -> Option<()> {
        let name = self.display_name();
        match dialog {
            Dialog::New { has_focus } => {
                // Before the picture is there, nothing else is drawn.
                let may_draw = self.viewport.picture_time().is_some();
                let thumbnails = may_draw.then_some(self.thumbnails.get_mut());
                if let Some(template) = new_scene::choose(context, thumbnails, has_focus)? {
                    self.want(Intent::Begin(template), context);
                }
            }
            Dialog::Unsaved(intent) => match Question::unsaved(&name).ask(context)? {
                question::FIRST => self.save_and_go(intent.clone(), context),
                question::SECOND => self.go(intent.clone(), context),
                _ => {}
            },
            Dialog::UnsavedScript(then) => {
                let title = self.writing.script.title();
                match Question::unsaved(&title).ask(context)? {
                    question::FIRST => self.save_script_and(then.clone(), context),
                    question::SECOND => self.after_script(then.clone(), context),
                    _ => {}
                }
            }
            Dialog::Revert => {
                if Question::revert(&name).ask(context)? == question::FIRST {
                    self.revert();
                }
            }
            Dialog::InTheWay { path, reason } => match Question::in_the_way(path, reason).ask(context)? {
                question::FIRST => self.save_to(path, Over::Anything, context),
                question::SECOND => self.save_as(context),
                _ => self.after_save = None,
            },
            Dialog::ChangedOnDisk => {
                if Question::changed_on_disk(&name).ask(context)? == question::SECOND {
                    self.load_theirs();
                } else {
                    // The file is no longer what was saved.
                    self.session.mark_unsaved();
                }
            }
            Dialog::Recent(scenes) => {
                if let Some(path) = recent::choose(context, scenes)? {
                    self.want(Intent::OpenFile(path), context);
                }
            }
            Dialog::Recovery(orphans) => match recovery::choose(context, orphans)? {
                Fate::Recover(at) => {
                    let orphan = orphans.remove(at);
                    self.recover(orphan);
                }
                Fate::Discard(at) => {
                    orphans.remove(at).slot.clear();
                    if !orphans.is_empty() {
                        return None;
                    }
                }
                Fate::Later => {}
            },
            Dialog::Preset => {
                let chosen = preset::choose(context, self.thumbnails.get_mut())?;
                if let Some(preset) = chosen {
                    self.add_preset(preset);
                }
            }
            Dialog::StartPage(recent) => self.answer_start_page(recent, context)?,
            Dialog::Preferences => {
                if let Some(preference) = preferences::choose(context, self.disk.settings())? {
                    self.prefer(preference, context);
                    return None;
                }
            }
            Dialog::LayoutName(name) => {
                if let Some(name) = layouts::name(context, name)? {
                    self.save_layout(&name);
                }
            }
            Dialog::Layouts => match layouts::choose(context, self.disk.settings().layouts.keys())? {
                Choice::Use(name) => self.use_layout(&name),
                Choice::Delete(name) => {
                    self.delete_layout(&name);
                    return None;
                }
                Choice::Close => {}
            },
            Dialog::Report(report) => {
                let facts = self.report_facts();
                match report::ask(context, &mut report.said, &mut report.with_scene, &facts)? {
                    report::Answer::Save => self.save_report(report, context),
                    report::Answer::Close => {}
                }
            }
            Dialog::About => about::show(context, &self.facts())?,
            Dialog::Append(append) => {
                if append.choose(context)? {
                    self.append(append);
                }
            }
            Dialog::IntoFolder => {
                match folder::choose(context, self.session.scene(), self.view.selection.clouds().count())? {
                    folder::Choice::Into(id) => self.put_into_folder(Some(id)),
                    folder::Choice::New => self.new_folder(),
                    folder::Choice::Cancel => {}
                }
            }
            Dialog::Rename(rename) => {
                if rename.ask(context, self.session.scene())? {
                    self.rename_many(rename);
                }
            }
            Dialog::Path { ask, text } => match path::ask(context, ask, text)? {
                Some(path) => self.use_path(&ask.clone(), path, false, context),
                None => self.give_up_what_follows(),
            },
            Dialog::Trouble(trouble) => trouble.show(context)?,
        }
        Some(())
    }
}

/// While a file is held over the window.
pub(super) fn show_drop_target(context: &egui::Context) {
    if context.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    egui::Area::new(Id::unique("drop target"))
        .order(egui::Order::Foreground)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(context, |ui| theme::dialog(context).show(ui, |ui| ui.heading("Drop a scene to open it")));
}

/// A window with a heading. `add` returns the answer; closing it another way is `or_closed`.
fn window<T>(
    context: &egui::Context,
    width: f32,
    heading: &str,
    or_closed: T,
    add: impl FnOnce(&mut Ui) -> Option<T>,
) -> Option<T> {
    let modal = Modal::new(Id::unique(heading)).frame(theme::dialog(context)).show(context, |ui| {
        fitted(ui, width, |ui| {
            ui.heading(visible::one_line(heading));
            ui.add_space(theme::GAP);
            add(ui)
        })
    });
    let closed = modal.should_close();
    modal.inner.or(closed.then_some(or_closed))
}

fn buttons<T>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> T) -> T {
    ui.add_space(theme::GAP);
    ui.horizontal(add).inner
}
