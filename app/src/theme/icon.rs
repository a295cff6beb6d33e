//! Names of the icon font's glyphs (assets/fonts). Buttons that show only an icon carry their name for screen readers.

/// Of a kind of thing, by its word ([`Thing::word`](cloudwright_core::scene::Thing::word)); a pin for a kind without one
/// of its own.
pub(crate) fn of_kind(word: &str) -> &'static str {
    match word {
        "aircraft" => AIRPLANE_TILT,
        "box" => CUBE,
        "camera" => VIDEO_CAMERA,
        "cloud" => CLOUD,
        "folder" => FOLDER,
        "model" => CUBE_TRANSPARENT,
        "path" => PATH,
        "track" => DIAMOND,
        _ => MAP_PIN,
    }
}

pub(crate) const AIRPLANE_TILT: &str = "\u{E5D6}";
pub(crate) const ARROW_U_UP_LEFT: &str = "\u{E08A}";
pub(crate) const ARROW_U_UP_RIGHT: &str = "\u{E08C}";
pub(crate) const ARROWS_CLOCKWISE: &str = "\u{E094}";
pub(crate) const ARROWS_LEFT_RIGHT: &str = "\u{E0A0}";
pub(crate) const ARROWS_OUT_CARDINAL: &str = "\u{E0A4}";
pub(crate) const BOUNDING_BOX: &str = "\u{E6CE}";
pub(crate) const CAMERA: &str = "\u{E10E}";
pub(crate) const CARET_DOWN: &str = "\u{E136}";
pub(crate) const CHART_LINE: &str = "\u{E154}";
pub(crate) const CHART_SCATTER: &str = "\u{EAAC}";
pub(crate) const CHECK_CIRCLE: &str = "\u{E184}";
pub(crate) const CIRCLE_HALF_TILT: &str = "\u{E18E}";
pub(crate) const CIRCLES_THREE_PLUS: &str = "\u{E194}";
pub(crate) const CLOCK_COUNTER_CLOCKWISE: &str = "\u{E1A0}";
pub(crate) const CLOUD: &str = "\u{E1AA}";
pub(crate) const COPY: &str = "\u{E1CA}";
pub(crate) const COPY_SIMPLE: &str = "\u{E1CC}";
pub(crate) const CORNERS_OUT: &str = "\u{E1D0}";
pub(crate) const CUBE: &str = "\u{E1DA}";
pub(crate) const CUBE_TRANSPARENT: &str = "\u{EC7C}";
pub(crate) const CURSOR: &str = "\u{E1DC}";
pub(crate) const DIAMOND: &str = "\u{E1EC}";
pub(crate) const DICE_FIVE: &str = "\u{E1EE}";
pub(crate) const DOTS_NINE: &str = "\u{E1FC}";
pub(crate) const DOTS_THREE: &str = "\u{E1FE}";
pub(crate) const EYE: &str = "\u{E220}";
pub(crate) const EYE_SLASH: &str = "\u{E224}";
pub(crate) const FILE_PLUS: &str = "\u{E236}";
pub(crate) const FLIP_HORIZONTAL: &str = "\u{ED6A}";
pub(crate) const FLOPPY_DISK: &str = "\u{E248}";
pub(crate) const FOLDER: &str = "\u{E24A}";
pub(crate) const FRAME_CORNERS: &str = "\u{E626}";
pub(crate) const GRADIENT: &str = "\u{EB42}";
pub(crate) const INFO: &str = "\u{E2CE}";
pub(crate) const LINK_BREAK: &str = "\u{E2E4}";
pub(crate) const LOCK_SIMPLE: &str = "\u{E308}";
pub(crate) const LOCK_SIMPLE_OPEN: &str = "\u{E30A}";
pub(crate) const MAGIC_WAND: &str = "\u{E6B6}";
pub(crate) const MAGNET: &str = "\u{E680}";
pub(crate) const MAGNIFYING_GLASS: &str = "\u{E30C}";
pub(crate) const MAP_PIN: &str = "\u{E316}";
pub(crate) const PAINT_BUCKET: &str = "\u{E392}";
pub(crate) const PATH: &str = "\u{E39C}";
pub(crate) const PAUSE: &str = "\u{E39E}";
pub(crate) const PLAY: &str = "\u{E3D0}";
pub(crate) const PLUS: &str = "\u{E3D4}";
pub(crate) const RECORD: &str = "\u{E3EE}";
pub(crate) const REPEAT: &str = "\u{E3F6}";
pub(crate) const RESIZE: &str = "\u{ED6E}";
pub(crate) const SELECTION_ALL: &str = "\u{E746}";
pub(crate) const SKIP_BACK: &str = "\u{E5A4}";
pub(crate) const SKIP_FORWARD: &str = "\u{E5A6}";
pub(crate) const SLIDERS_HORIZONTAL: &str = "\u{E434}";
pub(crate) const SQUARES_FOUR: &str = "\u{E464}";
pub(crate) const STACK: &str = "\u{E466}";
pub(crate) const STEERING_WHEEL: &str = "\u{E9AC}";
pub(crate) const STOP: &str = "\u{E46C}";
pub(crate) const SUBTRACT: &str = "\u{EBD6}";
pub(crate) const SUN: &str = "\u{E472}";
pub(crate) const TARGET: &str = "\u{E47C}";
pub(crate) const TRASH: &str = "\u{E4A6}";
pub(crate) const TREE_STRUCTURE: &str = "\u{E67C}";
pub(crate) const UNITE: &str = "\u{E87E}";
pub(crate) const VIDEO_CAMERA: &str = "\u{E4DA}";
pub(crate) const WARNING: &str = "\u{E4E0}";
pub(crate) const WARNING_CIRCLE: &str = "\u{E4E2}";
pub(crate) const X: &str = "\u{E4F6}";
