//! Scenes as OpenUSD, by a reader of its own for as much of the text as is needed here.

use super::glb::shipped_scenes;
use super::{left, left_at};
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::exchange::motion::{TOLERANCE_DEG, TOLERANCE_M};
use cloudwright_core::flight::PathCurve;
use cloudwright_core::posed_sprite::Still;
use cloudwright_core::scene::{Cloud, Formation, FormationChange, Scene};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::{Light, WeatherRules};
use cloudwright_tests::small_scenes::{everything, heap};
use glam::{DQuat, DVec3, Vec3};
use std::collections::BTreeMap;

/// A prim: what is declared of it, and the prims in it.
#[derive(Debug, Default)]
struct Prim {
    kind: String,
    metadata: String,
    values: BTreeMap<String, String>,
    children: BTreeMap<String, Self>,
}

impl Prim {
    fn of(text: &str) -> Self {
        let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
        assert_eq!(lines.next(), Some("#usda 1.0"));
        let mut root = Self::default();
        root.fill(&mut lines);
        assert_eq!(lines.next(), None, "every brace has its twin");
        root
    }

    fn fill<'a>(&mut self, lines: &mut impl Iterator<Item = &'a str>) {
        let mut last = None;
        while let Some(line) = lines.next() {
            match line.split(' ').collect::<Vec<_>>()[..] {
                ["}"] => return,
                ["{"] => {
                    let (name, mut prim): (String, Self) = last.take().expect("a head");
                    prim.fill(lines);
                    assert!(self.children.insert(name, prim).is_none(), "names are had once");
                }
                ["("] => {
                    let metadata: Vec<&str> = lines.by_ref().take_while(|line| *line != ")").collect();
                    let of = last.as_mut().map_or(&mut *self, |(_, prim)| prim);
                    of.metadata = metadata.join("\n");
                }
                ["def" | "over", .., name] => {
                    let name = name.trim_matches('"');
                    assert!(name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && !name.is_empty(), "{line}");
                    last = Some((name.into(), Self { kind: line.into(), ..Self::default() }));
                }
                _ => self.value(line, lines),
            }
        }
    }

    fn value<'a>(&mut self, line: &str, lines: &mut impl Iterator<Item = &'a str>) {
        let (name, value) = line.split_once(" = ").unwrap_or((line, ""));
        let end = match value {
            "{" => "}",
            "[" => "]",
            _ => "",
        };
        let mut value = String::from(value.trim_matches(['[', '{']));
        while !end.is_empty() {
            let line = lines.next().expect("an end");
            value.push_str(line);
            value.push('\n');
            if line.contains(end) {
                break;
            }
        }
        assert!(self.values.insert(name.into(), value).is_none(), "{name} twice");
    }

    fn at(&self, path: &str) -> &Self {
        path.split('/')
            .fold(self, |prim, name| prim.children.get(name).unwrap_or_else(|| panic!("no {name} of {path}")))
    }

    fn text(&self, name: &str) -> &str {
        self.values.get(name).unwrap_or_else(|| panic!("no {name}"))
    }

    /// All numbers of a value, `N` an item.
    fn numbers<const N: usize>(&self, name: &str) -> Vec<[f64; N]> {
        let items = numbers(self.text(name));
        assert_eq!(items.len() % N, 0, "{name}");
        items.as_chunks::<N>().0.to_vec()
    }

    /// Seconds and values.
    fn samples<const N: usize>(&self, name: &str) -> Vec<(f64, [f64; N])> {
        let line = |line: &str| {
            let (code, value) = line.split_once(": ").expect("a sample");
            (code.parse::<f64>().expect("a time") / 24.0, numbers(value).try_into().expect("as many"))
        };
        let text = self.text(&format!("{name}.timeSamples"));
        text.lines().filter(|line| line.contains(": ")).map(line).collect()
    }

    /// It and all below it.
    fn all(&self) -> Vec<&Self> {
        std::iter::once(self).chain(self.children.values().flat_map(Self::all)).collect()
    }

    fn of_kind(&self, kind: &str) -> Vec<&Self> {
        self.all().into_iter().filter(|prim| prim.kind.starts_with(&format!("def {kind} "))).collect()
    }
}

fn numbers(text: &str) -> Vec<f64> {
    let text = text.split(" (interpolation").next().unwrap_or_default();
    let words = text.split(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | '-' | 'e'));
    words.filter(|word| !word.is_empty()).map(|word| word.parse().expect("a number")).collect()
}

/// The stage of a scene, and the bytes of the sheet beside it.
fn stage(scene: &Scene) -> (Prim, Vec<u8>, usize) {
    let (files, _) = left_at(scene, "a b@c.usda", &[], 0.0).expect("it leaves");
    let [(name, text), (sheet, png)] = &files[..] else { panic!("{} files", files.len()) };
    assert_eq!((name.as_str(), sheet.as_str()), ("a b@c.usda", "a b_c_atlas.png"));
    (Prim::of(std::str::from_utf8(text).expect("text")), png.clone(), text.len())
}

#[test]
fn every_sprite_camera_and_material_of_what_ships_is_there() {
    for (name, scene) in shipped_scenes() {
        let derived = Derived::new(&scene);
        let (stage, _, bytes) = stage(&scene);
        let sprites: usize = derived.clouds().iter().map(|cloud| cloud.sprites.len()).sum();
        assert!(bytes < 400 * sprites + 400_000, "{name}: {bytes} bytes for {sprites} sprites");
        assert_eq!(stage.of_kind("Camera").len(), scene.cameras.len() + scene.paths.len(), "{name}");
        assert_eq!(stage.at("Sky/Clouds").children.len(), scene.clouds.len(), "{name}");
        let mut quads = 0;
        let materials = &stage.at("Sky/Materials").children;
        for mesh in stage.of_kind("Mesh") {
            let count = mesh.numbers::<1>("int[] faceVertexCounts").len();
            let points = mesh.numbers::<3>("point3f[] points");
            let lengths = [
                mesh.numbers::<4>("int[] faceVertexIndices").len() * 4,
                points.len(),
                mesh.numbers::<3>("color3f[] primvars:displayColor").len(),
                mesh.numbers::<1>("float[] primvars:displayOpacity").len(),
                mesh.numbers::<1>("int[] primvars:st:indices").len(),
            ];
            assert_eq!(lengths, [4 * count; 5], "{name}");
            let places = mesh.numbers::<2>("texCoord2f[] primvars:st").len() as f64;
            assert!(mesh.numbers::<1>("int[] primvars:st:indices").iter().all(|[index]| *index < places));
            let [low, high] = mesh.numbers::<3>("float3[] extent")[..] else { panic!("an extent") };
            assert!(points.iter().all(|point| (0..3).all(|i| (low[i]..=high[i]).contains(&point[i]))), "{name}");
            // Each quad has one material.
            let subsets = mesh.of_kind("GeomSubset");
            let mut faces: Vec<[f64; 1]> = subsets.iter().flat_map(|subset| subset.numbers("int[] indices")).collect();
            faces.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let bound = if subsets.is_empty() { vec![mesh] } else { subsets };
            if !faces.is_empty() {
                assert!(
                    faces.iter().enumerate().all(|(at, face)| face[0] == at as f64) && faces.len() == count,
                    "{name}"
                );
            }
            for prim in bound {
                let material = prim.text("rel material:binding").trim_matches(['<', '>']);
                let material = material.strip_prefix("/Sky/Materials/").expect("a material");
                assert!(materials.contains_key(material), "{name}: {material}");
            }
            quads += count;
        }
        assert_eq!(quads, sprites, "{name}");
    }
}

/// Corners are rounded to a centimetre, colours to 1/10,000.
#[test]
fn quads_are_those_that_are_drawn() {
    let scene = heap(30);
    let derived = Derived::new(&scene);
    let (stage, png, _) = stage(&scene);
    let (name, cloud_prim) = stage.at("Sky/Clouds").children.iter().next().expect("a cloud");
    let mesh = cloud_prim.at(name);
    let points = mesh.numbers::<3>("point3f[] points");
    let colors = mesh.numbers::<3>("color3f[] primvars:displayColor");
    let opacities = mesh.numbers::<1>("float[] primvars:displayOpacity");
    let places = mesh.numbers::<2>("texCoord2f[] primvars:st");
    let indices = mesh.numbers::<4>("int[] primvars:st:indices");
    assert!(png.starts_with(b"\x89PNG"));
    let view = View::new(&scene.cameras[0], 1, 1);
    let light = Light::at(&scene, scene.time_of_day_h);
    let clouds = derived.clouds_at(0.0, WeatherRules::default());
    let cloud = &clouds[0];
    let still = Still { view: &view, light: &light };
    let [origin] = cloud_prim.numbers::<3>("double3 xformOp:translate")[..] else { panic!("a place") };
    assert!(DVec3::from(origin).distance(cloud.origin()) < 1e-3);
    let exposure = libm::exp2(scene.sky.exposure_ev) as f32;
    for index in 0..cloud.placed.sprites.len() {
        let posed = still.posed(cloud, index);
        let corners = posed.corners(posed.sprite.position);
        let far = |quad: &[[f64; 3]; 4]| {
            let order = [0, 3, 2, 1].map(|i| corners[i]);
            order.iter().zip(quad).map(|(a, b)| a.as_dvec3().distance(DVec3::from(*b))).fold(0.0, f64::max)
        };
        let quads = points.as_chunks::<4>().0;
        let at = (0..quads.len()).min_by(|a, b| far(&quads[*a]).total_cmp(&far(&quads[*b]))).expect("quads");
        assert!(far(&quads[at]) < 0.01, "{} m", far(&quads[at]));
        let mean = mean_of(posed.sprite.tile);
        for (i, corner) in [0, 3, 2, 1].into_iter().enumerate() {
            let lit = posed.light_at(posed.corners(Vec3::ZERO)[corner]).color();
            let wanted = (lit.rgb * exposure).to_array();
            for part in 0..3 {
                let wanted = f64::from(wanted[part]) * mean;
                assert!((colors[4 * at + i][part] - wanted).abs() < 1e-4 + 1e-3 * wanted, "{wanted}");
            }
            assert!((opacities[4 * at + i][0] - f64::from(lit.a)).abs() < 1e-4);
        }
        let [left, top] = places[indices[at][0] as usize];
        let (column, row) = (posed.sprite.tile % 4, posed.sprite.tile / 4);
        assert_eq!([left, top], [f64::from(column) / 4.0, 1.0 - f64::from(row) / 4.0]);
        assert_eq!(places[indices[at][2] as usize], [left + 0.25, top - 0.25]);
    }
}

/// What a grey tile leaves of light in the mean.
fn mean_of(tile: u8) -> f64 {
    let texels = &Atlas::built_in().level(usize::from(tile), 0).texels;
    let sum = |part: usize| texels.iter().map(|texel| f64::from(texel[part])).sum::<f64>();
    sum(0) / sum(3)
}

/// As with glTF: a parabola is farther off by 4/3 between where it was looked at; and places are in millimetres.
#[test]
fn paths_are_followed_within_the_tolerance() {
    let scene = everything();
    let (stage, ..) = stage(&scene);
    assert!(!scene.paths.is_empty(), "there is something to follow");
    for path in &scene.paths {
        let curve = PathCurve::new(path);
        let prim = stage.at("Sky/Cameras").all().into_iter().find(|prim| {
            prim.metadata.contains(&format!("displayName = \"{}\"", path.name)) && prim.kind.contains("Camera")
        });
        let prim = prim.expect("a camera");
        let places = prim.samples::<3>("double3 xformOp:translate");
        let turns = prim.samples::<4>("quatf xformOp:orient");
        let [focal, film] = ["float focalLength", "float verticalAperture"].map(|name| prim.numbers::<1>(name)[0][0]);
        let field_of_view_deg = (0.5 * film / focal).atan().to_degrees() * 2.0;
        assert!((field_of_view_deg - path.field_of_view_deg).abs() < 1e-3);
        for step in 0..=2000 {
            let time = curve.duration_s() * f64::from(step) / 2000.0;
            let truth = curve.at(time);
            let (a, b, share) = around(&places, time);
            let place = DVec3::from(a).lerp(DVec3::from(b), share);
            assert!(place.distance(truth.position) < TOLERANCE_M * 4.0 / 3.0 + 2e-3, "at {time}");
            let (a, b, share) = around(&turns, time);
            let [a, b] = [a, b].map(|[w, x, y, z]| DQuat::from_xyzw(x, y, z, w).normalize());
            let error_deg = a.slerp(b, share).angle_between(truth.turn()).to_degrees();
            assert!(error_deg < TOLERANCE_DEG * 4.0 / 3.0 + 1e-3, "{error_deg}° at {time}");
        }
    }
}

fn around<const N: usize>(keys: &[(f64, [f64; N])], time: f64) -> ([f64; N], [f64; N], f64) {
    let after = keys.partition_point(|key| key.0 <= time).clamp(1, keys.len() - 1);
    let (a, b) = (keys[after - 1], keys[after]);
    (a.1, b.1, ((time - a.0) / (b.0 - a.0)).clamp(0.0, 1.0))
}

#[test]
fn a_cloud_that_forms_is_hidden_until_it_does_and_its_materials_fade_in() {
    let mut scene = heap(30);
    let mut cloud = scene.clouds[0].clone();
    cloud.formation = Some(Formation {
        change: FormationChange::Forming,
        start_s: 10.0,
        core_s: 20.0,
        edges_s: 20.0,
        ..Formation::default()
    });
    scene.clouds = vec![cloud].into();
    let (stage, ..) = stage(&scene);
    let cloud = stage.at("Sky/Clouds").children.values().next().expect("a cloud");
    let seen = cloud.text("token visibility.timeSamples");
    let lines: Vec<&str> = seen.lines().filter(|line| line.contains(": ")).collect();
    let [("0", hidden), (code, shown)] = lines.iter().filter_map(|line| line.split_once(": ")).collect::<Vec<_>>()[..]
    else {
        panic!("{seen}")
    };
    assert_eq!((hidden, shown), ("\"invisible\",", "\"inherited\","));
    // It begins at 10 s, with its core alone, of which there is little.
    assert!((240.0..360.0).contains(&code.parse::<f64>().expect("a time")), "{seen}");
    let materials: Vec<&Prim> = stage.all().into_iter().filter(|prim| prim.kind == "over \"tiles\"").collect();
    assert!(!materials.is_empty());
    for material in materials {
        let samples = material.samples::<4>("float4 inputs:scale");
        assert!(samples.is_sorted_by(|a, b| a.0 < b.0 && a.1[3] <= b.1[3]), "{samples:?}");
        assert_eq!((samples[0].1[3], samples.iter().all(|sample| sample.1 == [sample.1[3]; 4])), (0.0, true));
        assert!(samples[samples.len() - 1].1[3] > 0.0);
    }
}

#[test]
fn volumes_name_the_files_beside() {
    let scene = everything();
    let (files, notes) = left_at(&scene, "sky.usda", &[("volumes", "yes")], 0.0).expect("it leaves");
    assert_eq!(files.len(), 1, "no sheet is needed");
    assert!(notes.iter().any(|note| note.how.contains("NAME.vdb")), "{notes:?}");
    let stage = Prim::of(std::str::from_utf8(&files[0].1).expect("text"));
    let volumes = stage.of_kind("OpenVDBAsset");
    let mut names: Vec<&str> = volumes.iter().map(|asset| asset.text("asset filePath")).collect();
    names.sort_unstable();
    // As the volumes' own export names them.
    let (written, _) = left_at(&scene, "sky.vdb", &[("longest", "8")], 0.0).expect("it leaves");
    let mut wanted: Vec<String> = written.iter().map(|(name, _)| format!("@./{name}@")).collect();
    wanted.sort();
    assert_eq!(names, wanted);
    // Grids stand in the world already: nothing carries them at the moment.
    for cloud in stage.at("Sky/Clouds").children.values() {
        assert_eq!(cloud.text("double3 xformOp:translate"), "(0,0,0)");
    }
    for (name, cloud) in &stage.at("Sky/Clouds").children {
        let field = cloud.at("volume").text("rel field:density");
        assert_eq!(field, format!("</Sky/Clouds/{name}/volume/density>"));
    }
}

#[test]
fn names_may_hold_anything() {
    let mut scene = everything();
    scene.name = "a \"sky\" \\ of\nlines {".into();
    let clouds = scene.clouds.iter().map(|cloud| Cloud { name: "7 \"}\" ü".into(), ..cloud.clone() });
    scene.clouds = clouds.collect::<Vec<_>>().into();
    let (stage, ..) = stage(&scene);
    assert_eq!(stage.at("Sky").metadata.lines().next(), Some(r#"displayName = "a \"sky\" \\ of\nlines {""#));
    assert_eq!(stage.at("Sky/Clouds").children.len(), scene.clouds.len());
}

/// As the USDZ specification has it.
#[test]
fn the_zip_is_stored_and_aligned() {
    let scene = heap(5);
    let zip = left(&scene, "a.usdz", &[]);
    let short = |at: usize| usize::from(u16::from_le_bytes([zip[at], zip[at + 1]]));
    let long = |at: usize| short(at) + (short(at + 2) << 16);
    let end = zip.len() - 22;
    assert_eq!((&zip[end..end + 4], short(end + 10)), (&b"PK\x05\x06"[..], 2));
    let mut entry = long(end + 16);
    let mut held = Vec::new();
    for _ in 0..2 {
        assert_eq!(&zip[entry..entry + 4], b"PK\x01\x02");
        let local = long(entry + 42);
        assert_eq!((&zip[local..local + 4], short(local + 8)), (&b"PK\x03\x04"[..], 0), "stored");
        assert_eq!(zip[local + 6..local + 26], zip[entry + 8..entry + 28], "the same is said twice");
        let (named, extra, size) = (short(local + 26), short(local + 28), long(local + 22));
        let start = local + 30 + named + extra;
        assert_eq!(start % 64, 0);
        let bytes = &zip[start..start + size];
        let crc = bytes.iter().fold(!0_u32, |crc, byte| {
            (0..8).fold(crc ^ u32::from(*byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 })
        });
        assert_eq!(!crc as usize, long(local + 14));
        held.push((String::from_utf8_lossy(&zip[local + 30..local + 30 + named]).into_owned(), bytes.to_vec()));
        entry += 46 + short(entry + 28) + short(entry + 30) + short(entry + 32);
    }
    assert_eq!(entry, end);
    let (files, _) = left_at(&scene, "a.usda", &[], 0.0).expect("it leaves");
    assert!(held == files, "the same as side by side, the stage first");
}

#[test]
fn same_scene_same_bytes() {
    let scene = everything();
    assert!(left(&scene, "a.usdz", &[]) == left(&scene, "a.usdz", &[]));
}
