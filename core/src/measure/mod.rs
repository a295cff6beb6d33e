//! Figures about scenes and pictures: pure functions that cost nothing unless they are asked for.
//!
//! **Error**: [`flip()`] as an eye sees it, on 8-bit sRGB; [`linear_error`] and [`opacity_error`] in linear light;
//! [`wrong_order`], the part of it that a sorted list is to blame for. **Stability**: [`Stability`], along a path.
//! **Cost**: [`Counts`], which no machine changes. **Coverage**: [`coverage`], the sky hidden, seen from
//! below; [`sky_cover`], a scene's.
//! Where a figure belongs to each pixel, a [`PixelMap`] holds it: the source of means, percentiles and heat maps.

mod counts;
mod coverage;
mod errors;
mod flip;
mod order;
mod overdraw;
mod percentile;
mod pixel_map;
mod sky_cover;
mod stability;

pub use counts::{Counts, bytes_of_change};
pub use coverage::{Coverage, VISIBLE_OPACITY, coverage};
pub use errors::{LinearError, OpacityError, SizesDiffer, linear_error, linear_error_map, opacity_error};
pub use flip::{PIXELS_PER_DEGREE, flip};
pub use order::{WrongOrder, wrong_order};
pub use overdraw::{Overdraw, overdraw, overdraw_map};
pub use percentile::percentile;
pub use pixel_map::PixelMap;
pub use sky_cover::{EYE_M, Observer, sky_cover};
pub use stability::{Stability, StabilityFigures};
