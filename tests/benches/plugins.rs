//! Plugins: `cargo bench -p cloudwright-tests --bench plugins`.
//!
//! Target on an idle machine of two cores: a script that makes 200 boxes and 2,000 keys, from the request to the outcome
//! applied, with the process that it runs in, in 50 ms. The rest tells where that goes. Least of many runs: what it takes
//! undisturbed.

use cloudwright::scripting::{Host, Request};
use cloudwright_core::document::Document;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::caged::{self, Message};
use cloudwright_scripts::{Patience, Plugin};
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::crowd;
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};

const HOST: &str = env!("CARGO_BIN_EXE_script_host");

fn plugin(body: &str) -> Plugin {
    let head = r#"const PLUGIN = #{ name: "Bench", kind: "edit", sentence: "For figures." };"#;
    Plugin::read(&format!("{head}\nfn run(p) {{ {body} }}")).expect("a plugin")
}

/// Milliseconds of the quickest of `runs`.
fn least<T>(runs: u32, mut run: impl FnMut() -> T) -> f64 {
    let time = |_| {
        let began = Instant::now();
        drop(black_box(run()));
        began.elapsed()
    };
    (0..runs).map(time).min().unwrap_or(Duration::ZERO).as_secs_f64() * 1e3
}

/// What a host says to `request`, in this process.
fn answer(request: &[u8]) -> Vec<u8> {
    struct Pipe(std::sync::mpsc::Sender<Vec<u8>>);
    impl std::io::Write for Pipe {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            let _ = self.0.send(bytes.to_vec());
            Ok(bytes.len())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let (sender, said) = channel();
    caged::serve(request.to_vec(), Pipe(sender));
    said.iter().last().unwrap_or_default()
}

#[allow(clippy::print_stdout, reason = "what it measured is its answer")]
fn main() {
    // `cargo test` builds benches too, and runs them.
    if !std::env::args().any(|arg| arg == "--bench") {
        return;
    }
    let host = Host::at(HOST);
    let nothing = plugin("");
    let boxes_and_keys = plugin(
        "let list = [];
         for place in grid(20, 10, 500) { list.push(#{ center: place }); }
         let model = add_model(#{ boxes: list });
         let cloud = add_cloud(#{ model: model });
         for i in 0..2000 { key(`cloud/${cloud}/opacity`, i, 0.5 + 0.5 * sin(i * 0.1)); }",
    );
    let overcast = authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make());
    let scenes =
        [("empty", Scene::default()), ("overcast", overcast.expect("it is shipped")), ("4000 clouds", crowd(4000))];
    let program = least(20, || Command::new(HOST).arg("--version").stdout(Stdio::null()).status());
    println!("the program started, to its end              {program:>8.2} ms");
    for (name, scene) in scenes {
        for (what, plugin, limit) in
            [("nothing", &nothing, ""), ("200 boxes, 2000 keys", &boxes_and_keys, "   limit 50")]
        {
            let values = plugin.values();
            let ask = || caged::request(plugin, &scene, &[], &values, None).expect("a sound scene");
            let request = ask();
            let said = answer(&request);
            let Ok(Message::Ended(Ok(outcome))) = Message::read(&said) else { unreachable!("it runs") };
            let apply = || {
                let mut document = Document::new(scene.clone());
                outcome.clone().apply(plugin, &mut document).expect("it fits");
                document
            };
            let whole = least(20, || {
                let request = Request { plugin, scene: &scene, selected: &[], values: &values };
                let outcome = host.run(request, &Patience::usual()).expect("it runs");
                let mut document = Document::new(scene.clone());
                outcome.apply(plugin, &mut document).expect("it fits");
                document
            });
            println!("{name}, {what}: request to applied {whole:>8.2} ms{limit}");
            println!(
                "    request told {:>7.2} ms ({} KiB), read and run in a thread {:>7.2} ms, run alone {:>7.2} ms, answer read {:>6.2} ms ({} KiB), applied {:>6.2} ms",
                least(20, ask),
                request.len() >> 10,
                least(20, || answer(&request)),
                least(20, || plugin.run(&scene, &values, &Patience::usual())),
                least(20, || Message::read(&said)),
                said.len() >> 10,
                least(20, apply),
            );
        }
    }
}
