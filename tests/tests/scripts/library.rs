//! The library of plugins: those that ship, and the user's own.

use cloudwright::plugins::{Library, Origin, listing};
use cloudwright_scripts::PluginKind;
use cloudwright_scripts::shipped::SHIPPED;

#[test]
fn all_are_listed_and_told_apart() {
    let home = tempfile::tempdir().expect("a folder");
    let put = |name: &str, text: &[u8]| std::fs::write(home.path().join(name), text).expect("writable");
    let scatter = SHIPPED.iter().find(|shipped| shipped.name == "scatter_clouds").expect("it ships");
    put("scatter_clouds.rhai", scatter.source.as_bytes());
    put("broken.rhai", b"const PLUGIN = #{ kind: \"edit\",\n  name: 7 };");
    put("bytes.rhai", b"\xff\xfe");
    put("large.rhai", &vec![b' '; (1 << 20) + 1]);
    put("notes.txt", b"no plugin");
    std::fs::create_dir(home.path().join("folder.rhai")).expect("writable");
    let library = Library::read(Some(home.path()));
    assert_eq!(library.entries().len(), SHIPPED.len() + 5);
    let generators = library.of_kind(PluginKind::Generator);
    let labels: Vec<String> = generators.iter().map(|(entry, plugin)| library.label(&entry.origin, plugin)).collect();
    for label in ["Scatter clouds (shipped)", "Scatter clouds (scatter_clouds.rhai)"] {
        assert!(labels.iter().any(|each| each == label), "{label} in {labels:?}");
    }
    let broken: Vec<(String, String)> =
        library.broken().map(|(origin, error)| (origin.in_short(), error.to_string())).collect();
    for ((name, error), (wanted, words)) in broken.iter().zip([
        ("broken.rhai", "line 2, column 9: name is a whole number"),
        ("bytes.rhai", "no text"),
        ("folder.rhai", "it is a folder"),
        ("large.rhai", "larger than 1 MB"),
    ]) {
        assert!(name == wanted && error.contains(words), "{name}: {error}");
    }
    assert_eq!(broken.len(), 4);
    assert_eq!(library.seen(), &listing(home.path()));
    let named = library.into_named("scatter_clouds").map(|entry| entry.origin);
    assert_eq!(named.ok(), Some(Origin::Shipped("scatter_clouds")));
    assert!(Library::read(Some(&home.path().join("none"))).broken().next().is_none());
}
