//! JSON for people and for diffs: small things on one line, the rest indented.
//!
//! A list or object goes on one line if it fits and holds nothing nested deeper than a list of numbers, so a colour or
//! a corner is a line and a diff shows what changed.

use rayon::prelude::*;
use serde_json::Value;
use std::fmt::Write;
use std::io;

/// Up to this length a list or object stays on one line.
const LINE: usize = 110;
/// Items of a list whose text is made in parallel: some megabytes.
const AT_A_TIME: usize = 2048;

/// `value` as text, ending in a newline.
pub fn write(value: &Value) -> String {
    let mut out = String::new();
    write_value(value, 0, &mut out);
    out.push('\n');
    out
}

/// Writes an object field by field, so that no more than one item of a long list stands in memory.
#[derive(Debug)]
pub struct LongObject<'a, W> {
    out: &'a mut W,
    indent: usize,
    is_empty: bool,
}

impl<'a, W: io::Write> LongObject<'a, W> {
    /// Begins one, `indent` spaces in.
    ///
    /// # Errors
    /// Those of `out`, as with all that follows.
    pub fn begin(out: &'a mut W, indent: usize) -> io::Result<Self> {
        write!(out, "{{")?;
        Ok(Self { out, indent, is_empty: true })
    }

    /// Writes a field.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn field(&mut self, name: &str, value: &Value) -> io::Result<()> {
        self.name(name)?;
        let mut text = String::new();
        write_value(value, self.indent + 2, &mut text);
        self.out.write_all(text.as_bytes())
    }

    /// Writes a field that is a list of `items`, each a tree as long as it is written; some at a time, in parallel.
    ///
    /// # Errors
    /// Those of `out` and of `tree_of`.
    pub fn list<T: Send>(
        &mut self,
        name: &str,
        mut items: impl Iterator<Item = T>,
        tree_of: impl Fn(T) -> serde_json::Result<Value> + Sync,
    ) -> io::Result<()> {
        let indent = self.indent + 4;
        let text_of = |item| {
            let mut text = String::new();
            tree_of(item).map(|tree| write_value(&tree, indent, &mut text)).map(|()| text)
        };
        let texts = std::iter::from_fn(|| {
            let some: Vec<T> = items.by_ref().take(AT_A_TIME).collect();
            let texts = some.into_par_iter().map(text_of).collect::<Vec<_>>();
            (!texts.is_empty()).then_some(texts)
        });
        self.list_by(name, texts.flatten(), |out, text| out.write_all(text?.as_bytes()))
    }

    /// Writes a field that is a list of `items`, each written by `write_item`, 4 spaces further in than the object.
    ///
    /// # Errors
    /// Those of `out` and of `write_item`.
    pub fn list_by<T>(
        &mut self,
        name: &str,
        items: impl Iterator<Item = T>,
        mut write_item: impl FnMut(&mut W, T) -> io::Result<()>,
    ) -> io::Result<()> {
        self.name(name)?;
        write!(self.out, "[")?;
        let mut is_empty = true;
        for item in items {
            let between = if is_empty { "" } else { "," };
            write!(self.out, "{between}\n{:1$}", "", self.indent + 4)?;
            write_item(self.out, item)?;
            is_empty = false;
        }
        if !is_empty {
            write!(self.out, "\n{:1$}", "", self.indent + 2)?;
        }
        write!(self.out, "]")
    }

    /// Ends it.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn end(self) -> io::Result<()> {
        write!(self.out, "\n{:1$}}}", "", self.indent)
    }

    fn name(&mut self, name: &str) -> io::Result<()> {
        let between = if self.is_empty { "" } else { "," };
        self.is_empty = false;
        write!(self.out, "{between}\n{:2$}{}: ", "", Value::from(name), self.indent + 2)
    }
}

/// Appends `value`, `indent` spaces in.
pub fn write_value(value: &Value, indent: usize, out: &mut String) {
    if depth(value, 2) < 2 || matches!(value, Value::Object(map) if map.values().all(|v| depth(v, 2) < 2)) {
        let line = one_line(value);
        if line.len() + indent <= LINE {
            out.push_str(&line);
            return;
        }
    }
    let inner = indent + 2;
    match value {
        Value::Array(items) if !items.is_empty() => {
            lines('[', ']', items.iter().map(|item| (None, item)), inner, out);
        }
        Value::Object(map) if !map.is_empty() => {
            lines('{', '}', map.iter().map(|(key, item)| (Some(key), item)), inner, out);
        }
        _ => out.push_str(&one_line(value)),
    }
}

fn lines<'a>(
    open: char,
    close: char,
    items: impl Iterator<Item = (Option<&'a String>, &'a Value)>,
    indent: usize,
    out: &mut String,
) {
    out.push(open);
    for (i, (key, item)) in items.enumerate() {
        out.push_str(if i > 0 { ",\n" } else { "\n" });
        out.extend(std::iter::repeat_n(' ', indent));
        if let Some(key) = key {
            let _ = write!(out, "{}: ", Value::from(key.as_str()));
        }
        write_value(item, indent, out);
    }
    out.push('\n');
    out.extend(std::iter::repeat_n(' ', indent - 2));
    out.push(close);
}

/// 0 for a scalar, 1 for a list or object of scalars, and so on, up to `most`.
fn depth(value: &Value, most: usize) -> usize {
    let within = |values: &mut dyn Iterator<Item = &Value>| 1 + values.map(|v| depth(v, most - 1)).max().unwrap_or(0);
    match value {
        _ if most == 0 => 0,
        Value::Array(items) => within(&mut items.iter()),
        Value::Object(map) => within(&mut map.values()),
        _ => 0,
    }
}

/// As serde_json's compact form, with a space after commas and colons.
fn one_line(value: &Value) -> String {
    match value {
        Value::Array(items) => format!("[{}]", items.iter().map(one_line).collect::<Vec<_>>().join(", ")),
        Value::Object(map) if map.is_empty() => "{}".into(),
        Value::Object(map) => {
            let fields: Vec<_> =
                map.iter().map(|(key, item)| format!("{}: {}", Value::from(key.as_str()), one_line(item))).collect();
            format!("{{ {} }}", fields.join(", "))
        }
        // Whole numbers without a fraction: 200, not 200.0.
        Value::Number(number) => match number.as_f64() {
            Some(x) if number.is_f64() && x == x.trunc() && x.abs() < 9e15 => (x as i64).to_string(),
            _ => number.to_string(),
        },
        _ => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn small_things_on_one_line() {
        let value = serde_json::json!({
            "name": "a \"b\" {  }",
            "color": [0.5, 1.0, 2],
            "keys": [{ "hour": 1.0, "value": [1, 2, 3] }, { "hour": 2.5, "value": [] }],
            "none": {},
        });
        let want = "{\n  \"name\": \"a \\\"b\\\" {  }\",\n  \"color\": [0.5, 1, 2],\n  \"keys\": [\n    { \"hour\": 1, \"value\": [1, 2, 3] },\n    { \"hour\": 2.5, \"value\": [] }\n  ],\n  \"none\": {}\n}\n";
        assert_eq!(super::write(&value), want);
    }
}
