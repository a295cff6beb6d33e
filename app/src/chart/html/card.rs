//! A card for each method, from true to wrong: its picture against the truth, where it errs, its figures.

use super::{Look, Page, picture, reading};
use crate::chart::columns::filled;
use crate::chart::report::MethodFigures;
use crate::chart::{Family, class, heat, text};
use std::fmt::Write;

/// No map's scale ends below this, or the noise of dither would glow.
const LEAST_BRIGHTEST: f32 = 0.05;

/// All cards, under one scale of errors.
pub(super) fn all(page: &Page<'_>, out: &mut String) -> Result<(), png::EncodingError> {
    if page.report.methods.is_empty() {
        return Ok(());
    }
    let brightest = brightest(page.looks);
    out.push_str("<section>\n<h2>MethodFigures by method, from true to wrong</h2>\n");
    if page.looks.iter().any(|look| !look.errors.is_empty()) {
        scale(brightest, out);
    }
    let mut methods: Vec<(usize, &MethodFigures)> = page.report.methods.iter().enumerate().collect();
    // What has no error known comes last.
    methods.sort_by(|(_, a), (_, b)| {
        let error = |method: &MethodFigures| method.error.flip_mean.unwrap_or(f64::INFINITY);
        error(a).total_cmp(&error(b))
    });
    methods.into_iter().try_for_each(|(index, method)| card(page, index, method, brightest, out))?;
    out.push_str("</section>\n");
    Ok(())
}

/// One scale for all maps, or they could not be compared: the error that 999 of 1000 pixels of the worst map don't
/// exceed, rounded up to a twentieth.
fn brightest(looks: &[Look<'_>]) -> f32 {
    let high = |look: &Look<'_>| {
        let mut errors: Vec<f32> = look.errors.iter().copied().filter(|error| error.is_finite()).collect();
        let index = errors.len().saturating_sub(1 + errors.len() / 1000);
        if errors.is_empty() { 0.0 } else { *errors.select_nth_unstable_by(index, f32::total_cmp).1 }
    };
    let most = looks.iter().map(high).fold(LEAST_BRIGHTEST, f32::max);
    ((most * 20.0 - 1e-4).ceil() / 20.0).min(1.0)
}

fn scale(brightest: f32, out: &mut String) {
    let stops: Vec<String> = heat::COLORS.iter().map(|[r, g, b]| format!("rgb({r} {g} {b})")).collect();
    let _ = writeln!(
        out,
        r#"<p class="scale"><span>Each map shows where its picture differs from the truth. <span class="drag">Drag across a picture to compare.</span></span>
<span class="key">FLIP 0 <span class="bar" style="background:linear-gradient(to right,{})"></span> {brightest:.2} and more</span></p>"#,
        stops.join(",")
    );
}

fn card(
    page: &Page<'_>,
    index: usize,
    method: &MethodFigures,
    brightest: f32,
    out: &mut String,
) -> Result<(), png::EncodingError> {
    let family = page.family(method);
    let _ = writeln!(out, r#"<article class="card {}" id="{}">"#, class(family), Page::card_id(index));
    let _ = write!(out, "<h3>{}", text::escape(&method.name));
    out.push_str(&badge(family));
    if method.on_front {
        out.push_str(r#" <span class="badge front">on the front</span>"#);
    }
    out.push_str("</h3>\n");
    let look = page.look(method);
    let about = look.map(|look| text::escape(look.about)).filter(|about| !about.is_empty());
    let words: Vec<String> = about.into_iter().chain(reading::verdict(page, index)).collect();
    if !words.is_empty() {
        let _ = writeln!(out, "<p>{}</p>", words.join(" "));
    }
    // The truth stands at the top, and differs from itself nowhere.
    if family != Family::Truth {
        pictures(look, method, brightest, out)?;
    }
    figures(page, method, out);
    out.push_str("</article>\n");
    Ok(())
}

/// What a family is called, where that is worth a word: its colour is never all that tells it.
pub(super) fn badge(family: Family) -> String {
    match family {
        Family::Shipped | Family::Failing => {
            format!(r#" <span class="badge {}">{}</span>"#, class(family), family.name())
        }
        Family::Truth | Family::Other => String::new(),
    }
}

fn pictures(
    look: Option<&Look<'_>>,
    method: &MethodFigures,
    brightest: f32,
    out: &mut String,
) -> Result<(), png::EncodingError> {
    let Some((look, drawn)) = look.and_then(|look| Some((look, look.picture?))) else {
        out.push_str("<p class=\"soft\">Its picture was not kept.</p>\n");
        return Ok(());
    };
    let name = text::escape(&method.name);
    out.push_str("<div class=\"pair\">\n<div class=\"wipe\">\n");
    picture(drawn, &method.name, "", out)?;
    let _ = writeln!(
        out,
        r#"<div class="over"></div><span class="left">{name}</span><span class="right">truth</span>
<input type="range" min="0" max="100" step="any" value="50" aria-label="Wipe between {name} and the truth">
</div>"#
    );
    if !look.errors.is_empty() {
        let map = heat::picture([drawn.width, drawn.height], look.errors, brightest);
        picture(&map, &format!("Map of the errors of {}", method.name), "", out)?;
    }
    out.push_str("</div>\n");
    Ok(())
}

fn figures(page: &Page<'_>, method: &MethodFigures, out: &mut String) {
    out.push_str("<dl class=\"figures\">\n");
    for column in filled(&page.report.methods) {
        let Some(name) = column.in_card else { continue };
        let Some(value) = (column.of)(method).filter(|x| x.is_finite()) else { continue };
        let unit = if column.unit.is_empty() { String::new() } else { format!(" {}", column.unit) };
        let _ = writeln!(out, "<div><dt>{name}</dt><dd>{}{unit}</dd></div>", text::figure(Some(value)));
    }
    out.push_str("</dl>\n");
    if !method.settings.is_empty() {
        let setting = |(name, value): (&String, &String)| {
            format!("<span>{}: <b>{}</b></span>", text::escape(name), text::escape(value))
        };
        let settings: Vec<String> = method.settings.iter().map(setting).collect();
        let _ = writeln!(out, "<p class=\"settings\">{}</p>", settings.join(" "));
    }
}
