//! The GPU renderer draws what the plain CPU renderer draws, on every backend that this machine has, within what 16-bit
//! floats and 8-bit filters lose (tolerance.rs); and what it cannot do, it says.
//!
//! A backend that is not there shows as ignored, or as failed with CLOUDWRIGHT_REQUIRE_GPU=1.

mod models;

use cloudwright_core::color::Rgb;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Document;
use cloudwright_core::draw_list::{DrawList, Hidden};
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::{Counts, bytes_of_change};
use cloudwright_core::raster::plain;
use cloudwright_core::scene::{Scene, Sun, Weather};
use cloudwright_core::shading::Veil;
use cloudwright_core::sight::Sight;
use cloudwright_core::sky::{MOON_RADIUS, NightSky};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::Moment;
use cloudwright_render::{AdapterChoice, Gpu, GpuRenderer, RenderError};
use cloudwright_tests::gpu::{Allowance, Backend, Case, cases, required};
use cloudwright_tests::part_edits::{PART_EDITS, heaps};
use glam::DVec3;
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use std::process::ExitCode;
use std::sync::{Arc, PoisonError};

/// Largest difference of the clouds in any case, linear. Measured: 0.003 where the shader filters in 32 bits itself,
/// 0.012 with llvmpipe's own filter, which rounds every sum to 8 bits.
const CLOUDS_LARGEST: f32 = 0.02;
/// Mean difference over a layer: two roundings of a 16-bit float at 1.
const CLOUDS_MEAN: f32 = 1.0 / 512.0;
/// Relative difference of the background in linear light: one truncation to 16 bits, and as much again for `exp`.
const BACKGROUND: f32 = 1.0 / 512.0;
/// Steps of 255 in the picture: 0.012 of light is two at sRGB's slope for a mid grey, and dither may add one.
const PICTURE_LARGEST: u8 = 3;
/// Share of pixels that may differ by more than the one step that dither makes of any difference.
const PICTURE_MORE_THAN_ONE: f64 = 0.002;

type Outcome = Result<(), Failed>;
type Check = fn(&Gpu, &mut GpuRenderer, &Case) -> Outcome;

fn main() -> ExitCode {
    let mut arguments = Arguments::from_args();
    // A software rasterizer uses all cores for one picture.
    arguments.test_threads = Some(1);
    let backends = Backend::all();
    let mut trials = Vec::new();
    for backend in &backends {
        for case in cases() {
            for (name, check) in [("clouds", clouds as Check), ("background", background), ("picture", picture)] {
                let case = case.clone();
                let name = format!("{}::{name}::{}", backend.name, case.name);
                trials.push(trial(backend, name, move |gpu, renderer| check(gpu, renderer, &case)));
            }
        }
        for (name, check) in [
            ("a_scene_far_away_is_as_sharp", far_away as fn(&Gpu, &mut GpuRenderer) -> Outcome),
            ("a_picture_too_large_is_an_error", too_large),
            ("the_sprites_pass_can_be_timed", timed),
            ("only_what_changed_is_uploaded", uploads),
            ("a_clock_that_moves_uploads_no_clouds", moments),
            ("each_part_of_a_cloud_is_uploaded_by_itself", part_uploads),
            ("what_is_hidden_is_not_drawn", hidden),
            ("casters_are_uploaded_when_they_are_others", casters),
        ]
        .into_iter()
        .chain(models::TESTS)
        {
            trials.push(trial(backend, format!("{}::{name}", backend.name), check));
        }
        let choice = backend.choice.clone();
        trials.push(trial(backend, format!("{}::a_lost_device_is_an_error", backend.name), move |_, _| lost(&choice)));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn trial(backend: &Backend, name: String, check: impl Fn(&Gpu, &mut GpuRenderer) -> Outcome + Send + 'static) -> Trial {
    let opened = backend.opened.as_ref().map(Arc::clone).map_err(Clone::clone);
    Trial::ignorable_test(name, move || match &opened {
        Ok(opened) => check(&opened.0, &mut opened.1.lock().unwrap_or_else(PoisonError::into_inner))
            .map(|()| Completion::Completed),
        Err(reason) if required() => Err(reason.into()),
        Err(reason) => Ok(Completion::ignored_with(reason)),
    })
}

fn clouds(gpu: &Gpu, renderer: &mut GpuRenderer, case: &Case) -> Outcome {
    case.with_frame(|frame| {
        let worst = Allowance::new(frame).worst(&renderer.clouds(gpu, frame)?);
        ensure(
            worst.share <= 1.0 && worst.difference <= CLOUDS_LARGEST && worst.mean <= CLOUDS_MEAN,
            &format!("clouds are off: {worst:?}"),
        )
    })
}

/// Sky, sun and ground alone, in linear light.
fn background(gpu: &Gpu, renderer: &mut GpuRenderer, case: &Case) -> Outcome {
    let mut case = case.clone();
    case.scene.clouds.clear();
    case.with_frame(|frame| {
        let (want, got) = (plain::linear_picture(frame), renderer.linear_picture(gpu, frame)?);
        for (i, (want, got)) in want.pixels.iter().zip(&got.pixels).enumerate() {
            let disc = if on_the_discs_edge(frame, i) { DISC_EDGE } else { 0.0 };
            let disc = frame.background.dome.sun_disc * disc;
            let night = Rgb::grey(night_edge(frame, i));
            let Rgb { r, g, b } = *want * BACKGROUND + disc + night + Rgb::grey(1e-6);
            let close = (want.r - got.r).abs() <= r && (want.g - got.g).abs() <= g && (want.b - got.b).abs() <= b;
            ensure(close, &format!("pixel {:?}: {got:?} for {want:?}", place(frame, i)))?;
        }
        Ok(())
    })
}

fn picture(gpu: &Gpu, renderer: &mut GpuRenderer, case: &Case) -> Outcome {
    case.with_frame(|frame| {
        let (want, got) = (plain::picture(frame), renderer.picture(gpu, frame)?);
        ensure((want.width, want.height) == (got.width, got.height), "another size")?;
        let mut more_than_one = 0;
        for (i, (want, got)) in want.pixels.iter().zip(&got.pixels).enumerate() {
            let steps = (0..4).map(|c| want[c].abs_diff(got[c])).max().unwrap_or(0);
            if on_the_discs_edge(frame, i) || night_edge(frame, i) > 0.0 {
                continue;
            }
            more_than_one += usize::from(steps > 1);
            ensure(steps <= PICTURE_LARGEST, &format!("pixel {:?}: {got:?} for {want:?}", place(frame, i)))?;
        }
        let share = more_than_one as f64 / want.pixels.len() as f64;
        ensure(share <= PICTURE_MORE_THAN_ONE, &format!("{more_than_one} pixels differ by more than one step"))
    })
}

/// Of the disc's light, where it fades out within 82 steps of an f32 cosine: three steps' rounding at its steepest.
const DISC_EDGE: f32 = 0.06;

fn on_the_discs_edge(frame: &Frame<'_>, i: usize) -> bool {
    let [x, y] = place(frame, i);
    let ray = frame.view.ray(x as f32 + 0.5, y as f32 + 0.5).normalize();
    (0.999_985..0.999_993).contains(&ray.dot(frame.background.dome.sun_direction))
}

/// By how much radiance the night's lights may differ in a pixel. Directions are rounded to some 3·10⁻⁷. On a star's spot, whose
/// slope is at most twice its peak over its radius, that is 2·10⁻⁴ of the brightest star's peak in pixels as fine as the cases'.
/// At the moon's limb what is lit follows from the root of nearly nothing, which loses half of the bits.
fn night_edge(frame: &Frame<'_>, i: usize) -> f32 {
    let Some(night) = frame.background.dome.night else { return 0.0 };
    let ([x, y], pixel) = (place(frame, i), frame.view.pixel());
    let ray = frame.view.ray(x as f32 + 0.5, y as f32 + 0.5).normalize();
    let from_moon = (ray - night.moon_direction).length();
    if night.moon > 0.0 && (from_moon - MOON_RADIUS).abs() < 0.05 * MOON_RADIUS + pixel {
        return 0.06 * night.moon;
    }
    let starless = NightSky { stars: 0.0, ..night };
    let starry = night.lights(ray, pixel) != starless.lights(ray, pixel);
    let brightest_peak = night.stars * 1000.0 * 0.37 / (pixel * pixel);
    if starry { 2e-4 * brightest_peak } else { 0.0 }
}

fn place(frame: &Frame<'_>, i: usize) -> [u32; 2] {
    [i as u32 % frame.view.width, i as u32 / frame.view.width]
}

/// Not a pixel changes when scene and camera move 1,000 km (whole periods of the ground).
fn far_away(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let mut pictures = Vec::new();
    for case in cases().iter().filter(|case| ["noon_beside", "moved_1000_km"].contains(&case.name)) {
        pictures.push(case.with_frame(|frame| renderer.picture(gpu, frame))?);
    }
    ensure(pictures.len() == 2 && pictures[0] == pictures[1], "the moved scene looks different")
}

fn too_large(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let Some(case) = cases().into_iter().next() else { return Err("there are no cases".into()) };
    case.with_frame(|frame| {
        let mut large = frame.clone();
        large.view.width = gpu.device().limits().max_texture_dimension_2d + 1;
        match renderer.draw(gpu, &large).map(|_| ()) {
            Err(error @ RenderError::TooLarge { .. }) => {
                ensure(error.to_string().contains("max_texture_dimension_2d"), &error.to_string())?;
            }
            other => return Err(format!("{other:?}").into()),
        }
        // And the renderer still works.
        renderer.picture(gpu, frame).map(|_| ()).map_err(Failed::from)
    })
}

fn timed(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let Some(case) = cases().into_iter().next() else { return Err("there are no cases".into()) };
    let time = case.with_frame(|frame| renderer.sprites_pass_time(gpu, frame))?;
    ensure(!time.duration.is_zero() && time.duration.as_secs() < 60, &format!("{time:?}"))
}

/// A camera that moves uploads twelve bytes a sprite in view, 96 a cloud and 32 a sprite near the eye; an edit uploads the
/// clouds.
fn uploads(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let Some(case) = cases().into_iter().next() else { return Err("there are no cases".into()) };
    case.with_frame(|frame| {
        let list = &frame.list;
        let each_frame = (12 * list.sprites.len() + 96 * frame.clouds.len() + 32 * list.poses.len()) as u64;
        renderer.draw(gpu, frame)?;
        ensure(renderer.bytes_uploaded() > each_frame, "a scene not seen before was not uploaded")?;
        renderer.draw(gpu, frame)?;
        let again = renderer.bytes_uploaded();
        ensure(again == each_frame, &format!("{again} bytes for a frame that needs {each_frame}"))
    })
}

/// Of a scene in weather, what the air makes of each sprite is sent once; then a moment costs what a camera's does.
fn moments(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let mut scene = heaps();
    scene.weather = Weather { wind_speed_mps: 9.0, turbulence: 0.5, humidity: 0.8, ..Weather::default() };
    let derived = Derived::new(&scene);
    for (step, clock_s) in [0.0, 1.5, 1e5, 0.0].into_iter().enumerate() {
        let sight = Sight { moment: Moment::at(clock_s), ..Sight::still(&scene.cameras[0], [160, 90]) };
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
        renderer.draw(gpu, &frame)?;
        let counts = Counts::of(&frame);
        let want = counts.bytes_uploaded + if step == 0 { counts.bytes_of_clouds } else { 0 };
        let got = renderer.bytes_uploaded();
        ensure(got == want, &format!("{got} bytes at {clock_s} s, where {want} are needed"))?;
    }
    Ok(())
}

/// After each edit: the bytes that core counts, and the picture that a renderer draws which has seen nothing else.
fn part_uploads(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let (mut scene, atlas) = (heaps(), Atlas::built_in());
    // Casters are sent all at once.
    scene.sky.cloud_shadows = 0.0;
    for part in PART_EDITS {
        let mut document = Document::new(scene.clone());
        let before = Derived::new(&scene);
        let change = document.edit(part.name, (part.edits)(&scene))?;
        let mut after = before.clone();
        after.update(document.scene(), &change);
        let sight = Sight::still(&scene.cameras[0], [160, 90]);
        let old = Frame::new(&scene, &before, atlas, &sight);
        let new = Frame::new(document.scene(), &after, atlas, &sight);
        renderer.draw(gpu, &old)?;
        let picture = renderer.picture(gpu, &new)?;
        let want = Counts::of(&new).bytes_uploaded + bytes_of_change(before.clouds(), after.clouds());
        let got = renderer.bytes_uploaded();
        ensure(got == want, &format!("{}: {got} bytes, not {want}", part.name))?;
        let alone = GpuRenderer::new(gpu)?.picture(gpu, &new)?;
        ensure(picture == alone, &format!("{}: another picture than one drawn anew", part.name))?;
        let stays = renderer.picture(gpu, &old)? == picture;
        let looks_alike = ["name"].contains(&part.name);
        ensure(stays == looks_alike, &format!("{}: the edit shows, or not", part.name))?;
    }
    Ok(())
}

/// Clouds cast shadows on the ground; hidden ones none, and for that their sprites are not sent again.
fn casters(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let mut scene = heaps();
    // Looks at the ground below one of them.
    (scene.cameras[0].position, scene.cameras[0].pitch_deg) = (DVec3::new(0.0, 1000.0, 900.0), -48.0);
    scene.sun = Sun::ByHand { heading_deg: 180.0, elevation_deg: 89.0 };
    let derived = Derived::new(&scene);
    let all = Hidden { clouds: scene.clouds.iter().map(|cloud| cloud.id).collect(), ..Hidden::default() };
    let mut ground = |scene: &Scene, hidden: &Hidden| {
        let sight = Sight { hidden: hidden.clone(), ..Sight::still(&scene.cameras[0], [160, 90]) };
        let frame = Frame::new(scene, &derived, Atlas::built_in(), &sight);
        let frame = Frame { list: DrawList::default(), veil: Veil::CLEAR, ..frame };
        Ok::<_, Failed>((renderer.picture(gpu, &frame)?, renderer.bytes_uploaded()))
    };
    let (shadowed, _) = ground(&scene, &Hidden::default())?;
    let (hidden, sent) = ground(&scene, &all)?;
    scene.sky.cloud_shadows = 0.0;
    let (without, _) = ground(&scene, &Hidden::default())?;
    ensure(shadowed != without, "nothing casts a shadow")?;
    ensure(hidden == without, "a hidden cloud casts one")?;
    ensure(sent == 96 * derived.clouds().len() as u64, &format!("{sent} bytes to hide clouds"))
}

/// Hiding is the list's affair: nothing is uploaded anew for it.
fn hidden(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    let Some(case) = cases().into_iter().next() else { return Err("there are no cases".into()) };
    case.with_frame(|frame| {
        renderer.draw(gpu, frame)?;
        let empty = Frame { list: DrawList::default(), veil: Veil::CLEAR, ..frame.clone() };
        let layer = renderer.clouds(gpu, &empty)?;
        ensure(renderer.bytes_uploaded() == 96 * frame.clouds.len() as u64, "hiding uploaded something")?;
        let drawn = layer.pixels.iter().enumerate().find(|(_, pixel)| pixel.a != 0.0);
        let count = layer.pixels.iter().filter(|pixel| pixel.a != 0.0).count();
        ensure(drawn.is_none(), &format!("a hidden cloud was drawn: {drawn:?} {count} of {}", layer.pixels.len()))
    })
}

fn lost(choice: &AdapterChoice) -> Outcome {
    let gpu = Gpu::headless(choice)?;
    let mut renderer = GpuRenderer::new(&gpu)?;
    let Some(case) = cases().into_iter().next() else { return Err("there are no cases".into()) };
    case.with_frame(|frame| {
        renderer.picture(&gpu, frame)?;
        gpu.device().destroy();
        let after = renderer.picture(&gpu, frame).map(|_| ());
        ensure(after.is_err(), "a lost device drew a picture")?;
        ensure(matches!(renderer.draw(&gpu, frame), Err(RenderError::DeviceLost(_))), &format!("it was {after:?}"))
    })
}

fn ensure(holds: bool, otherwise: &str) -> Outcome {
    if holds { Ok(()) } else { Err(otherwise.into()) }
}
