//! The program: an editor window and a command line over one library of clouds.
//!
//! The only place with a window, files and a clock. [`cli`] is one file a subcommand; [`editor`] is the window's frame
//! in order, above its panels and viewport, which share what is in [`state`]; [`storage`] is the only file access,
//! [`opening`] and [`saving`] what both make of a scene file; [`plugins`] which plugins there are, and [`scripting`] has
//! them do what they do; [`chart`] turns measured methods into a page to read; `renderer` chooses between GPU and CPU.

pub mod chart;
pub mod cli;
pub mod command;
pub mod editor;
pub mod exchange;
mod manual;
pub mod opening;
mod panel;
mod picture_hdr;
pub mod picture_kind;
mod picture_png;
pub mod plugins;
pub mod renderer;
mod rendering;
pub mod reports;
pub mod saving;
pub mod scripting;
mod signals;
mod starter;
pub mod state;
pub mod storage;
mod theme;
pub mod thumbnail;
pub mod units;
mod viewport;
pub mod visible;
mod widget;
pub mod worker;

pub use widget::{category_choice, preset_choice};
