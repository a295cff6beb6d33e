//! A picture into a file: what is asked before it is drawn.

use super::exchange::{ExchangeAnswer, Stage, ask, grid};
use crate::picture_kind::PictureKind;
use crate::storage::PictureSettings;
use crate::widget::{combo, number_field};
use cloudwright_core::math::clock;
use cloudwright_core::method::METHODS;
use cloudwright_core::property::Number;
use cloudwright_core::scene::{CameraId, Scene};
use egui::{Context, Ui};

/// What is shown beside what is chosen.
#[derive(Clone, Copy)]
pub(crate) struct PictureForm<'a> {
    pub(crate) scene: &'a Scene,
    /// Where the scene's clock stands, seconds.
    pub(crate) clock_s: f64,
    /// The hour that is tried out, if one is.
    pub(crate) hour_h: Option<f64>,
    pub(crate) stage: Stage<'a>,
    /// Whether a file's name is not being asked for just now.
    pub(crate) can_go: bool,
}

const fn side(label: &'static str, doc: &'static str) -> Number {
    Number { label, unit: "px", min: 1.0, max: PictureSettings::MAX_SIDE as f64, doc }
}

const SIDES: [Number; 2] = [side("Width", "Of the picture."), side("Height", "Of the picture.")];

/// Asks.
pub(crate) fn ask_picture(
    context: &Context,
    form: &PictureForm<'_>,
    chosen: &mut PictureSettings,
    camera: &mut Option<CameraId>,
) -> Option<ExchangeAnswer> {
    ask(context, ("Render picture", "Render…"), form.stage, form.can_go, |ui| {
        grid(ui, "picture", |ui| rows(ui, form, chosen, camera));
    })
}

/// Who looks: the view, or one of the scene's cameras.
fn camera_row(ui: &mut Ui, scene: &Scene, camera: &mut Option<CameraId>) {
    ui.label("Camera");
    let view = std::iter::once((None, "The view as it is".to_owned()));
    let cameras = scene.cameras.iter().map(|camera| (Some(camera.id), camera.name.clone()));
    let all: Vec<_> = view.chain(cameras).collect();
    choose(ui, "Camera", "From where it is seen.", &all, camera);
    ui.end_row();
}

fn rows(ui: &mut Ui, form: &PictureForm<'_>, chosen: &mut PictureSettings, camera: &mut Option<CameraId>) {
    size_rows(ui, chosen);
    camera_row(ui, form.scene, camera);
    ui.label("File");
    let kinds = PictureKind::ALL.map(|kind| (kind, format!("{} (.{})", kind.name(), kind.ending())));
    let doc = "As what it is written. OpenEXR and HDR hold light before the tone curve.";
    choose(ui, "File", doc, &kinds, &mut chosen.kind);
    ui.end_row();
    if chosen.kind == PictureKind::Exr {
        layers_row(ui, chosen);
    }
    method_rows(ui, chosen);
    let second = (form.clock_s != 0.0).then(|| format!("as it is at {:.1} s of the clock", form.clock_s));
    second.into_iter().chain(form.hour_h.map(tried_out)).for_each(|line| said_row(ui, line));
}

pub(super) fn size_rows(ui: &mut Ui, chosen: &mut PictureSettings) {
    let mut size = chosen.size();
    for (number, side) in SIDES.iter().zip(&mut size) {
        ui.label(number.label);
        let mut value = f64::from(*side);
        if number_field(ui, number.label, number, &mut value, true) {
            *side = value as u32;
        }
        ui.end_row();
    }
    chosen.set_size(size);
}

pub(super) fn layers_row(ui: &mut Ui, chosen: &mut PictureSettings) {
    ui.label("");
    ui.checkbox(&mut chosen.layers, "With layers")
        .on_hover_text("Adds each light by itself, depth and motion, for compositing; drawn on the CPU.");
    ui.end_row();
}

/// By what it is drawn, and how smoothly.
pub(super) fn method_rows(ui: &mut Ui, chosen: &mut PictureSettings) {
    ui.label("Method");
    let methods = METHODS.iter().map(|method| (Some(method.name.to_owned()), method.name.to_owned()));
    let methods: Vec<_> = std::iter::once((None, "As it ships".to_owned())).chain(methods).collect();
    choose(ui, "Method", "How it is drawn.", &methods, &mut chosen.method);
    ui.end_row();
    ui.label("Samples a pixel");
    let samples = |side: u32| (Some(side), (side * side).to_string());
    let samples: Vec<_> = std::iter::once((None, "As the method has".to_owned()))
        .chain((1..=PictureSettings::MAX_SAMPLES_SIDE).map(samples))
        .collect();
    let mut samples_side = chosen.samples_side();
    choose(ui, "Samples a pixel", "More smooth edges, and take longer.", &samples, &mut samples_side);
    chosen.set_samples_side(samples_side);
    ui.end_row();
}

/// Says by which light it will be drawn, if that is not the scene's.
pub(super) fn tried_out(hour_h: f64) -> String {
    format!("by the light of {}, which is tried out", clock(hour_h))
}

/// A line that tells something.
pub(super) fn said_row(ui: &mut Ui, line: String) {
    ui.label("");
    ui.weak(line);
    ui.end_row();
}

/// One of `all`, where something else may stand that is none of them.
pub(super) fn choose<T: Clone + PartialEq>(ui: &mut Ui, label: &str, doc: &str, all: &[(T, String)], chosen: &mut T) {
    let text = all.iter().find(|(each, _)| each == chosen).map_or("", |(_, text)| text);
    if let Some(new) = combo(ui, label, doc, text, all, |each| each == chosen) {
        *chosen = new;
    }
}
