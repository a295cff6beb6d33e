//! One picture: a scene as a camera sees it at a moment.

use super::{NoPicture, Painter, Said, draw};
use crate::opening::Beside;
use crate::picture_kind::PictureKind;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;

/// How long a still's picture is taken to last: motion is what happens within it.
const STILL_S: f64 = 1.0 / 24.0;

/// From where a picture is taken.
#[derive(Debug, Clone, Copy)]
pub(crate) enum StillEye<'a> {
    /// A camera of the scene, which its tracks may move.
    Saved(&'a Camera),
    /// Right there.
    Free(&'a Camera),
}

impl StillEye<'_> {
    fn camera(&self) -> &Camera {
        match self {
            Self::Saved(camera) | Self::Free(camera) => camera,
        }
    }

    fn at(&self, derived: &Derived, clock_s: f64) -> Camera {
        match self {
            Self::Saved(camera) => derived.timeline().camera_at(camera, clock_s),
            Self::Free(camera) => Camera::clone(camera),
        }
    }
}

/// What is drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Still<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) derived: &'a Derived,
    pub(crate) beside: &'a Beside,
    pub(crate) eye: StillEye<'a>,
    pub(crate) moment: Moment,
    /// Width and height in pixels.
    pub(crate) size: [u32; 2],
    /// What is left out.
    pub(crate) hidden: &'a Hidden,
}

impl Still<'_> {
    fn sight(&self, painter: &Painter<'_>, later_s: f64) -> Sight {
        let moment = Moment { clock_s: self.moment.clock_s + later_s, ..self.moment };
        let camera = self.eye.at(self.derived, moment.clock_s);
        let still = Sight::still(&camera, self.size);
        let (hidden, meshes) = (self.hidden.clone(), self.beside.meshes().clone());
        Sight { moment, hidden, meshes, rules: painter.rules, ..still }
    }

    fn frame<'b>(&'b self, sight: &'b Sight) -> Frame<'b> {
        Frame::new(self.scene, self.derived, self.beside.sheet(), sight)
    }

    /// Its file as `kind`, with layers if they are wanted. What takes long tells `watch` how far it is.
    ///
    /// # Errors
    /// If it can't be drawn or packed, and if `watch` was cancelled.
    pub(crate) fn file(
        &self,
        painter: &mut Painter<'_>,
        kind: PictureKind,
        in_layers: bool,
        watch: &Watch,
    ) -> Result<Vec<u8>, NoPicture> {
        let sight = self.sight(painter, 0.0);
        let later = in_layers.then(|| Later::new(self.scene, self.derived, &self.sight(painter, STILL_S)));
        let frame = self.frame(&sight);
        let said = Said::new(&self.scene.name, &self.eye.camera().name, self.moment.clock_s, &frame);
        let file = draw(kind, painter, (frame, later.as_ref()), &said, watch)?;
        if watch.is_cancelled() { Err(NoPicture::Stopped) } else { Ok(file) }
    }
}
