//! JSON for people and for diffs: small things on one line, the rest indented.
//!
//! A list or object goes on one line if it fits and holds nothing nested deeper than a list of numbers, so a colour or
//! a corner is a line and a diff shows what changed.

use serde_json::Value;
use std::fmt::Write;

/// Up to this length a list or object stays on one line.
const LINE: usize = 110;

/// `value` as text, ending in a newline.
pub fn write(value: &Value) -> String {
    let mut out = String::new();
    write_value(value, 0, &mut out);
    out.push('\n');
    out
}

/// Appends an object, `indent` spaces in, whose last field is a long list: `item(out, i)` appends one item, `indent` + 4
/// spaces in. So only one item at a time stands in memory as a tree.
pub fn write_list<E>(
    out: &mut String,
    indent: usize,
    head: &[(&str, Value)],
    (name, count): (&str, usize),
    mut item: impl FnMut(&mut String, usize) -> Result<(), E>,
) -> Result<(), E> {
    let new_line = |out: &mut String, indent: usize| {
        out.push('\n');
        out.extend(std::iter::repeat_n(' ', indent));
    };
    out.push('{');
    for (key, value) in head {
        new_line(out, indent + 2);
        let _ = write!(out, "{}: ", Value::from(*key));
        write_value(value, indent + 2, out);
        out.push(',');
    }
    new_line(out, indent + 2);
    let _ = write!(out, "{}: [", Value::from(name));
    for i in 0..count {
        out.push_str(if i > 0 { "," } else { "" });
        new_line(out, indent + 4);
        item(out, i)?;
    }
    if count > 0 {
        new_line(out, indent + 2);
    }
    out.push(']');
    new_line(out, indent);
    out.push('}');
    Ok(())
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
