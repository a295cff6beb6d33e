//! The only colours and spacings.

pub(crate) mod icon;
mod tint;

pub(crate) use tint::{group_tint, of_folder, tint_of, tints};

use cloudwright_core::method::Family;
use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, Frame, Id, Margin, RichText, Stroke, Style,
    Theme, Ui, Vec2, Visuals, vec2,
};
use egui_code_editor::{Color32Theme, ColorTheme};

/// Between things that belong apart.
pub(crate) const GAP: f32 = 8.0;
/// Between docked panels, points.
pub(crate) const SPLIT_WIDTH: f32 = 3.0;
/// Beside the name in a panel's tab: five of them have room in the narrowest place.
pub(crate) const TAB_SPACING: f32 = 5.5;
/// From a dialog in a corner to the window's rim, points.
pub(crate) const DIALOG_MARGIN: f32 = 40.0;
/// Points.
pub(crate) const DIALOG_WIDTH: f32 = 380.0;
/// Points.
pub(crate) const WIDE_DIALOG_WIDTH: f32 = 560.0;
/// Points.
pub(crate) const DIALOG_LIST_HEIGHT: f32 = 320.0;
/// Of the start page, if there is room, points.
pub(crate) const START_WIDTH: f32 = 960.0;
/// Of a picture on it, points.
pub(crate) const START_PICTURE: Vec2 = vec2(152.0, 95.0);
/// Of what is new on it, points.
pub(crate) const NEWS_WIDTH: f32 = 290.0;
/// Of what is new on it, points.
pub(crate) const NEWS_HEIGHT: f32 = 380.0;
/// Of the manual at first, points.
pub(crate) const MANUAL_SIZE: Vec2 = vec2(780.0, 560.0);
/// Of the list of its pages, points.
pub(crate) const PAGES_WIDTH: f32 = 170.0;
/// Of what a report tells, points.
pub(crate) const REPORT_HEIGHT: f32 = 160.0;
/// Of a progress bar, points.
pub(crate) const PROGRESS_WIDTH: f32 = 140.0;
/// Of a field for a number, points.
pub(crate) const NUMBER_WIDTH: f32 = 62.0;
/// Of a field for a seed, points.
pub(crate) const SEED_WIDTH: f32 = 96.0;
/// Of a script, points.
pub(crate) const CODE_TEXT: f32 = 13.0;
/// Of what stands beneath a script, points.
pub(crate) const OUTPUT_HEIGHT: f32 = 72.0;
/// Beside the number of a plugin's parameter, points.
pub(crate) const PARAMETER_SLIDER_WIDTH: f32 = 104.0;
/// Of a plugin's curve or report, points.
pub(crate) const PARAMETER_WIDTH: f32 = 216.0;
/// Of the window's height, what the fields of a plugin may take before they scroll.
pub(crate) const FORM_SHARE: f32 = 0.5;
/// As that, of a form that holds lists of its own.
pub(crate) const WIDE_FORM_SHARE: f32 = 0.66;
/// What is kept free for what a plugin says, points: two lines.
pub(crate) const SAID_HEIGHT: f32 = 36.0;
/// Of the column of names in the inspector, points.
pub(crate) const NAME_WIDTH: f32 = 108.0;
/// Of the presets to choose from: three pictures side by side, points.
pub(crate) const GALLERY_WIDTH: f32 = 620.0;
/// Of the menu of categories: three pictures side by side, points.
pub(crate) const CATEGORIES_WIDTH: f32 = 306.0;
/// Of messages, points.
pub(crate) const TOAST_WIDTH: f32 = 340.0;
/// Points.
pub(crate) const LEAST_TOAST_WIDTH: f32 = 180.0;
/// Between messages and the window's rim, points.
pub(crate) const TOAST_MARGIN: f32 = 12.0;
/// Of a bar without text, points.
pub(crate) const THIN_BAR: f32 = 4.0;
/// Of a tint's mark in a list, points.
pub(crate) const SWATCH: f32 = 10.0;
/// Of a curve with its scale, points.
pub(crate) const CURVE_HEIGHT: f32 = 132.0;
/// Of numbers at a scale, points.
pub(crate) const SMALL_TEXT: f32 = 11.0;
/// Around marks in the viewport.
pub(crate) const VIEWPORT_MARGIN: f32 = 10.0;
/// Of instruments in the viewport, points.
pub(crate) const HUD_TEXT: f32 = 15.0;
/// From the viewport's lower rim to the instruments, points: the hints stand below.
pub(crate) const HUD_HEIGHT: f32 = 40.0;

/// Of the picture of a ready-made cloud to choose, points.
pub(crate) const PRESET_PICTURE: Vec2 = vec2(192.0, 120.0);
/// Of a category among the others: three of them side by side in the inspector, points.
pub(crate) const CATEGORY_PICTURE: Vec2 = vec2(90.0, 56.25);
/// Between a picture and its name, points.
pub(crate) const PICTURE_NAME_GAP: f32 = 4.0;

/// A selected box.
pub(crate) const SELECTED_BOX: Stroke = Stroke { width: 1.5, color: Color32::from_rgb(255, 176, 64) };
/// What a press would take.
pub(crate) const HOVERED: Stroke = Stroke { width: 1.2, color: Color32::from_rgb(255, 226, 160) };
/// A box of a selected cloud: there may be a hundred, and the cloud must be seen through them.
pub(crate) const SELECTED_CLOUD: Stroke =
    Stroke { width: 1.2, color: Color32::from_rgba_premultiplied(96, 64, 22, 96) };
/// A box beside the selected one.
pub(crate) const RELATED_BOX: Stroke = Stroke { width: 1.0, color: Color32::from_rgba_premultiplied(92, 78, 54, 92) };
/// Any other box.
pub(crate) const OTHER_BOX: Stroke = Stroke { width: 1.0, color: Color32::from_rgba_premultiplied(28, 52, 88, 130) };
/// A camera in the viewport.
pub(crate) const CAMERA: Stroke = Stroke { width: 1.2, color: Color32::from_rgb(200, 224, 255) };
/// Under bright lines, so that they are seen on bright clouds.
pub(crate) const CASING: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 90);
/// How far that shows on each side, points.
pub(crate) const CASING_WIDTH: f32 = 0.8;
/// Of an edge's opacity: behind its own box.
pub(crate) const FAR_EDGE: f32 = 0.4;
/// A sprite that is marked.
pub(crate) const SPRITE_MARK: Color32 = Color32::from_rgb(120, 214, 255);
/// Of a tint's opacity: a sprite's quad in the group view.
pub(crate) const GROUP_FILL: f32 = 0.18;
/// Of a mark's opacity: a sprite's outline.
pub(crate) const SPRITE_OUTLINE: f32 = 0.55;
/// The plane that the box tool draws on.
pub(crate) const GRID: Stroke = Stroke { width: 1.0, color: Color32::from_rgba_premultiplied(120, 132, 148, 150) };
/// What a marquee covers.
pub(crate) const MARQUEE_FILL: Color32 = Color32::from_rgba_premultiplied(20, 34, 52, 60);
/// Around a marquee.
pub(crate) const MARQUEE: Stroke = Stroke { width: 1.0, color: Color32::from_rgb(150, 200, 255) };
/// East, up and south.
pub(crate) const AXIS_X: Color32 = Color32::from_rgb(236, 74, 86);
/// East, up and south.
pub(crate) const AXIS_Y: Color32 = Color32::from_rgb(98, 196, 76);
/// East, up and south.
pub(crate) const AXIS_Z: Color32 = Color32::from_rgb(62, 134, 246);
/// Across the view.
pub(crate) const AXIS_VIEW: Color32 = Color32::from_rgb(240, 240, 244);
/// A handle under the pointer.
pub(crate) const GIZMO_HOVERED: Color32 = Color32::from_rgb(255, 224, 96);
/// Points.
pub(crate) const GIZMO_WIDTH: f32 = 3.5;
/// From its middle to an arrow's tip, points.
pub(crate) const GIZMO_SIZE: f32 = 84.0;
/// Around a handle.
pub(crate) const HANDLE_RIM: Stroke = Stroke { width: 1.0, color: Color32::from_rgb(40, 26, 6) };
/// What is chosen among handles.
pub(crate) const CHOSEN: Color32 = SELECTED_BOX.color;
/// Shows through where a colour is clear.
pub(crate) const CHECKERBOARD: [Color32; 2] = [Color32::from_gray(168), Color32::from_gray(122)];
/// Behind a cloud's silhouette: a sky that white and dark clouds both stand out from.
pub(crate) const SILHOUETTE_SKY: Color32 = Color32::from_rgb(58, 84, 118);
/// On that sky.
pub(crate) const SILHOUETTE_TEXT: Color32 = Color32::from_rgba_premultiplied(200, 206, 214, 215);
/// A colour level's height across the silhouette.
pub(crate) const LEVEL_GUIDE: Color32 = Color32::from_rgba_premultiplied(62, 62, 62, 62);
/// The sun, its rise and its set.
pub(crate) const SUN: Color32 = Color32::from_rgb(255, 208, 92);
/// The sun below the horizon.
pub(crate) const SUN_BELOW: Color32 = Color32::from_rgb(122, 112, 96);
/// The sun's way over the day.
pub(crate) const SUN_PATH: Color32 = Color32::from_rgb(226, 190, 110);
/// The present hour on a strip: no sky has this colour.
pub(crate) const NOW: Color32 = Color32::from_rgb(232, 48, 58);
/// Behind the switch of what keys by itself.
pub(crate) const AUTO_KEY: Color32 = Color32::from_rgb(190, 36, 44);
/// Behind text in the viewport.
pub(crate) const VIEWPORT_SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 110);
/// Over what a camera that is looked through does not see.
pub(crate) const AROUND_FRAME: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 130);
/// Text in the viewport, on that shade.
pub(crate) const VIEWPORT_TEXT: Color32 = Color32::from_gray(235);
/// Behind instruments in the viewport, which must be read at a glance before a white cloud too.
pub(crate) const HUD_SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 170);

/// Of the rim of what has the keyboard's focus, points.
const FOCUS_WIDTH: f32 = 2.0;

const ACCENT_DARK: Color32 = Color32::from_rgb(52, 96, 148);
const ACCENT_LIGHT: Color32 = Color32::from_rgb(168, 205, 240);

/// Gives the window both looks; the desktop's own preference decides until the user switches.
pub(crate) fn install(context: &Context) {
    install_icons(context);
    context.style_mut_of(Theme::Dark, |style| {
        spacing(style);
        dark(&mut style.visuals);
    });
    context.style_mut_of(Theme::Light, |style| {
        spacing(style);
        light(&mut style.visuals);
    });
}

/// The icon font stands behind the text fonts, so that its glyphs may stand in any text.
fn install_icons(context: &Context) {
    let mut fonts = FontDefinitions::default();
    let icons = FontData::from_static(include_bytes!("../../../assets/fonts/icons.ttf"));
    fonts.font_data.insert("icons".into(), icons.into());
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.entry(family).or_default().push("icons".into());
    }
    context.set_fonts(fonts);
}

/// A button's icon.
pub(crate) fn tool_text(icon: &str) -> RichText {
    RichText::new(icon).size(17.0)
}

fn spacing(style: &mut Style) {
    style.spacing.item_spacing = vec2(6.0, 5.0);
    style.spacing.button_padding = vec2(8.0, 3.0);
    style.spacing.interact_size.y = 22.0;
    style.spacing.slider_width = 150.0;
    style.spacing.indent = 14.0;
    style.visuals.indent_has_left_vline = false;
    style.visuals.slider_trailing_fill = true;
    for corner in [
        &mut style.visuals.widgets.inactive.corner_radius,
        &mut style.visuals.widgets.hovered.corner_radius,
        &mut style.visuals.widgets.active.corner_radius,
        &mut style.visuals.widgets.open.corner_radius,
        &mut style.visuals.widgets.noninteractive.corner_radius,
    ] {
        *corner = CornerRadius::same(4);
    }
}

fn dark(visuals: &mut Visuals) {
    visuals.error_fg_color = Color32::from_rgb(255, 128, 116);
    visuals.warn_fg_color = Color32::from_rgb(255, 190, 92);
    visuals.panel_fill = Color32::from_rgb(32, 35, 40);
    visuals.window_fill = Color32::from_rgb(38, 42, 48);
    visuals.extreme_bg_color = Color32::from_rgb(22, 24, 28);
    visuals.faint_bg_color = Color32::from_rgb(38, 41, 47);
    visuals.selection.bg_fill = ACCENT_DARK;
    visuals.widgets.noninteractive.bg_stroke.color = Color32::from_rgb(54, 58, 66);
    visuals.widgets.noninteractive.fg_stroke.color = Color32::from_gray(190);
    visuals.widgets.inactive.weak_bg_fill = Color32::from_rgb(50, 54, 62);
    visuals.widgets.inactive.bg_fill = Color32::from_rgb(58, 63, 72);
    visuals.widgets.inactive.fg_stroke.color = Color32::from_gray(210);
    visuals.widgets.active.bg_stroke = Stroke::new(FOCUS_WIDTH, focus_color(true));
}

fn light(visuals: &mut Visuals) {
    visuals.error_fg_color = Color32::from_rgb(178, 34, 34);
    visuals.warn_fg_color = Color32::from_rgb(168, 92, 0);
    visuals.panel_fill = Color32::from_rgb(244, 245, 247);
    // So far from white that fields of text stand out.
    visuals.window_fill = Color32::from_rgb(240, 242, 245);
    // Five times as dark as its ground at least.
    visuals.weak_text_color = Some(Color32::from_gray(100));
    visuals.selection.bg_fill = ACCENT_LIGHT;
    visuals.selection.stroke.color = Color32::from_rgb(10, 48, 92);
    visuals.widgets.noninteractive.bg_stroke.color = Color32::from_rgb(214, 217, 222);
    visuals.widgets.inactive.weak_bg_fill = Color32::from_rgb(228, 231, 236);
    visuals.widgets.inactive.bg_fill = Color32::from_rgb(214, 218, 225);
    visuals.widgets.active.bg_stroke = Stroke::new(FOCUS_WIDTH, focus_color(false));
}

/// Of menus: quiet but for what the pointer or the keyboard is at.
pub(crate) fn menu(style: &mut Style) {
    egui::containers::menu::menu_style(style);
    style.visuals.widgets.active.bg_stroke = Stroke::new(FOCUS_WIDTH, focus_color(style.visuals.dark_mode));
}

/// The window clears itself to the panels' colour, so that they need not be filled with it: where a program paints, that is
/// a third of all its pixels.
pub(crate) fn panels_stand_on_clear(context: &Context) {
    context.data_mut(|data| data.insert_temp(cleared(), true));
}

/// What the window is to be cleared to.
pub(crate) fn clear_color(visuals: &Visuals) -> [f32; 4] {
    visuals.panel_fill.to_normalized_gamma_f32()
}

fn cleared() -> Id {
    Id::unique("the window clears itself to the panels' colour")
}

fn on_panel_color(ui: &Ui) -> Frame {
    let is_there = ui.data(|data| data.get_temp(cleared())).unwrap_or(false);
    if is_there { Frame::new() } else { Frame::new().fill(ui.visuals().panel_fill) }
}

/// Menus, tools and status.
pub(crate) fn bar(ui: &Ui) -> Frame {
    on_panel_color(ui).inner_margin(Margin::symmetric(8, 4))
}

/// Outline and inspector.
pub(crate) fn side(ui: &Ui) -> Frame {
    on_panel_color(ui).inner_margin(Margin::symmetric(10, 8))
}

/// Windows that come up over the editor.
pub(crate) fn dialog(context: &Context) -> Frame {
    Frame::popup(&context.global_style()).inner_margin(Margin::same(16))
}

/// Around a picture that is chosen, or that the keyboard is at.
pub(crate) fn chosen_picture(ui: &Ui) -> Stroke {
    Stroke::new(2.0, ui.visuals().selection.stroke.color)
}

/// Controls that stand in the viewport.
pub(crate) fn overlay(ui: &Ui) -> Frame {
    Frame::new()
        .fill(ui.visuals().panel_fill.gamma_multiply(0.92))
        .corner_radius(6)
        .inner_margin(Margin::symmetric(6, 4))
}

/// What goes under a line, so that it is seen on bright clouds: as faint as the line is.
pub(crate) fn casing(stroke: Stroke) -> Stroke {
    Stroke { width: stroke.width + 2.0 * CASING_WIDTH, color: CASING.gamma_multiply_u8(stroke.color.a()) }
}

/// A family of methods in charts: the colours of `chart.html`, told apart without red and green too.
pub(crate) fn family(ui: &Ui, family: Family) -> Color32 {
    let [light, dark] = match family {
        Family::Truth => [[23, 33, 43], [232, 238, 243]],
        Family::Shipped => [[10, 98, 176], [108, 182, 255]],
        Family::Other => [[100, 116, 139], [147, 164, 181]],
        Family::Failing => [[196, 80, 10], [255, 156, 90]],
    };
    let [r, g, b] = if ui.visuals().dark_mode { dark } else { light };
    Color32::from_rgb(r, g, b)
}

/// What is worth a look.
pub(crate) fn warning(ui: &Ui) -> Color32 {
    ui.visuals().warn_fg_color
}

/// From one colour towards another by that share.
pub(crate) fn mix(from: Color32, to: Color32, share: f32) -> Color32 {
    from.lerp_to_gamma(to, share)
}

/// A key, and what is keyed.
pub(crate) fn key(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_rgb(244, 202, 78) } else { Color32::from_rgb(168, 112, 0) }
}

/// What was changed since it was keyed.
pub(crate) fn changed_key(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_rgb(255, 112, 76) } else { Color32::from_rgb(190, 54, 12) }
}

/// What could be keyed.
pub(crate) fn no_key(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_gray(104) } else { Color32::from_gray(158) }
}

/// Around a handle in a colour of the artist's.
pub(crate) fn tag_edge(ui: &Ui) -> Color32 {
    ui.visuals().widgets.inactive.fg_stroke.color
}

/// Sunrise and sunset, on the panel's ground.
pub(crate) fn sun_mark(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { SUN } else { Color32::from_rgb(176, 116, 0) }
}

/// Around what the tour is about.
pub(crate) fn tour(context: &Context) -> Stroke {
    Stroke::new(3.0, focus_color(context.theme() == Theme::Dark))
}

/// Around what has the keyboard's focus.
const fn focus_color(is_dark: bool) -> Color32 {
    if is_dark { Color32::from_rgb(112, 178, 255) } else { Color32::from_rgb(0, 92, 184) }
}

/// What is wrong.
pub(crate) fn error(ui: &Ui) -> Color32 {
    ui.visuals().error_fg_color
}

/// What went well.
pub(crate) fn good(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_rgb(124, 204, 140) } else { Color32::from_rgb(32, 122, 58) }
}

/// Over a line of a script that is at fault.
pub(crate) fn fault_line(ui: &Ui) -> Color32 {
    error(ui).gamma_multiply(0.22)
}

/// The words of a script.
pub(crate) fn code(ui: &Ui) -> Color32Theme {
    let dark = ui.visuals().dark_mode;
    let theme = if dark { ColorTheme::GITHUB_DARK } else { ColorTheme::GITHUB_LIGHT };
    Color32Theme {
        bg: ui.visuals().extreme_bg_color,
        selection: ui.visuals().selection.bg_fill,
        cursor: ui.visuals().strong_text_color(),
        ..theme.into()
    }
}
