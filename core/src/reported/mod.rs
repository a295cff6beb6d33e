//! What weather reports mean for a scene: the layers that a sky needs, its air as properties, and several reports as tracks.
//!
//! A [`Report`](crate::formats::metar::Report) is what stands in the text; a [`Sky`] is what is made of it, of a forecast's
//! hours ([`expected`]), or of what several stations say ([`skies`]). Clouds are planned here and placed by whoever runs
//! plugins. Several skies become smooth keys at their times: monotone cubics pass through each one's values, so that
//! nothing steps at a report.

mod air;
mod expected;
mod layers;
mod preset;
mod regions;
mod sky;
mod stations;
mod strands;
mod timeline;

pub use air::{Air, EXTINCTION_AT_CONTRAST};
pub use expected::expected;
pub use layers::{Genus, PlannedLayer, layers};
pub use preset::{FREEZING_K, KNOT_MPS, LAPSE_K_PER_M};
pub use regions::roughly;
pub use sky::Sky;
pub use stations::{Place, Told, Unordered, skies};
pub use strands::{Strand, strands};
use timeline::minutes_apart;
pub use timeline::{ApplyError, SPEEDS, take_air, take_track};
