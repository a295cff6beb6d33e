//! Pictures to choose from: ready-made clouds, skies to begin with, and categories.
//!
//! A tile is a button with a picture above its name: reached by Tab and the arrow keys, pressed by Enter, Space or
//! click, and named for screen readers. Until its picture is drawn it is a quiet blank. Nothing is changed here; what was
//! chosen is returned.

use crate::starter::Template;
use crate::theme;
use crate::thumbnail::{Subject, Thumbnails};
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Category;
use egui::accesskit::Role;
use egui::{
    Color32, Rect, Response, Sense, StrokeKind, TextStyle, TextWrapMode, TextureId, Ui, Vec2, WidgetInfo, WidgetText,
    pos2, vec2,
};

/// All presets. The one that was chosen in this frame.
pub fn preset_choice(ui: &mut Ui, thumbnails: &mut Thumbnails) -> Option<&'static Preset> {
    side_by_side(ui, |ui| {
        let mut chosen = None;
        for preset in Preset::ALL {
            let texture = thumbnails.texture(&Subject::Preset(preset));
            let response = picture_button(ui, texture, theme::PRESET_PICTURE, preset.label, None);
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(preset.help));
            if response.on_hover_text(preset.help).clicked() {
                chosen = Some(preset);
            }
        }
        chosen
    })
}

/// All skies to begin with, drawn by `thumbnails` if they may be by now. The one that was chosen in this frame, and the
/// first tile.
pub(crate) fn template_choice(
    ui: &mut Ui,
    mut thumbnails: Option<&mut Thumbnails>,
) -> (Option<Template>, Option<Response>) {
    side_by_side(ui, |ui| {
        let (mut chosen, mut first) = (None, None);
        for template in Template::ALL {
            let texture = thumbnails.as_mut().and_then(|thumbnails| thumbnails.texture(&Subject::Template(template)));
            let response = picture_button(ui, texture, theme::START_PICTURE, template.label(), None);
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(template.help()));
            let response = response.on_hover_text(template.help());
            if response.clicked() {
                chosen = Some(template);
            }
            first.get_or_insert(response);
        }
        (chosen, first)
    })
}

/// All categories, `present` marked. The one that was chosen in this frame, if it is another.
pub fn category_choice(ui: &mut Ui, thumbnails: &mut Thumbnails, present: Option<Category>) -> Option<Category> {
    side_by_side(ui, |ui| {
        let mut chosen = None;
        for category in Category::ALL {
            let texture = thumbnails.texture(&Subject::Category(category));
            let name = category_name(category);
            let response = picture_button(ui, texture, theme::CATEGORY_PICTURE, &name, Some(Some(category) == present));
            if response.on_hover_text(name).clicked() && Some(category) != present {
                chosen = Some(category);
            }
        }
        chosen
    })
}

/// Tiles side by side, as many in a row as there is room for.
pub(crate) fn side_by_side<T>(ui: &mut Ui, tiles: impl FnOnce(&mut Ui) -> T) -> T {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = Vec2::splat(theme::GAP);
        tiles(ui)
    })
    .inner
}

/// One tile, with a mark if it is `selected`; tiles that can't be have none.
pub(crate) fn picture_button(
    ui: &mut Ui,
    texture: Option<TextureId>,
    picture: Vec2,
    name: &str,
    selected: Option<bool>,
) -> Response {
    let size = picture + vec2(0.0, ui.text_style_height(&name_style(picture)) + theme::PICTURE_NAME_GAP);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| match selected {
        Some(selected) => WidgetInfo::selected(Role::Button, ui.is_enabled(), selected, name),
        None => WidgetInfo::labeled(Role::Button, ui.is_enabled(), name),
    });
    if ui.is_rect_visible(rect) {
        paint(ui, &response, texture, picture, name, selected == Some(true));
    }
    response
}

fn paint(ui: &Ui, response: &Response, texture: Option<TextureId>, picture: Vec2, name: &str, selected: bool) {
    let visuals = ui.style().interact(response);
    let painter = ui.painter();
    let picture = Rect::from_min_size(response.rect.min, picture);
    match texture {
        Some(texture) => {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture, picture, whole, Color32::WHITE);
        }
        None => {
            painter.rect_filled(picture, 0.0, ui.visuals().extreme_bg_color);
        }
    }
    let stroke = if selected || response.has_focus() {
        theme::chosen_picture(ui)
    } else if response.hovered() {
        visuals.fg_stroke
    } else {
        ui.visuals().widgets.noninteractive.bg_stroke
    };
    painter.rect_stroke(picture, 0.0, stroke, StrokeKind::Outside);
    let text = WidgetText::from(name).into_galley(
        ui,
        Some(TextWrapMode::Truncate),
        picture.width(),
        name_style(picture.size()),
    );
    let left = picture.center().x - 0.5 * text.size().x;
    painter.galley(pos2(left, response.rect.bottom() - text.size().y), text, visuals.text_color());
}

/// Names of small pictures are small.
fn name_style(picture: Vec2) -> TextStyle {
    if picture.x < theme::PRESET_PICTURE.x { TextStyle::Small } else { TextStyle::Body }
}

/// The file's name in words.
pub(super) fn category_name(category: Category) -> String {
    category.name().replace('_', " ")
}
