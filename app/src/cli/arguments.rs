//! How single values of the command line are read.

use cloudwright_core::method::{self, METHODS, Method};
use cloudwright_core::reported::SPEEDS;
use cloudwright_core::spelling::closest;

/// Seconds of a scene's clock.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    let is_sound = |seconds: &f64| (0.0..=1e6).contains(seconds);
    text.parse().ok().filter(is_sound).ok_or_else(|| "write seconds, 0 to 1000000, such as 12.5".into())
}

/// How much faster than life reports follow one another.
pub(super) fn report_speed(text: &str) -> Result<f64, String> {
    let is_sound = |speed: &f64| SPEEDS.contains(speed);
    text.parse().ok().filter(is_sound).ok_or_else(|| "write a number from 1 to 86400, such as 600".into())
}

/// A share of a whole, or an error on such a scale.
pub(super) fn share(text: &str) -> Result<f64, String> {
    let is_sound = |share: &f64| (0.0..=1.0).contains(share);
    text.parse().ok().filter(is_sound).ok_or_else(|| "write a number from 0 to 1, such as 0.02".into())
}

/// `WIDTHxHEIGHT` in pixels.
pub(super) fn picture_size(text: &str) -> Result<[u32; 2], String> {
    const MAX: u32 = 16_384;
    let read = |part: &str| part.parse().ok().filter(|n| (1..=MAX).contains(n));
    text.split_once(['x', '×'])
        .and_then(|(width, height)| Some([read(width)?, read(height)?]))
        .ok_or_else(|| format!("write width x height in pixels, 1x1 to {MAX}x{MAX}, such as 1280x720"))
}

/// Samples a pixel, as the side of their square.
pub(super) fn samples_side(text: &str) -> Result<u32, String> {
    let samples: Option<u32> = text.parse().ok();
    (1..=8)
        .find(|side| samples == Some(side * side))
        .ok_or_else(|| "use a square number: 1, 4, 9, 16, 25, 36, 49 or 64".into())
}

/// A mean FLIP.
pub(super) fn tolerance(text: &str) -> Result<f32, String> {
    let flip: Option<f32> = text.trim().parse().ok();
    flip.filter(|flip| (0.0..=1.0).contains(flip)).ok_or_else(|| "use a number from 0 to 1: 0.01 is hardly seen".into())
}

/// A way to draw, by its name.
pub(super) fn method(text: &str) -> Result<&'static Method, String> {
    let name = text.trim();
    method::named(name).ok_or_else(|| {
        let names: Vec<&str> = METHODS.iter().map(|method| method.name).collect();
        format!("there is no such method; {}the methods are {}", did_you_mean(name, &names), names.join(", "))
    })
}

/// A question to stand before a list of all `names`; nothing if none of them is like `unknown`.
pub(super) fn did_you_mean(unknown: &str, names: &[&str]) -> String {
    closest(unknown, names.iter().copied()).map(|name| format!("did you mean `{name}`? ")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values() {
        assert_eq!(picture_size("1280x720"), Ok([1280, 720]));
        for bad in ["0x1", "1x0", "16385x1", "1280", "x", "-1x5", "1e3x5", "99999999999x1"] {
            assert!(picture_size(bad).is_err(), "{bad}");
        }
        assert_eq!(seconds("12.5"), Ok(12.5));
        for bad in ["-1", "NaN", "inf", "1e7", "soon", ""] {
            assert!(seconds(bad).is_err(), "{bad}");
        }
        assert_eq!(share("0.02"), Ok(0.02));
        for bad in ["-0.1", "1.1", "NaN", "2 %", ""] {
            assert!(share(bad).is_err(), "{bad}");
        }
        assert_eq!(method(" half").map(|method| method.name), Ok("half"));
        for (bad, wanted) in [("turth", "did you mean `truth`?"), ("", "truth, fast"), ("Fast", "the methods are")] {
            assert!(method(bad).is_err_and(|said| said.contains(wanted)), "{bad}");
        }
        assert_eq!(samples_side("16"), Ok(4));
        for bad in ["0", "2", "15", "81", "-4", "four"] {
            assert!(samples_side(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn tolerances() {
        assert_eq!(tolerance("0.02"), Ok(0.02));
        assert_eq!(tolerance("0"), Ok(0.0));
        for bad in ["-0.01", "1.5", "NaN", "inf", "little", ""] {
            assert!(tolerance(bad).is_err(), "{bad}");
        }
    }
}
