//! What the figures say, in words. Answers are HTML, with all names escaped.

use super::Page;
use crate::chart::front::{self, Beaten, Gain};
use crate::chart::report::{MethodFigures, Stability};
use crate::chart::{Family, text};

/// A method that another one beats by this factor lies far from the front.
const FAR: f64 = 2.0;
/// So many of them are named, the worst first.
const MOST_NAMED: usize = 6;

/// The page in a paragraph: which method to take, what the shipped one does, and what not to take.
pub(super) fn paragraph(page: &Page<'_>) -> String {
    [cheapest(page), shipped(page), far_from_front(page)].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

fn name(method: &MethodFigures) -> String {
    format!("<strong>{}</strong>", text::escape(&method.name))
}

/// "4.1 ms a frame, FLIP 0.004".
fn figures([cost, error]: [f64; 2]) -> String {
    format!("{} ms a frame, FLIP {}", text::figure(Some(cost)), text::figure(Some(error)))
}

fn cheapest(page: &Page<'_>) -> Option<String> {
    let tolerance = text::round_number(page.tolerance);
    let Some(method) = front::cheapest_within(&page.report.methods, page.tolerance) else {
        return Some(format!("No method measured keeps within a mean FLIP of {tolerance}."));
    };
    let figures = figures(method.cost_and_error()?);
    Some(format!("The cheapest method within a mean FLIP of {tolerance} is {}: {figures}.", name(method)))
}

fn shipped(page: &Page<'_>) -> Option<String> {
    let of = |family| page.report.methods.iter().find(|method| page.family(method) == family);
    let shipped = of(Family::Shipped)?;
    let [cost, error] = shipped.cost_and_error()?;
    let cheapest = front::cheapest_within(&page.report.methods, page.tolerance);
    let mut words = if cheapest.is_some_and(|method| method.name == shipped.name) {
        "It is what Cloudwright ships".to_owned()
    } else {
        format!("Shipped is {}: {}", name(shipped), figures([cost, error]))
    };
    if let Some([truth, _]) = of(Family::Truth).and_then(MethodFigures::cost_and_error)
        && truth > cost
        && cost > 0.0
    {
        words += &format!("; the truth takes {} as long", text::times(truth / cost));
    }
    Some(words + ".")
}

fn far_from_front(page: &Page<'_>) -> Option<String> {
    let mut far: Vec<(&MethodFigures, Beaten)> =
        page.report.methods.iter().enumerate().filter_map(|(i, method)| Some((method, beaten(page, i)?))).collect();
    far.retain(|(_, beaten)| beaten.factor >= FAR);
    far.sort_by(|(_, a), (_, b)| b.factor.total_cmp(&a.factor));
    let one = |(method, beaten): &(&MethodFigures, Beaten)| {
        format!("{} ({} {})", name(method), better(page, beaten), gained(beaten))
    };
    let named: Vec<String> = far.iter().take(MOST_NAMED).map(one).collect();
    let rest = far.len() - named.len();
    let more = if rest > 0 { format!(" and {rest} more") } else { String::new() };
    match named.as_slice() {
        [] => None,
        [only] => Some(format!("Far from the front lies {only}.")),
        several => Some(format!("Far from the front lie {}{more}.", several.join(", "))),
    }
}

fn beaten(page: &Page<'_>, index: usize) -> Option<Beaten> {
    let methods = page.report.methods.iter().enumerate();
    // What is known to fail may be beaten, but beats none.
    let point =
        |(i, method): (usize, &MethodFigures)| if i == index { method.cost_and_error() } else { method.choice() };
    let points: Vec<_> = methods.map(point).collect();
    front::beaten(&points, index)
}

fn better(page: &Page<'_>, beaten: &Beaten) -> String {
    page.report.methods.get(beaten.by).map_or_else(String::new, |method| text::escape(&method.name))
}

fn gained(Beaten { gain, factor, .. }: &Beaten) -> String {
    match gain {
        Gain::Truth => format!("errs {} less", text::times(*factor)),
        Gain::Speed => format!("is {} as quick", text::times(*factor)),
    }
}

/// For the card of the method at `index`: what is wrong with taking it, if something is.
pub(super) fn verdict(page: &Page<'_>, index: usize) -> Option<String> {
    let beaten = beaten(page, index).filter(|beaten| beaten.factor >= FAR)?;
    let no_worse = match beaten.gain {
        Gain::Truth => "takes no longer",
        Gain::Speed => "errs no more",
    };
    Some(format!("Beaten: {} {no_worse} and {}.", better(page, &beaten), gained(&beaten)))
}

/// Under the heading of the chart of errors.
pub(super) fn of_errors(page: &Page<'_>) -> String {
    let drawn = page.report.methods.iter().filter(|method| method.cost_and_error().is_some()).count();
    if drawn == 0 {
        return "No method has been measured.".into();
    }
    "The line is the front: no method that one can choose is both quicker and truer than those on it, and what lies in \
     the field beyond is beaten. FLIP is how different two pictures look when one is shown after the other, from 0 to 1."
        .into()
}

/// Under the heading of the chart of stability.
pub(super) fn of_stability(page: &Page<'_>) -> String {
    let mean =
        |method: &MethodFigures| method.stability.as_ref().and_then(|Stability { excess_mean, .. }| *excess_mean);
    let measured = page.report.methods.iter().filter_map(|method| Some((method, mean(method)?)));
    let Some((worst, most)) = measured.max_by(|a, b| a.1.total_cmp(&b.1)) else {
        return "Not measured: stability needs a path to fly along (<code>--path NAME</code>).".into();
    };
    let mut words =
        "How much more a pixel changes from frame to frame than the truth does: flicker and pops.".to_owned();
    if most > 0.0 {
        words += &format!(" Least steady is {}: {} a frame on average", name(worst), text::figure(Some(most)));
        let shipped = page.report.methods.iter().find(|method| page.family(method) == Family::Shipped);
        if let Some(least) = shipped.and_then(mean).filter(|least| *least > 0.0 && most > least * FAR) {
            words += &format!(", {} the shipped method’s", text::times(most / least));
        }
        words.push('.');
    }
    words
}
