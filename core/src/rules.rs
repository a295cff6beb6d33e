//! By which rules a picture is drawn: one value, which a [`crate::sight::Sight`] carries, a frame is made by, and a
//! method gives a name.
//!
//! The rules that ship stand in their own rooms; those of the sources that fail are in `variants`, as values of the same
//! types, and are put together with a name in `method/table.rs`.

use crate::detail::Detail;
use crate::draw_list::Sorting;
use crate::facing::FacingRule;
use crate::weather::{FormingRule, StreamingRule, WeatherRules};
use std::collections::BTreeMap;

/// Draw to the last sprite.
pub const NEVER_STOP: f32 = 0.0;

/// In what order [`Rasterizer::Fast`] blends fragments that lie over one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FragmentOrder {
    /// In their sprites', which the list has by distance: wrong where quads cross.
    OfSprites,
    /// In that of their own depths, as far as a short queue at each pixel takes it.
    #[default]
    OfTheirOwn,
}

/// How [`Rasterizer::Fast`] blends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blending {
    /// A pixel is done when less than this share of what lies behind gets through. What still does shows the background, but
    /// for rows of a tile that are done as a whole.
    pub stop_below: f32,
    /// In what order.
    pub order: FragmentOrder,
}

impl Blending {
    /// What ships.
    pub const SHIPPED: Self = Self { stop_below: 1.0 / 1024.0, order: FragmentOrder::OfTheirOwn };
    /// To the last sprite, in the list's order: as [`Rasterizer::Plain`].
    pub const AS_PLAIN: Self = Self { stop_below: NEVER_STOP, order: FragmentOrder::OfSprites };
}

/// What turns a frame into pixels, and in what precision it blends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rasterizer {
    /// Each sample's fragments in their own order, in f32 ([`crate::raster::truth`]).
    Truth,
    /// Tiles on all cores, in f32 ([`crate::raster::fast`]).
    Fast(Blending),
    /// One fragment after the other, in f32 ([`crate::raster::plain`]).
    Plain,
    /// Into eight bits a channel: one of the sources' ways that fail.
    EightBits,
    /// A graphics adapter, in 16-bit floats: not in this crate; whoever has an adapter draws.
    Gpu,
}

/// How texels become a fragment's, on the CPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Filter {
    /// Linear within and between mip levels.
    #[default]
    MipLevels,
    /// Linear within the finest level, whose texels far sprites step over: they shimmer.
    FinestLevel,
}

/// Where the haze before a sprite is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HazeRule {
    /// At its centre, for all of it.
    #[default]
    ASprite,
    /// Where each ray meets it, and in that ray's direction. Only [`Rasterizer::Truth`] does so; to others it is the sprite's.
    AFragment,
}

/// A full way to draw. [`Rules::SHIPPED`] and what differs from it make a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// What makes pixels.
    pub rasterizer: Rasterizer,
    /// When sprites are sorted again.
    pub sorting: Sorting,
    /// How sprites near the eye turn and fade.
    pub facing: FacingRule,
    /// How clouds form.
    pub forming: FormingRule,
    /// How loose edges follow the wind.
    pub streaming: StreamingRule,
    /// How much of each cloud is drawn.
    pub detail: Detail,
    /// How texels become a fragment's.
    pub filter: Filter,
    /// Where the haze before a sprite is taken.
    pub haze: HazeRule,
    /// Samples a pixel, as the side of their square; at least 1.
    pub samples_side: u32,
}

/// What moves in a scene, or before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Movement {
    /// The eye.
    pub flies: bool,
    /// A cloud forms or dissipates, by terms of its own.
    pub forms: bool,
    /// A wind.
    pub blows: bool,
}

impl Rules {
    /// What Cloudwright draws by on the CPU.
    pub const SHIPPED: Self = Self {
        rasterizer: Rasterizer::Fast(Blending::SHIPPED),
        sorting: Sorting::EachFrame,
        facing: FacingRule::BOUNDED,
        forming: FormingRule::ClosedForm,
        streaming: StreamingRule::ClosedForm,
        detail: Detail::FULL,
        filter: Filter::MipLevels,
        haze: HazeRule::ASprite,
        samples_side: 1,
    };

    /// With the sprites sorted so. An order that is kept or faded is one of sprites: each fragment's own would undo it.
    pub fn sorted(self, sorting: Sorting) -> Self {
        let rasterizer = match self.rasterizer {
            Rasterizer::Fast(blending) if sorting != Sorting::EachFrame => {
                Rasterizer::Fast(Blending { order: FragmentOrder::OfSprites, ..blending })
            }
            as_before => as_before,
        };
        Self { rasterizer, sorting, ..self }
    }

    /// Whether the haze is each fragment's own.
    pub fn hazes_fragments(&self) -> bool {
        self.rasterizer == Rasterizer::Truth && self.haze == HazeRule::AFragment
    }

    /// By which rules the clock moves clouds.
    pub fn of_weather(&self) -> WeatherRules {
        WeatherRules { forming: self.forming, streaming: self.streaming }
    }

    /// How many of a frame's pixels lie side by side in one of the picture's.
    pub fn pixels_a_pixel(&self) -> u32 {
        // The truth takes its samples itself.
        if self.rasterizer == Rasterizer::Truth { 1 } else { self.samples_side.max(1) }
    }

    /// Whether a view that goes by these and one that goes by `other` remember the same of their way.
    pub fn remember_as(&self, other: &Self) -> bool {
        (self.facing, self.sorting) == (other.facing, other.sorting)
    }

    /// Why these can't differ from the shipped ones where no more than that `moves`, if they can't.
    pub fn without_effect(&self, moves: Movement) -> Option<&'static str> {
        let Movement { flies, forms, blows } = moves;
        let locks = self.facing != FacingRule::BOUNDED && !self.facing.across_view;
        if self.forming != FormingRule::ClosedForm && !forms {
            Some("no cloud of the scene forms or dissipates")
        } else if self.streaming != StreamingRule::ClosedForm && !blows {
            Some("no wind blows in the scene")
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
        let (rasterizer, blending, stop) = match self.rasterizer {
            Rasterizer::Truth => ("truth", "32-bit float, by fragment", NEVER_STOP),
            Rasterizer::Fast(Blending { stop_below, order: FragmentOrder::OfSprites }) => {
                ("fast", "32-bit float", stop_below)
            }
            Rasterizer::Fast(Blending { stop_below, .. }) => ("fast", "32-bit float, by fragment", stop_below),
            Rasterizer::Plain => ("plain", "32-bit float", NEVER_STOP),
            Rasterizer::EightBits => ("plain", "8 bits", NEVER_STOP),
            Rasterizer::Gpu => ("GPU", "16-bit float", NEVER_STOP),
        };
        let sorting = if self.rasterizer == Rasterizer::Truth { "each ray" } else { self.sorting.name() };
        let filter = match self.filter {
            Filter::MipLevels => "mip levels",
            Filter::FinestLevel => "finest level only",
        };
        let samples = (self.samples_side * self.samples_side).to_string();
        let merged = match self.detail.tolerance_px {
            pixels if pixels > 0.0 => format!("off by {pixels:.1} px"),
            _ => "none".into(),
        };
        let stop = if stop > NEVER_STOP { format!("below 1/{:.0}", 1.0 / stop) } else { "none".into() };
        [
            ("renderer", rasterizer.into()),
            ("blending", blending.into()),
            ("early stop", stop),
            ("sorting", sorting.into()),
            ("facing", self.facing.name.into()),
            ("forming", self.forming.in_words()),
            ("streaming", self.streaming.in_words()),
            ("sprites kept", format!("{:.0} %", self.detail.kept * 100.0)),
            ("merged", merged),
            ("filter", filter.into()),
            ("haze", if self.hazes_fragments() { "a fragment" } else { "a sprite" }.into()),
            ("samples", samples),
        ]
        .map(|(name, value): (&str, String)| (name.into(), value))
        .into()
    }
}
