//! How the scene is looked at and worked on: selection, tool, what is hidden. Never saved, never undone.

use super::selection::{Item, Selection};
use super::timeline::TimelineView;
use cloudwright_core::draw_list::{Hidden, Sorting};
use cloudwright_core::method::Method;
use cloudwright_core::scene::{Cloud, PathId, Scene};
use std::collections::BTreeSet;

/// What the primary button does in the viewport.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Tool {
    /// Click to choose, drag for a marquee.
    #[default]
    Select,
    /// Arrows to move the selection by.
    Move,
    /// Rings to turn it by.
    Rotate,
    /// Cubes to stretch it by.
    Scale,
    /// Drag a footprint, then pull the height.
    Box,
}

/// How sprites are marked in the viewport.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SpriteMarks {
    /// Not at all.
    #[default]
    Off,
    /// A dot at each centre.
    Dots,
    /// Each quad's outline.
    Outlines,
}

impl SpriteMarks {
    /// The one that a press of the key leads to.
    pub(crate) fn next(self) -> Self {
        match self {
            Self::Off => Self::Dots,
            Self::Dots => Self::Outlines,
            Self::Outlines => Self::Off,
        }
    }
}

/// What is seen of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Lens {
    /// All of it.
    #[default]
    Picture,
    /// Its left part, and right of a handle the truth.
    Wipe,
    /// How many sprites are blended at each pixel.
    Overdraw,
    /// What the order of whole sprites costs in colour.
    WrongOrder,
    /// How much it looks different from the truth.
    Error,
}

impl Lens {
    /// As they stand in the panel.
    pub(crate) const ALL: [Self; 5] = [Self::Picture, Self::Wipe, Self::Overdraw, Self::WrongOrder, Self::Error];

    /// For people.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Picture => "Picture",
            Self::Wipe => "Wipe",
            Self::Overdraw => "Overdraw",
            Self::WrongOrder => "Wrong order",
            Self::Error => "Error",
        }
    }

    /// What it shows.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Picture => "The picture as it is.",
            Self::Wipe => "The truth to the right of a handle that can be dragged.",
            Self::Overdraw => "How many sprites are blended at each pixel: what clouds cost.",
            Self::WrongOrder => {
                "How much the pixel changes because whole sprites are put in order, not each ray's fragments."
            }
            Self::Error => "How much the picture looks different from the truth (FLIP).",
        }
    }
}

/// What gestures snap to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Snap {
    /// Whether they do; Ctrl does the opposite while it is held.
    pub on: bool,
    /// For places and sizes, metres.
    pub step_m: f64,
    /// For turns, degrees.
    pub angle_deg: f64,
    /// For scales.
    pub scale: f64,
}

impl Default for Snap {
    fn default() -> Self {
        Self { on: false, step_m: 50.0, angle_deg: 15.0, scale: 0.1 }
    }
}

/// The editor's own view of the scene.
#[derive(Debug, Clone)]
pub struct ViewState {
    /// What is selected.
    pub selection: Selection,
    /// What the primary button does.
    pub tool: Tool,
    /// What gestures snap to.
    pub snap: Snap,
    /// Whether a box that is resized stays as densely filled.
    pub keep_fill: bool,
    /// The altitude that the box tool draws on, metres; none: that of the selected cloud, or 1,000.
    pub base_altitude_m: Option<f64>,
    /// The outlines of all boxes, not only of selected ones.
    pub show_all_boxes: bool,
    /// Marks at sprites.
    pub sprite_marks: SpriteMarks,
    /// Boxes and sprites in the tints of their shading groups.
    pub group_view: bool,
    /// Whether there is haze.
    pub haze: bool,
    /// Whether sprites are drawn that merged ones could stand for.
    pub all_sprites: bool,
    /// Whether three orthographic views are shown beside the free one.
    pub quad: bool,
    /// Whether a corner of the viewport shows what the chosen camera sees.
    pub camera_picture: bool,
    /// When sprites are sorted again, unless a method says so.
    pub sorting: Sorting,
    /// By which method the picture is drawn; none for the window's own way.
    pub method: Option<&'static Method>,
    /// What is seen of the picture.
    pub lens: Lens,
    /// The key that is worked on, of a path that is selected.
    pub path_key: Option<(PathId, usize)>,
    /// What of the timeline is worked on.
    pub timeline: TimelineView,
    /// Whose name is typed in the outline.
    pub renaming: Option<Item>,
    /// Clouds and boxes that are not drawn.
    pub hidden: BTreeSet<Item>,
    /// Clouds and boxes that the pointer passes through.
    pub locked: BTreeSet<Item>,
    /// If any: only these clouds, and those of these folders, are drawn.
    pub solo: BTreeSet<Item>,
}

impl Default for ViewState {
    fn default() -> Self {
        Self {
            selection: Selection::default(),
            tool: Tool::default(),
            snap: Snap::default(),
            keep_fill: true,
            base_altitude_m: None,
            show_all_boxes: false,
            sprite_marks: SpriteMarks::default(),
            group_view: false,
            haze: true,
            all_sprites: false,
            quad: false,
            camera_picture: true,
            sorting: Sorting::default(),
            method: None,
            lens: Lens::default(),
            path_key: None,
            timeline: TimelineView::default(),
            renaming: None,
            hidden: BTreeSet::new(),
            locked: BTreeSet::new(),
            solo: BTreeSet::new(),
        }
    }
}

/// Where the box tool draws when nothing says otherwise, metres.
const BASE_ALTITUDE_M: f64 = 1000.0;

impl ViewState {
    /// The altitude that the box tool draws on, metres.
    pub fn base_altitude_m(&self, scene: &Scene) -> f64 {
        let selected = || self.selection.cloud(scene).map(|cloud| cloud.position.y);
        self.base_altitude_m.or_else(selected).unwrap_or(BASE_ALTITUDE_M)
    }

    /// Whether `cloud` of `scene` is drawn.
    pub fn shows(&self, scene: &Scene, cloud: &Cloud) -> bool {
        let item = Item::Cloud(cloud.id);
        let is_in_solo = || cloud.folder.is_some_and(|id| self.solo.contains(&Item::Folder(id)));
        scene.is_seen(cloud)
            && !self.hidden.contains(&item)
            && !self.hidden.contains(&Item::Model(cloud.model))
            && (self.solo.is_empty() || self.solo.contains(&item) || is_in_solo())
    }

    /// Whether `item` can be hidden and locked by itself in the view: folders are in the scene.
    pub(crate) fn can_hide(item: Item) -> bool {
        matches!(item, Item::Model(_) | Item::Box(..) | Item::Cloud(_))
    }

    /// What the renderers leave out.
    pub(crate) fn hidden_in(&self, scene: &Scene) -> Hidden {
        let hidden = Hidden { haze: !self.haze, ..Hidden::default() };
        if self.hidden.is_empty() && self.solo.is_empty() {
            return hidden;
        }
        let clouds = scene.clouds.iter().filter(|cloud| !self.shows(scene, cloud));
        let boxes = self.hidden.iter().filter_map(|item| if let Item::Box(_, id) = item { Some(*id) } else { None });
        Hidden { clouds: clouds.map(|cloud| cloud.id).collect(), boxes: boxes.collect(), ..hidden }
    }

    /// Whether the pointer may pick `cloud` of `scene`.
    pub fn can_pick(&self, scene: &Scene, cloud: &Cloud) -> bool {
        self.shows(scene, cloud)
            && !scene.is_locked(cloud)
            && !self.locked.contains(&Item::Cloud(cloud.id))
            && !self.locked.contains(&Item::Model(cloud.model))
    }

    /// Which key of `path` is worked on; none for the whole path.
    pub(crate) fn key_of(&self, path: PathId) -> Option<usize> {
        self.path_key.filter(|(of, _)| *of == path).map(|(_, index)| index)
    }

    /// Leaves out what the scene has no longer.
    pub(crate) fn keep_what_is_in(&mut self, scene: &Scene) {
        self.selection.keep_what_is_in(scene);
        self.timeline.keep_what_is_in(scene);
        for set in [&mut self.hidden, &mut self.locked, &mut self.solo] {
            set.retain(|item| item.is_in(scene));
        }
        self.renaming = self.renaming.filter(|item| item.is_in(scene));
        self.path_key = self.path_key.filter(|(id, index)| {
            let count = scene.path(*id).map_or(0, |path| path.keys.len());
            self.selection.contains(Item::Path(*id)) && *index < count
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::starter::starter_scene;

    #[test]
    fn what_is_hidden_is_not_drawn() {
        let mut scene = starter_scene();
        let mut other = scene.clouds[0].clone();
        other.id = cloudwright_core::scene::CloudId::new(&mut scene.next_id);
        scene.clouds.push(other);
        let [one, two] = [0, 1].map(|i| scene.clouds[i].id);
        let mut view = ViewState::default();
        assert_eq!(view.hidden_in(&scene), Hidden::default());
        let (model, box_id) = (scene.models[0].id, scene.models[0].boxes[1].id);
        view.hidden.extend([Item::Cloud(two), Item::Box(model, box_id)]);
        let hidden = view.hidden_in(&scene);
        assert_eq!((hidden.clouds, hidden.boxes), ([two].into(), [box_id].into()));
        view.hidden = [Item::Model(model)].into();
        assert_eq!(view.hidden_in(&scene).clouds, [one, two].into(), "a model hides all its clouds");
        view.hidden.clear();
        view.solo.insert(Item::Cloud(two));
        assert_eq!(view.hidden_in(&scene).clouds, [one].into());
        view.haze = false;
        assert!(view.hidden_in(&scene).haze && !view.hidden_in(&scene).ground);
    }
}
