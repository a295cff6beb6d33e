//! All that a user prefers, in one place. What is chosen holds at once; there is nothing to cancel.

use super::{buttons, window};
use crate::command::Keymap;
use crate::editor::preferences::Preference;
use crate::renderer::RendererChoice;
use crate::storage::{Settings, ThemeChoice};
use crate::theme;
use crate::units::Units;
use crate::widget::combo;
use egui::{Context, Grid, Ui};

const THEMES: [(ThemeChoice, &str); 3] =
    [(ThemeChoice::System, "As the desktop"), (ThemeChoice::Dark, "Dark"), (ThemeChoice::Light, "Light")];
const UNITS: [(Units, &str); 2] =
    [(Units::Metric, "Metres and km/h"), (Units::Aviation, "Feet and knots, as in aviation")];
const KEYMAPS: [(Keymap, &str); 2] =
    [(Keymap::Own, "Cloudwright's"), (Keymap::Blender, "Blender's, where it has the command")];
const RENDERERS: [(RendererChoice, &str); 3] = [
    (RendererChoice::Auto, "A GPU if there is one"),
    (RendererChoice::Gpu, "A GPU, also one that is a program"),
    (RendererChoice::Cpu, "The CPU"),
];
/// Times the usual size.
const SCALES: [f32; 9] = [0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5];
/// Seconds.
const PAUSES: [(u32, &str); 5] =
    [(0, "After each change"), (5, "Every 5 s"), (30, "Every 30 s"), (120, "Every 2 min"), (600, "Every 10 min")];

/// Megabytes.
const UNDO: [(u32, &str); 5] =
    [(16, "16 MB"), (64, "64 MB"), (256, "256 MB"), (1024, "1 GB"), (0, "As much as there is")];

/// Some(None) when it is closed.
pub(super) fn choose(context: &Context, settings: &Settings) -> Option<Option<Preference>> {
    window(context, theme::DIALOG_WIDTH, "Preferences", None, |ui| {
        let mut chosen = None;
        Grid::new("preferences").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
            chosen = rows(ui, settings);
        });
        let closed = buttons(ui, |ui| ui.button("Done").clicked().then_some(None));
        chosen.map(Some).or(closed)
    })
}

fn rows(ui: &mut Ui, settings: &Settings) -> Option<Preference> {
    let scales = SCALES.map(|scale| (scale, format!("{:.0} %", scale * 100.0)));
    let scale_text = format!("{:.0} %", settings.scale() * 100.0);
    let pause = settings.keep_work_every_s();
    let pause_text =
        PAUSES.iter().find(|(each, _)| *each == pause).map_or(format!("Every {pause} s"), |(_, text)| (*text).into());
    let undo = settings.undo_mb;
    let undo_text =
        UNDO.iter().find(|(each, _)| *each == undo).map_or(format!("{undo} MB"), |(_, text)| (*text).into());
    let asked = [
        row(ui, "Look", "Of the whole window.", text_of(&THEMES, &settings.theme), &THEMES, &settings.theme)
            .map(Preference::Theme),
        row(
            ui,
            "Size of the interface",
            "Ctrl and plus or minus do it too; Ctrl+0 is the usual size.",
            &scale_text,
            &scales.each_ref().map(|(scale, text)| (*scale, text.as_str())),
            &settings.scale(),
        )
        .map(Preference::Scale),
        row(ui, "Units", "Of altitudes and speeds.", text_of(&UNITS, &settings.units), &UNITS, &settings.units)
            .map(Preference::Units),
        row(ui, "Keys", "Which keys do what.", text_of(&KEYMAPS, &settings.keymap), &KEYMAPS, &settings.keymap)
            .map(Preference::Keymap),
        row(
            ui,
            "Unsaved work is kept",
            "For the case of a crash: what was done since is lost by one.",
            &pause_text,
            &PAUSES,
            &pause,
        )
        .map(Preference::KeepWork),
        row(
            ui,
            "Memory for undo",
            "Beyond it the oldest steps are forgotten; the last can always be taken back.",
            &undo_text,
            &UNDO,
            &undo,
        )
        .map(Preference::UndoMemory),
        row(
            ui,
            "Drawn by",
            "From the next start on; the command line's --renderer goes before it.",
            text_of(&RENDERERS, &settings.renderer),
            &RENDERERS,
            &settings.renderer,
        )
        .map(Preference::Renderer),
    ];
    ui.label("");
    let mut on = settings.start_page;
    let page = ui.checkbox(&mut on, "Show the start page at the start").clicked();
    ui.end_row();
    asked.into_iter().flatten().next().or(page.then_some(Preference::StartPage(on)))
}

/// A name and its choices. The one that was chosen in this frame.
fn row<T: Copy + PartialEq>(
    ui: &mut Ui,
    label: &str,
    doc: &str,
    shown: &str,
    all: &[(T, &str)],
    present: &T,
) -> Option<T> {
    ui.label(label).on_hover_text(doc);
    let all: Vec<(T, String)> = all.iter().map(|(each, text)| (*each, (*text).to_owned())).collect();
    let chosen = combo(ui, label, doc, shown, &all, |each| each == present);
    ui.end_row();
    chosen
}

fn text_of<'a, T: PartialEq>(all: &[(T, &'a str)], present: &T) -> &'a str {
    all.iter().find(|(each, _)| each == present).map_or("", |(_, text)| text)
}
