use super::*;
use crate::Fault;
use crate::shipped::SHIPPED;
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::{CameraPath, PathId, PathKey};
use glam::DVec3;
use std::sync::mpsc::{Sender, channel};

/// Hands on what is written.
struct Pipe(Sender<Vec<u8>>);

impl Write for Pipe {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let _ = self.0.send(bytes.to_vec());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// What the other side says to `request`.
fn answers(request: Vec<u8>) -> Vec<Message> {
    let (sender, said) = channel();
    serve(request, Pipe(sender));
    let bytes: Vec<u8> = said.iter().flatten().collect();
    assert!(bytes.ends_with(b"\n"));
    bytes.trim_ascii_end().split(|byte| *byte == b'\n').map(|line| Message::read(line).expect("a message")).collect()
}

fn plugin(kind: &str, body: &str) -> Plugin {
    let head = format!(r#"const PLUGIN = #{{ name: "Test", kind: "{kind}", sentence: "For tests." }};"#);
    Plugin::read(&format!("{head}\nfn run(p) {{ {body} }}")).expect("a plugin")
}

fn asked(plugin: &Plugin, scene: &Scene) -> Vec<u8> {
    let selected: Vec<Thing> = scene.clouds.iter().map(|cloud| Thing::Cloud(cloud.id)).collect();
    request(plugin, scene, &selected, &plugin.values(), None).expect("a sound scene")
}

#[test]
fn what_comes_back_is_to_the_bit_what_one_thread_makes() {
    let mut scene = Preset::ALL[0].scene();
    // Some need one.
    let id = PathId::new(&mut scene.next_id);
    let key = |time_s: f64| PathKey {
        time_s,
        position: DVec3::new(200.0 * time_s, 900.0, 0.0),
        heading_deg: 90.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let keys = vec![key(0.0), key(20.0)];
    scene.paths.push(CameraPath { id, name: "past".into(), field_of_view_deg: 60.0, keys });
    let selected: Vec<Thing> = scene.clouds.iter().map(|cloud| Thing::Cloud(cloud.id)).collect();
    let patience = Patience { until: None, ..Patience::usual() };
    let arranging = plugin(
        "edit",
        "let one = clouds()[0];
         for i in 0..20 { key(`${selection()[0]}/opacity`, i / 7.0, 0.5 + 0.5 * sin(i * 0.1)); }
         set(`cloud/${duplicate_own([one], [1.0 / 3.0, 0.1, 1e-7])[0]}/opacity`, 1.0 / 3.0);
         remove(`cloud/${one}`); print(\"“ü\\n\");",
    );
    let shipped = SHIPPED.iter().map(|shipped| Plugin::read(shipped.source).expect(shipped.name));
    for plugin in shipped.chain([arranging]) {
        let here = plugin.run_on(&scene, &selected, &plugin.values(), &patience);
        assert!(here.is_ok(), "{here:?}");
        assert_eq!(answers(asked(&plugin, &scene)).pop(), Some(Message::Ended(here)), "{}", plugin.description.name);
    }
}

#[test]
fn whose_time_it_is_is_told() {
    let scene = Preset::ALL[0].scene();
    let [script, placing] = [TimeOf::Script, TimeOf::Scene].map(Message::Time);
    for (kind, body, wanted) in [
        ("edit", "set(\"time_of_day_h\", 7.0);", vec![script.clone()]),
        ("edit", "throw \"no\";", vec![script.clone()]),
        ("exporter", "sprite_table(#{ }); sprite_table(#{ })", vec![script.clone(), placing, script]),
    ] {
        let said = answers(asked(&plugin(kind, body), &scene));
        let (last, before) = said.split_last().expect("an answer");
        assert_eq!(before, wanted, "{body}");
        assert!(matches!(last, Message::Ended(_)));
    }
}

#[test]
fn errors_keep_their_place_and_limits_hold() {
    let scene = Preset::ALL[0].scene();
    let error = |request: Vec<u8>| match answers(request).pop() {
        Some(Message::Ended(Err(error))) => error,
        other => unreachable!("{other:?}"),
    };
    let told = error(asked(&plugin("edit", "\n let a = 1;\n set(\"time_of_dey_h\", 1);"), &scene));
    assert_eq!((told.fault, told.place.map(|place| place.line)), (Fault::Script, Some(4)), "{told}");
    let told = error(b"{ \"source\": 7 }\n".to_vec());
    assert_eq!(told.fault, Fault::Broken, "{told}");
    let endless = plugin("edit", "loop { }");
    let left = Some(Duration::from_millis(20));
    let told = error(request(&endless, &scene, &[], &endless.values(), left).expect("a sound scene"));
    assert_eq!((told.fault, told.place.is_some()), (Fault::Limit, true), "{told}");
    // Each edit of a model's own values carries all of its boxes.
    let large = plugin(
        "edit",
        "let boxes = []; for i in 0..2000 { boxes.push(#{ }); }
         let model = add_model(#{ boxes: boxes });
         for i in 0..2000 { set(`model/${model}/seed`, i); }",
    );
    let told = error(asked(&large, &scene));
    assert_eq!((told.fault, told.message.as_str()), (Fault::Limit, "the script asks for more than 128 MiB"));
    let mut broken = scene;
    broken.time_of_day_h = f64::NAN;
    let told = error(asked(&endless, &broken));
    assert_eq!(told.fault, Fault::Broken, "{told}");
}
