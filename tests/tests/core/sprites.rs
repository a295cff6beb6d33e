//! Phase 1: candidates, culling, placing (MODEL: from boxes to sprites).

use cloudwright_core::derived::Derived;
use cloudwright_core::scene::{BoxId, CullRadius, Scene, SpriteEdit};
use cloudwright_core::sprites::{Candidate, candidates, cull, cull_radii, cull_slow, populate};
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::heap;
use glam::{DQuat, DVec3};
use proptest::prelude::*;

fn any_candidate() -> impl Strategy<Value = (Candidate, f64)> {
    let coordinate = prop_oneof![Just(0.0), -100.0..100.0, -5e4..5e4];
    let radius = prop_oneof![Just(0.0), 1e-15..1e-12, 0.005..0.02, 1.0..60.0, 100.0..5e4];
    (coordinate.clone(), coordinate.clone(), coordinate, radius, any::<u32>(), 0..10_u8).prop_map(
        |(x, y, z, radius, index, moved)| {
            let candidate = Candidate {
                box_id: BoxId(1),
                index,
                position: DVec3::new(x, y, z),
                width: 1.0,
                height: 1.0,
                rotation: 0.0,
                tile: 0,
                moved: moved == 0,
                group: None,
                lump: 0,
            };
            (candidate, radius)
        },
    )
}

proptest! {
    /// The grids keep exactly what asking all pairs keeps; and what the rule says holds for each candidate.
    #[test]
    fn cull_is_the_rule(input in prop::collection::vec(any_candidate(), 0..300)) {
        let (candidates, radii): (Vec<_>, Vec<_>) = input.into_iter().unzip();
        let keep = cull(&candidates, &radii);
        prop_assert_eq!(&keep, &cull_slow(&candidates, &radii));
        let order = (0..candidates.len()).filter(|i| candidates[*i].moved).chain((0..candidates.len()).filter(|i| !candidates[*i].moved));
        let mut kept_before: Vec<usize> = Vec::new();
        for i in order {
            let close = kept_before.iter().any(|j| candidates[i].position.distance(candidates[*j].position) < radii[i]);
            prop_assert_eq!(keep[i], candidates[i].moved || !close);
            if keep[i] {
                kept_before.push(i);
            }
        }
    }
}

#[test]
fn changing_one_box_leaves_the_others_candidates() {
    let scene = heap(40);
    let before = candidates(&scene.models[0], 1);
    let mut changed = scene;
    let first = &mut changed.models[0].boxes[0];
    first.size *= 3.0;
    first.sprite_count = 77;
    first.width = [5.0, 9.0];
    let id = first.id;
    let after = candidates(&changed.models[0], 1);
    let others = |all: &[Candidate]| all.iter().filter(|c| c.box_id != id).copied().collect::<Vec<_>>();
    assert!(!others(&before).is_empty());
    assert_eq!(others(&before), others(&after));
    assert_eq!(after.iter().filter(|c| c.box_id == id).count(), 77);
}

#[test]
fn a_rotated_box_is_filled_truly() {
    let mut scene = heap(2000);
    let first = &mut scene.models[0].boxes[0];
    first.size = DVec3::new(400.0, 20.0, 60.0);
    first.orientation = DQuat::from_rotation_z(0.7) * DQuat::from_rotation_y(0.4);
    let first = first.clone();
    let inside: Vec<DVec3> = candidates(&scene.models[0], 1)
        .iter()
        .filter(|c| c.box_id == first.id)
        .map(|c| first.orientation.inverse() * (c.position - first.center) / first.size)
        .collect();
    let reach = inside.iter().fold(DVec3::ZERO, |most, p| most.max(p.abs()));
    assert!(reach.max_element() <= 0.5 + 1e-9 && reach.min_element() > 0.49, "{reach}");
    // The mean of 2,000 uniform numbers in ±½ has a deviation of 0.289/√2000 = 0.0065: five of them.
    let mean = inside.iter().sum::<DVec3>() / inside.len() as f64;
    assert!(mean.abs().max_element() < 0.033, "{mean}");
}

#[test]
fn hand_moved_sprites_stay_and_hand_dropped_ones_go() {
    let mut scene = heap(60);
    let edits = vec![
        SpriteEdit { moved: Some(DVec3::new(0.1, 0.2, 0.3)), ..SpriteEdit::new(3) },
        SpriteEdit { moved: Some(DVec3::new(0.1, 0.2, 0.3)), ..SpriteEdit::new(4) },
        SpriteEdit { dropped: true, ..SpriteEdit::new(5) },
        SpriteEdit {
            moved: Some(DVec3::ZERO),
            width: Some(77.0),
            height: Some(55.0),
            rotation_deg: Some(-30.0),
            tile: Some(3),
            ..SpriteEdit::new(6)
        },
    ];
    scene.models[0].boxes[0].sprite_edits = edits;
    let (id, center) = (scene.models[0].boxes[0].id, scene.models[0].boxes[0].center);
    for seed in 0..20 {
        let kept = populate(&scene.models[0], seed).sprites;
        let of_box = |index| kept.iter().find(|c| c.box_id == id && c.index == index);
        for index in [3, 4] {
            let moved = of_box(index).expect("moved sprites are never culled, not even by one another");
            assert!(moved.position.distance(center + DVec3::new(20.0, 40.0, 60.0)) < 1e-9);
        }
        assert!(of_box(5).is_none());
        let made = of_box(6).expect("kept");
        assert_eq!((made.width, made.height, made.tile), (77.0, 55.0, 3));
        assert!((made.rotation.to_degrees() + 30.0).abs() < 1e-9);
    }
}

#[test]
fn three_ways_to_give_the_cull_radius() {
    let scene = heap(50);
    let all = candidates(&scene.models[0], 1);
    let bottom = all.iter().map(|c| c.position.y - 0.5 * c.width.max(c.height)).fold(f64::INFINITY, f64::min);
    let top = all.iter().map(|c| c.position.y + 0.5 * c.width.max(c.height)).fold(f64::NEG_INFINITY, f64::max);
    let ways: [(CullRadius, fn(&Candidate, f64) -> f64); 3] = [
        (CullRadius::SpriteFraction(0.25), |c, _| 0.25 * c.width.min(c.height)),
        (CullRadius::CloudHeightFraction(0.2), |_, height| 0.2 * height),
        (CullRadius::Metres(33.0), |_, _| 33.0),
    ];
    for (way, want) in ways {
        for (candidate, radius) in all.iter().zip(cull_radii(way, &all)) {
            assert!((radius - want(candidate, top - bottom)).abs() < 1e-9, "{way:?}");
        }
    }
}

#[test]
fn degenerate_boxes_have_answers() {
    let broken: [(&str, fn(&mut Scene)); 6] = [
        ("no sprites", |s| s.models[0].boxes.iter_mut().for_each(|b| b.sprite_count = 0)),
        ("no boxes", |s| s.models[0].boxes.clear()),
        ("10,000 at one point", |s| {
            s.models[0].boxes[0].size = DVec3::ZERO;
            s.models[0].boxes[0].sprite_count = 10_000;
        }),
        ("sprites of 1 cm", |s| s.models[0].boxes[0].width = [0.01, 0.01]),
        ("sprites of 50 km", |s| s.models[0].boxes[0].height = [5e4, 5e4]),
        ("no culling", |s| s.models[0].cull_radius = CullRadius::Metres(0.0)),
    ];
    for (name, break_it) in broken {
        let mut scene = heap(30);
        break_it(&mut scene);
        let derived = Derived::new(&scene);
        let cloud = &derived.clouds()[0];
        assert!(cloud.center.is_finite() && cloud.radius.is_finite() && cloud.bottom <= cloud.top, "{name}");
        assert!(cloud.sprites.iter().all(|s| s.position.is_finite() && s.width > 0.0 && s.height > 0.0), "{name}");
        if name == "10,000 at one point" {
            let at_point = cloud.sprites.iter().filter(|s| s.box_id == scene.models[0].boxes[0].id).count();
            assert!(at_point <= 1, "one of the coincident sprites is kept at the most, found {at_point}");
        }
    }
}

#[test]
fn bounds_are_those_of_the_kept_sprites() {
    let scene = heap(40);
    let derived = Derived::new(&scene);
    let cloud = &derived.clouds()[0];
    let low = cloud.sprites.iter().map(|s| s.position).reduce(|a, b| a.min(b)).expect("sprites");
    let high = cloud.sprites.iter().map(|s| s.position).reduce(|a, b| a.max(b)).expect("sprites");
    assert!(cloud.center.distance((low + high) * 0.5) < 1e-3);
    assert!((cloud.radius - low.distance(high) * 0.5).abs() < 1e-3);
    let bottom = cloud.sprites.iter().map(|s| s.position.y - s.width.max(s.height) * 0.5).fold(f32::MAX, f32::min);
    assert_eq!(cloud.bottom, bottom);
}

#[test]
fn a_placed_model_is_turned_and_scaled_with_its_sprites() {
    let mut scene = heap(30);
    let plain = Derived::new(&scene).clouds()[0].clone();
    scene.clouds[0].heading_deg = 90.0;
    scene.clouds[0].scale = 2.0;
    let turned = Derived::new(&scene).clouds()[0].clone();
    assert_eq!(plain.sprites.len(), turned.sprites.len(), "cull metres scale too");
    for (a, b) in plain.sprites.iter().zip(turned.sprites.iter()) {
        // 90° clockwise seen from above takes east (x) to south (z) and north (−z) to east.
        let want = glam::Vec3::new(-a.position.z, a.position.y, a.position.x) * 2.0;
        assert!(b.position.distance(want) < 1e-3, "{} {want}", b.position);
        assert!((b.width - 2.0 * a.width).abs() < 1e-3);
    }
}

#[test]
fn sprites_that_would_cut_the_ground_stand_on_it() {
    let mut scene = heap(30);
    scene.clouds[0].position.y = -50.0;
    let derived = Derived::new(&scene);
    let cloud = &derived.clouds()[0];
    assert!(cloud.sprites.iter().all(|s| cloud.origin.y as f32 + s.position.y - s.reach() >= -1e-3));
    scene.ground = None;
    let derived = Derived::new(&scene);
    assert!(derived.clouds()[0].sprites.iter().any(|s| s.position.y < -50.0));
}

/// The same bytes on every machine: this number was made on one, and must come out on all.
#[test]
fn sampling_gives_the_same_bytes_everywhere() {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut eat = |bits: u64| hash = (hash ^ bits).wrapping_mul(0x0100_0000_01b3);
    for sprite in populate(&heap(200).models[0], 5).sprites {
        sprite.position.to_array().into_iter().chain([sprite.width, sprite.rotation]).for_each(|x| eat(x.to_bits()));
        eat(u64::from(sprite.index) << 8 | u64::from(sprite.tile));
    }
    assert_eq!(hash, 1_651_762_502_481_544_582, "the sprites of a fixed scene and seed have changed");
}

#[test]
fn only_what_changed_is_computed_again() {
    use cloudwright_core::document::{Document, Edit, ListEdit};
    let mut document = Document::new(authoring::SCENES[1].1());
    let mut derived = Derived::new(document.scene());
    let start = derived.work_done();
    let mut model = document.scene().models[0].clone();
    model.color_levels[2].color.a = 0.5;
    let uses = document.scene().clouds.iter().filter(|cloud| cloud.model == model.id).count() as u64;
    let change = document.edit("Level", [Edit::Model(ListEdit::Replace(model))]).expect("in range");
    derived.update(document.scene(), &change);
    assert_eq!(derived.work_done().models_populated, start.models_populated, "colours strew no sprites");
    assert_eq!(derived.work_done().clouds_placed, start.clouds_placed, "nor do they place any");
    assert_eq!(derived.work_done().clouds_dressed, start.clouds_dressed + uses);
    assert_eq!(derived.clouds(), Derived::new(document.scene()).clouds(), "as if all were computed anew");
    let change = document.edit("Hour", [Edit::TimeOfDay(3.0)]).expect("in range");
    let before = derived.work_done();
    derived.update(document.scene(), &change);
    assert_eq!(derived.work_done(), before);
}

/// What a random walk of edits, undo and redo leaves in the caches is what a fresh start computes; and the version
/// tells states apart.
#[test]
fn caches_hold_what_a_fresh_start_computes() {
    use cloudwright_core::document::{Document, Edit, ListEdit};
    use cloudwright_core::random::draw;
    use cloudwright_core::scene::{Cloud, CloudId, CloudModel, ModelId};
    let mut document = Document::new(heap(12));
    let mut derived = Derived::new(document.scene());
    for step in 0..300 {
        let [what, which, size, _] = draw(9, 9, step, 0);
        let scene = document.scene().clone();
        let mut counter = scene.next_id;
        let some = |count: usize| which as usize % count.max(1);
        let cloud = scene.clouds.get(some(scene.clouds.len())).cloned();
        let model = scene.models.get(some(scene.models.len())).cloned();
        let before = derived.clouds().to_vec();
        let version = derived.version();
        let edits: Vec<Edit> = match (what % 10, cloud, model) {
            (0, Some(cloud), _) => vec![Edit::Cloud(ListEdit::Remove(cloud.id))],
            (1, Some(cloud), _) => {
                let id = CloudId::new(&mut counter);
                vec![Edit::NextId(counter), Edit::Cloud(ListEdit::Insert { at: some(3), value: Cloud { id, ..cloud } })]
            }
            (2, Some(cloud), _) => vec![Edit::Cloud(ListEdit::Replace(Cloud { seed: Some(u64::from(size)), ..cloud }))],
            (3, Some(cloud), _) => {
                vec![Edit::Cloud(ListEdit::Replace(Cloud { scale: 1.0 + f64::from(size % 3), ..cloud }))]
            }
            (4, _, Some(mut model)) if !model.boxes.is_empty() => {
                model.boxes[0].sprite_count = size % 30;
                vec![Edit::Box(model.id, ListEdit::Replace(model.boxes[0].clone()))]
            }
            (5, _, Some(model)) => vec![Edit::Model(ListEdit::Replace(CloudModel { seed: u64::from(size), ..model }))],
            (6, _, Some(model)) => {
                let id = ModelId::new(&mut counter);
                let copy = CloudModel { id, boxes: Default::default(), ..model };
                vec![Edit::NextId(counter), Edit::Model(ListEdit::Insert { at: 0, value: copy })]
            }
            (7, ..) => vec![Edit::Ground(scene.ground.is_none().then(Default::default))],
            (8, ..) => Vec::new(),
            _ => vec![Edit::TimeOfDay(f64::from(size % 24))],
        };
        let change = match (edits.is_empty(), which % 2) {
            (true, 0) => document.undo().unwrap_or_default(),
            (true, _) => document.redo().unwrap_or_default(),
            (false, _) => document.edit("step", edits).unwrap_or_default(),
        };
        derived.update(document.scene(), &change);
        assert!(derived.clouds() == Derived::new(document.scene()).clouds(), "step {step}");
        assert!(derived.version() != version || derived.clouds() == before, "step {step}: changed, but of one version");
    }
}
