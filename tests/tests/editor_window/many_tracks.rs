//! A timeline of 500 tracks of 50 keys: what is in sight is laid out, and every track is reached.

use crate::Window;
use crate::outline::with_scene;
use cloudwright::command::Command;
use cloudwright_core::scene::{KeyValue, Scene, Track, TrackId, TrackKey};
use cloudwright_tests::small_scenes::crowd;
use egui::accesskit::Role;
use egui::vec2;
use egui_kittest::kittest::Queryable;
use std::time::Instant;

const TRACKS: u32 = 500;
const KEYS: u32 = 50;

fn tracks() -> Scene {
    let mut scene = crowd(TRACKS / 2);
    let clouds: Vec<_> = scene.clouds.iter().map(|cloud| cloud.id).collect();
    for (index, cloud) in clouds.into_iter().enumerate() {
        scene.clouds[index].name = format!("cloud {index:03}");
        for (property, three) in [("opacity", false), ("position", true)] {
            let key = |i: u32| {
                let value = f64::from(i % 3) * 0.5;
                let value = if three { KeyValue::Three([value * 100.0; 3]) } else { KeyValue::One(value) };
                TrackKey::new(f64::from(i), value)
            };
            let id = TrackId::new(&mut scene.next_id);
            scene.tracks.push(Track::new(id, format!("cloud/{cloud}/{property}"), (0..KEYS).map(key).collect()));
        }
    }
    scene
}

#[test]
#[allow(clippy::print_stdout, reason = "how long it took, for who asks with --nocapture")]
fn what_is_in_sight_is_laid_out_and_all_is_found() {
    let (mut window, _folder) = with_scene(&tracks());
    window.command(Command::TimelinePanel);
    window.command(Command::FitTimeline);
    let keys = |window: &Window| window.harness.query_all_by_label_contains("key of ").count();
    let in_sight = keys(&window);
    assert!(in_sight >= 8 * KEYS as usize && in_sight < 30 * KEYS as usize, "{in_sight} keys");
    let begun = Instant::now();
    window.harness.run_steps(20);
    println!("a frame: {:?}", begun.elapsed() / 20);

    window.node(Role::TextInput, "Find tracks").focus();
    window.settle();
    window.node(Role::TextInput, "Find tracks").type_text("opacity 249");
    window.settle();
    assert_eq!(keys(&window), KEYS as usize);
    window.press("Opacity of cloud 249");
    window.command(Command::SelectAllKeys);
    let at = window.node(Role::Button, "key of Opacity at 10 s").rect().center();
    let second = window.node(Role::Button, "key of Opacity at 11 s").rect().center().x - at.x;
    let begun = Instant::now();
    window.drag(at, vec2(2.0 * second, 0.0));
    println!("a drag of seven steps: {:?}", begun.elapsed());
    let track = window.scene().tracks.iter().rfind(|track| track.property.ends_with("opacity")).expect("a track");
    assert_eq!((track.keys.len(), track.keys[0].time_s), (KEYS as usize, 2.0));
    // All keys of all tracks at once.
    window.command(Command::SelectNoKeys);
    window.command(Command::SelectAllKeys);
    let begun = Instant::now();
    window.command(Command::MirrorKeys);
    println!("all keys mirrored: {:?}", begun.elapsed());
    assert!(window.scene().tracks.iter().all(|track| track.keys.len() == KEYS as usize));
    window.command(Command::Undo);
}
