//! What is sound comes back as from one thread; who cancels is heard at once; the process gets to know nothing else.

use crate::{host, plugin, run_by, scene};
use cloudwright::scripting::Request;
use cloudwright_core::scene::{CameraPath, PathId, PathKey, Thing};
use cloudwright_scripts::shipped::SHIPPED;
use cloudwright_scripts::{Fault, Patience, Plugin};
use glam::DVec3;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

#[test]
fn shipped_plugins_make_what_they_make_in_one_thread() {
    let _alone = crate::alone();
    let mut scene = scene();
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
    // How long they take on a busy machine is not what is asked.
    let patience = Patience { until: None, ..Patience::usual() };
    for shipped in SHIPPED {
        let plugin = Plugin::read(shipped.source).expect(shipped.name);
        let values = plugin.values();
        let request = Request { plugin: &plugin, scene: &scene, selected: &selected, values: &values };
        let apart = host().run(request, &patience);
        assert!(apart.is_ok(), "{}: {apart:?}", shipped.name);
        assert_eq!(apart, plugin.run_on(&scene, &selected, &values, &patience), "{}", shipped.name);
    }
}

#[test]
fn who_cancels_is_heard_at_once() {
    let _alone = crate::alone();
    let endless = plugin("edit", "loop { }");
    let patience = Patience { until: None, ..Patience::usual() };
    let cancelled = Arc::clone(&patience.cancelled);
    let canceller = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(300));
        cancelled.store(true, Ordering::Relaxed);
        Instant::now()
    });
    let error = run_by(&host(), &endless, &patience).expect_err("endless");
    let heard = canceller.join().expect("it cancelled").elapsed();
    assert_eq!(error.fault, Fault::Cancelled, "{error}");
    assert!(heard < Duration::from_millis(500), "{heard:?}");
}

#[test]
fn a_script_without_patience_is_told_where_it_was() {
    let _alone = crate::alone();
    let patience = Patience { until: Some(Instant::now() + Duration::from_millis(100)), ..Patience::usual() };
    let error = run_by(&host(), &plugin("edit", "let a = 1;\nloop { }"), &patience).expect_err("endless");
    assert_eq!((error.fault, error.place.map(|place| place.line)), (Fault::Limit, Some(4)), "{error}");
}

#[test]
fn many_run_side_by_side() {
    let _alone = crate::alone();
    let adds = plugin("edit", "for i in 0..100 { add_camera(#{ name: `${i}` }); }");
    let run = || run_by(&host(), &adds, &Patience::usual()).map(|outcome| outcome.edits.len());
    let threads: Vec<_> = std::thread::scope(|scope| {
        let started: Vec<_> = (0..8).map(|_| scope.spawn(run)).collect();
        started.into_iter().map(|thread| thread.join().expect("it ran")).collect()
    });
    assert!(threads.iter().all(|edits| *edits == Ok(200)), "{threads:?}");
}

/// Whoever starts it by hand is told what it is, and one whose caller has died ends by itself.
#[test]
fn it_is_nothing_to_start_by_hand_and_outlives_nobody() {
    let _alone = crate::alone();
    use std::io::Write;
    use std::process::{Command, Stdio};
    let start = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cloudwright"));
        command.arg("script-host").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command.spawn().expect("it starts")
    };
    let by_hand = start().wait_with_output().expect("it ends");
    assert_eq!(by_hand.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&by_hand.stderr).contains("write cloudwright run"), "{by_hand:?}");
    let endless = plugin("edit", "loop { }");
    let request = cloudwright_scripts::caged::request(&endless, &scene(), &[], &endless.values(), None);
    let mut left = start();
    let mut stdin = left.stdin.take().expect("piped");
    stdin.write_all(&request.expect("a sound scene")).expect("it reads");
    std::thread::sleep(Duration::from_millis(300));
    assert!(left.try_wait().expect("a child").is_none(), "it runs as long as somebody waits");
    drop(stdin);
    let began = Instant::now();
    while left.try_wait().expect("a child").is_none() {
        assert!(began.elapsed() < Duration::from_secs(5), "it runs for nobody");
        std::thread::sleep(Duration::from_millis(5));
    }
}
