//! Cloud models: category and culling. Boxes are in the outline, colours in their own panel.

use crate::command::Command;
use crate::state::{Action, Reading};
use crate::widget::{Fields, Kept, fields, kept};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{CloudModel, CullRadius};
use egui::Ui;

#[derive(Clone, Copy, PartialEq)]
enum CullKind {
    Sprite,
    Height,
    Metres,
}

/// `models` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, models: &[CloudModel], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    fields(
        ui,
        "Change model",
        actions,
        models,
        |rows, model| {
            rows.text("Name", &mut model.name);
            rows.category(&mut model.category, reading.thumbnails);
            cull(rows, &mut model.cull_radius);
            rows.seed("Seed", "Another number strews the sprites anew.", &mut model.seed);
        },
        |model| Edit::Model(ListEdit::Replace(model)),
    );
    placed_as(ui, models, reading);
    ui.horizontal_wrapped(|ui| {
        for command in [Command::AddBox, Command::PlaceModel, Command::PlaceMany] {
            let row = command.row();
            if ui.button(row.name).on_hover_text(row.tooltip(ui.ctx())).clicked() {
                actions.push(Action::Command(command));
            }
        }
    });
}

/// The counts of each model's first cloud: those of the others differ only if they have seeds of their own.
fn placed_as(ui: &mut Ui, models: &[CloudModel], reading: &Reading<'_>) {
    let clouds = &reading.session.scene().clouds;
    let first = |model: &CloudModel| clouds.iter().find(|cloud| cloud.model == model.id);
    let placed: Vec<_> = models.iter().filter_map(first).filter_map(|cloud| reading.session.placed(cloud.id)).collect();
    if placed.is_empty() {
        ui.weak("Placed nowhere.");
    } else {
        kept::line(ui, &Kept::of_clouds(&placed));
    }
}

fn cull(rows: &mut Fields<'_>, radius: &mut CullRadius) {
    let before = cull_kind(*radius);
    let mut kind = before;
    let kinds = [
        (CullKind::Sprite, "share of the sprite's size".into()),
        (CullKind::Height, "share of the cloud's height".into()),
        (CullKind::Metres, "metres".into()),
    ];
    rows.choice("Cull by", "What the cull radius is measured in.", &mut kind, &kinds);
    if kind != before {
        *radius = match kind {
            CullKind::Sprite => CullRadius::SpriteFraction(p::CULL_FRACTION.default),
            CullKind::Height => CullRadius::CloudHeightFraction(p::CULL_FRACTION.default),
            CullKind::Metres => CullRadius::Metres(p::CULL_METRES.default),
        };
    }
    match radius {
        CullRadius::SpriteFraction(share) | CullRadius::CloudHeightFraction(share) => {
            rows.number(&p::CULL_FRACTION, share);
        }
        CullRadius::Metres(metres) => rows.number(&p::CULL_METRES, metres),
    }
}

fn cull_kind(radius: CullRadius) -> CullKind {
    match radius {
        CullRadius::SpriteFraction(_) => CullKind::Sprite,
        CullRadius::CloudHeightFraction(_) => CullKind::Height,
        CullRadius::Metres(_) => CullKind::Metres,
    }
}
