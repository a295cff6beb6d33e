//! A cloud model of Flight Simulator 2004 and X, `NAME.cld`: every value as it stands in the file, so that what was read is
//! written again byte for byte.
//!
//! Little-endian: u32 0x238C; u32 number of sprites; the texture's name, ended by a zero within 128 bytes; u32 number of
//! colour levels, each { f32 level, u32 colour }; and 44 bytes a sprite: { f32 `position[3]`; i16 shading number, group
//! number, width from and to, length from and to, rotation from and to; f32 `uv[2][2]` }.
//!
//! Source: the order and types by which the editor of Amazon Lumberyard reads such files ("MS FS (*.cld)" in its
//! CloudGroup.cpp). Known by that reader alone, as **no sample file was at hand**: which way the axes run, that the second
//! of the two texture coordinates is measured from the sheet's bottom, and that rotations are degrees. Not known: what
//! shading and group numbers mean, how a colour's bytes are ordered, what a level is measured in, and the unit of lengths.
//! That reader multiplies lengths by a thousandth for an engine of metres; but 16 bits of millimetres end at 33 m, and the
//! simulator's sprites are some hundred metres wide (W). `crate::exchange` says how all this is taken.

use super::Misread;

/// The largest file, bytes.
pub const MAX_BYTES: usize = 16 << 20;

const MAGIC: u32 = 0x238C;
/// With the zero at its end.
const TEXTURE_BYTES: usize = 128;
const LEVEL_BYTES: usize = 8;
const SPRITE_BYTES: usize = 44;

/// All that a file says.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cld {
    /// The name of the sheet of tiles, without the zero at its end; of an unknown encoding.
    pub texture: Vec<u8>,
    /// Colours over the height.
    pub levels: Vec<CldLevel>,
    /// The sprites.
    pub sprites: Vec<CldSprite>,
    /// What stands behind the last sprite, if anything does.
    pub rest: Vec<u8>,
}

/// A colour at a height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CldLevel {
    /// Where it is.
    pub level: f32,
    /// Four bytes of colour.
    pub color: u32,
}

/// A sprite, or a range of sprites to draw one from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CldSprite {
    /// x to the right, y up, z forward.
    pub position: [f32; 3],
    /// Perhaps of the lump by which it is shaded.
    pub shading: i16,
    /// Perhaps of the box that it was made in.
    pub group: i16,
    /// From, to.
    pub width: [i16; 2],
    /// From, to: of the other side.
    pub length: [i16; 2],
    /// From, to, degrees.
    pub rotation_deg: [i16; 2],
    /// Of two opposite corners of its tile; the second of each from the sheet's bottom.
    pub uv: [[f32; 2]; 2],
}

/// Reads a file.
///
/// # Errors
/// If it is none, is cut off, or has a number that is none.
pub fn read(bytes: &[u8]) -> Result<Cld, Misread> {
    let mut reader = Reader { bytes, at: 0 };
    match reader.u32("its first number")? {
        MAGIC => {}
        swapped if swapped == MAGIC.swap_bytes() => {
            return Err(Misread::new("byte 0", "its bytes are in the order of another kind of machine: big-endian"));
        }
        other => {
            return Err(Misread::new("byte 0", format!("it begins with {other:#x}; a cloud begins with {MAGIC:#x}")));
        }
    }
    let sprite_count = reader.u32("the number of sprites")?;
    let texture = reader.texture()?;
    let level_count = reader.u32("the number of colour levels")?;
    reader.check_room(level_count, LEVEL_BYTES, "colour levels")?;
    let levels = (0..level_count).map(|_| reader.level()).collect::<Result<_, _>>()?;
    reader.check_room(sprite_count, SPRITE_BYTES, "sprites")?;
    let sprites = (0..sprite_count).map(|_| reader.sprite()).collect::<Result<_, _>>()?;
    Ok(Cld { texture, levels, sprites, rest: bytes[reader.at..].to_vec() })
}

/// Whether bytes begin as such a file does, in either order.
pub fn looks_like(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC.to_le_bytes()) || bytes.starts_with(&MAGIC.to_be_bytes())
}

/// The file's bytes. A texture's name ends where a zero stands in it, and at 127 bytes.
pub fn write(cld: &Cld) -> Vec<u8> {
    let Cld { texture, levels, sprites, rest } = cld;
    let mut out = Vec::with_capacity(16 + TEXTURE_BYTES + levels.len() * LEVEL_BYTES + sprites.len() * SPRITE_BYTES);
    out.extend(MAGIC.to_le_bytes());
    out.extend((sprites.len() as u32).to_le_bytes());
    out.extend(texture.iter().take(TEXTURE_BYTES - 1).take_while(|byte| **byte != 0));
    out.push(0);
    out.extend((levels.len() as u32).to_le_bytes());
    for CldLevel { level, color } in levels {
        out.extend(level.to_le_bytes());
        out.extend(color.to_le_bytes());
    }
    for sprite in sprites {
        out.extend(sprite.position.iter().flat_map(|number| number.to_le_bytes()));
        let CldSprite { shading, group, width, length, rotation_deg, uv, .. } = sprite;
        let shorts = [*shading, *group].into_iter().chain([width, length, rotation_deg].into_iter().flatten().copied());
        out.extend(shorts.flat_map(i16::to_le_bytes));
        out.extend(uv.iter().flatten().flat_map(|number| number.to_le_bytes()));
    }
    out.extend(rest);
    out
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self, what: &str) -> Result<[u8; N], Misread> {
        let found = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let found = found.ok_or_else(|| Misread::new(format!("byte {}", self.at), format!("it ends before {what}")))?;
        self.at += N;
        Ok(*found)
    }

    fn u32(&mut self, what: &str) -> Result<u32, Misread> {
        self.take(what).map(u32::from_le_bytes)
    }

    fn i16(&mut self, what: &str) -> Result<i16, Misread> {
        self.take(what).map(i16::from_le_bytes)
    }

    fn f32(&mut self, what: &str) -> Result<f32, Misread> {
        let at = self.at;
        let number = self.take(what).map(f32::from_le_bytes)?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(Misread::new(format!("byte {at}"), format!("{what} is no number")))
        }
    }

    fn shorts(&mut self, what: &str) -> Result<[i16; 2], Misread> {
        Ok([self.i16(what)?, self.i16(what)?])
    }

    /// Known before memory is taken for them.
    fn check_room(&self, count: u32, bytes_each: usize, what: &str) -> Result<(), Misread> {
        let room = (self.bytes.len() - self.at) / bytes_each;
        if count as usize <= room {
            return Ok(());
        }
        let message = format!("it tells of {count} {what}, and has room for {room}");
        Err(Misread::new(format!("byte {}", self.at), message))
    }

    fn texture(&mut self) -> Result<Vec<u8>, Misread> {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().take(TEXTURE_BYTES).position(|byte| *byte == 0);
        let end = end.ok_or_else(|| {
            let message = format!("the texture's name has no end within {TEXTURE_BYTES} bytes");
            Misread::new(format!("byte {}", self.at), message)
        })?;
        self.at += end + 1;
        Ok(rest[..end].to_vec())
    }

    fn level(&mut self) -> Result<CldLevel, Misread> {
        Ok(CldLevel { level: self.f32("a colour level")?, color: self.u32("a level's colour")? })
    }

    fn sprite(&mut self) -> Result<CldSprite, Misread> {
        let mut coordinate = |what| self.f32(what);
        let position = [coordinate("a sprite's x")?, coordinate("a sprite's y")?, coordinate("a sprite's z")?];
        let (shading, group) = (self.i16("a sprite's shading number")?, self.i16("a sprite's group number")?);
        let (width, length) = (self.shorts("a sprite's width")?, self.shorts("a sprite's length")?);
        let rotation_deg = self.shorts("a sprite's rotation")?;
        let mut corner = || Ok([self.f32("a sprite's u")?, self.f32("a sprite's v")?]);
        Ok(CldSprite { position, shading, group, width, length, rotation_deg, uv: [corner()?, corner()?] })
    }
}
