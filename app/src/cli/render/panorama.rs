//! `cloudwright render --panorama`: the sky all around a camera's place, for engines' sky domes.

use super::Arguments;
use crate::cli::failure::Failure;
use crate::cli::input;
use crate::cli::painter::kind_of;
use crate::cli::progress::Progress;
use crate::opening;
use crate::rendering::{Said, check_memory, pack};
use crate::storage::{Over, Together};
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::picture_exr::{About, Eye};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::panorama::{Facet, Side, Surroundings};
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use std::io::Write;
use std::path::{Path, PathBuf};

/// How all directions become pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Projection {
    /// One map of latitude and longitude, twice as wide as high
    Equirect,
    /// Six square files, NAME_east to NAME_north
    Cube,
}

impl Projection {
    fn usual_size(self) -> [u32; 2] {
        match self {
            Self::Equirect => [2048, 1024],
            Self::Cube => [1024, 1024],
        }
    }

    fn check_size(self, [width, height]: [u32; 2]) -> Result<(), Failure> {
        let (fits, hint) = match self {
            Self::Equirect => (width == 2 * height, "an equirect panorama is twice as wide as high: 4096x2048"),
            Self::Cube => (width == height, "a cube's sides are square: 1024x1024"),
        };
        if fits { Ok(()) } else { Err(Failure::argument(format!("--size {width}x{height}"), hint)) }
    }

    /// How many pixels are kept for one that is asked for: of a map all sides, half as wide as it is.
    fn weight(self) -> u64 {
        match self {
            Self::Equirect => 3,
            Self::Cube => 1,
        }
    }

    /// Width and height of one side, pixels.
    fn side(self, [width, _]: [u32; 2]) -> u32 {
        match self {
            Self::Equirect => Surroundings::side_of_map(width),
            Self::Cube => width,
        }
    }
}

pub(super) fn run(arguments: &Arguments, projection: Projection) -> Result<(), Failure> {
    let kind = kind_of(&arguments.output)?;
    let size = arguments.size.unwrap_or(projection.usual_size());
    projection.check_size(size)?;
    let painting = arguments.painter.in_software("--panorama")?;
    let rules = painting.rules()?;
    check_memory(size, rules.pixels_a_pixel(), projection.weight())?;
    let side = projection.side(size);
    let (scene, beside) = opening::open(&arguments.scene)?;
    let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
    let outputs = outputs(&arguments.output, projection);
    outputs.iter().try_for_each(|output| input::check_output(&scene, &arguments.scene, output))?;
    let derived = Derived::new(&scene);
    let mut painter = painting.painter(rules)?;
    let looking = derived.timeline().camera_at(camera, arguments.at);
    let mut sight = Sight {
        moment: Moment { clock_s: arguments.at, time_h: arguments.time },
        meshes: beside.meshes().clone(),
        rules: painter.rules,
        ..Sight::still(&looking, [side; 2])
    };
    let progress = Progress::start_stoppable("rendering");
    let seen = Frame::new(&scene, &derived, beside.sheet(), &sight);
    let said = Said::new(&scene.name, &camera.name, arguments.at, &seen);
    let exposure = seen.now.exposure;
    drop(seen);

    let mut done = 0;
    let mut draw = |facet: Facet| {
        if progress.watch().is_cancelled() {
            return Err(Failure::stopped());
        }
        sight.facet = Some(facet);
        let frame = Frame::new(&scene, &derived, beside.sheet(), &sight);
        let view = frame.view;
        let side = painter.linear(frame, &Watch::cancelled_by(progress.watch().cancelled()))?;
        done += 1;
        progress.set(done as f32 / Side::ALL.len() as f32);
        Ok((view, side))
    };
    let file = |picture: &LinearPicture, eye: Eye<'_>| {
        pack(kind, picture, exposure, &About { comment: &said.comment, eye, frames_a_second: None })
    };
    let mut files = Together::default();
    let mut add = |output: &Path, bytes: &[u8]| files.add(output, Over::Anything, |sink| sink.write_all(bytes));
    match projection {
        Projection::Equirect => {
            let all = Surroundings::for_map(size[0], &looking, |facet, _| draw(facet).map(|(_, side)| side))?;
            add(&arguments.output, &file(&all.map(size[0]), Eye::AllAround)?)?;
        }
        Projection::Cube => {
            for (side, output) in Side::ALL.into_iter().zip(&outputs) {
                let (view, picture) = draw(Facet { side, margin: 0 })?;
                add(output, &file(&picture, Eye::Camera(&view))?)?;
            }
        }
    }
    if progress.watch().is_cancelled() {
        return Err(Failure::stopped());
    }
    files.take_names()?;
    Ok(())
}

/// The files that are written: of a cube one for each side, in the order of [`Side::ALL`].
fn outputs(output: &Path, projection: Projection) -> Vec<PathBuf> {
    match projection {
        Projection::Equirect => vec![output.into()],
        Projection::Cube => {
            let part = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
            let (name, ending) = (part(output.file_stem()), part(output.extension()));
            Side::ALL.map(|side| output.with_file_name(format!("{name}_{}.{ending}", side.name()))).to_vec()
        }
    }
}
