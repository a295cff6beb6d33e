//! Enough of a reader of markup to tell whether a page holds together.

/// Elements that have no end.
const VOID: [&str; 5] = ["meta", "img", "input", "br", "link"];

/// The names of all elements of `text` in order.
///
/// # Panics
/// If an element is not closed by its own end, or an attribute's value has no quotes.
pub fn elements(text: &str) -> Vec<String> {
    let (mut open, mut all): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        let end = rest.find('>').expect("a tag ends");
        let (tag, after) = (&rest[..end], &rest[end + 1..]);
        rest = after;
        if tag.starts_with('!') {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "after {:?}", all.last());
            continue;
        }
        let name = tag.split([' ', '/']).next().unwrap_or_default().to_owned();
        assert!(name.chars().all(|c| c.is_ascii_alphanumeric()), "<{tag}>");
        assert_eq!(tag.matches('"').count() % 2, 0, "<{tag}>");
        all.push(name.clone());
        if tag.ends_with('/') || VOID.contains(&name.as_str()) {
            continue;
        }
        if ["script", "style"].contains(&name.as_str()) {
            rest = &rest[rest.find(&format!("</{name}>")).expect("it ends")..];
        }
        open.push(name);
    }
    assert!(open.is_empty(), "never closed: {open:?}");
    all
}

/// How many elements of that name there are.
pub fn count(elements: &[String], name: &str) -> usize {
    elements.iter().filter(|element| *element == name).count()
}
