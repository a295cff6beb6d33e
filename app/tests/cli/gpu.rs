//! The GPU's part of the command line. What it draws is tested in the render package; here it is enough that it draws
//! where there is an adapter, and says what to do where there is none.

use crate::Place;

#[test]
fn a_picture_or_a_way_out() {
    let place = Place::new();
    for words in ["", " --samples 4"] {
        let ran = place.run(&format!("render good.cloudscene -o out.png --size 64x36 --renderer gpu{words}"));
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
