//! Eight pixels at once with AVX2 and FMA.
//!
//! The sums are those of [`ScreenSprite::fragment`] in another order. Weights of texels have 15 bits, so that a
//! multiply-add of 16-bit pairs filters two texels in one instruction. Pixels beside the quad need no mask: texture
//! coordinates are clamped to the tile, whose border is clear.

use super::super::bins::{TILE, TileRect};
use super::super::{Glow, ScreenSprite};
use super::fragments::{Fragments, LANES};
use super::queue::Queue;
use super::tile::{Spans, Tile, bits};
use crate::camera::NEAR_M;
use crate::sprites::{Atlas, FootprintTable, LEVEL_START, MIP_LEVELS, TABLE, TILE_SIZE};
use bytemuck::must_cast;
use std::arch::x86_64::*;

/// Texels' weights sum to this.
const WEIGHT_ONE: f32 = 32_767.0;

/// Proof that this processor has AVX2 and FMA, with the atlas to draw with.
pub struct Avx2Blender<'a> {
    atlas: &'a Atlas,
}

/// A sprite's constants.
struct Constants<const G: usize> {
    fine: Level,
    /// The next level, and how much of it.
    coarse: Option<(Level, f32)>,
    alpha: Bilinear,
    lights: [Shine; G],
    cut_by_near: bool,
}

/// Value at the top left, change along u, along v, and along both.
type Bilinear = [f32; 4];

/// A light's constants.
struct Shine {
    /// For red, green and blue; none where all is black.
    corners: Option<[Bilinear; 3]>,
    added: [f32; 3],
}

impl Shine {
    fn new(glow: &Glow) -> Self {
        let has_corners = glow.corners != [[0.0; 3]; 4];
        let corners = has_corners.then(|| std::array::from_fn(|c| bilinear(glow.corners.map(|corner| corner[c]))));
        Self { corners, added: glow.added }
    }
}

fn bilinear([top_left, top_right, bottom_right, bottom_left]: [f32; 4]) -> Bilinear {
    let (along_u, along_v) = (top_right - top_left, bottom_left - top_left);
    [top_left, along_u, along_v, bottom_right - top_left - along_u - along_v]
}

#[derive(Clone, Copy)]
struct Level {
    size: f32,
    start: usize,
}

impl Level {
    fn of(mip: usize) -> Self {
        Self { size: (TILE_SIZE >> mip) as f32, start: LEVEL_START[mip] }
    }
}

impl<'a> Avx2Blender<'a> {
    /// None on a processor without the instructions.
    pub fn new(atlas: &'a Atlas) -> Option<Self> {
        (is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")).then_some(Self { atlas })
    }

    /// Adds `sprite` in these lights behind what `tile` shows already, or to the `queue`. Eight pixels that all let less than
    /// `stop_below` through are left as they are.
    pub fn draw<const G: usize>(
        &self,
        (tile, queue): (&mut Tile<G>, Option<&mut Queue<G>>),
        rect: TileRect,
        sprite: (&ScreenSprite, &[Glow; G]),
        stop_below: f32,
    ) {
        let footprints = self.atlas.footprints();
        let (alpha_red, green_blue) = (footprints.alpha_red(sprite.0.tile), footprints.green_blue(sprite.0.tile));
        // SAFETY: a blender exists only where `new` found AVX2 and FMA; the functions need nothing else.
        #[allow(unsafe_code)]
        unsafe {
            match green_blue {
                None => draw::<true, G>((tile, queue), rect, sprite, [alpha_red; 2], stop_below),
                Some(green_blue) => draw::<false, G>((tile, queue), rect, sprite, [alpha_red, green_blue], stop_below),
            }
        }
    }
}

fn constants<const G: usize>(sprite: &ScreenSprite, lights: &[Glow; G]) -> Constants<G> {
    let mip = sprite.mip.clamp(0.0, (MIP_LEVELS - 1) as f32);
    let (level, between) = (mip as usize, mip - mip.floor());
    Constants {
        fine: Level::of(level),
        coarse: (between > 0.0).then(|| (Level::of(level + 1), between)),
        alpha: bilinear(sprite.corners.map(|corner| corner[3])),
        lights: lights.each_ref().map(Shine::new),
        cut_by_near: sprite.outline.is_none(),
    }
}

#[target_feature(enable = "avx2,fma")]
fn draw<const GREY: bool, const G: usize>(
    (tile, mut queue): (&mut Tile<G>, Option<&mut Queue<G>>),
    rect: TileRect,
    (sprite, lights): (&ScreenSprite, &[Glow; G]),
    [alpha_red, green_blue]: [&FootprintTable; 2],
    stop_below: f32,
) {
    let constants = constants(sprite, lights);
    let stop_below = _mm256_set1_ps(stop_below);
    let lanes = _mm256_setr_ps(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
    let (first_x, first_y) = (rect.left as f32 + 0.5 - sprite.anchor.x, rect.top as f32 + 0.5 - sprite.anchor.y);
    let [d_dx, u_dx, v_dx] = [sprite.denominator.dx, sprite.u.dx, sprite.v.dx].map(|dx| _mm256_set1_ps(dx));
    let nearness_of_one = _mm256_set1_ps(sprite.nearness_of_one());
    for (row, span) in Spans::new(sprite, rect).rows() {
        let y = first_y + row as f32;
        let [d_row, u_row, v_row] =
            [sprite.denominator, sprite.u, sprite.v].map(|linear| _mm256_set1_ps(linear.at(first_x, y)));
        for group in bits(tile.open_groups(row, &span)) {
            let x = _mm256_add_ps(_mm256_set1_ps((group * LANES) as f32), lanes);
            let denominator = _mm256_fmadd_ps(x, d_dx, d_row);
            let inverse = _mm256_div_ps(_mm256_set1_ps(1.0), denominator);
            // A lane beside the quad may have no number here. Of two operands min and max give the second unless the
            // comparison holds, so such a lane reads the tile's clear border.
            let within = |t| _mm256_max_ps(_mm256_min_ps(t, _mm256_set1_ps(1.0)), _mm256_setzero_ps());
            let u = within(_mm256_mul_ps(_mm256_fmadd_ps(x, u_dx, u_row), inverse));
            let v = within(_mm256_mul_ps(_mm256_fmadd_ps(x, v_dx, v_row), inverse));

            let fine = fetch::<GREY>(constants.fine, u, v, alpha_red, green_blue);
            let mut texel = fine;
            if let Some((level, between)) = constants.coarse {
                let coarse = fetch::<GREY>(level, u, v, alpha_red, green_blue);
                let between = _mm256_set1_ps(between);
                for (fine, coarse) in texel.iter_mut().zip(coarse) {
                    *fine = _mm256_fmadd_ps(between, _mm256_sub_ps(coarse, *fine), *fine);
                }
            }
            if _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(texel[0], _mm256_setzero_ps())) == 0 {
                continue;
            }
            if constants.cut_by_near {
                let depth = _mm256_mul_ps(_mm256_set1_ps(sprite.depth), inverse);
                let before = _mm256_cmp_ps::<_CMP_GE_OQ>(depth, _mm256_set1_ps(NEAR_M));
                texel = texel.map(|channel| _mm256_and_ps(channel, before));
            }
            if let Some(models) = &tile.models {
                let nearness = models.nearness(group * LANES, row);
                let share = before_models(nearness, _mm256_mul_ps(_mm256_set1_ps(sprite.depth), inverse), sprite);
                texel = texel.map(|channel| _mm256_mul_ps(channel, share));
            }
            let fragments = fragments(&constants, _mm256_mul_ps(denominator, nearness_of_one), texel, u, v);
            let through = must_cast(match &mut queue {
                None => tile.blend(row * (TILE / LANES) + group, &fragments),
                Some(queue) => queue.push(tile, (row, group), fragments),
            });
            if _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GE_OQ>(through, stop_below)) == 0 {
                if let Some(queue) = &mut queue {
                    queue.flush(tile, (row, group));
                }
                tile.close(row, group);
            }
        }
    }
}

/// As [`super::super::models::share_before`], of eight pixels.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn before_models(nearness: &[f32], depth: __m256, sprite: &ScreenSprite) -> __m256 {
    let nearness: [f32; LANES] = std::array::from_fn(|lane| nearness[lane]);
    let (half, one) = (_mm256_set1_ps(0.5), _mm256_set1_ps(1.0));
    let between = _mm256_sub_ps(_mm256_div_ps(one, must_cast(nearness)), depth);
    let share = _mm256_fmadd_ps(between, _mm256_set1_ps(0.5 / sprite.half_depth_m), half);
    // Of what is no number, min gives the second.
    _mm256_max_ps(_mm256_min_ps(share, one), _mm256_setzero_ps())
}

/// Eight fragments of `texel` (alpha, red, green, blue) lit by the corners' lights at (u, v).
#[target_feature(enable = "avx2,fma")]
#[inline]
fn fragments<const G: usize>(
    constants: &Constants<G>,
    nearness: __m256,
    texel: [__m256; 4],
    u: __m256,
    v: __m256,
) -> Fragments<G> {
    let uv = _mm256_mul_ps(u, v);
    let share = at(&constants.alpha, u, v, uv);
    let mut lights = [[[0.0; LANES]; 3]; G];
    for (colors, light) in lights.iter_mut().zip(&constants.lights) {
        for (c, shown) in colors.iter_mut().enumerate() {
            let mut color = _mm256_mul_ps(texel[0], _mm256_set1_ps(light.added[c]));
            if let Some(corners) = &light.corners {
                color = _mm256_fmadd_ps(texel[c + 1], at(&corners[c], u, v, uv), color);
            }
            *shown = must_cast(_mm256_mul_ps(share, color));
        }
    }
    Fragments { nearness: must_cast(nearness), alpha: must_cast(_mm256_mul_ps(share, texel[0])), lights }
}

/// The value at (u, v).
#[target_feature(enable = "avx2,fma")]
#[inline]
fn at([at, along_u, along_v, along_both]: &Bilinear, u: __m256, v: __m256, uv: __m256) -> __m256 {
    let base = _mm256_fmadd_ps(u, _mm256_set1_ps(*along_u), _mm256_set1_ps(*at));
    _mm256_fmadd_ps(uv, _mm256_set1_ps(*along_both), _mm256_fmadd_ps(v, _mm256_set1_ps(*along_v), base))
}

/// Alpha, red, green and blue of eight pixels at one mip level, 0 to 1, premultiplied.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn fetch<const GREY: bool>(
    level: Level,
    u: __m256,
    v: __m256,
    alpha_red: &FootprintTable,
    green_blue: &FootprintTable,
) -> [__m256; 4] {
    let (size, half) = (_mm256_set1_ps(level.size), _mm256_set1_ps(-0.5));
    let (zero, last) = (_mm256_setzero_ps(), _mm256_set1_ps(level.size - 1.0));
    let x = _mm256_max_ps(_mm256_min_ps(_mm256_fmadd_ps(u, size, half), last), zero);
    let y = _mm256_max_ps(_mm256_min_ps(_mm256_fmadd_ps(v, size, half), last), zero);
    let (column, row) = (_mm256_floor_ps(x), _mm256_floor_ps(y));
    let (fx, fy) = (_mm256_sub_ps(x, column), _mm256_sub_ps(y, row));
    let index = _mm256_cvtps_epi32(_mm256_fmadd_ps(row, size, column));
    let index: [i32; LANES] = must_cast(_mm256_add_epi32(index, _mm256_set1_epi32(level.start as i32)));

    // Weights of left and right texels, top and bottom, as pairs of 16-bit numbers (top low, bottom high).
    let one = _mm256_set1_ps(WEIGHT_ONE);
    let (right, lower) = (_mm256_mul_ps(fx, one), fy);
    let left = _mm256_sub_ps(one, right);
    let lower_right = _mm256_cvtps_epi32(_mm256_mul_ps(right, lower));
    let lower_left = _mm256_cvtps_epi32(_mm256_mul_ps(left, lower));
    let upper_right = _mm256_sub_epi32(_mm256_cvtps_epi32(right), lower_right);
    let upper_left = _mm256_sub_epi32(_mm256_cvtps_epi32(left), lower_left);
    let left = _mm256_or_si256(upper_left, _mm256_slli_epi32::<16>(lower_left));
    let right = _mm256_or_si256(upper_right, _mm256_slli_epi32::<16>(lower_right));

    let [alpha, red] = filter(alpha_red, &index, left, right);
    if GREY {
        return [alpha, red, red, red];
    }
    let [green, blue] = filter(green_blue, &index, left, right);
    [alpha, red, green, blue]
}

/// The two channels of a table at eight texels, filtered with weights for the left texels (upper low, lower high) and for
/// the right ones.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn filter(table: &FootprintTable, index: &[i32; LANES], left: __m256i, right: __m256i) -> [__m256; 2] {
    // One load of eight bytes: an entry and its right neighbour.
    let at = |lane: usize| {
        let entry = index[lane] as usize & (TABLE - 1);
        (u64::from(table[entry]) | (u64::from(table[entry + 1]) << 32)) as i64
    };
    // In this order the shuffles below bring the lanes back in line.
    let low = _mm256_castsi256_ps(_mm256_set_epi64x(at(5), at(4), at(1), at(0)));
    let high = _mm256_castsi256_ps(_mm256_set_epi64x(at(7), at(6), at(3), at(2)));
    let left_texels = _mm256_castps_si256(_mm256_shuffle_ps::<0b10_00_10_00>(low, high));
    let right_texels = _mm256_castps_si256(_mm256_shuffle_ps::<0b11_01_11_01>(low, high));
    // Two bytes of each entry as 16-bit numbers.
    let channels = [0x8001_8000_u32, 0x8003_8002].map(|first| {
        let lanes: [u32; 4] = std::array::from_fn(|lane| first + 0x0004_0004 * lane as u32);
        _mm256_broadcastsi128_si256(must_cast(lanes))
    });
    channels.map(|channel| {
        let left = _mm256_madd_epi16(_mm256_shuffle_epi8(left_texels, channel), left);
        let right = _mm256_madd_epi16(_mm256_shuffle_epi8(right_texels, channel), right);
        let sum = _mm256_cvtepi32_ps(_mm256_add_epi32(left, right));
        _mm256_mul_ps(sum, _mm256_set1_ps(1.0 / (255.0 * WEIGHT_ONE)))
    })
}
