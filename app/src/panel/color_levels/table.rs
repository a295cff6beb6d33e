//! All values of the five levels, highest first, as they lie in the cloud.

use crate::state::color_levels;
use crate::widget::{brightness_field, color_field, name_it, number_field};
use cloudwright_core::property::{ALPHA, LEVEL_HEIGHT};
use cloudwright_core::scene::ColorLevels;
use egui::{Grid, Ui};

/// What [`show`] will take, points: a row of heads and the levels.
pub(super) fn height(ui: &Ui) -> f32 {
    let spacing = ui.spacing();
    6.0 * (spacing.interact_size.y + spacing.item_spacing.y) + spacing.item_spacing.y
}

/// Fields change `levels`, and the one that is touched is `chosen`. `diamond` shows that of a value of the chosen one, by
/// its place in a level.
pub(super) fn show(ui: &mut Ui, levels: &mut ColorLevels, chosen: &mut usize, diamond: &mut dyn FnMut(&mut Ui, &str)) {
    let chosen_row = levels.len() - (*chosen).min(levels.len() - 1);
    let grid = Grid::new("levels").num_columns(5).with_row_color(move |row, style| {
        (row == chosen_row).then(|| style.visuals.selection.bg_fill.gamma_multiply(0.45))
    });
    grid.show(ui, |ui| {
        for (text, path) in
            [("", ""), ("Height", "height"), ("Colour", "color"), ("Brightness", ""), ("Opacity", "color.a")]
        {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 2.0;
                if !path.is_empty() {
                    diamond(ui, path);
                }
                ui.weak(text);
            });
        }
        ui.end_row();
        for index in (0..levels.len()).rev() {
            if row(ui, levels, index, *chosen == index) {
                *chosen = index;
            }
            ui.end_row();
        }
    });
}

/// Whether it was touched.
fn row(ui: &mut Ui, levels: &mut ColorLevels, index: usize, is_chosen: bool) -> bool {
    let number = index + 1;
    let name = ui.selectable_label(is_chosen, format!(" {number} "));
    name_it(ui, &name, &format!("Choose level {number}"));
    let mut touched = name.clicked();

    let mut height = levels[index].height;
    touched |= number_field(ui, &format!("Level {number} height"), &LEVEL_HEIGHT, &mut height, false);
    *levels = color_levels::moved(*levels, index, height);

    let color = &mut levels[index].color;
    let label = format!("Level {number} colour");
    touched |= color_field(ui, &label, &mut color.rgb);
    touched |= brightness_field(ui, &format!("{label} brightness"), &mut color.rgb);
    let mut opacity = f64::from(color.a);
    if number_field(ui, &format!("Level {number} opacity"), &ALPHA, &mut opacity, false) {
        color.a = opacity as f32;
        touched = true;
    }
    touched
}
