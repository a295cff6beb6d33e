//! XML as a tree: there and back, and within its bounds.

use cloudwright_core::formats::xml::{Element, MOST_NODES, Style, read, write};

const STYLE: Style = Style { byte_order_mark: true, line_end: "\r\n", indent: "  ", closes: true, declares: true };

#[test]
fn there_and_back() {
    let text = "\u{feff}<?xml version='1.0'?>\n<!-- before -->\n<a x=\"1 &amp; &#50;\">\n <!-- words -->\n <b/>t&lt;x\n\n <c>é</c></a>\n";
    let root = read(text.as_bytes()).expect("sound");
    assert_eq!((root.attribute("x"), root.line, root.element("c").map(|c| c.line)), (Some("1 & 2"), 3, Some(7)));
    assert_eq!((root.text(), root.element("c").map(Element::text)), ("t<x".into(), Some("é".into())));
    let written = write(&root, STYLE);
    let again = read(&written).expect("sound");
    assert_eq!(write(&again, STYLE), written);
    let said = String::from_utf8(written).expect("text");
    assert!(
        said.starts_with("\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\"?>\r\n\r\n<a x=\"1 &amp; 2\">\r\n"),
        "{said}"
    );
    assert!(said.contains("<b></b>") && said.contains("<!-- words -->"), "{said}");
}

#[test]
fn what_is_broken_or_without_bounds_is_refused() {
    let bomb = "<!DOCTYPE a [<!ENTITY b \"ha\"><!ENTITY c \"&b;&b;\">]>\n<a>&c;</a>";
    let attributes = (0..300).map(|at| format!(" a{at}=''")).collect::<String>();
    let attributes = format!("<a{attributes}/>");
    let deep = "<a>".repeat(100_000);
    let many = format!("<a>{}</a>", "<b/>".repeat(MOST_NODES + 1));
    for (text, wanted) in [
        (&attributes[..], "more than 256 attributes"),
        ("", "line 1: it has no element"),
        ("<a>\n<b>\n", "line 3: it ends within b"),
        ("<a>\n</b>", "line 2:"),
        ("<a></a><b/>", "a second root"),
        ("words", "text stands outside"),
        ("<a>&c;</a>", "the entity “c” is not known"),
        ("<a x='&c;'/>", "line 1:"),
        ("<a x=1/>", "line 1:"),
        ("<a>&#xD800;</a>", "line 1:"),
        (bomb, "line 1: it has a document type"),
        (&deep, "more than 64 elements stand within"),
        (&many, "more than 500000 elements"),
    ] {
        let error = read(text.as_bytes()).expect_err(&text[..text.len().min(40)]).to_string();
        assert!(error.contains(wanted), "“{error}”, not “{wanted}”");
    }
    assert!(read(b"<a>\xFF</a>").is_err_and(|error| error.place == "byte 3"));
    assert!(read(b"\xFF\xFE<\0a\0").is_err_and(|error| error.message.contains("UTF-16")));
}
