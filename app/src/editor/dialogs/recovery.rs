//! What other editors left when they ended without saving.

use super::{buttons, window};
use crate::storage::Orphan;
use crate::theme;
use egui::{Align, Layout, ScrollArea, Ui};
use std::path::Path;
use std::time::SystemTime;

/// What becomes of an orphan, by its index.
pub(super) enum Fate {
    Recover(usize),
    Discard(usize),
    /// All stay, and are offered at the next start.
    Later,
}

pub(super) fn choose(context: &egui::Context, orphans: &[Orphan]) -> Option<Fate> {
    window(context, theme::WIDE_DIALOG_WIDTH, "Recover unsaved work?", Fate::Later, |ui| {
        ui.label("Cloudwright ended without saving it. Recovered work still has to be saved.");
        ui.add_space(theme::GAP);
        let mut fate = None;
        ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).show(ui, |ui| {
            for (index, orphan) in orphans.iter().enumerate() {
                fate = row(ui, index, orphan).or(fate.take());
            }
        });
        buttons(ui, |ui| ui.button("Later").clicked().then_some(Fate::Later)).or(fate)
    })
}

fn row(ui: &mut Ui, index: usize, orphan: &Orphan) -> Option<Fate> {
    let (name, about) = match &orphan.rescue {
        Ok(rescue) => {
            let path = rescue.path.as_deref();
            let name = path.and_then(Path::file_name).map_or("New scene".into(), |name| name.to_string_lossy());
            let folder = path.and_then(Path::parent).map(|folder| format!(", {}", folder.display()));
            (name.into_owned(), format!("{}{}", ago(rescue.saved_at()), folder.unwrap_or_default()))
        }
        Err(why) => ("Unreadable work".into(), why.clone()),
    };
    ui.horizontal(|ui| {
        let mut fate = None;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut button = |verb: &str| {
                let response = ui.button(verb);
                ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(format!("{verb} {name}")));
                response.clicked()
            };
            if button("Discard") {
                fate = Some(Fate::Discard(index));
            }
            if button("Recover") {
                fate = Some(Fate::Recover(index));
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.strong(&name);
                ui.add(egui::Label::new(egui::RichText::new(&about).weak()).truncate()).on_hover_text(&about);
            });
        });
        fate
    })
    .inner
}

/// How long ago, to be read at a glance.
fn ago(moment: SystemTime) -> String {
    let minutes = SystemTime::now().duration_since(moment).unwrap_or_default().as_secs() / 60;
    match minutes {
        0 => "a moment ago".into(),
        1..60 => format!("{minutes} min ago"),
        60..2880 => format!("{} h ago", minutes / 60),
        _ => format!("{} days ago", minutes / 1440),
    }
}
