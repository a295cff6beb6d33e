//! What leads back: the inverses of an open transaction, and the undo point that they become.
//!
//! A drag applies thousands of edits, but its way back is as long as the number of parts it touched: an inverse that
//! gives a part its value of a moment ago is left out when one before it gives that part an older value, since that one
//! is applied later and wins. This holds as long as no edit in between adds to a list or takes from one.

use super::edit::{Edit, Part};
use super::{Change, SavedMark, budget};
use crate::problem::{self, Severity};
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// What takes the scene across one step of its history.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct UndoPoint {
    pub(super) name: String,
    /// The state that the point leads to when done.
    #[serde(skip)]
    pub(super) mark: SavedMark,
    /// Applied last to first.
    inverses: Vec<Edit>,
    /// About what it takes, once that was asked for.
    #[serde(skip)]
    bytes: OnceLock<u64>,
}

/// A transaction that goes on.
#[derive(Debug, Clone)]
pub(super) struct Transaction {
    point: UndoPoint,
    /// Which parts the inverses since the last one that changed a list lead back.
    led_back: BTreeSet<Part>,
}

impl Transaction {
    pub(super) fn new(name: String) -> Self {
        let point = UndoPoint { name, mark: SavedMark(0), inverses: Vec::new(), bytes: OnceLock::new() };
        Self { point, led_back: BTreeSet::new() }
    }

    /// One more step has been taken, from which `inverse` leads back.
    pub(super) fn push(&mut self, inverse: Edit) {
        match inverse.replaces() {
            Some(part) if !self.led_back.insert(part) => return,
            Some(_) => {}
            None => self.led_back.clear(),
        }
        self.point.inverses.push(inverse);
    }

    pub(super) fn into_point(mut self) -> UndoPoint {
        self.point.inverses.shrink_to_fit();
        self.point
    }
}

impl UndoPoint {
    /// A scene without errors, which may not be the one that the point was made for, taken across it; none if it does not
    /// fit or would leave errors.
    pub(super) fn lead_back(&self, scene: &Scene) -> Option<Scene> {
        let mut scene = scene.clone();
        let mut change = Change::default();
        for edit in self.inverses.iter().rev() {
            change.join(edit.change());
            edit.clone().apply(&mut scene).ok()?;
        }
        let errors = problem::check_touched(&scene, &change);
        errors.iter().all(|problem| problem.severity != Severity::Error).then_some(scene)
    }

    /// Applies its edits last to first, and gives the point that leads back and what was touched.
    pub(super) fn reverse(&self, scene: &mut Scene) -> (Self, Change) {
        let mut change = Change::default();
        let mut inverses = Vec::with_capacity(self.inverses.len());
        for edit in self.inverses.iter().rev() {
            change.join(edit.change());
            // An inverse was made for exactly this state, so what it names is there.
            if let Ok(inverse) = edit.clone().apply(scene) {
                inverses.push(inverse);
            }
        }
        (Self { name: self.name.clone(), mark: self.mark, inverses, bytes: OnceLock::new() }, change)
    }

    /// About what it takes of memory.
    pub(super) fn bytes(&self) -> u64 {
        *self.bytes.get_or_init(|| budget::bytes_of(self))
    }

    /// The edits, of which the last is applied first.
    pub(super) fn inverses(&self) -> &[Edit] {
        &self.inverses
    }

    /// The edits in the order in which [`UndoPoint::reverse`] applies them.
    pub(super) fn into_edits(self) -> Vec<Edit> {
        self.inverses.into_iter().rev().collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{Document, Edit, ListEdit};
    use crate::problem::sound_scene;
    use crate::scene::{BoxId, CloudBox, CloudId, Scene};
    use glam::DVec3;

    /// Three clouds of one model.
    fn three_clouds() -> Scene {
        let mut scene = sound_scene();
        for _ in 0..2 {
            let mut cloud = scene.clouds[0].clone();
            cloud.id = CloudId::new(&mut scene.next_id);
            scene.clouds.push(cloud);
        }
        scene
    }

    fn moved(document: &Document, cloud: usize, x: f64) -> Edit {
        let mut cloud = document.scene().clouds[cloud].clone();
        cloud.position.x = x;
        Edit::Cloud(ListEdit::Replace(cloud))
    }

    fn inverse_count(document: &Document) -> usize {
        document.open.as_ref().expect("it is open").point.inverses.len()
    }

    #[test]
    fn a_long_drag_of_several_things_leads_back_in_as_many_steps_as_things() {
        let mut document = Document::new(three_clouds());
        let start = document.scene().clone();
        for step in 0..500 {
            for cloud in 0..3 {
                document.apply(moved(&document, cloud, f64::from(step))).expect("it is there");
            }
        }
        assert_eq!(inverse_count(&document), 3);
        let end = document.scene().clone();
        document.commit().expect("sound");
        document.undo();
        assert_eq!(*document.scene(), start);
        document.redo();
        assert_eq!(*document.scene(), end);
    }

    #[test]
    fn a_box_and_the_model_around_it_lead_back_in_any_order() {
        let mut document = Document::new(sound_scene());
        let start = document.scene().clone();
        for step in 1..20_u32 {
            let mut model = document.scene().models[0].clone();
            model.seed = step.into();
            model.boxes[0].sprite_count = step;
            let (id, mut one) = (model.id, model.boxes[0].clone());
            one.size = DVec3::splat(f64::from(step));
            let edits = [Edit::Model(ListEdit::Replace(model)), Edit::Box(id, ListEdit::Replace(one))];
            let [first, second] = if step % 2 == 0 { edits } else { [edits[1].clone(), edits[0].clone()] };
            document.apply(first).expect("it is there");
            document.apply(second).expect("it is there");
        }
        assert_eq!(inverse_count(&document), 2);
        let end = document.scene().clone();
        document.commit().expect("sound");
        document.undo();
        assert_eq!(*document.scene(), start);
        document.redo();
        assert_eq!(*document.scene(), end);
    }

    #[test]
    fn what_is_added_within_a_drag_goes_again() {
        let mut document = Document::new(sound_scene());
        let start = document.scene().clone();
        let model = start.models[0].id;
        document.apply(moved(&document, 0, 1.0)).expect("it is there");
        let mut counter = start.next_id;
        let mut new = CloudBox::new(BoxId::new(&mut counter), DVec3::ZERO);
        document.apply(Edit::NextId(counter)).expect("a counter");
        document.apply(Edit::Box(model, ListEdit::Insert { at: 0, value: new.clone() })).expect("a free id");
        for step in 0..100 {
            new.center.x = f64::from(step);
            document.apply(Edit::Box(model, ListEdit::Replace(new.clone()))).expect("it is there");
            document.apply(moved(&document, 0, f64::from(step))).expect("it is there");
        }
        assert_eq!(inverse_count(&document), 5);
        let mut other = document.clone();
        document.cancel();
        assert_eq!(*document.scene(), start);
        // Another document takes the point over.
        other.commit().expect("sound");
        assert_eq!(document.edit("Taken over", other.last_edits()).map(|_| ()), Ok(()));
        assert_eq!(document.scene(), other.scene());
        document.undo();
        assert_eq!((document.scene(), document.last_edits()), (&start, Vec::new()));
    }
}
