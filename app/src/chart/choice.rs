//! Which methods a chart is of, and why others are not.

use super::easel::Easel;
use super::report::LeftOut;
use super::subject::Subject;
use crate::renderer::RenderError;
use cloudwright_core::method::{self, METHODS, Method, Renderer};
use cloudwright_render::AdapterChoice;

/// All that make a difference, and need no adapter.
pub(crate) fn on_the_cpu() -> Vec<&'static Method> {
    methods(|renderer| !matches!(renderer, Renderer::Plain | Renderer::Gpu))
}

/// The plain way is slow, and draws what “no-stop” draws.
fn methods(is_meant: impl Fn(Renderer) -> bool) -> Vec<&'static Method> {
    METHODS.iter().filter(|method| is_meant(method.settings.renderer)).collect()
}

/// Those of the methods `asked` for, or all that make a difference, ready to draw; and what is left out.
pub(crate) fn easels<'a>(subject: &Subject<'a>, asked: &[&'static Method]) -> (Vec<Easel<'a>>, Vec<LeftOut>) {
    let (mut easels, mut left_out): (Vec<Easel<'a>>, Vec<LeftOut>) = Default::default();
    let all = methods(|renderer| renderer != Renderer::Plain);
    // A program that plays a GPU is worth a look only to someone who asks for it.
    let (methods, adapter) =
        if asked.is_empty() { (&all[..], AdapterChoice::HardwareOnly) } else { (asked, AdapterChoice::Any) };
    for &method in methods {
        let name = method.name;
        if easels.iter().any(|easel| easel.method.name == name) || left_out.iter().any(|one| one.name == name) {
            continue;
        }
        match easel(subject, method, &adapter) {
            Ok(easel) => easels.push(easel),
            Err(reason) => left_out.push(LeftOut { name: name.into(), reason }),
        }
    }
    (easels, left_out)
}

fn easel<'a>(subject: &Subject<'a>, method: &'static Method, adapter: &AdapterChoice) -> Result<Easel<'a>, String> {
    match method.settings.without_effect(subject.flies(), subject.forms()) {
        Some(reason) => Err(format!("it would draw what “{}” draws: {reason}", method::shipped().name)),
        None => Easel::new(*subject, method, adapter).map_err(|error| match (error, adapter) {
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
