//! Which methods a chart is of, and why others are not.

use super::charted::Charted;
use super::report::LeftOut;
use super::subject::Subject;
use crate::renderer::RenderError;
use cloudwright_core::method::{self, METHODS, Method};
use cloudwright_core::rules::Rasterizer;
use cloudwright_render::AdapterChoice;

/// All that make a difference, and need no adapter.
pub(crate) fn on_the_cpu() -> Vec<&'static Method> {
    methods().filter(|method| method.rules.rasterizer != Rasterizer::Gpu).collect()
}

/// The plain way is slow, and draws what “no-stop” draws; and one truth takes long enough.
fn methods() -> impl Iterator<Item = &'static Method> {
    METHODS.iter().filter(|method| method.rules.rasterizer != Rasterizer::Plain && !method.rules.hazes_fragments())
}

/// Those of the methods `asked` for, or all that make a difference, ready to draw; and what is left out.
pub(crate) fn charted<'a>(subject: &Subject<'a>, asked: &[&'static Method]) -> (Vec<Charted<'a>>, Vec<LeftOut>) {
    let (mut ready, mut left_out): (Vec<Charted<'a>>, Vec<LeftOut>) = Default::default();
    let all: Vec<_> = methods().collect();
    // A program that plays a GPU is worth a look only to someone who asks for it.
    let (methods, adapter) =
        if asked.is_empty() { (&all[..], AdapterChoice::HardwareOnly) } else { (asked, AdapterChoice::Any) };
    for &method in methods {
        let name = method.name;
        if ready.iter().any(|one: &Charted<'_>| one.method.name == name) || left_out.iter().any(|one| one.name == name)
        {
            continue;
        }
        match one(subject, method, &adapter) {
            Ok(one) => ready.push(one),
            Err(reason) => left_out.push(LeftOut { name: name.into(), reason }),
        }
    }
    (ready, left_out)
}

fn one<'a>(subject: &Subject<'a>, method: &'static Method, adapter: &AdapterChoice) -> Result<Charted<'a>, String> {
    match method.rules.without_effect(subject.moves()) {
        Some(reason) => Err(format!("it would draw what “{}” draws: {reason}", method::shipped().name)),
        None => Charted::new(*subject, method, adapter).map_err(|error| match (error, adapter) {
            (RenderError::NoGpu(_), AdapterChoice::HardwareOnly) => {
                format!(
                    "there is no graphics adapter of real hardware; --methods {} takes one that is a program",
                    method.name
                )
            }
            (RenderError::NoGpu(error), _) => error.to_string(),
            (error, _) => error.to_string(),
        }),
    }
}
