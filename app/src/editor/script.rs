//! The script that is being written: read and checked off the frame, saved, watched, and run on the open scene.
//!
//! What would lose text is asked about first, and carried out when it is saved or given up.

use super::dialogs::Dialog;
use super::done::Done;
use super::files::Ask;
use super::intent::{Intent, Then};
use super::{Editor, plugins::ScriptRun};
use crate::plugins::{self, Origin};
use crate::state::{Script, ScriptChange};
use crate::storage::{self, Folder, Over, Sighting, Stamp, StorageError, Watcher};
use crate::worker::Latest;
use cloudwright_scripts::{Plugin, ScriptError, shipped};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What was checked, and what it is.
type Checked = (String, Result<Arc<Plugin>, ScriptError>);

/// The script, and the threads that look after it.
pub(super) struct Writing {
    pub(super) script: Script,
    /// None where the system gives no thread.
    checker: Option<Latest<String, Checked>>,
    watcher: Option<Watcher<Stamp>>,
    /// What the text is, if that is known.
    plugin: Option<Arc<Plugin>>,
    /// It is to run as soon as it is known what it is.
    run_wanted: bool,
    pub(super) run: Option<ScriptRun>,
    /// What is to follow when it is saved.
    after_save: Option<Then>,
}

impl Writing {
    pub(super) fn new(context: &egui::Context) -> Self {
        let [for_checker, for_watcher] = [context.clone(), context.clone()];
        let check = |text: String| {
            let read = Plugin::read(&text).map(Arc::new);
            (text, read)
        };
        Self {
            script: Script::default(),
            checker: Latest::start("script check", check, move || for_checker.request_repaint()).ok(),
            watcher: Watcher::start(Stamp::of, move || for_watcher.request_repaint()).ok(),
            plugin: None,
            run_wanted: false,
            run: None,
            after_save: None,
        }
    }

    fn replace(&mut self, script: Script) {
        self.script = script;
        self.run = None;
        self.run_wanted = false;
        self.check();
    }

    /// Has the text checked; what it was before is forgotten.
    fn check(&mut self) {
        self.plugin = None;
        self.script.fault = None;
        if let Some(checker) = self.checker.as_ref().filter(|_| !self.script.text.is_empty()) {
            checker.ask(self.script.text.clone());
        }
    }

    /// What it may be called: after its plugin, in small letters.
    fn file_name(&self) -> String {
        let name = self.plugin.as_ref().map_or("new plugin", |plugin| plugin.description.name.as_str());
        let letter = |c: char| if c.is_alphanumeric() { c.to_lowercase().next().unwrap_or(c) } else { '_' };
        format!("{}.{}", name.chars().map(letter).collect::<String>(), plugins::EXTENSION)
    }

    /// Where its plugin is from.
    fn origin(&self) -> Origin {
        match self.script.example {
            Some(name) => Origin::Shipped(name),
            None => Origin::File(self.script.file.clone().unwrap_or_else(|| PathBuf::from("new.rhai"))),
        }
    }
}

impl Editor {
    /// Once a frame.
    pub(super) fn keep_script(&mut self, context: &egui::Context) {
        let writing = &mut self.writing;
        if let Some((text, read)) = writing.checker.as_ref().and_then(Latest::newest)
            && text == writing.script.text
        {
            match read {
                Ok(plugin) => writing.plugin = Some(plugin),
                Err(error) => {
                    writing.run_wanted = false;
                    writing.script.fault = Some(error);
                }
            }
        }
        let focused = context.input(|input| input.focused);
        if let Some(watcher) = &writing.watcher {
            let file = writing.script.file.as_deref().filter(|_| focused && !writing.script.changed_on_disk);
            watcher.watch(file.map(|file| (file, writing.script.known.as_ref())));
            if let Some(Sighting { path, stamp: Some(stamp) }) = watcher.news()
                && writing.script.file.as_ref() == Some(&path)
            {
                writing.script.known = Some(stamp);
                if writing.script.is_modified() {
                    writing.script.changed_on_disk = true;
                } else {
                    self.open_script(path);
                }
            }
        }
        if self.writing.run_wanted
            && let Some(plugin) = self.writing.plugin.clone()
        {
            self.writing.run_wanted = false;
            self.begin_script(&self.writing.origin(), plugin, context);
        }
        self.keep_script_run(context);
    }

    /// Does what the panel asked for, after a question if text would be lost.
    pub(super) fn change_script(&mut self, change: ScriptChange, context: &egui::Context) {
        use ScriptChange as Change;
        let loses = matches!(change, Change::New(_) | Change::Example(_) | Change::Open(_));
        if loses && self.writing.script.is_modified() {
            return self.dialogs.open(Dialog::UnsavedScript(Then::Change(change)));
        }
        let writing = &mut self.writing;
        match change {
            Change::Type(text) => {
                writing.script.text = text;
                writing.check();
            }
            Change::New(kind) => {
                let text = plugins::template(kind).into();
                writing.replace(Script { text, saved: plugins::template(kind).into(), ..Script::default() });
            }
            Change::Example(name) => {
                let text = shipped::named(name).map_or("", |shipped| shipped.source).into();
                writing.replace(Script { text, example: Some(name), ..Script::default() });
            }
            Change::Copy => {
                let text = std::mem::take(&mut writing.script.text);
                writing.replace(Script { text, ..Script::default() });
            }
            Change::Open(path) => self.open_script(path),
            Change::Reload => {
                if let Some(path) = writing.script.file.clone() {
                    self.open_script(path);
                }
            }
            Change::Save => self.save_script(context),
            Change::SaveAs => self.ask_script_name(context),
            // What is no plugin says so already.
            Change::Run => writing.run_wanted = writing.plugin.is_some() || writing.script.fault.is_none(),
        }
        context.request_repaint();
    }

    fn open_script(&mut self, path: PathBuf) {
        self.disk.file_jobs.ask(move || {
            let stamp = Stamp::of(&path);
            Done::ScriptRead { outcome: plugins::source(&path), path, stamp }
        });
    }

    pub(super) fn script_read(
        &mut self,
        path: &Path,
        stamp: Option<Stamp>,
        outcome: Result<String, plugins::ReadError>,
    ) {
        match outcome {
            Ok(text) => self.writing.replace(Script::of_file(path, text, stamp)),
            Err(error) => self.tell_error(format!("The script can't be read: {error}")),
        }
    }

    fn save_script(&mut self, context: &egui::Context) {
        match self.writing.script.file.clone() {
            Some(path) => {
                let over = self.writing.script.known.map_or(Over::Nothing, Over::Known);
                self.save_script_to(path, over);
            }
            None => self.ask_script_name(context),
        }
    }

    fn ask_script_name(&mut self, context: &egui::Context) {
        let folder = self.disk.folders().map(storage::Folders::plugins).unwrap_or_default();
        let start = self.writing.script.file.clone().unwrap_or_else(|| folder.join(self.writing.file_name()));
        self.ask(Ask::SaveScript(start), context);
    }

    /// Under a name that the user gave. Who chose it in a native dialog was asked there about a file that has it.
    pub(super) fn save_script_under(&mut self, given: &Path, asked_already: bool) {
        let path =
            if given.extension().is_some() { given.to_path_buf() } else { given.with_extension(plugins::EXTENSION) };
        let over = if asked_already && path == given { Over::Anything } else { Over::Nothing };
        self.save_script_to(path, over);
    }

    fn save_script_to(&mut self, path: PathBuf, over: Over) {
        let text = self.writing.script.text.clone();
        self.disk.file_jobs.ask(move || {
            let write = || {
                // The folder of plugins is made with the first one.
                let _folder = Folder::make(path.parent().unwrap_or(Path::new("")))?;
                storage::write_over(&path, text.as_bytes(), over)
            };
            let outcome = write();
            Done::ScriptSaved { path, text, outcome }
        });
    }

    pub(super) fn script_saved(
        &mut self,
        path: PathBuf,
        text: String,
        outcome: Result<Stamp, StorageError>,
        context: &egui::Context,
    ) {
        match outcome {
            Ok(stamp) => {
                self.tell(format!("Saved {}", path.display()));
                let script = &mut self.writing.script;
                (script.file, script.saved, script.known) = (Some(path), text, Some(stamp));
                script.changed_on_disk = false;
                if let Some(then) = self.writing.after_save.take() {
                    self.after_script(then, context);
                }
            }
            Err(error) => {
                self.writing.after_save = None;
                self.dialogs.fail("The script can't be saved", &error);
            }
        }
    }

    /// The user changed their mind about a name: what waited for it does not come.
    pub(super) fn give_up_what_follows(&mut self) {
        self.after_save = None;
        self.writing.after_save = None;
    }

    /// Saves first, then goes on.
    pub(super) fn save_script_and(&mut self, then: Then, context: &egui::Context) {
        self.writing.after_save = Some(then);
        self.save_script(context);
    }

    /// Goes on, whatever is lost.
    pub(super) fn after_script(&mut self, then: Then, context: &egui::Context) {
        self.writing.script.saved.clone_from(&self.writing.script.text);
        match then {
            Then::Change(change) => self.change_script(change, context),
            Then::Quit => self.want(Intent::Quit, context),
        }
    }
}
