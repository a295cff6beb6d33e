//! Everything Cloudwright computes: the scene, how it changes, sprites, light, and pictures on the CPU.
//!
//! No GPU, no files, no clock, no window, no scripts: bytes and values go in, bytes and values come out,
//! and the only threads are those of a data-parallel pool. ARCHITECTURE.md has the map; the two flows are
//!
//! ```text
//! Scene ─sprites→ [Sprite], groups, bounds                             edit clock
//! [Sprite] + View + Light ─draw_list→ order ─facing, shading→ pixels   camera clock
//! ```

pub mod arrange;
pub mod baked;
pub mod camera;
pub mod change;
pub mod color;
pub mod density;
pub mod derived;
pub mod detail;
pub mod document;
pub mod draw;
pub mod draw_list;
pub mod exchange;
pub mod facing;
pub mod fit_light;
pub mod flight;
pub mod formats;
pub mod frame;
pub mod image;
pub mod math;
pub mod measure;
pub mod method;
pub mod model_in_view;
pub mod model_mesh;
pub mod panorama;
pub mod posed_sprite;
pub mod preset;
pub mod problem;
pub mod property;
pub mod random;
pub mod raster;
pub mod reported;
pub mod rules;
pub mod scene;
pub mod shading;
pub mod sight;
pub mod sky;
pub mod spelling;
pub mod sprites;
pub mod thin;
pub mod tone;
pub mod traced;
pub mod variants;
pub mod version;
pub mod view_history;
pub mod watch;
pub mod weather;
