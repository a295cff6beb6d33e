//! The models' reader: what it reads, what it says of the rest, and that no bytes make it panic.

use cloudwright_core::color::Rgb;
use cloudwright_core::formats::model_glb::{MAX_BYTES, MAX_REACH_M, ModelError, read};
use cloudwright_core::model_in_view::Meshes;
use cloudwright_core::model_mesh::ModelVertex;
use cloudwright_tests::authoring::aircraft;
use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Value, json};

/// A right angle in the plane of the picture, counter-clockwise from the south.
const POINTS: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bits: Vec<bool> = bytes.iter().flat_map(|byte| (0..8).rev().map(move |i| byte >> i & 1 == 1)).collect();
    bits.chunks(6)
        .map(|six| {
            DIGITS[six.iter().zip([32, 16, 8, 4, 2, 1]).map(|(bit, v)| usize::from(*bit) * v).sum::<usize>()] as char
        })
        .collect()
}

/// A file of one triangle, with `change` made to its JSON.
fn triangle(change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let bytes: Vec<u8> = POINTS.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
    let mut file = json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
        "buffers": [{ "byteLength": 36, "uri": format!("data:application/octet-stream;base64,{}", base64(&bytes)) }],
    });
    change(&mut file);
    serde_json::to_vec(&file).expect("JSON")
}

fn vertex(position: [f32; 3], normal: Vec3, color: Rgb) -> ModelVertex {
    ModelVertex { position: Vec3::from_array(position), normal, color }
}

#[test]
fn triangles_are_read_as_their_nodes_place_them() {
    let white = Rgb::grey(1.0);
    let plain = POINTS.map(|point| vertex(point, Vec3::Z, white));
    let cases: [(&str, fn(&mut Value), [ModelVertex; 3]); 6] = [
        ("as it is", |_| (), plain),
        (
            "painted",
            |file| {
                file["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorFactor": [0.25, 0.5, 0.75, 0.1] } }]);
                file["meshes"][0]["primitives"][0]["material"] = json!(0);
            },
            plain.map(|v| ModelVertex { color: Rgb::new(0.25, 0.5, 0.75), ..v }),
        ),
        (
            "vertices painted by their places",
            |file| file["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = json!(0),
            plain.map(|v| ModelVertex { color: Rgb::new(v.position.x, v.position.y, v.position.z), ..v }),
        ),
        (
            "moved by the child, then turned a quarter to the left by the parent",
            |file| {
                let quarter = std::f32::consts::FRAC_1_SQRT_2;
                file["nodes"] = json!([
                    { "children": [1], "rotation": [0.0, quarter, 0.0, quarter] },
                    { "mesh": 0, "translation": [0.0, 0.0, -2.0] },
                ]);
            },
            [[-2.0, 0.0, 0.0], [-2.0, 0.0, -1.0], [-2.0, 1.0, 0.0]].map(|p| vertex(p, Vec3::X, white)),
        ),
        (
            "mirrored: it runs the other way round",
            |file| file["nodes"][0]["scale"] = json!([-1.0, 1.0, 1.0]),
            [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(|p| vertex(p, Vec3::Z, white)),
        ),
        ("a strip", |file| file["meshes"][0]["primitives"][0]["mode"] = json!(5), plain),
    ];
    for (name, change, want) in cases {
        let mesh = read(&triangle(change)).expect(name);
        assert_eq!(mesh.vertices().len(), 3, "{name}");
        for (got, want) in mesh.vertices().iter().zip(want) {
            // A few roundings of numbers up to 2.
            let close = got.position.distance(want.position) < 1e-6 && got.normal.distance(want.normal) < 1e-6;
            assert!(close && got.color == want.color, "{name}: {got:?} for {want:?}");
        }
    }
}

#[test]
fn what_is_no_model_is_refused_with_a_reason() {
    let broken = |what: &str| ModelError::Broken(what.into());
    let cases: Vec<(Vec<u8>, ModelError)> = vec![
        (vec![], ModelError::NotGltf),
        (b"solid teapot".to_vec(), ModelError::NotGltf),
        (vec![b' '; MAX_BYTES + 1], ModelError::TooLarge(MAX_BYTES + 1)),
        (b"glTF\x02\0\0\0\x03\0\0\0".to_vec(), broken("its head is cut off")),
        (triangle(|file| file["buffers"][0]["uri"] = json!("wings.bin")), ModelError::NeedsFile("wings.bin".into())),
        (
            triangle(|file| file["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
            ModelError::Packed("KHR_draco_mesh_compression".into()),
        ),
        (triangle(|file| file["scenes"][0]["nodes"] = json!([])), ModelError::NoTriangles),
        (triangle(|file| file["meshes"][0]["primitives"][0]["mode"] = json!(1)), ModelError::NoTriangles),
        (triangle(|file| file["nodes"][0]["scale"] = json!([1.0, MAX_REACH_M * 1.1, 1.0])), ModelError::OutOfReach),
        (triangle(|file| file["accessors"][0]["count"] = json!(2_000_001)), ModelError::TooManyVertices),
        (triangle(|file| file["accessors"][0]["count"] = json!(4)), broken("accessor 0 reaches beyond its data")),
        (
            triangle(|file| file["accessors"][0]["byteOffset"] = json!(u64::MAX)),
            broken("accessor 0 reaches beyond its data"),
        ),
        (
            triangle(|file| file["bufferViews"][0]["byteStride"] = json!(4)),
            broken("accessor 0 reaches beyond its data"),
        ),
        (triangle(|file| file["nodes"][0]["children"] = json!([0])), broken("node 0 has two parents")),
        (triangle(|file| file["nodes"][0]["mesh"] = json!(7)), broken("it has no mesh 7")),
        (
            // As a file's own check in the crate would index beyond the end.
            triangle(|file| file["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(9)),
            broken("it has no accessor 9"),
        ),
        (
            triangle(|file| file["meshes"][0]["primitives"][0]["indices"] = json!(0)),
            broken("accessor 0 has no indices"),
        ),
        (
            // The points' own bits as indices: 1.0 is a thousand million.
            triangle(|file| {
                let points = file["accessors"][0].clone();
                file["accessors"] =
                    json!([points, { "bufferView": 0, "componentType": 5125, "count": 9, "type": "SCALAR" }]);
                file["meshes"][0]["primitives"][0]["indices"] = json!(1);
            }),
            broken("a triangle has a vertex that is not there"),
        ),
    ];
    for (bytes, want) in cases {
        let got = read(&bytes).map(|mesh| mesh.vertices().len()).expect_err(&want.to_string());
        assert_eq!(got, want);
    }
}

#[test]
fn the_shipped_aircraft_is_of_its_size() {
    let mesh = Meshes::built_in();
    let triangles = mesh.vertices().len() / 3;
    assert!((300..2000).contains(&triangles), "{triangles} triangles");
    let reduce = |f: fn(Vec3, Vec3) -> Vec3| mesh.vertices().iter().map(|v| v.position).reduce(f).expect("vertices");
    let (low, high) = (reduce(Vec3::min), reduce(Vec3::max));
    assert!((high.x - 5.5).abs() < 0.01 && (low.x + 5.5).abs() < 0.01, "11 m of span: {low} to {high}");
    assert!((7.5..8.5).contains(&(high.z - low.z)), "8 m long: {low} to {high}");
    assert!(low.z > -3.0, "its centre of gravity is nearer to the nose, which is at −z: {low}");
    for v in mesh.vertices() {
        assert!((v.normal.length() - 1.0).abs() < 1e-5, "{v:?}");
    }
    for corners in mesh.vertices().as_chunks::<3>().0 {
        let [a, b, c] = corners.map(|v| v.position);
        let out = corners.iter().map(|v| v.normal).sum::<Vec3>();
        assert!((b - a).cross(c - a).dot(out) > 0.0, "counter-clockwise from outside: {corners:?}");
    }
}

#[test]
fn every_beginning_of_a_file_is_refused() {
    let file = aircraft::glb();
    for end in (0..file.len()).step_by(97) {
        assert!(read(&file[..end]).is_err(), "{end} bytes are no whole file");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400), binary in any::<bool>()) {
        let head: &[u8] = if binary { b"glTF\x02\0\0\0" } else { b"" };
        let _ = read(&[head, &bytes].concat());
    }

    /// Bits flipped anywhere, with a liking for the head and the JSON behind it.
    #[test]
    fn flipped_bits(hits in prop::collection::vec((any::<prop::sample::Index>(), 0..8_u8, any::<bool>()), 1..6)) {
        let mut file = aircraft::glb();
        for (at, bit, near_head) in hits {
            let end = if near_head { 4000 } else { file.len() };
            file[at.index(end)] ^= 1 << bit;
        }
        let _ = read(&file);
    }

    /// A number of the JSON replaced by another.
    #[test]
    fn wild_numbers(at in any::<prop::sample::Index>(), wild in prop::sample::select(vec!["1e999", "-1", "0", "1", "4294967295", "18446744073709551615", "5121", "null", "\"7\"", "[]"])) {
        let text = String::from_utf8(triangle(|_| ())).expect("text");
        let starts: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(i, _)| i).collect();
        let start = starts[at.index(starts.len())];
        let length = text[start..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(1);
        let _ = read(format!("{}{wild}{}", &text[..start], &text[start + length..]).as_bytes());
    }
}
