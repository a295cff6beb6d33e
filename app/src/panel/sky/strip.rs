//! A table over the day as a strip of 24 hours: its colours as a band, its keys as handles below.
//!
//! Midnight is at both ends, and the band runs on across it. A double click adds a key; Delete takes the one out that
//! has the focus. While a key is dragged past another one their order changes; the hand keeps the one that it took.

use super::keys;
use super::sun_path::SunPath;
use crate::theme::{self, icon};
use crate::units::typed_hour;
use crate::widget::{
    Handle, Handled, brightness_field, checkerboard, color_field, color32, name_it, number_field, refusal,
};
use cloudwright_core::color::Rgba;
use cloudwright_core::math::clock;
use cloudwright_core::property::{ALPHA, Number, TIME_OF_DAY_H};
use cloudwright_core::scene::{DailyKey, DailyTable};
use egui::{
    Align, Align2, Button, Color32, CursorIcon, DragValue, FontId, Id, Key, Layout, Mesh, Modifiers, Pos2, Rect,
    Response, Sense, Shape, Stroke, Ui, pos2, vec2,
};
use std::cell::Cell;

/// Points.
const BAND_HEIGHT: f32 = 24.0;
/// Of a key's handle, points.
const TAG: egui::Vec2 = vec2(10.0, 16.0);
/// Of the row of hours, points.
const AXIS_HEIGHT: f32 = 15.0;
/// Of a handle's tip, points.
const TIP: f32 = 5.0;
/// Of an arrow key, hours.
const STEP_H: f64 = 0.1;
const KEY_HOUR: Number = Number { doc: "When this colour holds.", ..TIME_OF_DAY_H };

/// What a strip shows.
pub(super) struct Strip<'a> {
    /// "Ambient".
    pub(super) name: &'static str,
    /// One sentence for the artist.
    pub(super) doc: &'static str,
    /// Whether alpha means something.
    pub(super) has_alpha: bool,
    /// The table; without alpha, all of it is 1.
    pub(super) table: &'a DailyTable<Rgba>,
    /// The hour that is shown.
    pub(super) hour: f64,
    /// Sunrise and sunset.
    pub(super) path: &'a SunPath,
}

impl Strip<'_> {
    /// The table as it was changed, and whether the button is still down.
    pub(super) fn show(&self, ui: &mut Ui) -> Option<(DailyTable<Rgba>, bool)> {
        let chosen_id = ui.scope_id().with((self.name, "chosen key"));
        let chosen = ui.data(|data| data.get_temp(chosen_id)).unwrap_or_else(|| self.nearest(self.hour));
        let chosen = chosen.min(self.table.keys.len().saturating_sub(1));
        let mut live = false;
        let by_buttons = self.head(ui, chosen);
        let by_band = self.band(ui, chosen, chosen_id, &mut live);
        let by_fields = self.fields(ui, chosen, &mut live);
        let (mut table, held) = by_buttons.or(by_band).or(by_fields)?;
        self.follow_hours(&mut table);
        ui.data_mut(|data| data.insert_temp(chosen_id, held));
        (table != *self.table).then_some((table, live))
    }

    /// Keys by the sun that were moved to other hours go by where it stands then.
    fn follow_hours(&self, table: &mut DailyTable<Rgba>) {
        for key in &mut table.keys {
            let stays = self.table.keys.iter().any(|before| before.hour == key.hour && before.sun_deg == key.sun_deg);
            if !stays && key.sun_deg.is_some() {
                key.sun_deg = Some(self.rounded_elevation_deg(key.hour));
            }
        }
    }

    /// To a tenth.
    fn rounded_elevation_deg(&self, hour: f64) -> f64 {
        (self.path.elevation_deg(hour) * 10.0).round() / 10.0
    }

    /// The key that was passed last.
    fn nearest(&self, hour: f64) -> usize {
        let passed = self.table.keys.iter().rposition(|key| key.hour <= hour);
        passed.unwrap_or_else(|| self.table.keys.len().saturating_sub(1))
    }

    fn head(&self, ui: &mut Ui, chosen: usize) -> Option<keys::Held> {
        ui.horizontal(|ui| {
            ui.label(self.name).on_hover_text(self.doc);
            let right = |ui: &mut Ui| {
                let button = |ui: &mut Ui, icon: &str, what: &str, enabled: bool| {
                    let response = ui.add_enabled(enabled, Button::new(icon).small());
                    name_it(ui, &response, &format!("{what} {} key", self.name.to_lowercase()));
                    response.on_hover_text(format!("{what} a key {}", self.where_text(what))).clicked()
                };
                let remove = button(ui, icon::TRASH, "Remove", self.table.keys.len() > 1);
                let add = button(ui, icon::PLUS, "Add", true);
                let removed = || keys::removed(self.table, chosen);
                if add { keys::added(self.table, self.hour) } else { remove.then(removed).flatten() }
            };
            ui.with_layout(Layout::right_to_left(Align::Center), right).inner
        })
        .inner
    }

    fn where_text(&self, what: &str) -> String {
        if what == "Add" { format!("at {}", clock(self.hour)) } else { "(Delete)".into() }
    }

    fn band(&self, ui: &mut Ui, chosen: usize, chosen_id: Id, live: &mut bool) -> Option<keys::Held> {
        let size = vec2(ui.available_width(), BAND_HEIGHT + TAG.y + AXIS_HEIGHT);
        let (whole, _) = ui.allocate_exact_size(size, Sense::hover());
        let band = Rect::from_min_size(whole.min, vec2(whole.width(), BAND_HEIGHT)).shrink2(vec2(TAG.x * 0.5, 0.0));
        self.paint_band(ui, band);
        self.paint_axis(ui, band);
        let response = ui.interact(band, ui.scope_id().with((self.name, "band")), Sense::click());
        name_it(ui, &response, &format!("{} over the day", self.name));
        let hour_at = |at: Pos2| 24.0 * f64::from((at.x - band.left()) / band.width());
        let pointed = response.interact_pointer_pos().filter(|_| response.double_clicked());
        let mut held = pointed.and_then(|at| keys::added(self.table, hour_at(at)));
        response.on_hover_text_at_pointer("Double-click to add a key.");

        let tags: Vec<(usize, Handled)> = (0..self.table.keys.len()).map(|i| (i, self.handle(ui, band, i))).collect();
        for (index, handled) in &tags {
            let tag = &handled.response;
            if tag.clicked() || tag.drag_started() || tag.gained_focus() {
                ui.data_mut(|data| data.insert_temp(chosen_id, *index));
            }
            if let Some(hour) = handled.wanted {
                // A drag may have changed the order: then the chosen key is the one in hand.
                let at = if tag.dragged() && !tag.drag_started() { chosen } else { *index };
                held = keys::moved(self.table, at, hour);
                *live = handled.live;
                if let (Some((_, now)), false) = (&held, tag.dragged()) {
                    ui.memory_mut(|memory| memory.request_focus(self.handle_id(ui, *now)));
                }
            }
            if tag.has_focus() && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Delete)) {
                held = keys::removed(self.table, *index);
            }
        }
        let (last, others): (Vec<_>, Vec<_>) = tags.into_iter().partition(|(index, _)| *index == chosen);
        for (index, handled) in others.into_iter().chain(last) {
            self.paint_tag(ui, band, &self.table.keys[index], index == chosen, handled.response);
        }
        held
    }

    fn handle_id(&self, ui: &Ui, index: usize) -> Id {
        ui.scope_id().with((self.name, "key", index))
    }

    fn handle(&self, ui: &Ui, band: Rect, index: usize) -> Handled {
        let key = &self.table.keys[index];
        let handled = Handle {
            id: self.handle_id(ui, index),
            rect: Rect::from_min_size(pos2(at_hour(band, key.hour) - TAG.x * 0.5, band.bottom()), TAG),
            name: &format!("{} key {}", self.name, index + 1),
            number: &KEY_HOUR,
            value: key.hour,
            step: STEP_H,
        }
        .show(ui, |start, way| start + 24.0 * f64::from(way.x / band.width()));
        crate::command::delete_belongs_to(ui.ctx(), &handled.response);
        handled
    }

    /// Hour, colour and opacity of the chosen key.
    fn fields(&self, ui: &mut Ui, chosen: usize, live: &mut bool) -> Option<keys::Held> {
        let mut key = *self.table.keys.get(chosen)?;
        let before = key;
        let name = |what: &str| format!("{} key {what}", self.name);
        ui.horizontal(|ui| {
            hour_field(ui, &name("hour"), &mut key.hour);
            self.by_sun(ui, &name("by the sun"), &mut key);
            color_field(ui, &name("colour"), &mut key.value.rgb);
            ui.weak("×");
            brightness_field(ui, &name("brightness"), &mut key.value.rgb);
        });
        if self.has_alpha {
            ui.horizontal(|ui| {
                ui.weak("opacity");
                let mut opacity = f64::from(key.value.a);
                if number_field(ui, &name("opacity"), &ALPHA, &mut opacity, false) {
                    key.value.a = opacity as f32;
                }
            });
        }
        if key == before {
            return None;
        }
        *live = ui.input(|input| input.pointer.any_down());
        let mut table = self.table.clone();
        (table.keys[chosen].value, table.keys[chosen].sun_deg) = (key.value, key.sun_deg);
        if key.hour == before.hour { Some((table, chosen)) } else { keys::moved(&table, chosen, key.hour) }
    }

    /// Whether the key goes by the sun's elevation.
    fn by_sun(&self, ui: &mut Ui, name: &str, key: &mut DailyKey<Rgba>) {
        let mut goes = key.sun_deg.is_some();
        let response = ui.toggle_value(&mut goes, icon::SUN);
        name_it(ui, &response, name);
        if response.changed() {
            key.sun_deg = goes.then(|| self.rounded_elevation_deg(key.hour));
        }
        response.on_hover_text(match key.sun_deg {
            Some(degrees) => format!("Holds where the sun stands at {degrees:.1}°, at whatever hour that is on another day or at another place."),
            None => "Has the key go by the sun's elevation in place of the hour, so that it holds on other days and at other places too.".into(),
        });
    }

    fn paint_band(&self, ui: &Ui, band: Rect) {
        let painter = ui.painter();
        if self.has_alpha {
            checkerboard::paint(painter, band);
        }
        let mut mesh = Mesh::default();
        let columns = band.width().round().max(1.0) as u32;
        let width = band.width() / columns as f32;
        for column in 0..columns {
            let left = band.left() + column as f32 * width;
            let hour = 24.0 * (f64::from(column) + 0.5) / f64::from(columns);
            let color = color32(self.table.at(hour, Rgba::mix));
            mesh.add_colored_rect(Rect::from_x_y_ranges(left..=left + width, band.y_range()), color);
        }
        painter.add(mesh);
        painter.rect_stroke(band, 0.0, ui.visuals().widgets.noninteractive.bg_stroke, egui::StrokeKind::Outside);
        for hour in [self.path.sunrise_h, self.path.sunset_h].into_iter().flatten() {
            let x = at_hour(band, hour);
            let stroke = Stroke::new(1.0, theme::SUN);
            painter.vline(x, band.top()..=band.top() + 6.0, stroke);
            painter.vline(x, band.bottom() - 6.0..=band.bottom(), stroke);
        }
        let now = at_hour(band, self.hour);
        painter.vline(now, band.y_range(), Stroke::new(1.5, theme::NOW));
        let head = [(-4.0, -3.0), (4.0, -3.0), (0.0, 3.0)].map(|(x, y)| pos2(now + x, band.top() + y));
        painter.add(Shape::convex_polygon(head.to_vec(), theme::NOW, Stroke::NONE));
    }

    /// Hours below the handles, with the sun's rise and set in the place of those that they would hide.
    fn paint_axis(&self, ui: &Ui, band: Rect) {
        let middle = band.bottom() + TAG.y + AXIS_HEIGHT * 0.5;
        let put = |hour: f64, text: &str, size: f32, color: Color32| {
            let at = pos2(at_hour(band, hour), middle);
            ui.painter().text(at, Align2::CENTER_CENTER, text, FontId::proportional(size), color);
        };
        let suns: Vec<f64> = [self.path.sunrise_h, self.path.sunset_h].into_iter().flatten().collect();
        for hour in (0..=24_u8).step_by(3) {
            let hidden = suns.iter().any(|sun| (sun - f64::from(hour)).abs() < 1.2);
            if !hidden {
                put(hour.into(), &hour.to_string(), 10.0, ui.visuals().weak_text_color());
            }
        }
        for sun in suns {
            put(sun, icon::SUN, 12.0, theme::sun_mark(ui));
        }
    }

    fn paint_tag(&self, ui: &Ui, band: Rect, key: &DailyKey<Rgba>, chosen: bool, tag: Response) {
        let tip = pos2(at_hour(band, key.hour), band.bottom());
        let half = TAG.x * 0.5;
        let edge = if chosen {
            Stroke::new(2.0, theme::CHOSEN)
        } else if tag.hovered() {
            ui.visuals().widgets.hovered.fg_stroke
        } else {
            Stroke::new(1.0, theme::tag_edge(ui))
        };
        let points = [(0.0, 0.0), (half, TIP), (half, TAG.y), (-half, TAG.y), (-half, TIP)];
        let points = points.map(|(x, y)| tip + vec2(x, y)).to_vec();
        ui.painter().add(Shape::convex_polygon(points, color32(Rgba { a: 1.0, ..key.value }), edge));
        if tag.has_focus() {
            let ring = Rect::from_min_size(tip - vec2(half, 0.0), TAG).expand(2.5);
            ui.painter().rect_stroke(ring, 3.0, ui.visuals().selection.stroke, egui::StrokeKind::Outside);
        }
        tag.on_hover_cursor(CursorIcon::ResizeHorizontal).on_hover_text(clock(key.hour));
    }
}

fn at_hour(band: Rect, hour: f64) -> f32 {
    egui::lerp(band.left()..=band.right(), (hour / 24.0).clamp(0.0, 1.0) as f32)
}

/// As a clock shows it.
fn hour_field(ui: &mut Ui, name: &str, hour: &mut f64) {
    let before = *hour;
    let refused = Cell::new(None);
    let field = DragValue::new(hour)
        .range(KEY_HOUR.min..=KEY_HOUR.max)
        .speed(1.0 / 60.0)
        .update_while_editing(false)
        .custom_formatter(|hour, _| clock(hour))
        .custom_parser(|text| typed_hour(text).map_err(|why| refused.set(Some(why))).ok());
    let response = ui.add_sized([48.0, ui.spacing().interact_size.y], field);
    name_it(ui, &response, name);
    let changed = response.changed();
    refusal::tell_and_show(ui, &response, refused.take(), changed);
    response.on_hover_text(KEY_HOUR.doc);
    if !changed || !KEY_HOUR.allows(*hour) {
        *hour = before;
    }
}
