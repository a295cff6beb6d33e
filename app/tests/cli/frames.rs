//! OpenEXR and HDR pictures, layers, panoramas, and flights that are split over machines.

use crate::{Place, fly};
use exr::meta::attribute::EnvironmentMap;
use exr::prelude::{FlatSamples, ReadChannels, ReadLayers, read};
use std::collections::BTreeMap;
use std::io::Cursor;

/// A file's channels by their names, and what it says about itself.
struct Exr {
    channels: BTreeMap<String, Vec<f32>>,
    about: exr::meta::header::LayerAttributes,
    size: [usize; 2],
}

fn exr(bytes: &[u8]) -> Exr {
    let reader = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
    let layer = reader.from_buffered(Cursor::new(bytes)).expect("an OpenEXR file").layer_data;
    let values = |samples: &FlatSamples| match samples {
        FlatSamples::F16(values) => values.iter().map(|value| value.to_f32()).collect(),
        FlatSamples::F32(values) => values.clone(),
        FlatSamples::U32(_) => Vec::new(),
    };
    let channels = layer.channel_data.list.iter().map(|c| (c.name.to_string(), values(&c.sample_data))).collect();
    Exr { channels, about: layer.attributes, size: [layer.size.x(), layer.size.y()] }
}

/// What the file holds is what a display shows of the PNG: exposure, curve and dither done here once more.
fn shown(linear: f32, exposure: f32) -> f32 {
    use cloudwright_core::{color::srgb_from_linear, tone::tone_curve};
    255.0 * srgb_from_linear(tone_curve(linear * exposure))
}

fn png(bytes: &[u8]) -> Vec<u8> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("its size")];
    reader.next_frame(&mut pixels).expect("whole");
    pixels
}

fn render(place: &Place, words: &str) -> String {
    let ran = place.run(&format!("render good.cloudscene --renderer cpu {words}"));
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    ran.stderr
}

#[test]
fn linear_pictures_are_the_png_before_the_display() {
    let place = Place::new();
    for more in ["", "--samples 4", "--time 20:00", "--truth"] {
        let words = |name: &str| format!("-o {name} --size 64x36 {more}").replace("--renderer cpu --truth", "--truth");
        ["out.png", "out.exr", "out.hdr"].iter().for_each(|name| drop(render(&place, &words(name))));
        let (exr, png) = (exr(&place.read("out.exr")), png(&place.read("out.png")));
        assert_eq!(exr.channels.keys().map(String::as_str).collect::<Vec<_>>(), ["A", "B", "G", "R"]);
        assert!(exr.channels["A"].iter().all(|alpha| *alpha == 1.0));
        let hdr = image::load_from_memory_with_format(&place.read("out.hdr"), image::ImageFormat::Hdr);
        let hdr = hdr.expect("a Radiance file").into_rgb32f();
        assert_eq!((exr.size, hdr.dimensions()), ([64, 36], (64, 36)));
        for (i, byte) in png.iter().enumerate() {
            let linear = exr.channels[["R", "G", "B"][i % 3]][i / 3];
            // Dither and rounding take up to one step, 11 bits of a half's mantissa a tenth.
            let apart = (shown(linear, 1.0) - f32::from(*byte)).abs();
            assert!(apart <= 1.2, "{more}: {linear} is {byte}");
            // 8 bits of mantissa, shared with the largest of the three.
            let largest = ["R", "G", "B"].map(|name| exr.channels[name][i / 3]).into_iter().fold(0.0, f32::max);
            assert!((hdr.as_raw()[i] - linear).abs() <= largest / 100.0, "{more}: {} is {linear}", hdr.as_raw()[i]);
        }
    }
}

#[test]
fn layers_are_written_beside_the_picture() {
    let place = Place::new();
    render(&place, "-o plain.exr --size 64x36");
    render(&place, "-o out.exr --size 64x36 --layers --camera above --at 2 --time 18:30");
    render(&place, "-o out.png --size 64x36 --camera above --at 2 --time 18:30");
    let (plain, out) = (exr(&place.read("plain.exr")), exr(&place.read("out.exr")));
    let of = |name: &str| out.channels.get(name).unwrap_or_else(|| panic!("no {name}"));
    let (alpha, png) = (of("alpha.A"), png(&place.read("out.png")));
    let mut clouded = 0;
    for (i, byte) in png.iter().enumerate() {
        let (pixel, channel) = (i / 3, ["R", "G", "B"][i % 3]);
        let layer = |name: &str| of(&format!("{name}.{channel}"))[pixel];
        let sum = layer("ambient") + layer("directional") + layer("haze");
        let sum = sum + (1.0 - alpha[pixel]) * (layer("sky") + layer("ground") + layer("models"));
        let picture = of(channel)[pixel];
        assert!((shown(sum, 1.0) - shown(picture, 1.0)).abs() <= 0.5, "pixel {pixel}: {sum}, not {picture}");
        assert!((shown(sum, 1.0) - f32::from(*byte)).abs() <= 1.2, "pixel {pixel}: {sum} is {byte}");
        let depth = of("depth.Z")[pixel];
        assert_eq!(depth > 0.0, alpha[pixel] > 0.0, "pixel {pixel}: {depth} m");
        clouded += usize::from(depth > 1000.0 && depth < 10_000.0);
    }
    assert!(clouded > 100, "there are clouds");
    assert!(["motion.X", "motion.Y"].iter().all(|name| of(name).iter().all(|px| px.abs() < 1.0)), "hardly any wind");
    assert!(plain.channels.len() == 4 && out.channels.len() == 28);

    let said = out.about.comments.expect("said").to_string();
    for part in ["scene: good", "camera: above", "clock: 2 s", "time of day: 18:30"] {
        assert!(said.contains(part), "no {part} in {said}");
    }
    let scene = crate::scenes::good_scene();
    let camera = scene.camera_named("above").expect("it has one");
    let vertical = out.about.vertical_field_of_view.expect("said");
    assert!((f64::from(vertical) - camera.field_of_view_deg).abs() < 1e-4, "{vertical}°");
    // The camera is at (0, 2500, 3000) and looks north, 30° down: a point 100 m before it is at −100 on its z.
    let matrix = out.about.world_to_camera.expect("said");
    let point = [0.0, 2500.0 - 50.0, 3000.0 - 100.0 * 0.75_f32.sqrt(), 1.0];
    let seen: [f32; 3] = std::array::from_fn(|column| (0..4).map(|row| point[row] * matrix[4 * row + column]).sum());
    assert!(seen[0].abs() < 1e-2 && seen[1].abs() < 1e-2 && (seen[2] + 100.0).abs() < 1e-2, "{seen:?}");
}

#[test]
fn what_does_not_go_together_is_refused() {
    let place = Place::new();
    let video = fly::place();
    for (words, wanted) in [
        ("render good.cloudscene -o out.png --layers", ["--layers: a .png file has none", ".exr"]),
        ("render good.cloudscene -o out.hdr --layers", ["--layers: a .hdr file has none", ".exr"]),
        ("render good.cloudscene -o out.exr --layers --truth", ["keeps none", "leave"]),
        ("render good.cloudscene -o out.exr --layers --renderer gpu", ["only the CPU", "--renderer cpu"]),
        ("render good.cloudscene -o out.exr --layers --size 16384x16384", ["million", "lower --size"]),
        ("render good.cloudscene -o out.tiff", ["OpenEXR", ".png, .exr or .hdr"]),
        ("render good.cloudscene -o out.exr --panorama cube --layers", ["cannot be used with", "--layers"]),
        ("render good.cloudscene -o out.exr --panorama equirect --size 64x64", ["64x64", "twice as wide"]),
        ("render good.cloudscene -o out.exr --panorama cube --size 64x32", ["64x32", "square"]),
        ("render good.cloudscene -o out.exr --panorama cube --size 16384x16384", ["million", "lower --size"]),
        ("render good.cloudscene -o out.exr --panorama cube --renderer gpu", ["only the CPU", "--renderer cpu"]),
        ("render good.cloudscene -o none/out.exr --panorama cube --size 8x8", ["none", ""]),
    ] {
        let code = if words.contains("none/") { 3 } else { 2 };
        place.refuses(words, code, &wanted);
    }
    for (words, wanted) in [
        ("-o frames --layers", ["--layers: a .png file has none", ".exr"]),
        ("-o out.mp4 --format exr", ["a video is made of PNG", "leave it out"]),
    ] {
        video.refuses(&format!("fly flown.cloudscene --path west --size 64x36 {words}"), 2, &wanted);
    }
}

#[test]
fn the_same_pictures_are_the_same_bytes_on_any_number_of_threads() {
    let place = Place::new();
    for (file, words) in [
        ("out.exr", "--layers --size 200x120"),
        ("out.hdr", "--size 200x120"),
        ("out.exr", "--panorama equirect --size 128x64"),
        ("out_up.exr", "--panorama cube --size 40x40"),
    ] {
        let output = file.replace("_up", "");
        let written = |threads| {
            let ran = place.run_on(threads, &format!("render good.cloudscene --renderer cpu {words} -o {output}"));
            assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
            place.read(file)
        };
        let first = written("1");
        assert!(first == written("1") && first == written("2"), "{words}: other bytes");
    }
}

#[test]
fn panoramas_are_files_as_asked_for() {
    let place = Place::new();
    let before = place.files();
    let new =
        |place: &Place| -> Vec<String> { place.files().into_iter().filter(|name| !before.contains(name)).collect() };
    render(&place, "-o map.exr --panorama equirect --size 128x64");
    let map = exr(&place.read("map.exr"));
    assert_eq!((map.size, map.about.environment_map), ([128, 64], Some(EnvironmentMap::LatitudeLongitude)));
    assert_eq!(new(&place), ["map.exr"]);
    render(&place, "-o sky.png --panorama cube --size 32x32");
    let sides = ["down", "east", "north", "south", "up", "west"].map(|side| format!("sky_{side}.png"));
    assert_eq!(new(&place)[1..], sides);
    let [below, above] = [png(&place.read("sky_down.png")), png(&place.read("sky_up.png"))];
    let blue = |pixels: &[u8]| pixels.chunks(3).map(|p| i64::from(p[2]) - i64::from(p[0])).sum::<i64>();
    assert!(blue(&above) > blue(&below), "the sky is bluer than the ground");
    // Each is what a camera of 90° sees there.
    let scene = crate::scenes::changed(|scene| {
        scene["cameras"][0]["heading_deg"] = serde_json::json!(90.0);
        scene["cameras"][0]["pitch_deg"] = serde_json::json!(0.0);
        scene["cameras"][0]["field_of_view_deg"] = serde_json::json!(90.0);
    });
    place.put("good.cloudscene", &scene);
    render(&place, "-o camera.png --size 32x32");
    let (east, camera) = (png(&place.read("sky_east.png")), png(&place.read("camera.png")));
    let apart = east.iter().zip(&camera).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / east.len() as f64;
    assert!(apart < 1.0, "{apart} steps on the mean");
}

fn flown(place: &Place, words: &str) -> String {
    let ran = place.run(&format!("fly flown.cloudscene --path west --size 64x36 --renderer cpu {words}"));
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    ran.stderr
}

/// Machines that share a flight write what one would have written, by whatever kind of file.
#[test]
fn a_flight_split_over_machines_is_the_whole_flight() {
    for format in ["--format png", "--format exr", "--format hdr", "--format exr --layers --sorting crossfade"] {
        let [whole, first, second] = [(); 3].map(|()| fly::place());
        flown(&whole, &format!("-o out {format}"));
        // As farms write frames, and as Rust does.
        flown(&second, &format!("-o out {format} --frames 6-10"));
        flown(&first, &format!("-o out {format} --frames 0..6"));
        let ending = format.split_whitespace().nth(1).unwrap_or_default();
        for number in 0..11 {
            let machine = if number < 6 { &first } else { &second };
            let name = format!("out/west_{number:05}.{ending}");
            assert!(machine.read(&name) == whole.read(&name), "{format}: frame {number}");
        }
        assert_eq!(std::fs::read_dir(second.path("out")).expect("made").count(), 5, "{format}");
    }
}

#[test]
fn frames_that_are_whole_are_kept_and_others_drawn_again() {
    let place = fly::place();
    for (ending, format) in [("exr", "--format exr --layers"), ("hdr", "--format hdr")] {
        flown(&place, &format!("-o out {format} --frames 0-3"));
        let frame = |number: u32| format!("out/west_{number:05}.{ending}");
        let [whole, cut] = [place.read(&frame(1)), place.read(&frame(2))];
        place.put(&frame(1), &whole[..whole.len() - 9]);
        place.put(&frame(2), b"none");
        let said = flown(&place, &format!("-o out {format} --frames 0-3"));
        assert!(said.contains("2 drawn, 2 kept"), "{said}");
        assert!(place.read(&frame(1)) == whole && place.read(&frame(2)) == cut);
    }
    let said = flown(&place, "-o out --format exr --frames 0-3");
    assert!(said.contains("4 drawn, 0 kept"), "without layers they are others: {said}");
}

/// Motion is until the next frame, also at another rate; from a camera no track says where a film ends.
#[test]
fn a_flight_moves_its_clouds() {
    let place = fly::place();
    let furthest = |fps: u32| {
        flown(&place, &format!("-o out{fps} --format exr --layers --fps {fps} --frames 1-1"));
        let frame = exr(&place.read(&format!("out{fps}/west_00001.exr")));
        assert_eq!(frame.about.frames_per_second, Some((fps as i32, 1)));
        frame.channels["motion.X"].iter().map(|px| px.abs()).fold(0.0, f32::max)
    };
    let (slow, fast) = (furthest(15), furthest(30));
    assert!(slow > 1.5 * fast && fast > 0.05, "{slow} and {fast} pixels");
    let ran = place.run("fly flown.cloudscene --still main --size 32x18 --renderer cpu -o still --frames 3-4");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert_eq!(std::fs::read_dir(place.path("still")).expect("made").count(), 2);
}
