//! Controls that several panels, the viewport or a dialog use. They show a value and tell what was done with it.

pub(crate) mod checkerboard;
mod chosen_level;
mod fields;
mod fitted;
mod handle;
pub(crate) mod kept;
mod markdown;
mod offer;
mod picture_choice;
pub(crate) mod section;
mod work_bar;

pub(crate) use chosen_level::{LEVEL_STEP, choose_level, chosen_level};
pub(crate) use fields::{
    ENDLESS, Fields, MOST_CHARACTERS, Span, brightness_field, color_field, color32, combo, field_to_key, key_button,
    lines_field, name_button, name_it, number_field, refusal, seed_field, span_field, text_field,
};
pub(crate) use fitted::fitted;
pub(crate) use handle::{Handle, Handled};
pub(crate) use kept::Kept;
pub(crate) use markdown::{markdown, with_known_glyphs};
pub(crate) use offer::{context_menu, menu_line, offer};
pub use picture_choice::{category_choice, preset_choice};
pub(crate) use picture_choice::{picture_button, side_by_side, template_choice};
pub(crate) use section::{section, section_called};
pub(crate) use work_bar::work_bar;
