//! What the plugins and their parts make, for the shipped scenes: each kind of cloud has one maker.

use super::Sketch;
use cloudwright_core::document::Document;
use cloudwright_core::scene::{List, ModelId, Scene};
use cloudwright_scripts::{Patience, Plugin, Values, shipped};

/// Adds the model that `call` makes, an expression of the script's in which `dice` goes on where the sketch's stands. It
/// knows those parts of the plugins by their names, and `more` functions.
pub fn model(sketch: &mut Sketch, parts: &[&str], more: &str, call: &str) -> ModelId {
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
    let (scene, printed) = ran(&plugin, &plugin.values(), empty);
    let drawn: u32 = printed[0].parse().expect("a number");
    sketch.go_on(drawn - 1, scene.next_id);
    let model = scene.models[0].clone();
    let id = model.id;
    sketch.scene.models.push(model);
    id
}

/// Has a whole plugin do what it does to the sketch's scene, with those values.
pub fn run(sketch: &mut Sketch, name: &str, set: &[(&str, &str)]) {
    let plugin = Plugin::read(shipped::named(name).expect("it ships").source).expect(name);
    let mut values = plugin.values();
    for (name, value) in set {
        values.set(&plugin.description.parameters, name, value).expect(name);
    }
    sketch.scene = ran(&plugin, &values, sketch.scene.clone()).0;
}

/// `scene` as the plugin leaves it, and what it printed.
fn ran(plugin: &Plugin, values: &Values, scene: Scene) -> (Scene, Vec<String>) {
    let mut document = Document::new(scene);
    let patience = Patience { until: None, ..Patience::usual() };
    let outcome = plugin.run(document.scene(), values, &patience).expect(&plugin.description.name);
    let printed = outcome.printed.clone();
    outcome.apply(plugin, &mut document).expect("it fits");
    (document.scene().clone(), printed)
}
