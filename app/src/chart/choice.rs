//! Which methods a chart is of, and why others are not.

use super::easel::Easel;
use super::report::LeftOut;
use super::subject::Subject;
use crate::renderer::RenderError;
use cloudwright_core::method::{self, METHODS, Method, Renderer};
use cloudwright_render::AdapterChoice;

/// All that make a difference, and need no adapter.
pub(crate) fn on_the_cpu() -> Vec<String> {
    names(|renderer| !matches!(renderer, Renderer::Plain | Renderer::Gpu))
}

/// The plain way is slow, and draws what “no-stop” draws.
fn names(is_meant: impl Fn(Renderer) -> bool) -> Vec<String> {
    METHODS.iter().filter(|method| is_meant(method.settings.renderer)).map(|method| method.name.to_owned()).collect()
}

/// Those of the names `asked` for, or all that make a difference, ready to draw; and what is left out.
pub(crate) fn easels<'a>(subject: &Subject<'a>, asked: &[String]) -> (Vec<Easel<'a>>, Vec<LeftOut>) {
    let (mut easels, mut left_out): (Vec<Easel<'a>>, Vec<LeftOut>) = Default::default();
    let all = names(|renderer| renderer != Renderer::Plain);
    // A program that plays a GPU is worth a look only to someone who asks for it.
    let (names, adapter) =
        if asked.is_empty() { (&all[..], AdapterChoice::HardwareOnly) } else { (asked, AdapterChoice::Any) };
    for name in names.iter().map(|name| name.trim()) {
        if easels.iter().any(|easel| easel.method.name == name) || left_out.iter().any(|one| one.name == name) {
            continue;
        }
        match easel(subject, name, &adapter) {
            Ok(easel) => easels.push(easel),
            Err(reason) => left_out.push(LeftOut { name: name.into(), reason }),
        }
    }
    (easels, left_out)
}

fn easel<'a>(subject: &Subject<'a>, name: &str, adapter: &AdapterChoice) -> Result<Easel<'a>, String> {
    let unknown = || {
        let names: Vec<&str> = METHODS.iter().map(|method: &Method| method.name).collect();
        format!("there is no such method (the methods are {})", names.join(", "))
    };
    let method = method::named(name).ok_or_else(unknown)?;
    match method.settings.without_effect(subject.flies(), subject.forms()) {
        Some(reason) => Err(format!("it would draw what “{}” draws: {reason}", method::shipped().name)),
        None => Easel::new(*subject, method, adapter).map_err(|error| match (error, adapter) {
            (RenderError::NoGpu(_), AdapterChoice::HardwareOnly) => {
                format!("there is no graphics adapter of real hardware; --methods {name} takes one that is a program")
            }
            (RenderError::NoGpu(error), _) => error.to_string(),
            (error, _) => error.to_string(),
        }),
    }
}
