//! The values of what is selected. Several things of the primary's kind are changed together.

use super::shading_groups::members;
use super::{camera, cloud, cloud_box, model, models};
use crate::command::Command;
use crate::state::{Action, Choose, Item, Reading, box_of, group_of};
use crate::widget::Fields;
use cloudwright_core::document::{Edit, ForEditable, ListEdit, for_each_editable};
use cloudwright_core::property::{Described, GROUP_NAME, Owner};
use cloudwright_core::scene::{Listed, ModelId, ShadingGroup};
use egui::{ScrollArea, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| match reading.view.selection.primary() {
        None => {
            ui.heading("Nothing selected");
            ui.weak("Click a cloud, or choose something in the outline.");
        }
        Some(primary) => {
            ui.push_id(primary, |ui| of(ui, primary, reading, actions));
        }
    });
}

fn of(ui: &mut Ui, primary: Item, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    // The primary first.
    let chosen = || reading.view.selection.items().iter().rev();
    match primary {
        Item::Model(_) => {
            let models: Vec<_> =
                chosen().filter_map(|item| if let Item::Model(id) = item { scene.model(*id) } else { None }).collect();
            title(ui, "Cloud model", models.len());
            model::fields_of(ui, &models, reading, actions);
        }
        Item::Box(of, _) | Item::Sprite(of, ..) => {
            let boxes: Vec<_> = chosen()
                .filter_map(|item| match item {
                    Item::Box(of, id) => Some((*of, box_of(scene, *of, *id)?)),
                    _ => None,
                })
                .collect();
            title(ui, "Box", boxes.len());
            if let Some(model) = scene.model(of) {
                cloud_box::fields_of(ui, model, &boxes, reading, actions);
            }
        }
        Item::Group(..) => groups(ui, reading, actions),
        Item::Cloud(_) => {
            let clouds: Vec<_> =
                chosen().filter_map(|item| if let Item::Cloud(id) = item { scene.cloud(*id) } else { None }).collect();
            title(ui, "Cloud", clouds.len());
            cloud::fields_of(ui, &clouds, reading, actions);
        }
        other => {
            for_each_editable(&mut Plain { ui, primary: other, reading, actions });
            match other {
                Item::Camera(id) => camera::views(ui, id, actions),
                Item::Aircraft(id) => models::aircraft(ui, id, reading, actions),
                Item::Prop(id) => models::prop(ui, id, reading, actions),
                _ => {}
            }
        }
    }
}

/// All values of things of the primary's kind, one row after the other.
struct Plain<'a, 'r> {
    ui: &'a mut Ui,
    primary: Item,
    reading: &'a Reading<'r>,
    actions: &'a mut Vec<Action>,
}

impl ForEditable for Plain<'_, '_> {
    fn kind<T>(&mut self)
    where
        T: Listed + Described,
        Edit: From<ListEdit<T>>,
    {
        if T::id_of(self.primary).is_none() {
            return;
        }
        let list = T::list(self.reading.session.scene());
        let mut chosen: Vec<&T> = self.reading.view.selection.all::<T>().filter_map(|id| list.with_id(id)).collect();
        // The primary first.
        chosen.reverse();
        title(self.ui, T::TITLE, chosen.len());
        let edit = |_: usize, value| Edit::from(ListEdit::Replace(value));
        let owners = chosen.iter().map(|value| Owner::Thing(T::thing(value.id())));
        let fields = Fields::of(&chosen, self.reading);
        let fields = if T::rows().any(|row| row.property.keyed) { fields.owned(owners) } else { fields };
        fields.show(self.ui, T::CHANGE, self.actions, Fields::all, edit);
    }
}

fn groups(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    let chosen = reading.view.selection.groups();
    let mut found: Vec<_> = chosen.filter_map(|(of, id)| Some((of, group_of(scene, of, id)?))).collect();
    found.reverse();
    title(ui, "Shading group", found.len());
    let (models, groups): (Vec<ModelId>, Vec<&ShadingGroup>) = found.into_iter().unzip();
    let name = |fields: &mut Fields<'_, ShadingGroup>, ui: &mut Ui| fields.rows(ui, GROUP_NAME);
    let edit = |at: usize, group| Edit::Group(models[at], ListEdit::Replace(group));
    Fields::of(&groups, reading).show(ui, "Rename shading group", actions, name, edit);
    ui.horizontal(|ui| {
        let panel = Command::GroupsPanel.row();
        if ui.button("Shape its light").on_hover_text(panel.help).clicked() {
            actions.push(Action::Command(panel.command));
        }
        if ui.button("Select its members").on_hover_text("The boxes and sprites that were put into it.").clicked() {
            let members = |(of, group): (&ModelId, &&ShadingGroup)| Some(members(scene.model(*of)?, group.id));
            let items = models.iter().zip(&groups).filter_map(members).flatten().collect();
            actions.push(Action::Select { items, through: None, how: Choose::Only });
        }
    });
}

fn title(ui: &mut Ui, kind: &str, count: usize) {
    ui.heading(kind);
    if count > 1 {
        ui.weak(format!("{count} selected: changes go to all of them"));
    }
}
