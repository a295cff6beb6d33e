//! The table of methods: a row each.

use super::{Family, Method};
use crate::detail::Detail;
use crate::draw_list::Sorting;
use crate::facing::FacingRule;
use crate::raster::truth::SIDE;
use crate::rules::{Blending, Filter, FragmentOrder, HazeRule, NEVER_STOP, Rasterizer, Rules};
use crate::variants::{
    LOCK_WITHOUT_FADE, NO_LOCK, SIMGEAR, SKYWORKS, STEPPED_10, STEPPED_AS_PRINTED, STEPPED_MENDED, VIEW_PLANE,
    WANGS_DOT_PRODUCT,
};
use crate::weather::{FormingRule, Stepped, StreamingRule};

const OURS: Rules = Rules::SHIPPED;
/// In the order of whole sprites: what the ways of sorting are about.
const BY_SPRITES: Rules = with(Rasterizer::Fast(Blending { order: FragmentOrder::OfSprites, ..Blending::SHIPPED }));

/// The row of the truth.
pub(super) const TRUTH: Method = Method {
    name: "truth",
    about: "The fragments of 16 rays a pixel, each ray's in their own order.",
    family: Family::Truth,
    rules: Rules { rasterizer: Rasterizer::Truth, samples_side: SIDE, ..OURS },
};

/// The row of what is shipped.
pub(super) const SHIPPED: Method = Method {
    name: "fast",
    about: "What Cloudwright draws with on the CPU: sorted each frame, where quads cross pixel by pixel, one sample each, done \
            where nothing more shows.",
    family: Family::Shipped,
    rules: OURS,
};

/// All methods: the truth, what is shipped, what else is worth a look, what is known to fail.
pub const METHODS: &[Method] = &[
    TRUTH,
    SHIPPED,
    other("gpu", "The same by a graphics adapter, in 16-bit floats.", with(Rasterizer::Gpu)),
    other(
        "plain",
        "One fragment after the other on one core: what the fast way is tested against.",
        with(Rasterizer::Plain),
    ),
    other(
        "four-samples",
        "The fast way at twice the width and height, averaged in linear light.",
        Rules { samples_side: 2, ..OURS },
    ),
    other(
        "by-sprites",
        "The fast way in the order of whole sprites, by the distances of their centres: wrong where quads cross.",
        BY_SPRITES,
    ),
    other(
        "crossfade",
        "The order is kept for half a second and faded over to the next, as Wang suggests: nothing pops, but the order is \
         old, and two are drawn.",
        Rules { sorting: Sorting::Crossfade, ..BY_SPRITES },
    ),
    other("no-stop", "The fast way to the last sprite, hidden or not.", fast(NEVER_STOP)),
    other(
        "early-stop",
        "A pixel is done when less than a sixteenth of what lies behind gets through.",
        fast(1.0 / 16.0),
    ),
    other(
        "auto",
        "Where sprites are too small to tell apart, merged ones in their place.",
        Rules { detail: Detail::AUTOMATIC, ..OURS },
    ),
    other(
        "three-quarters",
        "Of each cloud the quarter of the sprites that cover least is left out.",
        Rules { detail: Detail { kept: 0.75, ..Detail::FULL }, ..OURS },
    ),
    other(
        "half",
        "Of each cloud the half of the sprites that cover most.",
        Rules { detail: Detail { kept: 0.5, ..Detail::FULL }, ..OURS },
    ),
    other(
        "quarter",
        "Of each cloud the quarter of the sprites that cover most.",
        Rules { detail: Detail { kept: 0.25, ..Detail::FULL }, ..OURS },
    ),
    other(
        "no-mips",
        "Texels of the finest level only: sharper near by, but what is far steps over most of them and shimmers.",
        Rules { filter: Filter::FinestLevel, ..OURS },
    ),
    other(
        "haze-a-fragment",
        "The truth with haze taken where each ray meets a sprite: by how much it differs is what one haze a sprite costs.",
        Rules { haze: HazeRule::AFragment, ..TRUTH.rules },
    ),
    failing(
        "eight-bits",
        "Every sprite is blended into 8 bits a channel: roundings add up to bands.",
        with(Rasterizer::EightBits),
    ),
    failing(
        "view-plane",
        "Sprites lie across the view direction instead of facing the eye: all turn when the head does.",
        facing(VIEW_PLANE),
    ),
    failing("no-lock", "Sprites always face the eye: near ones spin as it passes.", facing(NO_LOCK)),
    failing(
        "lock-without-fade",
        "Near sprites are locked but not faded: they are seen edge on, and snap back.",
        facing(LOCK_WITHOUT_FADE),
    ),
    failing(
        "dot-product",
        "Near sprites are locked and fade by the dot product that Wang writes: it jumps where the eye passes a centre.",
        facing(WANGS_DOT_PRODUCT),
    ),
    failing(
        "lazy-skyworks",
        "Sorted again after 10 m of travel or 36.9° of turn, as SkyWorks does: late, then all at once.",
        Rules { sorting: Sorting::Lazy(SKYWORKS), ..BY_SPRITES },
    ),
    failing(
        "lazy-simgear",
        "One pass of bubble sort a frame, as SimGear does: the order lags behind.",
        Rules { sorting: Sorting::Lazy(SIMGEAR), ..BY_SPRITES },
    ),
    failing(
        "stepped-as-printed",
        "Forming by the article's listing as printed: the core fades first, and a whole cloud is left unset.",
        stepped(STEPPED_AS_PRINTED),
    ),
    failing(
        "stepped-mended",
        "Forming by the article's listing, mended but stepped: it depends on the frame rate.",
        stepped(STEPPED_MENDED),
    ),
    failing(
        "stepped-wind",
        "Edges follow the wind by explicit steps of a tenth of a second: with a lag of less than half of that they fly off.",
        Rules { streaming: StreamingRule::Stepped(STEPPED_10), ..OURS },
    ),
];

const fn other(name: &'static str, about: &'static str, rules: Rules) -> Method {
    Method { name, about, family: Family::Other, rules }
}

const fn failing(name: &'static str, about: &'static str, rules: Rules) -> Method {
    Method { name, about, family: Family::Failing, rules }
}

const fn with(rasterizer: Rasterizer) -> Rules {
    Rules { rasterizer, ..OURS }
}

const fn fast(stop_below: f32) -> Rules {
    with(Rasterizer::Fast(Blending { stop_below, ..Blending::SHIPPED }))
}

const fn facing(facing: FacingRule) -> Rules {
    Rules { facing, ..OURS }
}

const fn stepped(forming: Stepped) -> Rules {
    Rules { forming: FormingRule::Stepped(forming), ..OURS }
}
