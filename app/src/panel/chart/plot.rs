//! Cost against error, both axes logarithmic; a click on a point has the viewport draw by that method.
//!
//! egui_plot has linear axes alone, so it is given places on the sheet of [`LogAxis`], the one that `chart.html` has,
//! with its rail for what is 0. Points are widgets over the plot, for the pointer and for those who can't see them.

use super::figures::{card, choose_method, family, is_chosen, shape};
use crate::chart::front;
use crate::chart::labels::{self, Rect, Wanted};
use crate::chart::log_axis::LogAxis;
use crate::chart::report::{MethodFigures, Report};
use crate::state::{Action, ChartChange, Reading};
use crate::theme;
use crate::widget::name_it;
use cloudwright_core::method::Family;
use egui::{Align2, Color32, ComboBox, FontId, Pos2, Sense, Stroke, Ui, vec2};
use egui_plot::{GridMark, HLine, Line, LineStyle, Plot, PlotBounds, PlotPoint, PlotTransform, Points};

/// Points.
const HEIGHT: f32 = 220.0;
/// What numbers and titles take of width and height, points.
const AXES: [f32; 2] = [58.0, 40.0];
/// To the right, where half of the last number stands, points.
const MARGIN: f32 = 18.0;
/// Of the strip for what is 0, points.
const RAIL: f64 = 28.0;
/// Between two numbers of the cost's axis, points.
const NUMBERS_APART: f64 = 34.0;
/// Of a point, points.
const RADIUS: f32 = 4.0;
/// Where a pointer is at a point, points.
const REACH: f32 = 14.0;

/// A method with its place on the sheet.
struct Mark<'a> {
    method: &'a MethodFigures,
    family: Family,
    at: [f64; 2],
    is_named: bool,
}

/// Places for plain and for logarithmic numbers.
struct Sheet {
    size: [f64; 2],
    cost: LogAxis,
    error: LogAxis,
}

pub(super) fn show(ui: &mut Ui, report: &Report, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let flickers = report.methods.iter().any(|method| method.stability.is_some());
    let by_flicker = flickers && reading.charting.shows_flicker;
    if flickers {
        choose_error(ui, by_flicker, actions);
    }
    let point = |method: &MethodFigures| if by_flicker { method.cost_and_excess() } else { method.cost_and_error() };
    let known: Vec<(&MethodFigures, [f64; 2])> =
        report.methods.iter().filter_map(|method| Some((method, point(method)?))).collect();
    if known.is_empty() {
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
        let font = FontId::proportional(theme::SMALL_TEXT);
        let text = "errors are measured first, then times";
        ui.painter().text(rect.center(), Align2::CENTER_CENTER, text, font, ui.visuals().weak_text_color());
        return;
    }
    let size = [ui.available_width() - AXES[0] - MARGIN, HEIGHT - AXES[1]].map(|side| f64::from(side.max(60.0)));
    let along = |i: usize| known.iter().map(|(_, point)| point[i]).collect::<Vec<_>>();
    let cost = LogAxis::new(&along(0), [0.0, size[0]], RAIL);
    let error = LogAxis::new(&along(1), [0.0, size[1]], RAIL);
    let sheet = Sheet { size, cost, error };
    let marks = known.into_iter().map(|(method, [cost, error])| {
        let family = family(method);
        let is_named = method.on_front || is_chosen(method, reading) || family != Family::Other;
        Mark { method, family, at: [sheet.cost.at(cost), sheet.error.at(error)], is_named }
    });
    let marks: Vec<Mark<'_>> = marks.collect();
    let tolerance = (!by_flicker).then_some(reading.charting.tolerance);
    let choices = marks.iter().filter(|mark| mark.method.on_front && !by_flicker).map(|mark| mark.at);
    let front = front::outline(choices.collect(), sheet.size[1], sheet.size[0]);
    let transform = draw(ui, &sheet, &marks, &front, tolerance, by_flicker);
    name_marks(ui, &marks, &front, &transform);
    for mark in &marks {
        let rect = egui::Rect::from_center_size(on_screen(&transform, mark.at), vec2(REACH, REACH));
        let response = ui.interact(rect, ui.scope_id().with(&mark.method.name), Sense::click());
        name_it(ui, &response, &format!("Point of {}", mark.method.name));
        if response.hovered() || response.has_focus() {
            ui.painter().circle_stroke(rect.center(), REACH / 2.0, Stroke::new(1.5, theme::family(ui, mark.family)));
        }
        let response = response.on_hover_ui(|ui| card(ui, mark.method));
        if response.clicked() {
            actions.push(choose_method(mark.method, reading));
        }
    }
}

fn choose_error(ui: &mut Ui, by_flicker: bool, actions: &mut Vec<Action>) {
    let name = |flicker: bool| if flicker { "flicker against cost" } else { "error against cost" };
    let combo = ComboBox::from_id_salt("error").selected_text(name(by_flicker)).show_ui(ui, |ui| {
        for flicker in [false, true] {
            if ui.selectable_label(flicker == by_flicker, name(flicker)).clicked() {
                actions.push(Action::Chart(ChartChange::ShowsFlicker(flicker)));
            }
        }
    });
    name_it(ui, &combo.response, "What the chart shows");
}

/// The sheet with its lines and marks, and where it lies on the screen.
fn draw(
    ui: &mut Ui,
    sheet: &Sheet,
    marks: &[Mark<'_>],
    front: &[[f64; 2]],
    tolerance: Option<f64>,
    by_flicker: bool,
) -> PlotTransform {
    let [costs, errors] =
        [ticks(&sheet.cost, NUMBERS_APART), ticks(&sheet.error, f64::from(ui.spacing().interact_size.y))];
    let (soft, accent) = (ui.visuals().weak_text_color(), theme::family(ui, Family::Shipped));
    let front = front.to_vec();
    let items: Vec<(Points<'_>, Option<Points<'_>>)> = marks
        .iter()
        .map(|mark| {
            let color = theme::family(ui, mark.family);
            let points = Points::new(&*mark.method.name, vec![mark.at]).shape(shape(mark.family)).color(color);
            let ring = Points::new("", vec![mark.at]).filled(false).color(color).radius(RADIUS * 1.8);
            (points.radius(RADIUS).allow_hover(false), (mark.family == Family::Shipped).then_some(ring))
        })
        .collect();
    let tolerance = tolerance.filter(|tolerance| sheet.error.shows(*tolerance)).map(|value| sheet.error.at(value));
    let (cost_labels, error_labels) = (costs.clone(), errors.clone());
    let [width, height] = sheet.size;
    let response = Plot::new("cost and error")
        .height(HEIGHT)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .allow_axis_zoom_drag(false)
        .show_crosshair(false)
        .width(sheet.size[0] as f32 + AXES[0])
        .grid_color(ui.visuals().widgets.noninteractive.bg_stroke.color)
        .grid_fade(0.0)
        .sense(Sense::hover())
        .x_axis_label("ms a picture")
        .y_axis_label(if by_flicker { "excess change" } else { "mean FLIP" })
        .x_grid_spacer(move |_| costs.iter().map(|(mark, _)| *mark).collect())
        .y_grid_spacer(move |_| errors.iter().map(|(mark, _)| *mark).collect())
        .x_axis_formatter(move |mark, _| label(&cost_labels, mark))
        .y_axis_formatter(move |mark, _| label(&error_labels, mark))
        .label_formatter(|_| None)
        .show(ui, |plot| {
            plot.set_plot_bounds(PlotBounds::from_min_max([0.0; 2], [width, height]));
            plot.line(Line::new("front", front).color(accent).width(1.5).allow_band(false).allow_hover(false));
            if let Some(y) = tolerance {
                let style = LineStyle::dashed_loose();
                plot.hline(HLine::new("good enough", y).color(soft).style(style).allow_hover(false));
            }
            for (points, ring) in items {
                plot.points(points);
                ring.into_iter().for_each(|ring| plot.points(ring.allow_hover(false)));
            }
        });
    response.transform
}

/// Lines of the grid, with their numbers.
fn ticks(axis: &LogAxis, apart: f64) -> Vec<(GridMark, String)> {
    let ticks = axis.ticks(apart).into_iter().chain(axis.rail());
    // All of one strength.
    ticks.map(|tick| (GridMark { value: tick.at_px, step_size: 100.0 }, tick.label)).collect()
}

fn label(ticks: &[(GridMark, String)], mark: GridMark) -> String {
    let found = ticks.iter().find(|(tick, _)| (tick.value - mark.value).abs() < 0.01);
    found.map(|(_, label)| label.clone()).unwrap_or_default()
}

fn on_screen(transform: &PlotTransform, at: [f64; 2]) -> Pos2 {
    transform.position_from_point(&PlotPoint::from(at))
}

/// The names of those that matter, none over another.
fn name_marks(ui: &Ui, marks: &[Mark<'_>], front: &[[f64; 2]], transform: &PlotTransform) {
    let named: Vec<&Mark<'_>> = marks.iter().filter(|mark| mark.is_named).collect();
    let painter = ui.painter_at(*transform.frame());
    let font = FontId::proportional(theme::SMALL_TEXT);
    let names = named
        .iter()
        .map(|mark| painter.layout_no_wrap(mark.method.name.clone(), font.clone(), theme::family(ui, mark.family)));
    let names: Vec<_> = names.collect();
    let place = |at: [f64; 2]| {
        let at = on_screen(transform, at);
        [f64::from(at.x), f64::from(at.y)]
    };
    let wanted: Vec<Wanted> = named
        .iter()
        .zip(&names)
        .map(|(mark, name)| Wanted {
            at: place(mark.at),
            radius: f64::from(RADIUS * 2.0),
            size: [name.size().x.into(), name.size().y.into()],
        })
        .collect();
    let frame = transform.frame();
    let bounds = Rect {
        x: frame.min.x.into(),
        y: frame.min.y.into(),
        width: frame.width().into(),
        height: frame.height().into(),
    };
    let corners: Vec<[f64; 2]> = front.iter().map(|at| place(*at)).collect();
    let lines: Vec<[[f64; 2]; 2]> = corners.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    let taken: Vec<Rect> = marks
        .iter()
        .filter(|mark| !mark.is_named)
        .map(|mark| {
            let ([x, y], side) = (place(mark.at), f64::from(RADIUS * 2.0));
            Rect { x: x - side / 2.0, y: y - side / 2.0, width: side, height: side }
        })
        .collect();
    for ((placed, name), mark) in labels::place(&wanted, bounds, &taken, &lines).iter().zip(names).zip(named) {
        let at = egui::pos2(placed.rect.x as f32, placed.rect.y as f32);
        if let Some([x, y]) = placed.leader {
            let ends = [on_screen(transform, mark.at), egui::pos2(x as f32, y as f32)];
            painter.line_segment(ends, Stroke::new(1.0, ui.visuals().weak_text_color()));
        }
        painter.galley(at, name, Color32::PLACEHOLDER);
    }
}
