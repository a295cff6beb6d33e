//! The lines of the panel: tracks under what they belong to, those that are found by what is typed.

use cloudwright_core::property::{Owner, Target};
use cloudwright_core::scene::{InScene, ModelId, Scene, Thing, Track, TrackId};
use std::collections::BTreeSet;
use std::ops::Range;

/// Whose tracks stand together; none: those that move nothing.
pub(super) type Group = Option<Owner>;

/// All of them.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// The tracks that are found, of one group behind one another.
    pub(super) tracks: Vec<Shown>,
    /// From top to bottom.
    pub(super) lines: Vec<Line>,
}

/// A track that is found.
#[derive(Debug, Clone)]
pub(super) struct Shown {
    pub(super) id: TrackId,
    /// Where it stands in the scene's list.
    pub(super) at: usize,
    /// What it moves, if that is there.
    pub(super) target: Option<Target>,
    /// The property's name, or its address.
    pub(super) label: String,
    group: Group,
    group_label: String,
}

/// A line.
#[derive(Debug, Clone)]
pub(super) enum Line {
    /// What tracks belong to, and which of the found ones.
    Group { group: Group, label: String, tracks: Range<usize>, is_open: bool },
    /// One of the found tracks.
    Track(usize),
}

impl Lines {
    pub(super) fn new(
        scene: &Scene,
        typed: &str,
        folded: &BTreeSet<Group>,
        target_of: &mut impl FnMut(&str) -> Option<Target>,
    ) -> Self {
        let words: Vec<String> = typed.split_whitespace().map(str::to_lowercase).collect();
        let shown = |(at, track): (usize, &Track)| {
            let target = target_of(&track.property).filter(|target| target.owner.is_in(scene));
            let group = target.map(|target| target.owner);
            let group_label = group.map_or_else(|| "Moves nothing".into(), |owner| name_of(scene, owner));
            let label = target.map_or_else(|| track.property.clone(), |target| target.property.label.into());
            let text = format!("{label} {group_label}").to_lowercase();
            words.iter().all(|word| text.contains(word)).then_some(Shown {
                id: track.id,
                at,
                target,
                label,
                group,
                group_label,
            })
        };
        let mut tracks: Vec<Shown> = scene.tracks.iter().enumerate().filter_map(shown).collect();
        // What moves nothing comes last.
        tracks.sort_by_key(|track| (track.group.is_none(), track.group));
        let mut lines = Vec::new();
        let mut from = 0;
        for of_group in tracks.chunk_by(|a, b| a.group == b.group) {
            let to = from + of_group.len();
            let Shown { group, group_label, .. } = &of_group[0];
            let is_open = !folded.contains(group);
            lines.push(Line::Group { group: *group, label: group_label.clone(), tracks: from..to, is_open });
            if is_open {
                lines.extend((from..to).map(Line::Track));
            }
            from = to;
        }
        Self { tracks, lines }
    }
}

impl Shown {
    /// With what it belongs to: "Opacity of Cloud".
    pub(super) fn full_name(&self) -> String {
        format!("{} of {}", self.label, self.group_label)
    }
}

/// What tracks belong to, for people.
fn name_of(scene: &Scene, owner: Owner) -> String {
    let model = |id: ModelId| scene.model(id).map_or_else(|| format!("model {id}"), |model| model.name.clone());
    match owner {
        Owner::Scene => "Scene".into(),
        Owner::Site => "Place".into(),
        Owner::Sun => "Sun".into(),
        Owner::Sky | Owner::AmbientKey(_) | Owner::DirectionalKey(_) => "Sky".into(),
        Owner::Weather => "Weather".into(),
        Owner::Ground => "Ground".into(),
        Owner::Level(id, level) => format!("{}, level {}", model(id), level + 1),
        Owner::Thing(Thing::Group(id, group)) => {
            let name = scene.model(id).and_then(|model| model.groups.with_id(group)).map(|group| group.name.as_str());
            format!("{}, {}", model(id), name.filter(|name| !name.is_empty()).unwrap_or("group"))
        }
        Owner::Thing(Thing::Box(id, each)) => {
            let name = scene.model(id).and_then(|model| model.boxes.with_id(each)).map(|each| each.name.as_str());
            let number = format!("box {each}");
            format!("{}, {}", model(id), name.filter(|name| !name.is_empty()).unwrap_or(&number))
        }
        Owner::Thing(thing) => match thing.listed(scene).map(InScene::name) {
            Some(name) if !name.is_empty() => name.into(),
            _ => owner.to_string().replace('/', " "),
        },
        Owner::Key(..) => owner.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::starter::starter_scene;
    use cloudwright_core::scene::{KeyValue, TrackKey};

    #[test]
    fn tracks_stand_under_their_owners_and_are_found_by_words() {
        let mut scene = starter_scene();
        let cloud = scene.clouds[0].id;
        let properties =
            [format!("cloud/{cloud}/opacity"), "sky/exposure_ev".into(), "cloud/99/scale".into(), "sky/gain".into()];
        for property in properties {
            let id = TrackId::new(&mut scene.next_id);
            scene.tracks.push(Track::new(id, property, vec![TrackKey::new(0.0, KeyValue::One(1.0))]));
        }
        let show = |typed: &str, folded: &[Group]| {
            let folded = folded.iter().copied().collect();
            let lines = Lines::new(&scene, typed, &folded, &mut |property: &str| property.parse().ok());
            let text = |line: &Line| match line {
                Line::Group { label, .. } => label.clone(),
                Line::Track(at) => format!("- {}", lines.tracks[*at].label),
            };
            lines.lines.iter().map(text).collect::<Vec<_>>()
        };
        let name = scene.clouds[0].name.as_str();
        let all = ["Sky", "- Exposure", "- Sky gain", name, "- Opacity", "Moves nothing", "- cloud/99/scale"];
        assert_eq!(show("", &[]), all);
        assert_eq!(show("sky EXPO", &[]), ["Sky", "- Exposure"]);
        assert_eq!(show("gain", &[Some(Owner::Sky)]), ["Sky"]);
        assert!(show("nowhere", &[]).is_empty());
    }
}
