//! What a hand does with keys: choose, drag, scale, draw a box around, pull a curve's slope, add.
//!
//! A drag starts each step from the tracks as they were when it began. Shift makes it finer (in the curves it keeps to one
//! axis), Ctrl coarser, Alt scales distances from the clock; Esc or the other button takes it back.
//! With *Ripple*, what comes later goes along.

use super::curves::Plot;
use super::lines::Lines;
use super::memory::{Gesture, Held, Memory};
use super::sheet::keys_at;
use super::span::Span;
use super::spot::{Spot, What, under};
use crate::state::{Action, Choose, Reading, TimelineChange};
use cloudwright_core::arrange::keys::{self, KeyPlace, Rekeyed};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::Target;
use cloudwright_core::scene::{Handles, KeyValue, Track, TrackId, TrackKey};
use egui::{Key, Modifiers, Pos2, Rect, Ui, Vec2};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Less is a tremble, points.
const TREMBLE: f32 = 3.0;
/// Of the pointer's way, with Shift.
const FINE: f32 = 0.1;

/// The part of the window where keys are, in this frame.
pub(super) struct Field<'a, 'r> {
    pub(super) rect: Rect,
    pub(super) span: Span,
    pub(super) lines: &'a Lines,
    pub(super) spots: &'a [Spot],
    /// Where curves are shown.
    pub(super) plot: Option<&'a Plot>,
    pub(super) reading: &'a Reading<'r>,
}

impl Field<'_, '_> {
    /// Follows the hand. A press is within the field if `is_over`.
    pub(super) fn work(&self, ui: &Ui, is_over: bool, memory: &mut Memory, actions: &mut Vec<Action>) {
        let (at, pressed, down, dropped, modifiers) = ui.input(|input| {
            let pointer = &input.pointer;
            let dropped = input.key_pressed(Key::Escape) || pointer.secondary_pressed();
            // A quick hand may have moved on within the frame.
            let pressed = pointer.primary_pressed().then(|| pointer.press_origin().or(pointer.latest_pos())).flatten();
            (pointer.latest_pos(), pressed, pointer.primary_down(), dropped, input.modifiers)
        });
        let Some(at) = at else { return };
        if let Some(from) = pressed.filter(|from| is_over && self.rect.contains(*from)) {
            memory.gesture = self.begin(from, modifiers, actions);
        }
        match memory.gesture.take() {
            Some(Gesture::Keys(held) | Gesture::Slope { held, .. }) if dropped => {
                actions.push(Action::DropGesture);
                let chosen = held.chosen.into_iter().collect();
                actions.push(Action::Timeline(TimelineChange::Keys(chosen, Choose::Only)));
            }
            Some(Gesture::Box(_)) if dropped => {}
            Some(Gesture::Keys(mut held)) => {
                follow(&mut held, at, modifiers, self.plot.is_some());
                if held.moved {
                    self.drag(&mut held, modifiers, down, actions);
                } else if !down && held.alone {
                    self.choose(vec![held.key], Choose::Only, actions);
                }
                memory.gesture = down.then_some(Gesture::Keys(held));
            }
            Some(Gesture::Slope { mut held, part, leaves }) => {
                follow(&mut held, at, Modifiers::NONE, false);
                if held.moved {
                    self.pull(&mut held, at, (part, leaves), modifiers.alt, down, actions);
                }
                memory.gesture = down.then_some(Gesture::Slope { held, part, leaves });
            }
            Some(Gesture::Box(from)) => {
                let area = Rect::from_two_pos(from, at);
                let is_drawn = area.size().max_elem() > TREMBLE;
                if !down {
                    let within = if is_drawn { self.within(area) } else { Vec::new() };
                    let how = if modifiers.shift { Choose::Too } else { Choose::Only };
                    self.choose(within, how, actions);
                }
                memory.gesture = down.then_some(Gesture::Box(from));
            }
            other => memory.gesture = other,
        }
    }

    fn choose(&self, keys: Vec<KeyPlace>, how: Choose, actions: &mut Vec<Action>) {
        actions.push(Action::Timeline(TimelineChange::Keys(keys, how)));
    }

    /// What a press begins.
    fn begin(&self, at: Pos2, modifiers: Modifiers, actions: &mut Vec<Action>) -> Option<Gesture> {
        let Some(spot) = under(self.spots, at) else { return Some(Gesture::Box(at)) };
        let (keys, part) = match &spot.what {
            What::Key(place, part) => (vec![*place], *part),
            What::Sum(tracks) => {
                let merged_s = 2.0 * self.span.s_per_point();
                (keys_at(self.lines, tracks, spot.time_s, merged_s, self.reading), None)
            }
            What::Handle { key, part, leaves } => {
                let held = self.hold(at, *key, spot.time_s, [*key].into());
                return Some(Gesture::Slope { held, part: *part, leaves: *leaves });
            }
        };
        let mut chosen = self.reading.view.timeline.chosen.clone();
        let all_chosen = keys.iter().all(|key| chosen.contains(key));
        let toggles = modifiers.shift || modifiers.command;
        if toggles {
            self.choose(keys.clone(), if all_chosen { Choose::Toggle } else { Choose::Too }, actions);
            for key in &keys {
                if all_chosen {
                    chosen.remove(key)
                } else {
                    chosen.insert(*key)
                };
            }
        } else if !all_chosen {
            self.choose(keys.clone(), Choose::Only, actions);
            chosen = keys.iter().copied().collect();
        }
        let key = *keys.first()?;
        if !chosen.contains(&key) {
            return None;
        }
        let alone = all_chosen && !toggles && keys.len() == 1;
        Some(Gesture::Keys(Held { part, alone, scales: modifiers.alt, ..self.hold(at, key, spot.time_s, chosen) }))
    }

    fn hold(&self, at: Pos2, key: KeyPlace, time_s: f64, chosen: BTreeSet<KeyPlace>) -> Held {
        let ids: BTreeSet<TrackId> = chosen.iter().map(|(id, _)| *id).collect();
        let tracks = self.reading.session.scene().tracks.as_slice().iter();
        Held {
            last: at,
            by: Vec2::ZERO,
            key,
            time_s,
            part: None,
            tracks: tracks.filter(|track| ids.contains(&track.id)).cloned().collect(),
            chosen,
            scales: false,
            moved: false,
            alone: false,
            asked: None,
        }
    }

    /// A step of a drag of keys.
    fn drag(&self, held: &mut Held, modifiers: Modifiers, live: bool, actions: &mut Vec<Action>) {
        let clock_s = self.reading.clock.time_s();
        let wanted_s = held.time_s + f64::from(held.by.x) * self.span.s_per_point();
        let ripples = self.reading.view.timeline.ripple && !held.scales;
        let tracks = || held.tracks.iter().map(|track| &**track);
        let moving = if ripples { keys::with_later(tracks(), &held.chosen) } else { held.chosen.clone() };
        // Times that are there as well: of keys that stay, of the clock, and the start.
        let others = held.tracks.iter().flat_map(|track| {
            let keys = track.keys.iter().enumerate();
            keys.filter(|(index, _)| !moving.contains(&(track.id, *index))).map(|(_, key)| key.time_s)
        });
        let fine = modifiers.shift && self.plot.is_none();
        let snap = if fine { crate::state::TimeSnap::Off } else { self.reading.view.timeline.snap };
        let others = others.chain([clock_s, 0.0]).filter(|_| snap != crate::state::TimeSnap::Off);
        let time_s =
            if held.by.x == 0.0 { held.time_s } else { self.span.snapped(wanted_s, snap, modifiers.command, others) };
        let asked = Some([time_s, f64::from(held.by.y)]);
        if std::mem::replace(&mut held.asked, asked) == asked && live {
            return;
        }
        let (name, rekeyed) = if held.scales && (held.time_s - clock_s).abs() > keys::SAME_S {
            let by = ((time_s - clock_s) / (held.time_s - clock_s)).max(1e-3);
            ("Scale keys", keys::scaled(tracks(), &held.chosen, clock_s, by))
        } else {
            let by_s = time_s - held.time_s;
            let set_value = |(id, _): KeyPlace, key: &mut TrackKey| {
                if let (Some(part), Some(plot)) = (held.part, self.plot) {
                    let by = -f64::from(held.by.y) * plot.value_per_point(id);
                    let parts = key.value.parts_mut();
                    let part = part.min(parts.len() - 1);
                    parts[part] += by;
                }
            };
            if ripples {
                ("Move keys and later ones", keys::rippled(tracks(), &held.chosen, by_s, set_value))
            } else {
                let rekeyed = keys::reshaped(tracks(), &held.chosen, |place, key| {
                    key.time_s += by_s;
                    set_value(place, key);
                });
                ("Move keys", rekeyed)
            }
        };
        actions.push(step(name, &held.tracks, rekeyed, live));
    }

    /// A step of a drag of a slope. Both sides follow, unless `alone`.
    fn pull(
        &self,
        held: &mut Held,
        at: Pos2,
        (part, leaves): (usize, bool),
        alone: bool,
        live: bool,
        actions: &mut Vec<Action>,
    ) {
        let Some(plot) = self.plot else { return };
        let asked = Some([f64::from(at.x), f64::from(at.y)]);
        if std::mem::replace(&mut held.asked, asked) == asked && live {
            return;
        }
        let (id, index) = held.key;
        let Some(key_y) = plot.key_y(id, index, part) else { return };
        let least_s = 2.0 * self.span.s_per_point();
        let apart_s = self.span.time_at(at.x) - held.tracks.first().map_or(0.0, |track| track.keys[index].time_s);
        let apart_s = if leaves { apart_s.max(least_s) } else { apart_s.min(-least_s) };
        let slope = -f64::from(at.y - key_y) * plot.value_per_point(id) / apart_s;
        let rekeyed = keys::reshaped(held.tracks.iter().map(|track| &**track), &held.chosen, |_, key| {
            let level = key.value.with(|_| 0.0);
            let handles = key.handles.get_or_insert(Handles { arrives: level, leaves: level });
            if leaves || !alone {
                handles.leaves.parts_mut()[part] = slope;
            }
            if !leaves || !alone {
                handles.arrives.parts_mut()[part] = slope;
            }
        });
        actions.push(step("Pull handle", &held.tracks, rekeyed, live));
    }

    /// The keys whose spots lie in a box.
    fn within(&self, area: Rect) -> Vec<KeyPlace> {
        let spots = self.spots.iter().filter(|spot| area.contains(spot.at));
        let keys = spots.filter_map(|spot| if let What::Key(place, _) = spot.what { Some(place) } else { None });
        keys.collect::<BTreeSet<KeyPlace>>().into_iter().collect()
    }

    /// A key where a double click says, with the value that its curve has there.
    pub(super) fn add(&self, at: Pos2, in_sight: &[(usize, f32)], half_line: f32) -> Option<Action> {
        if under(self.spots, at).is_some() || !self.rect.contains(at) {
            return None;
        }
        let clock_s = self.reading.clock.time_s();
        let snap = self.reading.view.timeline.snap;
        let time_s = self.span.snapped(self.span.time_at(at.x), snap, false, [clock_s].into_iter());
        let line = in_sight.iter().find(|(_, y)| (y - at.y).abs() <= half_line).map(|(track, _)| *track);
        let tracks = match self.plot {
            Some(plot) => vec![plot.track_near(at)?],
            None => vec![self.lines.tracks.get(line?)?.id],
        };
        let shown = self.lines.tracks.iter().filter(|shown| tracks.contains(&shown.id));
        let values = shown.filter_map(|shown| value_at(&shown.target?, time_s, self.reading));
        let rekeyed = keys::keyed(self.reading.session.scene(), &values.collect::<Vec<_>>(), time_s);
        (!rekeyed.edits.is_empty()).then_some(Action::Keys {
            name: "Add key".into(),
            rekeyed,
            live: false,
            choose: true,
        })
    }
}

fn value_at(target: &Target, time_s: f64, reading: &Reading<'_>) -> Option<(Target, KeyValue)> {
    let curve = reading.session.derived().timeline().curve(target.owner, target.property.path)?;
    let [x, y, z] = curve.all_at(time_s);
    Some((*target, if target.parts() == 3 { KeyValue::Three([x, y, z]) } else { KeyValue::One(x) }))
}

/// How far the hand has come.
fn follow(held: &mut Held, at: Pos2, modifiers: Modifiers, has_values: bool) {
    let way = at - held.last;
    held.last = at;
    held.by += if modifiers.shift && !has_values { way * FINE } else { way };
    held.moved |= held.by.length() > TREMBLE;
    if modifiers.shift && has_values {
        // Along one axis, the one that the hand went more.
        if held.by.x.abs() >= held.by.y.abs() { held.by.y = 0.0 } else { held.by.x = 0.0 }
    }
}

/// As an action. A track that is as it was at the beginning is put back too.
fn step(name: &str, before: &[Arc<Track>], mut rekeyed: Rekeyed, live: bool) -> Action {
    let of = |edit: &Edit| match edit {
        Edit::Track(ListEdit::Replace(track)) => Some(track.id),
        Edit::Track(ListEdit::Remove(id)) => Some(*id),
        _ => None,
    };
    let changed: BTreeSet<TrackId> = rekeyed.edits.iter().filter_map(of).collect();
    let same = before.iter().filter(|track| !changed.contains(&track.id));
    rekeyed.edits.extend(same.map(|track| Edit::Track(ListEdit::Replace((**track).clone()))));
    Action::Keys { name: name.into(), rekeyed, live, choose: true }
}
