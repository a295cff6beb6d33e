//! Parts of a panel under a title that folds them away. What is folded is remembered by title, over things and starts.

use crate::theme;
use egui::{CollapsingHeader, Context, Id, RichText, Ui};
use std::collections::BTreeSet;

/// Shows `add` under `title`, unless it is folded.
pub(crate) fn section(ui: &mut Ui, title: &'static str, add: impl FnOnce(&mut Ui)) {
    section_called(ui, title, title, add);
}

/// As [`section`], where what is shown tells more than the title by which it is remembered.
pub(crate) fn section_called(ui: &mut Ui, title: &'static str, shown: &str, add: impl FnOnce(&mut Ui)) {
    ui.add_space(theme::GAP);
    let is_open = !folded(ui.ctx()).contains(title);
    let header = CollapsingHeader::new(RichText::new(shown).strong()).id_salt(title).open(Some(is_open));
    if header.show_unindented(ui, |ui| drop(ui.push_id(title, add))).header_response.clicked() {
        let mut all = folded(ui.ctx());
        if is_open {
            all.insert(title.into());
        } else {
            all.remove(title);
        }
        fold(ui.ctx(), all);
    }
}

/// The titles of what is folded.
pub(crate) fn folded(context: &Context) -> BTreeSet<String> {
    context.data(|data| data.get_temp(id())).unwrap_or_default()
}

/// Folds those, and no other.
pub(crate) fn fold(context: &Context, titles: BTreeSet<String>) {
    context.data_mut(|data| data.insert_temp(id(), titles));
}

fn id() -> Id {
    Id::unique("folded sections")
}
