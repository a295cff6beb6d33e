//! What can be set of a format's files: described once, for help, command line and menus.

use crate::property::Number;
use crate::spelling::closest;

/// What can be set, and what holds if nothing is said.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OptionRow {
    /// As on the command line.
    pub name: &'static str,
    /// What it may be.
    pub kind: OptionKind,
    /// One sentence for the artist.
    pub doc: &'static str,
}

/// What an option may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OptionKind {
    /// A number within a range; the usual one.
    Number(Number, f64),
    /// Yes or no; the usual one.
    Flag(bool),
}

/// A format's options with their values.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    rows: &'static [OptionRow],
    values: Vec<f64>,
}

/// An option that is not there, or can't be so.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OptionError {
    /// There is none of that name.
    #[error("there is no option “{name}”")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The one that was meant, perhaps.
        meant: Option<&'static str>,
    },
    /// The value is none.
    #[error("{name}: “{value}” is not {wanted}")]
    Value {
        /// Of the option.
        name: &'static str,
        /// As given.
        value: String,
        /// "yes or no", "a number from 1 to 8".
        wanted: String,
    },
}

impl OptionKind {
    /// "yes or no", "a number from 1 to 8 m".
    pub fn wanted(&self) -> String {
        match self {
            Self::Flag(_) => "yes or no".into(),
            Self::Number(number, _) => {
                format!("a number from {} to {} {}", number.min, number.max, number.unit).trim_end().into()
            }
        }
    }

    /// What holds if nothing is said.
    pub fn usual(&self) -> String {
        match self {
            Self::Flag(usual) => if *usual { "yes" } else { "no" }.into(),
            Self::Number(_, usual) => usual.to_string(),
        }
    }

    fn read(&self, text: &str) -> Option<f64> {
        match self {
            Self::Flag(_) => ["no", "yes"].iter().position(|word| *word == text).map(|at| at as f64),
            Self::Number(number, _) => text.parse().ok().filter(|value| number.allows(*value)),
        }
    }
}

impl Options {
    /// All as they usually are.
    pub(super) fn usual(rows: &'static [OptionRow]) -> Self {
        let usual = |row: &OptionRow| match row.kind {
            OptionKind::Flag(usual) => f64::from(u8::from(usual)),
            OptionKind::Number(_, usual) => usual,
        };
        Self { rows, values: rows.iter().map(usual).collect() }
    }

    /// Gives one another value.
    ///
    /// # Errors
    /// If there is none of that name, or the value is none of its kind.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), OptionError> {
        let Some(at) = self.rows.iter().position(|row| row.name == name) else {
            let meant = closest(name, self.rows.iter().map(|row| row.name));
            return Err(OptionError::Unknown { name: name.into(), meant });
        };
        let row = &self.rows[at];
        self.values[at] = row.kind.read(value.trim()).ok_or_else(|| OptionError::Value {
            name: row.name,
            value: value.into(),
            wanted: row.kind.wanted(),
        })?;
        Ok(())
    }

    /// A number's value. Of an option that is not in the table, 0.
    pub fn number(&self, name: &str) -> f64 {
        self.rows.iter().position(|row| row.name == name).map_or(0.0, |at| self.values[at])
    }

    /// Whether it is yes.
    pub fn flag(&self, name: &str) -> bool {
        self.number(name) != 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: &[OptionRow] = &[
        OptionRow {
            name: "voxel_m",
            kind: OptionKind::Number(Number::new("Voxel", &(1.0..=100.0), "m", "Its side."), 10.0),
            doc: "A voxel's side.",
        },
        OptionRow { name: "plain", kind: OptionKind::Flag(false), doc: "Without extensions." },
    ];

    #[test]
    fn values_are_of_their_kind() {
        let mut options = Options::usual(ROWS);
        assert_eq!((options.number("voxel_m"), options.flag("plain")), (10.0, false));
        options.set("plain", "yes").expect("a flag");
        options.set("voxel_m", "2.5").expect("a number");
        assert_eq!((options.number("voxel_m"), options.flag("plain")), (2.5, true));
        for (name, value, wanted) in [
            ("plain", "1", "plain: “1” is not yes or no"),
            ("voxel_m", "NaN", "voxel_m: “NaN” is not a number from 1 to 100 m"),
            ("voxel_m", "101", "a number from 1 to 100 m"),
            ("voxel", "2", "there is no option “voxel”"),
        ] {
            let error = options.set(name, value).expect_err(value);
            assert!(error.to_string().contains(wanted), "{error}");
        }
        assert_eq!(options.number("voxel_m"), 2.5, "as before");
    }
}
