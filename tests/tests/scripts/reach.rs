//! What hands can do to a document, scripts can: whole things, paths, groups, single sprites; and they can measure it.

use crate::plugins::{after, plugin, run};
use crate::scene;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::coverage;
use cloudwright_core::problem;
use cloudwright_core::scene::{CloudId, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use glam::DVec3;

/// Runs `body` on the usual scene, where it `throw`s what it finds wrong; the scene after it has no problems.
fn check(body: &str) -> Scene {
    let scene = after(body);
    assert_eq!(problem::check(&scene), [], "{body}");
    scene
}

/// A path of two legs: 10 s northwards at 100 m/s, and 20 s eastwards and up.
const PATH: &str = "
    let keys = [[0, [0, 500, 0]], [10, [0, 500, -1000]], [30, [1000, 700, -1000]]];
    let path = add_path(#{ name: \"over\", keys: keys.map(|key| #{
        time_s: key[0] + 5, position: key[1], heading_deg: 350, pitch_deg: 0,
    }) });
    let near = |a, b| if abs(a - b) > 1e-6 * max(1.0, abs(b)) { throw `${a} for ${b}` };
";

fn on_path(body: &str) -> Scene {
    check(&format!("{PATH}{body}"))
}

#[test]
fn paths_are_added_flown_and_timed() {
    let scene = on_path(
        "near.call(path_duration_s(path), 30);
         let start = path_at(path, -3);
         if start.position != [0.0, 500.0, 0.0] || start.heading_deg != 350.0 { throw `${start}` }
         let first = path_at(path, 5);
         near.call(first.direction[2], -1);
         if first.speed_mps < 80.0 || first.position[2] > -300.0 { throw `${first}` }
         let all = path_length_m(path);
         if all < 1000.0 + 1019.0 || all > 2200.0 { throw `${all} m` }
         near.call(path_at_m(path, all).position[0], 1000);
         let places = along(path, 100);
         if places.len() != (all / 100.0).to_int() + 1 { throw `${places.len()}` }
         for i in 1..places.len() {
             let apart = distance(places[i].position, places[i - 1].position);
             if apart > 100.2 || apart < 90.0 { throw `${apart} m` }
         }
         set_leg_speed(path, 0, 50);
         if abs(leg_speed_mps(path, 0) - 50.0) > 0.1 { throw `${leg_speed_mps(path, 0)}` }
         let thinned = thin_keys(fields(`path/${path}`).keys, 5000, 90);
         change(`path/${path}`, #{ keys: thinned, field_of_view_deg: 40 });
         let leader = add_aircraft(#{ path: path, name: \"leader\", ahead_s: 2 });
         let tower = add_prop(#{ model: \"tower.glb\", position: [0, 0, -500], heading_deg: 30 });
         if props() != [tower] || get(`prop/${tower}/position`) != [0.0, 0.0, -500.0] { throw \"props\" }
         change(`prop/${tower}`, #{ model: \"mast.glb\" });
         if fields(`prop/${tower}`).model != \"mast.glb\" { throw \"its file\" }
         if aircraft() != [leader] || paths() != [path] { throw \"listed\" }
         let copies = copy([`path/${path}`, `camera/${cameras()[0]}`, `prop/${tower}`]);
         if copies.len() != 3 || !has(copies[0]) || !has(copies[1]) { throw `${copies}` }",
    );
    assert_eq!((scene.paths.len(), scene.paths[0].keys.len(), scene.aircraft.len()), (2, 2, 1));
    assert!((scene.paths[0].field_of_view_deg - 40.0).abs() < 1e-9);
}

#[test]
fn whole_things_are_read_and_changed() {
    let scene = check(
        "let sky = fields(\"sky\");
         sky.directional.remove(0);
         change(\"sky\", #{ directional: sky.directional, turbidity: 4 });
         if get(\"sky/turbidity\") != 4.0 { throw \"turbidity\" }
         let cloud = clouds()[0];
         change(`cloud/${cloud}`, #{ formed: #{ core: 0.5, edges: 0.25 }, formation: #{ change: \"dissipating\" } });
         let made = fields(`cloud/${cloud}`);
         if made.formed.core != 0.5 || made.formation.core_s != 20.0 { throw `${made}` }
         let model = get(`cloud/${cloud}/model`);
         let one = boxes(model)[0];
         change(`model/${model}/box/${one}`, #{ sprite_edits: [#{ index: 0, dropped: true }], lumps: [2, 1, 1] });
         remove(\"ground\");
         if has(\"ground\") { throw \"ground\" }
         change(\"ground\", #{ altitude_m: -50 });
         change(\"weather\", #{ region: #{ width_m: 9000, depth_m: 8000, center_x_m: 0, center_z_m: 0, border_m: 500 } });
         let added = add_preset(\"cumulus_humilis\", [0, 900, 0]);
         let other = add_preset_model(\"wisps\");
         if !models().contains(other) || !clouds().contains(added) { throw \"presets\" }",
    );
    let cloud = &scene.clouds[0];
    assert!(cloud.formed.is_some_and(|formed| formed.edges == 0.25));
    let first = &scene.model(cloud.model).expect("its model").boxes[0];
    assert!(first.sprite_edits[0].dropped && first.lumps == [2, 1, 1]);
    assert!((scene.ground.as_ref().expect("a ground").altitude_m + 50.0).abs() < 1e-9);
    assert!((scene.weather.region.expect("a region").depth_m - 8_000.0).abs() < 1e-9);
}

#[test]
fn clouds_are_joined_split_placed_and_grouped() {
    let scene = check(
        "let one = clouds()[0];
         let copies = duplicate_own([one], [800, 0, 0]);
         let all = boxes_of(one).len();
         let parted = split(copies[0], [boxes_of(copies[0])[0]]);
         if boxes_of(parted).len() != 1 || boxes_of(copies[0]).len() != all - 1 { throw \"split\" }
         if join([copies[0], parted]) != copies[0] || has(`cloud/${parted}`) { throw \"join\" }
         let model = get(`cloud/${copies[0]}/model`);
         let some = [];
         for id in boxes(model).extract(0, 2) { some.push(`model/${model}/box/${id}`); }
         let top = put_in_group(model, some, \"top\");
         if groups(model) != [top] || get(some[0] + \"/group\") != top { throw \"group\" }
         if put_in_group(model, [some[0]], ()) != () { throw \"own\" }
         let many = place_many(model, #{ count: 9, center: [0, 2000, 0], pattern: \"grid\", scale: [0.5, 0.5] });
         if many.len() != 9 || get(`cloud/${many[8]}/scale`) != 0.5 { throw \"many\" }
         if auto_group(one).is_empty() { throw \"groups of thirty\" }",
    );
    assert_eq!(scene.clouds.len(), 11);
}

#[test]
fn single_sprites_are_found_dropped_and_moved() {
    let before = scene();
    let sprites = |scene: &Scene| Derived::new(scene).clouds()[0].sprites.len();
    let scene = check(
        "let cloud = clouds()[0];
         let model = get(`cloud/${cloud}/model`);
         let reach = bounds(cloud);
         let middle = lerp(reach[0], reach[1], 0.5);
         let near = sprites_near(cloud, [add(middle, [-900, 0, 0]), add(middle, [900, 0, 0])], 20);
         if near.is_empty() || !sprites_near(cloud, [[99999, 0, 0]], 20).is_empty() { throw `${near.len()}` }
         // Those that were culled for them come forth, until none is left.
         let left = near;
         while !left.is_empty() {
             drop_sprites(model, left);
             left = sprites_near(cloud, [add(middle, [-900, 0, 0]), add(middle, [900, 0, 0])], 20);
         }
         reset_sprites(model, [near[0]]);
         move_sprites(model, [[near[0][0], near[0][1], to_model(cloud, add(middle, [0, 4000, 0]))]]);
         if abs(bounds(cloud)[1][1] - middle[1] - 4000.0) > 500.0 { throw `${bounds(cloud)}` }
         let there = to_world(cloud, [1, 2, 3]);
         if distance(to_model(cloud, there), [1, 2, 3]) > 1e-6 { throw `${there}` }",
    );
    assert!(sprites(&scene) < sprites(&before));
}

#[test]
fn keys_and_curves_are_at_hand() {
    check(
        "key(\"sky/exposure_ev\", 2, 1); key(\"sky/exposure_ev\", 4, 1);
         if keyed() != [\"sky/exposure_ev\"] { throw `${keyed()}` }
         if !remove_key(\"sky/exposure_ev\", 4) || remove_key(\"sky/exposure_ev\", 3) { throw \"removed\" }
         let curve = [[0, 1], [10, 3], [20, 3]];
         let at = [];
         for x in [-5, 0, 5, 15, 99] { at.push(curve_at(curve, x)); }
         if at != [1.0, 1.0, 2.0, 3.0, 3.0] { throw `${at}` }
         let apart = |a, b| if distance(a, b) > 1e-9 { throw `${a}, not ${b}` };
         apart.call(towards(90), [1, 0, 0]);
         apart.call(turned(towards(30), 60), [1, 0, 0]);
         apart.call(cross([1, 0, 0], [0, 1, 0]), [0, 0, 1]);
         apart.call(normalize(subtract([3, 0, 4], [0, 0, 0])), [0.6, 0, 0.8]);
         apart.call(line([0, 0, 0], [4, 0, 0], 5)[3], [3, 0, 0]);
         let to = look([0, 0, 0], [10, 10, 0]);
         if abs(to.heading_deg - 90.0) + abs(to.pitch_deg - 45.0) > 1e-9 { throw `${to}` }
         if heading_of([-1, 5, 0]) != 270.0 || clamp(7, 0, 3) != 3.0 || dot([1, 2, 3], [3, 2, 1]) != 10.0 { throw \"x\" }
         let turn = orientation(90);
         if abs(turn[1] + sqrt(0.5)) > 1e-9 || abs(turn[3] - sqrt(0.5)) > 1e-9 { throw `${turn}` }",
    );
}

/// The script's own measure against the core's, from the same place.
#[test]
fn coverage_is_what_the_core_measures() {
    let printed = |body: &str| {
        let outcome = run(&plugin(body), &scene()).unwrap_or_else(|error| panic!("{body}: {error}"));
        outcome.printed.iter().map(|line| line.parse::<f64>().expect("a number")).collect::<Vec<_>>()
    };
    let got = printed(
        "let far = duplicate(clouds(), [5000, 900, 0]);
         print(coverage_oktas(#{ from: [0, 0, 0], least_elevation_deg: 5 }));
         print(coverage_oktas(#{ from: [0, 0, 0], least_elevation_deg: 5, clouds: far }));
         print(coverage_oktas(#{ from: [0, 0, 0], least_elevation_deg: 5, base_m: [0, 1000] }));
         remove(`cloud/${far[0]}`);
         print(coverage_oktas(#{ from: [0, 0, 0], least_elevation_deg: 5 }));
         for cloud in clouds() { remove(`cloud/${cloud}`); }
         print(coverage_oktas());",
    );
    let scene = scene();
    let derived = Derived::new(&scene);
    let seen = coverage(DVec3::ZERO, 5.0, 64, |camera, size| {
        Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(camera, size))
    });
    let wanted = 8.0 * seen.covered;
    assert!(wanted > 0.1, "{wanted}");
    assert!((got[2] - wanted).abs() < 1e-12 && (got[3] - wanted).abs() < 1e-12, "{got:?} for {wanted}");
    assert!(got[1] > 0.0 && (got[0] - got[1] - got[2]).abs() < 0.05, "{got:?}");
    assert_eq!(got[4], 0.0);
    assert!(scene.cloud(CloudId(999_999)).is_none());
}
