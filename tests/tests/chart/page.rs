//! The page as a reader gets it.
//!
//! To look at it: `CLOUDWRIGHT_CHART=DIR cargo test -p cloudwright-tests --test chart example_page` keeps it there, in
//! the size that a run has.

use super::example::{self, Drawn, EXAMPLES, page};
use super::markup::{count, elements};
use cloudwright::chart::Family;
use cloudwright::chart::html::{Look, Page, write};
use cloudwright::chart::report::{LeftOut, MethodFigures, Report, Viewpoint};
use cloudwright::chart::svg::{Mark, Plot, Shape};
use cloudwright_core::image::Picture;
use std::path::PathBuf;

fn plain_picture(width: u32, height: u32) -> Picture {
    Picture { width, height, pixels: vec![[90, 120, 160, 255]; (width * height) as usize] }
}

#[test]
fn example_page() {
    let kept = std::env::var_os("CLOUDWRIGHT_CHART").map(PathBuf::from);
    let drawn = if kept.is_some() { Drawn::new([640, 360], 4) } else { Drawn::new([96, 54], 1) };
    let mut report = example::report();
    report.mark_front();
    let looks = drawn.looks();
    let page = page(&report, &drawn.pictures[0], &looks);
    let html = write(&page).expect("enough memory");
    assert!(html == write(&page).expect("enough memory"), "the same input gives the same bytes");

    let elements = elements(&html);
    // The truth once, and two pictures for each other method.
    assert_eq!(count(&elements, "img"), 1 + 2 * (EXAMPLES.len() - 1));
    assert_eq!(html.matches("alt=\"").count(), count(&elements, "img"));
    assert!(!html.contains("alt=\"\""));
    assert_eq!(count(&elements, "svg"), 4);
    assert_eq!(count(&elements, "article"), EXAMPLES.len());
    assert_eq!(html.matches("scope=\"row\"").count(), EXAMPLES.len());
    // In the table too, words tell a family and not its colour alone.
    let table = html.split("<table>").nth(1).expect("a table");
    for family in [Family::Shipped, Family::Failing] {
        let of_family = EXAMPLES.iter().filter(|example| example.family == family).count();
        assert_eq!(table.matches(&format!("{}</span>", family.name())).count(), of_family);
    }
    // Nothing is fetched: no address but the name of SVG's own language.
    assert_eq!(html.matches("://").count(), html.matches("http://www.w3.org/2000/svg").count());
    for sentence in [
        "The cheapest method within a mean FLIP of 0.02 is <strong>gpu</strong>: 6.9 ms a frame, FLIP 0.0079.",
        "Shipped is <strong>shipped fast</strong>: 21.4 ms a frame, FLIP 0.0062; the truth takes 133 times as long.",
        "Far from the front lie <strong>half the sprites</strong> (gpu errs 7.3 times less), <strong>lazy sorting (SimGear)",
        "Least steady is <strong>no lock</strong>",
    ] {
        assert!(html.contains(sentence), "{sentence}");
    }

    let Some(folder) = kept else { return };
    let marks: Vec<Mark<'_>> = EXAMPLES
        .iter()
        .map(|e| Mark { name: e.name, family: e.family, at: [e.figures[0], e.figures[1]], link: String::new() })
        .collect();
    let plot = Plot {
        title: "Frame time against error",
        cost_title: "frame time, ms",
        error_title: "FLIP, mean",
        less_error: "truer",
        marks: &marks,
        tolerance: Some(0.02),
    };
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("chart.html"), html).expect("a file");
    std::fs::write(folder.join("chart.svg"), plot.file(Shape::Wide)).expect("a file");
}

/// Names and reasons come out of files and command lines.
#[test]
fn names_are_text() {
    let bad = "</title><script>alert('1')</script>\"'&\u{0}";
    let method = MethodFigures {
        name: bad.into(),
        settings: [(bad.into(), bad.into())].into(),
        ..example::report().methods[1].clone()
    };
    let report = Report {
        scene: bad.into(),
        adapter: bad.into(),
        view: Some(Viewpoint::Camera(bad.into())),
        methods: vec![method],
        left_out: vec![LeftOut { name: bad.into(), reason: bad.into() }],
        ..example::report()
    };
    let truth = plain_picture(4, 3);
    for family in Family::ALL {
        let looks = [Look { name: bad, family, about: bad, picture: Some(&truth), errors: &[0.5; 12] }];
        let html = write(&page(&report, &truth, &looks)).expect("enough memory");
        let elements = elements(&html);
        assert_eq!(count(&elements, "script"), 1, "only the page's own");
        assert!(!html.contains("alert('1')") && !html.contains('\0'));
        assert!(html.contains("&lt;script&gt;"));
    }
}

/// Reports that say little, and pictures of odd sizes.
#[test]
fn poor_reports() {
    let unmeasured = MethodFigures { name: "unmeasured".into(), ..MethodFigures::default() };
    let without_path = |mut report: Report| {
        report.methods.iter_mut().for_each(|method| method.stability = None);
        report
    };
    let nothing = Report { methods: Vec::new(), left_out: Vec::new(), ..example::report() };
    let cases = [
        (nothing.clone(), "No method has been measured."),
        (Report { unfinished: true, ..nothing.clone() }, "run the same command again"),
        (Report { methods: vec![unmeasured], ..nothing }, "No method measured keeps within a mean FLIP of 0.02."),
        (without_path(example::report()), "--path NAME"),
        (example::report(), "dual-source"),
    ];
    for (report, want) in cases {
        for [width, height] in [[1, 1], [640, 1], [1, 300]] {
            let truth = plain_picture(width, height);
            let look = |example: &'static example::Example| Look {
                name: example.name,
                family: example.family,
                about: "",
                picture: Some(&truth),
                errors: &[],
            };
            let all: Vec<Look<'_>> = EXAMPLES.iter().map(look).collect();
            for looks in [&all[..], &[]] {
                let html = write(&page(&report, &truth, looks)).expect("enough memory");
                elements(&html);
                assert!(html.contains(want), "{want}");
            }
        }
    }
}

/// The tolerance is the reader's: all that is said goes by it.
#[test]
fn tolerance_is_one_number() {
    let (report, truth) = (example::report(), plain_picture(2, 2));
    for (tolerance, want) in [(0.05, "within a mean FLIP of 0.05 is <strong>gpu"), (0.003, "is <strong>truth")] {
        let html = write(&Page { tolerance, ..page(&report, &truth, &[]) }).expect("enough memory");
        assert!(html.contains(want), "{want}");
    }
}
