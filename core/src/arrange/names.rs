//! Names that are not taken yet.

use std::collections::{BTreeMap, BTreeSet};

/// The names that are taken, those that were given out included.
#[derive(Debug, Clone, Default)]
pub struct Names {
    taken: BTreeSet<String>,
    /// For each stem the number below which none is free.
    next: BTreeMap<String, usize>,
}

impl Names {
    /// Starts with those that are taken.
    pub fn new<'a>(taken: impl IntoIterator<Item = &'a str>) -> Self {
        Self { taken: taken.into_iter().map(String::from).collect(), next: BTreeMap::new() }
    }

    /// `name`, or with another number behind it, whichever is the first that is free; it is then taken.
    pub fn free(&mut self, name: &str) -> String {
        let stem = match name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end() {
            "" => name,
            stem => stem,
        };
        let next = self.next.entry(stem.into()).or_insert(1);
        loop {
            let candidate = if *next == 1 { stem.into() } else { format!("{stem} {next}") };
            *next += 1;
            if self.taken.insert(String::clone(&candidate)) {
                return candidate;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_free_number() {
        let mut names = Names::new(["heap", "heap 3", "7"]);
        let given: Vec<String> = ["heap", "heap 3", "heap 9", "new", "7"].map(|name| names.free(name)).into();
        assert_eq!(given, ["heap 2", "heap 4", "heap 5", "new", "7 2"]);
        assert_eq!([names.free(""), names.free("")], ["", " 2"]);
    }
}
