//! What is wrong with the scene, and what to do about it; a click selects the thing.

use crate::state::{Action, Item, Reading};
use crate::theme::{self, icon};
use crate::widget::name_it;
use cloudwright_core::problem::{self, Problem, Severity};
use cloudwright_core::scene::{ForKind, Listed, Scene, for_each_kind};
use cloudwright_core::version::Version;
use egui::{Button, Id, RichText, ScrollArea, Ui};
use std::sync::Arc;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let problems = problems(ui, reading);
    if problems.is_empty() {
        ui.weak("Nothing is wrong.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for problem in problems.iter() {
            line(ui, problem, reading.session.scene(), actions);
        }
    });
}

/// Looked for only when something has changed.
fn problems(ui: &Ui, reading: &Reading<'_>) -> Arc<Vec<Problem>> {
    type Found = (Version, Arc<Vec<Problem>>);
    let session = reading.session;
    let id = Id::unique("problems");
    let found = ui.data(|data| data.get_temp::<Found>(id));
    if let Some((_, problems)) = found.filter(|(revision, _)| *revision == session.revision()) {
        return problems;
    }
    let problems = problem::check_with_sprites(session.scene(), session.derived().clouds());
    let problems = Arc::new(problem::shortened(problems));
    ui.data_mut(|data| data.insert_temp::<Found>(id, (session.revision(), Arc::clone(&problems))));
    problems
}

fn line(ui: &mut Ui, problem: &Problem, scene: &Scene, actions: &mut Vec<Action>) {
    let (glyph, color) = match problem.severity {
        Severity::Error => (icon::X, theme::error(ui)),
        Severity::Note => (icon::INFO, ui.visuals().text_color()),
    };
    let item = item_at(&problem.place, scene);
    ui.horizontal(|ui| {
        ui.label(RichText::new(glyph).color(color));
        if let Some((item, name)) = item {
            let go = ui.add(Button::new(RichText::new(&name).strong()).frame(false));
            name_it(ui, &go, &format!("Select {name}"));
            if go.on_hover_text(&problem.place).clicked() {
                actions.push(Action::select(item));
            }
        } else if !problem.place.is_empty() {
            ui.label(RichText::new(&problem.place).weak().monospace());
        }
    });
    ui.label(RichText::new(&problem.message).color(color));
    if !problem.hint.is_empty() {
        ui.weak(&problem.hint);
    }
    ui.add_space(theme::GAP);
}

/// The thing that a place such as `models[2].boxes[0].size` lies in, and its name.
fn item_at(place: &str, scene: &Scene) -> Option<(Item, String)> {
    let mut parts = place.split('.').map(|part| {
        let (list, rest) = part.split_once('[')?;
        Some((list, rest.strip_suffix(']')?.parse::<usize>().ok()?))
    });
    let (list, at) = parts.next()??;
    let mut position = Position { scene, list, at, found: None };
    for_each_kind(&mut position);
    let (item, name) = position.found?;
    let part = scene.models.get(at).filter(|model| item == Item::Model(model.id)).and_then(|model| {
        Some(match parts.next()?? {
            ("boxes", at) => model.boxes.get(at).map(|each| (Item::Box(model.id, each.id), each.name.clone()))?,
            ("groups", at) => {
                model.groups.get(at).map(|group| (Item::Group(model.id, group.id), group.name.clone()))?
            }
            _ => return None,
        })
    });
    let (item, name) = part.unwrap_or((item, name));
    let word = item.word();
    let article = if word.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    Some((item, if name.is_empty() { format!("{article} {word}") } else { format!("“{name}”") }))
}

/// A position in a list of the scene, and what stands there.
struct Position<'a> {
    scene: &'a Scene,
    list: &'a str,
    at: usize,
    found: Option<(Item, String)>,
}

impl ForKind for Position<'_> {
    fn kind<T: Listed>(&mut self) {
        if T::LIST == self.list {
            self.found = T::list(self.scene).get(self.at).map(|value| (T::thing(value.id()), value.name().into()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lead_to_things() {
        let scene = crate::starter::starter_scene();
        let (model, cloud) = (&scene.models[0], scene.clouds[0].id);
        for (place, want) in [
            ("models[0]", Some(Item::Model(model.id))),
            ("models[0].boxes[1].width", Some(Item::Box(model.id, model.boxes[1].id))),
            ("models[0].boxes[99]", Some(Item::Model(model.id))),
            ("models[0].color_levels[2].height", Some(Item::Model(model.id))),
            ("clouds[0].position", Some(Item::Cloud(cloud))),
            ("cameras[0]", Some(Item::Camera(scene.cameras[0].id))),
            ("clouds[7]", None),
            ("clouds[-1]", None),
            ("clouds[", None),
            ("sky.exposure_ev", None),
            ("", None),
            ("…", None),
        ] {
            assert_eq!(item_at(place, &scene).map(|(item, _)| item), want, "{place}");
        }
    }
}
