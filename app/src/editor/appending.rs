//! *Append from scene…*: clouds of another scene with their models, as one step.

use super::Editor;
use super::dialogs::{Append, Dialog};
use crate::command::Command;
use crate::opening::{self, OpenError};
use crate::state::Selection;
use cloudwright_core::arrange::{Arrangement, transfer};
use cloudwright_core::scene::Thing;
use std::path::Path;

impl Editor {
    /// Asks which clouds of the scene at `path`; if it can't be read, says why.
    pub(super) fn ask_appending(&mut self, path: &Path) {
        let scene = match opening::open_scene(path) {
            Ok(scene) => scene,
            Err(OpenError::Problems { problems, .. }) => return self.dialogs.list(path, problems),
            Err(OpenError::Storage(error)) => return self.dialogs.fail("The scene can't be read", &error),
        };
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if scene.clouds.is_empty() {
            return self.tell_error(format!("{name} has no clouds"));
        }
        self.dialogs.open(Dialog::Append(Append::new(scene, name)));
    }

    /// Those that were chosen come in where they stand there; models that are here already are shared.
    pub(super) fn append(&mut self, asked: &Append) {
        let chosen: Vec<Thing> = asked.chosen.iter().map(|id| Thing::Cloud(*id)).collect();
        let scene = self.session.scene();
        let sheet = asked.scene.atlas.clone().filter(|atlas| scene.atlas.as_ref() != Some(atlas));
        let models = scene.models.len();
        let Arrangement { edits, made } = transfer::things(&asked.scene, &chosen, scene);
        let count = made.len();
        let done = self.session.edit(Command::Append.row().label(), edits);
        if done.is_ok() {
            self.select(Selection::of(made));
            let models = self.session.scene().models.len() - models;
            self.tell(format!("Appended from {}: clouds {count}, new models {models}", asked.name));
            if let Some(atlas) = sheet {
                self.tell(format!("Its clouds show the tiles of this scene, not those of {atlas}"));
            }
        }
        self.report(done);
    }
}
