//! A category, chosen by its picture.

use super::{Fields, name_it};
use crate::theme;
use crate::thumbnail::Thumbnails;
use crate::widget::preset_gallery::{category_gallery, category_name};
use cloudwright_core::scene::Category;
use std::cell::RefCell;

const DOC: &str = "Which tiles its sprites show.";

impl Fields<'_> {
    /// A category of its own.
    pub(crate) fn category(&mut self, value: &mut Category, thumbnails: &RefCell<Thumbnails>) {
        let mut own = Some(*value);
        self.choose_category(&mut own, None, thumbnails);
        *value = own.unwrap_or(*value);
    }

    /// A category of its own, or none: then it is `inherited`.
    pub(crate) fn category_or(
        &mut self,
        value: &mut Option<Category>,
        inherited: Category,
        thumbnails: &RefCell<Thumbnails>,
    ) {
        self.choose_category(value, Some(inherited), thumbnails);
    }

    fn choose_category(
        &mut self,
        value: &mut Option<Category>,
        inherited: Option<Category>,
        thumbnails: &RefCell<Thumbnails>,
    ) {
        self.row("Category", DOC, |values| {
            values.value("Category", value, |ui, value| {
                let before = *value;
                let as_model = |category| format!("the model's: {}", category_name(category));
                let shown = value.map(category_name).or(inherited.map(as_model)).unwrap_or_default();
                let menu = ui.menu_button(shown, |ui| {
                    ui.set_width(theme::CATEGORIES_WIDTH);
                    if let Some(inherited) = inherited
                        && ui.selectable_label(value.is_none(), as_model(inherited)).clicked()
                    {
                        *value = None;
                    }
                    if let Some(chosen) = category_gallery(ui, &mut thumbnails.borrow_mut(), *value) {
                        *value = Some(chosen);
                    }
                });
                name_it(ui, &menu.response, "Category");
                menu.response.on_hover_text(DOC);
                *value != before
            });
        });
    }
}
