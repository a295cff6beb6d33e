//! What is done with things that are there: duplicate, mirror, join, split, re-roll, delete.
//!
//! How each is done is [`cloudwright_core::arrange`]'s; here stands what of the selection it is asked for: things of the
//! primary's kind, as in the inspector.

use crate::command::Command;
use crate::editor::Editor;
use crate::state::{Item, Selection, box_of};
use cloudwright_core::arrange::duplicate::{self, Copy};
use cloudwright_core::arrange::mirror::{self, Axis};
use cloudwright_core::arrange::sprites::SpriteId;
use cloudwright_core::arrange::{
    Arrangement, ModelSpace, Refusal, delete, fill, folders, join, rename, split, sprites,
};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::random;
use cloudwright_core::scene::{BoxId, Cloud, CloudBox, CloudId, CloudModel, Folder, FolderId, ModelId};
use glam::DVec3;
use std::collections::BTreeSet;

impl Editor {
    /// One undo point; what it made is selected. Where nothing is made, the selection stays.
    pub(super) fn arrange(&mut self, command: Command, arrangement: Arrangement) {
        self.arrange_as(command.row().label(), arrangement);
    }

    /// The same under a name that says more than the command's. Whether anything was done.
    pub(super) fn arrange_as(&mut self, name: &str, arrangement: Arrangement) -> bool {
        let Arrangement { edits, made } = arrangement;
        if edits.is_empty() {
            return false;
        }
        let selection = if made.is_empty() {
            self.view.selection.clone()
        } else {
            let seen = self.view.selection.cloud(self.session.scene()).map(|cloud| cloud.id);
            let made = Selection::of(made);
            if let Some(cloud) = seen { made.through(cloud) } else { made }
        };
        self.edit_as(name, edits, selection)
    }

    pub(super) fn arrange_or_tell(&mut self, command: Command, arrangement: Result<Arrangement, Refusal>) {
        match arrangement {
            Ok(arrangement) => self.arrange(command, arrangement),
            Err(refusal) => self.tell_error(refusal.to_string()),
        }
    }

    pub(super) fn duplicate(&mut self) {
        let scene = self.session.scene();
        let selection = &self.view.selection;
        let arrangement = match selection.primary() {
            Some(Item::Box(model, _)) => {
                let ids = boxes_of(selection, model);
                duplicate::boxes(scene, model, &ids, self.beside_boxes(model, &ids))
            }
            Some(Item::Cloud(_)) => self.duplicated_clouds(Copy::Linked),
            Some(Item::Folder(_)) => {
                let ids: Vec<FolderId> = selection.all::<Folder>().collect();
                let clouds: Vec<CloudId> =
                    ids.iter().flat_map(|id| scene.clouds_in(*id)).map(|cloud| cloud.id).collect();
                folders::duplicated(scene, &ids, self.aside(&clouds))
            }
            Some(primary) => {
                let same = selection.items().iter().copied().filter(|item| item.word() == primary.word());
                duplicate::things(scene, &same.collect::<Vec<_>>())
            }
            None => return,
        };
        self.arrange(Command::Duplicate, arrangement);
    }

    pub(super) fn duplicate_own(&mut self) {
        let arrangement = self.duplicated_clouds(Copy::Own);
        self.arrange(Command::DuplicateOwn, arrangement);
    }

    /// Copies of the selected clouds, beside them.
    fn duplicated_clouds(&self, copy: Copy) -> Arrangement {
        let ids: Vec<CloudId> = self.view.selection.clouds().collect();
        duplicate::clouds(self.session.scene(), &ids, self.aside(&ids), copy)
    }

    /// Where copies of those clouds go, metres from them.
    fn aside(&self, ids: &[CloudId]) -> DVec3 {
        let placed: Vec<_> = ids.iter().filter_map(|id| self.session.placed(*id)).collect();
        // A cloud is narrower than the sphere that holds it.
        let sides =
            [0, 2].map(|axis| width(placed.iter().map(|cloud| (cloud.origin[axis], f64::from(cloud.reach)))) * 0.75);
        let [x, z] = sides.map(|side| if side > 0.0 { side.round() } else { 500.0 });
        let things = Selection::of(ids.iter().map(|id| Item::Cloud(*id)));
        let shown = self.viewport.places(&things, &self.session, self.clock.time_s());
        self.viewport.beside(&shown, DVec3::new(x, 0.0, z), |by| by).round()
    }

    /// Where copies of a model's boxes go, metres from them in its space.
    fn beside_boxes(&self, model: ModelId, ids: &[BoxId]) -> DVec3 {
        let scene = self.session.scene();
        let boxes: Vec<_> = ids.iter().filter_map(|id| box_of(scene, model, *id)).collect();
        let [x, z] = [0, 2].map(|axis| width(boxes.iter().map(|each| (each.center[axis], each.size[axis] * 0.5))));
        let Some(cloud) = self.view.selection.cloud(scene) else { return DVec3::X * x };
        let space = ModelSpace::of(cloud);
        let things = Selection::of(ids.iter().map(|id| Item::Box(model, *id))).through(cloud.id);
        let shown = self.viewport.places(&things, &self.session, self.clock.time_s());
        self.viewport.beside(&shown, DVec3::new(x, 0.0, z), |by| space.turn * by * space.scale)
    }

    pub(super) fn make_own(&mut self) {
        let ids: Vec<CloudId> = self.view.selection.clouds().collect();
        let arrangement = duplicate::make_own(self.session.scene(), &ids);
        if arrangement.edits.is_empty() {
            self.tell("No other cloud shares the model");
        }
        self.arrange(Command::MakeOwn, arrangement);
    }

    pub(super) fn mirror(&mut self, command: Command, axis: Axis) {
        let scene = self.session.scene();
        let selection = &self.view.selection;
        let arrangement = match selection.primary() {
            Some(Item::Box(model, _)) => mirror::boxes(scene, model, &boxes_of(selection, model), axis),
            _ => mirror::clouds(scene, &selection.clouds().collect::<Vec<_>>(), axis),
        };
        self.arrange(command, arrangement);
    }

    /// Into the primary, which stays where it is.
    pub(super) fn join(&mut self) {
        let mut ids: Vec<CloudId> = self.view.selection.clouds().collect();
        ids.reverse();
        let arrangement = join::clouds(self.session.scene(), &ids);
        self.arrange_or_tell(Command::Join, arrangement);
    }

    pub(super) fn split(&mut self) {
        let scene = self.session.scene();
        let Some(cloud) = self.view.selection.cloud(scene) else { return };
        let arrangement = split::boxes(scene, cloud.id, &boxes_of(&self.view.selection, cloud.model));
        self.arrange_or_tell(Command::Split, arrangement);
    }

    /// Clouds get another seed of their own, models another for all their clouds, boxes another key.
    pub(super) fn reroll(&mut self) {
        let scene = self.session.scene();
        let selection = &self.view.selection;
        let edits = match selection.primary() {
            Some(Item::Cloud(_)) => {
                let clouds = selection.clouds().filter_map(|id| scene.cloud(id));
                let seed_of = |cloud: &Cloud| cloud.seed.or(scene.model(cloud.model).map(|model| model.seed));
                let rolled = |cloud: &Cloud| Cloud { seed: seed_of(cloud).map(random::another_seed), ..cloud.clone() };
                clouds.map(|cloud| Edit::Cloud(ListEdit::Replace(rolled(cloud)))).collect()
            }
            Some(Item::Box(..)) => {
                let boxes = selection.boxes().filter_map(|(model, id)| Some((model, box_of(scene, model, id)?)));
                let key_of = |each: &CloudBox| each.key.unwrap_or(each.id.0);
                let rolled =
                    |each: &CloudBox| CloudBox { key: Some(random::another_seed(key_of(each))), ..each.clone() };
                boxes.map(|(model, each)| Edit::Box(model, ListEdit::Replace(rolled(each)))).collect()
            }
            _ => {
                let models = scene.models.iter().filter(|model| selection.of_model(model.id));
                let rolled =
                    |model: &CloudModel| CloudModel { seed: random::another_seed(model.seed), ..model.clone() };
                models.map(|model| Edit::Model(ListEdit::Replace(rolled(model)))).collect()
            }
        };
        self.arrange(Command::Reroll, Arrangement { edits, made: Vec::new() });
    }

    /// Those of the selected boxes.
    pub(super) fn fit_sprites(&mut self) {
        let scene = self.session.scene();
        let boxes = self.view.selection.boxes().filter_map(|(of, id)| Some((of, box_of(scene, of, id)?)));
        let edits = boxes.map(|(of, each)| Edit::Box(of, ListEdit::Replace(fill::filled(each)))).collect();
        self.arrange(Command::FitSprites, Arrangement { edits, made: Vec::new() });
    }

    /// The selected sprites, and all of the selected boxes.
    pub(super) fn reset_sprites(&mut self) {
        let scene = self.session.scene();
        let selection = &self.view.selection;
        let Some(model) = selection.model(scene) else { return };
        let whole = selection.boxes().filter(|(of, _)| *of == model.id).filter_map(|(of, id)| box_of(scene, of, id));
        let edited = whole.flat_map(|each| each.sprite_edits.iter().map(|edit| (each.id, edit.index)));
        let single = selection.sprites().filter(|(of, ..)| *of == model.id).map(|(_, id, index)| (id, index));
        let ids: Vec<SpriteId> = edited.chain(single).collect();
        let reset = sprites::reset(scene, model.id, &ids);
        self.arrange(Command::ResetSprites, Arrangement { edits: reset.edits, made: Vec::new() });
    }

    /// With what hangs on it. After a group or a sprite, the artist is still at work on its cloud.
    pub(super) fn delete(&mut self) {
        if !self.delete_key() {
            self.take_out(Command::Delete);
        }
    }

    /// The selection goes, by that command. A folder that is cut takes its clouds along; one that is deleted leaves them.
    pub(super) fn take_out(&mut self, command: Command) {
        let scene = self.session.scene();
        let chosen = self.view.selection.items();
        let with_contents = folders::with_contents(scene, chosen);
        let kept = if command == Command::Cut { 0 } else { with_contents.len() - chosen.len() };
        let things = if command == Command::Cut { with_contents } else { chosen.to_vec() };
        let left = match self.view.selection.primary() {
            Some(Item::Group(model, _) | Item::Sprite(model, ..)) => {
                let cloud = self.view.selection.cloud(scene).map(|cloud| Item::Cloud(cloud.id));
                Selection::of([cloud.unwrap_or(Item::Model(model))])
            }
            _ => Selection::default(),
        };
        let edits = delete::things(scene, &things).edits;
        let before: BTreeSet<Item> = delete::unused_models(scene).into_iter().collect();
        self.edit_and_select(command, edits, left);
        self.tell_what_stays(&before);
        match kept {
            0 => {}
            1 => self.tell("Its cloud stays, in no folder"),
            _ => self.tell(format!("Its {kept} clouds stay, in no folder")),
        }
    }

    /// Models that are no longer placed, as before those were.
    fn tell_what_stays(&mut self, before: &BTreeSet<Item>) {
        let scene = self.session.scene();
        let stays: Vec<Item> =
            delete::unused_models(scene).into_iter().filter(|model| !before.contains(model)).collect();
        let named = stays.first().and_then(|first| rename::name_of(scene, *first)).unwrap_or_default();
        match stays.len() {
            0 => {}
            1 => self.tell(format!("Its model “{named}” stays, to be placed again; Remove unused models takes it out")),
            more => self.tell(format!("{more} models stay, to be placed again; Remove unused models takes them out")),
        }
    }

    pub(super) fn remove_unused_models(&mut self) {
        let scene = self.session.scene();
        let unused = delete::unused_models(scene);
        let (count, edits) = (unused.len(), delete::things(scene, &unused).edits);
        self.arrange(Command::RemoveUnusedModels, Arrangement { edits, made: Vec::new() });
        self.tell(format!("Removed {count} model{} that no cloud placed", if count == 1 { "" } else { "s" }));
    }
}

pub(super) fn boxes_of(selection: &Selection, model: ModelId) -> Vec<BoxId> {
    selection.boxes().filter(|(of, _)| *of == model).map(|(_, id)| id).collect()
}

/// From the westernmost to the easternmost end of things with a middle and half an extent; 0 of nothing.
fn width(things: impl Iterator<Item = (f64, f64)>) -> f64 {
    let ends = things.map(|(middle, half)| (middle - half, middle + half));
    let ends = ends.reduce(|(low, high), (from, to)| (low.min(from), high.max(to)));
    ends.map_or(0.0, |(low, high)| high - low)
}
