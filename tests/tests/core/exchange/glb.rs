//! Scenes as binary glTF: what another program reads there is what we draw, and the scene comes back whole.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Document;
use cloudwright_core::exchange::Content;
use cloudwright_core::exchange::motion::{TOLERANCE_DEG, TOLERANCE_M, TOLERANCE_OPACITY};
use cloudwright_core::flight::PathCurve;
use cloudwright_core::formats::{Misread, model_glb, scene_file};
use cloudwright_core::posed_sprite::Still;
use cloudwright_core::scene::{
    Cloud, CloudId, Formation, FormationChange, HowFarFormed, KeyValue, Scene, Thing, Track, TrackId, TrackKey,
};
use cloudwright_core::weather::{Light, WeatherRules};
use cloudwright_tests::small_scenes::{everything, heap};
use glam::{DVec3, Quat, Vec3};
use serde_json::{Value, json};

pub(super) fn shipped_scenes() -> Vec<(String, Scene)> {
    let folder = std::fs::read_dir(cloudwright_tests::root().join("assets/scenes")).expect("scenes ship");
    let mut paths: Vec<_> = folder.map(|entry| entry.expect("readable").path()).collect();
    paths.sort();
    let scene = |path: std::path::PathBuf| {
        let scene = scene_file::read(&std::fs::read(&path).expect("readable")).expect("sound");
        (path.display().to_string(), scene)
    };
    paths.into_iter().map(scene).collect()
}

/// A file as a reader has it: its JSON, and its binary chunk.
struct File {
    root: Value,
    binary: Vec<u8>,
}

impl File {
    fn of(scene: &Scene, plain: bool) -> Self {
        Self::open(&bytes(scene, plain))
    }

    fn open(bytes: &[u8]) -> Self {
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        assert_eq!((&bytes[..4], number(4), number(8)), (&b"glTF"[..], 2, bytes.len()));
        let text = number(12);
        assert_eq!((text % 4, number(20 + text) % 4), (0, 0), "chunks end at multiples of four");
        assert_eq!(28 + text + number(20 + text), bytes.len(), "and nothing follows");
        let root = serde_json::from_slice(&bytes[20..20 + text]).expect("JSON");
        Self { root, binary: bytes[28 + text..].to_vec() }
    }

    fn list(&self, name: &str) -> &[Value] {
        self.root[name].as_array().map_or(&[], Vec::as_slice)
    }

    /// The numbers of an accessor, as they are meant, `N` an item.
    fn numbers<const N: usize>(&self, accessor: &Value) -> Vec<[f32; N]> {
        let accessor = &self.root["accessors"][accessor.as_u64().expect("an index") as usize];
        let view = &self.root["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let at = view["byteOffset"].as_u64().expect("an offset") as usize;
        let bytes = &self.binary[at..at + view["byteLength"].as_u64().expect("a length") as usize];
        let numbers: Vec<f32> = match accessor["componentType"].as_u64() {
            Some(5126) => bytes.as_chunks::<4>().0.iter().map(|four| f32::from_le_bytes(*four)).collect(),
            Some(5123) => {
                bytes.as_chunks::<2>().0.iter().map(|two| f32::from(u16::from_le_bytes(*two)) / 65535.0).collect()
            }
            Some(5122) => {
                bytes.as_chunks::<2>().0.iter().map(|two| f32::from(i16::from_le_bytes(*two)) / 32767.0).collect()
            }
            other => panic!("{other:?}"),
        };
        let items = numbers.as_chunks::<N>().0.to_vec();
        assert_eq!(items.len() as u64, accessor["count"].as_u64().expect("a count"));
        items
    }

    /// Of each node with instances: its instances' places, turns and sizes.
    fn instances(&self, node: &Value) -> Vec<(Vec3, Quat, Vec3)> {
        let attributes = &node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        if attributes.is_null() {
            return Vec::new();
        }
        let [places, sizes] = ["TRANSLATION", "SCALE"].map(|name| self.numbers::<3>(&attributes[name]));
        let turns = self.numbers::<4>(&attributes["ROTATION"]);
        assert_eq!(self.numbers::<4>(&attributes["_COLOR_0"]).len(), places.len());
        let all = places.into_iter().zip(turns).zip(sizes);
        all.map(|((place, turn), size)| (place.into(), Quat::from_array(turn).normalize(), size.into())).collect()
    }

    /// Times and values of a node's channel.
    fn keys<const N: usize>(&self, node: usize, path: &str) -> Vec<(f32, [f32; N])> {
        self.channel(|target| target["node"] == node && target["path"] == path)
    }

    /// Times and values of what moves at that place of the file.
    fn factors(&self, pointer: &str) -> Vec<(f32, [f32; 4])> {
        self.channel(|target| target["extensions"]["KHR_animation_pointer"]["pointer"] == pointer)
    }

    fn channel<const N: usize>(&self, is_target: impl Fn(&Value) -> bool) -> Vec<(f32, [f32; N])> {
        let animation = &self.root["animations"][0];
        let channels = animation["channels"].as_array().expect("channels");
        let channel = channels.iter().find(|channel| is_target(&channel["target"])).expect("it moves");
        let sampler = &animation["samplers"][channel["sampler"].as_u64().expect("an index") as usize];
        let times = self.numbers::<1>(&sampler["input"]);
        times.into_iter().map(|[time]| time).zip(self.numbers(&sampler["output"])).collect()
    }

    fn node(&self, name: &str) -> usize {
        self.list("nodes").iter().position(|node| node["name"] == name).unwrap_or_else(|| panic!("no node {name}"))
    }
}

fn bytes(scene: &Scene, plain: bool) -> Vec<u8> {
    super::left(scene, "a.glb", &[("plain", if plain { "yes" } else { "no" })])
}

fn back(bytes: &[u8]) -> Result<Scene, Misread> {
    match super::arrived(bytes, "a.glb", &[])?.content {
        Content::Scene(scene) => Ok(*scene),
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_sprite_and_camera_of_what_ships_is_there_and_the_scene_comes_back() {
    for (name, scene) in shipped_scenes() {
        let sprites: usize = Derived::new(&scene).clouds().iter().map(|cloud| cloud.sprites.len()).sum();
        let file = bytes(&scene, false);
        let back = back(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
        let text = |scene: &Scene| scene_file::write(scene).expect("a scene");
        assert_eq!(text(&back), text(&scene), "{name}");
        let file = File::open(&file);
        let instances: usize = file.list("nodes").iter().map(|node| file.instances(node).len()).sum();
        assert_eq!(instances, sprites, "{name}");
        assert_eq!(file.list("cameras").len(), scene.cameras.len() + scene.paths.len(), "{name}");
        let plain = File::of(&scene, true);
        let corners: usize = plain
            .list("meshes")
            .iter()
            .map(|mesh| plain.numbers::<3>(&mesh["primitives"][0]["attributes"]["POSITION"]).len())
            .sum();
        assert_eq!(corners, 4 * sprites, "{name}");
        assert!(!plain.root.to_string().contains("EXT_mesh_gpu_instancing"));
    }
}

/// The corners of instances, of plain meshes and of what is drawn are the same within a turn's last step, 1/32767, over a
/// sprite's half diagonal, and what f32 holds.
#[test]
fn instances_stand_where_plain_corners_do() {
    let scene = heap(30);
    let (instanced, plain) = (File::of(&scene, false), File::of(&scene, true));
    let mesh = &plain.root["meshes"][0]["primitives"][0]["attributes"];
    let corners = plain.numbers::<3>(&mesh["POSITION"]);
    let places = plain.numbers::<2>(&mesh["TEXCOORD_0"]);
    let instances: Vec<_> = instanced.list("nodes").iter().flat_map(|node| instanced.instances(node)).collect();
    assert_eq!(instances.len() * 4, corners.len());
    for (i, quad) in corners.as_chunks::<4>().0.iter().enumerate() {
        let quad = quad.map(Vec3::from);
        let center = (quad[0] + quad[2]) * 0.5;
        let (place, turn, size) = instances
            .iter()
            .min_by(|a, b| a.0.distance(center).total_cmp(&b.0.distance(center)))
            .expect("there are instances");
        for (corner, [x, y]) in quad.iter().zip([[-0.5, 0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]]) {
            let instance = *place + *turn * (*size * Vec3::new(x, y, 0.0));
            let bound = size.length() * 4.0 / 32767.0 + 1e-3;
            assert!(instance.distance(*corner) < bound, "{} m", instance.distance(*corner));
        }
        let [left, top] = places[4 * i];
        assert!([left * 4.0, top * 4.0].iter().all(|place| (place - place.round()).abs() < 1e-3), "a tile's corner");
    }
}

#[test]
fn plain_sprites_go_from_far_to_near_with_the_light_that_is_drawn() {
    let scene = heap(30);
    let derived = Derived::new(&scene);
    let file = File::of(&scene, true);
    let mesh = &file.root["meshes"][0]["primitives"][0]["attributes"];
    let node = &file.root["nodes"][file.node(&scene.clouds[0].name)];
    let origin = DVec3::from_array(std::array::from_fn(|i| node["translation"][i].as_f64().expect("a number")));
    let eye = (scene.cameras[0].position - origin).as_vec3();
    let corners = file.numbers::<3>(&mesh["POSITION"]);
    let centers: Vec<Vec3> =
        corners.as_chunks::<4>().0.iter().map(|quad| (Vec3::from(quad[0]) + Vec3::from(quad[2])) * 0.5).collect();
    assert!(centers.windows(2).all(|pair| pair[0].distance(eye) >= pair[1].distance(eye) - 1e-2));
    // The nearest sprite's first corner, by the way that everything else is drawn.
    let view = View::new(&scene.cameras[0], 1, 1);
    let light = Light::at(&scene, scene.time_of_day_h);
    let clouds = derived.clouds_at(0.0, WeatherRules::default());
    let cloud = &clouds[0];
    let still = Still { view: &view, light: &light };
    let last = centers[centers.len() - 1];
    let index = (0..cloud.placed.sprites.len())
        .min_by(|a, b| {
            let far = |i: &usize| cloud.sprite_now(*i).position.distance(last);
            far(a).total_cmp(&far(b))
        })
        .expect("sprites");
    let posed = still.posed(cloud, index);
    let exposure = libm::exp2(scene.sky.exposure_ev) as f32;
    let lit = posed.light_at(posed.corners(Vec3::ZERO)[0]).color();
    let colors = file.numbers::<4>(&mesh["COLOR_0"]);
    let [r, g, b, a] = colors[colors.len() - 4];
    let wanted = (lit.rgb * exposure).to_array();
    for (got, wanted) in [r, g, b, a].into_iter().zip([wanted[0], wanted[1], wanted[2], lit.a]) {
        assert!((got - wanted.min(1.0)).abs() < 1.0 / 65535.0, "{got} for {wanted}");
    }
}

/// Between keys, where it was not looked at, a line may be farther off than where it was; by a parabola's 4/3 at most,
/// and by what f32 holds of the place.
#[test]
fn paths_are_followed_within_the_tolerance() {
    let scene = everything();
    let file = File::of(&scene, false);
    for path in &scene.paths {
        let curve = PathCurve::new(path);
        let node = file.node(&path.name);
        let places = file.keys::<3>(node, "translation");
        let turns = file.keys::<4>(node, "rotation");
        assert!(places.windows(2).all(|pair| pair[0].0 < pair[1].0));
        for step in 0..=4000 {
            let time = curve.duration_s() * f64::from(step) / 4000.0;
            let truth = curve.at(time);
            let (a, b, share) = around(&places, time as f32);
            let place = Vec3::from(a).lerp(Vec3::from(b), share).as_dvec3();
            let bound = TOLERANCE_M * 4.0 / 3.0 + truth.position.abs().max_element() * 2e-7 + 1e-3;
            assert!(place.distance(truth.position) < bound, "{} m at {time}", place.distance(truth.position));
            let (a, b, share) = around(&turns, time as f32);
            let turn = Quat::from_array(a).slerp(Quat::from_array(b), share);
            let error_deg = turn.angle_between(truth.turn().as_quat()).to_degrees();
            // An angle of two f32 turns is known to the root of their last bit.
            assert!(f64::from(error_deg) < TOLERANCE_DEG * 4.0 / 3.0 + 0.06, "{error_deg}° at {time}");
        }
    }
    assert!(!scene.paths.is_empty(), "there is something to follow");
}

/// Clouds that form by their formation, by a track of how far they have formed, by one of their opacity, and that drift:
/// the material's alpha and the node's place follow what is drawn. Between keys a line may be a parabola's 4/3 farther off.
#[test]
fn clouds_form_and_drift_as_they_are_drawn() {
    let mut scene = heap(30);
    let first = scene.clouds[0].clone();
    let mut add = |name: &str| {
        let id = CloudId::new(&mut scene.next_id);
        scene.clouds.push(Cloud { id, name: name.into(), ..first.clone() });
        id
    };
    let [forms, formed, fades] = ["forms", "formed", "fades"].map(&mut add);
    let formation =
        Formation { change: FormationChange::Forming, start_s: 3.0, core_s: 20.0, edges_s: 9.0, threshold: 0.5 };
    scene.clouds.with_id_mut(forms).expect("there").formation = Some(formation);
    scene.clouds.with_id_mut(formed).expect("there").formed = Some(HowFarFormed { core: 1.0, edges: 1.0 });
    let tracks = [
        (formed, "formed/core", [(0.0, 0.0), (17.0, 0.4), (40.0, 1.0)]),
        (fades, "opacity", [(0.0, 0.8), (12.5, 0.3), (40.0, 1.0)]),
    ];
    for (cloud, path, keys) in tracks {
        let keys = keys.map(|(time_s, value)| TrackKey::new(time_s, KeyValue::One(value))).to_vec();
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, format!("cloud/{cloud}/{path}"), keys));
    }
    scene.weather.wind_speed_mps = 12.0;
    let derived = Derived::new(&scene);
    let file = File::of(&scene, false);
    let materials = file.list("materials");
    assert_eq!(materials.len(), 1 + 3, "one for what doesn't form, and one for each that does");
    for step in 0..=400 {
        let time = 40.0 * f64::from(step) / 400.0;
        for cloud in derived.clouds_at(time, WeatherRules::default()) {
            let name = &cloud.placed.name;
            let (a, b, share) = around(&file.keys::<3>(file.node(name), "translation"), time as f32);
            let place = Vec3::from(a).lerp(Vec3::from(b), share).as_dvec3();
            assert!(place.distance(cloud.origin()) < TOLERANCE_M * 4.0 / 3.0 + 1e-3, "{name} at {time}");
            let Some(material) = materials.iter().position(|material| material["name"] == name.as_str()) else {
                assert_eq!(name, &first.name);
                continue;
            };
            let (mut shown, mut all) = (0.0, 0.0);
            for sprite in cloud.placed.sprites.iter() {
                let area = sprite.width * sprite.height;
                shown += area * cloud.opacity_at(cloud.placed.radii_of(sprite.position));
                all += area;
            }
            let pointer = format!("/materials/{material}/pbrMetallicRoughness/baseColorFactor");
            let (a, b, share) = around(&file.factors(&pointer), time as f32);
            let alpha = a[3] + (b[3] - a[3]) * share;
            // Times are f32: 2e-6 s at 40 s, of what changes by 1 in 5 s.
            let bound = TOLERANCE_OPACITY as f32 * 4.0 / 3.0 + 1e-5;
            assert!((alpha - shown / all).abs() < bound, "{name} at {time}: {alpha} for {}", shown / all);
        }
    }
}

/// The keys before and after a time, and which share of the way between them it is.
fn around<const N: usize>(keys: &[(f32, [f32; N])], time: f32) -> ([f32; N], [f32; N], f32) {
    let after = keys.partition_point(|key| key.0 <= time).clamp(1, keys.len() - 1);
    let (a, b) = (keys[after - 1], keys[after]);
    (a.1, b.1, ((time - a.0) / (b.0 - a.0)).clamp(0.0, 1.0))
}

#[test]
fn what_is_no_file_of_ours_says_so() {
    let good = bytes(&heap(3), false);
    for cut in [0, 3, 19, 40, 600] {
        let error = back(&good[..cut]).expect_err("cut off").to_string();
        assert!(error.contains("cut off"), "{error}");
    }
}

/// A binary glTF file of that text, and of so many bytes that it speaks of.
fn by_hand(root: &Value, binary: usize) -> Vec<u8> {
    let mut text = root.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let number = |number: usize| (number as u32).to_le_bytes();
    let mut file = [&b"glTF"[..], &number(2), &number(28 + text.len() + binary), &number(text.len()), b"JSON"].concat();
    file.extend(text);
    file.extend([&number(binary)[..], b"BIN\0"].concat());
    file.resize(file.len() + binary, 0);
    file
}

/// One triangle, of which a test changes something.
fn triangle() -> Value {
    json!({
        "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
        "buffers": [{ "byteLength": 36 }],
    })
}

#[test]
fn a_model_from_elsewhere_stands_or_flies() {
    let plane = std::fs::read(cloudwright_tests::root().join("assets/models/aircraft.glb")).expect("it ships");
    let of = |options: &[(&str, &str)]| match super::arrived(&plane, "jet.glb", options).expect("a model").content {
        Content::Model(model) => model,
        other => panic!("{other:?}"),
    };
    let at = DVec3::new(100.0, 900.0, -50.0);
    let mut document = Document::new(everything());
    let (edits, thing, notes) = of(&[]).put(document.scene(), "tower.glb", at);
    document.edit("Import", edits).expect("it fits");
    let prop = document.scene().props.iter().next_back().expect("one more").clone();
    assert_eq!((thing, notes), (Thing::Prop(prop.id), Vec::new()));
    assert_eq!((prop.model.as_str(), prop.position, prop.scale), ("tower.glb", at, 1.0));
    let model = of(&[("flies", "yes")]);
    let mesh = model_glb::read(&plane).expect("sound");
    assert_eq!(model.triangles * 3, mesh.vertices().len());
    for scene in [Scene::default(), everything()] {
        let mut document = Document::new(scene.clone());
        let (edits, _, notes) = model.put(&scene, "jet.glb", at);
        document.edit("Import", edits).expect("it fits");
        let after = document.scene();
        let aircraft = after.aircraft.iter().next_back().expect("one more");
        assert_eq!((after.aircraft.len(), aircraft.model.as_deref()), (scene.aircraft.len() + 1, Some("jet.glb")));
        assert_eq!(aircraft.path, after.paths[0].id, "{notes:?}");
        assert_eq!(after.paths.len(), scene.paths.len().max(1), "a path only where there is none");
        document.undo();
        assert_eq!(document.scene(), &scene, "one step");
    }
    let (edits, ..) = model.put(&Scene::default(), "../jet.glb", DVec3::ZERO);
    let error = Document::new(Scene::default()).edit("Import", edits).expect_err("elsewhere").to_string();
    assert!(error.contains("“../jet.glb” doesn't lie beside the scene file"), "{error}");
}

#[test]
fn models_that_cannot_come_in_are_told() {
    for (pointer, value, wanted) in [
        ("/buffers/0/uri", json!("https://example.org/a.bin"), "needs the file “https://example.org/a.bin”"),
        ("/buffers/0/uri", json!("../../etc/passwd"), "needs the file “../../etc/passwd”"),
        ("/buffers/0/uri", json!("data:application/octet-stream;base64,%%"), "buffer 0 is no base64"),
        ("/accessors/0/count", json!(4), "accessor 0 reaches beyond its data"),
        ("/accessors/0/count", json!(u64::MAX), "more than 2000000 vertices"),
        ("/bufferViews/0/byteLength", json!(u64::MAX), "accessor 0 reaches beyond its data"),
        ("/nodes/0/children", json!([0]), "node 0 has two parents"),
        ("/meshes/0/primitives", json!([]), "no triangles"),
    ] {
        let mut root = triangle();
        let (parent, key) = pointer.rsplit_once('/').expect("a pointer");
        root.pointer_mut(parent).expect("it is there")[key] = value;
        let error = super::arrived(&by_hand(&root, 36), "a.glb", &[]).expect_err(pointer).to_string();
        assert!(error.starts_with("its model: ") && error.contains(wanted), "{error}");
    }
    let sound = super::arrived(&by_hand(&triangle(), 36), "a.glb", &[]).expect("sound");
    assert!(matches!(sound.content, Content::Model(model) if model.triangles == 1));
}

#[test]
fn same_scene_same_bytes() {
    let scene = everything();
    assert!(bytes(&scene, false) == bytes(&scene, false));
}
