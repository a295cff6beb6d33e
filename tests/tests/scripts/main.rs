//! Scripts through their own door: plugins read, run and refused. Needs no display.

#![allow(clippy::panic, reason = "a failing test says what it found")]

mod hostile;
mod library;
mod plugins;

use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Scene;

/// A scene with a cloud, a camera and a ground.
fn scene() -> Scene {
    Preset::ALL[0].scene()
}
