//! OpenUSD's text, `.usda`: prims within prims, with attributes, their samples in time, and relationships.
//!
//! Numbers stand in their shortest form. Names of prims are ASCII identifiers, of which each parent has every one once;
//! what things are called stands in `displayName`. Source: the format as OpenUSD's documentation and reader have it.

use std::collections::BTreeSet;
use std::fmt::{Display, Write};

/// A stage's text while it is made.
#[derive(Debug, Default)]
pub struct Text {
    text: String,
    depth: usize,
}

/// Names that a parent's children have.
#[derive(Debug, Default)]
pub struct Names(BTreeSet<String>);

impl Text {
    /// A stage with lines of metadata: `upAxis = "Y"`.
    pub fn new(metadata: &[String]) -> Self {
        let mut text = Self { text: "#usda 1.0\n".into(), depth: 0 };
        text.metadata(metadata);
        text.text.push('\n');
        text
    }

    /// A prim: `def Xform "clouds"`, with lines of metadata and what `fill` puts into it.
    pub fn prim(&mut self, head: &str, metadata: &[String], fill: impl FnOnce(&mut Self)) {
        self.line(head);
        self.metadata(metadata);
        self.line("{");
        self.depth += 1;
        fill(self);
        self.depth -= 1;
        self.line("}");
    }

    /// A line: an attribute without a value, or all that stands on one.
    pub fn line(&mut self, line: &str) {
        self.indent();
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// An attribute, `double3 xformOp:translate`, or a relationship, `rel material:binding`, with its value.
    pub fn set(&mut self, declared: &str, value: impl Display) {
        self.indent();
        let _ = writeln!(self.text, "{declared} = {value}");
    }

    /// A list of many values, those of each item together, with what follows it.
    pub fn list<T: Display, const N: usize>(
        &mut self,
        declared: &str,
        items: impl Iterator<Item = [T; N]>,
        metadata: &str,
    ) {
        self.indent();
        let _ = writeln!(self.text, "{declared} = [");
        for (at, item) in items.enumerate() {
            // Lines of a length that editors take.
            self.text.push_str(match at {
                0 => "",
                _ if at * N % 32 < N => ",\n",
                _ => ",",
            });
            for (at, value) in item.into_iter().enumerate() {
                let _ = write!(self.text, "{}{value}", if at > 0 { "," } else { "" });
            }
        }
        let _ = writeln!(self.text, "]{metadata}");
    }

    /// An attribute's values at times, if there are any.
    pub fn samples<T: Display>(&mut self, declared: &str, samples: impl Iterator<Item = (f64, T)>) {
        self.indent();
        let _ = writeln!(self.text, "{declared}.timeSamples = {{");
        for (time, value) in samples {
            self.indent();
            let _ = writeln!(self.text, "    {}: {value},", Number(time, 1e6));
        }
        self.line("}");
    }

    /// All of it.
    pub fn finish(self) -> String {
        self.text
    }

    fn metadata(&mut self, lines: &[String]) {
        if lines.is_empty() {
            return;
        }
        self.line("(");
        self.depth += 1;
        lines.iter().for_each(|line| self.line(line));
        self.depth -= 1;
        self.line(")");
    }

    fn indent(&mut self) {
        self.text.extend(std::iter::repeat_n("    ", self.depth));
    }
}

impl Names {
    /// A name like `wanted` that no one has yet.
    pub fn free(&mut self, wanted: &str) -> String {
        let mut name: String = wanted.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        if !name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
            name.insert(0, '_');
        }
        let mut free = name.clone();
        let mut count = 1;
        while !self.0.insert(free.clone()) {
            count += 1;
            free = format!("{name}_{count}");
        }
        free
    }
}

/// A number in steps of one over that many, without an end of zeros.
#[derive(Debug, Clone, Copy)]
pub struct Number(pub f64, pub f64);

impl Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self(number, steps) = *self;
        // Beyond that a number has no such steps. A sum with 0 takes the sign from 0.
        let rounded = if number.abs() < 1e9 { (number * steps).round() / steps } else { number };
        write!(f, "{}", rounded + 0.0)
    }
}

/// Numbers in brackets: `(1,2,3)`.
#[derive(Debug, Clone, Copy)]
pub struct Tuple<const N: usize>(pub [Number; N]);

impl<const N: usize> Tuple<N> {
    /// Of numbers in those steps.
    pub fn of(numbers: [f64; N], steps: f64) -> Self {
        Self(numbers.map(|number| Number(number, steps)))
    }
}

impl<const N: usize> Display for Tuple<N> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (at, number) in self.0.iter().enumerate() {
            write!(f, "{}{number}", if at > 0 { "," } else { "(" })?;
        }
        f.write_char(')')
    }
}

/// Text in quotes.
pub fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// A file beside this one: `@./sky_atlas.png@`.
pub fn beside(file_name: &str) -> String {
    let name: String = file_name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // What holds the sign stands between three of them, and of three in the name the reader wants a backslash before.
    if name.contains('@') { format!("@@@./{}@@@", name.replace("@@@", "\\@@@")) } else { format!("@./{name}@") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases = [(0.1 + 0.2, 1e6, "0.3"), (-0.001, 1e2, "0"), (1200.0, 1e2, "1200"), (-7.126, 1e2, "-7.13")];
        for (number, steps, wanted) in cases {
            assert_eq!(Number(number, steps).to_string(), wanted);
        }
        assert_eq!(Tuple::of([1.0, -0.5, 1.0 / 3.0], 1e3).to_string(), "(1,-0.5,0.333)");
    }

    #[test]
    fn names_are_identifiers_and_each_is_one_things() {
        let mut names = Names::default();
        let wanted = ["west", "west", "west_2", "7 äpfel", "", "-"];
        let got = wanted.map(|name| names.free(name));
        assert_eq!(got, ["west", "west_2", "west_2_2", "_7__pfel", "_", "__2"]);
    }

    #[test]
    fn text_and_files_hold_any_name() {
        assert_eq!(quoted("a \"b\" \\ c\nd\u{7}"), "\"a \\\"b\\\" \\\\ c\\nd \"");
        let files = ["sky.png", "a@b.png", "a@@@b"].map(beside);
        assert_eq!(files, ["@./sky.png@", "@@@./a@b.png@@@", "@@@./a\\@@@b@@@"]);
    }
}
