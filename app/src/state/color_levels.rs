//! Changes to colour levels: levels stay in order, and what is changed in the primary's model is changed in all
//! selected ones.

use crate::state::{Action, Reading};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{CloudModel, ColorLevels};

/// The edit that gives `model` other colour levels.
pub(crate) fn with_levels(model: &CloudModel, levels: ColorLevels) -> Edit {
    Edit::Model(ListEdit::Replace(CloudModel { color_levels: levels, ..model.clone() }))
}

/// The levels with one of them at `height`, or as near as its neighbours let it: two at one height make a step.
pub(crate) fn moved(mut levels: ColorLevels, index: usize, height: f64) -> ColorLevels {
    let lowest = if index > 0 { levels[index - 1].height } else { 0.0 };
    let highest = levels.get(index + 1).map_or(1.0, |level| level.height);
    if height.is_finite() {
        levels[index].height = height.max(lowest).min(highest);
    }
    levels
}

/// Gives the selected models what differs between the primary's levels and `after`: the rest of theirs stays.
pub(crate) fn change(reading: &Reading<'_>, after: &ColorLevels, live: bool) -> Option<Action> {
    let models = reading.view.selection.models(reading.session.scene());
    let before = models.first()?.color_levels;
    let edits: Vec<Edit> = models
        .into_iter()
        .map(|model| (model, carried_over(&before, after, model.color_levels)))
        .filter(|(model, levels)| *levels != model.color_levels)
        .map(|(model, levels)| with_levels(model, levels))
        .collect();
    (!edits.is_empty()).then_some(Action::Change { name: "Change colour levels", edits, live })
}

/// Gives the selected models these levels, whatever theirs are.
pub(crate) fn replace(reading: &Reading<'_>, name: &'static str, levels: ColorLevels) -> Action {
    let models = reading.view.selection.models(reading.session.scene());
    let edits = models.into_iter().map(|model| with_levels(model, levels)).collect();
    Action::Change { name, edits, live: false }
}

/// The same colours the other way up.
pub(crate) fn upside_down(levels: ColorLevels) -> ColorLevels {
    let mut turned = levels;
    for (level, from) in turned.iter_mut().zip(levels.iter().rev()) {
        level.color = from.color;
        level.height = 1.0 - from.height;
    }
    turned
}

/// The same colours at even distances.
pub(crate) fn evenly_spaced(mut levels: ColorLevels) -> ColorLevels {
    let last = (levels.len() - 1) as f64;
    for (i, level) in levels.iter_mut().enumerate() {
        level.height = i as f64 / last;
    }
    levels
}

fn carried_over(before: &ColorLevels, after: &ColorLevels, mut levels: ColorLevels) -> ColorLevels {
    for i in 0..levels.len() {
        if after[i].color.rgb != before[i].color.rgb {
            levels[i].color.rgb = after[i].color.rgb;
        }
        if after[i].color.a != before[i].color.a {
            levels[i].color.a = after[i].color.a;
        }
        if after[i].height != before[i].height {
            levels = moved(levels, i, after[i].height);
        }
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::color::Rgba;
    use cloudwright_core::scene::ColorLevel;

    fn levels(heights: [f64; 5]) -> ColorLevels {
        heights.map(|height| ColorLevel { height, color: Rgba::new(height as f32, 0.5, 0.5, 1.0) })
    }

    #[test]
    fn a_level_stops_at_its_neighbours() {
        let start = levels([0.1, 0.3, 0.5, 0.5, 0.9]);
        for (index, to, want) in [(0, -1.0, 0.0), (1, 0.9, 0.5), (2, 0.2, 0.3), (2, 0.7, 0.5), (4, 7.0, 1.0)] {
            assert_eq!(moved(start, index, to)[index].height, want, "level {index} to {to}");
        }
        assert_eq!(moved(start, 1, f64::NAN), start);
    }

    #[test]
    fn others_take_only_what_was_changed_and_stay_in_order() {
        let (before, other) = (levels([0.0, 0.2, 0.4, 0.6, 1.0]), levels([0.0, 0.1, 0.2, 0.3, 0.4]));
        let mut after = moved(before, 2, 0.55);
        after[4].color.a = 0.25;
        let got = carried_over(&before, &after, other);
        assert_eq!(got.map(|level| level.height), [0.0, 0.1, 0.3, 0.3, 0.4]);
        assert_eq!((got[4].color.a, got[4].color.rgb), (0.25, other[4].color.rgb));
        assert_eq!(upside_down(upside_down(before)).map(|level| level.color), before.map(|level| level.color));
        assert_eq!(evenly_spaced(other).map(|level| level.height), [0.0, 0.25, 0.5, 0.75, 1.0]);
    }
}
