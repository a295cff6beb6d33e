//! Where the panels are docked: a tree of splits and tabs that the user drags, remembered between starts.

use crate::command::{Command, context};
use crate::panel::Panel;
use crate::state::Offered;
use crate::theme;
use crate::widget::{context_menu, name_it};
use egui::scroll_area::{DragScroll, ScrollSource};
use egui::{Id, Rect, Response, ScrollArea, Ui, WidgetText};
use egui_tiles::{
    Behavior, Container, Linear, LinearDir, SimplificationOptions, Tile, TileId, Tiles, Tree, UiResponse,
};

/// Of the viewport's height, what the timeline takes when it comes up.
const TIMELINE_SHARE: f32 = 0.36;

/// Of the window's width, what outline and history take at first, and between how many points.
const LEFT_SHARE: f32 = 0.17;
const LEFT_WIDTHS: [f32; 2] = [150.0, 380.0];
/// As those, of inspector and looks.
const RIGHT_SHARE: f32 = 0.27;
const RIGHT_WIDTHS: [f32; 2] = [260.0, 700.0];

/// The docked panels.
#[derive(Debug)]
pub(super) struct Layout {
    tree: Tree<Panel>,
    /// The user moved something since the last [`Layout::take_changed`].
    changed: bool,
    /// The user has never moved anything.
    untouched: bool,
}

impl Default for Layout {
    fn default() -> Self {
        Self { tree: default_tree(), changed: false, untouched: true }
    }
}

impl Layout {
    /// As [`Layout::to_saved`] gave it; none if that is no layout with a viewport.
    pub(super) fn from_saved(saved: &serde_json::Value) -> Option<Self> {
        let tree: Tree<Panel> = serde::Deserialize::deserialize(saved).ok()?;
        let viewports = tree.tiles.iter().filter(|(_, tile)| matches!(tile, Tile::Pane(Panel::Viewport))).count();
        let is_sound = viewports == 1 && tree.root.is_some_and(|root| holds_once(&tree.tiles, root, &mut Vec::new()));
        is_sound.then_some(Self { tree, changed: false, untouched: false })
    }

    /// To be kept between starts.
    pub(super) fn to_saved(&self) -> Option<serde_json::Value> {
        serde_json::to_value(&self.tree).ok()
    }

    /// Whether the user moved something since this was asked last.
    pub(super) fn take_changed(&mut self) -> bool {
        std::mem::take(&mut self.changed)
    }

    /// Shows all panels; `show` puts the content of one on the screen. The panel that help was asked about, and what was
    /// chosen in the menu of a tab.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        offered: &Offered,
        show: impl FnMut(Panel, &mut Ui),
    ) -> (Option<Panel>, Option<Command>) {
        if self.untouched {
            self.share_out(ui.available_width());
        }
        let in_front = self.tree.active_tiles();
        let mut panes = Panes { show, offered, chosen: None, changed: false, in_front, asked: None };
        self.tree.ui(&mut panes, ui);
        self.changed |= panes.changed;
        self.untouched &= !panes.changed;
        (panes.asked, panes.chosen)
    }

    /// Whether a panel is on the screen: not closed, and not behind another one's tab.
    pub(super) fn shows(&self, panel: Panel) -> bool {
        let tile = self.tree.tiles.find_pane(&panel);
        tile.is_some_and(|tile| self.tree.active_tiles().contains(&tile))
    }

    /// Where the picture is; all the window while it is behind another tab.
    pub(super) fn picture_place(&self, context: &egui::Context) -> Rect {
        self.place_of(Panel::Viewport).unwrap_or_else(|| context.content_rect())
    }

    /// Where a panel was in the last frame, if it is on the screen.
    pub(super) fn place_of(&self, panel: Panel) -> Option<Rect> {
        let tile = self.tree.tiles.find_pane(&panel).filter(|_| self.shows(panel));
        tile.and_then(|tile| self.tree.tiles.rect(tile)).filter(Rect::is_positive)
    }

    /// Another one in place of this.
    pub(super) fn replace(&mut self, other: Self) {
        *self = Self { changed: true, ..other };
    }

    /// All panels to their places.
    pub(super) fn reset(&mut self) {
        self.replace(Self::default());
    }

    /// Shows the tab of a panel that has not been moved, unless the user has arranged panels before.
    pub(super) fn offer(&mut self, panel: Panel) {
        if self.untouched
            && let Some(tile) = self.tree.tiles.find_pane(&panel)
        {
            self.tree.make_active(|id, _| id == tile);
        }
    }

    /// Brings a panel up, wherever it is. One that was closed comes back beside the inspector, timeline and script
    /// below the viewport; there the timeline comes too from its first place, which is narrow.
    pub(super) fn bring_up(&mut self, panel: Panel) {
        self.changed = true;
        self.untouched = false;
        let found = self.tree.tiles.find_pane(&panel);
        if panel == Panel::Timeline
            && let Some(tile) = found.filter(|tile| self.is_beside_looks(*tile))
            && self.put_below_viewport(tile)
        {
            return;
        }
        let tile = found.unwrap_or_else(|| {
            let tile = self.tree.tiles.insert_pane(panel);
            if matches!(panel, Panel::Timeline | Panel::Script) && self.put_below_viewport(tile) {
                return tile;
            }
            let beside = self.tree.tiles.find_pane(&Panel::Inspector).and_then(|id| self.tree.tiles.parent_of(id));
            match beside.or(self.tree.root) {
                Some(parent) => self.tree.move_tile_to_container(tile, parent, usize::MAX, false),
                None => self.tree.root = Some(tile),
            }
            tile
        });
        self.tree.set_visible(tile, true);
        self.tree.make_active(|id, _| id == tile);
    }
}

impl Layout {
    /// Gives side panels that nobody has moved the room that they need and use, and the picture the rest.
    fn share_out(&mut self, width: f32) {
        let tiles = &mut self.tree.tiles;
        let Some(Tile::Container(Container::Linear(root))) = self.tree.root.and_then(|root| tiles.get_mut(root)) else {
            return;
        };
        if let [left, middle, right] = root.children[..]
            && width > 0.0
        {
            let of = |share: f32, [least, most]: [f32; 2]| (share * width).clamp(least, most) / width;
            let [beside, behind] = [of(LEFT_SHARE, LEFT_WIDTHS), of(RIGHT_SHARE, RIGHT_WIDTHS)];
            root.shares.set_share(left, beside);
            root.shares.set_share(middle, 1.0 - beside - behind);
            root.shares.set_share(right, behind);
        }
    }

    /// Whether a tile has its tab among those of what clouds look like.
    fn is_beside_looks(&self, tile: TileId) -> bool {
        let tiles = &self.tree.tiles;
        let dock = tiles.parent_of(tile);
        let is_there = |panel| tiles.find_pane(&panel).is_some_and(|other| tiles.parent_of(other) == dock);
        dock.is_some() && [Panel::ColorLevels, Panel::Flight].into_iter().all(is_there)
    }

    /// Puts a tile below the viewport, over all its width. False if the viewport is not in a place of its own.
    fn put_below_viewport(&mut self, tile: TileId) -> bool {
        let tiles = &mut self.tree.tiles;
        let above = tiles.find_pane(&Panel::Viewport).and_then(|viewport| tiles.parent_of(viewport));
        let Some((above, holder)) = above.and_then(|above| Some((above, tiles.parent_of(above)?))) else {
            return false;
        };
        if let Some(Tile::Container(Container::Tabs(tabs))) = tiles.parent_of(tile).and_then(|dock| tiles.get_mut(dock))
        {
            tabs.children.retain(|child| *child != tile);
            tabs.active = tabs.active.filter(|active| *active != tile).or(tabs.children.first().copied());
        }
        let below = tiles.insert_tab_tile(vec![tile]);
        let mut linear = Linear::new(LinearDir::Vertical, vec![above, below]);
        linear.shares.set_share(above, 1.0 - TIMELINE_SHARE);
        linear.shares.set_share(below, TIMELINE_SHARE);
        let both = tiles.insert_container(Container::Linear(linear));
        let Some(Tile::Container(Container::Linear(parent))) = tiles.get_mut(holder) else { return false };
        parent.shares.replace_with(above, both);
        for child in parent.children.iter_mut().filter(|child| **child == above) {
            *child = both;
        }
        true
    }
}

/// Whether `tile` is there, and no other is within it twice or within itself.
fn holds_once(tiles: &Tiles<Panel>, tile: TileId, seen: &mut Vec<TileId>) -> bool {
    if seen.contains(&tile) {
        return false;
    }
    seen.push(tile);
    match tiles.get(tile) {
        Some(Tile::Pane(_)) => true,
        Some(Tile::Container(container)) => {
            container.children_vec().into_iter().all(|child| holds_once(tiles, child, seen))
        }
        None => false,
    }
}

fn default_tree() -> Tree<Panel> {
    let mut tiles = Tiles::default();
    let mut tabs = |panels: &[Panel]| {
        let children = panels.iter().map(|panel| tiles.insert_pane(*panel)).collect();
        tiles.insert_tab_tile(children)
    };
    let outline = tabs(&[Panel::Outline]);
    let history = tabs(&[Panel::History, Panel::Problems]);
    let viewport = tabs(&[Panel::Viewport]);
    let inspector = tabs(&[Panel::Inspector, Panel::Chart]);
    let looks = tabs(&[Panel::ColorLevels, Panel::ShadingGroups, Panel::Sky, Panel::Flight, Panel::Timeline]);
    let mut split = |dir, parts: &[(TileId, f32)]| {
        let mut linear = Linear::new(dir, parts.iter().map(|(id, _)| *id).collect());
        for (id, share) in parts {
            linear.shares.set_share(*id, *share);
        }
        tiles.insert_container(Container::Linear(linear))
    };
    let left = split(LinearDir::Vertical, &[(outline, 2.6), (history, 1.0)]);
    let right = split(LinearDir::Vertical, &[(inspector, 1.0), (looks, 1.0)]);
    let root = split(
        LinearDir::Horizontal,
        &[(left, LEFT_SHARE), (viewport, 1.0 - LEFT_SHARE - RIGHT_SHARE), (right, RIGHT_SHARE)],
    );
    Tree::new(Id::unique("panels"), root, tiles)
}

struct Panes<'a, F> {
    show: F,
    offered: &'a Offered,
    chosen: Option<Command>,
    changed: bool,
    /// Tiles that no other's tab is before.
    in_front: Vec<TileId>,
    /// The panel that help was asked about.
    asked: Option<Panel>,
}

impl<F: FnMut(Panel, &mut Ui)> Behavior<Panel> for Panes<'_, F> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, panel: &mut Panel) -> UiResponse {
        ui.push_id(*panel, |ui| {
            let frame = if *panel == Panel::Viewport { egui::Frame::NONE } else { theme::side(ui) };
            frame.show(ui, |ui| match panel.least_width() {
                None => (self.show)(*panel, ui),
                Some(least) => scrolled_sideways(ui, least, |ui| (self.show)(*panel, ui)),
            });
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, panel: &Panel) -> WidgetText {
        format!("{} {}", panel.icon(), panel.name()).into()
    }

    fn on_tab_button(&mut self, _tiles: &mut Tiles<Panel>, _tile: TileId, tab: Response) -> Response {
        self.chosen = context_menu(&tab, context::TAB, self.offered).or(self.chosen);
        tab
    }

    fn is_tab_closable(&self, tiles: &Tiles<Panel>, tile: TileId) -> bool {
        // The viewport stays. Tabs behind others can be closed once they are in front: so more have room.
        let is_viewport = matches!(tiles.get(tile), Some(Tile::Pane(Panel::Viewport)) | None);
        !is_viewport && self.in_front.contains(&tile)
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<Panel>,
        ui: &mut Ui,
        _tile: TileId,
        tabs: &egui_tiles::Tabs,
        _scroll_offset: &mut f32,
    ) {
        let Some(Tile::Pane(panel)) = tabs.active.and_then(|active| tiles.get(active)) else { return };
        // It stands at the right.
        ui.add_space(theme::TAB_SPACING);
        let button = ui.add(egui::Button::new("?").frame(false));
        name_it(ui, &button, &format!("Help on {}", panel.name()));
        if button.on_hover_text(format!("The manual's page on {}", panel.name())).clicked() {
            self.asked = Some(*panel);
        }
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        theme::SPLIT_WIDTH
    }

    fn tab_title_spacing(&self, _visuals: &egui::Visuals) -> f32 {
        theme::TAB_SPACING
    }

    fn tab_bar_color(&self, visuals: &egui::Visuals) -> egui::Color32 {
        visuals.extreme_bg_color
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions { all_panes_must_have_tabs: true, ..SimplificationOptions::default() }
    }

    fn on_edit(&mut self, _action: egui_tiles::EditAction) {
        self.changed = true;
    }
}

/// Panels are laid out for the docks of a window of 1280 points, which are so wide. Narrower ones are scrolled sideways.
const DOCK_WIDTH: f32 = 320.0;

/// A place narrower than a dock is scrolled sideways, `least` points wide, instead of cutting off what stands at its right.
fn scrolled_sideways(ui: &mut Ui, least: f32, add: impl FnOnce(&mut Ui)) {
    let room = ui.available_size();
    ScrollArea::horizontal().auto_shrink(false).scroll_source(SCROLLS).show(ui, |ui| {
        ui.set_width(if room.x < DOCK_WIDTH { least.max(room.x) } else { room.x });
        // A panel without content still fills its place.
        ui.set_min_height(room.y);
        add(ui);
        follow_focus(ui);
    });
}

/// Brings what got the focus into sight: areas within, which scroll downwards, leave nothing of that for sideways.
fn follow_focus(ui: &Ui) {
    let focused = ui.memory(|memory| memory.focused());
    let followed: Option<Id> = ui.data(|data| data.get_temp(ui.scope_id()));
    let Some(id) = focused.filter(|id| followed != Some(*id)) else { return };
    let field = ui.ctx().read_response(id).filter(|field| field.layer_id == ui.layer_id());
    // One that is still above or below comes first into this panel, or is another panel's.
    if let Some(field) = field.filter(|field| ui.min_rect().contains(field.rect.min)) {
        ui.scroll_to_rect(field.rect, None);
        ui.data_mut(|data| data.insert_temp(ui.scope_id(), id));
    }
}

/// Not by drags: those belong to what is in the panels.
const SCROLLS: ScrollSource = ScrollSource { scroll_bar: true, drag: DragScroll::Never, mouse_wheel: true };

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comes_back_as_it_was_saved() {
        let mut layout = Layout::default();
        layout.bring_up(Panel::Sky);
        assert!(layout.take_changed() && !layout.take_changed());
        assert!(layout.shows(Panel::Sky) && !layout.shows(Panel::ColorLevels));
        let saved = layout.to_saved().expect("it can be saved");
        let again = Layout::from_saved(&saved).expect("it is a layout");
        assert_eq!(again.tree, layout.tree);
        // The timeline comes up below the viewport from its tab, and hides nothing.
        layout.bring_up(Panel::Timeline);
        assert!(layout.shows(Panel::Sky));
        assert!([Panel::Viewport, Panel::Timeline, Panel::Inspector].into_iter().all(|panel| layout.shows(panel)));
        let saved = layout.to_saved().expect("it can be saved");
        assert_eq!(Layout::from_saved(&saved).expect("it is a layout").tree, layout.tree);
        // A tab is offered only to those who have arranged nothing yet.
        layout.offer(Panel::Flight);
        assert!(!layout.shows(Panel::Flight));
        let mut new = Layout::default();
        new.offer(Panel::Timeline);
        assert!(new.shows(Panel::Timeline) && !new.shows(Panel::ColorLevels) && !new.take_changed());
        new.bring_up(Panel::Timeline);
        assert!([Panel::Timeline, Panel::ColorLevels].into_iter().all(|panel| new.shows(panel)));
        for bad in [serde_json::json!(null), serde_json::json!({"root": 7}), serde_json::json!([])] {
            assert!(Layout::from_saved(&bad).is_none(), "{bad}");
        }
    }
}
