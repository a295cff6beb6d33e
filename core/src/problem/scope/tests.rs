//! A random walk of edits: what is found in what was touched is what is found in the whole.

use super::super::{Problem, Severity, check, check_touched, scene_with_flight};
use crate::color::Rgb;
use crate::document::{Change, Document, Edit, EditError, ListEdit};
use crate::random::draw;
use crate::scene::{
    Aircraft, BoxId, Camera, CameraId, CameraPath, Cloud, CloudBox, CloudId, CloudModel, CullRadius, Formation,
    GroupId, GroupLight, IdCounter, ModelId, PathId, Scene, ShadingGroup, Site, Sky, SpriteEdit, Sun,
};
use glam::DVec3;

fn errors(problems: Vec<Problem>) -> Vec<Problem> {
    problems.into_iter().filter(|problem| problem.severity == Severity::Error).collect()
}

/// A few edits that may leave `scene` broken: about half of them do.
fn some_edits(scene: &Scene, step: u32) -> Vec<Edit> {
    let [what, which, value, more] = draw(3, 5, step, 0);
    let bad = value % 2 == 0;
    let some = |count: usize| which as usize % count;
    let mut counter = scene.next_id;
    let cloud = scene.clouds[some(scene.clouds.len())].clone();
    let mut model = scene.models[some(scene.models.len())].clone();
    let (camera, path) = (scene.cameras[some(scene.cameras.len())].clone(), scene.paths.first().cloned());
    let replace = |cloud| vec![Edit::Cloud(ListEdit::Replace(cloud))];
    let counted = |counter, edit| if bad { vec![edit] } else { vec![Edit::NextId(counter), edit] };
    match what % 26 {
        0 => replace(Cloud { scale: if bad { f64::NAN } else { 2.0 }, ..cloud }),
        1 => replace(Cloud { model: if bad { ModelId(999) } else { cloud.model }, ..cloud }),
        2 if scene.clouds.len() > 1 => vec![Edit::Cloud(ListEdit::Remove(cloud.id))],
        3 => {
            let id = CloudId::new(&mut counter);
            counted(counter, Edit::Cloud(ListEdit::Insert { at: some(3), value: Cloud { id, ..cloud } }))
        }
        4 if scene.models.len() > 1 => vec![Edit::Model(ListEdit::Remove(model.id))],
        5 => {
            let id = ModelId::new(&mut counter);
            // Its boxes' ids are taken by the original's.
            let boxes = if more % 2 == 0 { model.boxes.clone() } else { Default::default() };
            counted(counter, Edit::Model(ListEdit::Insert { at: 0, value: CloudModel { id, boxes, ..model } }))
        }
        6 => {
            model.color_levels[2].height = if bad { 0.01 } else { 0.5 };
            vec![Edit::Model(ListEdit::Replace(model))]
        }
        7 if !model.boxes.is_empty() => {
            let each = model.boxes[0].clone();
            let changed = match more % 4 {
                0 => CloudBox { width: if bad { [9.0, 3.0] } else { [3.0, 9.0] }, ..each },
                1 => CloudBox { group: if bad { Some(GroupId(998)) } else { None }, ..each },
                2 => CloudBox { sprite_count: if bad { 1_000_000 } else { 10 }, ..each },
                _ => CloudBox { group: model.groups.first().map(|group| group.id), ..each },
            };
            vec![Edit::Box(model.id, ListEdit::Replace(changed))]
        }
        8 => {
            let id = if bad {
                BoxId(scene.models[0].boxes.first().map_or(1, |each| each.id.0))
            } else {
                BoxId::new(&mut counter)
            };
            let new = CloudBox::new(id, DVec3::ZERO);
            vec![Edit::NextId(counter), Edit::Box(model.id, ListEdit::Insert { at: 0, value: new })]
        }
        9 => {
            let id = GroupId::new(&mut counter);
            let new = ShadingGroup { id, name: "new".into(), light: GroupLight::default() };
            counted(counter, Edit::Group(model.id, ListEdit::Insert { at: 0, value: new }))
        }
        10 if !model.groups.is_empty() => {
            vec![Edit::Group(model.id, ListEdit::Remove(model.groups[0].id))]
        }
        11 => {
            let id = CameraId::new(&mut counter);
            let name = if bad { camera.name.clone() } else { format!("camera {id}") };
            let new = Camera { id, name, ..camera };
            vec![Edit::NextId(counter), Edit::Camera(ListEdit::Insert { at: 0, value: new })]
        }
        12 => {
            let (first, own) = (scene.cameras[0].name.clone(), format!("camera {}", camera.id));
            vec![Edit::Camera(ListEdit::Replace(Camera { name: if bad { first } else { own }, ..camera }))]
        }
        13 if path.is_some() && bad => path.map(|path| Edit::Path(ListEdit::Remove(path.id))).into_iter().collect(),
        13 | 14 => {
            let mut keys = scene_with_flight().paths[0].keys.clone();
            keys[1].time_s = if bad { -1.0 } else { 20.0 };
            let id = path.as_ref().map_or(PathId::new(&mut counter), |path| path.id);
            let new = CameraPath::new(id, "way", keys);
            let edit = if path.is_some() { ListEdit::Replace(new) } else { ListEdit::Insert { at: 0, value: new } };
            vec![Edit::NextId(counter), Edit::Path(edit)]
        }
        15 => {
            let path = if bad { PathId(997) } else { path.map_or(PathId(996), |path| path.id) };
            scene
                .aircraft
                .iter()
                .map(|each| Edit::Aircraft(ListEdit::Replace(Aircraft { path, ..each.clone() })))
                .collect()
        }
        16 => vec![Edit::TimeOfDay(if bad { 25.0 } else { 12.0 })],
        17 => {
            let mut sky = scene.sky.clone();
            sky.ambient.keys[1].hour = if bad { 23.9 } else { sky.ambient.keys[0].hour + 0.1 };
            vec![Edit::Sky(sky)]
        }
        18 => vec![Edit::Ground(Some(crate::scene::Ground {
            altitude_m: if bad { f64::INFINITY } else { 3.0 },
            ..Default::default()
        }))],
        19 if bad => vec![Edit::NextId(IdCounter(scene.next_id.0.saturating_sub(u64::from(more % 3))))],
        20..25 => vec![one_number(scene, which, bad)],
        // Its boxes' ids are taken by another model's.
        25 => {
            let first = &scene.models[0];
            if bad && first.id != model.id {
                model.boxes = first.boxes.clone();
            }
            vec![Edit::Model(ListEdit::Replace(model))]
        }
        _ => vec![Edit::Site(Site { latitude_deg: if bad { 91.0 } else { 47.0 }, ..scene.site })],
    }
}

/// Another value for one number of each kind of owner that has nothing else wrong with it, in turn.
fn one_number(scene: &Scene, which: u32, bad: bool) -> Edit {
    let number = if bad { f64::NAN } else { 0.5 };
    let (model, sky) = (scene.models[0].clone(), scene.sky.clone());
    let first_box = model.boxes.first().cloned();
    let of_box = |each: CloudBox| Edit::Box(model.id, ListEdit::Replace(each));
    match which % 13 {
        0 => first_box.map(|each| of_box(CloudBox { size: DVec3::splat(number), ..each })),
        1 => first_box.map(|each| {
            let moved = Some(DVec3::splat(number));
            of_box(CloudBox { sprite_edits: vec![SpriteEdit { moved, ..SpriteEdit::new(0) }], ..each })
        }),
        2 => model.groups.first().cloned().map(|group| {
            let light = GroupLight { c_max: number, ..group.light };
            Edit::Group(model.id, ListEdit::Replace(ShadingGroup { light, ..group }))
        }),
        3 => {
            let mut model = model.clone();
            model.color_levels[1].color.a = number as f32;
            Some(Edit::Model(ListEdit::Replace(model)))
        }
        4 => Some(Edit::Model(ListEdit::Replace(CloudModel {
            cull_radius: CullRadius::Metres(number),
            ..model.clone()
        }))),
        5 => {
            let camera = scene.cameras[0].clone();
            Some(Edit::Camera(ListEdit::Replace(Camera { roll_deg: number, ..camera })))
        }
        6 => {
            let path = scene.paths.first().cloned();
            path.map(|path| Edit::Path(ListEdit::Replace(CameraPath { field_of_view_deg: 80.0 * number, ..path })))
        }
        7 => {
            let aircraft = scene.aircraft.first().cloned();
            aircraft.map(|each| Edit::Aircraft(ListEdit::Replace(Aircraft { ahead_s: number, ..each })))
        }
        8 => {
            let cloud = scene.clouds[0].clone();
            let formation = Some(Formation { threshold: number, ..Formation::default() });
            Some(Edit::Cloud(ListEdit::Replace(Cloud { formation, ..cloud })))
        }
        9 => Some(Edit::Sun(Sun::ByHand { heading_deg: number, elevation_deg: 30.0 })),
        10 => Some(Edit::Sky(Sky { exposure_ev: number, ..sky })),
        11 => {
            let mut sky = sky;
            sky.ambient.keys[0].value.a = number as f32;
            Some(Edit::Sky(sky))
        }
        _ => {
            let mut sky = sky;
            sky.directional.keys[0].value = Rgb::grey(number as f32);
            Some(Edit::Sky(sky))
        }
    }
    .unwrap_or(Edit::TimeOfDay(12.0))
}

/// What is found in what was touched is what is found in the whole, and what a commit refuses.
#[test]
fn a_random_walk_of_edits_finds_the_same_errors_in_the_whole_and_in_what_was_touched() {
    let mut document = Document::new(scene_with_flight());
    let [mut refused, mut kept] = [0; 2];
    for step in 0..6000 {
        let before = document.scene().clone();
        let mut change = Change::default();
        for each in 0..=step % 3 {
            for edit in some_edits(document.scene(), step * 3 + each) {
                change.join(document.apply(edit).unwrap_or_default());
            }
        }
        let whole = errors(check(document.scene()));
        assert_eq!(errors(check_touched(document.scene(), &change)), whole, "step {step}: {change:?}");
        match document.commit() {
            Ok(()) => {
                assert!(whole.is_empty(), "step {step}: {whole:?}");
                kept += 1;
            }
            Err(EditError::Problems { problems, taken_back }) => {
                assert_eq!((problems, taken_back), (whole, change), "step {step}");
                assert!(document.scene() == &before, "step {step}");
                refused += 1;
            }
            Err(error) => assert_eq!(None, Some(error), "step {step}"),
        }
        // Back and forth, which touches things too.
        let change = match step % 7 {
            0 => document.undo(),
            1 => document.redo(),
            _ => None,
        };
        assert_eq!(errors(check_touched(document.scene(), &change.unwrap_or_default())), [], "step {step}");
    }
    assert!(refused > 1000 && kept > 1000, "{refused} refused, {kept} kept");
}
