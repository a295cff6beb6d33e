//! From a draw list to sprites on the screen: faced, shaded, hazed and projected, ready to be sampled at any pixel.
//!
//! A quad lies in a plane, so its texture coordinates are quotients of functions linear in the pixel's: with the ray
//! ρ(x, y), the plane's normal n and offset n·c, the ray meets it at t = n·c / n·ρ, and u = ½ + (tρ − c)·right / width.
//! One division a pixel is thus exact perspective, near and far alike.

use crate::camera::{NEAR_M, View};
use crate::color::Premultiplied;
use crate::draw_list::{DrawSprite, SpritesAlone};
use crate::frame::Frame;
use crate::posed_sprite::PosedSprite;
use crate::rules::Filter;
use crate::sky::{DomeTables, haze_share};
use crate::sprites::{Atlas, MIP_LEVELS, TILE_SIZE, TileLevel};
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;

/// A function linear in the pixel coordinates counted from a sprite's [`ScreenSprite::anchor`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear {
    /// Value at the anchor.
    pub at_anchor: f32,
    /// Change a pixel to the right.
    pub dx: f32,
    /// Change a pixel down.
    pub dy: f32,
}

impl Linear {
    /// The value `x`, `y` pixels from the anchor.
    #[inline]
    pub fn at(self, x: f32, y: f32) -> f32 {
        self.at_anchor + x * self.dx + y * self.dy
    }
}

/// A sprite as one view sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenSprite {
    /// Pixel of the picture that the linear functions count from: the nearest to its centre.
    pub anchor: Vec2,
    /// n·ρ, the common denominator; positive where the ray meets the plane before the eye.
    pub denominator: Linear,
    /// u times the denominator; u runs from 0 at the left to 1 at the right.
    pub u: Linear,
    /// v times the denominator; v runs from 0 at the top to 1 at the bottom.
    pub v: Linear,
    /// View depth times the denominator, metres.
    pub depth: f32,
    /// Half of how deep it is among models, metres.
    pub half_depth_m: f32,
    /// 0 to 15.
    pub tile: u8,
    /// Texels across a pixel at view depth 1 m.
    pub texels_a_pixel: f32,
    /// Mip level of the whole sprite for one sample a pixel, not yet clamped: [`ScreenSprite::mip_at`] its centre,
    /// sharpened.
    pub mip: f32,
    /// Least and greatest u, v, u + v and u − v between which its tile shows anything, at the levels for one sample a
    /// pixel.
    pub covered: [[f32; 2]; 4],
    /// Linear light and alpha at top left, top right, bottom right, bottom left; straight, what haze leaves of it.
    pub corners: [[f32; 4]; 4],
    /// What haze adds, for a fragment of alpha 1.
    pub haze: [f32; 3],
    /// Left, top, right, bottom: no pixel centre outside can be covered.
    pub bounds: [f32; 4],
    /// The corners on the screen, if all lie before the near plane.
    pub outline: Option<[Vec2; 4]>,
}

/// Light that a sprite shows: what its tile's colour is multiplied with, and what is added whatever that colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glow {
    /// Linear light at top left, top right, bottom right, bottom left.
    pub corners: [[f32; 3]; 4],
    /// For a fragment of alpha 1.
    pub added: [f32; 3],
}

/// Where a ray meets a sprite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// From 0 at the left to 1 at the right.
    pub u: f32,
    /// From 0 at the top to 1 at the bottom.
    pub v: f32,
    /// View depth, metres.
    pub depth: f32,
}

/// The frame's sprites on the screen, back to front as in its list, each faded as its run is.
pub fn prepare(frame: &Frame<'_>) -> Vec<ScreenSprite> {
    let mut on_screen = Vec::with_capacity(frame.list.sprites.len());
    for (sprites, fade) in frame.list.sprite_runs() {
        put_on_screen(frame, sprites, fade, &mut on_screen);
    }
    on_screen
}

/// The same of sprites by themselves, each as if it were drawn alone.
pub fn prepare_alone(frame: &Frame<'_>, sprites: SpritesAlone<'_>) -> Vec<ScreenSprite> {
    let mut on_screen = Vec::new();
    put_on_screen(frame, sprites.in_order(), 1.0, &mut on_screen);
    on_screen
}

fn put_on_screen(frame: &Frame<'_>, sprites: &[DrawSprite], fade: f32, on_screen: &mut Vec<ScreenSprite>) {
    let dome = DomeTables::new(&frame.background.dome);
    on_screen.par_extend(sprites.par_iter().with_min_len(256).map(|drawn| screen_sprite(frame, &dome, drawn, fade)));
}

fn screen_sprite(frame: &Frame<'_>, dome: &DomeTables, drawn: &DrawSprite, fade: f32) -> ScreenSprite {
    let view = &frame.view;
    let posed = frame.posed(drawn);
    let PosedSprite { sprite, facing, .. } = posed;
    let quad = posed.corners(drawn.center);

    let hazed = if frame.rules.hazes_fragments() {
        // Each fragment takes its own.
        0.0
    } else {
        haze_share(drawn.center.length(), frame.background.haze_length_m)
    };
    let haze_color = dome.horizon(drawn.center);
    let lit = quad.map(|corner| {
        let color = posed.light_at(corner - drawn.center).color();
        (color.rgb * (1.0 - hazed), color.a * fade)
    });

    // Within the picture: counted from afar, large terms would all but cancel at its pixels.
    let size = Vec2::new(view.width as f32, view.height as f32);
    let anchor = view.project(drawn.center).map_or(size * 0.5, Vec2::floor).clamp(Vec2::ZERO, size);
    let plane = Plane::new(view, anchor, drawn.center, facing.right.cross(facing.up));
    let outline = outline(view, &quad);
    let depth = view.depth_of_detail(drawn.center).max(NEAR_M);
    let texels_a_pixel = TILE_SIZE as f32 * view.pixel() / (sprite.width * sprite.height).sqrt();
    let mip = match frame.rules.filter {
        Filter::MipLevels => sharpened((texels_a_pixel * depth).log2() + FINER),
        Filter::FinestLevel => 0.0,
    };
    ScreenSprite {
        anchor,
        denominator: plane.denominator(),
        u: plane.coordinate(facing.right, sprite.width),
        v: plane.coordinate(-facing.up, sprite.height),
        depth: plane.offset as f32,
        half_depth_m: 0.5 * sprite.width.min(sprite.height),
        tile: sprite.tile,
        texels_a_pixel,
        mip,
        covered: covered(frame.atlas, sprite.tile, mip),
        corners: lit.map(|(rgb, a)| [rgb.r, rgb.g, rgb.b, a]),
        haze: (haze_color * hazed).to_array(),
        bounds: bounds(view, outline.as_ref()),
        outline,
    }
}

/// The quad's plane against the picture's rays. In f64: for small, far sprites the terms nearly cancel.
struct Plane {
    center: DVec3,
    normal: DVec3,
    /// n·c.
    offset: f64,
    /// The ray through the anchor, and its change a pixel to the right and down.
    rays: [DVec3; 3],
}

impl Plane {
    fn new(view: &View, anchor: Vec2, center: Vec3, towards_eye: Vec3) -> Self {
        let pixel = f64::from(view.pixel());
        let (right, up) = (view.right.as_dvec3(), view.up.as_dvec3());
        let across = (f64::from(anchor.x) - 0.5 * f64::from(view.width)) * pixel;
        let upwards = (0.5 * f64::from(view.height) - f64::from(anchor.y)) * pixel;
        let (center, normal) = (center.as_dvec3(), -towards_eye.as_dvec3());
        Self {
            center,
            normal,
            offset: normal.dot(center),
            rays: [view.forward.as_dvec3() + right * across + up * upwards, right * pixel, -up * pixel],
        }
    }

    fn linear(&self, f: impl Fn(DVec3) -> f64) -> Linear {
        let [at_anchor, dx, dy] = self.rays.map(|ray| f(ray) as f32);
        Linear { at_anchor, dx, dy }
    }

    fn denominator(&self) -> Linear {
        self.linear(|ray| ray.dot(self.normal))
    }

    /// (½ + (tρ − c)·axis / extent) · n·ρ.
    fn coordinate(&self, axis: Vec3, extent: f32) -> Linear {
        let axis = axis.as_dvec3() / f64::from(extent);
        let center = self.center.dot(axis);
        self.linear(|ray| ray.dot(self.normal) * (0.5 - center) + self.offset * ray.dot(axis))
    }
}

fn outline(view: &View, quad: &[Vec3; 4]) -> Option<[Vec2; 4]> {
    let [a, b, c, d] = quad.map(|corner| view.project(corner));
    Some([a?, b?, c?, d?])
}

/// Around the outline; for a quad that the near plane cuts, the whole picture.
fn bounds(view: &View, outline: Option<&[Vec2; 4]>) -> [f32; 4] {
    let whole = [0.0, 0.0, view.width as f32, view.height as f32];
    let Some(points) = outline else { return whole };
    let low = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
    let high = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
    [low.x.max(whole[0]), low.y.max(whole[1]), high.x.min(whole[2]), high.y.min(whole[3])]
}

impl ScreenSprite {
    /// Mip level at a view depth in metres for samples `spacing` pixels apart, not yet clamped: a little finer
    /// than log₂ of the texels between two samples.
    pub fn mip_at(&self, depth: f32, spacing: f32) -> f32 {
        (self.texels_a_pixel * depth * spacing).log2() + FINER
    }

    /// What the sprite shows at a pixel coordinate, with the view depth at which the ray meets it; none beside the
    /// quad, behind the near plane, or where it is clear. `mip_at` gives the level for a view depth.
    pub fn fragment(&self, atlas: &Atlas, x: f32, y: f32, mip_at: impl Fn(f32) -> f32) -> Option<(Premultiplied, f32)> {
        let Hit { u, v, depth } = self.hit(x, y)?;
        Some((self.shown(atlas, u, v, mip_at(depth))?, depth))
    }

    /// Where the ray through a pixel coordinate meets it; nowhere beside the quad or behind the near plane.
    #[inline]
    pub fn hit(&self, x: f32, y: f32) -> Option<Hit> {
        let (x, y) = (x - self.anchor.x, y - self.anchor.y);
        let denominator = self.denominator.at(x, y);
        if denominator <= 0.0 {
            return None;
        }
        let inverse = 1.0 / denominator;
        let (u, v, depth) = (self.u.at(x, y) * inverse, self.v.at(x, y) * inverse, self.depth * inverse);
        let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v) && depth >= NEAR_M;
        inside.then_some(Hit { u, v, depth })
    }

    /// One over the view depth of its plane at a pixel coordinate, 1/m: linear, and what fragments are ordered by. A plane
    /// through the eye shows nothing, and is 0 everywhere.
    #[inline]
    pub fn nearness(&self, x: f32, y: f32) -> f32 {
        self.denominator.at(x - self.anchor.x, y - self.anchor.y) * self.nearness_of_one()
    }

    /// The nearness for each unit of the denominator.
    #[inline]
    pub fn nearness_of_one(&self) -> f32 {
        if self.depth == 0.0 { 0.0 } else { 1.0 / self.depth }
    }

    /// What it shows there at a mip level; nothing where it is clear.
    #[inline]
    pub fn shown(&self, atlas: &Atlas, u: f32, v: f32, mip: f32) -> Option<Premultiplied> {
        let ([[r, g, b]], a) = self.shown_by(&[self.glow()], atlas, (u, v), mip)?;
        Some(Premultiplied { r, g, b, a })
    }

    /// The colour of each of these lights there, premultiplied, and the alpha.
    #[inline]
    pub fn shown_by<const G: usize>(
        &self,
        lights: &[Glow; G],
        atlas: &Atlas,
        (u, v): (f32, f32),
        mip: f32,
    ) -> Option<([[f32; 3]; G], f32)> {
        let texel = trilinear(atlas, self.tile, u, v, mip);
        if texel[3] == 0.0 {
            return None;
        }
        let between = |[top_left, top_right, bottom_right, bottom_left]: [f32; 4]| {
            let top = top_left + u * (top_right - top_left);
            let bottom = bottom_left + u * (bottom_right - bottom_left);
            top + v * (bottom - top)
        };
        let alpha = between(self.corners.map(|corner| corner[3]));
        let shown = lights.each_ref().map(|glow| {
            std::array::from_fn(|c| {
                alpha * (texel[c] * between(glow.corners.map(|corner| corner[c])) + texel[3] * glow.added[c])
            })
        });
        Some((shown, alpha * texel[3]))
    }

    /// All its light together.
    #[inline]
    pub fn glow(&self) -> Glow {
        Glow { corners: self.corners.map(|[r, g, b, _]| [r, g, b]), added: self.haze }
    }
}

/// How much finer than a sample's square a level's texels are, log₂: −½·log₂ 3.
///
/// What a sample is to show is the mean over its square, a box of width 1 with the variance 1/12. What it is given has
/// been through two filters: a texel of width s is a mean over its own square (s²/12), and lines between texels are a
/// tent (s²/6). Both together blur as much as the sample's square where s²/4 = 1/12, at s = 1/√3. With s = 1, as mip
/// levels are usually chosen, the blur is √3 times as wide; measured against the truth, ꟻLIP and opacity errors are
/// least near 1/√3, and nothing flickers more.
pub(crate) const FINER: f32 = -0.792_481_25;

/// A mip level nearer to a whole one: the nearest quarters go to it, the half between runs twice as fast. Half of all
/// sprites then need one level instead of two, and still nothing jumps.
fn sharpened(mip: f32) -> f32 {
    let level = mip.floor();
    level + (2.0 * (mip - level) - 0.5).clamp(0.0, 1.0)
}

/// What a tile covers at the two mip levels around `mip`.
fn covered(atlas: &Atlas, tile: u8, mip: f32) -> [[f32; 2]; 4] {
    let level = mip.clamp(0.0, (MIP_LEVELS - 1) as f32) as usize;
    let [fine, coarse] = [level, level + 1].map(|level| &atlas.level(tile.into(), level).covered);
    std::array::from_fn(|i| [fine[i][0].min(coarse[i][0]), fine[i][1].max(coarse[i][1])])
}

/// Texels of a tile at (u, v), linear within and between mip levels; `mip` is clamped to those there are.
pub fn trilinear(atlas: &Atlas, tile: u8, u: f32, v: f32, mip: f32) -> [f32; 4] {
    let mip = mip.clamp(0.0, (MIP_LEVELS - 1) as f32);
    let level = mip as usize;
    let between = mip - level as f32;
    let fine = bilinear(atlas.level(tile.into(), level), u, v);
    if between == 0.0 {
        return fine;
    }
    let coarse = bilinear(atlas.level(tile.into(), level + 1), u, v);
    std::array::from_fn(|c| fine[c] + between * (coarse[c] - fine[c]))
}

/// Four texels around (u, v), those beyond the edge as at the edge: clear.
fn bilinear(level: &TileLevel, u: f32, v: f32) -> [f32; 4] {
    let last = level.size as f32 - 1.0;
    let place = |t: f32| (t * level.size as f32 - 0.5).clamp(0.0, last);
    let (x, y) = (place(u), place(v));
    let (column, row) = ((x as usize).min(level.size - 2), (y as usize).min(level.size - 2));
    let (fx, fy) = (x - column as f32, y - row as f32);
    let at = |dx: usize, dy: usize| level.texels[(row + dy) * level.size + column + dx].map(f32::from);
    let (a, b, c, d) = (at(0, 0), at(1, 0), at(0, 1), at(1, 1));
    std::array::from_fn(|i| {
        let top = a[i] + fx * (b[i] - a[i]);
        let bottom = c[i] + fx * (d[i] - c[i]);
        (top + fy * (bottom - top)) * (1.0 / 255.0)
    })
}
