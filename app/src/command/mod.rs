//! The command table: every action once, with name, help, keys, icon and menu.
//!
//! Menus, toolbar, palette, tooltips and README's manual read it. A new command is a row here and an arm in
//! editor/perform.

pub(crate) mod context;
pub(crate) mod keymap;
mod keys;
pub mod manual;

pub use keymap::Keymap;
pub(crate) use keys::{Pasted, delete_belongs_to, give_keys_to_timeline, pasted, pressed};

use crate::theme::icon;
use egui::{Key, KeyboardShortcut, Modifiers};

/// In which menu a command stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Menu {
    /// Scenes on disk.
    File,
    /// History, selection and what is done with it.
    Edit,
    /// New things.
    Add,
    /// Shading groups and colour levels.
    Shade,
    /// How it is looked at.
    View,
    /// What the primary button does.
    Tool,
    /// The scene's clock, and paths that are flown by it.
    Flight,
    /// Keys of tracks, and what the clock plays of them.
    Keys,
    /// What scripts do.
    Plugins,
    /// Panels.
    Window,
    /// How things are done, and what this is.
    Help,
}

impl Menu {
    /// All, in the order of the menu bar.
    pub const ALL: [Self; 11] = [
        Self::File,
        Self::Edit,
        Self::Add,
        Self::Shade,
        Self::View,
        Self::Tool,
        Self::Flight,
        Self::Keys,
        Self::Plugins,
        Self::Window,
        Self::Help,
    ];

    /// Alt and this key open it: a letter of its name that no command of the editor's own keymap has with Alt.
    pub const fn key(self) -> Key {
        match self {
            Self::File => Key::F,
            Self::Edit => Key::E,
            Self::Add => Key::D,
            Self::Shade => Key::S,
            Self::View => Key::V,
            Self::Tool => Key::T,
            Self::Flight => Key::I,
            Self::Keys => Key::K,
            Self::Plugins => Key::P,
            Self::Window => Key::W,
            Self::Help => Key::L,
        }
    }

    /// The keys that open it, unless a command has them.
    pub(crate) fn shortcut(self, context: &egui::Context) -> Option<KeyboardShortcut> {
        let keys = KeyboardShortcut::new(Modifiers::ALT, self.key());
        let taken = keymap::of(context).all().any(|(others, _)| others == keys);
        (!taken).then_some(keys)
    }

    /// As in the menu bar.
    pub const fn name(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Add => "Add",
            Self::Shade => "Shade",
            Self::View => "View",
            Self::Tool => "Tool",
            Self::Flight => "Flight",
            Self::Keys => "Keys",
            Self::Plugins => "Plugins",
            Self::Window => "Window",
            Self::Help => "Help",
        }
    }
}

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Which command.
    pub command: Command,
    /// As in menus.
    pub name: &'static str,
    /// One sentence for the tooltip.
    pub help: &'static str,
    /// Its own keys, which a [`Keymap`] may change; none for a rare one.
    pub shortcut: Option<KeyboardShortcut>,
    /// A glyph of the icon font.
    pub icon: Option<&'static str>,
    /// Where it stands.
    pub menu: Menu,
}

macro_rules! commands {
    ($($menu:ident { $($command:ident: $name:literal, $help:literal, $keys:expr, $icon:expr;)* })*) => {
        /// Something that the user can have done.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Command {
            $($(#[doc = $help] $command,)*)*
        }

        /// All commands, in the order of the menus.
        pub const TABLE: &[Row] = &[
            $($(Row {
                command: Command::$command,
                name: $name,
                help: $help,
                shortcut: $keys,
                icon: $icon,
                menu: Menu::$menu,
            },)*)*
        ];
    };
}

const NONE: Option<KeyboardShortcut> = None;

const fn key(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::NONE, key))
}

const fn shift(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::SHIFT, key))
}

const fn alt(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::ALT, key))
}

const fn ctrl(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND, key))
}

const fn ctrl_shift(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key))
}

commands! {
    File {
        New: "New…", "Start a new scene, with a clear sky or one that is ready.", ctrl(Key::N), Some(icon::FILE_PLUS);
        Open: "Open…", "Open a scene file.", ctrl(Key::O), None;
        OpenRecent: "Open recent…", "Open one of the last ten scenes.", ctrl_shift(Key::O), None;
        Save: "Save", "Save the scene.", ctrl(Key::S), Some(icon::FLOPPY_DISK);
        SaveAs: "Save as…", "Save the scene under another name.", ctrl_shift(Key::S), None;
        Revert: "Revert…", "Go back to the scene as it was last saved.", NONE, None;
        Append: "Append from scene…", "Add clouds of another scene with their models.", NONE, None;
        Import: "Import…", "Bring in what another program made: clouds, weather, or a whole scene.", ctrl(Key::I), None;
        Export: "Export…", "Write the scene for another program: glTF, clouds of flight simulators, weather presets, tables.", ctrl(Key::E), None;
        RenderPicture: "Render picture…", "Draw the scene into a picture file: PNG, OpenEXR or Radiance HDR.", key(Key::F12), None;
        RenderFlight: "Render flight…", "Draw a flight, or weather from a camera, into a video or into frames.", ctrl(Key::F12), None;
        Quit: "Quit", "Close the editor.", ctrl(Key::Q), None;
    }
    Edit {
        Undo: "Undo", "Take the last change back.", ctrl(Key::Z), Some(icon::ARROW_U_UP_LEFT);
        Redo: "Redo", "Bring an undone change again.", ctrl_shift(Key::Z), Some(icon::ARROW_U_UP_RIGHT);
        SelectAll: "Select all", "Select all clouds, or all boxes of the selected box's model.", ctrl(Key::A), Some(icon::SELECTION_ALL);
        SelectNone: "Select nothing", "Clear the selection.", alt(Key::A), None;
        Cut: "Cut", "Put the selection onto the clipboard, and take it out of the scene.", ctrl(Key::X), None;
        Copy: "Copy", "Put the selection onto the clipboard, for this scene or another one.", ctrl(Key::C), None;
        Paste: "Paste", "Add what was copied: clouds with their models, models, paths, cameras; boxes to the selected model.", ctrl(Key::V), None;
        Duplicate: "Duplicate linked", "Add another one like the selection; clouds share the model.", ctrl(Key::D), Some(icon::COPY_SIMPLE);
        DuplicateOwn: "Duplicate with own model", "Add another cloud with a model of its own.", ctrl_shift(Key::D), Some(icon::COPY);
        MakeOwn: "Make model own", "Give the selected cloud a model that no other cloud shares.", NONE, Some(icon::LINK_BREAK);
        MirrorX: "Mirror east–west", "Mirror the selected boxes, or the cloud, across x.", NONE, Some(icon::FLIP_HORIZONTAL);
        MirrorY: "Mirror up–down", "Mirror the selected boxes, or the cloud, across y.", NONE, None;
        MirrorZ: "Mirror north–south", "Mirror the selected boxes, or the cloud, across z.", NONE, None;
        Join: "Join clouds", "Make the selected clouds one cloud.", ctrl(Key::J), Some(icon::UNITE);
        Split: "Split cloud", "Make the selected boxes a cloud of their own.", ctrl_shift(Key::J), Some(icon::SUBTRACT);
        Reroll: "Re-roll", "Strew the selected cloud's or model's sprites anew, with another seed.", key(Key::K), Some(icon::DICE_FIVE);
        FitSprites: "Fit sprites to box", "Give the selected boxes as many and as large sprites as fill them.", NONE, None;
        ResetSprites: "Reset sprites", "Take back what was changed by hand about the selected sprites or boxes.", NONE, None;
        Rename: "Rename…", "Give the selection another name; of many, names with a running number.", key(Key::F2), None;
        NewFolder: "New folder from selection", "Keep the selected clouds in a new folder.", NONE, Some(icon::FOLDER);
        MoveToFolder: "Move to folder…", "Choose a folder for the selected clouds.", NONE, None;
        LeaveFolder: "Out of the folder", "Take the selected clouds out of their folder.", NONE, None;
        SelectFolder: "Select folder's clouds", "Select all clouds of the selected folder, or of the selected clouds' folders.", NONE, None;
        RemoveUnusedModels: "Remove unused models", "Take out the models that no cloud places.", NONE, None;
        CopyPicture: "Copy picture", "Put what the view shows onto the clipboard, as an image.", NONE, None;
        Preferences: "Preferences…", "Look, units, keys and the like, all in one place.", ctrl(Key::Comma), None;
        Delete: "Delete", "Take the selection out of the scene.", key(Key::Delete), Some(icon::TRASH);
    }
    Add {
        AddCloud: "Cloud", "Add a cloud with a model of its own where the view looks.", NONE, Some(icon::CLOUD);
        AddPreset: "Cloud from preset…", "Choose a ready-made cloud by its picture.", shift(Key::A), Some(icon::SQUARES_FOUR);
        PlaceModel: "Placement", "Place the selected model again.", NONE, Some(icon::MAP_PIN);
        PlaceMany: "Many placements…", "Strew placements of the selected model over an area.", NONE, Some(icon::DOTS_NINE);
        AddBox: "Box", "Add a box of sprites to the selected model.", NONE, Some(icon::CUBE);
        AddCamera: "Camera", "Add a camera that sees what the view sees.", NONE, Some(icon::VIDEO_CAMERA);
        AddPath: "Path", "Add a camera path that begins where the view is.", NONE, Some(icon::PATH);
        AddAircraft: "Aircraft", "Add an aircraft on the chosen path.", NONE, Some(icon::AIRPLANE_TILT);
    }
    Shade {
        NewGroup: "New shading group", "Put the selected boxes or sprites into a shading group of their own.", ctrl(Key::G), Some(icon::CIRCLES_THREE_PLUS);
        Ungroup: "Leave the group", "Give the selected boxes or sprites their own groups back.", ctrl_shift(Key::G), None;
        AutoGroup: "Group automatically", "Split the selected model's sprites into shading groups of at most 30.", NONE, Some(icon::MAGIC_WAND);
        FitLight: "Fit light…", "Light clouds as nearly as they can be as a path tracer does.", NONE, None;
        ThinOut: "Thin out…", "Drop the sprites that the scene can do without.", NONE, None;
        CopyLevels: "Copy colour levels", "Keep the selected model's colour levels for pasting.", NONE, None;
        PasteLevels: "Paste colour levels", "Give the selected models the colour levels that were copied.", NONE, None;
    }
    View {
        FrameSelection: "Frame selection", "Bring the selection into view.", key(Key::F), Some(icon::CORNERS_OUT);
        FrameAll: "Frame all", "Bring all clouds into view.", key(Key::A), Some(icon::FRAME_CORNERS);
        TopView: "Top view", "Look down on what is looked at, north at the top.", key(Key::Num7), None;
        BottomView: "Bottom view", "Look up at what is looked at, south at the top.", ctrl(Key::Num7), None;
        FrontView: "Front view", "Look north at what is looked at, from the south.", key(Key::Num1), None;
        BackView: "Back view", "Look south at what is looked at, from the north.", ctrl(Key::Num1), None;
        RightView: "Right view", "Look west at what is looked at, from the east.", key(Key::Num3), None;
        LeftView: "Left view", "Look east at what is looked at, from the west.", ctrl(Key::Num3), None;
        Orthographic: "Orthographic", "Look along rays that run side by side, so that what is far is no smaller; without haze.", key(Key::Num5), None;
        QuadView: "Quad view", "Show orthographic views from the top, the front and the right beside the free one, or it alone.", key(Key::Num4), None;
        LookThrough: "Look through camera", "See what the selected camera sees, or the next one.", key(Key::C), Some(icon::CAMERA);
        AlignCamera: "Align camera to view", "Put the selected camera, or the first, where the view is.", ctrl_shift(Key::C), None;
        Hide: "Hide", "Hide the selection, or show it again.", key(Key::H), Some(icon::EYE_SLASH);
        Solo: "Solo", "Show only the selected clouds and folders, or all again; so does Esc.", shift(Key::H), Some(icon::TARGET);
        Lock: "Lock", "Keep the pointer from picking the selection, or let it again.", key(Key::L), Some(icon::LOCK_SIMPLE);
        ShowAll: "Show and unlock all", "Show and unlock all that was hidden or locked.", alt(Key::H), Some(icon::EYE);
        ShowBoxes: "Show all boxes", "Show or hide the outlines of all boxes.", shift(Key::B), Some(icon::CUBE_TRANSPARENT);
        SpriteMarks: "Mark sprites", "Mark sprites with dots, with outlines, or not at all.", key(Key::M), Some(icon::DOTS_THREE);
        GroupView: "Group view", "Show boxes and sprites in the tints of their shading groups.", key(Key::G), Some(icon::PAINT_BUCKET);
        CameraPicture: "Camera's picture", "Show what the selected camera sees in a corner of the viewport.", NONE, None;
        Haze: "Haze", "Show haze in the view, or leave it out while working; pictures in files have it.", NONE, None;
        AllSprites: "All sprites", "Draw every sprite in the view, also where merged ones in their place are hardly told from them; pictures in files have them all.", NONE, None;
        SwitchTheme: "Dark or light", "Switch between the dark and the light look.", NONE, Some(icon::CIRCLE_HALF_TILT);
        SwitchUnits: "Metric or aviation units", "Show altitudes and speeds in metres and km/h, or in feet and knots.", NONE, None;
        SwitchKeymap: "Blender's keys", "Use Blender's keys where it has the command, such as G, R and S, or the editor's own.", NONE, None;
        Palette: "Command palette…", "Find any command by typing.", ctrl_shift(Key::P), Some(icon::MAGNIFYING_GLASS);
    }
    Tool {
        SelectTool: "Select", "Click to choose, drag for a marquee; again on one place for what lies behind.", key(Key::Q), Some(icon::CURSOR);
        MoveTool: "Move", "Arrows to move the selection by.", key(Key::W), Some(icon::ARROWS_OUT_CARDINAL);
        RotateTool: "Rotate", "Rings to turn the selection by.", key(Key::E), Some(icon::ARROWS_CLOCKWISE);
        ScaleTool: "Scale", "Handles to stretch the selection by.", key(Key::R), Some(icon::RESIZE);
        GrabPlace: "Move by pointer", "The selection follows the pointer until a click: X, Y, Z and figures say where to, Esc drops it.", NONE, None;
        GrabTurn: "Rotate by pointer", "The selection turns with the pointer until a click: X, Y, Z and figures say how far, Esc drops it.", NONE, None;
        GrabSize: "Scale by pointer", "The selection grows with the pointer until a click: X, Y, Z and figures say how much, Esc drops it.", NONE, None;
        BoxTool: "Box tool", "Drag a footprint at the base altitude, then pull the height.", key(Key::B), Some(icon::BOUNDING_BOX);
        Snap: "Snap", "Snap gestures to steps; Ctrl does the opposite while it is held.", shift(Key::S), Some(icon::MAGNET);
        KeepFill: "Keep boxes filled", "A box that is resized stays as densely filled: its sprites grow and become more.", NONE, None;
        PlayTime: "Play time", "Let the time of day run in the view, or stop it; the scene's hour stays.", key(Key::P), Some(icon::PLAY);
        KeepHour: "Keep this hour", "Make the hour that is tried out the scene's.", NONE, None;
        SceneHour: "Back to the scene's hour", "Leave the hour that is tried out.", NONE, None;
    }
    Flight {
        PlayFlight: "Play the clock", "Let the scene's clock run, or stop it: tracks and wind move, clouds form, and the chosen path is flown.", key(Key::Space), Some(icon::PLAY);
        LoopFlight: "Loop flight", "Begin anew when the clock is at its end.", NONE, Some(icon::REPEAT);
        BoardFlight: "On board", "The view goes along the path; else the clock runs before a view that stays.", NONE, Some(icon::STEERING_WHEEL);
        FlightStart: "To the start", "Put the clock at its start.", key(Key::Home), Some(icon::SKIP_BACK);
        FlightEnd: "To the end", "Put the clock at its end.", key(Key::End), Some(icon::SKIP_FORWARD);
        SecondBack: "A second back", "Put the clock back by a second.", key(Key::Comma), None;
        SecondOn: "A second on", "Put the clock forward by a second.", key(Key::Period), None;
        KeyAfterLast: "Key after the last", "Let the chosen path go on to where the view is.", key(Key::I), Some(icon::PLUS);
        KeyAtClock: "Key at the clock", "Have the chosen path pass the view at the clock's time; a key that is there already moves.", shift(Key::I), None;
        RecordFlight: "Record flight", "Make a path of what is flown by hand from now until this is done again.", ctrl_shift(Key::R), Some(icon::RECORD);
    }
    Keys {
        KeyValue: "Key this value", "Key the value of the field that the pointer was at last, at the clock's time.", ctrl(Key::K), Some(icon::DIAMOND);
        AutoKey: "Auto-key", "What is changed about a keyed value sets a key at the clock's time.", ctrl_shift(Key::K), Some(icon::RECORD);
        PreviousKey: "Previous key", "Put the clock at the key before, of the chosen tracks or of all.", key(Key::PageUp), None;
        NextKey: "Next key", "Put the clock at the key after, of the chosen tracks or of all.", key(Key::PageDown), None;
        RippleKeys: "Ripple", "Dragged keys take all later ones of their tracks along, so that time is put in or cut out.", NONE, None;
        SnapKeys: "Snap keys", "Let dragged keys snap to frames, to whole seconds, or to nothing: each time the next of the three.", NONE, Some(icon::MAGNET);
        AddKeys: "Add keys", "Add a key at the clock's time to the chosen tracks, or to all.", shift(Key::K), Some(icon::PLUS);
        DeleteKeys: "Delete keys", "Take the chosen keys out: over the timeline, the Delete key.", NONE, Some(icon::TRASH);
        CutKeys: "Cut keys", "Put the chosen keys onto the clipboard, and take them out: over the timeline, Ctrl+X.", NONE, None;
        CopyKeys: "Copy keys", "Put the chosen keys onto the clipboard: over the timeline, Ctrl+C.", NONE, Some(icon::COPY);
        PasteKeys: "Paste keys", "Put the copied keys at the clock's time: over the timeline, Ctrl+V.", NONE, None;
        DuplicateKeys: "Duplicate keys", "Copy the chosen keys to a second behind them: over the timeline, Ctrl+D.", NONE, Some(icon::COPY_SIMPLE);
        SelectAllKeys: "Select all keys", "Choose all keys of the chosen tracks, or of all: over the timeline, Ctrl+A.", NONE, None;
        SelectNoKeys: "Select no keys", "Choose no key and no track: over the timeline, Alt+A.", NONE, None;
        SelectKeysBefore: "Select keys before the clock", "Choose all keys up to the clock's time, of the chosen tracks or of all.", NONE, None;
        SelectKeysAfter: "Select keys after the clock", "Choose all keys from the clock's time on, of the chosen tracks or of all.", NONE, None;
        MirrorKeys: "Mirror keys in time", "Turn the chosen keys the other way round about the clock's time.", NONE, None;
        SlowKeys: "Twice as slow", "Move the chosen keys twice as far from the clock's time; Alt drags them by any factor.", NONE, None;
        QuickenKeys: "Twice as fast", "Move the chosen keys half as far from the clock's time; Alt drags them by any factor.", NONE, None;
        KeysStep: "Leave by step", "The chosen keys hold until the next.", NONE, None;
        KeysLinear: "Leave straight", "The chosen keys go on straight to the next.", NONE, None;
        KeysSmooth: "Leave smoothly", "The chosen keys go on in a curve that never overshoots.", NONE, None;
        KeysFlat: "Flatten", "The curve is level at the chosen keys.", NONE, None;
        KeysFree: "Free handles", "Give the chosen keys handles that can be dragged in the curves.", NONE, None;
        EndsBefore: "Before the keys", "Let the chosen tracks hold, repeat or swing before their first key: each time the next of the three.", NONE, None;
        EndsAfter: "After the keys", "Let the chosen tracks hold, repeat or swing after their last key: each time the next of the three.", NONE, None;
        ClearKeys: "Clear all keys", "Take out all keys of what is selected.", NONE, None;
        MarkIn: "In mark", "Let the clock play from here on.", ctrl(Key::Home), None;
        MarkOut: "Out mark", "Let the clock play up to here.", ctrl(Key::End), None;
        ClearMarks: "No marks", "Let the clock play all through.", NONE, None;
        CurveView: "Curves", "Show the curves of the chosen tracks in the timeline, or its rows of keys.", NONE, Some(icon::CHART_LINE);
        FitTimeline: "Fit timeline", "Bring the chosen keys into sight, or all: over the timeline, F.", NONE, Some(icon::ARROWS_LEFT_RIGHT);
    }
    Plugins {
        WeatherReport: "Weather from a report…", "Paste METARs or TAFs: the scene takes their air, their hour and their clouds.", NONE, Some(icon::CLOUD);
        RunAgain: "Run again…", "Ask what is to be chosen of the plugin that was run last, and run it once more.", NONE, Some(icon::REPEAT);
        OpenPluginFolder: "Open plugin folder", "Show the folder in which plugins of your own lie.", NONE, None;
    }
    Window {
        OutlinePanel: "Outline", "Show the panel of models, clouds and cameras.", NONE, Some(icon::TREE_STRUCTURE);
        InspectorPanel: "Inspector", "Show the panel of the selection's values.", NONE, Some(icon::SLIDERS_HORIZONTAL);
        LevelsPanel: "Colour levels", "Show the panel of the five colour levels.", NONE, Some(icon::GRADIENT);
        GroupsPanel: "Shading groups", "Show the panel of shading groups.", NONE, Some(icon::STACK);
        SkyPanel: "Sky", "Show the panel of light, time and place.", NONE, Some(icon::SUN);
        FlightPanel: "Flight", "Show the panel of camera paths, aircraft and the scene's clock.", NONE, Some(icon::AIRPLANE_TILT);
        TimelinePanel: "Timeline", "Show the panel of keys over the scene's clock.", shift(Key::T), Some(icon::DIAMOND);
        ScriptPanel: "Script", "Show the panel in which plugins are written.", NONE, Some(icon::MAGIC_WAND);
        ChartPanel: "Chart", "Show the panel of what each method costs and gets wrong.", NONE, Some(icon::CHART_SCATTER);
        HistoryPanel: "History", "Show the panel of changes.", NONE, Some(icon::CLOCK_COUNTER_CLOCKWISE);
        ProblemsPanel: "Problems", "Show the panel of what is wrong.", NONE, Some(icon::WARNING);
        ResetLayout: "Reset layout", "Put all panels back to their places.", NONE, None;
        SaveLayout: "Save layout as…", "Keep where the panels are under a name.", NONE, None;
        Layouts: "Layouts…", "Choose a layout that was saved by name, or delete it.", NONE, None;
        StartPage: "Start page", "Recent scenes with their pictures, and skies to begin with.", NONE, None;
    }
    Help {
        Manual: "Manual", "How everything is done, as pages that can be searched.", key(Key::F1), None;
        Tour: "Tour", "Seven steps round the window; it can be left at any time.", NONE, None;
        WhatsNew: "What's new", "What has come and changed.", NONE, None;
        ReportProblem: "Report a problem…", "Gather what is needed to find a fault into a file, which you may read and send.", NONE, None;
        About: "About Cloudwright", "Version, renderer and driver.", NONE, Some(icon::INFO);
    }
}

impl Command {
    /// What its keys mean while the pointer is over the timeline.
    pub(crate) fn in_timeline(self) -> Self {
        match self {
            Self::Delete => Self::DeleteKeys,
            Self::Cut => Self::CutKeys,
            Self::Copy => Self::CopyKeys,
            Self::Paste => Self::PasteKeys,
            Self::Duplicate => Self::DuplicateKeys,
            Self::SelectAll => Self::SelectAllKeys,
            Self::SelectNone => Self::SelectNoKeys,
            Self::FrameSelection | Self::FrameAll => Self::FitTimeline,
            other => other,
        }
    }

    /// Its row.
    pub fn row(self) -> &'static Row {
        // The test below sees to it that each has one; the first stands in.
        TABLE.iter().find(|row| row.command == self).unwrap_or(&TABLE[0])
    }
}

impl Row {
    /// Help and keys, for tooltips.
    pub fn tooltip(&self, context: &egui::Context) -> String {
        match self.shortcut_text(context) {
            Some(keys) => format!("{} ({keys})", self.help),
            None => self.help.into(),
        }
    }

    /// The keys that it has in the keymap in use, in words.
    pub fn shortcut_text(&self, context: &egui::Context) -> Option<String> {
        keymap::of(context).shown(self.command).map(|keys| context.format_shortcut(&keys))
    }

    /// The name without the dots of what asks first.
    pub fn label(&self) -> &'static str {
        self.name.trim_end_matches('…')
    }

    /// "Add cloud", not "Cloud": for where no menu stands around it.
    pub fn full_label(&self) -> String {
        if self.menu == Menu::Add { format!("Add {}", self.label().to_lowercase()) } else { self.label().into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_rows_share_a_command_or_keys() {
        for (i, a) in TABLE.iter().enumerate() {
            for b in &TABLE[i + 1..] {
                assert_ne!(a.command, b.command);
                assert!(a.shortcut.is_none() || a.shortcut != b.shortcut, "{} and {}", a.name, b.name);
                assert_ne!(a.name, b.name);
            }
            assert_eq!(a.command.row().name, a.name);
        }
    }

    #[test]
    fn each_menu_opens_by_a_letter_of_its_own() {
        for (i, menu) in Menu::ALL.iter().enumerate() {
            let (letter, name) = (menu.key().name(), menu.name());
            assert!(name.to_uppercase().contains(letter), "{name}");
            assert!(Menu::ALL[i + 1..].iter().all(|other| other.key() != menu.key()), "{name}");
            assert!(TABLE.iter().all(|row| row.shortcut != alt(menu.key())), "{name}");
        }
    }
}
