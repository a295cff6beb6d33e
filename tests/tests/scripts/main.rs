//! Scripts through their own door: plugins read, run and refused. Needs no display.

#![allow(clippy::panic, reason = "a failing test says what it found")]

mod dice;
mod hostile;
mod library;
mod manual;
mod plugins;
mod reach;
mod reading;

use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Scene;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Held by who measures time, and by who needs all cores for long.
static TURN: Mutex<()> = Mutex::new(());

fn turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A scene with a cloud, a camera and a ground.
fn scene() -> Scene {
    Preset::ALL[0].scene()
}
