//! A button in a colour that opens a picker of sRGB: saturation across and brightness up for one hue, the hues below,
//! and the same as numbers and as text. (egui's own picker needs a glyph that our fonts don't have.)

use super::name_it;
use crate::theme;
use egui::accesskit::Role;
use egui::ecolor::HsvaGamma;
use egui::{
    Color32, DragValue, Id, Mesh, Popup, PopupCloseBehavior, Pos2, Rect, Response, Sense, Stroke, StrokeKind, TextEdit,
    Ui, Vec2, WidgetInfo, pos2, vec2,
};

/// Points.
const FIELD: Vec2 = vec2(208.0, 128.0);
const HUES: Vec2 = vec2(FIELD.x, 16.0);
/// So many flat parts stand for a smooth change.
const PARTS: u32 = 24;

/// The button, with its popup. Its response is marked as changed if the colour is another one.
pub(super) fn button(ui: &mut Ui, label: &str, srgb: &mut [u8; 3]) -> Response {
    let (rect, mut response) = ui.allocate_exact_size(ui.spacing().interact_size, Sense::click());
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::ColorWell, enabled, label));
    let visuals = ui.style().interact(&response);
    ui.painter().rect(rect.shrink(1.0), visuals.corner_radius, color32(*srgb), visuals.bg_stroke, StrokeKind::Inside);
    if response.has_focus() {
        let focus = ui.visuals().selection.stroke;
        ui.painter().rect_stroke(rect, visuals.corner_radius, focus, StrokeKind::Outside);
    }
    let before = *srgb;
    Popup::menu(&response)
        .id(response.id.with("picker"))
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| picker(ui, label, srgb));
    if *srgb != before {
        response.mark_changed();
    }
    response
}

fn picker(ui: &mut Ui, label: &str, srgb: &mut [u8; 3]) {
    let id = ui.scope_id().with(label);
    let before = hsv_of(ui, id, *srgb);
    let mut hsv = before;
    let field = |h: f32| move |at: Vec2| HsvaGamma { h, s: at.x, v: 1.0 - at.y, a: 1.0 };
    if let Some(at) = plane(ui, label, FIELD, PARTS, vec2(hsv.s, 1.0 - hsv.v), field(hsv.h)) {
        (hsv.s, hsv.v) = (at.x, 1.0 - at.y);
    }
    let hues = |at: Vec2| HsvaGamma { h: at.x, s: 1.0, v: 1.0, a: 1.0 };
    if let Some(at) = plane(ui, &format!("{label} hue"), HUES, 1, vec2(hsv.h, 0.5), hues) {
        hsv.h = at.x;
    }
    if hsv != before {
        *srgb = bytes(hsv);
        ui.data_mut(|data| data.insert_temp(id, hsv));
    }
    ui.horizontal(|ui| {
        for (part, (letter, name)) in srgb.iter_mut().zip([("R ", "red"), ("G ", "green"), ("B ", "blue")]) {
            let field = ui.add(DragValue::new(part).prefix(letter).speed(0.5).update_while_editing(false));
            name_it(ui, &field, &format!("{label} {name}"));
        }
        hex(ui, id.with("hex"), label, srgb);
    });
}

/// The colour's hue and saturation, kept where the colour itself has forgotten them: black and greys.
fn hsv_of(ui: &Ui, id: Id, srgb: [u8; 3]) -> HsvaGamma {
    let kept: Option<HsvaGamma> = ui.data(|data| data.get_temp(id));
    kept.filter(|hsv| bytes(*hsv) == srgb).unwrap_or_else(|| HsvaGamma::from(color32(srgb)))
}

/// A rectangle of colours with a mark at `mark`, both from 0 to 1. Where it was pointed to.
fn plane(
    ui: &mut Ui,
    name: &str,
    size: Vec2,
    rows: u32,
    mark: Vec2,
    color_at: impl Fn(Vec2) -> HsvaGamma,
) -> Option<Vec2> {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    name_it(ui, &response, &format!("{name} picker"));
    let mut mesh = Mesh::default();
    let columns = PARTS * 2;
    for row in 0..=rows {
        for column in 0..=columns {
            let at = vec2(column as f32 / columns as f32, row as f32 / rows as f32);
            mesh.colored_vertex(place(rect, at), color_at(at).into());
            if row < rows && column < columns {
                let corner = row * (columns + 1) + column;
                let below = corner + columns + 1;
                mesh.add_triangle(corner, corner + 1, below);
                mesh.add_triangle(below, corner + 1, below + 1);
            }
        }
    }
    ui.painter().add(mesh);
    let middle = place(rect, mark);
    ui.painter().circle(middle, 5.0, color_at(mark), Stroke::new(2.0, Color32::WHITE));
    ui.painter().circle_stroke(middle, 6.5, Stroke::new(1.0, theme::VIEWPORT_SHADE));
    let pointed = response.interact_pointer_pos()?;
    let at = (pointed - rect.min) / rect.size();
    Some(vec2(at.x.clamp(0.0, 1.0), at.y.clamp(0.0, 1.0)))
}

fn place(rect: Rect, at: Vec2) -> Pos2 {
    pos2(egui::lerp(rect.x_range(), at.x), egui::lerp(rect.y_range(), at.y))
}

/// `#rrggbb`, taken over when the field is left; what is no colour is not.
fn hex(ui: &mut Ui, id: Id, label: &str, srgb: &mut [u8; 3]) {
    let shown = || format!("#{:02x}{:02x}{:02x}", srgb[0], srgb[1], srgb[2]);
    let mut text = ui.data(|data| data.get_temp(id)).unwrap_or_else(shown);
    let response = ui.add(
        TextEdit::singleline(&mut text)
            .desired_width(58.0)
            .align(egui::Align2::LEFT_CENTER)
            .min_size(vec2(0.0, ui.spacing().interact_size.y)),
    );
    name_it(ui, &response, &format!("{label} sRGB"));
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
        return;
    }
    ui.data_mut(|data| data.remove::<String>(id));
    if response.lost_focus()
        && !ui.input(|input| input.key_pressed(egui::Key::Escape))
        && let Some(read) = from_hex(&text)
    {
        *srgb = read;
    }
}

fn from_hex(text: &str) -> Option<[u8; 3]> {
    let digits = text.trim().trim_start_matches('#');
    if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some([r, g, b])
}

fn color32([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn bytes(hsv: HsvaGamma) -> [u8; 3] {
    let [r, g, b, _] = Color32::from(hsv).to_array();
    [r, g, b]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_colors_as_text() {
        assert_eq!(from_hex("#0a1bff"), Some([0x0a, 0x1b, 0xff]));
        assert_eq!(from_hex(" FFFFFF "), Some([255; 3]));
        for bad in ["", "#12345", "#1234567", "#gg0000", "+12345", "äää"] {
            assert_eq!(from_hex(bad), None, "{bad}");
        }
    }

    #[test]
    fn what_is_picked_is_what_is_kept() {
        for srgb in [[0, 0, 0], [255, 255, 255], [200, 30, 90], [17, 250, 3]] {
            assert_eq!(bytes(HsvaGamma::from(color32(srgb))), srgb);
        }
    }
}
