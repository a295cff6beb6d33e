//! Every shader is valid WGSL and is laid out as the Rust side packs it. Needs no GPU.

#![allow(clippy::panic)] // A test fails with the shader compiler's own message.

use cloudwright_render::{layout, shader};
use naga::valid::{Capabilities, ValidationFlags, Validator};

fn parse(name: &str, source: &str) -> naga::Module {
    naga::front::wgsl::parse_str(source).unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(source)))
}

#[test]
fn every_shader_validates() {
    for (name, source) in shader::all() {
        let module = parse(name, &source);
        // No capability beyond the plain language: it must run on OpenGL too.
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        if let Err(error) = validator.validate(&module) {
            panic!("{name}: {}", error.emit_to_string(&source));
        }
        assert!(module.entry_points.len() >= 2, "{name} has a vertex and a fragment stage");
    }
}

#[test]
fn the_frames_uniform_is_laid_out_alike() {
    for (name, source) in shader::all() {
        let module = parse(name, &source);
        let (_, uniform) =
            module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some("Frame")).expect("every shader has a Frame");
        let naga::TypeInner::Struct { members, span } = &uniform.inner else { panic!("{name}: Frame is a struct") };
        let in_shader: Vec<(&str, usize)> =
            members.iter().map(|member| (member.name.as_deref().unwrap_or(""), member.offset as usize)).collect();
        assert_eq!(in_shader, layout::frame_uniform(), "{name}");
        assert_eq!(*span as usize, layout::frame_uniform_size(), "{name}");
    }
}

#[test]
fn data_textures_are_packed_as_the_shader_reads_them() {
    let module = parse("sprites", &shader::sprites());
    for (name, want) in layout::sprite_constants() {
        let constant = module.constants.iter().find(|(_, constant)| constant.name.as_deref() == Some(name));
        let (_, constant) = constant.unwrap_or_else(|| panic!("sprites.wgsl has no constant {name}"));
        let got = match module.global_expressions[constant.init] {
            naga::Expression::Literal(naga::Literal::U32(value)) => f64::from(value),
            naga::Expression::Literal(naga::Literal::F32(value)) => f64::from(value),
            ref other => panic!("{name}: {other:?}"),
        };
        assert_eq!(got, want, "{name}");
    }
}
