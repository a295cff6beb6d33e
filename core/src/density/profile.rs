//! How extinction falls from the middle of a sprite's ball, by what its tile covers.

use crate::sprites::{Atlas, TILE_SIZE, TILES};

/// How far a ball reaches, in half widths: to a tile's corners.
pub(super) const REACH: f32 = std::f32::consts::SQRT_2;
/// Shells of a ball.
const SHELLS: usize = 32;
/// No tile is more opaque: the optical depth of what is quite opaque has no end.
const MOST_OPAQUE: f32 = 0.995;
/// Opacities that have a profile of their own: how a ball thins is not in proportion to how it covers.
const OPACITIES: usize = 64;
/// Entries of a profile by the square of the distance, as that needs no root.
const ENTRIES: usize = 1024;

/// The profiles of all tiles.
#[derive(Debug)]
pub(super) struct Profiles {
    /// Tile by tile, from the faintest.
    all: Vec<Profile>,
}

/// Extinction in shells about the middle of a ball of half width 1.
#[derive(Debug, Clone)]
pub(super) struct Profile {
    shells: [f32; SHELLS],
    by_square: Vec<f32>,
}

impl Profiles {
    pub(super) fn new(atlas: &Atlas) -> Self {
        let of_tile = |tile| {
            let rings = rings(atlas, tile);
            (1..=OPACITIES).map(move |step| Profile::new(&rings, step as f32 / OPACITIES as f32))
        };
        Self { all: (0..TILES).flat_map(of_tile).collect() }
    }

    /// Of a sprite with that tile whose alpha is multiplied with `opacity`.
    pub(super) fn of(&self, tile: u8, opacity: f32) -> &Profile {
        let step = (opacity.clamp(0.0, 1.0) * OPACITIES as f32).round().max(1.0) as usize;
        &self.all[usize::from(tile) % TILES * OPACITIES + step - 1]
    }
}

impl Profile {
    /// Such that a chord at any distance from the middle lets through what such a sprite does on average at that distance.
    /// The mean is that of light, not of depth: of many sprites that stand behind one another anyhow, the light that comes
    /// through is the product of their means.
    fn new(rings: &[f32; SHELLS], opacity: f32) -> Self {
        let shells = peeled(&rings.map(|alpha| -libm::logf(1.0 - (alpha * opacity).min(MOST_OPAQUE))));
        let square = |entry: usize| (entry as f32 + 0.5) / ENTRIES as f32 * REACH * REACH;
        Self { by_square: (0..ENTRIES).map(|entry| between(&shells, square(entry).sqrt())).collect(), shells }
    }

    /// Extinction by the square of the distance from the middle, in half widths.
    #[inline]
    pub(super) fn at_square(&self, square: f32) -> f32 {
        const PER_SQUARE: f32 = ENTRIES as f32 / (REACH * REACH);
        self.by_square.get((square * PER_SQUARE) as usize).copied().unwrap_or(0.0)
    }

    /// The sum of all extinction over the ball.
    pub(super) fn whole(&self) -> f32 {
        // In thin shells, as it is between the thick ones.
        const STEPS: usize = 8 * SHELLS;
        let step = REACH / STEPS as f32;
        let shell = |i: usize| {
            let away = (i as f32 + 0.5) * step;
            between(&self.shells, away) * away * away
        };
        (0..STEPS).map(shell).sum::<f32>() * step * 4.0 * std::f32::consts::PI
    }
}

/// A tile's mean alpha in rings about its middle.
fn rings(atlas: &Atlas, tile: usize) -> [f32; SHELLS] {
    let (mut sums, mut counts) = ([0.0_f32; SHELLS], [0_u32; SHELLS]);
    let half = TILE_SIZE as f32 * 0.5;
    for (i, texel) in atlas.level(tile, 0).texels.iter().enumerate() {
        let [x, y] = [i % TILE_SIZE, i / TILE_SIZE].map(|place| (place as f32 + 0.5 - half) / half);
        let shell = (((x * x + y * y).sqrt() / REACH * SHELLS as f32) as usize).min(SHELLS - 1);
        sums[shell] += f32::from(texel[3]) / 255.0;
        counts[shell] += 1;
    }
    // The outer rings are cut by the tile's edges, and clear beyond.
    let texels_in = |shell: usize| {
        let outer = |shell: usize| shell as f32 / SHELLS as f32 * REACH * half;
        std::f32::consts::PI * (outer(shell + 1) * outer(shell + 1) - outer(shell) * outer(shell))
    };
    std::array::from_fn(|shell| sums[shell] / texels_in(shell).max(counts[shell] as f32).max(1.0))
}

/// The shells whose chords, each through the middle of a shell, have those depths: from the outside in, as in Abel's
/// inversion. What the outer ones leave of a chord's depth is the next one's; where there is nothing left, it is empty.
fn peeled(depths: &[f32; SHELLS]) -> [f32; SHELLS] {
    let thickness = REACH / SHELLS as f32;
    let mut shells = [0.0; SHELLS];
    for chord in (0..SHELLS).rev() {
        let away = (chord as f32 + 0.5) * thickness;
        // Half of what lies within a radius, of the chord at that distance from the middle.
        let half = |outer: usize| {
            let radius = outer as f32 * thickness;
            (radius * radius - away * away).max(0.0).sqrt()
        };
        let beyond: f32 = (chord + 1..SHELLS).map(|shell| shells[shell] * 2.0 * (half(shell + 1) - half(shell))).sum();
        shells[chord] = ((depths[chord] - beyond) / (2.0 * half(chord + 1))).max(0.0);
    }
    shells
}

/// Linear between the middles of shells, so that voxels show no steps.
fn between(shells: &[f32; SHELLS], distance: f32) -> f32 {
    let place = (distance / REACH * SHELLS as f32 - 0.5).max(0.0);
    let (shell, share) = (place as usize, place.fract());
    let of = |shell: usize| shells.get(shell).copied().unwrap_or(0.0);
    of(shell) * (1.0 - share) + of(shell + 1) * share
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball of even extinction has the depth of its chord's length.
    #[test]
    fn an_even_ball_is_peeled_even() {
        let depths = std::array::from_fn(|shell| {
            let away = (shell as f32 + 0.5) * REACH / SHELLS as f32;
            2.0 * (REACH * REACH - away * away).sqrt() * 0.7
        });
        for (shell, value) in peeled(&depths).iter().enumerate() {
            assert!((value - 0.7).abs() < 1e-3, "shell {shell}: {value}");
        }
    }

    /// Whatever a tile covers and however faint its sprite is, chords through the ball are as opaque as its rings.
    #[test]
    fn chords_of_a_ball_are_as_opaque_as_its_tile_is_around() {
        for tile in 0..TILES {
            let rings = rings(Atlas::built_in(), tile);
            for opacity in [0.1, 0.5, 1.0] {
                let profile = Profile::new(&rings, opacity);
                for (shell, alpha) in rings.iter().enumerate() {
                    let away = (shell as f32 + 0.5) * REACH / SHELLS as f32;
                    let step = 0.002;
                    let depth: f32 = (0..2000)
                        .map(|i| (i as f32 + 0.5) * step - 2.0)
                        .map(|along| profile.at_square(away * away + along * along) * step)
                        .sum();
                    let (got, want) = (1.0 - (-depth).exp(), alpha * opacity);
                    assert!((got - want).abs() < 0.04, "tile {tile} × {opacity}, shell {shell}: {got}, want {want}");
                }
            }
        }
    }

    #[test]
    fn the_whole_is_the_sum_over_the_ball() {
        let profile = Profile { shells: [0.5; SHELLS], by_square: Vec::new() };
        let ball = 4.0 / 3.0 * std::f32::consts::PI * REACH * REACH * REACH;
        // But for the half shell that falls to nothing at the rim.
        assert!((profile.whole() / (0.5 * ball) - 1.0).abs() < 3.0 / SHELLS as f32, "{}", profile.whole());
    }
}
