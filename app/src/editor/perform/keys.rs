//! Keys of tracks, by command: what is done is [`cloudwright_core::arrange::keys`]'s, with the chosen keys and tracks.

use crate::command::Command;
use crate::editor::Editor;
use crate::panel::Panel;
use crate::state::{Choose, TimelineChange};
use crate::widget::field_to_key;
use cloudwright_core::arrange::keys::{self, Ease, KeyPlace, Rekeyed};
use cloudwright_core::property::Target;
use cloudwright_core::scene::{KeyValue, Leaves, List, Track, TrackId};
use std::collections::BTreeSet;

impl Editor {
    /// A step of keys from a panel; the last one of a gesture ends it.
    pub(super) fn change_keys(&mut self, name: &str, rekeyed: Rekeyed, live: bool, choose: bool) {
        if self.gesture_dropped {
            return;
        }
        self.view.timeline.was_keyed(&rekeyed);
        let Rekeyed { edits, chosen } = rekeyed;
        let mut done = self.session.drag(name, edits);
        if done.is_ok() && !live {
            done = self.session.commit();
        }
        if done.is_ok() && choose {
            self.view.timeline.choose(&chosen.into_iter().collect::<Vec<_>>(), Choose::Only);
        }
        self.view.keep_what_is_in(self.session.scene());
        self.report(done);
    }

    pub(super) fn change_timeline(&mut self, change: TimelineChange) {
        let timeline = &mut self.view.timeline;
        match change {
            TimelineChange::Keys(keys, how) => timeline.choose(&keys, how),
            TimelineChange::Tracks(tracks, how) => timeline.choose_tracks(&tracks, how),
            TimelineChange::Unkeyed(targets) => timeline.changed_by_hand(targets, self.clock.time_s()),
            TimelineChange::Snap(snap) => timeline.snap = snap,
            TimelineChange::Show(targets) => {
                let properties: BTreeSet<String> = targets.iter().map(Target::to_string).collect();
                let its = self.session.scene().tracks.iter().filter(|track| properties.contains(&track.property));
                let its: Vec<TrackId> = its.map(|track| track.id).collect();
                timeline.choose_tracks(&its, Choose::Only);
                timeline.reveal += 1;
                self.layout.bring_up(Panel::Timeline);
            }
        }
    }

    /// The value of the field that the pointer was at last, in all that it was of.
    pub(super) fn key_value(&mut self, context: &egui::Context) {
        let scene = self.session.scene();
        let pointed = field_to_key(context);
        let there = pointed.filter(|(_, values)| values.iter().all(|(target, _)| target.owner.is_in(scene)));
        let Some((label, values)) = there else {
            return self.tell("Point at a value that has a diamond, and do this again");
        };
        let rekeyed = keys::keyed(scene, &values, self.clock.time_s());
        self.change_keys(&format!("Key {}", label.to_lowercase()), rekeyed, false, true);
    }

    /// To the key before or after the clock's time, of the chosen tracks or of all.
    pub(super) fn seek_key(&mut self, onwards: bool) {
        let tracks = self.tracks_at_work();
        if let Some(time_s) = keys::next_key_s(tracks, self.clock.time_s(), onwards) {
            self.seek(time_s);
        }
    }

    /// The chosen tracks; all if none is chosen.
    fn tracks_at_work(&self) -> impl Iterator<Item = &Track> {
        let chosen = &self.view.timeline.tracks;
        let tracks = self.session.scene().tracks.iter();
        tracks.filter(move |track| chosen.is_empty() || chosen.contains(&track.id))
    }

    /// A key at the clock's time for each of the chosen tracks, where its curve is.
    pub(super) fn add_keys(&mut self) {
        let clock_s = self.clock.time_s();
        let timeline = self.session.derived().timeline();
        let value = |track: &Track| {
            let target: Target = track.property.parse().ok()?;
            let [x, y, z] = timeline.curve(target.owner, target.property.path)?.all_at(clock_s);
            Some((target, if target.parts() == 3 { KeyValue::Three([x, y, z]) } else { KeyValue::One(x) }))
        };
        let values: Vec<_> = self.tracks_at_work().filter_map(value).collect();
        let rekeyed = keys::keyed(self.session.scene(), &values, clock_s);
        self.rekey(Command::AddKeys, rekeyed);
    }

    /// The chosen keys; if none is, all of the chosen tracks.
    pub(super) fn keys_at_work(&self) -> BTreeSet<KeyPlace> {
        let timeline = &self.view.timeline;
        if !timeline.chosen.is_empty() {
            return timeline.chosen.clone();
        }
        let tracks = self.session.scene().tracks.iter().filter(|track| timeline.tracks.contains(&track.id));
        tracks.flat_map(|track| (0..track.keys.len()).map(|index| (track.id, index))).collect()
    }

    /// What is done with the chosen keys.
    pub(super) fn work_on_keys(&mut self, command: Command) {
        let (tracks, clock_s) = (&self.session.scene().tracks, self.clock.time_s());
        let chosen = &self.keys_at_work();
        let ease = |ease| keys::eased(tracks, chosen, ease);
        let rekeyed = match command {
            Command::DeleteKeys => keys::deleted(tracks, chosen),
            Command::DuplicateKeys => {
                let times = || chosen.iter().filter_map(|(id, index)| tracks.with_id(*id)?.keys.get(*index));
                let ends = times()
                    .map(|key| key.time_s)
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], time_s| [a.min(time_s), b.max(time_s)]);
                // Behind the last one, as far as the first from the second if there is but one time: a second.
                keys::duplicated(tracks, chosen, (ends[1] - ends[0]).max(0.0) + 1.0)
            }
            Command::MirrorKeys => keys::mirrored(tracks, chosen, clock_s),
            Command::SlowKeys => keys::scaled(tracks, chosen, clock_s, 2.0),
            Command::QuickenKeys => keys::scaled(tracks, chosen, clock_s, 0.5),
            Command::KeysStep => ease(Ease::Plain(Leaves::Step)),
            Command::KeysLinear => ease(Ease::Plain(Leaves::Linear)),
            Command::KeysSmooth => ease(Ease::Plain(Leaves::Smooth)),
            Command::KeysFlat => ease(Ease::Flat),
            Command::KeysFree => ease(Ease::Free),
            _ => return,
        };
        self.rekey(command, rekeyed);
    }

    /// Keys that came from the clipboard, from the clock's time on.
    pub(super) fn paste_keys(&mut self, copied: &List<Track>) {
        let rekeyed = keys::pasted(self.session.scene(), copied, self.clock.time_s(), &self.view.timeline.tracks);
        if rekeyed.edits.is_empty() {
            return self.tell("What these keys were of is not in the scene");
        }
        self.rekey(Command::PasteKeys, rekeyed);
    }

    /// All keys of the chosen tracks, or of all, that `wanted` says of their times.
    pub(super) fn select_keys(&mut self, wanted: impl Fn(f64) -> bool) {
        let of_track = |track: &Track| {
            let keys = track.keys.iter().enumerate().filter(|(_, key)| wanted(key.time_s));
            keys.map(|(index, _)| (track.id, index)).collect::<Vec<_>>()
        };
        let chosen: Vec<KeyPlace> = self.tracks_at_work().flat_map(of_track).collect();
        self.view.timeline.choose(&chosen, Choose::Only);
    }

    /// One of the two marks at the clock's time; the other one stays, or is an end of the clock's way.
    pub(super) fn mark(&mut self, is_out: bool) {
        let length_s = self.clock.length_s(self.session.scene());
        let (now_s, [start_s, end_s]) = (self.clock.time_s(), self.clock.played_s(length_s));
        let marks = if is_out {
            [if start_s < now_s { start_s } else { 0.0 }, now_s]
        } else {
            [now_s, if end_s > now_s { end_s } else { length_s }]
        };
        self.clock.set_marks(Some(marks).filter(|[a, b]| a < b));
    }

    pub(super) fn rekey(&mut self, command: Command, rekeyed: Rekeyed) {
        self.change_keys(command.row().label(), rekeyed, false, true);
    }
}
