//! `chart.json` there and back, and what is said of one that is broken.

use super::example;
use cloudwright::chart::report::{MethodFigures, Report, Viewpoint, read, write};

#[test]
fn comes_back_as_it_went() {
    let mut full = example::report();
    full.mark_front();
    let on_front: Vec<&str> =
        full.methods.iter().filter(|method| method.on_front).map(|method| method.name.as_str()).collect();
    // By the figures of the example: each is truer than all that is cheaper, but for 8-bit blending, known to fail.
    assert_eq!(on_front, ["truth", "shipped fast", "plain", "gpu"]);
    let camera = Report { view: Some(Viewpoint::Camera("“a”\n<b>".into())), unfinished: true, ..Report::default() };
    let method = MethodFigures { name: "nothing known".into(), ..MethodFigures::default() };
    let poor = Report { methods: vec![method], ..Report::default() };
    for report in [full, camera, poor, Report::default()] {
        let text = write(&report).expect("JSON");
        assert_eq!(read(text.as_bytes()).expect("what was written"), report);
        assert_eq!(write(&read(text.as_bytes()).expect("again")).expect("JSON"), text);
    }
}

/// The names of issue and manual: programs of others read them.
#[test]
fn fields_have_their_names() {
    let text = write(&example::report()).expect("JSON");
    let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    for (pointer, want) in [
        ("/format", serde_json::json!("cloudwright-chart")),
        ("/version", 1.into()),
        ("/scene", "cumulonimbus_dusk".into()),
        ("/size", serde_json::json!([640, 360])),
        ("/adapter", "llvmpipe (LLVM 15.0.6, 256 bits)".into()),
        ("/path", "fly-through".into()),
        ("/methods/1/name", "shipped fast".into()),
        ("/methods/1/settings/sorting", "each frame".into()),
        ("/methods/1/cost/frame_ms", 21.4.into()),
        ("/methods/1/cost/gpu_ms", serde_json::Value::Null),
        ("/methods/1/cost/counts/sprites", 6764.into()),
        ("/methods/1/cost/counts/corners_shaded", 27056.into()),
        ("/methods/1/cost/counts/overdraw_p99", 64.into()),
        ("/methods/1/error/flip_mean", 0.0062.into()),
        ("/methods/1/stability/excess_mean", 0.000_41.into()),
        ("/methods/1/on_front", false.into()),
        ("/left_out/0/name", "dual-source".into()),
        ("/unfinished", false.into()),
    ] {
        assert_eq!(value.pointer(pointer), Some(&want), "{pointer}");
    }
}

#[test]
fn what_is_not_finite_is_null() {
    let mut report = example::report();
    report.methods[0].cost.frame_ms = Some(f64::NAN);
    report.methods[1].error.rmse = Some(f64::INFINITY);
    report.mark_front();
    assert!(!report.methods[0].on_front);
    let back = read(write(&report).expect("JSON").as_bytes()).expect("what was written");
    assert_eq!((back.methods[0].cost.frame_ms, back.methods[1].error.rmse), (None, None));
}

#[test]
fn broken_files_are_told_apart() {
    let good = write(&example::report()).expect("JSON");
    let check = |text: &str, place: &str, message: &str| {
        let problem = read(text.as_bytes()).expect_err("broken");
        assert!(problem.place.contains(place) && problem.message.contains(message), "{problem}");
        assert!(!problem.hint.is_empty());
    };
    check("", "line 1", "EOF");
    check(&good[..good.len() / 2], "line", "EOF");
    check("{}", "line 1", "format");
    check(&good.replace("cloudwright-chart", "cloudwright-scene"), "format", "cloudwright-scene");
    check(&good.replace("\"version\": 1", "\"version\": 2"), "version", "version 2");
    check(&good.replace("\"adapter\"", "\"adaptor\""), "line", "adapter");
    check(&good.replace("\"sprites\": 3382", "\"sprites\": -1"), "line", "-1");
}
