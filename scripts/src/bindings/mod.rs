//! What a script can call: the scene by addresses, things, keys; random streams, noise, easing, lists of places.
//!
//! A file a subject, and in each its functions with how they are written. Numbers may be whole or not; NaN and infinity
//! are refused at the door. Vectors and colours are lists of three numbers. Sines and powers are `libm`'s, in the place
//! of the engine's, so that every machine makes the same edits.

mod arrange;
mod convert;
mod export;
mod geometry;
mod keys;
mod maths;
mod measured;
mod noise;
mod parameters;
mod paths;
mod placed;
mod places;
mod random;
mod scene;
mod sprites;
mod things;
mod whole;

pub(crate) use export::{Exported, whole_text};
pub(crate) use parameters::Parameters;

use crate::error::Said;
use crate::limits::Patience;
use crate::recorder::Recorder;
use cloudwright_core::scene::Thing;
use placed::Placed;
use rhai::{Engine, EvalAltResult};
use std::cell::RefCell;
use std::rc::Rc;

/// What functions return to the engine.
type Answer<T> = Result<T, Box<EvalAltResult>>;
/// The one recorder of a run, which its functions share.
type Shared = Rc<RefCell<Recorder>>;

/// A function's name, how it is written, and what it does.
pub type Usage = (&'static str, &'static str, &'static str);

/// All functions, by subject.
pub const SUBJECTS: &[(&str, &[Usage])] = &[
    ("The scene", scene::USAGE),
    ("Things", things::USAGE),
    ("Whole things", whole::USAGE),
    ("Many things at once", arrange::USAGE),
    ("Single sprites", sprites::USAGE),
    ("Camera paths", paths::USAGE),
    ("Measures", measured::USAGE),
    ("Keys", keys::USAGE),
    ("Files", export::USAGE),
    ("Random numbers", random::USAGE),
    ("Noise", noise::USAGE),
    ("Places", places::USAGE),
    ("Directions and curves", geometry::USAGE),
    ("Numbers and vectors", maths::USAGE),
];

/// `selected` are what the script finds selected; `exported` is there for an exporter.
pub(crate) fn register(
    engine: &mut Engine,
    recorder: &Shared,
    selected: &[Thing],
    exported: Option<&Rc<Exported>>,
    patience: &Patience,
) {
    let placed = exported.map_or_else(|| Rc::new(Placed::new(patience, None)), |exported| Rc::clone(exported.placed()));
    parameters::register(engine);
    scene::register(engine, recorder);
    things::register(engine, recorder);
    whole::register(engine, recorder);
    arrange::register(engine, recorder, selected);
    sprites::register(engine, recorder, &placed);
    paths::register(engine, recorder);
    measured::register(engine, recorder, &placed);
    keys::register(engine, recorder);
    export::register(engine, recorder, exported);
    random::register(engine);
    noise::register(engine);
    places::register(engine);
    geometry::register(engine);
    maths::register(engine);
}

/// How the function of that name is written.
pub(crate) fn usage(name: &str) -> Option<&'static str> {
    SUBJECTS.iter().flat_map(|(_, list)| *list).find(|(known, ..)| *known == name).map(|(_, usage, _)| *usage)
}

fn answer<T>(said: Result<T, Said>) -> Answer<T> {
    said.map_err(Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::Scene;
    use std::collections::BTreeSet;

    /// The engine's own that are replaced, and keep their meaning.
    const PORTABLE: &str = "sin cos tan sinh cosh tanh asin acos atan asinh acosh atanh exp ln log hypot";

    #[test]
    fn every_function_has_its_usage() {
        let mut engine = Engine::new_raw();
        register(&mut engine, &Rc::new(RefCell::new(Recorder::new(&Scene::default()))), &[], None, &Patience::usual());
        let signatures = engine.gen_fn_signatures(false);
        let name = |signature: &str| signature.split('(').next().unwrap_or_default().trim().to_owned();
        let registered: BTreeSet<String> =
            signatures.iter().map(|each| name(each)).filter(|name| !name.contains('$')).collect();
        let portable = PORTABLE.split(' ').map(String::from);
        let told = SUBJECTS.iter().flat_map(|(_, list)| *list).map(|(name, ..)| (*name).to_owned());
        assert_eq!(registered, told.chain(portable).collect());
    }
}
