//! Tracks: of their keys the timeline takes care.

use super::described::Described;
use super::row::{Row, choice, setting, text};
use super::setting::{Choice, Setting, Value};
use crate::scene::{Beyond, Track};

const BEYOND: &[(Beyond, Choice)] = &[
    (Beyond::Hold, Choice { name: "hold", label: "holds" }),
    (Beyond::Repeat, Choice { name: "repeat", label: "repeats" }),
    (Beyond::Swing, Choice { name: "swing", label: "swings" }),
];
const CHOICES: &[Choice] = &[BEYOND[0].1, BEYOND[1].1, BEYOND[2].1];

macro_rules! beyond {
    ($field:ident: $property:expr) => {
        Row::of(
            stringify!($field),
            $property,
            |track| {
                let named = BEYOND.iter().find(|(beyond, _)| *beyond == track.$field)?;
                Some(Value::Text(named.1.name.into()))
            },
            |track, value| {
                let name = String::from_value(value)?;
                track.$field = BEYOND.iter().find(|(_, choice)| choice.name == name)?.0;
                Some(())
            },
        )
    };
}

impl Described for Track {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(property: text("Moves", "The property that it moves, by its address.")),
        beyond!(before: choice("Before", "What it does before its first key.", CHOICES)),
        beyond!(after: choice("After", "What it does after its last key.", CHOICES)),
    ]];
}
