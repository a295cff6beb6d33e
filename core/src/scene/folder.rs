//! A folder: clouds that are kept together, to be hidden, locked and told from others as one.

use super::{Cloud, FolderId, HasId, InScene, Scene};
use crate::color::{Rgb, linear_from_srgb};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Clouds that are kept together. Which, each of them says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Folder {
    /// Its id.
    pub id: FolderId,
    /// For people.
    pub name: String,
    /// What its clouds are marked with in the editor, linear light.
    #[serde(default = "grey")]
    pub color: Rgb,
    /// Whether its clouds are left out: of pictures, of what leaves, and of what is measured.
    #[serde(default, skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// Whether the pointer passes through its clouds in the editor.
    #[serde(default, skip_serializing_if = "is_false")]
    pub locked: bool,
}

/// Colours that are easily told apart, on dark and on light, as a display has them.
const COLORS: [[u8; 3]; 8] = [
    [0xe0, 0x8a, 0x3c],
    [0x4f, 0x9f, 0xd8],
    [0x7a, 0xb6, 0x48],
    [0xc7, 0x6a, 0xb8],
    [0xd8, 0xb4, 0x2e],
    [0x4c, 0xb3, 0xa1],
    [0xd8, 0x63, 0x63],
    [0x8f, 0x84, 0xd6],
];

fn grey() -> Rgb {
    Rgb::grey(0.25)
}

fn is_false(flag: &bool) -> bool {
    !flag
}

impl Folder {
    /// Of no cloud yet, in a colour that the next one won't have.
    pub fn new(id: FolderId, name: &str) -> Self {
        let [r, g, b] =
            COLORS[(id.0 % COLORS.len() as u64) as usize].map(|byte| linear_from_srgb(f32::from(byte) / 255.0));
        Self { id, name: name.into(), color: Rgb::new(r, g, b), hidden: false, locked: false }
    }
}

impl HasId for Folder {
    type Id = FolderId;
    fn id(&self) -> FolderId {
        self.id
    }
}

impl InScene for Folder {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }
}

impl Scene {
    /// The folder that `cloud` is in, if it is in one.
    pub fn folder_of(&self, cloud: &Cloud) -> Option<&Folder> {
        self.folders.with_id(cloud.folder?)
    }

    /// Whether there is anything of `cloud` to be drawn, exported or measured: not if its folder is hidden.
    pub fn is_seen(&self, cloud: &Cloud) -> bool {
        self.folder_of(cloud).is_none_or(|folder| !folder.hidden)
    }

    /// Whether hands are kept off `cloud`, as its folder is locked.
    pub fn is_locked(&self, cloud: &Cloud) -> bool {
        self.folder_of(cloud).is_some_and(|folder| folder.locked)
    }

    /// The clouds of a folder, in their order.
    pub fn clouds_in(&self, folder: FolderId) -> impl Iterator<Item = &Cloud> {
        self.clouds.iter().filter(move |cloud| cloud.folder == Some(folder))
    }
}
