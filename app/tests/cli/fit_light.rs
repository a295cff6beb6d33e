//! A scene lit as a path tracer lights it, through the command line.

use crate::Place;
use crate::scenes::good;

#[test]
fn says_how_near_it_was_and_is() {
    let place = Place::new();
    let ran = place.run("fit-light good.cloudscene -o lit.cloudscene --samples 2 --time 9:00 --time 15:30");
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    for wanted in ["by the sun at 09:00, 15:30", "“heap”: error ", " before, ", "; self-shadow "] {
        assert!(ran.stderr.contains(wanted), "no “{wanted}” in: {}", ran.stderr);
    }
    assert_eq!(place.run("check lit.cloudscene").code, 0);
    assert_ne!(place.read("lit.cloudscene"), good().as_bytes());
    let again = "fit-light good.cloudscene -o again.cloudscene --samples 2 --time 9:00 --time 15:30 --model heap";
    assert_eq!(place.run_on("1", again).code, 0);
    assert!(place.read("again.cloudscene") == place.read("lit.cloudscene"), "the same bytes on one thread");
}

#[test]
fn refusals_leave_nothing() {
    let place = Place::new();
    let fit = "fit-light good.cloudscene -o lit.cloudscene";
    place.refuses("fit-light good.cloudscene -o good.cloudscene --force", 2, &["that is the scene itself"]);
    place.refuses("fit-light good.cloudscene -o lit.json", 2, &[".cloudscene"]);
    place.refuses(&format!("{fit} --time 1:00"), 2, &["--time 01:00", "not above the horizon"]);
    place.refuses(&format!("{fit} --model heep"), 2, &["there is no model “heep”", "heap"]);
    place.refuses(&format!("{fit} --samples 0"), 2, &["--samples"]);
    place.refuses(&format!("{fit} --keep levels --keep shares --keep self-shadow"), 2, &["nothing is to be fitted"]);
    place.put("lit.cloudscene", b"precious");
    place.refuses(&format!("{fit} --samples 1 --time 9:00"), 2, &["--force"]);
    assert_eq!(place.read("lit.cloudscene"), b"precious");
}
