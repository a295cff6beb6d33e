//! XML as a tree of elements, bounded: for formats that are XML, and whose readers keep what they do not know.
//!
//! Crate quick-xml finds the tags. Here is what else keeps a file from harm: no document type (so no entities of its own,
//! which could grow without end), a bound on depth and on the number of elements. Processing instructions are passed over.

use super::Misread;
use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::fmt::Write;

/// Elements within one another.
pub const MOST_DEEP: usize = 64;
/// Elements, comments and texts of a file.
pub const MOST_NODES: usize = 500_000;
/// Attributes of an element: each is compared with all before it.
pub const MOST_ATTRIBUTES: usize = 256;

/// An element.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Element {
    /// Its tag.
    pub name: String,
    /// In their order.
    pub attributes: Vec<(String, String)>,
    /// What stands in it.
    pub children: Vec<Node>,
    /// Where its tag stands in the file, from 1; 0 if it is in none.
    pub line: usize,
}

/// What stands in an element.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// Another one.
    Element(Element),
    /// Text, without the white space around it.
    Text(String),
    /// Words for people.
    Comment(String),
}

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Whether it begins with a byte order mark.
    pub byte_order_mark: bool,
    /// "\n" or "\r\n".
    pub line_end: &'static str,
    /// White space for each step in.
    pub indent: &'static str,
    /// Whether what holds nothing is written as a tag and its end all the same.
    pub closes: bool,
    /// Whether there is a first line that says that this is XML.
    pub declares: bool,
}

impl Element {
    /// An empty one.
    pub fn new(name: &str) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// One with a text.
    pub fn with_text(name: &str, text: impl Into<String>) -> Self {
        Self { children: vec![Node::Text(text.into())], ..Self::new(name) }
    }

    /// The same with another attribute.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Into<String>) -> Self {
        self.attributes.push((name.into(), value.into()));
        self
    }

    /// Adds an element at its end.
    pub fn push(&mut self, element: Self) {
        self.children.push(Node::Element(element));
    }

    /// The elements in it.
    pub fn elements(&self) -> impl Iterator<Item = &Self> {
        self.children.iter().filter_map(|node| match node {
            Node::Element(element) => Some(element),
            _ => None,
        })
    }

    /// The first element of that name in it.
    pub fn element(&self, name: &str) -> Option<&Self> {
        self.elements().find(|element| element.name == name)
    }

    /// An attribute's value; of names, case counts.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// Its texts, joined.
    pub fn text(&self) -> String {
        let texts = self.children.iter().filter_map(|node| match node {
            Node::Text(text) => Some(text.as_str()),
            _ => None,
        });
        texts.collect::<Vec<_>>().join(" ")
    }

    /// Something wrong with it.
    pub fn misread(&self, message: impl std::fmt::Display) -> Misread {
        Misread::new(format!("line {}", self.line), format!("{}: {message}", self.name))
    }

    /// `text`, which stands in it, as a number.
    ///
    /// # Errors
    /// If it is none, or not finite.
    pub fn number(&self, text: &str) -> Result<f64, Misread> {
        let number = text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| self.misread(format_args!("“{text}” is no number")))
    }
}

/// The root of a file.
///
/// # Errors
/// If it is no XML in UTF-8, has a document type, or is beyond the bounds.
pub fn read(bytes: &[u8]) -> Result<Element, Misread> {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(Misread::new("byte 0", "it is in UTF-16; save it as UTF-8"));
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Misread::new(format!("byte {}", error.valid_up_to()), "it is no text in UTF-8"))?;
    let mut building = Building { text, open: Vec::new(), root: None, written: String::new(), nodes: 0 };
    let mut reader = Reader::from_str(text);
    loop {
        let at = reader.buffer_position() as usize;
        match reader.read_event() {
            Err(error) => return Err(building.misread(reader.error_position() as usize, error)),
            Ok(Event::Eof) => return building.done(),
            Ok(event) => building.take(at, event)?,
        }
    }
}

/// A tree while it is read.
struct Building<'a> {
    text: &'a str,
    /// From the root to the innermost that has not ended.
    open: Vec<Element>,
    root: Option<Element>,
    /// Text of the innermost one since its last tag.
    written: String,
    nodes: usize,
}

impl Building<'_> {
    fn line(&self, at: usize) -> usize {
        1 + self.text.as_bytes()[..at.min(self.text.len())].iter().filter(|byte| **byte == b'\n').count()
    }

    fn misread(&self, at: usize, message: impl std::fmt::Display) -> Misread {
        Misread::new(format!("line {}", self.line(at)), message.to_string())
    }

    fn take(&mut self, at: usize, event: Event<'_>) -> Result<(), Misread> {
        match event {
            Event::Start(tag) => self.begin(at, &tag),
            Event::Empty(tag) => {
                self.begin(at, &tag)?;
                self.end(at)
            }
            Event::End(_) => self.end(at),
            Event::Text(text) => self.write(at, &text.decode().map_err(|error| self.misread(at, error))?),
            Event::CData(text) => self.write(at, &text.decode().map_err(|error| self.misread(at, error))?),
            Event::GeneralRef(reference) => {
                let character = self.character(at, &reference)?;
                self.write(at, character.encode_utf8(&mut [0; 4]))
            }
            Event::Comment(words) => {
                let words = words.decode().map_err(|error| self.misread(at, error))?.trim().to_owned();
                self.add(at, Node::Comment(words))
            }
            Event::DocType(_) => Err(self.misread(at, "it has a document type, which is not read")),
            Event::Decl(_) | Event::PI(_) | Event::Eof => Ok(()),
        }
    }

    fn begin(&mut self, at: usize, tag: &BytesStart<'_>) -> Result<(), Misread> {
        self.flush(at)?;
        if self.open.len() == MOST_DEEP {
            return Err(self.misread(at, format_args!("more than {MOST_DEEP} elements stand within one another")));
        }
        if self.open.is_empty() && self.root.is_some() {
            return Err(self.misread(at, "a second root stands behind the first"));
        }
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        // Counting lines for every element of a long file would take long: only the last one's is looked for.
        let mut element = Element { name: text(tag.name().as_ref()), line: at, ..Element::default() };
        for attribute in tag.attributes() {
            let attribute = attribute.map_err(|error| self.misread(at, error))?;
            if element.attributes.len() == MOST_ATTRIBUTES {
                return Err(self.misread(at, format_args!("an element has more than {MOST_ATTRIBUTES} attributes")));
            }
            let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| self.misread(at, error))?;
            element.attributes.push((text(attribute.key.as_ref()), value.into_owned()));
        }
        self.open.push(element);
        Ok(())
    }

    fn end(&mut self, at: usize) -> Result<(), Misread> {
        self.flush(at)?;
        let Some(element) = self.open.pop() else { return Err(self.misread(at, "an element ends that has not begun")) };
        if self.open.is_empty() {
            self.root = Some(element);
            return Ok(());
        }
        self.add(at, Node::Element(element))
    }

    fn character(&self, at: usize, reference: &BytesRef<'_>) -> Result<char, Misread> {
        let name = reference.decode().map_err(|error| self.misread(at, error))?;
        let found = match (&*name, reference.resolve_char_ref()) {
            (_, Err(error)) => return Err(self.misread(at, error)),
            (_, Ok(Some(character))) => Some(character),
            ("lt", _) => Some('<'),
            ("gt", _) => Some('>'),
            ("amp", _) => Some('&'),
            ("quot", _) => Some('"'),
            ("apos", _) => Some('\''),
            _ => None,
        };
        found.ok_or_else(|| self.misread(at, format_args!("the entity “{name}” is not known")))
    }

    fn write(&mut self, at: usize, text: &str) -> Result<(), Misread> {
        if self.open.is_empty() && !text.trim().is_empty() {
            return Err(self.misread(at, "text stands outside the root"));
        }
        self.written.push_str(text);
        Ok(())
    }

    /// The text so far is one of the innermost element's children.
    fn flush(&mut self, at: usize) -> Result<(), Misread> {
        let text = std::mem::take(&mut self.written);
        let text = text.trim();
        if text.is_empty() { Ok(()) } else { self.add(at, Node::Text(text.into())) }
    }

    fn add(&mut self, at: usize, node: Node) -> Result<(), Misread> {
        self.nodes += 1;
        if self.nodes > MOST_NODES {
            return Err(self.misread(at, format_args!("it has more than {MOST_NODES} elements")));
        }
        // Words beside the root are no part of it.
        if let Some(parent) = self.open.last_mut() {
            parent.children.push(node);
        }
        Ok(())
    }

    fn done(mut self) -> Result<Element, Misread> {
        if let Some(open) = self.open.last() {
            let message = format!("it ends within {}", open.name);
            return Err(self.misread(self.text.len(), message));
        }
        let mut root = self.root.take().ok_or_else(|| Misread::new("line 1", "it has no element"))?;
        number_lines(&mut root, &mut Lines { text: self.text.as_bytes(), at: 0, line: 1 });
        Ok(root)
    }
}

/// Counts lines along a text.
struct Lines<'a> {
    text: &'a [u8],
    at: usize,
    line: usize,
}

/// Places in the text become lines; elements stand in the order of their tags.
fn number_lines(element: &mut Element, lines: &mut Lines<'_>) {
    let at = element.line.clamp(lines.at, lines.text.len());
    lines.line += lines.text[lines.at..at].iter().filter(|byte| **byte == b'\n').count();
    lines.at = at;
    element.line = lines.line;
    for node in &mut element.children {
        if let Node::Element(child) = node {
            number_lines(child, lines);
        }
    }
}

/// A file with that root.
pub fn write(root: &Element, style: Style) -> Vec<u8> {
    let mut out = String::new();
    if style.byte_order_mark {
        out.push('\u{feff}');
    }
    if style.declares {
        let end = style.line_end;
        let _ = write!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>{end}{end}");
    }
    write_element(&mut out, root, style, 0);
    out.into_bytes()
}

fn write_element(out: &mut String, element: &Element, style: Style, depth: usize) {
    let Style { line_end, indent, .. } = style;
    let inset = indent.repeat(depth);
    let _ = write!(out, "{inset}<{}", element.name);
    for (name, value) in &element.attributes {
        let _ = write!(out, " {name}=\"{}\"", escaped(value));
    }
    if element.children.is_empty() && !style.closes {
        let _ = write!(out, "/>{line_end}");
        return;
    }
    out.push('>');
    // A text alone stands on one line with its tags.
    if let [Node::Text(text)] = &element.children[..] {
        out.push_str(&escaped(text));
    } else if !element.children.is_empty() {
        out.push_str(line_end);
        for node in &element.children {
            match node {
                Node::Element(child) => write_element(out, child, style, depth + 1),
                Node::Text(text) => {
                    let _ = write!(out, "{inset}{indent}{}{line_end}", escaped(text));
                }
                Node::Comment(words) => {
                    // Two strokes would end it.
                    let _ = write!(out, "{inset}{indent}<!-- {} -->{line_end}", words.replace("--", "- -"));
                }
            }
        }
        out.push_str(&inset);
    }
    let _ = write!(out, "</{}>{line_end}", element.name);
}

fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            // Within an attribute, these would be read as spaces.
            '\n' | '\r' | '\t' => {
                let _ = write!(out, "&#{};", u32::from(character));
            }
            character => out.push(character),
        }
    }
    out
}
