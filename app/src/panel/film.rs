//! A flight, or weather from a camera, into a video or frames: what is asked before it is drawn.

use super::exchange::{ExchangeAnswer, Stage, ask, grid};
use super::picture::{choose, layers_row, method_rows, said_row, size_rows, tried_out};
use crate::picture_kind::PictureKind;
use crate::rendering::count;
use crate::storage::{FilmSettings, There};
use crate::units::counted;
use crate::widget::number_field;
use cloudwright_core::property::Number;
use cloudwright_core::scene::{Scene, Thing};
use egui::{Context, Ui};
use std::ops::Range;

/// What is chosen.
#[derive(Debug, Clone)]
pub(crate) struct FilmChosen {
    /// These are remembered.
    pub(crate) settings: FilmSettings,
    /// The path that is flown, or the camera that films.
    pub(crate) eye: Thing,
    /// How long the camera films, seconds.
    pub(crate) seconds: f64,
    /// Which frames, if not all; the end is not drawn.
    pub(crate) part: Option<Range<u32>>,
}

/// What is shown beside that.
#[derive(Clone, Copy)]
pub(crate) struct FilmForm<'a> {
    pub(crate) scene: &'a Scene,
    /// How long the film is, seconds.
    pub(crate) duration_s: f64,
    /// The hour that is tried out, if one is.
    pub(crate) hour_h: Option<f64>,
    pub(crate) stage: Stage<'a>,
    /// Whether a file's name is not being asked for just now.
    pub(crate) can_go: bool,
}

const SECONDS: Number =
    Number { label: "Duration", unit: "s", min: 0.0, max: 86_400.0, doc: "How long the camera films." };
const RATE: Number = Number {
    label: "Frames a second",
    unit: "",
    min: 1.0,
    max: FilmSettings::MAX_FRAMES_A_SECOND as f64,
    doc: "Of the film.",
};
const FIRST: &str = "First frame";
const LAST: &str = "Last frame";

/// Who can film: each path that goes somewhere, each camera.
pub(crate) fn film_eyes(scene: &Scene) -> Vec<(Thing, String)> {
    let paths = scene.paths.iter().filter(|path| path.keys.len() > 1);
    let paths = paths.map(|path| (Thing::Path(path.id), format!("Path {}", path.name)));
    let cameras = scene.cameras.iter().map(|camera| (Thing::Camera(camera.id), format!("Camera {}", camera.name)));
    paths.chain(cameras).collect()
}

/// Asks.
pub(crate) fn ask_film(context: &Context, form: &FilmForm<'_>, chosen: &mut FilmChosen) -> Option<ExchangeAnswer> {
    ask(context, ("Render flight", "Render…"), form.stage, form.can_go, |ui| {
        grid(ui, "film", |ui| rows(ui, form, chosen));
    })
}

fn rows(ui: &mut Ui, form: &FilmForm<'_>, chosen: &mut FilmChosen) {
    ui.label("Film");
    choose(ui, "Film", "Which path is flown, or which camera films.", &film_eyes(form.scene), &mut chosen.eye);
    ui.end_row();
    if matches!(chosen.eye, Thing::Camera(_)) {
        ui.label(SECONDS.label);
        number_field(ui, SECONDS.label, &SECONDS, &mut chosen.seconds, false);
        ui.end_row();
    }
    size_rows(ui, &mut chosen.settings.frame);
    ui.label(RATE.label);
    let mut rate = f64::from(chosen.settings.frames_a_second());
    if number_field(ui, RATE.label, &RATE, &mut rate, true) {
        chosen.settings.set_frames_a_second(rate as u32);
    }
    ui.end_row();
    kind_rows(ui, &mut chosen.settings);
    method_rows(ui, &mut chosen.settings.frame);
    if matches!(chosen.eye, Thing::Path(_)) && chosen.settings.frame.method.is_none() {
        ui.label("");
        ui.checkbox(&mut chosen.settings.crossfade, "Fade sprites over each other").on_hover_text(
            "A sprite that comes before another fades over it in place of popping. Some 20 % slower; the film of a camera \
             has no need of it.",
        );
        ui.end_row();
    }
    ui.label("Frames there already");
    let there = [
        (There::Refuse, "Stop and say so".to_owned()),
        (There::Keep, "Keep: go on with a film".to_owned()),
        (There::Replace, "Draw anew".to_owned()),
    ];
    let doc = "What becomes of frames of the same names. Those kept show the scene as it was.";
    choose(ui, "Frames there already", doc, &there, &mut chosen.settings.there);
    ui.end_row();
    part_rows(ui, form, chosen);
    form.hour_h.map(tried_out).into_iter().for_each(|line| said_row(ui, line));
}

fn kind_rows(ui: &mut Ui, settings: &mut FilmSettings) {
    ui.label("File");
    let frames = |kind: PictureKind| (Some(kind), format!("Frames, {} (.{})", kind.name(), kind.ending()));
    let kinds: Vec<_> =
        std::iter::once((None, "Video (.mp4)".to_owned())).chain(PictureKind::ALL.map(frames)).collect();
    let mut kind = (!settings.video).then_some(settings.frame.kind);
    choose(ui, "File", "A video needs ffmpeg; its frames stay in a folder beside it.", &kinds, &mut kind);
    ui.end_row();
    settings.video = kind.is_none();
    settings.frame.kind = kind.unwrap_or(settings.frame.kind);
    if kind == Some(PictureKind::Exr) {
        layers_row(ui, &mut settings.frame);
    }
}

/// How many frames there are, and which of them are drawn.
fn part_rows(ui: &mut Ui, form: &FilmForm<'_>, chosen: &mut FilmChosen) {
    let frames = match count(form.duration_s, chosen.settings.frames_a_second()) {
        Ok(frames) => frames,
        Err(error) => return said_row(ui, error.to_string()),
    };
    ui.label("");
    let mut is_part = chosen.part.is_some();
    ui.checkbox(&mut is_part, "Only some of its frames").on_hover_text("Several machines may share a film so.");
    ui.end_row();
    let part = chosen.part.take().unwrap_or(0..frames);
    let [mut first, mut last] = [part.start.min(frames - 1), (part.end - 1).min(frames - 1)];
    if is_part {
        for (label, frame) in [(FIRST, &mut first), (LAST, &mut last)] {
            ui.label(label);
            let number = Number { label, unit: "", min: 0.0, max: f64::from(frames - 1), doc: "Counted from 0." };
            let mut value = f64::from(*frame);
            if number_field(ui, label, &number, &mut value, true) {
                *frame = value as u32;
            }
            ui.end_row();
        }
        chosen.part = Some(first..last.max(first) + 1);
    }
    let drawn = chosen.part.as_ref().map_or(frames, |part| part.end - part.start);
    let all = counted(drawn as usize, "frame", "frames");
    said_row(ui, format!("{all} of a film of {:.2} s", form.duration_s));
}
