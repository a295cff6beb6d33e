//! Scenes small enough to draw slowly.

use crate::authoring::{Sketch, Strew};
use cloudwright_core::color::Rgb;
use cloudwright_core::scene::{
    Aircraft, AircraftId, BoxId, CameraPath, Category, Cloud, CloudBox, CloudId, CloudModel, CullRadius, Folder,
    FolderId, Formation, GroupCenter, GroupId, GroupLight, HowFarFormed, KeyValue, ModelId, PathId, PathKey, Prop,
    PropId, Region, Scene, ShadingGroup, SpriteEdit, Sun, Track, TrackId, TrackKey, Tuning,
};
use glam::{DQuat, DVec3, EulerRot};

/// One heap of two boxes with `count` sprites each, its middle at the origin's column, 1,000 m up; a camera `main`
/// 900 m south of it.
pub fn heap(count: u32) -> Scene {
    let mut sketch = Sketch::new("heap", 7);
    let mut model = sketch.model("heap", Category::CumulusCongestus, 0.2, crate::authoring::heap_levels());
    let strew = Strew { count, sprite: [60.0, 140.0], ..Strew::default() };
    sketch.strew(&mut model, "left", Strew { center: DVec3::new(-90.0, 0.0, 0.0), size: DVec3::splat(200.0), ..strew });
    sketch.strew(
        &mut model,
        "right",
        Strew { center: DVec3::new(90.0, 40.0, 30.0), size: DVec3::splat(180.0), ..strew },
    );
    let id = model.id;
    sketch.scene.models.push(model);
    sketch.place(id, "heap", DVec3::new(0.0, 1000.0, 0.0), 0.0, 1.0, None);
    sketch.scene.time_of_day_h = 17.0;
    sketch.camera("main", DVec3::new(0.0, 1000.0, 900.0), DVec3::new(0.0, 1010.0, 0.0), 40.0);
    sketch.scene
}

/// `count` small clouds of three models, each with sprites of its own, in a square of 20 km in view of the camera `main`.
pub fn crowd(count: u32) -> Scene {
    let mut sketch = Sketch::new("crowd", 7);
    let models = ["low", "round", "flat"].map(|name| {
        let mut model = sketch.model(name, Category::CumulusHumilis, 0.2, crate::authoring::heap_levels());
        sketch.strew(&mut model, "body", Strew { size: DVec3::splat(150.0), count: 24, ..Strew::default() });
        let id = model.id;
        sketch.scene.models.push(model);
        id
    });
    let side = f64::from(count).sqrt().ceil() as u32;
    for index in 0..count {
        let [x, z] = [index % side, index / side].map(|at| (f64::from(at) / f64::from(side) - 0.5) * 20_000.0);
        let model = models[index as usize % models.len()];
        sketch.place(model, "small", DVec3::new(x, 1200.0, z), 0.0, 1.0, Some(u64::from(index)));
    }
    sketch.camera("main", DVec3::new(0.0, 1500.0, 12_000.0), DVec3::new(0.0, 1200.0, 0.0), 50.0);
    sketch.scene
}

/// A scene of single square sprites, unculled, unturned: each a box of size zero with one sprite of `side` metres.
pub fn single_sprites(sprites: &[(DVec3, f64)]) -> Scene {
    let mut sketch = Sketch::new("single sprites", 7);
    let mut model = sketch.model("sprites", Category::SolidCumulus, 0.0, crate::authoring::heap_levels());
    for (position, side) in sprites {
        sketch.strew(
            &mut model,
            "sprite",
            Strew { center: *position, size: DVec3::ZERO, count: 1, sprite: [*side, *side], ..Strew::default() },
        );
    }
    for (cloud_box, (position, side)) in model.boxes.iter_mut().zip(sprites) {
        cloud_box.rotation_deg = [0.0, 0.0];
        // A sketch rounds to metres.
        cloud_box.center = *position;
        (cloud_box.width, cloud_box.height) = ([*side; 2], [*side; 2]);
    }
    let id = model.id;
    sketch.scene.models.push(model);
    sketch.place(id, "sprites", DVec3::ZERO, 0.0, 1.0, None);
    sketch.scene.ground = None;
    sketch.camera("main", DVec3::ZERO, DVec3::NEG_Z, 50.0);
    sketch.scene
}

/// A scene that has each of the file's values: one of each kind of thing at least, and each way of saying how clouds are
/// culled, groups lie and clouds form.
pub fn everything() -> Scene {
    let mut scene = Scene { sun: Sun::ByHand { heading_deg: 200.0, elevation_deg: 30.0 }, ..Scene::default() };
    let next = &mut scene.next_id;
    let groups: Vec<ShadingGroup> = [GroupCenter::Mean, GroupCenter::Pulled(0.5), GroupCenter::At(DVec3::splat(9.0))]
        .into_iter()
        .map(|center| {
            let light = GroupLight { center, ..GroupLight::default() };
            ShadingGroup { id: GroupId::new(next), name: "group".into(), light }
        })
        .collect();
    let sprite = SpriteEdit {
        moved: Some(DVec3::splat(0.25)),
        width: Some(180.0),
        height: Some(120.0),
        rotation_deg: Some(-10.0),
        tile: Some(9),
        group: Some(groups[0].id),
        ..SpriteEdit::new(3)
    };
    for cull_radius in [CullRadius::SpriteFraction(0.3), CullRadius::CloudHeightFraction(0.2), CullRadius::Metres(60.0)]
    {
        let mut model = CloudModel::new(ModelId::new(next), "model", Category::CumulusHumilis);
        model.cull_radius = cull_radius;
        for center in groups.iter().map(|group| group.light.center) {
            let light = GroupLight { center, ..GroupLight::default() };
            let new = CloudBox::new(BoxId::new(next), DVec3::new(10.0, 20.0, 30.0));
            let orientation = DQuat::from_euler(EulerRot::YXZ, 0.5, 0.3, 0.1).normalize();
            model.boxes.push(CloudBox { light, orientation, lumps: [1, 2, 3], ..new });
        }
        scene.models.push(model);
    }
    let first = &mut scene.models[0];
    first.boxes[0].sprite_edits.push(sprite);
    first.groups.extend(groups);
    let folder = Folder::new(FolderId::new(next), "folder");
    for formation in [None, Some(Formation::default())] {
        let cloud = Cloud::new(CloudId::new(next), &scene.models[0], DVec3::new(0.0, 1000.0, 0.0));
        let formed = Some(HowFarFormed { core: 0.75, edges: 0.5 });
        scene.clouds.push(Cloud { formation, formed, folder: Some(folder.id), ..cloud });
    }
    scene.folders.push(folder);
    let key = |time_s| PathKey {
        time_s,
        position: DVec3::new(time_s, 900.0, 0.0),
        heading_deg: 10.0,
        pitch_deg: -5.0,
        roll_deg: 3.0,
    };
    let path = CameraPath::new(PathId::new(next), "path", vec![key(1.0), key(20.0)]);
    scene.aircraft.push(Aircraft::new(AircraftId::new(next), "aircraft", path.id));
    scene.paths.push(path);
    scene.props.push(Prop::new(PropId::new(next), "tower.glb", DVec3::new(10.0, 0.0, -20.0)));
    let tuning = Tuning { scale: 2.0, tint: Rgb::new(1.0, 0.5, 0.25) };
    (scene.sky.ambient_tuning, scene.sky.directional_tuning) = (tuning, tuning);
    scene.weather.region = Some(Region::default());
    let keys = vec![TrackKey::new(0.0, KeyValue::One(1.0)), TrackKey::new(9.0, KeyValue::One(2.0))];
    scene.tracks.push(Track::new(TrackId::new(&mut scene.next_id), "sky/gain", keys));
    scene
}
