//! The core through its own doors: scenes in, sprites, files and pictures out. Needs no GPU and no display.

mod architecture;
mod assets;
mod derived;
mod draw_list;
mod export;
mod filter;
mod flight;
mod measure;
mod method;
mod model_glb;
mod parts;
mod property;
mod raster;
mod scene_file;
mod shading;
mod sprites;
mod suite;
mod thin;
mod truth;
mod weather;
