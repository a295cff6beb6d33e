//! Models that the plugins' own parts make, from a sketch's dice: shipped scenes and plugins have one maker.

use super::Sketch;
use cloudwright_core::document::Document;
use cloudwright_core::scene::{CloudModel, List, Scene};
use cloudwright_scripts::{Patience, Plugin, shipped};

/// The model that `call` adds, an expression of the script's in which `dice` goes on where the sketch's stands. It knows
/// those parts of the plugins by their names, and `more` functions.
pub fn model(sketch: &mut Sketch, parts: &[&str], more: &str, call: &str) -> CloudModel {
    let parts: String = parts.iter().map(|name| shipped::part(name).expect("a part")).collect();
    let (seed, rolls) = sketch.dice();
    // The sketch's first roll is the stream's second number.
    let source = format!(
        "const PLUGIN = #{{ name: \"Model\", kind: \"generator\", sentence: \"One model.\" }};
         fn run(p) {{
             let dice = random({seed});
             dice.units({rolls} + 1);
             {call};
             print(dice.drawn());
         }}
         {more}
         {parts}"
    );
    let plugin = Plugin::read(&source).expect(call);
    let empty = Scene { next_id: sketch.scene.next_id, cameras: List::new(), ..Scene::default() };
    let mut document = Document::new(empty);
    let patience = Patience { until: None, ..Patience::usual() };
    let outcome = plugin.run(document.scene(), &plugin.values(), &patience);
    let outcome = outcome.expect(call);
    let drawn: u32 = outcome.printed[0].parse().expect("a number");
    outcome.apply(&plugin, &mut document).expect("it fits an empty scene");
    sketch.go_on(drawn - 1, document.scene().next_id);
    document.scene().models[0].clone()
}
