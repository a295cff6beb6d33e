//! The GPU's part of the command line. What it draws is tested in the render package; here it is enough that it draws
//! where there is an adapter, and says what to do where there is none.

use crate::Place;

#[test]
fn a_picture_or_a_way_out() {
    let place = Place::new();
    for words in ["", " --samples 4"] {
        let ran = place.run(&format!("render good.cloudscene -o out.png --size 64x36 --renderer gpu{words}"));
        let required = std::env::var("CLOUDWRIGHT_REQUIRE_GPU").is_ok_and(|value| value == "1");
        assert!(ran.code == 0 || !required, "an adapter is required: {}", ran.stderr);
        if ran.code == 0 {
            assert!(ran.stderr.contains("GPU: "), "{}", ran.stderr);
            assert!(place.read("out.png").starts_with(b"\x89PNG"));
        } else {
            assert_eq!(ran.code, 3, "{}", ran.stderr);
            assert!(ran.stderr.contains("--renderer cpu"), "{}", ran.stderr);
            assert_eq!(place.files(), ["good.cloudscene"]);
        }
    }
}

/// Drivers are hidden from the program, so this holds on a machine with a GPU too.
#[cfg(target_os = "linux")]
#[test]
fn without_an_adapter_it_says_what_to_do() {
    let place = Place::new();
    let hidden =
        ["VK_DRIVER_FILES", "VK_ICD_FILENAMES", "__EGL_VENDOR_LIBRARY_FILENAMES"].map(|name| (name, "/dev/null"));
    let run = |renderer: &str| {
        place.run_with(&hidden, &format!("render good.cloudscene -o out.png --size 64x36 --renderer {renderer}"))
    };
    let ran = run("gpu");
    assert_eq!(ran.code, 3, "{}", ran.stderr);
    assert!(ran.stderr.contains("--renderer cpu"), "{}", ran.stderr);
    assert_eq!(place.files(), ["good.cloudscene"]);
    let ran = run("auto");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("renderer: CPU"), "{}", ran.stderr);
}
