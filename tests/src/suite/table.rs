//! Every method in every situation.

use super::{Situation, Stage, situations};
use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::draw::Drawn;
use cloudwright_core::method::{Family, METHODS, Method, truth};
use cloudwright_core::rules::Rasterizer;

/// What came of a situation.
pub struct Row {
    /// Which.
    pub situation: &'static Situation,
    /// A cell for each method that can be judged on the CPU.
    pub cells: Vec<Cell>,
    /// What is not as the table says, in words; nothing, if all is well.
    pub faults: Vec<String>,
}

/// What came of a method in a situation.
pub struct Cell {
    /// Which method.
    pub method: &'static Method,
    /// The situation's figure; none where the method has none.
    pub figure: Option<f64>,
    /// Whether it must break the bound, must keep it, or neither.
    pub must: Option<Must>,
    /// Whether it keeps the bound.
    pub keeps: bool,
}

/// What the table says of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Must {
    /// It is shipped.
    Keep,
    /// It is known to fail there.
    Break,
}

/// Runs every method through every situation.
pub fn judge() -> Vec<Row> {
    situations().map(judged).collect()
}

fn judged(situation: &'static Situation) -> Row {
    let stage = (situation.stage)();
    let mut faults = Vec::new();
    let truths = stage.draw(&truth().rules).unwrap_or_default();
    note_odd_pixels(truth(), &truths, &mut faults);
    let judged = METHODS.iter().filter(|method| method.rules.rasterizer != Rasterizer::Truth);
    let cells = judged.filter_map(|method| cell(situation, &stage, method, &truths, &mut faults)).collect();
    let known = |name: &&&str| METHODS.iter().any(|method| method.name == **name);
    faults.extend(situation.breaks.iter().filter(|name| !known(name)).map(|name| format!("there is no method {name}")));
    Row { situation, cells, faults }
}

/// None for what runs on a GPU.
fn cell(
    situation: &Situation,
    stage: &Stage,
    method: &'static Method,
    truths: &[Drawn],
    faults: &mut Vec<String>,
) -> Option<Cell> {
    let pictures = stage.draw(&method.rules)?;
    note_odd_pixels(method, &pictures, faults);
    let bound = &situation.bound;
    let figure = bound.figure.of(stage, &method.rules, &pictures, truths);
    let must = match method.family {
        Family::Shipped => Some(Must::Keep),
        _ => situation.breaks.contains(&method.name).then_some(Must::Break),
    };
    // What is no number keeps nothing.
    let keeps = figure.is_some_and(|figure| figure <= bound.at_most);
    let wrong = match must {
        Some(Must::Keep) => !keeps,
        Some(Must::Break) => keeps || figure.is_none(),
        None => false,
    };
    if wrong {
        let does = if keeps { "keeps" } else { "breaks" };
        faults.push(format!("{} {does} the bound {}: {figure:?}", method.name, bound.at_most));
    }
    Some(Cell { method, figure, must, keeps })
}

/// Whatever a method gets wrong, each pixel is a number.
fn note_odd_pixels(method: &Method, pictures: &[Drawn], faults: &mut Vec<String>) {
    let color = |pixel: &Rgb| pixel.to_array().iter().all(|channel| channel.is_finite());
    let cloud = |&Premultiplied { r, g, b, a }: &Premultiplied| [r, g, b, a].iter().all(|channel| channel.is_finite());
    let finite = |drawn: &Drawn| {
        drawn.linear.pixels.iter().all(color)
            && drawn.clouds.as_ref().is_none_or(|clouds| clouds.pixels.iter().all(cloud))
    };
    if let Some(at) = pictures.iter().position(|drawn| !finite(drawn)) {
        faults.push(format!("{}: picture {at} has pixels that are no numbers", method.name));
    }
}
