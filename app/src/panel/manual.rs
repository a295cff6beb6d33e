//! The manual's window: pages at the left, one of them at the right, a search above. It stands beside the work, not before it.

use crate::manual::{self, Page};
use crate::theme::{self, icon};
use crate::widget::{markdown, name_it, with_known_glyphs};
use egui::{Align, Context, Id, Key, Layout, RichText, ScrollArea, TextEdit, TextStyle, Ui, Vec2, Window};

/// Which page is read, while the window is open.
#[derive(Debug)]
pub(crate) struct Manual {
    title: &'static str,
    typed: String,
    /// The page is another one than in the last frame: it is read from its top.
    is_new: bool,
}

impl Manual {
    /// At the page of that title.
    pub(crate) fn at(title: &'static str) -> Self {
        Self { title, typed: String::new(), is_new: true }
    }

    /// Shows it. Whether it stays open.
    pub(crate) fn show(&mut self, context: &Context) -> bool {
        let window = context.content_rect();
        let room = window.size() - 3.0 * Vec2::splat(theme::DIALOG_MARGIN);
        let shown = Window::new("Manual")
            .id(Id::unique("manual"))
            .frame(theme::dialog(context))
            .title_bar(false)
            .default_pos(window.center() - 0.5 * theme::MANUAL_SIZE.min(room))
            .default_size(theme::MANUAL_SIZE.min(room))
            .max_size(room)
            .constrain_to(window)
            .show(context, |ui| self.content(ui));
        shown.and_then(|shown| shown.inner).unwrap_or(true)
    }

    /// Whether it stays open.
    fn content(&mut self, ui: &mut Ui) -> bool {
        let closed = ui.horizontal(|ui| self.head(ui)).inner;
        ui.add_space(theme::GAP);
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                ui.set_width(theme::PAGES_WIDTH);
                ScrollArea::vertical().id_salt("pages").auto_shrink(false).show(ui, |ui| self.pages(ui));
            });
            ui.separator();
            ui.vertical(|ui| {
                let area = ScrollArea::vertical().id_salt("page").auto_shrink(false);
                let is_new = std::mem::take(&mut self.is_new);
                let area = if is_new { area.vertical_scroll_offset(0.0) } else { area };
                area.show(ui, |ui| {
                    ui.set_width(ui.available_width() - theme::GAP);
                    if let Some(page) = manual::PAGES.iter().find(|page| page.title == self.title) {
                        ui.heading(page.title);
                        markdown(ui, &page.text);
                    }
                });
            });
        });
        !closed
    }

    /// Title, search, and the button that closes it: whether it was pressed.
    fn head(&mut self, ui: &mut Ui) -> bool {
        ui.heading("Manual");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let close = ui.button(icon::X);
            name_it(ui, &close, "Close the manual");
            let field = TextEdit::singleline(&mut self.typed).hint_text("Search all pages");
            let field = ui.add(field.desired_width(ui.available_width() - theme::GAP));
            name_it(ui, &field, "Search the manual");
            // Esc ends the typing, and takes it back.
            if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Escape)) {
                self.typed.clear();
            }
            close.clicked()
        })
        .inner
    }

    fn pages(&mut self, ui: &mut Ui) {
        let found = manual::search(&self.typed);
        if found.is_empty() {
            ui.weak("No page has these words");
        }
        for (page, line) in found {
            self.offer(ui, page, line.filter(|_| !self.typed.is_empty()));
        }
    }

    fn offer(&mut self, ui: &mut Ui, page: &Page, line: Option<&str>) {
        let chosen = ui.selectable_label(page.title == self.title, page.title);
        name_it(ui, &chosen, &format!("Page {}", page.title));
        if chosen.clicked() {
            (self.title, self.is_new) = (page.title, true);
        }
        if let Some(line) = line {
            let line = with_known_glyphs(ui, &TextStyle::Small.resolve(ui.style()), line);
            ui.add(egui::Label::new(RichText::new(line).small().weak()).truncate());
        }
    }
}
