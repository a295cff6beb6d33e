//! What is wrong with the scene, and what to do about it; a click selects the thing.

use crate::state::{Action, Item, Reading};
use crate::theme::{self, icon};
use crate::widget::name_it;
use cloudwright_core::problem::{self, Problem, Severity};
use cloudwright_core::scene::Scene;
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
    let named =
        |item, name: &str, kind: &str| Some((item, if name.is_empty() { kind.into() } else { format!("“{name}”") }));
    match parts.next()?? {
        ("models", at) => {
            let model = scene.models.get(at)?;
            match parts.next().flatten() {
                Some(("boxes", at)) if let Some(each) = model.boxes.get(at) => {
                    named(Item::Box(model.id, each.id), &each.name, "a box")
                }
                Some(("groups", at)) if let Some(group) = model.groups.get(at) => {
                    named(Item::Group(model.id, group.id), &group.name, "a group")
                }
                _ => named(Item::Model(model.id), &model.name, "a model"),
            }
        }
        ("clouds", at) => scene.clouds.get(at).and_then(|cloud| named(Item::Cloud(cloud.id), &cloud.name, "a cloud")),
        ("cameras", at) => {
            scene.cameras.get(at).and_then(|camera| named(Item::Camera(camera.id), &camera.name, "a camera"))
        }
        ("paths", at) => scene.paths.get(at).and_then(|path| named(Item::Path(path.id), &path.name, "a path")),
        ("aircraft", at) => {
            scene.aircraft.get(at).and_then(|each| named(Item::Aircraft(each.id), &each.name, "an aircraft"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lead_to_things() {
        let scene = crate::state::starter_scene();
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
