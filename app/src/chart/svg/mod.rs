//! Cost against error as a drawing: both axes logarithmic, the front a stepped line, every mark with its name.
//!
//! What lies in the soft field beyond the line is beaten by what lies on it. Shape and colour tell a mark's family, so
//! that neither is needed alone; colours come from `style.css`, which knows light and dark. Made by hand: a plotting
//! library has no rails, no leading lines and no dark mode, and this needs no font on the machine that draws.

mod frame;
mod marks;
mod shape;

use super::labels::Rect;
use super::log_axis::LogAxis;
use super::{Family, front, text};

/// The colours and strokes of [`Plot::svg`]; a page has it once for all its charts.
pub const STYLE: &str = include_str!("style.css");

/// A method in a chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark<'a> {
    /// The method's.
    pub name: &'a str,
    /// Its shape and colour.
    pub family: Family,
    /// Cost and error, finite.
    pub at: [f64; 2],
    /// What a click leads to, such as `#card-3`; empty for nothing.
    pub link: String,
}

/// A chart to draw.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot<'a> {
    /// What it shows, in a sentence, for those who can't see it.
    pub title: &'a str,
    /// Name and unit of the cost: "frame time, ms".
    pub cost_title: &'a str,
    /// Name and unit of the error: "FLIP, mean".
    pub error_title: &'a str,
    /// What less of the error is: "truer".
    pub less_error: &'a str,
    /// The methods; those known to fail are drawn over the others.
    pub marks: &'a [Mark<'a>],
    /// The error that is still good enough: a dashed line, if it lies within the chart.
    pub tolerance: Option<f64>,
}

/// How large a drawing is, for the text in it to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// For a window or a sheet of paper.
    Wide,
    /// For a telephone.
    Narrow,
}

impl Shape {
    fn size(self) -> [f64; 2] {
        match self {
            Self::Wide => [960.0, 540.0],
            Self::Narrow => [360.0, 470.0],
        }
    }

    /// Units, which are pixels at the drawing's own size.
    fn text(self) -> f64 {
        match self {
            Self::Wide => 13.5,
            Self::Narrow => 12.0,
        }
    }
}

/// The width of `text` in a common sans serif of `size`, rather too wide: no font is at hand here.
fn text_width(text: &str, size: f64) -> f64 {
    let em = |c: char| match c {
        ' ' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | 'i' | 'j' | 'l' => 0.33,
        '(' | ')' | '[' | ']' | 'f' | 't' | 'r' | 'I' | '-' => 0.42,
        'm' | 'w' | 'M' | 'W' => 0.95,
        c if c.is_uppercase() => 0.74,
        _ => 0.64,
    };
    text.chars().map(em).sum::<f64>() * size
}

/// The places that all parts of a drawing share.
struct Sheet<'a> {
    plot: &'a Plot<'a>,
    size: [f64; 2],
    text: f64,
    /// Of the field with the marks.
    field: Rect,
    cost: LogAxis,
    error: LogAxis,
}

impl<'a> Sheet<'a> {
    fn new(plot: &'a Plot<'a>, shape: Shape) -> Self {
        let ([width, height], text) = (shape.size(), shape.text());
        let along = |i: usize| plot.marks.iter().map(|mark| mark.at[i]).collect::<Vec<_>>();
        let (top, lower, rail) = (text * 4.6, height - text * 3.6, text * 3.2);
        let error = LogAxis::new(&along(1), [lower, top], rail);
        // To the left stand the scale's numbers, to the right half of the last number below.
        let numbers = error.ticks(0.0).into_iter().chain(error.rail()).map(|tick| text_width(&tick.label, text));
        let (left, right) = (numbers.fold(text, f64::max) + text, width - text * 1.8);
        let cost = LogAxis::new(&along(0), [left, right], rail);
        let field = Rect { x: left, y: top, width: right - left, height: lower - top };
        Self { plot, size: [width, height], text, field, cost, error }
    }

    fn at(&self, [cost, error]: [f64; 2]) -> [f64; 2] {
        [self.cost.at(cost), self.error.at(error)]
    }

    /// The front's corners from the top of the field to its right.
    fn front(&self) -> Vec<[f64; 2]> {
        // What is known to fail is no choice.
        let choice = |mark: &Mark<'_>| (mark.family != Family::Failing).then_some(mark.at);
        let points: Vec<_> = self.plot.marks.iter().map(choice).collect();
        let on_front = front::front(&points);
        let best = self.plot.marks.iter().zip(on_front).filter(|(_, on)| *on).map(|(mark, _)| self.at(mark.at));
        front::outline(best.collect(), self.field.y, self.field.x + self.field.width)
    }
}

impl Plot<'_> {
    /// The drawing, for a page that has [`STYLE`].
    pub fn svg(&self, shape: Shape) -> String {
        self.draw(shape, "")
    }

    /// A file of its own, with its colours and a ground to stand on.
    pub fn file(&self, shape: Shape) -> String {
        let ground = r#"<rect width="100%" height="100%" style="fill:var(--raised)"/>"#;
        self.draw(shape, &format!("<style>\n{STYLE}</style>\n{ground}\n")) + "\n"
    }

    fn draw(&self, shape: Shape, head: &str) -> String {
        let sheet = Sheet::new(self, shape);
        let [width, height] = sheet.size;
        let title = text::escape(self.title);
        let mut out = format!(
            r#"<svg class="chart" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="group" aria-label="{title}">"#
        );
        out.push('\n');
        out.push_str(head);
        frame::draw(&sheet, &mut out);
        marks::draw(&sheet, &mut out);
        out.push_str("</svg>");
        out
    }
}
