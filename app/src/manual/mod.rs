//! The manual within the program: pages of Markdown, one for each panel and some for what goes beyond.
//!
//! What is written elsewhere is not written again: the walk through a first cloud and the command line are README's, keys come
//! from the command table, functions for scripts from the plugins' own manual, news from the changelog.

use crate::command::manual::shortcuts;
use std::borrow::Cow;
use std::sync::LazyLock;

/// Of a user who begins.
pub(crate) const FIRST: &str = "First cloud";
/// Of a user who has been here before.
pub(crate) const NEWS: &str = "What's new";

const README: &str = include_str!("../../../README.md");
const PLUGINS: &str = include_str!("../../../scripts/MANUAL.md");
const CHANGES: &str = include_str!("../../../CHANGELOG.md");

/// A page.
#[derive(Debug)]
pub(crate) struct Page {
    /// In the list; a panel's page has the name on its tab.
    pub(crate) title: &'static str,
    /// Markdown.
    pub(crate) text: Cow<'static, str>,
}

/// All, in the order in which they are listed.
pub(crate) static PAGES: LazyLock<Vec<Page>> = LazyLock::new(|| {
    let first = part_of(README, "From an empty scene to a cloud in a picture");
    let written = |title, text: &'static str| Page { title, text: text.into() };
    vec![
        written(FIRST, first),
        written("Viewport", include_str!("pages/viewport.md")),
        written("Outline", include_str!("pages/outline.md")),
        written("Inspector", include_str!("pages/inspector.md")),
        written("Levels", include_str!("pages/levels.md")),
        written("Groups", include_str!("pages/groups.md")),
        written("Sky", include_str!("pages/sky.md")),
        written("Flight", include_str!("pages/flight.md")),
        written("Timeline", include_str!("pages/timeline.md")),
        written("Script", include_str!("pages/script.md")),
        written("Chart", include_str!("pages/chart.md")),
        written("History", include_str!("pages/history.md")),
        written("Problems", include_str!("pages/problems.md")),
        written("By keyboard and by ear", include_str!("pages/keyboard.md")),
        written("Coming from other programs", include_str!("pages/habits.md")),
        Page { title: "Keys", text: shortcuts().into() },
        written("Writing a plugin", part_of(README, "Write a plugin")),
        written("Functions for plugins", PLUGINS),
        written("Command line", part_of(README, "Five minutes")),
        written(NEWS, CHANGES),
    ]
});

/// What stands under a heading of the second rank.
fn part_of(text: &'static str, heading: &str) -> &'static str {
    let parts = text.split("\n## ");
    parts.skip(1).find_map(|part| part.strip_prefix(heading)).unwrap_or_default()
}

/// The pages that hold all of the typed words, those first that have them in their title; with the first line that has one.
pub(crate) fn search(typed: &str) -> Vec<(&'static Page, Option<&'static str>)> {
    let words: Vec<String> = typed.split_whitespace().map(str::to_lowercase).collect();
    let has_all = |text: &str| {
        let text = text.to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let line_of = |page: &'static Page| {
        let mut lines = page.text.lines().filter(|line| !line.starts_with(['|', '`']) || line.len() > 8);
        lines.find(|line| words.first().is_some_and(|word| line.to_lowercase().contains(word)))
    };
    let holds = |page: &&Page| has_all(&format!("{} {}", page.title, page.text));
    let mut found: Vec<&'static Page> = PAGES.iter().filter(holds).collect();
    found.sort_by_key(|page| !has_all(page.title));
    found.into_iter().map(|page| (page, line_of(page))).collect()
}

/// The last lines of the changelog, newest first, without their marks.
pub(crate) fn newest(most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let latest = CHANGES.split("\n## ").nth(1).unwrap_or_default();
    for line in latest.lines().skip(1) {
        match line.strip_prefix("- ") {
            Some(begins) => lines.push(begins.into()),
            None if line.starts_with("  ") => {
                if let Some(last) = lines.last_mut() {
                    last.push(' ');
                    last.push_str(line.trim());
                }
            }
            None => {}
        }
    }
    lines.into_iter().rev().take(most).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_has_a_text_and_a_name_of_its_own() {
        for (at, page) in PAGES.iter().enumerate() {
            assert!(page.text.len() > 200, "{}: {}", page.title, page.text);
            assert!(PAGES[at + 1..].iter().all(|other| other.title != page.title), "{}", page.title);
        }
    }

    #[test]
    fn words_are_found_wherever_they_stand() {
        let titles = |typed| search(typed).iter().map(|(page, _)| page.title).collect::<Vec<_>>();
        assert_eq!(titles("timeline").first(), Some(&"Timeline"));
        assert!(titles("COLOUR level handle").contains(&"Levels"));
        assert!(titles("xyzzy").is_empty());
        assert_eq!(titles("").len(), PAGES.len());
        assert!(search("ripple").iter().any(|(_, line)| line.is_some_and(|line| line.contains("Ripple"))));
        assert_eq!(newest(3).len(), 3);
    }
}
