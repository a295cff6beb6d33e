//! A small picture of what the chosen camera sees, in the viewport's lower right corner: all of the scene as it would be
//! rendered, whatever the view hides. A click looks through the camera.
//!
//! A thread of its own draws it, when something has changed and no more often than twice a second: a drag or a flight
//! waits for nothing.

use super::overlay;
use super::picture::image;
use crate::opening::Beside;
use crate::state::{Action, Item, Reading};
use crate::theme;
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraId, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use egui::{
    Align2, Color32, Context, CursorIcon, Rect, Sense, StrokeKind, TextureHandle, TextureOptions, Ui, Vec2, pos2, vec2,
};
use std::sync::Arc;

/// Between two pictures, seconds.
const RATE_S: f64 = 0.5;
/// Of the viewport's width and height, at most.
const SHARE: f32 = 0.28;
/// Of a picture's longer side, points: no smaller one is shown, and no larger.
const SIDE: [f32; 2] = [90.0, 360.0];
/// In a viewport less wide it stands above the line of hints, points.
const WIDE: f32 = 760.0;
/// Of that line, points.
const HINTS: f32 = 26.0;
/// Samples along a pixel's side.
const SAMPLES_SIDE: u32 = 2;

/// Draws the pictures.
pub(super) struct Inset {
    context: Context,
    /// Begins with the first picture; none before, and if the system gives no thread.
    worker: Option<Latest<Request, Option<(CameraId, Picture)>>>,
    /// What was asked for last, and when.
    asked: Option<(Version, Sight, f64)>,
    shown: Option<(CameraId, TextureHandle)>,
}

struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    sight: Sight,
}

impl Inset {
    pub(super) fn new(context: &Context) -> Self {
        Self { context: context.clone(), worker: None, asked: None, shown: None }
    }

    /// Shows what the chosen camera sees, unless that is what the view looks `through`. `raised` keeps it off what stands
    /// in the corner.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        raised: f32,
        through: Option<CameraId>,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        let camera = chosen(reading).filter(|camera| reading.view.camera_picture && Some(camera.id) != through);
        let Some((camera, place)) =
            camera.and_then(|camera| Some((camera, place(rect, raised, reading.picture_size)?)))
        else {
            (self.asked, self.shown) = (None, None);
            return;
        };
        self.ask(ui, &camera, place.size(), reading);
        self.take(camera.id);
        let response = ui.interact(place, ui.scope_id().with("camera picture"), Sense::click());
        let name = overlay::camera_name(&camera);
        let label = format!("What {name} sees");
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &label));
        let painter = ui.painter_at(rect);
        match &self.shown {
            Some((_, texture)) => {
                let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                painter.image(texture.id(), place, whole, Color32::WHITE);
            }
            None => {
                painter.rect_filled(place, 0.0, theme::HUD_SHADE);
            }
        }
        let lit = response.hovered() || response.has_focus();
        let stroke = if lit { theme::SELECTED_BOX } else { theme::CAMERA };
        painter.rect_stroke(place, 0.0, theme::casing(stroke), StrokeKind::Outside);
        painter.rect_stroke(place, 0.0, stroke, StrokeKind::Outside);
        overlay::plate(ui, place.left_top() + vec2(8.0, 6.0), Align2::LEFT_TOP, &name);
        if response.on_hover_cursor(CursorIcon::PointingHand).on_hover_text(format!("Look through {name}.")).clicked() {
            actions.push(Action::LookThrough(camera.id));
        }
    }

    /// Has a picture drawn if it would be another one, at its time.
    fn ask(&mut self, ui: &Ui, camera: &Camera, size: Vec2, reading: &Reading<'_>) {
        let session = reading.session;
        let pixels = (size * ui.pixels_per_point()).round().max(Vec2::ONE);
        let sight = Sight {
            moment: Moment { clock_s: reading.clock.time_s(), time_h: reading.time_play.time_h() },
            meshes: session.beside().meshes().clone(),
            rules: Rules { samples_side: SAMPLES_SIDE, ..Rules::SHIPPED },
            ..Sight::still(camera, [pixels.x as u32, pixels.y as u32])
        };
        let now_s = ui.input(|input| input.time);
        if let Some((revision, asked, at_s)) = &self.asked {
            if *revision == session.revision() && *asked == sight {
                return;
            }
            let wait_s = at_s + RATE_S - now_s;
            if wait_s > 0.0 {
                return self.context.request_repaint_after(std::time::Duration::from_secs_f64(wait_s));
            }
        }
        if self.worker.is_none() {
            let wake = self.context.clone();
            let work = |request: Request| draw(&request);
            self.worker = Latest::start_beside_the_window("inset", work, move || wake.request_repaint()).ok();
        }
        if let Some(worker) = &self.worker {
            let (scene, derived, beside) = session.to_draw();
            worker.ask(Request { scene, derived, beside, sight: sight.clone() });
        }
        self.asked = Some((session.revision(), sight, now_s));
    }

    /// Takes up what was drawn of the camera of that id.
    fn take(&mut self, id: CameraId) {
        self.shown = self.shown.take().filter(|(of, _)| *of == id);
        let drawn = self.worker.as_ref().and_then(Latest::newest).flatten();
        let Some((_, picture)) = drawn.filter(|(of, _)| *of == id) else { return };
        let image = image(&picture);
        match &mut self.shown {
            Some((_, texture)) => texture.set(image, TextureOptions::LINEAR),
            None => self.shown = Some((id, self.context.load_texture("camera picture", image, TextureOptions::LINEAR))),
        }
    }
}

fn draw(request: &Request) -> Option<(CameraId, Picture)> {
    let Request { scene, derived, beside, sight } = request;
    let frame = Frame::new(scene, derived, beside.sheet(), sight);
    Some((sight.camera.id, draw::picture(&frame, &Watch::default())?))
}

/// The camera that was chosen last, where its tracks have it.
fn chosen(reading: &Reading<'_>) -> Option<Camera> {
    let Some(Item::Camera(id)) = reading.view.selection.primary() else { return None };
    let camera = reading.session.scene().cameras.with_id(id)?;
    Some(reading.session.derived().timeline().camera_at(camera, reading.clock.time_s()))
}

/// Where a picture of the shape of `size` stands; none where there is no room.
fn place(rect: Rect, raised: f32, size: [u32; 2]) -> Option<Rect> {
    let [width, height] = size.map(|side| side.max(1) as f32);
    let room = rect.size() * SHARE;
    let longest = width.max(height);
    let scale = (room.x.max(SIDE[0]) / width).min(room.y.max(SIDE[0]) / height).min(SIDE[1] / longest);
    let size = vec2(width, height) * scale;
    let raised = if rect.width() < WIDE { raised + HINTS } else { raised };
    let corner = rect.right_bottom() - Vec2::splat(theme::VIEWPORT_MARGIN) - vec2(0.0, raised);
    let has_room = rect.width() > 3.0 * SIDE[0] && rect.height() > 3.0 * SIDE[0] && size.min_elem() >= 8.0;
    has_room.then(|| Rect::from_min_max(corner - size, corner))
}
