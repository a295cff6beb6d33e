//! The picture in the viewport: drawn when something changed, and only then, so that an idle window does nothing.
//!
//! On a GPU it is drawn with the window's own device, into a texture that egui shows as it is. The CPU draws on a
//! worker thread ([`by_cpu`]), as it draws by every method but the device's own. A GPU that fails (its device lost, a
//! scene too large for it) gives way to the CPU.

mod by_cpu;
mod by_gpu;

use crate::renderer::RendererChoice;
use crate::state::Session;
use by_cpu::ByCpu;
use by_gpu::ByGpu;
use cloudwright_core::image::Picture;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::sight::Sight;
use cloudwright_core::version::Version;
use eframe::egui_wgpu::RenderState;
use egui::{Color32, ColorImage, TextureId};
use std::time::Duration;

/// While a hand moves something, pictures should take no longer.
const QUICK: Duration = Duration::from_millis(18);

/// Of a picture's pixels during a gesture, the longest side in the viewport's pixels.
const COARSEST: u32 = 4;

/// Larger pictures than any window need not be asked for.
const MAX_SIDE: u32 = 8192;

/// What a picture shows: another key, another picture.
#[derive(PartialEq)]
struct Key {
    revision: Version,
    sight: Sight,
}

/// Draws the viewport's pictures.
pub(super) struct PictureSource {
    context: egui::Context,
    /// The window's device, if it is to draw.
    gpu: Option<Box<ByGpu>>,
    /// Its thread begins with the first picture that it is asked for.
    cpu: Option<ByCpu>,
    /// Why the device draws no longer.
    trouble: Option<String>,
    asked: Option<Key>,
    /// Of a picture's pixels, the side in the viewport's pixels.
    coarseness: u32,
}

impl PictureSource {
    pub(super) fn new(context: &egui::Context, choice: RendererChoice, device: Option<RenderState>) -> Self {
        let gpu = match choice {
            RendererChoice::Cpu => None,
            RendererChoice::Auto => device.and_then(ByGpu::new).filter(|gpu| !gpu.is_software()),
            RendererChoice::Gpu => device.and_then(ByGpu::new),
        };
        let context = context.clone();
        Self { context, gpu: gpu.map(Box::new), cpu: None, trouble: None, asked: None, coarseness: 1 }
    }

    /// What draws unless a method is chosen.
    pub(super) fn own_rules(&self) -> Rules {
        let rasterizer = if self.gpu.is_some() { Rasterizer::Gpu } else { Rules::SHIPPED.rasterizer };
        Rules { rasterizer, ..Rules::SHIPPED }
    }

    /// The device, if the last picture is its.
    fn gpu_in_use(&self) -> Option<&ByGpu> {
        let by_gpu = self.asked.as_ref().is_none_or(|key| key.sight.rules.rasterizer == Rasterizer::Gpu);
        self.gpu.as_deref().filter(|_| by_gpu)
    }

    /// What draws.
    pub(super) fn renderer_name(&self) -> String {
        match (self.gpu_in_use(), &self.trouble) {
            (Some(gpu), _) => gpu.name().into(),
            (None, None) => "CPU".into(),
            (None, Some(trouble)) => format!("CPU ({trouble})"),
        }
    }

    /// What the last picture took: on a GPU, what it took to prepare and send off.
    pub(super) fn time(&self) -> Option<Duration> {
        match self.gpu_in_use() {
            Some(gpu) => gpu.time(),
            None => self.cpu.as_ref()?.last().map(|(time, _)| time),
        }
    }

    /// How often the last picture's pixels were blended over, in the mean, where that is known.
    pub(super) fn overdraw(&self) -> Option<f32> {
        self.cpu.as_ref().filter(|_| self.gpu_in_use().is_none())?.overdraw()
    }

    /// Has a picture drawn if it would be another than the last one. While a hand moves something, `quick` lets a slow
    /// renderer draw less.
    pub(super) fn ask(&mut self, session: &Session, mut sight: Sight, quick: bool) {
        if self.gpu.is_none() && sight.rules.rasterizer == Rasterizer::Gpu {
            sight.rules.rasterizer = Rules::SHIPPED.rasterizer;
        }
        let rasterizer = sight.rules.rasterizer;
        let by_gpu = rasterizer == Rasterizer::Gpu;
        let last = self.cpu.as_ref().and_then(ByCpu::last);
        self.coarseness = if quick && !by_gpu { coarseness(rasterizer, self.coarseness, last) } else { 1 };
        // Of a window larger than a texture, each pixel of the picture is several of the window's.
        let most = self.context.input(|input| input.max_texture_side).clamp(1, MAX_SIDE as usize) as u32;
        let [width, height] = sight.size;
        self.coarseness = self.coarseness.max(width.max(height).div_ceil(most));
        sight.size = sight.size.map(|side| side.div_ceil(self.coarseness).max(1));
        let key = Key { revision: session.revision(), sight };
        if self.asked.as_ref() == Some(&key) {
            return;
        }
        match self.gpu.as_mut().filter(|_| by_gpu) {
            Some(gpu) => {
                self.cpu = None;
                if let Err(error) = gpu.draw(session, &key.sight) {
                    self.trouble = Some(error.to_string());
                    self.gpu = None;
                    self.context.request_repaint();
                    return;
                }
            }
            None => {
                let cpu = self.cpu.get_or_insert_with(|| ByCpu::new(&self.context));
                cpu.ask(session, &key.sight, self.coarseness);
                cpu.wait();
            }
        }
        self.asked = Some(key);
    }

    /// The newest picture.
    pub(super) fn texture(&mut self) -> Option<TextureId> {
        let by_cpu = self.cpu.as_mut().and_then(ByCpu::texture);
        // The device's last one stands in until the CPU has one.
        by_cpu.or_else(|| self.gpu.as_ref().and_then(|gpu| gpu.texture()))
    }
}

/// For egui.
pub(crate) fn image(picture: &Picture) -> ColorImage {
    let size = [picture.width as usize, picture.height as usize];
    ColorImage::new(size, picture.pixels.iter().map(|&[r, g, b, _]| Color32::from_rgb(r, g, b)).collect())
}

/// How coarse the next picture of a gesture is to be, from `last`, the time of one and how coarse that was. It gets no
/// finer than the gesture's pictures so far, lest it flicker between the two.
fn coarseness(rasterizer: Rasterizer, so_far: u32, last: Option<(Duration, u32)>) -> u32 {
    // It is never quick, and its last picture may have been another rasterizer's.
    if rasterizer == Rasterizer::Truth {
        return COARSEST;
    }
    let Some((time, drawn_at)) = last else { return so_far };
    let is_quick = |side: u32| time.mul_f32((drawn_at as f32 / side as f32).powi(2)) <= QUICK;
    [1, 2, 3].into_iter().find(|&side| side >= so_far && is_quick(side)).unwrap_or(COARSEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_of_a_gesture_get_coarser_until_they_are_quick() {
        let fast = Rules::SHIPPED.rasterizer;
        let after = |so_far, ms, drawn_at| coarseness(fast, so_far, Some((Duration::from_millis(ms), drawn_at)));
        assert_eq!([after(1, 15, 1), after(1, 60, 1), after(1, 150, 1), after(1, 9000, 1)], [1, 2, 3, 4]);
        assert_eq!([after(2, 15, 2), after(2, 30, 2), after(4, 5, 4), after(4, 500, 4)], [2, 3, 4, 4]);
        assert_eq!(coarseness(fast, 1, None), 1);
        assert_eq!(coarseness(Rasterizer::Truth, 1, Some((Duration::from_millis(5), 1))), COARSEST);
    }
}
