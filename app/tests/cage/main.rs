//! Plugins in a process of their own: the real program as their host, and hosts that misbehave.
//!
//! `tests/hostile/` is run through both. What only a process can hold lies in `tests/hostile/caged/`.

#![allow(clippy::panic, reason = "a failing test says what it found")]

#[cfg(unix)]
mod fake_hosts;
mod hostile;
mod sound;
#[cfg(target_os = "linux")]
mod watched;

use cloudwright::scripting::{Host, Request};
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::{Outcome, Patience, Plugin, ScriptError};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Held by each test: they look at the children of this program, and at how long these take.
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A scene with a cloud, a camera and a ground.
fn scene() -> Scene {
    Preset::ALL[0].scene()
}

/// The program itself.
fn host() -> Host {
    Host::at(env!("CARGO_BIN_EXE_cloudwright"))
}

/// A plugin of that kind whose `run` has that body.
fn plugin(kind: &str, body: &str) -> Plugin {
    let head = format!(r#"const PLUGIN = #{{ name: "Test", kind: "{kind}", sentence: "For tests." }};"#);
    Plugin::read(&format!("{head}\nfn run(p) {{\n{body}\n}}")).expect("a plugin")
}

/// It is run by `host` on the usual scene.
fn run_by(host: &Host, plugin: &Plugin, patience: &Patience) -> Result<Outcome, ScriptError> {
    let scene = scene();
    host.run(Request { plugin, scene: &scene, selected: &[], values: &plugin.values() }, patience)
}
