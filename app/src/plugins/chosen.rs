//! What was chosen of a plugin, taken along to what the plugin is now.

use cloudwright_scripts::{Plugin, Values};

/// The values of `plugin`, where `chosen` has one that it may have; else those that it begins with.
pub fn carried_over(chosen: &Values, plugin: &Plugin) -> Values {
    let parameters = &plugin.description.parameters;
    let mut values = plugin.values();
    for parameter in parameters {
        if let Some(value) = chosen.get(&parameter.name) {
            // What it may no longer have, it begins anew with.
            let _ = values.set(parameters, &parameter.name, &value.to_string());
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_still_fits_stays() {
        let plugin = |parameters: &str| {
            let source = format!(
                "const PLUGIN = #{{ name: \"A\", kind: \"edit\", sentence: \"B.\", parameters: [{parameters}] }};\nfn run(p) {{ }}"
            );
            Plugin::read(&source).expect("a plugin")
        };
        let old = plugin(
            "#{ name: \"a\", kind: \"number\", initial: 1 }, #{ name: \"b\", kind: \"integer\", initial: 5 },
             #{ name: \"c\", kind: \"flag\" }, #{ name: \"d\", kind: \"text\" }",
        );
        let mut chosen = old.values();
        for (name, text) in [("a", "0.1"), ("b", "9"), ("c", "yes"), ("d", "x")] {
            chosen.set(&old.description.parameters, name, text).expect("in range");
        }
        let new = plugin(
            "#{ name: \"a\", kind: \"number\", initial: 1 }, #{ name: \"b\", kind: \"integer\", max: 8, initial: 5 },
             #{ name: \"c\", kind: \"number\", initial: 3 }, #{ name: \"e\", kind: \"seed\" }",
        );
        let carried = carried_over(&chosen, &new);
        let text = |name: &str| carried.get(name).map(ToString::to_string);
        let wanted = [("a", Some("0.1")), ("b", Some("5")), ("c", Some("3")), ("d", None), ("e", Some("1"))];
        for (name, wanted) in wanted {
            assert_eq!(text(name).as_deref(), wanted, "{name}");
        }
    }
}
