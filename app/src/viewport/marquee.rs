//! A rectangle dragged over the picture selects what lies in it.
//!
//! Which kind of thing goes by what is being worked on: marked sprites, the boxes of a cloud, or clouds.

use super::pick;
use super::screen::Screen;
use crate::state::{Action, Choose, Item, Reading};
use crate::theme;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::CloudId;
use cloudwright_core::sprites::PlacedCloud;
use egui::{Key, Modifiers, Painter, Pos2, Rect, StrokeKind, Ui};

/// Shorter drags are none, points.
pub(super) const LEAST_DRAG: f32 = 4.0;

/// The rectangle, from where the button went down.
#[derive(Debug, Default)]
pub(super) struct Marquee {
    from: Option<Pos2>,
}

impl Marquee {
    pub(super) fn begin(&mut self, at: Pos2) {
        self.from = Some(at);
    }

    pub(super) fn is_on(&self) -> bool {
        self.from.is_some()
    }

    /// Draws it, and selects when the button is let go.
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        let Some(from) = self.from else { return };
        let (to, down, dropped, modifiers) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.latest_pos(), pointer.primary_down(), input.key_pressed(Key::Escape), input.modifiers)
        });
        let rect = Rect::from_two_pos(from, to.unwrap_or(from));
        let is_drag = rect.size().length() >= LEAST_DRAG;
        if !down || dropped {
            self.from = None;
            if is_drag && !dropped {
                let (items, through) = within(rect, screen, reading);
                actions.push(Action::Select { items, through, how: how(modifiers, Choose::Too) });
            }
        } else if is_drag {
            let rect = rect.intersect(screen.rect);
            painter.rect(rect, 0.0, theme::MARQUEE_FILL, theme::casing(theme::MARQUEE), StrokeKind::Middle);
            painter.rect_stroke(rect, 0.0, theme::MARQUEE, StrokeKind::Middle);
        }
    }
}

/// How what is picked joins the selection: Ctrl toggles, and Shift does what `with_shift` says.
pub(super) fn how(modifiers: Modifiers, with_shift: Choose) -> Choose {
    if modifiers.command {
        Choose::Toggle
    } else if modifiers.shift {
        with_shift
    } else {
        Choose::Only
    }
}

fn within(rect: Rect, screen: &Screen, reading: &Reading<'_>) -> (Vec<Item>, Option<CloudId>) {
    let sprites: Vec<_> = pick::dots_on(screen, reading).filter(|(at, ..)| rect.contains(*at)).collect();
    if let Some((.., picked)) = sprites.first() {
        return (sprites.iter().map(|(.., picked)| picked.item).collect(), picked.through);
    }
    let boxes = boxes_within(rect, screen, reading);
    if !boxes.is_empty() {
        return (boxes, reading.view.selection.cloud(reading.session.scene()).map(|cloud| cloud.id));
    }
    let scene = reading.session.scene();
    let clouds = scene.clouds.iter().filter(|cloud| reading.view.can_pick(scene, cloud));
    let inside = clouds
        .filter(|cloud| reading.session.placed(cloud.id).is_some_and(|placed| is_mostly_within(placed, rect, screen)));
    (inside.map(|cloud| Item::Cloud(cloud.id)).collect(), None)
}

/// Boxes whose middles lie in the rectangle, if a box is being worked on.
fn boxes_within(rect: Rect, screen: &Screen, reading: &Reading<'_>) -> Vec<Item> {
    let (view, scene) = (reading.view, reading.session.scene());
    let cloud = match view.selection.primary() {
        Some(Item::Box(..)) => view.selection.cloud(scene).filter(|cloud| view.can_pick(scene, cloud)),
        _ => None,
    };
    let Some((cloud, model)) = cloud.and_then(|cloud| Some((cloud, scene.model(cloud.model)?))) else {
        return Vec::new();
    };
    let space = ModelSpace::of(cloud);
    let boxes = model
        .boxes
        .iter()
        .filter(|each| screen.find(space.to_world(each.center)).is_some_and(|middle| rect.contains(middle)));
    let items = boxes.map(|each| Item::Box(model.id, each.id));
    items.filter(|item| !view.hidden.contains(item) && !view.locked.contains(item)).collect()
}

/// By the middle, or by half of the sprites.
fn is_mostly_within(placed: &PlacedCloud, rect: Rect, screen: &Screen) -> bool {
    let offset = screen.relative(placed.origin);
    let holds = |point| screen.project(point).is_some_and(|at| rect.contains(at) && screen.rect.contains(at));
    if placed.sprites.is_empty() {
        return false;
    }
    let inside = || placed.sprites.iter().filter(|sprite| holds(offset + sprite.position)).count();
    holds(offset + placed.center) || inside() * 2 >= placed.sprites.len()
}
