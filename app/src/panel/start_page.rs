//! The start page: scenes that were open, skies to begin with, and what is new. Esc or a click beside it leaves it.

use crate::manual;
use crate::starter::Template;
use crate::theme::{self, icon};
use crate::thumbnail::{Subject, Thumbnails};
use crate::visible;
use crate::widget::{fitted, markdown, name_it, picture_button, side_by_side, template_choice};
use egui::{Button, Context, Id, Modal, RichText, ScrollArea, Ui};
use std::path::{Path, PathBuf};

/// More recent scenes are in *File ▸ Open recent…*.
const MOST_RECENT: usize = 4;
/// Lines of what is new.
const MOST_NEWS: usize = 8;

/// What is shown beside what is always there.
#[derive(Clone, Copy)]
pub(crate) struct StartPage<'a> {
    /// Scenes that were open, those that are still there.
    pub(crate) recent: &'a [PathBuf],
    /// Whether pictures may be drawn by now.
    pub(crate) may_draw: bool,
    /// Whether it is shown at each start.
    pub(crate) at_start: bool,
}

/// What is chosen.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum StartChoice {
    Open(PathBuf),
    OpenOther,
    Begin(Template),
    Report,
    Tour,
    News,
    /// Whether it is to be shown at each start.
    AtStart(bool),
    Close,
}

/// Shows it. None while it stays open.
pub(crate) fn start_page(context: &Context, page: &StartPage<'_>, thumbnails: &mut Thumbnails) -> Option<StartChoice> {
    let modal = Modal::new(Id::unique("start page")).frame(theme::dialog(context));
    let modal = modal.show(context, |ui| {
        fitted(ui, theme::START_WIDTH, |ui| {
            let head = head(ui);
            let room = ui.available_width();
            let news_width = if room > theme::START_WIDTH * 0.9 { theme::NEWS_WIDTH } else { 0.0 };
            let body = ui.horizontal_top(|ui| {
                let skies = ui.vertical(|ui| {
                    ui.set_width(room - news_width - if news_width > 0.0 { 2.0 * theme::GAP } else { 0.0 });
                    skies(ui, page, thumbnails)
                });
                let news = (news_width > 0.0).then(|| ui.vertical(|ui| news(ui, news_width)).inner).flatten();
                skies.inner.or(news)
            });
            ui.add_space(theme::GAP);
            head.or(body.inner).or(foot(ui, page))
        })
    });
    let closed = modal.should_close();
    modal.inner.or(closed.then_some(StartChoice::Close))
}

fn head(ui: &mut Ui) -> Option<StartChoice> {
    ui.horizontal(|ui| {
        ui.heading("Cloudwright");
        ui.weak(env!("CARGO_PKG_VERSION"));
    });
    None
}

fn skies(ui: &mut Ui, page: &StartPage<'_>, thumbnails: &mut Thumbnails) -> Option<StartChoice> {
    let mut chosen = None;
    let mut picture = |subject: Subject| page.may_draw.then(|| thumbnails.texture(&subject)).flatten();
    if !page.recent.is_empty() {
        ui.strong("Recent scenes");
        side_by_side(ui, |ui| {
            for path in page.recent.iter().take(MOST_RECENT) {
                let name = visible::one_line(&path.file_stem().unwrap_or_default().to_string_lossy());
                let texture = picture(Subject::File(path.clone()));
                let response = picture_button(ui, texture, theme::START_PICTURE, &name, None);
                let folder = path.parent().unwrap_or(Path::new("")).display().to_string();
                ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(folder.as_str()));
                if response.on_hover_text(visible::one_line(&path.display().to_string())).clicked() {
                    chosen = Some(StartChoice::Open(path.clone()));
                }
            }
        });
        ui.add_space(theme::GAP);
    }
    ui.strong("Begin with");
    chosen = chosen.or(template_choice(ui, page.may_draw.then_some(thumbnails)).0.map(StartChoice::Begin));
    ui.add_space(theme::GAP);
    ui.horizontal_wrapped(|ui| {
        let report = ui.button((icon::CLOUD, "Weather from a report…"));
        name_it(ui, &report, "Weather from a report");
        if report.on_hover_text("Paste a METAR or a TAF: the sky is made as it says.").clicked() {
            chosen = Some(StartChoice::Report);
        }
        if ui.button("Open a scene…").clicked() {
            chosen = Some(StartChoice::OpenOther);
        }
        if ui.button("Take the tour").on_hover_text("Seven steps; it can be left at any time.").clicked() {
            chosen = Some(StartChoice::Tour);
        }
        if ui.button("All of what's new").clicked() {
            chosen = Some(StartChoice::News);
        }
    });
    chosen
}

fn news(ui: &mut Ui, width: f32) -> Option<StartChoice> {
    ui.set_width(width);
    ui.strong(RichText::new(manual::NEWS));
    ScrollArea::vertical().id_salt("news").max_height(theme::NEWS_HEIGHT).show(ui, |ui| {
        for line in manual::newest(MOST_NEWS) {
            markdown(ui, &line);
        }
    });
    None
}

fn foot(ui: &mut Ui, page: &StartPage<'_>) -> Option<StartChoice> {
    ui.horizontal(|ui| {
        let close = ui.add(Button::new("To the editor")).clicked().then_some(StartChoice::Close);
        let mut on = page.at_start;
        let changed = ui.checkbox(&mut on, "Show this at the start").clicked();
        close.or(changed.then_some(StartChoice::AtStart(on)))
    })
    .inner
}
