//! Ready-made clouds and categories, chosen by their pictures: found by label, pressed by click and by keyboard, quiet
//! before they are shown and after the last picture came.

use cloudwright::thumbnail::{Subject, Thumbnails};
use cloudwright::{category_choice, preset_choice};
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Category;
use egui::accesskit::Role;
use egui::{Context, Key};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::time::Duration;

#[derive(Default)]
struct Shown {
    thumbnails: Option<Thumbnails>,
    preset: Option<&'static Preset>,
    category: Option<Category>,
}

fn choices() -> Harness<'static, Shown> {
    Harness::builder().with_size([660.0, 900.0]).build_ui_state(
        |ui, shown: &mut Shown| {
            let context = ui.ctx().clone();
            let thumbnails = shown.thumbnails.get_or_insert_with(|| Thumbnails::new(&context));
            shown.preset = preset_choice(ui, thumbnails).or(shown.preset);
            ui.separator();
            shown.category = category_choice(ui, thumbnails, Some(Category::Stratus)).or(shown.category);
        },
        Shown::default(),
    )
}

#[test]
fn every_preset_and_category_is_a_button() {
    let mut harness = choices();
    harness.step();
    for preset in Preset::ALL {
        assert!(harness.query_all_by_role_and_label(Role::Button, preset.label).count() == 1, "{}", preset.label);
    }
    for category in Category::ALL {
        let name = category.name().replace('_', " ");
        assert!(harness.query_all_by_role_and_label(Role::Button, &name).count() == 1, "{name}");
    }
}

#[test]
fn a_click_chooses() {
    let mut harness = choices();
    harness.get_by_role_and_label(Role::Button, "Cumulonimbus").click();
    harness.run_steps(2);
    assert_eq!(harness.state().preset.map(|preset| preset.name), Some("cumulonimbus"));
    harness.get_by_role_and_label(Role::Button, "stratus").click();
    harness.run_steps(2);
    assert_eq!(harness.state().category, None, "it is the present one already");
    harness.get_by_role_and_label(Role::Button, "flat base").click();
    harness.run_steps(2);
    assert_eq!(harness.state().category, Some(Category::FlatBase));
}

#[test]
fn the_keyboard_chooses() {
    let mut harness = choices();
    harness.key_press(Key::Tab);
    harness.step();
    harness.key_press(Key::Tab);
    harness.step();
    assert_eq!(harness.state().preset, None);
    harness.key_press(Key::Enter);
    harness.step();
    assert_eq!(harness.state().preset.map(|preset| preset.name), Some("cumulus_congestus"));
}

#[test]
fn a_picture_wakes_the_window_when_it_is_there() {
    let context = Context::default();
    let (tell, woken) = std::sync::mpsc::channel();
    context.set_request_repaint_callback(move |_| {
        let _ = tell.send(());
    });
    let mut thumbnails = Thumbnails::new(&context);
    assert!(woken.try_recv().is_err(), "no work before a picture is asked for");
    let subject = Subject::Preset(&Preset::ALL[0]);
    assert_eq!(thumbnails.texture(&subject), None);
    woken.recv_timeout(Duration::from_secs(60)).expect("a picture");
    let texture = thumbnails.texture(&subject).expect("drawn");
    assert_eq!(thumbnails.texture(&subject), Some(texture), "kept for the session");
    assert!(woken.try_recv().is_err(), "drawn once");
}
