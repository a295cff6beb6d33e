//! What a new plugin of a kind begins as.

use cloudwright_scripts::PluginKind;

/// A script that can be run as it is.
pub fn template(kind: PluginKind) -> &'static str {
    match kind {
        PluginKind::Generator => include_str!("templates/generator.rhai"),
        PluginKind::Edit => include_str!("templates/edit.rhai"),
        PluginKind::Look => include_str!("templates/look.rhai"),
        PluginKind::Weather => include_str!("templates/weather.rhai"),
        PluginKind::Exporter => include_str!("templates/exporter.rhai"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::preset::Preset;
    use cloudwright_core::scene::Thing;
    use cloudwright_scripts::{Patience, Plugin};

    #[test]
    fn each_is_a_plugin_of_its_kind_that_runs() {
        let scene = Preset::ALL[0].scene();
        let selected: Vec<Thing> = scene.clouds.iter().map(|cloud| Thing::Cloud(cloud.id)).collect();
        for kind in PluginKind::ALL {
            let plugin = Plugin::read(template(*kind)).expect("a plugin");
            assert_eq!(plugin.description.kind, *kind);
            let outcome = plugin.run_on(&scene, &selected, &plugin.values(), &Patience::usual()).expect("it runs");
            assert!(!outcome.edits.is_empty() || outcome.text.is_some_and(|text| !text.is_empty()), "{kind:?}");
        }
    }
}
