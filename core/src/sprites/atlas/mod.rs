//! The sheet of sixteen sprite tiles, cut into layers with mip levels.
//!
//! A sheet is a PNG of 4 × 4 tiles, row by row from the top left; its colours are linear shares of the light, not
//! sRGB. Every layer is premultiplied and has a border of alpha 0 at each level, so that tiles neither bleed into one
//! another nor rim when filtered. Levels go down to 8 texels: below that a sprite is a dot.

mod footprints;

pub use footprints::{FootprintTable, Footprints, LEVEL_START, TABLE};

use crate::version::Version;
use std::sync::{Arc, LazyLock, OnceLock};

/// Tiles on a sheet.
pub const TILES: usize = 16;
/// Side of a tile at level 0, texels.
pub const TILE_SIZE: usize = 128;
/// Sides 128, 64, 32, 16, 8.
pub const MIP_LEVELS: usize = 5;
const SHEET_SIZE: usize = 4 * TILE_SIZE;
/// What every PNG begins with.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Sixteen tiles with their mip levels.
#[derive(Debug, Clone)]
pub struct Atlas {
    levels: Vec<TileLevel>,
    grey: bool,
    mean_opacities: [f32; TILES],
    spreads: [f32; TILES],
    version: Version,
    footprints: OnceLock<Arc<Footprints>>,
}

/// One tile at one mip level.
#[derive(Debug, Clone, PartialEq)]
pub struct TileLevel {
    /// Side, texels.
    pub size: usize,
    /// Premultiplied RGBA, `size` × `size`, top row first.
    pub texels: Vec<[u8; 4]>,
    /// Least and greatest u, v, u + v and u − v: filtered texels beyond are clear.
    pub covered: [[f32; 2]; 4],
}

/// Why a picture can't be an atlas.
#[derive(Debug, thiserror::Error)]
pub enum AtlasError {
    /// Another kind of file.
    #[error("it is not a PNG")]
    NotPng,
    /// It ends too early.
    #[error("its PNG is cut off")]
    CutOff,
    /// What stands in it can't be.
    #[error("its PNG is broken; save it again")]
    Broken,
    /// Not 512 × 512.
    #[error("it measures {width} × {height}; an atlas is 512 × 512: four by four tiles of 128")]
    Size {
        /// Found, pixels.
        width: u32,
        /// Found, pixels.
        height: u32,
    },
    /// Palette or greyscale without alpha.
    #[error("it has no alpha channel; save it as RGBA, 8 bits a channel")]
    NoAlpha,
}

static BUILT_IN: LazyLock<Atlas> = LazyLock::new(|| {
    // The sheet is checked in and read by a test of its own; an unreadable one would show as clear sky.
    Atlas::from_png(include_bytes!("../../../../assets/atlas/clouds.png")).unwrap_or_else(|_| Atlas::from_sheet(&[]))
});

/// The library's own words are for those who write PNG files by hand.
impl From<png::DecodingError> for AtlasError {
    fn from(error: png::DecodingError) -> Self {
        match error {
            png::DecodingError::IoError(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => Self::CutOff,
            _ => Self::Broken,
        }
    }
}

impl Atlas {
    /// The sheet that ships with Cloudwright (assets/atlas/clouds.png).
    pub fn built_in() -> &'static Self {
        &BUILT_IN
    }

    /// Reads a 512 × 512 PNG with alpha.
    ///
    /// # Errors
    /// If it is no PNG, has another size, or no alpha.
    pub fn from_png(bytes: &[u8]) -> Result<Self, AtlasError> {
        if !bytes.starts_with(SIGNATURE) {
            return Err(AtlasError::NotPng);
        }
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
        let mut reader = decoder.read_info()?;
        let (width, height) = reader.info().size();
        if (width as usize, height as usize) != (SHEET_SIZE, SHEET_SIZE) {
            return Err(AtlasError::Size { width, height });
        }
        let (color, _) = reader.output_color_type();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap_or(0)];
        reader.next_frame(&mut bytes)?;
        let straight: Vec<[u8; 4]> = match color {
            png::ColorType::Rgba => bytes.as_chunks::<4>().0.to_vec(),
            png::ColorType::GrayscaleAlpha => bytes.as_chunks::<2>().0.iter().map(|&[l, a]| [l, l, l, a]).collect(),
            _ => return Err(AtlasError::NoAlpha),
        };
        Ok(Self::from_sheet(&straight))
    }

    /// From straight RGBA texels, 512 × 512, top row first; what is missing is clear.
    pub fn from_sheet(straight: &[[u8; 4]]) -> Self {
        let texel = |tile: usize, x: usize, y: usize| -> [f32; 4] {
            let row = (tile / 4) * TILE_SIZE + y;
            let column = (tile % 4) * TILE_SIZE + x;
            let [r, g, b, a] =
                straight.get(row * SHEET_SIZE + column).copied().unwrap_or_default().map(|c| f32::from(c) / 255.0);
            [r * a, g * a, b * a, a]
        };
        let mut levels = Vec::with_capacity(TILES * MIP_LEVELS);
        for tile in 0..TILES {
            let mut plane = Plane {
                size: TILE_SIZE,
                texels: (0..TILE_SIZE * TILE_SIZE).map(|i| texel(tile, i % TILE_SIZE, i / TILE_SIZE)).collect(),
            };
            for _ in 0..MIP_LEVELS {
                levels.push(plane.bordered().quantized());
                plane = plane.halved();
            }
        }
        let grey = levels.iter().flat_map(|level| &level.texels).all(|[r, g, b, _]| r == g && g == b);
        let mean_opacities = std::array::from_fn(|tile| {
            let texels = &levels[tile * MIP_LEVELS + MIP_LEVELS - 1].texels;
            texels.iter().map(|texel| f32::from(texel[3])).sum::<f32>() / (255.0 * texels.len() as f32)
        });
        let spreads = std::array::from_fn(|tile| spread(&levels[tile * MIP_LEVELS].texels, TILE_SIZE));
        Self { levels, grey, mean_opacities, spreads, version: Version::fresh(), footprints: OnceLock::new() }
    }

    /// One tile (0 to 15) at one mip level (0 to [`MIP_LEVELS`] − 1).
    pub fn level(&self, tile: usize, mip: usize) -> &TileLevel {
        &self.levels[tile.min(TILES - 1) * MIP_LEVELS + mip.min(MIP_LEVELS - 1)]
    }

    /// The same texels as the fast CPU renderer reads them, made on first use.
    pub fn footprints(&self) -> &Footprints {
        self.footprints.get_or_init(|| Arc::new(Footprints::new(self)))
    }

    /// Mean alpha of a tile, 0 to 1.
    pub fn mean_opacity(&self, tile: usize) -> f32 {
        self.mean_opacities[tile.min(TILES - 1)]
    }

    /// How far a tile's alpha is from its middle, root mean square along an axis, in halves of its side; 0 if it is clear.
    pub fn spread(&self, tile: usize) -> f32 {
        self.spreads[tile.min(TILES - 1)]
    }

    /// Tells this sheet from every other.
    pub fn version(&self) -> Version {
        self.version
    }

    /// Whether all texels are grey: then one channel of colour is enough.
    pub fn is_grey(&self) -> bool {
        self.grey
    }
}

/// A tile's level in f32, premultiplied, before it is rounded to bytes.
struct Plane {
    size: usize,
    texels: Vec<[f32; 4]>,
}

impl Plane {
    /// Half the side, each texel the mean of four.
    fn halved(&self) -> Self {
        let size = self.size / 2;
        let mean = |i: usize| {
            let (x, y) = (2 * (i % size), 2 * (i / size));
            let at = |dx: usize, dy: usize| self.texels[(y + dy) * self.size + x + dx];
            std::array::from_fn(|c| 0.25 * (at(0, 0)[c] + at(1, 0)[c] + at(0, 1)[c] + at(1, 1)[c]))
        };
        Self { size, texels: (0..size * size).map(mean).collect() }
    }

    /// The outermost ring made clear; what it held goes to the rest, or far clouds would thin out with each level.
    fn bordered(&self) -> Self {
        let last = self.size - 1;
        let in_ring = |i: usize| [0, last].contains(&(i % self.size)) || [0, last].contains(&(i / self.size));
        let sum = |keep: &dyn Fn(usize) -> bool| -> f32 {
            self.texels.iter().enumerate().filter(|(i, _)| keep(*i)).map(|(_, t)| t[3]).sum()
        };
        let inside = sum(&|i| !in_ring(i));
        let gain = if inside > 0.0 { sum(&|_| true) / inside } else { 1.0 };
        let texel = |(i, t): (usize, &[f32; 4])| {
            if in_ring(i) {
                return [0.0; 4];
            }
            let gain = if t[3] > 0.0 { gain.min(1.0 / t[3]) } else { 1.0 };
            t.map(|c| c * gain)
        };
        Self { size: self.size, texels: self.texels.iter().enumerate().map(texel).collect() }
    }

    fn quantized(&self) -> TileLevel {
        let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let texels: Vec<[u8; 4]> = self.texels.iter().map(|t| t.map(byte)).collect();
        TileLevel { size: self.size, covered: covered(self.size, &texels), texels }
    }
}

/// The octagon around the texels that are not clear, with the reach of a bilinear filter: half a texel before a texel's
/// edges and half a texel behind. A clear tile covers a point.
fn covered(size: usize, texels: &[[u8; 4]]) -> [[f32; 2]; 4] {
    let shown = || (0..texels.len()).filter(|i| texels[*i] != [0; 4]).map(|i| ((i % size) as f32, (i / size) as f32));
    let range = |along: fn((f32, f32)) -> f32, before: f32, after: f32| {
        let ends = shown().map(along).map(|at| (at, at)).reduce(|(low, high), (at, _)| (low.min(at), high.max(at)));
        ends.map_or([0.0; 2], |(low, high)| [(low - before) / size as f32, (high + after) / size as f32])
    };
    [
        range(|(x, _)| x, 0.5, 1.5),
        range(|(_, y)| y, 0.5, 1.5),
        range(|(x, y)| x + y, 1.0, 3.0),
        range(|(x, y)| x - y, 2.0, 2.0),
    ]
}

/// See [`Atlas::spread`].
fn spread(texels: &[[u8; 4]], size: usize) -> f32 {
    let off = |at: usize| (at as f32 + 0.5) * 2.0 / size as f32 - 1.0;
    let (mut squares, mut alphas) = (0.0, 0.0);
    for (at, texel) in texels.iter().enumerate() {
        let (x, y, alpha) = (off(at % size), off(at / size), f32::from(texel[3]));
        squares += alpha * 0.5 * (x * x + y * y);
        alphas += alpha;
    }
    if alphas > 0.0 { (squares / alphas).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn built_in_sheet_is_whole() {
        let atlas = Atlas::from_png(include_bytes!("../../../../assets/atlas/clouds.png")).expect("the shipped atlas");
        assert!(atlas.is_grey());
        for tile in 0..TILES {
            for mip in 0..MIP_LEVELS {
                let level = atlas.level(tile, mip);
                assert_eq!(level.size, TILE_SIZE >> mip);
                let last = level.size - 1;
                for (i, texel) in level.texels.iter().enumerate() {
                    let (x, y) = (i % level.size, i / level.size);
                    if x == 0 || y == 0 || x == last || y == last {
                        assert_eq!(*texel, [0; 4], "tile {tile}, level {mip}: border at {x}, {y}");
                    }
                    assert!(texel[0] <= texel[3], "premultiplied: tile {tile}, level {mip}");
                }
            }
        }
    }

    #[test]
    fn a_mip_level_keeps_the_tiles_opacity() {
        // A disc of radius 50 texels, alpha 0.5: its mean alpha must survive borders and halving (within byte rounding).
        let mut sheet = vec![[0_u8; 4]; SHEET_SIZE * SHEET_SIZE];
        for y in 0..TILE_SIZE {
            for x in 0..TILE_SIZE {
                let (dx, dy) = (x as f32 - 63.5, y as f32 - 63.5);
                if dx * dx + dy * dy < 2500.0 {
                    sheet[y * SHEET_SIZE + x] = [255, 255, 255, 128];
                }
            }
        }
        let atlas = Atlas::from_sheet(&sheet);
        let mean = |mip| {
            let level = atlas.level(0, mip);
            level.texels.iter().map(|t| f32::from(t[3])).sum::<f32>() / level.texels.len() as f32 / 255.0
        };
        for mip in 1..MIP_LEVELS {
            assert!((mean(mip) - mean(0)).abs() <= 0.5 / 255.0, "level {mip}: {} for {}", mean(mip), mean(0));
        }
    }

    #[test]
    fn other_pictures_are_refused() {
        assert!(matches!(Atlas::from_png(b"not a png"), Err(AtlasError::NotPng)));
        let sheet = include_bytes!("../../../../assets/atlas/clouds.png");
        for length in [8, 20, 40, sheet.len() / 2] {
            assert!(matches!(Atlas::from_png(&sheet[..length]), Err(AtlasError::CutOff)), "{length}");
        }
        // A chunk of another kind where the head must be, and a head whose checksum is wrong.
        for (at, byte) in [(12, b'i'), (12, 0x1b), (30, 1)] {
            let mut broken = sheet.to_vec();
            broken[at] = byte;
            assert!(matches!(Atlas::from_png(&broken), Err(AtlasError::Broken)), "{at}");
        }
    }
}
