//! Reading what a plugin says of itself needs no process: the largest and worst texts are read or refused in bounded time,
//! without the stack's end, whatever they nest or repeat.

use cloudwright_scripts::limits::SOURCE_BYTES;
use cloudwright_scripts::{Fault, Plugin};
use std::time::{Duration, Instant};

const HEAD: &str = r#"const PLUGIN = #{ name: "Test", kind: "edit", sentence: "For tests." };"#;

/// The clock's limit, and what else it takes on a busy machine where nothing is optimised.
const MOST: Duration = Duration::from_secs(6);

/// `piece` again and again between two ends, as often as a script may be long.
fn filled(begin: &str, piece: impl Fn(usize) -> String, end: &str) -> String {
    let mut text = format!("{HEAD}\n{begin}");
    let mut i = 0;
    loop {
        let next = piece(i);
        if text.len() + next.len() + end.len() >= SOURCE_BYTES {
            return text + end;
        }
        text += &next;
        i += 1;
    }
}

#[allow(clippy::print_stdout, reason = "what it measured is to be read")]
#[test]
fn the_worst_texts_are_read_or_refused_in_time() {
    let same = |piece: &'static str| move |_: usize| piece.to_owned();
    let run = |piece: &'static str| filled("fn run(p) { let a = 1;", same(piece), "}");
    let both = {
        let names: Vec<String> = (0..25_000).map(|i| format!("q{i}")).collect();
        format!("{HEAD}\nfn run(p) {{}} fn f({}) {{ {}", names.join(","), names[..8_000].join(";"))
    };
    for (name, text) in [
        ("statements", run("a;")),
        ("a remark", filled("fn run(p) {} /*", same("/* "), "")),
        ("a text", filled("fn run(p) { let a = \"", same("\\n"), "\"; }")),
        ("texts in texts", filled("fn run(p) { let a = ", same("`${"), "1; }")),
        ("variables", run("let a=a;")),
        ("a long sum", filled("fn run(p) { 1", same("+1"), "}")),
        ("a long chain", filled("fn run(p) { p", same(".a"), "}")),
        ("calls of calls", filled("fn run(p) { ", same("f("), "1 }")),
        ("indices", filled("fn run(p) { p", same("[0]"), "}")),
        ("minus of minus", filled("fn run(p) { ", same("- "), "1 }")),
        ("not of not", filled("fn run(p) { ", same("!"), "true }")),
        ("lists in lists", filled("fn run(p) { ", same("["), "}")),
        ("a long list", filled("fn run(p) { [", same("1,"), "] }")),
        ("maps in maps", filled("fn run(p) { ", same("#{a:"), "}")),
        ("a wide map", filled("fn run(p) { #{", |i| format!("k{i}:1,"), "} }")),
        ("blocks in blocks", filled("fn run(p) ", same("{"), "}")),
        ("loops in loops", filled("fn run(p) { ", same("loop{"), "}")),
        ("otherwise otherwise", filled("fn run(p) { if true {}", same("else if true {}"), "}")),
        ("cases", filled("fn run(p) { switch p {", |i| format!("{i}=>1,"), "} }")),
        ("wide cases", filled("fn run(p) { switch p {", |i| format!("{i}..999999999=>1,"), "} }")),
        ("functions in functions", filled("fn run(p) { ", same("|x| "), "1 }")),
        ("many functions", filled("fn run(p) { }", |i| format!("fn f{i}(){{}}"), "")),
        ("many parameters", filled("fn run(p) { } fn f(", |i| format!("q{i},"), ") {}")),
        ("many parameters, each used", both + "; }"),
        ("many arguments", filled("fn run(p) { f(", same("p,"), "p) }")),
        ("a header in headers", format!("const PLUGIN = {}", "#{a:[".repeat(50_000))),
        ("no text at all", "\u{1}\u{0}\u{fffd}".repeat(40_000)),
    ] {
        let start = Instant::now();
        let read = Plugin::read(&text);
        let took = start.elapsed();
        let said = read.as_ref().map_or_else(ToString::to_string, |_| "read".into());
        println!("{name:<30}{:>6} ms  {}", took.as_millis(), said.chars().take(90).collect::<String>());
        assert!(took < MOST, "{name}: {took:?}");
        if let Err(error) = read {
            assert_ne!(error.fault, Fault::Broken, "{name}: {error}");
        }
    }
}
