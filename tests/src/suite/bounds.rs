//! What bounds are made from.

use super::figure::Figure;
use cloudwright_core::rules::Blending;

/// Off the truth by rounding, for the brightest light of 1: texels are filtered with weights of 15 bits, each of four off
/// by 2⁻¹⁵ at most. A solid texel is then off by four such parts, a layer's opacity by as many parts of itself, and a
/// stack of layers by no more than one layer that shows alone, since what each shows of itself adds up to 1 at most.
pub const ROUNDING: f64 = 4.0 / 32_768.0;

/// Off the truth by what the shipped method leaves out behind what hides it.
pub const STOP: f64 = Blending::SHIPPED.stop_below as f64;

/// Where two neighbours of opacity `alpha`, one black, the other white, are drawn in the wrong order.
pub const fn swapped(alpha: f64) -> f64 {
    alpha * alpha
}

/// What a method keeps in a situation.
#[derive(Debug, Clone, Copy)]
pub struct Bound {
    /// What is measured.
    pub figure: Figure,
    /// How large it is at most.
    pub at_most: f64,
    /// Why, in a sentence.
    pub because: &'static str,
}

/// Of nothing but rounding.
pub const fn exact(figure: Figure, because: &'static str) -> Bound {
    Bound { figure, at_most: ROUNDING, because }
}
