//! What a gesture did, in the words of the history: "Width of belly from 210 to 340 m".
//!
//! Old values and new ones are read by the table of properties from the edits that lead back and on again. Where one
//! property of one thing or of several was changed it is told; anything else keeps the name that it was given, with the
//! thing's. A box that is new is told with its model's name: "Draw box 3 of heap".

use super::edit::{Edit, ListEdit};
use crate::property::{Described, Kind, Owner, Parts, Property, Value, Visitor, enter};
use crate::scene::{BoxId, ModelId, Scene, Thing, kinds};
use std::collections::BTreeSet;
use std::fmt::Arguments;

/// A longer name of a thing is cut, characters.
const LONGEST_NAME: usize = 24;
/// What takes more edits is not told by its values.
const MOST_EDITS: usize = 4096;

/// A part of a property that was changed.
struct Changed {
    owner: Owner,
    property: &'static Property,
    part: usize,
    old: Value,
    new: Value,
}

/// What a transaction of that name did, after which the scene is `scene`; `back` leads back and `on` forward again.
/// None if its name says more.
pub(super) fn told(name: &str, back: &[Edit], on: &[Edit], scene: &Scene) -> Option<String> {
    if let Some((model, id)) = new_box(on) {
        let model = scene.model(model)?;
        let named = model.boxes.iter().find(|each| each.id == id).filter(|each| !each.name.trim().is_empty());
        let called = named.map_or_else(|| format!("box {id}"), |each| cut(&each.name));
        return Some(format!("{name} {called} of {}", cut(&model.name)));
    }
    let replaces = |edits: &[Edit]| edits.iter().all(|edit| edit.replaces().is_some());
    if back.len() != on.len() || back.len() > MOST_EDITS || !replaces(back) || !replaces(on) {
        return None;
    }
    if let ([Edit::TimeOfDay(old)], [Edit::TimeOfDay(new)]) = (back, on) {
        return Some(format!("Time of day from {} to {}", clock(*old), clock(*new)));
    }
    let [mut old, mut new] = [Values::default(), Values::default()];
    back.iter().for_each(|edit| visit(edit, &mut old));
    on.iter().rev().for_each(|edit| visit(edit, &mut new));
    let changed = old.changed_to(new)?;
    tell(name, &changed, &old)
}

/// The one box that edits bring into the scene, in a model that is there or in one of its own.
fn new_box(edits: &[Edit]) -> Option<(ModelId, BoxId)> {
    let new = |edit: &Edit| match edit {
        Edit::Box(model, ListEdit::Insert { value, .. }) => Some((*model, value.id)),
        Edit::Model(ListEdit::Insert { value, .. }) => match value.boxes.as_slice() {
            [only] => Some((value.id, only.id)),
            _ => None,
        },
        _ => None,
    };
    let mut found = edits.iter().filter_map(new);
    found.next().filter(|_| found.next().is_none())
}

fn tell(name: &str, changed: &[Changed], old: &Values) -> Option<String> {
    // What is turned or resized about another point than its own is moved by that, and a box's sprites go along with its size.
    let is_place = |changed: &&Changed| matches!(changed.property.path, "center" | "position");
    let is_size = |changed: &&Changed| changed.property.path == "size";
    let (places, others): (Vec<&Changed>, Vec<&Changed>) = changed.iter().partition(is_place);
    let follows = |changed: &&Changed| matches!(changed.property.path, "sprite_count" | "width" | "height" | "lumps");
    let resized = others.iter().any(is_size) && others.iter().all(|changed| is_size(changed) || follows(changed));
    let told = match (resized, others.is_empty()) {
        (true, _) => others.into_iter().filter(is_size).collect(),
        (false, false) => others,
        (false, true) => places,
    };
    let first = told.first()?;
    let owners: BTreeSet<Owner> = told.iter().map(|changed| changed.owner).collect();
    let of = old.called(&owners);
    if owners.iter().any(|owner| matches!(owner, Owner::AmbientKey(_) | Owner::DirectionalKey(_))) {
        return None;
    }
    if told.iter().any(|changed| !changed.property.is_the_same(first.property)) {
        let is_one = owners.len() == 1 && matches!(first.owner, Owner::Thing(_));
        return of.filter(|_| is_one).map(|of| format!("{name} · {of}"));
    }
    let parts: BTreeSet<usize> = told.iter().map(|changed| changed.part).collect();
    let whole = first.property.label;
    let label = match (first.property.parts, parts.len()) {
        (Parts::Ends, 1) => format!("{} {}", ["Smallest", "Largest"][first.part.min(1)], whole.to_lowercase()),
        (Parts::One, _) => whole.to_owned(),
        (axes, 1) => format!("{whole} {}", axes.labels()[first.part]),
        _ => whole.to_owned(),
    };
    let of = of.map_or_else(String::new, |of| format!(" of {of}"));
    let [from, to] = [written(first, &first.old)?, written(first, &first.new)?];
    let unit = first.property.kind.number().map_or("", |number| number.unit);
    let unit = if unit.is_empty() || unit == "°" { unit.to_owned() } else { format!(" {unit}") };
    Some(match (owners.len(), parts.len()) {
        (1, 1) => format!("{label}{of} from {from} to {to}{unit}"),
        (1, _) if is_place(first) => format!("{name}{} by {}{unit}", &of.replacen(" of", "", 1), length(&told)?),
        (_, 1) if told.iter().all(|changed| changed.new == first.new) => format!("{label}{of} to {to}{unit}"),
        _ if is_place(first) => format!("{name}{}", &of.replacen(" of", "", 1)),
        _ => format!("{label}{of}"),
    })
}

/// How far the parts went together.
fn length(told: &[&Changed]) -> Option<String> {
    let ways = told.iter().map(|changed| match (&changed.old, &changed.new) {
        (Value::Number(old), Value::Number(new)) => Some((new - old) * (new - old)),
        _ => None,
    });
    Some(short(ways.sum::<Option<f64>>()?.sqrt()))
}

/// A value as people write it; none of an id, which says nothing.
fn written(changed: &Changed, value: &Value) -> Option<String> {
    let kind = changed.property.kind;
    Some(match (kind, value) {
        (Kind::Seed | Kind::Model | Kind::Folder | Kind::Group | Kind::Path, _) => return None,
        (_, Value::Number(number)) => short(*number),
        (_, Value::Flag(on)) => (if *on { "on" } else { "off" }).into(),
        (Kind::Choice(choices), Value::Text(name)) => {
            choices.iter().find(|choice| choice.name == name).map_or(name.as_str(), |choice| choice.label).into()
        }
        (Kind::Text, Value::Text(text)) => format!("“{}”", cut(text)),
        (_, Value::Text(text)) => cut(text),
        (_, Value::None) => changed.property.none.unwrap_or("none").into(),
        (_, Value::Whole(_)) => return None,
    })
}

/// Four figures, without idle zeros.
fn short(number: f64) -> String {
    let decimals = match number.abs() {
        large if large >= 1000.0 => 0,
        middle if middle >= 10.0 => 1,
        small if small >= 1.0 => 2,
        _ => 3,
    };
    let text = format!("{number:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.replacen('-', "−", 1) }
}

/// Hours as a clock shows them.
fn clock(hours: f64) -> String {
    let minutes = (hours * 60.0).round().rem_euclid(24.0 * 60.0) as u32;
    format!("{:02}:{:02}", minutes / 60, minutes % 60)
}

/// A name of one line, not too long.
fn cut(text: &str) -> String {
    let text: String = text.chars().map(|each| if each.is_control() { ' ' } else { each }).collect();
    match text.char_indices().nth(LONGEST_NAME) {
        Some((at, _)) => format!("{}…", text[..at].trim_end()),
        None => text,
    }
}

/// The values of what edits replace, in their order.
#[derive(Default)]
struct Values(Vec<(Owner, &'static Property, usize, Value)>);

impl Visitor for Values {
    fn thing<T: Described>(&mut self, owner: Owner, _: Arguments<'_>, thing: &T) {
        for row in T::rows() {
            for part in 0..row.property.parts.names().len() {
                // What is not there has a place all the same, so that both sides stay beside one another.
                let value = row.value(thing, part).unwrap_or(Value::None);
                self.0.push((owner, &row.property, part, value));
            }
        }
    }
}

impl Values {
    /// What differs from `new`; none if that has other things.
    fn changed_to(&self, new: Self) -> Option<Vec<Changed>> {
        if self.0.len() != new.0.len() {
            return None;
        }
        let mut changed = Vec::new();
        for ((owner, property, part, old), (of, its, at, new)) in self.0.iter().zip(new.0) {
            if (owner, part) != (&of, &at) || !property.is_the_same(its) {
                return None;
            }
            if *old != new {
                changed.push(Changed { owner: *owner, property, part: *part, old: old.clone(), new });
            }
        }
        Some(changed)
    }

    /// What people call those; none for what there is one of.
    fn called(&self, owners: &BTreeSet<Owner>) -> Option<String> {
        let first = owners.first()?;
        let word = match first {
            Owner::Thing(thing) => thing.word().to_owned(),
            Owner::Key(_, index) => format!("path key {}", index + 1),
            Owner::Level(_, index) => format!("level {}", index + 1),
            _ => return None,
        };
        if owners.len() > 1 {
            let same = |owner: &Owner| match (owner, first) {
                (Owner::Thing(a), Owner::Thing(b)) => a.word() == b.word(),
                _ => false,
            };
            let word = if owners.iter().all(same) { plural(&word) } else { "things".into() };
            return Some(format!("{} {word}", owners.len()));
        }
        let named = self.0.iter().find(|(owner, property, ..)| owner == first && property.path == "name");
        match named.map(|(.., value)| value) {
            Some(Value::Text(name)) if !name.trim().is_empty() => Some(cut(name)),
            _ => Some(match first {
                Owner::Thing(thing) => format!("{word}{}", id_of(*thing)),
                _ => word,
            }),
        }
    }
}

fn plural(word: &str) -> String {
    match word {
        "aircraft" => word.into(),
        "box" => "boxes".into(),
        _ => format!("{word}s"),
    }
}

macro_rules! by_kind {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        /// Shows `values` what `edit` puts there.
        fn visit(edit: &Edit, values: &mut Values) {
            let place = format_args!("");
            match edit {
                Edit::Site(site) => enter(Owner::Site, place, site, values),
                Edit::Sun(sun) => enter(Owner::Sun, place, sun, values),
                Edit::Sky(sky) => enter(Owner::Sky, place, sky, values),
                Edit::Weather(weather) => enter(Owner::Weather, place, weather, values),
                Edit::Ground(Some(ground)) => enter(Owner::Ground, place, ground, values),
                Edit::Box(model, ListEdit::Replace(each)) => {
                    enter(Owner::Thing(Thing::Box(*model, each.id)), place, each, values);
                }
                Edit::Group(model, ListEdit::Replace(group)) => {
                    enter(Owner::Thing(Thing::Group(*model, group.id)), place, group, values);
                }
                $(Edit::$Kind(ListEdit::Replace(each)) => {
                    enter(Owner::Thing(Thing::$Kind(each.id)), place, each, values);
                })*
                _ => {}
            }
        }

        fn id_of(thing: Thing) -> String {
            match thing {
                $(Thing::$Kind(id) => format!(" {id}"),)*
                Thing::Box(_, id) => format!(" {id}"),
                Thing::Group(_, id) => format!(" {id}"),
                Thing::Sprite(_, _, index) => format!(" {index}"),
            }
        }
    };
}
kinds!(by_kind);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::problem::sound_scene;
    use crate::scene::{CloudBox, IdCounter, Scene};
    use glam::DVec3;

    /// What the history calls a gesture on the boxes of a model.
    fn after(change: impl Fn(&mut CloudBox)) -> String {
        let mut scene = sound_scene();
        scene.models[0].boxes[0].name = "belly".into();
        let model = scene.models[0].id;
        let boxes = scene.models[0].boxes.clone();
        let mut document = Document::new(scene);
        document.begin("Gesture");
        for step in 0..3 {
            for each in boxes.iter() {
                let mut new = each.clone();
                change(&mut new);
                // Only the last frame of a drag counts.
                new.center.y += f64::from(2 - step);
                if new != *each {
                    document.apply(Edit::Box(model, ListEdit::Replace(new))).expect("it is there");
                }
            }
        }
        document.commit_told().expect("sound");
        document.undo_name().unwrap_or_default().to_owned()
    }

    #[test]
    fn one_value_is_told_with_where_it_came_from() {
        let only = |name: &'static str, change: fn(&mut CloudBox)| {
            move |each: &mut CloudBox| {
                if each.name == name {
                    change(each);
                }
            }
        };
        for (change, told) in [
            (only("belly", |each| each.width[1] = 340.0), "Largest width of belly from WIDTH to 340 m"),
            (only("belly", |each| each.size.x = 825.812), "Size x of belly from SIZE to 825.8 m"),
            (only("belly", |each| each.center += DVec3::new(30.0, 0.0, -40.0)), "Gesture belly by 50 m"),
            (only("belly", |each| (each.size.x, each.center.x) = (600.0, 77.0)), "Size x of belly from SIZE to 600 m"),
            (only("belly", |each| (each.size.x, each.sprite_count) = (600.0, 7)), "Size x of belly from SIZE to 600 m"),
            (only("belly", |each| (each.rotation_deg[0], each.sprite_count) = (5.0, 7)), "Gesture · belly"),
            (only("belly", |each| each.name = "a\nb".into()), "Name of belly from “belly” to “a b”"),
            (only("belly", |each| each.key = Some(7)), "Gesture"),
        ] {
            let got = after(change);
            let start = sound_scene();
            let was = start.models[0].boxes[0].clone();
            let told = told.replace("WIDTH", &short(was.width[1])).replace("SIZE", &short(was.size.x));
            assert_eq!(got, told);
        }
    }

    #[test]
    fn a_new_box_is_told_with_its_model() {
        for (name, told) in [("box 3", "Draw box 3 of heap"), (" ", "Draw box 99 of heap")] {
            let mut document = Document::new(sound_scene());
            let model = document.scene().models[0].id;
            document.begin("Draw");
            document.apply(Edit::NextId(IdCounter(100))).expect("a number");
            let mut new = CloudBox { name: name.into(), ..CloudBox::new(BoxId(99), DVec3::ZERO) };
            document.apply(Edit::Box(model, ListEdit::Insert { at: usize::MAX, value: new.clone() })).expect("new");
            new.size.x = 700.0;
            document.apply(Edit::Box(model, ListEdit::Replace(new))).expect("it is there");
            document.commit_told().expect("sound");
            assert_eq!(document.undo_name(), Some(told));
        }
    }

    #[test]
    fn numbers_are_short() {
        for (number, text) in [
            (825.812, "825.8"),
            (210.0, "210"),
            (12_345.6, "12346"),
            (-3.1459, "−3.15"),
            (0.12345, "0.123"),
            (-0.0001, "0"),
            (1e300, &format!("{:.0}", 1e300)),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(short(number), text);
        }
        assert_eq!((clock(14.5).as_str(), clock(23.999).as_str()), ("14:30", "00:00"));
        assert_eq!(cut(&"ä".repeat(40)), format!("{}…", "ä".repeat(24)));
    }

    #[test]
    fn what_adds_or_takes_keeps_its_name() {
        let mut document = Document::new(Scene::default());
        document.begin("Gesture");
        document.apply(Edit::Camera(ListEdit::Remove(document.scene().cameras[0].id))).expect("there");
        document.commit_told().expect("sound");
        assert_eq!(document.undo_name(), Some("Gesture"));
    }
}
