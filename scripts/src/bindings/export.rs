//! Texts for files: tables of sprites, made whole, as texts of the script's own are bounded for what they are.
//!
//! Sprites are placed once a run, which changes nothing; the time that takes is the scene's and not the script's.

use super::convert::{kind, list, number, text};
use super::placed::Placed;
use super::{Answer, Shared, Usage};
use crate::error::{Said, did_you_mean};
use crate::limits::{EXPORTED_BYTES, Hears, Patience};
use crate::recorder::Recorder;
use cloudwright_core::derived::Derived;
use cloudwright_core::sprites::Sprite;
use cloudwright_core::weather::{CloudNow, WeatherRules};
use rhai::{Array, Dynamic, Engine, Map};
use std::borrow::Cow;
use std::cell::Cell;
use std::fmt::Write;
use std::rc::Rc;
use std::time::Duration;

pub(super) const USAGE: &[Usage] = &[(
    "sprite_table",
    "sprite_table(#{ columns: [\"x\", \"-z\", \"y\"], separator: \" \", at_s: 0.0, scale: 1.0, head: false })",
    "All sprites at a second of the clock, a line each, for an exporter to return. A minus changes a number's sign.",
)];

/// A longer one is a mistake.
const SEPARATOR_BYTES: usize = 8;
/// More would be each of them twice.
const MOST_COLUMNS: usize = 32;
/// So many sprites pass between two looks at the clock.
const SPRITES_A_LOOK: usize = 1024;

/// What an exporter's run has made so far.
pub(crate) struct Exported {
    placed: Rc<Placed>,
    bytes: Cell<usize>,
}

/// A text that is larger than the engine lets texts be.
#[derive(Debug, Clone)]
struct Text(Rc<str>);

impl Exported {
    pub(crate) fn new(patience: &Patience, hears: Hears) -> Self {
        Self { placed: Rc::new(Placed::new(patience, Some(hears))), bytes: Cell::default() }
    }

    /// The sprites that it writes.
    pub(super) fn placed(&self) -> &Rc<Placed> {
        &self.placed
    }

    /// How long placing sprites took.
    pub(crate) fn unasked(&self) -> Duration {
        self.placed.took()
    }

    fn table(&self, recorder: &Recorder, table: &Table) -> Result<Text, Said> {
        self.placed.tell(recorder, |derived| self.table_of(derived, table))
    }

    fn table_of(&self, derived: &Derived, table: &Table) -> Result<Text, Said> {
        let clouds = derived.clouds_at(table.at_s, WeatherRules::default());
        let mut text = String::new();
        if table.head {
            let names: Vec<String> = table.columns.iter().map(|column| column.name()).collect();
            text += &(names.join(&table.separator) + "\n");
        }
        let mut seen = 0_usize;
        for cloud in &clouds {
            for index in 0..cloud.placed.sprites.len() {
                if seen.is_multiple_of(SPRITES_A_LOOK) {
                    self.placed.look(self.unasked())?;
                }
                seen += 1;
                table.row(cloud, &cloud.sprite_now(index), &mut text);
                if self.bytes.get() + text.len() > EXPORTED_BYTES {
                    return Err(too_large());
                }
            }
        }
        self.bytes.set(self.bytes.get() + text.len());
        Ok(Text(text.into()))
    }
}

fn too_large() -> Said {
    Said::limit(format!("more than {} MiB for a file", EXPORTED_BYTES >> 20), "fewer columns, or a smaller scene")
}

macro_rules! columns {
    ($($Column:ident: $name:literal, $signed:literal;)*) => {
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        enum Field { $($Column,)* }

        /// With their names, those of `cloudwright export`, and whether they are measures whose sign may change.
        const FIELDS: &[(Field, &str, bool)] = &[$((Field::$Column, $name, $signed),)*];
    };
}
columns! {
    Cloud: "cloud", false;
    Name: "name", false;
    Category: "category", false;
    Box: "box", false;
    Index: "index", false;
    X: "x", true;
    Y: "y", true;
    Z: "z", true;
    Width: "width", false;
    Height: "height", false;
    Rotation: "rotation_deg", true;
    Tile: "tile", false;
    Group: "group", false;
}

#[derive(Debug, Clone, Copy)]
struct Column {
    field: Field,
    negative: bool,
}

impl Column {
    fn read(what: &str, value: &Dynamic) -> Result<Self, Said> {
        let given = text(what, value)?;
        let (name, negative) = given.strip_prefix('-').map_or((given.as_str(), false), |name| (name, true));
        let Some((field, _, signed)) = FIELDS.iter().find(|(_, known, _)| *known == name) else {
            let names = FIELDS.iter().map(|(_, name, _)| *name);
            let near = did_you_mean(name, names.clone());
            let all = format!("the columns are {}", names.collect::<Vec<_>>().join(", "));
            return Err(Said::script(format!("{what} is “{given}”"), if near.is_empty() { all } else { near }));
        };
        if negative && !signed {
            return Err(Said::script(format!("{what} is “{given}”"), format!("{name} has no sign to change")));
        }
        Ok(Self { field: *field, negative })
    }

    fn name(self) -> String {
        let name = FIELDS.iter().find(|(field, ..)| *field == self.field).map_or("", |(_, name, _)| *name);
        format!("{}{name}", if self.negative { "-" } else { "" })
    }
}

/// What to write.
#[derive(Debug)]
struct Table {
    columns: Vec<Column>,
    separator: String,
    at_s: f64,
    scale: f64,
    head: bool,
}

impl Table {
    fn read(fields: &Map) -> Result<Self, Said> {
        const NAMES: [&str; 5] = ["columns", "separator", "at_s", "scale", "head"];
        if let Some(name) = fields.keys().find(|name| !NAMES.contains(&name.as_str())) {
            return Err(Said::script(format!("sprite_table: there is no `{name}`"), did_you_mean(name, NAMES)));
        }
        let columns = match fields.get("columns") {
            Some(given) => list("columns", given)?,
            None => ["x", "y", "z"].map(Dynamic::from).to_vec(),
        };
        if columns.is_empty() || columns.len() > MOST_COLUMNS {
            let message = format!("columns is a list of {}", columns.len());
            return Err(Said::script(message, format!("1 to {MOST_COLUMNS} names")));
        }
        let columns = columns.iter().enumerate().map(|(i, each)| Column::read(&format!("columns[{i}]"), each));
        let separator = fields.get("separator").map_or(Ok(" ".into()), |given| text("separator", given))?;
        let fits = (1..=SEPARATOR_BYTES).contains(&separator.len());
        if !fits || separator.contains(['\n', '\r', '"']) {
            let hint = "a few letters, such as \" \", \",\" or \"\\t\", and no quote or end of line";
            return Err(Said::script("separator is no text between columns", hint));
        }
        let scale = fields.get("scale").map_or(Ok(1.0), |given| number("scale", given))?;
        if !(1e-6..=1e6).contains(&scale) {
            return Err(Said::script(format!("scale is {scale}"), "1e-6 to 1e6, units of the file a metre"));
        }
        let head = fields.get("head").map_or(Ok(false), |given| {
            given.as_bool().map_err(|_| Said::script(format!("head is {}", kind(given)), "true or false"))
        })?;
        let at_s = fields.get("at_s").map_or(Ok(0.0), |given| number("at_s", given))?;
        Ok(Self { columns: columns.collect::<Result<_, _>>()?, separator, at_s, scale, head })
    }

    fn row(&self, cloud: &CloudNow<'_>, sprite: &Sprite, out: &mut String) {
        let position = cloud.origin() + sprite.position.as_dvec3();
        for (i, column) in self.columns.iter().enumerate() {
            if i > 0 {
                out.push_str(&self.separator);
            }
            let sign = if column.negative { -1.0 } else { 1.0 };
            // Adding 0 turns −0 into 0.
            let length = |metres: f64| sign * metres * self.scale + 0.0;
            // Writing into a text never fails.
            let _ = match column.field {
                Field::X => write!(out, "{:.4}", length(position.x)),
                Field::Y => write!(out, "{:.4}", length(position.y)),
                Field::Z => write!(out, "{:.4}", length(position.z)),
                Field::Width => write!(out, "{:.4}", length(sprite.width.into())),
                Field::Height => write!(out, "{:.4}", length(sprite.height.into())),
                Field::Rotation => write!(out, "{:.4}", sign * f64::from(sprite.rotation).to_degrees() + 0.0),
                Field::Cloud => write!(out, "{}", cloud.placed.id),
                Field::Name => out.write_str(&self.quoted(&cloud.placed.name)),
                Field::Category => write!(out, "{}", cloud.placed.category.name()),
                Field::Box => write!(out, "{}", sprite.box_id),
                Field::Index => write!(out, "{}", sprite.index),
                Field::Tile => write!(out, "{}", sprite.tile),
                Field::Group => match cloud.groups().get(sprite.group as usize) {
                    Some(group) => write!(out, "{}", group.key),
                    None => Ok(()),
                },
            };
        }
        out.push('\n');
    }

    /// As in RFC 4180: quoted where it must be.
    fn quoted<'t>(&self, text: &'t str) -> Cow<'t, str> {
        if text.contains(&self.separator) || text.contains(['"', '\n', '\r']) {
            format!("\"{}\"", text.replace('"', "\"\"")).into()
        } else {
            text.into()
        }
    }
}

/// What a run returned, for a file: a text, a table, or a list of them, one after the other.
pub(crate) fn whole_text(returned: &Dynamic) -> Result<String, Said> {
    let mut whole = String::new();
    let pieces = match returned.read_lock::<Array>() {
        Some(pieces) => pieces.clone(),
        None => vec![returned.clone()],
    };
    for piece in pieces {
        if let Some(Text(table)) = piece.read_lock::<Text>().as_deref() {
            whole += table;
        } else if let Ok(text) = piece.clone().into_immutable_string() {
            whole += &text;
        } else {
            let message = format!("an exporter's run returns {}, where a text is expected", kind(&piece));
            return Err(Said::script(message, "a text, a table of sprites, or a list of them"));
        }
        if whole.len() > EXPORTED_BYTES {
            return Err(too_large());
        }
    }
    Ok(whole)
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared, exported: Option<&Rc<Exported>>) {
    engine.register_type_with_name::<Text>("Text");
    let (own, exported) = (Rc::clone(recorder), exported.cloned());
    engine.register_fn("sprite_table", move |fields: Map| -> Answer<Text> {
        let Some(exported) = &exported else {
            return Err(Said::script("sprite_table is for exporters", "kind: \"exporter\"").into());
        };
        let table = Table::read(&fields)?;
        Ok(exported.table(&own.borrow(), &table)?)
    });
}
