//! Where the program keeps what it remembers for a user.

use directories::ProjectDirs;
use std::path::{Path, PathBuf};

/// Two folders, made when something is first written into them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folders {
    /// Settings: what a user would take along to another machine.
    pub config: PathBuf,
    /// What may be needed after a crash.
    pub state: PathBuf,
}

impl Folders {
    /// The user's own, where the system wants them (XDG's variables are heeded); none for a user without a home.
    pub fn of_user() -> Option<Self> {
        let user = ProjectDirs::from("", "", "cloudwright")?;
        let state = user.state_dir().unwrap_or_else(|| user.data_local_dir());
        Some(Self { config: user.config_dir().into(), state: state.into() })
    }

    /// Where the user's own plugins lie.
    pub fn plugins(&self) -> PathBuf {
        self.config.join("plugins")
    }

    /// Both in one folder.
    pub fn within(folder: &Path) -> Self {
        Self { config: folder.join("config"), state: folder.join("state") }
    }
}
