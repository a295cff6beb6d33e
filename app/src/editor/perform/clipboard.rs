//! Cut, copy and paste: parts of the scene as text on the system's clipboard, keys of the timeline too.
//!
//! What a text is, it says itself ([`scene_clip`]), so it is pasted as that wherever the pointer is. What is no part of a
//! scene changes nothing and is told.

use crate::command::{Command, Pasted};
use crate::editor::Editor;
use crate::opening::{self, Elsewhere};
use crate::state::Item;
use crate::storage;
use crate::units::counted;
use cloudwright_core::arrange::clip::{self, Clip, Holds};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::formats::{model_glb, scene_clip};
use egui::{Event, Id, ViewportCommand};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

impl Editor {
    /// Whether the selection is something that can stand on the clipboard.
    pub(super) fn can_copy(&self) -> bool {
        let scene = self.session.scene();
        match self.view.selection.primary() {
            Some(Item::Box(..)) => true,
            Some(_) => self.view.selection.items().iter().any(|item| item.listed(scene).is_some()),
            None => false,
        }
    }

    /// The selected boxes of the primary's model; or all that stands in lists of the scene.
    fn clip(&self) -> Option<Clip> {
        let (scene, selection) = (self.session.scene(), &self.view.selection);
        match selection.primary()? {
            Item::Box(model, _) => clip::boxes(scene, model, &super::arrange::boxes_of(selection, model)),
            _ => clip::things(scene, selection.items()),
        }
    }

    pub(super) fn copy(&mut self, context: &egui::Context) {
        if let Some(clip) = self.clip()
            && self.put_on_clipboard(&clip, context)
        {
            self.tell(format!("Copied {}", told(&clip)));
        }
    }

    pub(super) fn cut(&mut self, context: &egui::Context) {
        if let Some(clip) = self.clip()
            && self.put_on_clipboard(&clip, context)
        {
            self.take_out(Command::Cut);
        }
    }

    pub(super) fn copy_keys(&mut self, context: &egui::Context) {
        if let Some(clip) = clip::keys(self.session.scene(), &self.keys_at_work()) {
            self.put_on_clipboard(&clip, context);
        }
    }

    pub(super) fn cut_keys(&mut self, context: &egui::Context) {
        let chosen = self.keys_at_work();
        if let Some(clip) = clip::keys(self.session.scene(), &chosen)
            && self.put_on_clipboard(&clip, context)
        {
            let rekeyed = cloudwright_core::arrange::keys::deleted(&self.session.scene().tracks, &chosen);
            self.rekey(Command::CutKeys, rekeyed);
        }
    }

    fn put_on_clipboard(&mut self, clip: &Clip, context: &egui::Context) -> bool {
        match scene_clip::write(clip) {
            Ok(text) => {
                let names = opening::models_of(&clip.scene);
                let lie = names.into_iter().filter_map(|name| Some((name.clone(), self.scene_file_by(&name)?)));
                self.copied_from = Some((text.clone(), lie.collect()));
                context.copy_text(text);
            }
            Err(error) => {
                self.tell_error(format!("Nothing was copied: {error}"));
                return false;
            }
        }
        true
    }

    /// What is on the clipboard comes as an event, as if its keys had been pressed.
    pub(super) fn ask_clipboard(context: &egui::Context) {
        context.send_viewport_cmd(ViewportCommand::RequestPaste);
        let frame = context.cumulative_frame_nr();
        context.data_mut(|data| data.insert_temp(asked_in_frame(), frame));
    }

    /// Of an empty clipboard no event comes.
    pub(super) fn tell_empty_clipboard(&mut self, context: &egui::Context) {
        let Some(frame) = context.data(|data| data.get_temp::<u64>(asked_in_frame())) else { return };
        let is_pasted = |event: &Event| matches!(event, Event::Paste(_) | Event::PasteImage(_));
        let came = context.input(|input| input.events.iter().any(is_pasted));
        if !came && context.cumulative_frame_nr() <= frame + 1 {
            return context.request_repaint();
        }
        context.data_mut(|data| data.remove::<u64>(asked_in_frame()));
        if !came {
            self.tell_error("Nothing was pasted: the clipboard is empty");
        }
    }

    pub(super) fn paste(&mut self, pasted: Pasted) {
        let text = match pasted {
            Pasted::Text(text) => text,
            Pasted::Picture => {
                return self.tell_error(
                    "Nothing was pasted: a picture is on the clipboard. Copy clouds, boxes, cameras or keys first",
                );
            }
        };
        let clip = match scene_clip::read(&text) {
            Ok(clip) => clip,
            Err(problem) => return self.tell_error(format!("Nothing was pasted. {}", said(&problem))),
        };
        if clip.holds == Holds::Keys {
            return self.paste_keys(&clip.scene.tracks);
        }
        let scene = self.session.scene();
        let model = self.view.selection.model(scene).map(|model| model.id);
        let arrangement = match clip::pasted(scene, &clip, model) {
            Ok(arrangement) => arrangement,
            Err(refusal) => return self.tell_error(refusal.to_string()),
        };
        let names = opening::models_of(&clip.scene);
        let copied = self.copied_from.as_ref().filter(|(copied, _)| *copied == text);
        let from = copied.map(|(_, from)| from.clone()).unwrap_or_default();
        let others = from.iter().filter(|(name, from)| self.is_another(name, from)).map(|(name, _)| name.clone());
        let others: Vec<String> = others.collect();
        self.session.expect_elsewhere(from.clone());
        let what = what_is_new(&arrangement.edits);
        if !self.arrange_as(&format!("{} {what}", Command::Paste.row().label()), arrangement) {
            return;
        }
        self.tell(format!("Pasted {what}"));
        for name in others {
            let which = "is another file than the one that was copied: this scene's is shown";
            self.tell_error(format!("“{name}” beside this scene {which}"));
        }
        self.tell_missing_models(&names, &from);
    }

    /// The scene file that a model of this scene lies beside, or should.
    fn scene_file_by(&self, name: &str) -> Option<PathBuf> {
        let file = self.session.path();
        let is_there = file.is_some_and(|file| storage::is_there(&file.with_file_name(name)));
        let elsewhere = self.session.elsewhere().get(name).filter(|_| !is_there);
        elsewhere.cloned().or_else(|| file.map(PathBuf::from))
    }

    /// Whether both files of that name are there, beside this scene and beside `other`, and are not the same.
    fn is_another(&self, name: &str, other: &Path) -> bool {
        let Some(mine) = self.scene_file_by(name) else { return false };
        let read = |scene: &Path| storage::read(&scene.with_file_name(name), model_glb::MAX_BYTES).ok();
        mine.as_path() != other && read(&mine).zip(read(other)).is_some_and(|(mine, other)| mine != other)
    }

    /// Which files of pasted props and aircraft don't lie beside this scene, and where they did beside the other. Those
    /// that are there are copied when the scene is saved.
    fn tell_missing_models(&mut self, names: &BTreeSet<String>, from: &Elsewhere) {
        if names.is_empty() {
            return;
        }
        self.session.load_beside();
        for name in names {
            if let Some(problem) = self.session.beside().fault(name).cloned() {
                let folder = from.get(name).and_then(|file| file.parent());
                let was =
                    folder.map_or_else(String::new, |folder| format!(". It was copied from {}", folder.display()));
                self.tell_error(format!("{} ({}){was}", problem.message, problem.hint));
            }
        }
    }
}

fn asked_in_frame() -> Id {
    Id::unique("clipboard was asked")
}

/// Place, fault and what to do.
fn said(problem: &cloudwright_core::problem::Problem) -> String {
    let place = if problem.place.is_empty() { String::new() } else { format!("At {}: ", problem.place) };
    format!("{place}{} ({})", problem.message, problem.hint)
}

/// What a clip holds: "2 clouds and 1 model".
fn told(clip: &Clip) -> String {
    let scene = &clip.scene;
    if clip.holds == Holds::Boxes {
        return in_words([0, 0, 0, 0, 0, 0, 0, scene.models.iter().map(|model| model.boxes.len()).sum()]);
    }
    in_words([
        scene.clouds.len(),
        scene.folders.len(),
        scene.models.len(),
        scene.cameras.len(),
        scene.paths.len(),
        scene.aircraft.len(),
        scene.props.len(),
        0,
    ])
}

/// What edits bring into the scene. Models that are there already are shared and don't count.
fn what_is_new(edits: &[Edit]) -> String {
    let mut counts = [0; WORDS.len()];
    for edit in edits {
        let kind = match edit {
            Edit::Cloud(ListEdit::Insert { .. }) => 0,
            Edit::Folder(ListEdit::Insert { .. }) => 1,
            Edit::Model(ListEdit::Insert { .. }) => 2,
            Edit::Camera(ListEdit::Insert { .. }) => 3,
            Edit::Path(ListEdit::Insert { .. }) => 4,
            Edit::Aircraft(ListEdit::Insert { .. }) => 5,
            Edit::Prop(ListEdit::Insert { .. }) => 6,
            Edit::Box(_, ListEdit::Insert { .. }) => 7,
            _ => continue,
        };
        counts[kind] += 1;
    }
    in_words(counts)
}

/// One and several of each kind.
const WORDS: [[&str; 2]; 8] = [
    ["cloud", "clouds"],
    ["folder", "folders"],
    ["model", "models"],
    ["camera", "cameras"],
    ["path", "paths"],
    ["aircraft", "aircraft"],
    ["prop", "props"],
    ["box", "boxes"],
];

fn in_words(counts: [usize; WORDS.len()]) -> String {
    let there = counts.into_iter().zip(WORDS).filter(|(count, _)| *count > 0);
    let mut words: Vec<String> = there.map(|(count, [one, many])| counted(count, one, many)).collect();
    match words.pop() {
        Some(last) if words.is_empty() => last,
        Some(last) => format!("{} and {last}", words.join(", ")),
        None => String::new(),
    }
}
