//! Marks at sprites: dots, or the quads' true outlines as the picture shows them; filled in the tints of their shading
//! groups in the group view.
//!
//! All marks are one mesh, built anew only when what it shows changed: ten thousands of sprites cost nothing while the
//! view stands still.

use super::pick;
use super::screen::Screen;
use crate::state::{Item, Reading, Selection, SpriteMarks, ViewState};
use crate::theme;
use cloudwright_core::facing::{FacingRule, Pose, Poses, corners};
use cloudwright_core::scene::{Cloud, ModelId};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::{PlacedCloud, Sprite};
use cloudwright_core::version::Version;
use cloudwright_core::view_history::ViewHistory;
use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, Vec2, vec2};
use glam::Vec3;
use std::collections::BTreeSet;
use std::sync::Arc;

/// More marks than these are no help to the eye; then every second, third, … sprite is marked.
const MOST: usize = 40_000;

/// The mesh and what it shows.
#[derive(Default)]
pub(super) struct Marks {
    shown: Option<(Key, Arc<Mesh>)>,
}

/// What the marks look like depends on this and nothing else.
#[derive(PartialEq)]
struct Key {
    revision: Version,
    view: cloudwright_core::camera::View,
    rect: Rect,
    marks: SpriteMarks,
    group_view: bool,
    selection: Selection,
    hidden: [BTreeSet<Item>; 2],
    clock_s: f64,
    facing: FacingRule,
    history: Arc<ViewHistory>,
}

impl Marks {
    /// Paints them. `sight` is the picture's.
    pub(super) fn paint(&mut self, painter: &Painter, screen: &Screen, sight: &Sight, reading: &Reading<'_>) {
        let view = reading.view;
        let any_selected = view.selection.sprites().next().is_some();
        if view.sprite_marks == SpriteMarks::Off && !view.group_view && !any_selected {
            self.shown = None;
            return;
        }
        let key = Key {
            revision: reading.session.revision(),
            view: screen.view,
            rect: screen.rect,
            marks: view.sprite_marks,
            group_view: view.group_view,
            selection: view.selection.clone(),
            hidden: [view.hidden.clone(), view.solo.clone()],
            clock_s: reading.clock.time_s(),
            facing: sight.rules.facing,
            history: Arc::clone(&sight.history),
        };
        let mesh = match self.shown.take() {
            Some((shown, mesh)) if shown == key => mesh,
            _ => Arc::new(mesh(screen, sight, reading)),
        };
        painter.add(Shape::Mesh(Arc::clone(&mesh)));
        self.shown = Some((key, mesh));
    }
}

fn mesh(screen: &Screen, sight: &Sight, reading: &Reading<'_>) -> Mesh {
    let view = reading.view;
    let derived = reading.session.derived();
    let now = derived.clouds_at(sight.moment.clock_s, sight.rules.of_weather());
    let poses = Poses::new(&sight.rules.facing, &now, derived.shapes(), &screen.view, &sight.history.facing);
    let clouds: Vec<(&Cloud, &PlacedCloud)> = marked(reading);
    let count: usize = clouds.iter().map(|(_, placed)| placed.sprites.len()).sum();
    let every = count.div_ceil(MOST).max(1);
    let chosen: BTreeSet<_> = view.selection.sprites().collect();
    let mut mesh = Mesh::default();
    let mut selected = Vec::new();
    for (cloud, placed) in clouds {
        let Some((cloud_index, cloud_now)) = derived.index_of(placed.id).and_then(|at| Some((at, now.get(at)?))) else {
            continue;
        };
        let offset = screen.relative(cloud_now.origin());
        if !screen.view.sees_sphere(offset + cloud_now.center_now(), cloud_now.reach_now()) {
            continue;
        }
        let pose = |number: usize, center: Vec3| match poses.of_sprite(cloud_index, number as u32) {
            Some(pose) => *pose,
            None => Pose::facing_eye(center, screen.view.up),
        };
        let tints = view.group_view.then(|| theme::tints(placed));
        for number in 0..placed.sprites.len() {
            let sprite = cloud_now.sprite_now(number);
            if view.hidden.contains(&Item::Box(cloud.model, sprite.box_id)) {
                continue;
            }
            let center = offset + sprite.position;
            if chosen.contains(&(cloud.model, sprite.box_id, sprite.index)) {
                selected.push((center, sprite, pose(number, center)));
            } else if number % every == 0 && pick::is_there(cloud_now, number) {
                let color = color_of(cloud.model, tints.as_deref(), &sprite, view);
                mark(&mut mesh, screen, (center, &sprite, || pose(number, center)), color, view);
            }
        }
    }
    // On top of the others.
    for (center, sprite, pose) in selected {
        if let Some(quad) = quad(screen, center, &sprite, &pose) {
            ring(&mut mesh, quad, 3.5, theme::CASING);
            ring(&mut mesh, quad, 2.0, theme::SELECTED_BOX.color);
        }
        dot(&mut mesh, screen, center, 5.0, theme::SELECTED_BOX.color);
    }
    mesh
}

/// The clouds whose sprites are marked: the selected ones, or all.
fn marked<'a>(reading: &Reading<'a>) -> Vec<(&'a Cloud, &'a PlacedCloud)> {
    let (view, scene) = (reading.view, reading.session.scene());
    let models: BTreeSet<ModelId> = view
        .selection
        .items()
        .iter()
        .filter_map(|item| if let Item::Model(id) = item { Some(*id) } else { None })
        .collect();
    let seen_in = view.selection.cloud(scene).map(|cloud| cloud.id);
    let any = |cloud: &Cloud| {
        view.selection.contains(Item::Cloud(cloud.id)) || models.contains(&cloud.model) || seen_in == Some(cloud.id)
    };
    let all = !scene.clouds.iter().any(any);
    let clouds = scene.clouds.iter().filter(|cloud| view.shows(scene, cloud) && (all || any(cloud)));
    clouds.filter_map(|cloud| Some((cloud, reading.session.placed(cloud.id)?))).collect()
}

fn color_of(model: ModelId, tints: Option<&[Color32]>, sprite: &Sprite, view: &ViewState) -> Color32 {
    match tints {
        Some(tints) => tints.get(sprite.group as usize).copied().unwrap_or(theme::SPRITE_MARK),
        None if view.selection.contains(Item::Box(model, sprite.box_id)) => theme::SELECTED_BOX.color,
        None => theme::SPRITE_MARK,
    }
}

fn mark(
    mesh: &mut Mesh,
    screen: &Screen,
    (center, sprite, pose): (Vec3, &Sprite, impl Fn() -> Pose),
    color: Color32,
    view: &ViewState,
) {
    let outlines = view.sprite_marks == SpriteMarks::Outlines;
    if (view.group_view || outlines)
        && screen.view.sees_sphere(center, sprite.reach())
        && let Some(quad) = quad(screen, center, sprite, &pose())
    {
        if view.group_view {
            fill(mesh, quad, color.gamma_multiply(theme::GROUP_FILL));
        }
        if outlines {
            ring(mesh, quad, 1.2 + 2.0 * theme::CASING_WIDTH, theme::CASING.gamma_multiply(theme::SPRITE_OUTLINE));
            ring(mesh, quad, 1.2, color.gamma_multiply(theme::SPRITE_OUTLINE));
        }
    }
    if view.sprite_marks == SpriteMarks::Dots {
        dot(mesh, screen, center, 2.2, color);
    }
}

/// Where a sprite's corners show, if all of them do.
fn quad(screen: &Screen, center: Vec3, sprite: &Sprite, pose: &Pose) -> Option<[Pos2; 4]> {
    let facing = pose.facing(sprite.rotation);
    let [a, b, c, d] = corners(center, facing, sprite.width, sprite.height).map(|corner| screen.project(corner));
    Some([a?, b?, c?, d?])
}

/// A dot with a dark rim, legible on bright clouds and dark ground.
fn dot(mesh: &mut Mesh, screen: &Screen, center: Vec3, radius: f32, color: Color32) {
    let Some(at) = screen.project(center).filter(|at| screen.rect.contains(*at)) else { return };
    for (radius, color) in [(radius + 1.0, theme::CASING), (radius, color)] {
        let half = radius * 0.866;
        let ends = [(0.0, -radius), (half, -radius * 0.5), (half, radius * 0.5)];
        let ends = ends.into_iter().chain(ends.map(|(x, y)| (-x, -y))).map(|(x, y)| at + vec2(x, y));
        polygon(mesh, ends, color);
    }
}

fn fill(mesh: &mut Mesh, quad: [Pos2; 4], color: Color32) {
    polygon(mesh, quad, color);
}

/// A convex polygon, as a fan.
fn polygon(mesh: &mut Mesh, corners: impl IntoIterator<Item = Pos2>, color: Color32) {
    let first = mesh.vertices.len() as u32;
    for corner in corners {
        mesh.colored_vertex(corner, color);
    }
    let last = mesh.vertices.len() as u32;
    for i in first + 1..last.saturating_sub(1) {
        mesh.add_triangle(first, i, i + 1);
    }
}

/// A quad's frame, `width` points wide.
fn ring(mesh: &mut Mesh, quad: [Pos2; 4], width: f32, color: Color32) {
    let first = mesh.vertices.len() as u32;
    let unit = |v: Vec2| v.normalized();
    for i in 0..4 {
        let (corner, next, before) = (quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4]);
        let inwards = (unit(next - corner) + unit(before - corner)) * (width * 0.5);
        mesh.colored_vertex(corner - inwards, color);
        mesh.colored_vertex(corner + inwards, color);
    }
    for i in 0..4 {
        let (a, b) = (first + 2 * i, first + 2 * ((i + 1) % 4));
        mesh.add_triangle(a, b, a + 1);
        mesh.add_triangle(a + 1, b, b + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn rings_and_polygons_have_all_their_triangles() {
        let mut mesh = Mesh::default();
        let quad = [pos2(0.0, 0.0), pos2(10.0, 0.0), pos2(10.0, 10.0), pos2(0.0, 10.0)];
        ring(&mut mesh, quad, 2.0, Color32::WHITE);
        assert_eq!((mesh.vertices.len(), mesh.indices.len()), (8, 24));
        assert_eq!(mesh.vertices[1].pos, pos2(1.0, 1.0), "half of the width inwards");
        fill(&mut mesh, quad, Color32::WHITE);
        assert_eq!((mesh.vertices.len(), mesh.indices.len()), (12, 30));
        polygon(&mut mesh, [], Color32::WHITE);
        ring(&mut mesh, [pos2(1.0, 1.0); 4], 2.0, Color32::WHITE);
        assert!(mesh.is_valid());
    }
}
