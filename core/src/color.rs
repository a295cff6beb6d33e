//! Colours: linear light, three types so that they can't be mixed up.
//!
//! [`Rgb`] and [`Rgba`] are straight (documents, light); [`Premultiplied`] is what pixels are blended in.
//! sRGB exists only at the edge, in [`srgb_from_linear`] and [`linear_from_srgb`].
//! The idea of a type per encoding is tiny-skia's (src/color.rs).

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::ops::{Add, Mul};

/// Linear RGB; 1 is the display's white before exposure, values above 1 are allowed. In files `[r, g, b]`.
#[derive(Debug, Clone, Copy, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

/// Linear RGB with straight alpha in 0 to 1. In files `[r, g, b, a]`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rgba {
    /// The colour, not multiplied by `a`.
    pub rgb: Rgb,
    /// Opacity, 0 to 1.
    pub a: f32,
}

/// Linear RGB already multiplied by its alpha: the only kind that is blended or filtered.
#[derive(Debug, Clone, Copy, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Premultiplied {
    /// Red times alpha.
    pub r: f32,
    /// Green times alpha.
    pub g: f32,
    /// Blue times alpha.
    pub b: f32,
    /// Opacity, 0 to 1.
    pub a: f32,
}

impl Rgb {
    /// How bright it is to an eye, 1 for white: the sum of ITU-R BT.709, whose primaries are sRGB's.
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// Black.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);

    /// A colour from its three linear parts.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// The same value in all three channels.
    pub const fn grey(value: f32) -> Self {
        Self::new(value, value, value)
    }

    /// As an array, red first.
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// `self` at `t` = 0, `other` at `t` = 1.
    pub fn mix(self, other: Self, t: f32) -> Self {
        self * (1.0 - t) + other * t
    }
}

impl Rgba {
    /// A colour and its opacity.
    pub const fn new(r: f32, g: f32, b: f32, a: f32) -> Self {
        Self { rgb: Rgb::new(r, g, b), a }
    }

    /// As an array, red first, alpha last.
    pub const fn to_array(self) -> [f32; 4] {
        [self.rgb.r, self.rgb.g, self.rgb.b, self.a]
    }

    /// `self` at `t` = 0, `other` at `t` = 1, alpha like the rest.
    pub fn mix(self, other: Self, t: f32) -> Self {
        Self { rgb: self.rgb.mix(other.rgb, t), a: self.a * (1.0 - t) + other.a * t }
    }
}

impl Premultiplied {
    /// Nothing: what a layer of clouds starts with.
    pub const CLEAR: Self = Self { r: 0.0, g: 0.0, b: 0.0, a: 0.0 };

    /// `self` at `t` = 0, `other` at `t` = 1.
    pub fn mix(self, other: Self, t: f32) -> Self {
        let mix = |a: f32, b: f32| a * (1.0 - t) + b * t;
        Self { r: mix(self.r, other.r), g: mix(self.g, other.g), b: mix(self.b, other.b), a: mix(self.a, other.a) }
    }

    /// `self` over an opaque background.
    pub fn over(self, background: Rgb) -> Rgb {
        Rgb::new(self.r, self.g, self.b) + background * (1.0 - self.a)
    }
}

impl Add for Premultiplied {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { r: self.r + o.r, g: self.g + o.g, b: self.b + o.b, a: self.a + o.a }
    }
}

impl Mul<f32> for Premultiplied {
    type Output = Self;
    fn mul(self, k: f32) -> Self {
        Self { r: self.r * k, g: self.g * k, b: self.b * k, a: self.a * k }
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    fn mul(self, s: f32) -> Self {
        Self::new(self.r * s, self.g * s, self.b * s)
    }
}

/// sRGB's transfer function (IEC 61966-2-1) for a value in 0 to 1.
pub fn srgb_from_linear(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::powf(linear, 1.0 / 2.4) - 0.055 }
}

/// The inverse of [`srgb_from_linear`].
pub fn linear_from_srgb(srgb: f32) -> f32 {
    if srgb <= 0.040_45 { srgb / 12.92 } else { libm::powf((srgb + 0.055) / 1.055, 2.4) }
}

/// The f64 whose shortest decimal is that of `value`, so that a file says 0.3 and not 0.30000001192092896.
pub(crate) fn shortest_f64(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

macro_rules! saved_as_array {
    ($type:ident, $count:literal, $from:expr) => {
        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                self.to_array().map(shortest_f64).serialize(serializer)
            }
        }
        impl<'de> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <[f32; $count]>::deserialize(deserializer).map($from)
            }
        }
        impl JsonSchema for $type {
            fn schema_name() -> Cow<'static, str> {
                stringify!($type).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "array", "items": { "type": "number" }, "minItems": $count, "maxItems": $count })
            }
        }
    };
}
saved_as_array!(Rgb, 3, |[r, g, b]| Rgb::new(r, g, b));
saved_as_array!(Rgba, 4, |[r, g, b, a]| Rgba::new(r, g, b, a));

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_there_and_back() {
        for i in 0..=255_u8 {
            let x = f32::from(i) / 255.0;
            // Half of a 16-bit step: far below what an 8-bit picture can hold.
            assert!((srgb_from_linear(linear_from_srgb(x)) - x).abs() < 1.0 / 131_072.0, "{i}");
        }
    }

    #[test]
    fn a_file_says_what_the_artist_typed() {
        assert_eq!(serde_json::to_string(&Rgb::new(0.3, 0.34, 1.06)).ok().as_deref(), Some("[0.3,0.34,1.06]"));
    }
}
