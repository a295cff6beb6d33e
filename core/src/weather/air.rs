//! The air at a moment: what it does to the sprites of every cloud alike.

use super::Lean;
use crate::scene::Weather;
use crate::sprites::Stir;
use glam::Vec3;

/// How fast a sprite goes from clear to whole as humidity rises, half, stretched.
pub const CONDENSING: f32 = 0.08;
/// The periods of the three swings of what sways, seconds: in no ratio of whole numbers.
pub(crate) const SWINGS_S: [f64; 3] = [7.3, 11.9, 19.1];
/// How far the largest sway goes, in a sprite's smaller side: in all three directions at once.
pub const SWAY: f32 = 0.1;

/// The air at one moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirNow {
    /// How far loose sprites lean in the middle of a cloud's height, in its reach, along the world's axes.
    pub lean: Vec3,
    /// How much more so at its top than at its bottom.
    pub lean_shear: Vec3,
    /// How far the loosest sprites have turned, whole turns.
    pub turned: f32,
    /// How much the air churns, 0 to 1.
    pub turbulence: f32,
    /// How far the three swings are, whole turns, less whole ones.
    pub swings: [f32; 3],
    /// The humidity, so stretched that 0 shows nothing of any cloud, and 1 everything.
    pub humidity: f32,
}

impl AirNow {
    /// At `clock_s` of the scene's clock, where the weather is as `now`; none if the air does nothing to sprites. `blown`: how
    /// far edges lean, and how many metres of wind have gone by, if there ever is any.
    pub fn new(now: &Weather, blown: Option<(Lean, f64)>, clock_s: f64) -> Option<Self> {
        if blown.is_none() && now.turbulence == 0.0 && now.humidity == 1.0 {
            return None;
        }
        let (lean, blown_m) = blown.unwrap_or_default();
        let across = |lean: glam::DVec2| Vec3::new(lean.x as f32, 0.0, lean.y as f32);
        let blown_km = blown_m / 1000.0;
        let (turned, humidity) = (blown_km * now.turn_deg_per_km / 360.0, now.humidity as f32);
        Some(Self {
            lean: across(lean.middle) * now.lean as f32,
            lean_shear: across(lean.shear) * now.lean as f32,
            // The loosest goes by whole turns, others by their shares of it: none may be left out.
            turned: turned as f32,
            turbulence: now.turbulence as f32,
            swings: SWINGS_S.map(|period_s| (clock_s / period_s).rem_euclid(1.0) as f32),
            humidity: humidity * (1.0 + 2.0 * CONDENSING) - CONDENSING,
        })
    }

    /// How far a sprite is off its rest, metres. `height`: its own within its cloud, 0 to 1; `reach_m` of the cloud's
    /// edges; `side_m`, its smaller one.
    pub fn carries(&self, stir: &Stir, height: f32, reach_m: f32, side_m: f32) -> Vec3 {
        let lean = (self.lean + self.lean_shear * (height - 0.5)) * (stir.looseness * reach_m);
        if self.turbulence == 0.0 {
            return lean;
        }
        let [x, y, z] = [0, 1, 2].map(|i| sine(self.swings[i] + stir.phases[i]));
        lean + Vec3::new(x, y, z) * (self.turbulence * stir.sway * SWAY * side_m)
    }

    /// How much of a sprite has condensed, 0 to 1.
    pub fn condensed(&self, stir: &Stir) -> f32 {
        crate::math::smoothstep(stir.threshold - CONDENSING, stir.threshold + CONDENSING, self.humidity)
    }

    /// Metres that no sprite is carried beyond, in a cloud of that reach whose largest sprite's side is `side_m`.
    pub fn most_m(&self, reach_m: f32, side_m: f32) -> f32 {
        let lean = self.lean.length() + 0.5 * self.lean_shear.length();
        lean * reach_m + 1.7321 * self.turbulence * SWAY * side_m
    }
}

/// The sine of so many whole turns, within 10⁻⁶: the same polynomial as in WGSL, whose own sine may be off by 2⁻¹¹.
pub fn sine(turns: f32) -> f32 {
    // To a quarter turn either way of 0.
    let within = turns - (turns + 0.5).floor();
    let folded = if within.abs() > 0.25 { 0.5_f32.copysign(within) - within } else { within };
    let squared = folded * folded;
    // Taylor's in 2π t up to t¹¹, whose next term is 6·10⁻⁸ at a quarter turn.
    folded
        * (6.283_185_5
            + squared
                * (-41.341_7
                    + squared * (81.605_25 + squared * (-76.705_86 + squared * (42.058_69 - squared * 15.094_643)))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sine_is_one() {
        for i in -4000..4000 {
            let turns = i as f32 * 0.001_37;
            let exact = (f64::from(turns) * std::f64::consts::TAU).sin();
            assert!((f64::from(sine(turns)) - exact).abs() < 2e-6, "{turns}: {} for {exact}", sine(turns));
        }
    }
}
