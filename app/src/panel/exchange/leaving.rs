//! As what a scene leaves.

use super::{ExchangeAnswer, Stage, ask, grid, option_rows};
use crate::plugins::Origin;
use crate::theme;
use crate::widget::combo;
use cloudwright_core::exchange::{Corners, FORMATS, Format, Options, Part};
use cloudwright_core::scene::{CameraId, Scene};
use egui::{Context, Ui};
use std::collections::BTreeMap;

/// What is chosen.
#[derive(Debug, Clone)]
pub(crate) struct LeavingChosen {
    pub(crate) format: &'static Format,
    /// Of each format that was looked at, by name.
    options: BTreeMap<&'static str, Options>,
    /// Whether formats that can have corners with their light do.
    shaded: bool,
    /// Whom sprites face; the view if it is none.
    pub(crate) camera: Option<CameraId>,
    /// Whether only what is selected leaves.
    pub(crate) only_selected: bool,
    /// A plugin that is to export instead, which asks for itself.
    pub(crate) exporter: Option<Origin>,
}

impl Default for LeavingChosen {
    fn default() -> Self {
        // That which most other programs open.
        let format = FORMATS.iter().find(|format| format.name == "glb").unwrap_or(&FORMATS[0]);
        Self { format, options: BTreeMap::new(), shaded: false, camera: None, only_selected: false, exporter: None }
    }
}

impl LeavingChosen {
    /// What is set of the format.
    pub(crate) fn options(&self) -> Options {
        self.options.get(self.format.name).cloned().unwrap_or_else(|| self.format.usual_for_writing())
    }

    /// Whether sprites face somebody.
    pub(crate) fn has_corners(&self) -> bool {
        self.format.corners == Corners::Always || self.format.corners == Corners::Asked && self.shaded
    }
}

/// What is shown of it.
#[derive(Clone, Copy)]
pub(crate) struct LeavingForm<'a> {
    pub(crate) scene: &'a Scene,
    /// Plugins that export.
    pub(crate) exporters: &'a [(Origin, String)],
    /// Where the scene's clock stands, seconds.
    pub(crate) clock_s: f64,
    /// Clouds that are selected.
    pub(crate) selected: usize,
    pub(crate) stage: Stage<'a>,
    /// Whether a file's name is not being asked for just now.
    pub(crate) can_go: bool,
}

/// Asks.
pub(crate) fn ask_leaving(
    context: &Context,
    form: &LeavingForm<'_>,
    chosen: &mut LeavingChosen,
) -> Option<ExchangeAnswer> {
    ask(context, ("Export", "Export…"), form.stage, form.can_go, |ui| {
        grid(ui, "export", |ui| rows(ui, form, chosen));
        ui.add_space(theme::GAP);
        ui.label(format!("{}{}.", chosen.format.about[..1].to_uppercase(), &chosen.format.about[1..]));
        let left: Vec<&str> = chosen.format.left_out(form.scene).into_iter().map(Part::name).collect();
        if !left.is_empty() {
            ui.weak(format!("Of this scene it does not carry: {}.", left.join(", ")));
        }
    })
}

/// What exports.
#[derive(Clone)]
enum By<'a> {
    Format(&'static Format),
    Plugin(&'a Origin),
}

fn rows(ui: &mut Ui, form: &LeavingForm<'_>, chosen: &mut LeavingChosen) {
    let formats = FORMATS.iter().filter(|format| format.is_written());
    let title = |format: &Format| format!("{} (.{})", format.title, format.endings[0]);
    let formats = formats.map(|format| (By::Format(format), title(format)));
    let plugins = form.exporters.iter().map(|(origin, name)| (By::Plugin(origin), format!("{name} (plugin)")));
    let all: Vec<(By<'_>, String)> = formats.chain(plugins).collect();
    ui.label("Format");
    let shown = |by: &By<'_>| matches!(by, By::Format(format) if format.name == chosen.format.name);
    match combo(ui, "Format", "", &title(chosen.format), &all, shown) {
        Some(By::Format(format)) => chosen.format = format,
        Some(By::Plugin(origin)) => chosen.exporter = Some(origin.clone()),
        None => {}
    }
    ui.end_row();
    let mut options = chosen.options();
    option_rows(ui, chosen.format.write_options, &mut options);
    chosen.options.insert(chosen.format.name, options);
    if chosen.format.corners == Corners::Asked {
        ui.label("");
        ui.checkbox(&mut chosen.shaded, "With light")
            .on_hover_text("Adds each sprite's four corners with their light.");
        ui.end_row();
    }
    if chosen.has_corners() {
        ui.label("Facing");
        let view = std::iter::once((None, "the view".to_owned()));
        let cameras = form.scene.cameras.iter().map(|camera| (Some(camera.id), camera.name.clone()));
        let all: Vec<_> = view.chain(cameras).collect();
        let shown = |camera: &Option<CameraId>| *camera == chosen.camera;
        let text = all.iter().find(|(camera, _)| shown(camera)).map_or("", |(_, text)| text);
        if let Some(camera) = combo(ui, "Facing", "Whom the sprites face.", text, &all, shown) {
            chosen.camera = camera;
        }
        ui.end_row();
    }
    if form.selected > 0 {
        ui.label("");
        ui.checkbox(&mut chosen.only_selected, "Only the selected clouds");
        ui.end_row();
    }
    if form.clock_s != 0.0 {
        ui.label("");
        ui.weak(format!("as it is at {:.1} s of the clock", form.clock_s));
        ui.end_row();
    }
}
