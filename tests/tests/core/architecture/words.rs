//! The words of a Rust source: names and signs, without comments, texts and numbers.

/// Every name, `::` and other sign of `source`, in order; lifetimes are left out too.
pub fn words(source: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(length) = text_length(rest) {
            length
        } else if first.is_ascii_digit() {
            number_length(rest)
        } else if first.is_alphabetic() || first == '_' {
            let length = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            found.push(&rest[..length]);
            length
        } else if rest.starts_with("::") {
            found.push("::");
            2
        } else {
            if !first.is_whitespace() {
                found.push(&rest[..first.len_utf8()]);
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    found
}

/// Of a text, character or lifetime that `rest` begins with.
fn text_length(rest: &str) -> Option<usize> {
    let prefix = rest.find(|c| !matches!(c, 'b' | 'c' | 'r')).filter(|length| *length <= 2)?;
    let quoted = &rest[prefix..];
    let hashes = quoted.find(|c| c != '#')?;
    if rest[..prefix].ends_with('r') && quoted[hashes..].starts_with('"') {
        let end = format!("\"{}", "#".repeat(hashes));
        let inside = prefix + hashes + 1;
        return Some(rest[inside..].find(&end).map_or(rest.len(), |at| inside + at + end.len()));
    }
    let mut signs = quoted.char_indices();
    let quote = signs.next().map(|(_, sign)| sign).filter(|sign| matches!(sign, '"' | '\''))?;
    let is_lifetime = quote == '\'' && !quoted[1..].starts_with('\\') && quoted.chars().nth(2) != Some('\'');
    if is_lifetime {
        let name = &quoted[1..];
        return Some(prefix + 1 + name.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(name.len()));
    }
    while let Some((at, sign)) = signs.next() {
        if sign == '\\' {
            signs.next();
        } else if sign == quote {
            return Some(prefix + at + 1);
        }
    }
    Some(rest.len())
}

/// Of a number with its suffix; the dots of a range are none of its.
fn number_length(rest: &str) -> usize {
    let mut length = 0;
    for part in rest.split_inclusive('.') {
        let own = part.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(part.len());
        length += own;
        let goes_on = own + 1 == part.len() && rest[length + 1..].starts_with(|c: char| c.is_ascii_digit());
        if !goes_on {
            break;
        }
        length += 1;
    }
    length
}

#[test]
fn names_and_signs_are_left() {
    let source = r##"
        /* a
        b */ use c; // d
        fn e<'f>(x: &'f str) { g::h("i \" j", 'k', '\'', b"l", r#"m " n"#, 1.5e3, 0..10, 2.0_f32.o()) }
    "##;
    let wanted = "use c ; fn e < > ( x : & str ) { g :: h ( , , , , , , . . , . o ( ) ) }";
    assert_eq!(words(source).join(" "), wanted);
}
