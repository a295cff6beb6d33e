//! Pictures from a worker thread, at the resolution asked for; the latest request wins.

use super::image;
use crate::opening::Beside;
use crate::state::Session;
use crate::worker::{self, Latest};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::overdraw;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use egui::{TextureHandle, TextureId, TextureOptions};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// A picture that is expected to take no longer is waited for in the frame, and for how long at most: it may take longer
/// than expected, and shown in the next frame it would come later still.
const SOON: Duration = Duration::from_millis(25);
const MOST_WAIT: Duration = Duration::from_millis(50);

/// A frame to draw, with all it needs.
struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    sight: Sight,
    coarseness: u32,
    watch: Arc<Watch>,
    /// Counts what was asked for.
    number: u64,
}

struct Answer {
    /// None if it is not whole.
    picture: Option<Picture>,
    time: Duration,
    coarseness: u32,
    /// Sprites blended on a pixel, in the mean; none while a gesture goes on.
    overdraw: Option<f32>,
    /// The request's.
    number: u64,
}

pub(super) struct ByCpu {
    context: egui::Context,
    /// None if the system gives no thread: then there is no picture, but still an editor that can save.
    worker: Option<Latest<Request, Answer>>,
    /// Of the newest request.
    watch: Arc<Watch>,
    asked_coarseness: u32,
    asked_number: u64,
    /// Whether the frame waits for the picture, so that none needs to be woken for it.
    is_awaited: Arc<AtomicBool>,
    texture: Option<TextureHandle>,
    last: Option<(Duration, u32)>,
    overdraw: Option<f32>,
}

impl ByCpu {
    pub(super) fn new(context: &egui::Context) -> Self {
        let wake = context.clone();
        let pool = worker::pool_beside_the_window("pictures");
        let work = move |request: Request| match &pool {
            // What takes long leaves the window its core.
            Some(pool) if request.sight.rules.rasterizer != Rules::SHIPPED.rasterizer => {
                pool.install(|| draw(&request))
            }
            _ => draw(&request),
        };
        let is_awaited = Arc::new(AtomicBool::new(false));
        let awaited = Arc::clone(&is_awaited);
        let wake = move || {
            if !awaited.load(Ordering::SeqCst) {
                wake.request_repaint();
            }
        };
        let worker = Latest::start("pictures", work, wake).ok();
        Self {
            context: context.clone(),
            worker,
            watch: Arc::default(),
            asked_coarseness: 1,
            asked_number: 0,
            is_awaited,
            texture: None,
            last: None,
            overdraw: None,
        }
    }

    /// What the last picture took, and how coarse it was.
    pub(super) fn last(&self) -> Option<(Duration, u32)> {
        self.last
    }

    pub(super) fn overdraw(&self) -> Option<f32> {
        self.overdraw
    }

    pub(super) fn ask(&mut self, session: &Session, sight: &Sight, coarseness: u32) {
        let Some(worker) = &self.worker else { return };
        // What is overtaken is shown all the same, so that a drag shows something; but the whole truth takes too long.
        if self.asked_coarseness == 1 {
            self.watch.cancel();
        }
        (self.watch, self.asked_coarseness) = (Arc::default(), coarseness);
        self.asked_number += 1;
        let (scene, derived, beside) = session.to_draw();
        let (sight, watch) = (sight.clone(), Arc::clone(&self.watch));
        worker.ask(Request { scene, derived, beside, sight, coarseness, watch, number: self.asked_number });
    }

    /// Waits a little for the picture that was asked for, if it is one of a gesture and will be there soon: the hand then sees
    /// it in this frame and not in the one after the next, and the window is not painted meanwhile by the cores that draw it.
    pub(super) fn wait(&mut self) {
        // In so many pixels, by what the last picture took.
        let share = |coarseness: u32| (coarseness as f32 / self.asked_coarseness as f32).powi(2);
        let is_soon = self.last.is_some_and(|(time, coarseness)| time.mul_f32(share(coarseness)) < SOON);
        if self.asked_coarseness == 1 || !is_soon {
            return;
        }
        let Some(worker) = &self.worker else { return };
        self.is_awaited.store(true, Ordering::SeqCst);
        let mut answer = worker.newest_within(MOST_WAIT, |answer| answer.number == self.asked_number);
        self.is_awaited.store(false, Ordering::SeqCst);
        // One that came as the wait ended has woken nobody.
        answer = worker.newest().or(answer);
        self.take(answer);
    }

    pub(super) fn texture(&mut self) -> Option<TextureId> {
        let answer = self.worker.as_ref().and_then(Latest::newest);
        self.take(answer);
        self.texture.as_ref().map(TextureHandle::id)
    }

    fn take(&mut self, answer: Option<Answer>) {
        if let Some(Answer { picture: Some(picture), time, coarseness, overdraw, .. }) = answer {
            self.show(&picture);
            self.last = Some((time, coarseness));
            self.overdraw = overdraw.or(self.overdraw);
        }
    }

    fn show(&mut self, picture: &Picture) {
        let image = image(picture);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(self.context.load_texture("picture", image, TextureOptions::LINEAR)),
        }
    }
}

fn draw(request: &Request) -> Answer {
    let begun = Instant::now();
    let Request { scene, derived, beside, sight, coarseness, watch, number } = request;
    let number = *number;
    let frame = Frame::new(scene, derived, beside.sheet(), sight);
    let is_whole = || sight.rules.rasterizer != Rasterizer::Truth || !watch.is_cancelled();
    let picture = draw::picture(&frame, watch).filter(|_| is_whole());
    let time = begun.elapsed();
    if picture.is_none() {
        return Answer { picture, time, coarseness: *coarseness, overdraw: None, number };
    }
    // Counted at rest only: it is nothing that a gesture should wait for.
    let overdraw = (*coarseness == 1).then(|| overdraw(&frame).mean_per_pixel as f32);
    Answer { picture, time, coarseness: *coarseness, overdraw, number }
}

impl Drop for ByCpu {
    fn drop(&mut self) {
        self.watch.cancel();
    }
}
