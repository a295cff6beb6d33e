//! Changes to colour levels: levels stay in order, and what is changed in the primary's model is changed in all
//! selected ones.

use super::timeline::TimelineChange;
use crate::state::{Action, Reading, Values};
use cloudwright_core::arrange::keys;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{Described, Owner, Row, Target, Value};
use cloudwright_core::scene::{CloudModel, ColorLevel, ColorLevels, KeyValue, ModelId};

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

/// The levels as they are at the clock's time.
pub(crate) fn shown(reading: &Reading<'_>, model: &CloudModel) -> ColorLevels {
    let mut levels = model.color_levels;
    for (i, level) in levels.iter_mut().enumerate() {
        for (row, target) in targets(model.id, i) {
            for part in 0..target.parts() {
                if let Some(number) = reading.keyed_number(&target, part) {
                    // What a track says is within the range.
                    let _ = row.set(level, part, &Value::Number(number));
                }
            }
        }
    }
    levels
}

/// What a track can move of a level, with its row.
pub(crate) fn targets(model: ModelId, level: usize) -> impl Iterator<Item = (&'static Row<ColorLevel>, Target)> {
    let keyed = ColorLevel::rows().filter(|row| row.property.keyed);
    keyed.map(move |row| (row, Target { owner: Owner::Level(model, level), property: &row.property }))
}

/// All of a level's value as a key has it.
pub(crate) fn key_value(row: &Row<ColorLevel>, level: &ColorLevel) -> Option<KeyValue> {
    let number = |part| match row.value(level, part)? {
        Value::Number(number) => Some(number),
        _ => None,
    };
    Some(match row.property.parts.names().len() {
        3 => KeyValue::Three([number(0)?, number(1)?, number(2)?]),
        _ => KeyValue::One(number(0)?),
    })
}

/// Gives the selected models what differs between the primary's levels as they are shown and `after`: the rest of theirs
/// stays. What is keyed becomes keys if *Auto-key* is on.
pub(crate) fn change(reading: &Reading<'_>, after: &ColorLevels, live: bool) -> Vec<Action> {
    let models = reading.view.selection.models(reading.session.scene());
    let Some(first) = models.first() else { return Vec::new() };
    let before = shown(reading, first);
    let (mut edits, mut keyed, mut unkeyed) = (Vec::new(), Values::new(), Vec::new());
    for model in models {
        let old = shown(reading, model);
        let new = carried_over(&before, after, old);
        let mut own = model.color_levels;
        for i in 0..own.len() {
            for (row, target) in targets(model.id, i) {
                let [was, is] = [&old[i], &new[i]].map(|level| key_value(row, level));
                let Some(value) = is.filter(|is| Some(*is) != was) else { continue };
                let has_track = reading.has_track(&target);
                if has_track && reading.view.timeline.auto_key {
                    keyed.push((target, value));
                    continue;
                }
                for (part, number) in value.parts().iter().enumerate() {
                    let _ = row.set(&mut own[i], part, &Value::Number(*number));
                }
                unkeyed.extend(has_track.then_some(target));
            }
        }
        if own != model.color_levels {
            edits.push(with_levels(model, own));
        }
    }
    let mut actions = Vec::new();
    if !unkeyed.is_empty() {
        actions.push(Action::Timeline(TimelineChange::Unkeyed(unkeyed)));
    }
    if !keyed.is_empty() {
        let mut rekeyed = keys::keyed(reading.session.scene(), &keyed, reading.clock.time_s());
        rekeyed.edits.append(&mut edits);
        actions.push(Action::Keys { name: "Key colour levels".into(), rekeyed, live, choose: false });
    } else if !edits.is_empty() {
        actions.push(Action::Change { name: "Change colour levels", edits, live });
    }
    actions
}

/// Gives those of the selected models these levels that have others.
pub(crate) fn replace(reading: &Reading<'_>, name: &'static str, levels: ColorLevels) -> Action {
    let models = reading.view.selection.models(reading.session.scene());
    let others = models.into_iter().filter(|model| model.color_levels != levels);
    let edits = others.map(|model| with_levels(model, levels)).collect();
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
