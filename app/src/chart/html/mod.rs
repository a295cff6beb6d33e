//! `chart.html`: one file to read in a browser, with or without a network, a script or a screen.
//!
//! Pictures are in it as data. Top to bottom: what was looked at, what the figures say in words, cost against error,
//! cost against stability, a card for each method from true to wrong, every figure in a table. All names go through
//! `text::escape`, and the page forbids itself to load anything.

mod card;
mod reading;
mod table;

use super::report::{MethodFigures, Report, Viewpoint};
use super::svg::{self, Mark, Plot, Shape};
use super::{Family, text};
use crate::picture_png;
use cloudwright_core::formats::base64;
use cloudwright_core::image::Picture;
use std::fmt::Write;

/// Mean FLIP that is still good enough unless told otherwise: differences that show only side by side.
pub const DEFAULT_TOLERANCE: f64 = 0.02;

/// All that the page shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Page<'a> {
    /// The figures.
    pub report: &'a Report,
    /// What errors are measured against.
    pub truth: &'a Picture,
    /// What is known of methods beside their figures, in any order; a method may have none.
    pub looks: &'a [Look<'a>],
    /// Mean FLIP that is good enough.
    pub tolerance: f64,
}

/// A method as the eye sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct Look<'a> {
    /// Its name in the report.
    pub name: &'a str,
    /// Its mark.
    pub family: Family,
    /// What it does, or what is wrong with it, in a sentence; may be empty.
    pub about: &'a str,
    /// What it draws; none if that was not kept.
    pub picture: Option<&'a Picture>,
    /// FLIP of each of its picture's pixels, 0 to 1, top row first; empty if that was not kept.
    pub errors: &'a [f32],
}

/// The page's text.
///
/// # Errors
/// If there is not enough memory for the pictures.
pub fn write(page: &Page<'_>) -> Result<String, png::EncodingError> {
    let mut out = String::new();
    head(page, &mut out)?;
    charts(page, &mut out);
    card::all(page, &mut out)?;
    table::write(page, &mut out);
    left_out(page.report, &mut out);
    out.push_str("</main>\n<script>\n");
    out.push_str(include_str!("page.js"));
    out.push_str("</script>\n</body>\n</html>\n");
    Ok(out)
}

impl Page<'_> {
    fn look(&self, method: &MethodFigures) -> Option<&Look<'_>> {
        self.looks.iter().find(|look| look.name == method.name)
    }

    fn family(&self, method: &MethodFigures) -> Family {
        self.look(method).map_or(Family::Other, |look| look.family)
    }

    /// Where the page shows the method at `index` of the report.
    fn card_id(index: usize) -> String {
        format!("method-{index}")
    }
}

fn head(page: &Page<'_>, out: &mut String) -> Result<(), png::EncodingError> {
    let Report { scene, size: [width, height], adapter, view, unfinished, .. } = page.report;
    let scene = text::escape(scene);
    let view = match view {
        Some(Viewpoint::Camera(name)) => format!(" · camera “{}”", text::escape(name)),
        Some(Viewpoint::Path(name)) => format!(" · along the path “{}”", text::escape(name)),
        None => String::new(),
    };
    let _ = write!(
        out,
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>{scene} · speed against accuracy</title>
<style>
{}{}</style>
</head>
<body>
<main>
<div class="top">
<header>
<p class="eyebrow">Cloudwright · speed against accuracy</p>
<h1>{scene}</h1>
<p class="soft">{width} × {height} pixels{view} · {}</p>
"#,
        svg::STYLE,
        include_str!("page.css"),
        text::escape(adapter)
    );
    if *unfinished {
        out.push_str(
            "<p class=\"notice\"><strong>Unfinished.</strong> The run was interrupted; run the same command again to go on.</p>\n",
        );
    }
    let _ = writeln!(out, "<p class=\"reading\">{}</p>\n</header>", reading::paragraph(page));
    out.push_str("<figure class=\"hero\">\n");
    picture(page.truth, "the truth", "id=\"truth\"", out)?;
    out.push_str(
        "<figcaption>The truth: every sprite, with the fragments of every ray in their own order. \
         All errors below are measured against this picture.</figcaption>\n</figure>\n</div>\n",
    );
    Ok(())
}

/// An `<img>` with the picture's data in it. `attributes` are HTML, `alt` is not.
fn picture(picture: &Picture, alt: &str, attributes: &str, out: &mut String) -> Result<(), png::EncodingError> {
    let png = base64::encode(&picture_png::encode(picture)?);
    let Picture { width, height, .. } = picture;
    let alt = text::escape(alt);
    let _ = writeln!(
        out,
        r#"<img {attributes} width="{width}" height="{height}" alt="{alt}" src="data:image/png;base64,{png}">"#
    );
    Ok(())
}

fn charts(page: &Page<'_>, out: &mut String) {
    let error = |method: &MethodFigures| method.cost_and_error();
    let plot = Plot {
        title: "Frame time against error for every method; both axes are logarithmic",
        cost_title: "frame time, ms",
        error_title: "FLIP, mean",
        less_error: "truer",
        marks: &marks(page, error),
        tolerance: Some(page.tolerance),
    };
    section("Cost against error", &reading::of_errors(page), &plot, out);
    let excess = |method: &MethodFigures| method.cost_and_excess();
    let plot = Plot {
        title: "Frame time against flicker for every method; both axes are logarithmic",
        error_title: "excess change, linear light",
        less_error: "steadier",
        marks: &marks(page, excess),
        tolerance: None,
        ..plot
    };
    section("Stability", &reading::of_stability(page), &plot, out);
}

fn marks<'a>(page: &'a Page<'_>, at: impl Fn(&MethodFigures) -> Option<[f64; 2]>) -> Vec<Mark<'a>> {
    let mark = |(index, method): (usize, &'a MethodFigures)| {
        let link = format!("#{}", Page::card_id(index));
        Some(Mark { name: &method.name, family: page.family(method), at: at(method)?, link })
    };
    page.report.methods.iter().enumerate().filter_map(mark).collect()
}

/// The chart twice: as large as a window, and as a telephone. The page shows the one that fits.
fn section(title: &str, caption: &str, plot: &Plot<'_>, out: &mut String) {
    let _ = writeln!(out, "<section class=\"charted\">\n<h2>{title}</h2>\n<p>{caption}</p>");
    if !plot.marks.is_empty() {
        for (class, shape) in [("wide", Shape::Wide), ("narrow", Shape::Narrow)] {
            let _ = writeln!(out, "<div class=\"plot {class}\">\n{}\n</div>", plot.svg(shape));
        }
    }
    out.push_str("</section>\n");
}

fn left_out(report: &Report, out: &mut String) {
    if report.left_out.is_empty() {
        return;
    }
    out.push_str("<section>\n<h2>Left out</h2>\n<dl class=\"left-out\">\n");
    for method in &report.left_out {
        let _ = writeln!(out, "<dt>{}</dt><dd>{}</dd>", text::escape(&method.name), text::escape(&method.reason));
    }
    out.push_str("</dl>\n</section>\n");
}
