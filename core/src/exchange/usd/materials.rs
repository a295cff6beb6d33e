//! What shows the sheet of tiles: preview surfaces that shine by the light at the corners, where a tile is opaque.
//!
//! A preview surface multiplies nothing, so a quad's alpha can't be the sheet's times that of its corners. The sheet's is
//! scaled instead, by a sprite's mean alpha in steps of 1/64, so that a mesh has a material for each step that its sprites
//! have. A cloud that forms has one, by the mean of all its sprites and how far it has formed. All are the first one with
//! another scale.

use super::{FINE_STEPS, ROOT, code};
use crate::exchange::motion::Course;
use crate::exchange::quads::Quad;
use crate::formats::usda::{Text, Tuple, beside};
use std::collections::BTreeMap;

const STEPS: f32 = 64.0;

/// The materials of all meshes: by the cloud that forms, if it does, and the step.
#[derive(Default)]
pub(super) struct Materials<'a>(BTreeMap<(Option<usize>, u8), Option<&'a Course>>);

/// Those of one mesh, by their names, with the quads that have each.
pub(super) struct OfMesh(Vec<(String, Vec<usize>)>);

impl<'a> Materials<'a> {
    /// The materials of a cloud's quads; its place and course, if it forms.
    pub(super) fn of(&mut self, quads: &[Quad], forms: Option<(usize, &'a Course)>) -> OfMesh {
        let alpha = |quad: &Quad| quad.colors.iter().map(|color| color[3]).sum::<f32>() * 0.25;
        let mean = quads.iter().map(alpha).sum::<f32>() / quads.len().max(1) as f32;
        let mut by_step: BTreeMap<u8, Vec<usize>> = BTreeMap::new();
        for (at, quad) in quads.iter().enumerate() {
            let alpha = if forms.is_some() { mean } else { alpha(quad) };
            by_step.entry((alpha.clamp(0.0, 1.0) * STEPS).round() as u8).or_default().push(at);
        }
        let cloud = forms.map(|(cloud, _)| cloud);
        self.0.extend(by_step.keys().map(|step| ((cloud, *step), forms.map(|(_, course)| course))));
        OfMesh(by_step.into_iter().map(|(step, quads)| (name(cloud, step), quads)).collect())
    }

    pub(super) fn write(&self, text: &mut Text, sheet_name: &str) {
        text.prim("def Scope \"Materials\"", &[], |text| {
            first(text, sheet_name);
            for ((cloud, step), course) in &self.0 {
                let references = [format!("references = <{ROOT}/Materials/sprites>")];
                text.prim(&format!("def Material \"{}\"", name(*cloud, *step)), &references, |text| {
                    text.prim("over \"tiles\"", &[], |text| scale(text, f64::from(*step) / f64::from(STEPS), *course));
                });
            }
        });
    }
}

impl OfMesh {
    /// Binds them, to the whole mesh if there is one alone.
    pub(super) fn bind(&self, text: &mut Text) {
        let bind = |text: &mut Text, name: &str| text.set("rel material:binding", format!("<{ROOT}/Materials/{name}>"));
        if let [(name, _)] = &self.0[..] {
            return bind(text, name);
        }
        text.set("uniform token subsetFamily:materialBind:familyType", "\"partition\"");
        for (name, quads) in &self.0 {
            let metadata = ["prepend apiSchemas = [\"MaterialBindingAPI\"]".into()];
            text.prim(&format!("def GeomSubset \"{name}\""), &metadata, |text| {
                text.set("uniform token elementType", "\"face\"");
                text.set("uniform token familyName", "\"materialBind\"");
                text.list("int[] indices", quads.iter().map(|quad| [quad]), "");
                bind(text, name);
            });
        }
    }
}

fn name(cloud: Option<usize>, step: u8) -> String {
    cloud.map_or_else(|| format!("alpha_{step}"), |cloud| format!("cloud_{}_alpha_{step}", cloud + 1))
}

/// What the sheet's alpha is multiplied with; its colours too, which no one reads, as Blender takes alpha's factor from them.
fn scale(text: &mut Text, alpha: f64, course: Option<&Course>) {
    let scale = |alpha: f64| Tuple::of([alpha; 4], FINE_STEPS);
    match course {
        Some(course) => {
            let samples = course.formed.iter().map(|(time, share)| (code(*time), scale(alpha * share)));
            text.samples("float4 inputs:scale", samples);
        }
        None => text.set("float4 inputs:scale", scale(alpha)),
    }
}

/// The one that all others are made of.
fn first(text: &mut Text, sheet_name: &str) {
    let path = format!("{ROOT}/Materials/sprites");
    text.prim("def Material \"sprites\"", &[], |text| {
        text.set("token outputs:surface.connect", format!("<{path}/surface.outputs:surface>"));
        let shader = |text: &mut Text, name: &str, id: &str, fill: &dyn Fn(&mut Text)| {
            text.prim(&format!("def Shader \"{name}\""), &[], |text| {
                text.set("uniform token info:id", format!("\"{id}\""));
                fill(text);
            });
        };
        shader(text, "surface", "UsdPreviewSurface", &|text| {
            text.set("color3f inputs:diffuseColor", "(0,0,0)");
            text.set("color3f inputs:emissiveColor.connect", format!("<{path}/light.outputs:result>"));
            // That of air: nothing is mirrored.
            text.set("float inputs:ior", 1);
            text.set("float inputs:metallic", 0);
            text.set("float inputs:opacity.connect", format!("<{path}/tiles.outputs:a>"));
            text.set("token inputs:opacityMode", "\"presence\"");
            text.set("float inputs:roughness", 1);
            text.line("token outputs:surface");
        });
        shader(text, "light", "UsdPrimvarReader_float3", &|text| {
            text.set("float3 inputs:fallback", "(1,1,1)");
            text.set("string inputs:varname", "\"displayColor\"");
            text.line("float3 outputs:result");
        });
        shader(text, "places", "UsdPrimvarReader_float2", &|text| {
            text.set("string inputs:varname", "\"st\"");
            text.line("float2 outputs:result");
        });
        shader(text, "tiles", "UsdUVTexture", &|text| {
            text.set("asset inputs:file", beside(sheet_name));
            text.set("token inputs:sourceColorSpace", "\"sRGB\"");
            text.set("float2 inputs:st.connect", format!("<{path}/places.outputs:result>"));
            text.set("token inputs:wrapS", "\"clamp\"");
            text.set("token inputs:wrapT", "\"clamp\"");
            text.line("float outputs:a");
            text.line("float3 outputs:rgb");
        });
    });
}
