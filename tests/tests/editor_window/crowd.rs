//! A scene of many clouds: the outline lays out what is in sight, and every row is reached.

use crate::Window;
use crate::outline::with_scene;
use cloudwright_tests::small_scenes::crowd;
use egui::accesskit::Role;
use egui::{Event, Modifiers, MouseWheelUnit, TouchPhase, vec2};
use egui_kittest::kittest::Queryable;

#[test]
fn the_outline_lays_out_the_rows_in_sight_and_scrolls_to_all() {
    let mut scene = crowd(400);
    for index in 0..scene.clouds.len() {
        scene.clouds[index].name = format!("cloud {index:03}");
    }
    let (mut window, _folder) = with_scene(&scene);
    let rows = |window: &Window| -> Vec<String> {
        let all = scene.clouds.iter().map(|cloud| cloud.name.clone());
        all.filter(|name| window.harness.query_by_role_and_label(Role::Button, name).is_some()).collect()
    };
    let first = rows(&window);
    assert!(first.len() > 10 && first.len() < 100, "{} rows", first.len());
    assert_eq!(first[0], "cloud 000");
    // Rows are as high as those that are left out are taken to be.
    let top = |name: &str| window.node(Role::Button, name).rect().center().y;
    let spacing = window.harness.ctx.global_style().spacing.clone();
    let pitch = spacing.interact_size.y + spacing.item_spacing.y;
    assert!((top("cloud 009") - top("cloud 000") - 9.0 * pitch).abs() < 0.5, "{pitch} points a row");
    // To the end.
    let over = window.node(Role::Button, "cloud 003").rect().center();
    window.harness.event(Event::PointerMoved(over));
    let wheel = |window: &mut Window, points: f32| {
        window.harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Point,
            delta: vec2(0.0, points),
            phase: TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        window.harness.run_steps(60);
    };
    wheel(&mut window, -20.0 * pitch);
    let next = rows(&window);
    assert!(!next.contains(&first[0]) && next.contains(&"cloud 030".into()), "{next:?}");
    wheel(&mut window, -20_000.0);
    assert!(window.harness.query_by_label_contains("Models (3)").is_some());
    let last = rows(&window);
    assert_eq!(last.last().map(String::as_str), Some("cloud 399"));
    window.press("cloud 399");
    assert_eq!(window.harness.state().selection().items().len(), 1);
}
