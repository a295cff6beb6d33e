//! Cut, copy and paste: parts of the scene as text on the system's clipboard, keys of the timeline too.
//!
//! What a text is, it says itself ([`scene_clip`]), so it is pasted as that wherever the pointer is. What is no part of a
//! scene changes nothing and is told.

use crate::command::{Command, Pasted};
use crate::editor::Editor;
use crate::state::Item;
use cloudwright_core::arrange::clip::{self, Clip, Holds};
use cloudwright_core::formats::scene_clip;
use cloudwright_core::scene::Scene;
use egui::{Event, Id, ViewportCommand};
use std::collections::BTreeSet;
use std::path::Path;

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
                let folder = self.session.path().and_then(Path::parent);
                self.copied_from = folder.map(|folder| (text.clone(), folder.into()));
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
        self.arrange_or_tell(Command::Paste, clip::pasted(scene, &clip, model));
        self.tell_missing_models(&clip.scene, &text);
    }

    /// Which files of pasted props and aircraft don't lie beside this scene, and where they did beside the other.
    fn tell_missing_models(&mut self, pasted: &Scene, text: &str) {
        let flying = pasted.aircraft.iter().filter_map(|aircraft| aircraft.model.as_ref());
        let names: BTreeSet<&String> = flying.chain(pasted.props.iter().map(|prop| &prop.model)).collect();
        if names.is_empty() {
            return;
        }
        let problems = self.session.load_beside();
        let from = self.copied_from.as_ref().filter(|(copied, _)| copied == text).map(|(_, folder)| folder.clone());
        for name in names {
            if let Some(problem) = problems.iter().find(|problem| problem.message.starts_with(&format!("“{name}”")))
            {
                let was = from
                    .as_ref()
                    .map_or_else(String::new, |folder| format!(". It was copied from {}", folder.display()));
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

/// "2 clouds, 1 model".
fn told(clip: &Clip) -> String {
    let scene = &clip.scene;
    if clip.holds == Holds::Boxes {
        return counted(scene.models.iter().map(|model| model.boxes.len()).sum(), "box", "boxes").unwrap_or_default();
    }
    let counts = [
        counted(scene.clouds.len(), "cloud", "clouds"),
        counted(scene.folders.len(), "folder", "folders"),
        counted(scene.models.len(), "model", "models"),
        counted(scene.cameras.len(), "camera", "cameras"),
        counted(scene.paths.len(), "path", "paths"),
        counted(scene.aircraft.len(), "aircraft", "aircraft"),
        counted(scene.props.len(), "prop", "props"),
    ];
    counts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn counted(count: usize, one: &str, many: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{count} {many}")),
    }
}
