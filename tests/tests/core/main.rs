//! The core through its own doors: scenes in, sprites, files and pictures out. Needs no GPU and no display.

#![allow(clippy::panic, reason = "a failing test says what it found")]

mod architecture;
mod assets;
mod baked;
mod density;
mod derived;
mod draw_list;
mod exchange;
mod export;
mod filter;
mod fit_light;
mod flight;
mod forecasts;
mod fragment_order;
mod layers;
mod measure;
mod merged;
mod method;
mod model_glb;
mod models;
mod night;
mod panorama;
mod parts;
mod property;
mod raster;
mod reports;
mod scene_file;
mod shading;
mod shadows;
mod skies;
mod sprites;
mod suite;
mod thin;
mod timeline;
mod traced;
mod truth;
mod weather;
mod wind;
