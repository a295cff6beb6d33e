//! Only what a change touched is computed again, in a scene of some four hundred boxes.

use cloudwright_core::derived::{Derived, WorkDone};
use cloudwright_core::document::{Document, Edit, ListEdit};
use cloudwright_core::scene::{Cloud, CloudModel, Formation, Ground, Scene};
use cloudwright_core::watch::Watch;
use cloudwright_tests::authoring;
use glam::DVec3;

fn overcast() -> Scene {
    authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make()).expect("a shipped scene")
}

/// Models populated, clouds placed, clouds dressed.
fn counts(work: WorkDone) -> [u64; 3] {
    [work.models_populated, work.clouds_placed, work.clouds_dressed]
}

#[test]
fn what_is_touched_and_nothing_else() {
    let scene = overcast();
    assert!(scene.clouds.iter().filter_map(|cloud| Some(scene.model(cloud.model)?.boxes.len())).sum::<usize>() > 300);
    let model = &scene.models[0];
    let placements: Vec<&Cloud> = scene.clouds.iter().filter(|cloud| cloud.model == model.id).collect();
    assert!(
        placements.len() > 1 && placements.iter().all(|cloud| cloud.seed.is_some()),
        "each with sprites of its own"
    );
    let uses = placements.len() as u64;

    let edit_model = |change: fn(&mut CloudModel)| {
        let mut model = model.clone();
        change(&mut model);
        Edit::Model(ListEdit::Replace(model))
    };
    let cloud = &scene.clouds[0];
    let edit_cloud = |cloud: Cloud| Edit::Cloud(ListEdit::Replace(cloud));
    let clouds = scene.clouds.len() as u64;
    let cases: [(&str, Edit, [u64; 3]); 14] = [
        ("colour level", edit_model(|m| m.color_levels[1].color.a = 0.5), [0, 0, uses]),
        ("sprite size", edit_model(|m| m.boxes[0].width[1] += 9.0), [uses, uses, 0]),
        ("cull radius", edit_model(|m| m.cull_radius = Default::default()), [uses, uses, 0]),
        ("box light", edit_model(|m| m.boxes[0].light.c_max = 0.7), [0, 0, uses]),
        ("box name", edit_model(|m| m.boxes[0].name = "other".into()), [0, 0, 0]),
        ("the same again", edit_model(|_| ()), [0, 0, 0]),
        ("heading", edit_cloud(Cloud { heading_deg: 77.0, ..cloud.clone() }), [0, 1, 0]),
        ("place", edit_cloud(Cloud { position: cloud.position + 50.0, ..cloud.clone() }), [0, 0, 1]),
        ("on the ground", edit_cloud(Cloud { position: DVec3::ZERO, ..cloud.clone() }), [0, 1, 0]),
        ("name", edit_cloud(Cloud { name: "other".into(), ..cloud.clone() }), [0, 0, 1]),
        ("formation", edit_cloud(Cloud { formation: Some(Formation::default()), ..cloud.clone() }), [0, 0, 1]),
        ("seed", edit_cloud(Cloud { seed: Some(12345), ..cloud.clone() }), [1, 1, 0]),
        ("ground far below", Edit::Ground(Some(Ground { altitude_m: 5.0, ..Ground::default() })), [0, 0, 0]),
        ("ground above", Edit::Ground(Some(Ground { altitude_m: 20_000.0, ..Ground::default() })), [0, clouds, 0]),
    ];
    for (name, edit, want) in cases {
        let mut document = Document::new(scene.clone());
        let mut derived = Derived::new(&scene);
        let before = (derived.work_done(), derived.version());
        let change = document.edit(name, [edit]).expect("in range");
        derived.update(document.scene(), &change);
        let after = counts(derived.work_done());
        let done: Vec<u64> = after.iter().zip(counts(before.0)).map(|(after, before)| after - before).collect();
        assert_eq!(done, want, "{name}");
        assert_eq!(derived.version() != before.1, want != [0; 3], "{name}: a version for each state");
        assert!(derived.clouds() == Derived::new(document.scene()).clouds(), "{name}: as if all were computed anew");
    }
}

#[test]
fn copies_share_their_sprites() {
    let derived = Derived::new(&overcast());
    let copy = derived.clone();
    assert!(derived.clouds().iter().zip(copy.clouds()).all(|(a, b)| std::ptr::eq(&*a.sprites, &*b.sprites)));
}

#[test]
fn what_is_cancelled_leaves_all_as_it_was() {
    let mut document = Document::new(overcast());
    let derived = Derived::new(document.scene());
    let before = derived.clone();
    let mut each = document.scene().models[0].boxes[0].clone();
    each.sprite_count = 5000;
    let change = document.edit("More", [Edit::Box(document.scene().models[0].id, ListEdit::Replace(each))]);
    let plan = derived.plan(document.scene(), &change.expect("in range"));
    assert!(plan.sprites() > 5000);
    let watch = Watch::default();
    watch.cancel();
    assert!(plan.carry_out(&watch).is_none());
    assert!(derived.clouds() == before.clouds() && derived.work_done() == before.work_done());
    let watch = Watch::default();
    assert!(derived.plan(document.scene(), &Default::default()).carry_out(&watch).is_some(), "nothing to do");
    let all = cloudwright_core::document::Change::everything();
    assert!(Derived::default().plan(document.scene(), &all).carry_out(&watch).is_some());
    assert!(watch.share() > 0.5 && watch.share() <= 1.0, "{}", watch.share());
}
