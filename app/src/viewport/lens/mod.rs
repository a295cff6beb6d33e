//! What is seen instead of the picture, or beside it: the truth to the right of a handle, and maps of what the picture
//! costs or gets wrong.
//!
//! A thread of its own draws it ([`slide`]) when the view rests: coarse at first, then finer. What the view has left is
//! neither shown nor worked on.

mod legend;
mod slide;
mod wipe;

use super::picture::image;
use crate::state::{Lens, Session};
use crate::worker::Latest;
use cloudwright_core::sight::Sight;
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use egui::{Color32, Context, Painter, Rect, TextureHandle, TextureOptions, Ui, pos2};
pub(super) use legend::height as legend_height;
use slide::{Request, Scale, Slide};
use std::sync::Arc;
use std::time::Duration;

/// Between two looks at how far a slide has come.
const LOOK: Duration = Duration::from_millis(200);

/// Draws the slides, and shows them.
pub(super) struct LensSource {
    context: Context,
    /// Begins with the first slide that is asked for; none before, and if the system gives no thread.
    worker: Option<Latest<Request, Option<Slide>>>,
    wanted: Option<Wanted>,
    shown: Option<Shown>,
    /// The handle's place, 0 to 1 from left to right.
    wipe: f64,
}

/// What is being drawn or was.
struct Wanted {
    key: Key,
    /// Tells the slides of this view from others.
    number: Version,
    watch: Arc<Watch>,
    /// Of the slide in hand; none if there is no finer one to come.
    coarseness: Option<u32>,
}

/// Another key, another slide.
#[derive(PartialEq)]
struct Key {
    lens: Lens,
    revision: Version,
    sight: Sight,
    truth: Sight,
}

struct Shown {
    number: Version,
    texture: TextureHandle,
    scale: Option<Scale>,
}

impl LensSource {
    pub(super) fn new(context: &Context) -> Self {
        Self { context: context.clone(), worker: None, wanted: None, shown: None, wipe: 0.5 }
    }

    /// Nothing is wanted any more.
    pub(super) fn put_away(&mut self) {
        self.drop_work();
        self.shown = None;
    }

    /// While a hand moves the view, nothing is drawn.
    pub(super) fn wait(&mut self) {
        self.drop_work();
    }

    /// Has what `lens` shows of `sight` drawn, unless that is done; `truth` is the same view as the truth draws it.
    pub(super) fn ask(&mut self, lens: Lens, session: &Session, sight: Sight, truth: Sight) {
        let key = Key { lens, revision: session.revision(), sight, truth };
        if self.wanted.as_ref().is_none_or(|wanted| wanted.key != key) {
            self.drop_work();
            let coarseness = slide::coarsenesses(lens).first().copied();
            self.wanted = Some(Wanted { key, number: Version::fresh(), watch: Arc::default(), coarseness });
            self.send(session);
        }
        let Some(Some(slide)) = self.worker.as_ref().and_then(Latest::newest) else { return };
        let Some(wanted) = self.wanted.as_mut().filter(|wanted| wanted.number == slide.number) else { return };
        wanted.coarseness = slide::coarsenesses(lens).iter().copied().find(|finer| *finer < slide.coarseness);
        self.take(slide);
        self.send(session);
    }

    /// How far the slide in hand is, 0 to 1.
    fn progress(&self) -> Option<f32> {
        self.wanted.as_ref().filter(|wanted| wanted.coarseness.is_some()).map(|wanted| wanted.watch.share())
    }

    fn drop_work(&mut self) {
        if let Some(wanted) = self.wanted.take() {
            wanted.watch.cancel();
        }
    }

    fn send(&mut self, session: &Session) {
        let Some(Wanted { key, number, watch, coarseness: Some(coarseness) }) = &mut self.wanted else { return };
        *watch = Arc::default();
        let (scene, derived, beside) = session.to_draw();
        let Key { lens, sight, truth, .. } = key;
        let (sight, truth, watch) = (sight.clone(), truth.clone(), Arc::clone(watch));
        let (lens, number, coarseness) = (*lens, *number, *coarseness);
        if self.worker.is_none() {
            let wake = self.context.clone();
            let work = |request: Request| slide::draw(&request);
            self.worker = Latest::start_beside_the_window("lens", work, move || wake.request_repaint()).ok();
        }
        match &self.worker {
            Some(worker) => {
                worker.ask(Request { lens, scene, derived, beside, sight, truth, number, coarseness, watch });
            }
            // Nothing will come.
            None => self.drop_work(),
        }
    }

    fn take(&mut self, slide: Slide) {
        let Slide { number, picture, scale, .. } = slide;
        let image = image(&picture);
        let texture = match self.shown.take() {
            Some(mut shown) => {
                shown.texture.set(image, TextureOptions::LINEAR);
                shown.texture
            }
            None => self.context.load_texture("lens", image, TextureOptions::LINEAR),
        };
        self.shown = Some(Shown { number, texture, scale });
    }

    /// The slide of what is wanted, if there is one yet.
    fn slide(&self) -> Option<&Shown> {
        let wanted = self.wanted.as_ref()?;
        self.shown.as_ref().filter(|shown| shown.number == wanted.number)
    }

    /// Shows it over the picture in `rect`, which is drawn by the method of that `name`.
    pub(super) fn show(&mut self, ui: &mut Ui, painter: &Painter, rect: Rect, lens: Lens, name: &str) {
        if self.progress().is_some() {
            ui.ctx().request_repaint_after(LOOK);
        }
        if lens == Lens::Wipe {
            return self.show_wipe(ui, painter, rect, name);
        }
        if let Some(shown) = self.slide() {
            paint(painter, shown, rect, rect);
        }
        let scale = self.slide().and_then(|shown| shown.scale.as_ref());
        legend::show(ui, rect, lens, scale, self.progress());
    }
}

impl Drop for LensSource {
    fn drop(&mut self) {
        self.drop_work();
    }
}

fn paint(painter: &Painter, shown: &Shown, rect: Rect, part: Rect) {
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.with_clip_rect(part.intersect(painter.clip_rect())).image(shown.texture.id(), rect, whole, Color32::WHITE);
}
