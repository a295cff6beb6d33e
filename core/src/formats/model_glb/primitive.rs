//! One primitive of a glTF mesh, the triangles of one material: read once, then placed where its node puts it.

use super::data::Data;
use super::{Budget, MAX_REACH_M, ModelError, broken};
use crate::color::Rgb;
use crate::math::unit_or;
use crate::model_mesh::ModelVertex;
use glam::{Mat3, Mat4, Vec3};
use gltf::json;
use gltf::json::Root;
use gltf::json::mesh::{Mode, Semantic};
use gltf::json::validation::Checked;

pub(super) struct Primitive {
    positions: Vec<Vec3>,
    normals: Option<Vec<Vec3>>,
    colors: Option<Vec<Vec3>>,
    /// Indices of the three above, three a triangle.
    triangles: Vec<[usize; 3]>,
    base_color: Rgb,
}

impl Primitive {
    /// None for points and lines.
    pub(super) fn read(
        root: &Root,
        data: &Data<'_>,
        primitive: &json::mesh::Primitive,
        budget: &mut Budget,
    ) -> Result<Option<Self>, ModelError> {
        let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
        let (Checked::Valid(mode), Some(positions)) = (primitive.mode, attribute(Semantic::Positions)) else {
            return Ok(None);
        };
        // What is read and what is drawn both count, before any of it is allocated.
        budget.spend(data.count(positions)?)?;
        let positions = data.vectors(positions)?;
        let corners = primitive.indices.map_or(Ok(positions.len()), |index| data.count(index))?;
        let (count, corners_of) = triangles(mode, corners);
        budget.spend(count.saturating_mul(3).max(corners).saturating_sub(positions.len()))?;
        let mut triangles: Vec<[usize; 3]> = (0..count).map(corners_of).collect();
        if let Some(index) = primitive.indices {
            let indices = data.indices(index)?;
            triangles.iter_mut().flatten().for_each(|corner| *corner = indices[*corner] as usize);
        }
        if triangles.as_flattened().iter().any(|corner| *corner >= positions.len()) {
            return Err(broken("a triangle has a vertex that is not there"));
        }
        let of_each_vertex = |semantic| match attribute(semantic) {
            Some(index) if data.count(index)? != positions.len() => {
                Err(broken(format!("accessor {index} has not as many elements as there are positions")))
            }
            Some(index) => data.vectors(index).map(Some),
            None => Ok(None),
        };
        Ok(Some(Self {
            normals: of_each_vertex(Semantic::Normals)?,
            colors: of_each_vertex(Semantic::Colors(0))?,
            positions,
            triangles,
            base_color: base_color(root, primitive)?,
        }))
    }

    /// Adds the triangles as `world` puts them.
    pub(super) fn place(&self, world: Mat4, vertices: &mut Vec<ModelVertex>) -> Result<(), ModelError> {
        let Mat3 { x_axis: x, y_axis: y, z_axis: z } = Mat3::from_mat4(world);
        let mirrored = x.cross(y).dot(z) < 0.0;
        let side = if mirrored { -1.0 } else { 1.0 };
        // The cofactors: the inverse's transpose but for its length, and no division by 0 in a flattened model.
        let turn_normals = Mat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * side;
        for corners in &self.triangles {
            // A mirrored triangle runs the other way round.
            let [a, b, c] = *corners;
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            let points = corners.map(|corner| world.transform_point3(self.positions[corner]));
            if !points.iter().all(|point| point.length() <= MAX_REACH_M) {
                return Err(ModelError::OutOfReach);
            }
            let flat = unit_or((points[1] - points[0]).cross(points[2] - points[0]), Vec3::Y);
            for (corner, position) in corners.into_iter().zip(points) {
                let normal =
                    self.normals.as_ref().map_or(flat, |normals| unit_or(turn_normals * normals[corner], flat));
                vertices.push(ModelVertex { position, normal, color: self.color(corner) });
            }
        }
        Ok(())
    }

    fn color(&self, corner: usize) -> Rgb {
        let own = self.colors.as_ref().map_or([1.0; 3], |colors| colors[corner].to_array());
        self.base_color * shares(own)
    }
}

/// How many triangles `corners` make, and which corners the i-th one has.
fn triangles(mode: Mode, corners: usize) -> (usize, fn(usize) -> [usize; 3]) {
    match mode {
        Mode::Triangles => (corners / 3, |i| [3 * i, 3 * i + 1, 3 * i + 2]),
        // Every other triangle of a strip runs the other way round.
        Mode::TriangleStrip => (corners.saturating_sub(2), |i| [i, i + 1 + i % 2, i + 2 - i % 2]),
        Mode::TriangleFan => (corners.saturating_sub(2), |i| [i + 1, i + 2, 0]),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => (0, |_| [0; 3]),
    }
}

fn base_color(root: &Root, primitive: &json::mesh::Primitive) -> Result<Rgb, ModelError> {
    let Some(index) = primitive.material else { return Ok(Rgb::grey(1.0)) };
    let material = root.get(index).ok_or_else(|| broken(format!("it has no material {index}")))?;
    let [r, g, b, _] = material.pbr_metallic_roughness.base_color_factor.0;
    Ok(shares([r, g, b]))
}

/// Each into 0 to 1; what is no number, to 0.
fn shares(color: [f32; 3]) -> Rgb {
    let [r, g, b] = color.map(|value| if value > 0.0 { value.min(1.0) } else { 0.0 });
    Rgb::new(r, g, b)
}
