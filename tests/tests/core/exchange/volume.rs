//! Clouds as volumes: Mitsuba's, OpenVDB's and FlightGear's files read back by readers of their own.

use super::left_at;
use cloudwright_core::exchange::{ExportError, Note};
use cloudwright_core::formats::xml::{self, Element};
use cloudwright_core::scene::{Category, Scene, Sun};
use cloudwright_tests::small_scenes::{crowd, heap};
use glam::DVec3;
use std::collections::BTreeMap;

/// A grid as a reader has it: voxels along x, y and z, the least and greatest corner, the values with x fastest.
#[derive(Debug, PartialEq)]
struct Grid {
    size: [usize; 3],
    low: [f64; 3],
    high: [f64; 3],
    values: Vec<f32>,
}

/// Numbers out of bytes, one after the other.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.0.split_at(count);
        self.0 = rest;
        taken
    }

    fn array<const N: usize>(&mut self) -> [u8; N] {
        self.take(N).try_into().expect("so many")
    }

    fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.array())
    }

    fn u64(&mut self) -> u64 {
        u64::from_le_bytes(self.array())
    }

    fn f32(&mut self) -> f32 {
        f32::from_le_bytes(self.array())
    }

    fn f64(&mut self) -> f64 {
        f64::from_le_bytes(self.array())
    }

    fn text(&mut self) -> String {
        let count = self.u32() as usize;
        String::from_utf8(self.take(count).to_vec()).expect("text")
    }

    /// The places of a node whose mask has so many.
    fn mask(&mut self, places: usize) -> Vec<usize> {
        let bytes = self.take(places / 8);
        (0..places).filter(|place| bytes[place / 8] >> (place % 8) & 1 == 1).collect()
    }
}

fn read_vol(bytes: &[u8]) -> Grid {
    let mut bytes = Bytes(bytes);
    assert_eq!((bytes.take(3), bytes.take(1)), (&b"VOL"[..], &[3][..]));
    assert_eq!(bytes.u32(), 1, "f32");
    let size = [0; 3].map(|_| bytes.u32() as usize);
    assert_eq!(bytes.u32(), 1, "a channel");
    let [low, high] = [0; 2].map(|_| [0; 3].map(|_| f64::from(bytes.f32())));
    let values: Vec<f32> = (0..size.iter().product()).map(|_| bytes.f32()).collect();
    assert!(bytes.0.is_empty(), "nothing follows");
    Grid { size, low, high, values }
}

/// A file of ours by OpenVDB's own order of things; its tree's axes are the grid's.
fn read_vdb(file: &[u8]) -> (Grid, BTreeMap<String, Vec<u8>>) {
    let mut bytes = Bytes(file);
    assert_eq!((bytes.u64(), bytes.u32()), (0x5644_4220, 224));
    bytes.take(8);
    assert_eq!(bytes.take(1), [1], "with offsets");
    let identifier = String::from_utf8(bytes.take(36).to_vec()).expect("text");
    assert_eq!(identifier.split('-').map(str::len).collect::<Vec<_>>(), [8, 4, 4, 4, 12], "{identifier}");
    assert_eq!((bytes.u32(), bytes.u32()), (0, 1), "nothing said, one grid");
    assert_eq!([0; 3].map(|_| bytes.text()), ["density", "Tree_float_5_4_3", ""]);
    let [at, values_at, end] = [0; 3].map(|_| bytes.u64() as usize);
    assert_eq!((file.len() - bytes.0.len(), file.len()), (at, end));
    assert_eq!(bytes.u32(), 2, "of active voxels alone");
    let said: BTreeMap<String, Vec<u8>> = (0..bytes.u32())
        .map(|_| {
            let (name, _) = (bytes.text(), bytes.text());
            let count = bytes.u32() as usize;
            (name, bytes.take(count).to_vec())
        })
        .collect();
    assert_eq!(bytes.text(), "UniformScaleTranslateMap");
    let [first, voxel, ..] = [0; 6].map(|_| [0; 3].map(|_| bytes.f64()));
    assert_eq!((bytes.u32(), bytes.f32(), bytes.u32()), (1, 0.0, 0), "a buffer, clear elsewhere, no tiles");
    let mut leaves: Vec<([usize; 3], Vec<usize>)> = Vec::new();
    let within =
        |place: usize, log: usize| [place >> (2 * log), place >> log & ((1 << log) - 1), place & ((1 << log) - 1)];
    for _ in 0..bytes.u32() {
        let root = [0; 3].map(|_| bytes.u32() as usize);
        let uppers = bytes.mask(1 << 15);
        assert_eq!((bytes.mask(1 << 15), bytes.take(1)), (Vec::new(), &[0][..]));
        for upper in uppers {
            let lowers = bytes.mask(1 << 12);
            assert_eq!((bytes.mask(1 << 12), bytes.take(1)), (Vec::new(), &[0][..]));
            for lower in lowers {
                let first =
                    [0, 1, 2].map(|axis| root[axis] + 128 * within(upper, 5)[axis] + 8 * within(lower, 4)[axis]);
                leaves.push((first, bytes.mask(512)));
            }
        }
    }
    assert_eq!(file.len() - bytes.0.len(), values_at);
    let mut held: BTreeMap<[usize; 3], f32> = BTreeMap::new();
    for (first, mask) in &leaves {
        assert_eq!((bytes.mask(512), bytes.take(1)), (mask.clone(), &[0][..]));
        for place in mask {
            let at = within(*place, 3);
            held.insert([0, 1, 2].map(|axis| first[axis] + at[axis]), bytes.f32());
        }
    }
    assert!(bytes.0.is_empty(), "nothing follows");
    let size = [0, 1, 2].map(|axis| held.keys().map(|at| at[axis] + 1).max().unwrap_or(0));
    let mut values = vec![0.0; size.iter().product()];
    held.iter().for_each(|([x, y, z], value)| values[(z * size[1] + y) * size[0] + x] = *value);
    let low = [0, 1, 2].map(|axis| first[axis] - 0.5 * voxel[axis]);
    let high = [0, 1, 2].map(|axis| low[axis] + size[axis] as f64 * voxel[axis]);
    (Grid { size, low, high, values }, said)
}

impl Grid {
    fn at(&self, [x, y, z]: [usize; 3]) -> f32 {
        let [width, height, depth] = self.size;
        if x < width && y < height && z < depth { self.values[(z * height + y) * width + x] } else { 0.0 }
    }

    fn middle(&self) -> DVec3 {
        (DVec3::from(self.low) + DVec3::from(self.high)) * 0.5
    }
}

type Left = (BTreeMap<String, Vec<u8>>, Vec<Note>);

fn leaves(scene: &Scene, name: &str, set: &[(&str, &str)]) -> Left {
    let (files, notes) = left_at(scene, name, set, 0.0).expect("it leaves");
    (files.into_iter().collect(), notes)
}

fn names(left: &Left) -> Vec<&str> {
    left.0.keys().map(String::as_str).collect()
}

fn heaps(places: &[DVec3]) -> Scene {
    let mut scene = crowd(places.len() as u32);
    scene.clouds.iter_mut().zip(places).for_each(|(cloud, place)| cloud.position = *place);
    scene
}

#[test]
fn mitsubas_volumes_have_a_scene_beside_them() {
    let scene = Scene {
        sun: Sun::ByHand { heading_deg: 90.0, elevation_deg: 30.0 },
        ..heaps(&[DVec3::new(0.0, 1000.0, 0.0), DVec3::new(4000.0, 1000.0, -900.0)])
    };
    let left = leaves(&scene, "sky.vol", &[("longest", "20")]);
    assert_eq!(names(&left), ["sky.vol", "sky.xml", "sky_2.vol"]);
    let root = xml::read(&left.0["sky.xml"]).expect("XML");
    let named = |element: &Element, name: &str| {
        element.elements().find(|child| child.attribute("name") == Some(name)).cloned().expect("it is there")
    };
    let numbers = |text: &str| -> Vec<f64> { text.split(' ').map(|word| word.parse().expect("a number")).collect() };
    let shapes: Vec<&Element> = root.elements().filter(|element| element.name == "shape").collect();
    assert_eq!(shapes.len(), 2);
    for (shape, file) in shapes.into_iter().zip(["sky.vol", "sky_2.vol"]) {
        let grid = read_vol(&left.0[file]);
        assert_eq!(grid.size.iter().max(), Some(&20));
        assert!(grid.values.iter().all(|value| value.is_finite() && *value >= 0.0));
        assert!(grid.values.iter().any(|value| *value > 1e-3), "{file} holds a cloud");
        let medium = named(shape, "interior");
        assert_eq!(named(&named(&medium, "sigma_t"), "filename").attribute("value"), Some(file));
        let to_world = named(shape, "to_world");
        let of = |tag: &str| numbers(to_world.element(tag).and_then(|each| each.attribute("value")).expect(tag));
        let (half, middle) = (of("scale"), of("translate"));
        for axis in 0..3 {
            assert!((middle[axis] - half[axis] - grid.low[axis]).abs() < 1e-2, "{file} is in its box");
            assert!((middle[axis] + half[axis] - grid.high[axis]).abs() < 1e-2, "{file} fills its box");
        }
    }
    let sun = root.elements().find(|element| element.attribute("type") == Some("directional")).expect("a sun");
    let direction = numbers(named(sun, "direction").attribute("value").expect("a direction"));
    let wanted = [-(30_f64.to_radians().cos()), -0.5, 0.0];
    assert!(direction.iter().zip(wanted).all(|(got, want)| (got - want).abs() < 1e-6), "from the east: {direction:?}");
    assert!(root.elements().any(|element| element.name == "sensor"));
    let told = left.1.iter().filter(|note| note.how.contains("(median)") && note.how.contains("(99th percentile)"));
    assert_eq!(told.count(), 2, "each cloud's error is told: {:?}", left.1);
}

/// Mitsuba has one medium at a place; OpenVDB's readers have as many as there are.
#[test]
fn clouds_that_touch_share_a_medium() {
    let y = 1000.0;
    let places = [[0.0, y, 0.0], [9000.0, y, 0.0], [200.0, y, 0.0], [400.0, y, 50.0]].map(DVec3::from);
    let scene = heaps(&places);
    assert_eq!(names(&leaves(&scene, "a.vol", &[("longest", "16")])), ["a.vol", "a.xml", "a_2.vol"]);
    let left = leaves(&scene, "a.vdb", &[("longest", "16")]);
    assert_eq!(names(&left), ["a.vdb", "a_2.vdb", "a_3.vdb", "a_4.vdb"]);
}

#[test]
fn openvdb_holds_what_mitsuba_does() {
    let scene = heap(30);
    // More than one node of 128 voxels along a side.
    let set = [("longest", "150")];
    let vol = read_vol(&leaves(&scene, "a.vol", &set).0["a.vol"]);
    let bytes = leaves(&scene, "a.vdb", &set).0.remove("a.vdb").expect("a file");
    assert!(bytes == leaves(&scene, "a.vdb", &set).0["a.vdb"], "the same bytes each time");
    assert!(bytes.len() < 2 * vol.values.len(), "sparse: {} bytes for {} voxels", bytes.len(), vol.values.len());
    let (vdb, said) = read_vdb(&bytes);
    assert_eq!((&said["class"][..], &said["name"][..]), (&b"fog volume"[..], &b"density"[..]));
    let z_up = [("longest", "150"), ("z_up", "yes")];
    let (turned, _) = read_vdb(&leaves(&scene, "a.vdb", &z_up).0["a.vdb"]);
    let [width, height, depth] = vol.size;
    for (z, y, x) in (0..depth).flat_map(|z| (0..height).flat_map(move |y| (0..width).map(move |x| (z, y, x)))) {
        let value = vol.at([x, y, z]);
        assert_eq!((vdb.at([x, y, z]), turned.at([x, depth - 1 - z, y])), (value, value), "{x} {y} {z}");
    }
    for axis in 0..3 {
        assert!((vdb.low[axis] - vol.low[axis]).abs() < 1e-2);
    }
    for (got, want) in turned.low.into_iter().zip([vol.low[0], -vol.high[2], vol.low[1]]) {
        assert!((got - want).abs() < 1e-2, "{:?}", turned.low);
    }
}

#[test]
fn a_sequence_drifts_with_the_wind() {
    let mut scene = heap(12);
    (scene.weather.wind_speed_mps, scene.weather.wind_from_deg) = (8.0, 270.0);
    let set = [("longest", "24"), ("frames", "3"), ("step_s", "10")];
    let left = leaves(&scene, "a.vol", &set);
    let wanted = ["a_0001.vol", "a_0001.xml", "a_0002.vol", "a_0002.xml", "a_0003.vol", "a_0003.xml"];
    assert_eq!(names(&left), wanted);
    let [first, second, third] = ["a_0001.vol", "a_0002.vol", "a_0003.vol"].map(|name| read_vol(&left.0[name]));
    for (from, to) in [(&first, &second), (&second, &third)] {
        let moved = to.middle() - from.middle();
        assert!(moved.distance(DVec3::X * 80.0) < 25.0, "to the east by 80 m: {moved}");
    }
    // One that has not formed keeps its place in the sequence.
    scene.clouds[0].opacity = 0.0;
    let left = leaves(&scene, "a.vdb", &set);
    assert_eq!(names(&left), ["a_0001.vdb", "a_0002.vdb", "a_0003.vdb"]);
    assert!(read_vdb(&left.0["a_0001.vdb"]).0.values.is_empty());
}

#[test]
fn far_from_the_origin_positions_count_from_near_by() {
    let place = DVec3::new(4.0e6, 1000.0, -7.0e6);
    let left = leaves(&heaps(&[place]), "a.vol", &[("longest", "40")]);
    let grid = read_vol(&left.0["a.vol"]);
    assert!(grid.low[0].abs().max(grid.low[2].abs()) < 2000.0, "{:?}", grid.low);
    let sides = [0, 1, 2].map(|axis| (grid.high[axis] - grid.low[axis]) / grid.size[axis] as f64);
    assert!(sides.iter().all(|side| (side / sides[0] - 1.0).abs() < 1e-4), "cubes: {sides:?}");
    let how = |note: &&Note| note.what == "positions" && note.how.contains("(4000000, 1000, -7000000)");
    assert!(left.1.iter().any(|note| how(&note)), "{:?}", left.1);
}

#[test]
fn what_can_be_no_volume_is_said() {
    for name in ["a.vol", "a.vdb", "a.voxels.png"] {
        let error = left_at(&heap(0), name, &[], 0.0).expect_err("no sprites");
        assert!(matches!(error, ExportError::Nothing(_)), "{name}: {error}");
    }
    let error = left_at(&heap(9), "a.vdb", &[("voxel_m", "0.2")], 0.0).expect_err("too fine");
    assert!(matches!(error, ExportError::TooMuch { .. }) && error.to_string().contains("voxel_m"), "{error}");
}

/// Slices side by side, as FlightGear cuts them: the simulator's own channels are left to it.
#[test]
fn flightgears_voxels_stand_in_slices() {
    let shown = |category: Category| {
        let mut scene = heap(30);
        scene.models[0].boxes.iter_mut().for_each(|own| own.category = Some(category));
        let (mut files, notes) = leaves(&scene, "a.voxels.png", &[("side", "24")]);
        assert!(notes.iter().any(|note| note.how.starts_with("24 × 24 × ")), "{notes:?}");
        let bytes = files.remove("a.voxels.png").expect("a picture");
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let (width, height) = reader.info().size();
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut pixels).expect("pixels");
        assert_eq!((height, width % height, pixels.len()), (24, 0, 4 * 24 * width as usize));
        let pixels = pixels.as_chunks::<4>().0.to_vec();
        assert!(pixels.iter().all(|[red, _, _, alpha]| (*red, *alpha) == (0, 255)));
        assert_eq!(pixels.iter().map(|[_, _, dense, _]| *dense).max(), Some(255));
        let clear = pixels.iter().filter(|[_, _, dense, _]| *dense == 0).count() as f64 / pixels.len() as f64;
        assert!((0.2..0.95).contains(&clear), "{clear}");
        // The middle of the middle slice is denser than its corner.
        let slices = width as usize / 24;
        let at = |x: usize, z: usize| pixels[z * width as usize + slices / 2 * 24 + x][2];
        assert!(at(12, 12) > at(0, 0), "{} {}", at(12, 12), at(0, 0));
        let weighed = |[_, billowy, dense, _]: &[u8; 4]| f64::from(*billowy) * f64::from(*dense);
        let dense: f64 = pixels.iter().map(|pixel| f64::from(pixel[2])).sum();
        pixels.iter().map(weighed).sum::<f64>() / (255.0 * dense)
    };
    let (puffs, wisps) = (shown(Category::SolidCumulus), shown(Category::Wisps));
    assert!(puffs > 0.7 && wisps < 0.3, "{puffs} {wisps}");
}
