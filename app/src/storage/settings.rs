//! What the program remembers from one start to the next, as JSON in the user's folder.
//!
//! Settings are never worth a crash: a file that can't be understood is put aside and the defaults stand in. Several
//! editors may run at once, so a change is made to what is on disk at that moment, not to what was read at the start.

use super::{FilmSettings, Folders, PictureSettings, StorageError, read, write_atomic};
use crate::command::Keymap;
use crate::renderer::RendererChoice;
use crate::units::Units;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const VERSION: u64 = 1;
/// No settings are longer, bytes.
const MAX_BYTES: usize = 1 << 20;
const MAX_RECENT: usize = 10;

/// What is remembered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    version: u64,
    /// Scenes that were open, the last one first.
    recent: Vec<PathBuf>,
    /// Dark or light.
    pub theme: ThemeChoice,
    /// What altitudes and speeds are shown in.
    pub units: Units,
    /// Whose keys are used.
    pub keymap: Keymap,
    /// What draws the viewport, unless the command line says.
    pub renderer: RendererChoice,
    /// Whether the start page is shown when the editor starts without a scene.
    pub start_page: bool,
    scale: f32,
    keep_work_every_s: u32,
    /// For what can be undone, megabytes; 0 for as many as there are.
    pub undo_mb: u32,
    /// The titles of what is folded in panels.
    pub folded: BTreeSet<String>,
    /// How pictures were last drawn into files.
    pub picture: PictureSettings,
    /// How films were.
    pub film: FilmSettings,
    /// How panels are docked, as the window's layout itself says it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layout: Option<Value>,
    /// Layouts that were saved by name, as the window's layout itself says them.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub layouts: BTreeMap<String, Value>,
    /// Width and height of the window, points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub window_size: Option<[f32; 2]>,
}

/// Dark, light, or whatever the desktop prefers.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ThemeChoice {
    /// As the desktop.
    #[default]
    System,
    /// Light on dark.
    Dark,
    /// Dark on light.
    Light,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: VERSION,
            recent: Vec::new(),
            theme: ThemeChoice::default(),
            units: Units::default(),
            keymap: Keymap::default(),
            renderer: RendererChoice::default(),
            start_page: true,
            scale: 1.0,
            keep_work_every_s: 0,
            undo_mb: 256,
            folded: BTreeSet::new(),
            picture: PictureSettings::default(),
            film: FilmSettings::default(),
            layout: None,
            layouts: BTreeMap::new(),
            window_size: None,
        }
    }
}

impl Settings {
    /// Of the interface: the smallest and the largest.
    pub const SCALES: [f32; 2] = [0.5, 3.0];
    /// The longest that unsaved work may wait until it is kept, seconds.
    pub const MAX_KEEP_WORK_S: u32 = 600;

    /// How large the interface is, times its usual size.
    pub fn scale(&self) -> f32 {
        let [least, most] = Self::SCALES;
        if self.scale.is_finite() { self.scale.clamp(least, most) } else { 1.0 }
    }

    /// Chooses another size of the interface.
    pub fn set_scale(&mut self, scale: f32) {
        self.scale = scale;
    }

    /// After how many seconds unsaved work is kept again; 0: after each change.
    pub fn keep_work_every_s(&self) -> u32 {
        self.keep_work_every_s.min(Self::MAX_KEEP_WORK_S)
    }

    /// Chooses another time between two keepings of unsaved work.
    pub fn set_keep_work_every_s(&mut self, seconds: u32) {
        self.keep_work_every_s = seconds;
    }

    /// What is remembered in `folders`: defaults if nothing is, and defaults with a notice if it can't be understood.
    pub fn load(folders: &Folders) -> (Self, Option<String>) {
        let path = file(folders);
        if !path.exists() {
            return (Self::default(), None);
        }
        let read = read(&path, MAX_BYTES).map_err(|error| error.reason().to_owned());
        match read.and_then(|bytes| understand(&bytes)) {
            Ok(settings) => (settings, None),
            Err(why) => {
                let notice = format!("{}: {why}; the settings start anew, and the old file is kept", path.display());
                (Self::default(), Some(notice))
            }
        }
    }

    /// Changes what is remembered in `folders`.
    ///
    /// # Errors
    /// If it can't be written.
    pub fn change(folders: &Folders, change: impl FnOnce(&mut Self)) -> Result<(), StorageError> {
        let path = file(folders);
        let (before, unreadable) = Self::load(folders);
        let mut settings = before.clone();
        change(&mut settings);
        if settings == before {
            return Ok(());
        }
        if unreadable.is_some() {
            // Kept for whoever wrote it, perhaps a newer version.
            let _ = fs::rename(&path, aside(&path));
        }
        fs::create_dir_all(&folders.config).map_err(|error| StorageError::write(&folders.config, &error))?;
        let text = serde_json::to_string_pretty(&settings)
            .map_err(|error| StorageError::write(&path, &std::io::Error::other(error)))?;
        write_atomic(&path, (text + "\n").as_bytes())
    }

    /// As its file says it.
    pub fn to_text(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    /// Scenes that were open, the last one first.
    pub fn recent(&self) -> &[PathBuf] {
        &self.recent
    }

    /// Puts a scene first. JSON can't say every name that a system allows; those are not remembered.
    pub fn remember_scene(&mut self, path: &Path) {
        let Ok(path) = std::path::absolute(path) else { return };
        if path.to_str().is_none() {
            return;
        }
        self.recent.retain(|old| *old != path);
        self.recent.insert(0, path);
        self.recent.truncate(MAX_RECENT);
    }
}

fn file(folders: &Folders) -> PathBuf {
    folders.config.join("settings.json")
}

/// A free name for a file that can't be understood: what was put aside before stays too.
fn aside(path: &Path) -> PathBuf {
    let mut kept = path.with_extension("unreadable.json");
    let mut number = 1_u32;
    while fs::symlink_metadata(&kept).is_ok() {
        number += 1;
        kept = path.with_extension(format!("unreadable-{number}.json"));
    }
    kept
}

fn understand(bytes: &[u8]) -> Result<Settings, String> {
    let settings: Settings = serde_json::from_slice(bytes).map_err(|error| error.to_string())?;
    match settings.version {
        VERSION => Ok(Settings { recent: settings.recent.into_iter().take(MAX_RECENT).collect(), ..settings }),
        version => Err(format!("version {version} is not known here")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_scene_comes_first_and_ten_are_kept() {
        let home = tempfile::tempdir().expect("a folder");
        let folders = Folders::within(home.path());
        assert_eq!(Settings::load(&folders), (Settings::default(), None));
        for name in (0..12).map(|n| format!("/scenes/{n}.cloudscene")).chain(["/scenes/5.cloudscene".into()]) {
            Settings::change(&folders, |settings| settings.remember_scene(Path::new(&name))).expect("writable");
        }
        let (settings, notice) = Settings::load(&folders);
        let names: Vec<_> = settings.recent().iter().map(|path| path.file_stem().expect("a name")).collect();
        assert_eq!(
            (names, notice),
            (["5", "11", "10", "9", "8", "7", "6", "4", "3", "2"].map(AsRef::as_ref).to_vec(), None)
        );
    }

    #[test]
    fn what_is_not_understood_is_put_aside() {
        let home = tempfile::tempdir().expect("a folder");
        let folders = Folders::within(home.path());
        fs::create_dir_all(&folders.config).expect("writable");
        let mut kept = Vec::new();
        for bad in ["", "{", "null", "{\"version\": 2}", "{\"recent\": 3}", "{\"theme\": \"pink\"}", "\u{0}"] {
            fs::write(file(&folders), bad).expect("writable");
            let (settings, notice) = Settings::load(&folders);
            assert_eq!(settings, Settings::default(), "{bad}");
            assert!(notice.is_some_and(|notice| notice.contains("settings.json")), "{bad}");
            Settings::change(&folders, |settings| settings.theme = ThemeChoice::Light).expect("writable");
            assert_eq!(Settings::load(&folders).0.theme, ThemeChoice::Light);
            kept.push(bad);
            let names = (1..=kept.len()).map(|n| match n {
                1 => "settings.unreadable.json".into(),
                n => format!("settings.unreadable-{n}.json"),
            });
            let there: Vec<_> = names.map(|name| fs::read_to_string(folders.config.join(name)).ok()).collect();
            assert_eq!(there, kept.iter().map(|kept| Some((*kept).to_owned())).collect::<Vec<_>>(), "all of them");
        }
        fs::write(file(&folders), "{\"later_field\": 1, \"theme\": \"light\"}").expect("writable");
        assert_eq!(Settings::load(&folders).0.theme, ThemeChoice::Light, "what it knows, it takes");
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_an_error_and_no_more() {
        let home = tempfile::NamedTempFile::new().expect("a file");
        let folders = Folders::within(home.path());
        assert!(Settings::change(&folders, |settings| settings.theme = ThemeChoice::Dark).is_err());
        assert_eq!(Settings::load(&folders), (Settings::default(), None));
    }
}
