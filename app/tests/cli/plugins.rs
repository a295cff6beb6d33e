//! `cloudwright run` and `cloudwright plugins`.

use crate::Place;

const MINE: &str = r#"const PLUGIN = #{ name: "Mine", kind: "edit", sentence: "An hour.", parameters: [
    #{ name: "hour_h", kind: "number", unit: "h", min: 0, max: 23, initial: 9, help: "Which." },
] };
fn run(parameters) { set("time_of_day_h", parameters.hour_h); print("set"); }
"#;

fn place() -> Place {
    let place = Place::new();
    place.put("mine.rhai", MINE.as_bytes());
    place.put("loop.rhai", MINE.replace("set(\"time", "loop { } set(\"time").as_bytes());
    place.put("bad.rhai", MINE.replace("time_of_day_h", "time_of_dey_h").as_bytes());
    place.put("blind.rhai", b"fn run(p) { }");
    place
}

#[test]
fn a_file_changes_a_scene_and_says_what_it_did() {
    let place = place();
    let before = place.read("good.cloudscene");
    let ran = place.run("run mine.rhai good.cloudscene -o out.cloudscene --set hour_h=17.5");
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    assert_eq!(ran.stderr, "set\nMine: 1 edit\n");
    let text = String::from_utf8(place.read("out.cloudscene")).expect("text");
    assert!(text.contains("\"time_of_day_h\": 17.5"), "{text}");
    assert_eq!(place.read("good.cloudscene"), before);
    assert_eq!(place.run("check out.cloudscene").code, 0);
}

#[test]
fn shipped_ones_make_scenes_that_check() {
    let place = place();
    for (words, out) in [
        ("run scatter_clouds -o sky.cloudscene --seed 7 --set count=12", "sky.cloudscene"),
        ("run scatter_clouds -o again.cloudscene --seed 7 --set count=12", "again.cloudscene"),
        ("run golden_hour sky.cloudscene -o gold.cloudscene --set light=1.1,1,0.9", "gold.cloudscene"),
        ("run diurnal_cumulus gold.cloudscene -o day.cloudscene --set looped=yes", "day.cloudscene"),
    ] {
        let ran = place.run(words);
        assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
        let checked = place.run(&format!("check {out}"));
        assert_eq!(checked.code, 0, "{words}: {}", checked.stdout);
    }
    assert_eq!(place.read("sky.cloudscene"), place.read("again.cloudscene"));
}

#[test]
fn exporters_write_a_file_of_their_own() {
    let place = place();
    let ran =
        place.run("run sprite_table good.cloudscene -o a.xyz --set axes=z_up --set sizes=no --set separator=comma");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let text = String::from_utf8(place.read("a.xyz")).expect("text");
    assert_eq!(ran.stderr, format!("Sprite table: {} lines\n", text.lines().count()));
    // The same numbers as the other exporter's, with the axes turned.
    assert_eq!(place.run("export good.cloudscene -o b.csv").code, 0);
    let table = String::from_utf8(place.read("b.csv")).expect("text");
    let rows: Vec<String> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect::<Vec<_>>())
        .map(|cells| {
            let z = if cells[7].trim_matches(['0', '.']) == "-" { "0.0000".into() } else { format!("-{}", cells[7]) };
            format!("{},{},{}", cells[5], z.replace("--", ""), cells[6])
        })
        .collect();
    assert!(!rows.is_empty());
    assert_eq!(text.lines().collect::<Vec<_>>(), rows);
    place.refuses("run sprite_table good.cloudscene -o a.xyz", 2, &["a.xyz", "--force"]);
    assert_eq!(place.run("run sprite_table good.cloudscene -o a.xyz --force --set head=yes").code, 0);
    assert!(place.read("a.xyz").starts_with(b"x y z width height rotation_deg tile\n"));
    place.refuses("run sprite_table -o out.cloudscene", 2, &["nothing to export", "name a scene"]);
    place.refuses("run sprite_table good.cloudscene -o out.cloudscene", 2, &["an exporter writes no scene"]);
    place.refuses("run sprite_table none.cloudscene -o out.xyz", 2, &["none.cloudscene"]);
    place.refuses("run sprite_table good.cloudscene -o none/out.xyz", 3, &["none/out.xyz", "make the folder"]);
}

#[test]
fn what_there_is_and_what_can_be_set() {
    let place = place();
    let list = place.run("plugins");
    assert_eq!(list.code, 0, "{}", list.stderr);
    for name in [
        "scatter_clouds      generator",
        "golden_hour         look",
        "diurnal_cumulus     weather",
        "sprite_table        exporter",
    ] {
        assert!(list.stdout.contains(name), "{}", list.stdout);
    }
    let page = place.run("plugins mine.rhai");
    assert!(page.stdout.starts_with("Mine (edit)\nAn hour.\n\n1 parameter:\n"), "{}", page.stdout);
    assert!(page.stdout.contains("hour h: a number from 0 to 23 h; 9 if not given. Which"), "{}", page.stdout);
    for name in ["scatter_clouds", "golden_hour", "diurnal_cumulus"] {
        assert_eq!(place.run(&format!("plugins {name}")).code, 0, "{name}");
    }
}

#[test]
fn nothing_is_written_when_anything_fails() {
    let place = place();
    for (words, code, wanted) in [
        ("run", 2, &["PLUGIN", "--help"][..]),
        ("run mine.rhai", 2, &["--output"]),
        ("run scatter_cloud -o out.cloudscene", 2, &["“scatter_cloud”", "did you mean `scatter_clouds`?"]),
        ("run none.rhai -o out.cloudscene", 2, &["none.rhai"]),
        ("run blind.rhai -o out.cloudscene", 2, &["blind.rhai: line 1, column 1", "const PLUGIN"]),
        ("run bad.rhai -o out.cloudscene", 2, &["bad.rhai: line 4, column 22", "did you mean time_of_day_h?"]),
        ("run loop.rhai -o out.cloudscene", 2, &["loop.rhai: line 4, column", "does a loop never end?"]),
        ("run mine.rhai -o out.cloudscene --set hour_h=24", 2, &["--set: hour_h", "a number from 0 to 23 h"]),
        ("run mine.rhai -o out.cloudscene --set huor_h=2", 2, &["did you mean `hour_h`?"]),
        ("run mine.rhai -o out.cloudscene --set hour_h", 2, &["there is no ="]),
        ("run mine.rhai -o out.cloudscene --seed 3", 2, &["mine.rhai has no seed"]),
        ("run mine.rhai -o out.png", 2, &["out.png", ".cloudscene"]),
        ("run mine.rhai -o none/out.cloudscene", 3, &["none/out.cloudscene", "make the folder"]),
        ("run mine.rhai good.cloudscene -o good.cloudscene", 2, &["that is the scene itself"]),
        ("run mine.rhai none.cloudscene -o out.cloudscene", 2, &["none.cloudscene"]),
        ("plugins none", 2, &["there is no plugin “none”", "scatter_clouds"]),
        ("plugins blind.rhai", 2, &["does not say what it is"]),
    ] {
        place.refuses(words, code, wanted);
    }
    place.put("there.cloudscene", b"{}");
    place.refuses("run mine.rhai -o there.cloudscene", 2, &["there.cloudscene", "--force"]);
}

#[test]
fn the_users_own_are_found_and_told_apart() {
    let place = place();
    let folder = place.path("config/cloudwright/plugins");
    std::fs::create_dir_all(&folder).expect("writable");
    place.put("config/cloudwright/plugins/hour.rhai", MINE.as_bytes());
    place.put("config/cloudwright/plugins/scatter_clouds.rhai", MINE.as_bytes());
    place.put("config/cloudwright/plugins/broken.rhai", b"fn run(p) { }");
    let config = place.path("config").display().to_string();
    let run = |words: &str| place.run_with(&[("XDG_CONFIG_HOME", &config)], words);
    let list = run("plugins");
    let in_folder = format!("\nin {}:\n", folder.display());
    let (ours, theirs) = list.stdout.split_once(&in_folder).expect("the folder's name");
    assert!(ours.contains("scatter_clouds      generator"), "{ours}");
    for line in [
        "broken              broken     line 1, column 1: ",
        "hour                edit       An hour.",
        "scatter_clouds      edit",
    ] {
        assert!(theirs.contains(line), "{theirs}");
    }
    // A name that both have means the one that ships.
    assert!(run("plugins scatter_clouds").stdout.starts_with("Scatter clouds (generator)"));
    assert!(run("plugins hour").stdout.starts_with("Mine (edit)"));
    let ran = run("run hour good.cloudscene -o out.cloudscene");
    assert_eq!((ran.code, ran.stderr.as_str()), (0, "set\nMine: 1 edit\n"));
    let broken = run("run broken -o none.cloudscene");
    assert!(broken.code == 2 && broken.stderr.contains("broken.rhai: line 1, column 1"), "{}", broken.stderr);
    assert!(run("run huor -o none.cloudscene").stderr.contains("did you mean `hour`?"));
}
