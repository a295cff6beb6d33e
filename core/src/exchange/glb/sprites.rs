//! Clouds as nodes, their sprites as instances of a quad a tile, or as one mesh a cloud.

use super::container::{Buffer, Use};
use super::{INSTANCING, Leaving, Nodes, material, push};
use crate::exchange::motion::{Course, share_formed};
use crate::exchange::quads::{Quad, quads, too_bright};
use crate::exchange::tiles;
use crate::posed_sprite::Still;
use glam::{Mat3, Quat, Vec3};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// The clouds in the file.
#[derive(Debug, Default)]
pub(super) struct Written {
    /// Of each cloud, in the scene's order: its node, and its material if that has a part of its own in the timeline.
    pub(super) nodes: Vec<CloudNode>,
    /// Whether any sprite is an instance.
    pub(super) instanced: bool,
    /// How many corners were brighter than a colour of glTF's can be.
    pub(super) clipped: usize,
}

/// A cloud in the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct CloudNode {
    pub(super) node: usize,
    /// Of a cloud that forms.
    pub(super) material: Option<usize>,
}

/// Adds the clouds, whose courses are given in their order; none if the watch is cancelled.
pub(super) fn write(
    root: &mut Value,
    buffer: &mut Buffer,
    nodes: &mut Nodes,
    leaving: &Leaving<'_>,
    (still, plain): (Still<'_>, bool),
    courses: &[Course],
) -> Option<Written> {
    let Leaving { now, watch, .. } = *leaving;
    let mut meshes = Meshes { root, buffer, tiles: BTreeMap::new() };
    let mut written = Written::default();
    let mut far_to_near: Vec<(f32, usize)> = Vec::new();
    watch.expect(now.clouds.len() as u64);
    for (cloud, course) in watch.along(1, &now.clouds).zip(courses) {
        let forms = !course.formed.is_empty();
        let material = forms.then(|| meshes.material(&cloud.placed.name, f64::from(share_formed(cloud))));
        let quads = quads(cloud, forms, still, now.exposure);
        written.clipped += too_bright(&quads);
        let mut node = json!({ "name": cloud.placed.name, "translation": cloud.origin().to_array() });
        if plain {
            if !quads.is_empty() {
                node["mesh"] = json!(meshes.of_cloud(&cloud.placed.name, &quads, material.unwrap_or(0)));
            }
        } else {
            let instances = meshes.instances(&quads, material.unwrap_or(0));
            let children: Vec<usize> = instances.into_iter().map(|instances| nodes.add(instances)).collect();
            if !children.is_empty() {
                node["children"] = json!(children);
                written.instanced = true;
            }
        }
        let node = nodes.add(node);
        far_to_near.push((cloud.from_eye(still.view.eye).length(), node));
        written.nodes.push(CloudNode { node, material });
    }
    if watch.is_cancelled() {
        return None;
    }
    far_to_near.sort_by(|a, b| b.0.total_cmp(&a.0));
    nodes.top.extend(far_to_near.into_iter().map(|(_, node)| node));
    Some(written)
}

/// The file's meshes and materials.
struct Meshes<'a> {
    root: &'a mut Value,
    buffer: &'a mut Buffer,
    /// Of each tile and material, what a quad of it is.
    tiles: BTreeMap<(u8, usize), usize>,
}

impl Meshes<'_> {
    fn material(&mut self, name: &str, alpha: f64) -> usize {
        push(self.root, "materials", material::material(name, alpha))
    }

    /// One mesh of all quads.
    fn of_cloud(&mut self, name: &str, quads: &[Quad], material: usize) -> usize {
        let corners: Vec<[f32; 3]> =
            quads.iter().flat_map(|quad| quad.corners.map(|corner| corner.to_array())).collect();
        let places: Vec<[f32; 2]> = quads.iter().flat_map(|quad| tile_corners(quad.tile)).collect();
        let colors: Vec<[f32; 4]> = quads.iter().flat_map(|quad| quad.colors).collect();
        let triangles = |quad: u32| QUAD.map(|corner| 4 * quad + corner);
        let indices: Vec<u32> = (0..quads.len() as u32).flat_map(triangles).collect();
        let mesh = json!({ "name": name, "primitives": [{
            "attributes": {
                "POSITION": self.buffer.floats(&corners, Use::Vertices, true),
                "TEXCOORD_0": self.buffer.shares(&places, Use::Vertices),
                "COLOR_0": self.buffer.shares(&colors, Use::Vertices),
            },
            "indices": self.buffer.indices(&indices),
            "material": material,
        }] });
        push(self.root, "meshes", mesh)
    }

    /// A node for each tile of a cloud, with the quads that have it.
    fn instances(&mut self, quads: &[Quad], material: usize) -> Vec<Value> {
        let mut by_tile: BTreeMap<u8, Vec<&Quad>> = BTreeMap::new();
        for quad in quads {
            by_tile.entry(quad.tile).or_default().push(quad);
        }
        let mut nodes = Vec::with_capacity(by_tile.len());
        for (tile, quads) in by_tile {
            let centers: Vec<[f32; 3]> = quads.iter().map(|quad| quad.center.to_array()).collect();
            let turned: Vec<(Quat, [f32; 3])> = quads.iter().map(|quad| turn_and_size(quad.corners)).collect();
            let turns: Vec<[f32; 4]> = turned.iter().map(|(turn, _)| turn.to_array()).collect();
            let sizes: Vec<[f32; 3]> = turned.iter().map(|(_, size)| *size).collect();
            let colors: Vec<[f32; 4]> = quads.iter().map(|quad| mean(quad.colors)).collect();
            nodes.push(json!({
                "mesh": self.tile(tile, material),
                "extensions": { INSTANCING: { "attributes": {
                    "TRANSLATION": self.buffer.floats(&centers, Use::Other, false),
                    "ROTATION": self.buffer.signed_shares(&turns, Use::Other),
                    "SCALE": self.buffer.floats(&sizes, Use::Other, false),
                    "_COLOR_0": self.buffer.shares(&colors, Use::Other),
                } } },
            }));
        }
        nodes
    }

    /// A quad of one tile, a metre wide and high, that faces along +z.
    fn tile(&mut self, tile: u8, material: usize) -> usize {
        if let Some(mesh) = self.tiles.get(&(tile, material)) {
            return *mesh;
        }
        let corners = [[-0.5, 0.5, 0.0], [0.5, 0.5, 0.0], [0.5, -0.5, 0.0], [-0.5, -0.5, 0.0]];
        let mesh = json!({ "name": format!("tile {tile}"), "primitives": [{
            "attributes": {
                "POSITION": self.buffer.floats(&corners, Use::Vertices, true),
                "TEXCOORD_0": self.buffer.shares(&tile_corners(tile), Use::Vertices),
            },
            "indices": self.buffer.indices(&QUAD),
            "material": material,
        }] });
        let mesh = push(self.root, "meshes", mesh);
        self.tiles.insert((tile, material), mesh);
        mesh
    }
}

/// The corners of a quad's two triangles, counter-clockwise as it is seen.
const QUAD: [u32; 6] = [0, 3, 2, 0, 2, 1];

fn tile_corners(tile: u8) -> [[f32; 2]; 4] {
    let [left, top, right, bottom] = tiles::edges(tile);
    [[left, top], [right, top], [right, bottom], [left, bottom]]
}

/// The turn of a quad whose corners those are, from facing along +z, and its width and height.
fn turn_and_size([top_left, top_right, _, bottom_left]: [Vec3; 4]) -> (Quat, [f32; 3]) {
    let (right, up) = (top_right - top_left, top_left - bottom_left);
    let (width, height) = (right.length(), up.length());
    if width <= 0.0 || height <= 0.0 {
        return (Quat::IDENTITY, [width, height, 1.0]);
    }
    let (right, up) = (right / width, up / height);
    (Quat::from_mat3(&Mat3::from_cols(right, up, right.cross(up))).normalize(), [width, height, 1.0])
}

fn mean(colors: [[f32; 4]; 4]) -> [f32; 4] {
    std::array::from_fn(|i| colors.iter().map(|color| color[i].min(1.0)).sum::<f32>() * 0.25)
}
