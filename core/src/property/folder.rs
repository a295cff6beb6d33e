//! Folders of clouds.

use super::Number;
use super::described::Described;
use super::row::{Row, color, flag, numbers, range_of, setting, text};
use super::setting::{Numbers, Setting};
use crate::scene::Folder;

const MARK: Number = Number::new("Colour", &(0.0..=1.0), "", "What its clouds are marked with in the editor.");

impl Described for Folder {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        numbers!(color: color(MARK)),
        setting!(hidden: flag("Hidden", "Leaves its clouds out of pictures, of what is exported and of what is measured.")),
        setting!(locked: flag("Locked", "Keeps the pointer from picking its clouds.")),
    ]];
}
