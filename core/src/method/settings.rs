//! What a method consists of.

use crate::draw_list::Sorting;
use crate::facing::FacingRule;
use crate::raster::Filter;
use crate::raster::fast::{NEVER_STOP, STOP_BELOW};
use crate::shading::FormingRule;
use crate::variants::{FacingVariant, LazySorting, Listing, SteppedForming};
use crate::view_history::ViewHistory;
use std::collections::BTreeMap;

/// What turns a frame into pixels, and in what precision it blends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Renderer {
    /// Each sample's fragments in their own order, in f32 ([`crate::raster::truth`]).
    Truth,
    /// Tiles on all cores, in f32 ([`crate::raster::fast`]).
    Fast {
        /// A pixel is done when less than this share of what lies behind gets through.
        stop_below: f32,
    },
    /// One fragment after the other, in f32 ([`crate::raster::plain`]).
    Plain,
    /// Into eight bits a channel ([`crate::variants::eight_bits`]).
    EightBits,
    /// A graphics adapter, in 16-bit floats: not here, but in the renderer for GPUs.
    Gpu,
}

/// A full way to draw. [`Settings::SHIPPED`] and what differs from it make a row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// What makes pixels.
    pub renderer: Renderer,
    /// When sprites are sorted again.
    pub sorting: Sorting,
    /// How sprites near the eye turn and fade.
    pub facing: FacingRule,
    /// How clouds form.
    pub forming: FormingRule,
    /// Share of each cloud's sprites that is drawn, 0 to 1; see [`super::keep`].
    pub kept: f32,
    /// How texels become a fragment's.
    pub filter: Filter,
    /// Samples a pixel, as the side of their square; at least 1.
    pub samples_side: u32,
}

impl Settings {
    /// What Cloudwright draws with on the CPU.
    pub const SHIPPED: Self = Self {
        renderer: Renderer::Fast { stop_below: STOP_BELOW },
        sorting: Sorting::EachFrame,
        facing: FacingRule::Bounded,
        forming: FormingRule::ClosedForm,
        kept: 1.0,
        filter: Filter::MipLevels,
        samples_side: 1,
    };

    /// The history of a view that is drawn by these: of nothing yet.
    pub fn history(&self) -> ViewHistory {
        ViewHistory { forming: self.forming, ..ViewHistory::new(self.facing, self.sorting) }
    }

    /// Why these can't differ from the shipped ones in such a scene, if they can't: whether the eye `flies`, and
    /// whether any cloud `forms` or dissipates.
    pub fn without_effect(&self, flies: bool, forms: bool) -> Option<&'static str> {
        let locks = matches!(self.facing, FacingRule::Variant(variant) if variant != FacingVariant::ViewPlane);
        if self.forming != FormingRule::ClosedForm && !forms {
            Some("no cloud of the scene forms or dissipates")
        } else if self.sorting != Sorting::EachFrame && !flies {
            Some("in a still there is no older order")
        } else if locks && !flies {
            Some("in a still no sprite is locked on the way")
        } else {
            None
        }
    }

    /// What they are, in words: "sorting" → "each frame".
    pub fn in_words(&self) -> BTreeMap<String, String> {
        let (renderer, blending, stop) = match self.renderer {
            Renderer::Truth => ("truth", "32-bit float, by fragment", NEVER_STOP),
            Renderer::Fast { stop_below } => ("fast", "32-bit float", stop_below),
            Renderer::Plain => ("plain", "32-bit float", NEVER_STOP),
            Renderer::EightBits => ("plain", "8 bits", NEVER_STOP),
            Renderer::Gpu => ("GPU", "16-bit float", NEVER_STOP),
        };
        let sorting = match (self.renderer, self.sorting) {
            (Renderer::Truth, _) => "each ray",
            (_, Sorting::EachFrame) => "each frame",
            (_, Sorting::Crossfade) => "each half second, faded over",
            (_, Sorting::Variant(LazySorting::SkyWorks)) => "after 10 m or 36.9°",
            (_, Sorting::Variant(LazySorting::SimGear)) => "one bubble pass a frame",
        };
        let facing = match self.facing {
            FacingRule::Bounded => "locked and faded",
            FacingRule::Variant(FacingVariant::NoLock) => "no lock",
            FacingRule::Variant(FacingVariant::LockWithoutFade) => "locked, not faded",
            FacingRule::Variant(FacingVariant::WangsDotProduct) => "locked, faded by a dot product",
            FacingRule::Variant(FacingVariant::ViewPlane) => "across the view direction",
        };
        let forming = match self.forming {
            FormingRule::ClosedForm => "closed form".into(),
            FormingRule::Variant(SteppedForming { listing, frames_a_second }) => {
                let listing = if listing == Listing::AsPrinted { "as printed" } else { "mended" };
                format!("steps, {listing}, {frames_a_second} a second")
            }
        };
        let filter = match self.filter {
            Filter::MipLevels => "mip levels",
            Filter::FinestLevel => "finest level only",
        };
        let samples = (self.samples_side * self.samples_side).to_string();
        let stop = if stop > NEVER_STOP { format!("below 1/{:.0}", 1.0 / stop) } else { "none".into() };
        [
            ("renderer", renderer.into()),
            ("blending", blending.into()),
            ("early stop", stop),
            ("sorting", sorting.into()),
            ("facing", facing.into()),
            ("forming", forming),
            ("sprites kept", format!("{:.0} %", self.kept * 100.0)),
            ("filter", filter.into()),
            ("samples", samples),
        ]
        .map(|(name, value): (&str, String)| (name.into(), value))
        .into()
    }
}
