//! Random numbers that belong to a place, not to a sequence.
//!
//! Philox4x32-10 (Salmon, Moraes, Dror, Shaw: *Parallel Random Numbers: As Easy as 1, 2, 3*, SC 2011) maps
//! (cloud seed, box id, sprite index, block) to four 32-bit numbers with integer arithmetic alone. So changing one
//! box never re-rolls another's sprites, any sprite can be made in any order, and every machine gets the same bytes.

/// Four independent 32-bit numbers for one place.
///
/// `block` tells apart several draws for the same sprite.
pub fn draw(seed: u64, box_id: u64, sprite_index: u32, block: u32) -> [u32; 4] {
    let [box_low, box_high] = halves(box_id);
    philox4x32_10([sprite_index, block, box_low, box_high], halves(seed))
}

/// A number in (0, 1): never 0, never 1, exact in f64.
pub fn unit(bits: u32) -> f64 {
    (f64::from(bits) + 0.5) / 4_294_967_296.0
}

/// Another seed in place of `seed`, the same for everyone who rolls from there; of at most six digits, to be read and
/// typed.
pub fn another_seed(seed: u64) -> u64 {
    let next = u64::from(draw(seed, 0, 0, 0)[0] % 1_000_000);
    if next == seed { next + 1 } else { next }
}

fn halves(x: u64) -> [u32; 2] {
    [x as u32, (x >> 32) as u32]
}

fn philox4x32_10(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
    const WEYL: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
    for _ in 0..10 {
        let [low0, high0] = halves(u64::from(counter[0]) * u64::from(MULTIPLIERS[0]));
        let [low1, high1] = halves(u64::from(counter[2]) * u64::from(MULTIPLIERS[1]));
        counter = [high1 ^ counter[1] ^ key[0], low1, high0 ^ counter[3] ^ key[1], low0];
        key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
    }
    counter
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The known answers of the authors' own test vectors (Random123, kat_vectors).
    #[test]
    fn known_answers() {
        let all = u32::MAX;
        assert_eq!(philox4x32_10([0; 4], [0; 2]), [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]);
        assert_eq!(philox4x32_10([all; 4], [all; 2]), [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]);
    }
}
