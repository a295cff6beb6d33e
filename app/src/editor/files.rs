//! Asking for a file name, off the frame: a trait, so that tests can answer.
//!
//! The native dialog needs a desktop portal or zenity. Where there is neither it answers "cancelled" at once; the
//! editor then asks for the path in a window of its own.

use crate::plugins;
use crate::state::Item;
use crate::storage::Over;
use cloudwright_core::exchange::FORMATS;
use cloudwright_core::formats::scene_file::EXTENSION;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// What the name is wanted for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ask {
    /// Of a scene to open, with the file that the dialog begins beside; none if it is empty.
    Open(PathBuf),
    /// Of a scene to save, with the name to start from.
    Save(PathBuf),
    /// Of a script to save, with the name to start from.
    SaveScript(PathBuf),
    /// Of what an exporter made, with the name to start from.
    Export(PathBuf),
    /// Of a file of another program's to write, with the name to start from.
    Leave(PathBuf),
    /// Of a picture to draw into, with the name to start from.
    Picture(PathBuf),
    /// Of a video to make, with the name to start from.
    Video(PathBuf),
    /// Of a folder for a film's frames, with the file that it begins beside.
    Frames(PathBuf),
    /// Of a report of a problem, with the name to start from.
    Report(PathBuf),
    /// Of a scene to take clouds out of, with the file that the dialog begins beside.
    Append(PathBuf),
    /// Of a file of another program's to read, with the file that the dialog begins beside.
    Arrive(PathBuf),
    /// Of the model of that aircraft or prop, which lies beside the scene's file.
    Model(Item, PathBuf),
}

/// What came back.
#[derive(Debug, PartialEq, Eq)]
pub enum Reply {
    /// A name.
    Path(PathBuf),
    /// The user changed their mind.
    Cancelled,
    /// No dialog could be shown.
    NoDialog,
}

/// Asks the user for file names.
pub trait FileDialogs {
    /// Shows a dialog and returns at once; the answer is sent, and then `wake` called.
    fn ask(&mut self, ask: &Ask, answer: Sender<Reply>, wake: Box<dyn FnOnce() + Send>);
}

/// The system's own dialogs.
#[derive(Debug, Default)]
pub struct NativeDialogs;

/// Nobody reads and cancels a dialog faster than this.
const TOO_FAST_FOR_A_PERSON: Duration = Duration::from_millis(250);

impl FileDialogs for NativeDialogs {
    fn ask(&mut self, ask: &Ask, answer: Sender<Reply>, wake: Box<dyn FnOnce() + Send>) {
        let dialog = rfd::AsyncFileDialog::new();
        let dialog = match ask {
            Ask::Model(..) => dialog.add_filter("glTF models", &["glb"]),
            Ask::Open(_) | Ask::Append(_) | Ask::Save(_) => dialog.add_filter("Cloudwright scenes", &[EXTENSION]),
            Ask::SaveScript(_) => dialog.add_filter("Plugins", &[plugins::EXTENSION]),
            // Of the ending that the name has; a user may give another.
            Ask::Arrive(_) => {
                let mut endings: Vec<&str> =
                    FORMATS.iter().filter(|each| each.is_read()).flat_map(|each| each.endings).copied().collect();
                endings.dedup();
                dialog.add_filter("What other programs make", &endings)
            }
            Ask::Frames(_) => dialog,
            Ask::Export(start) | Ask::Leave(start) | Ask::Picture(start) | Ask::Video(start) | Ask::Report(start) => {
                match start.extension().and_then(|ending| ending.to_str()) {
                    Some(ending) => dialog.add_filter(format!("{} files", ending.to_uppercase()), &[ending]),
                    None => dialog,
                }
            }
        };
        let asked = Instant::now();
        // Made on this thread, as macOS wants it, and waited for on another.
        let file: std::pin::Pin<Box<dyn Future<Output = Option<rfd::FileHandle>> + Send>> = match ask {
            Ask::Open(scene) => Box::pin(beside(scene, dialog).set_title("Open scene").pick_file()),
            Ask::Append(scene) => Box::pin(beside(scene, dialog).set_title("Append from scene").pick_file()),
            Ask::Arrive(scene) => Box::pin(beside(scene, dialog).set_title("Import").pick_file()),
            Ask::Save(start)
            | Ask::Export(start)
            | Ask::Leave(start)
            | Ask::Picture(start)
            | Ask::Video(start)
            | Ask::Report(start)
            | Ask::SaveScript(start) => {
                let name = start.file_name().unwrap_or_default().to_string_lossy().into_owned();
                let title = match ask {
                    Ask::Export(_) | Ask::Leave(_) => "Export as",
                    Ask::SaveScript(_) => "Save script as",
                    Ask::Picture(_) => "Render picture to",
                    Ask::Video(_) => "Render flight to",
                    Ask::Report(_) => "Save report as",
                    _ => "Save scene as",
                };
                let dialog = dialog.set_title(title).set_file_name(name);
                Box::pin(beside(start, dialog).save_file())
            }
            Ask::Frames(scene) => Box::pin(beside(scene, dialog).set_title("Folder for the frames").pick_folder()),
            Ask::Model(_, scene) => Box::pin(beside(scene, dialog).set_title("Choose model").pick_file()),
        };
        std::thread::spawn(move || {
            let reply = match pollster::block_on(file) {
                Some(file) => Reply::Path(file.path().into()),
                None if asked.elapsed() < TOO_FAST_FOR_A_PERSON => Reply::NoDialog,
                None => Reply::Cancelled,
            };
            let _ = answer.send(reply);
            wake();
        });
    }
}

/// A dialog that begins in the folder of `file`.
fn beside(file: &Path, dialog: rfd::AsyncFileDialog) -> rfd::AsyncFileDialog {
    match file.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        Some(folder) => dialog.set_directory(folder),
        None => dialog,
    }
}

/// A question that waits for its answer.
#[derive(Debug)]
pub(crate) struct Waiting {
    pub(crate) ask: Ask,
    answer: Receiver<Reply>,
}

impl Waiting {
    pub(crate) fn start(dialogs: &mut dyn FileDialogs, ask: Ask, context: &egui::Context) -> Self {
        let (sender, answer) = channel();
        let context = context.clone();
        dialogs.ask(&ask, sender, Box::new(move || context.request_repaint()));
        Self { ask, answer }
    }

    /// The answer, once.
    pub(crate) fn answered(&self) -> Option<Reply> {
        use std::sync::mpsc::TryRecvError;
        match self.answer.try_recv() {
            Ok(reply) => Some(reply),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Reply::NoDialog),
        }
    }
}

/// `path` with the ending of scene files, unless it has one.
pub(crate) fn with_extension(path: PathBuf) -> PathBuf {
    if path.extension().is_some() { path } else { path.with_extension(EXTENSION) }
}

/// What may be replaced at `to`, for a name that was `given`. Who chose it in a native dialog was asked there about a file
/// that has it, and so about those beside it.
pub(crate) fn over(given: &Path, to: &Path, asked_already: bool) -> Over {
    if asked_already && to == given && to.exists() { Over::Anything } else { Over::Nothing }
}
