//! The manual of plugins, as Markdown, and the functions' definitions for editors of code: both from what is registered
//! and from what ships, so that neither can say what is not so.

use crate::bindings::{SUBJECTS, Usage};
use crate::description::{Description, PluginKind};
use crate::limits;
use crate::parameter::Parameter;
use crate::shipped::SHIPPED;
use crate::{Plugin, ScriptError};
use std::fmt::Write;

const OPENING: &str = "# Plugins

A plugin is one Rhai script, `NAME.rhai`. It begins with what it is, `const PLUGIN = #{ … }`, which is read before a line of
it runs: menu entry, dialog, flags of `cloudwright run` and the pages below follow from that alone. Then stands
`fn run(parameters) { … }`, which is called once. What it asks for becomes one undo point, or nothing at all if anything
fails. Same scene and values: same edits, on every machine.

```
cloudwright run NAME.rhai SCENE -o OUT --set count=40 --seed 7
```

The language is [Rhai](https://rhai.rs/book/language/). Lengths are metres, angles degrees, times seconds; names of
parameters and properties end in their unit. Vectors are `[east, up, south]`, colours `[red, green, blue]` in linear light.
Things are named by their ids, properties by their addresses, such as `cloud/7/heading_deg`.

A script sees no files, no network and no clock. It runs in a process of its own, whose memory is bounded, and which is ended
when it takes too long.

";

/// The manual.
///
/// # Errors
/// If a plugin that ships can't be read.
pub fn manual() -> Result<String, ScriptError> {
    let mut text = OPENING.to_owned();
    let _ = writeln!(
        text,
        "At most {} things and {} keys a run, lists of {} items, texts of files of {} MiB.\n",
        limits::EDITS,
        limits::KEYS,
        limits::LIST_ITEMS,
        limits::EXPORTED_BYTES >> 20
    );
    text.push_str("## Functions\n");
    for (subject, functions) in SUBJECTS {
        let _ = writeln!(text, "\n### {subject}\n\n| written | does |\n|---|---|");
        for (_, written, does) in *functions {
            let _ = writeln!(text, "| `{}` | {} |", cell(written), cell(does));
        }
    }
    text.push_str("\n## Plugins that ship\n");
    for kind in PluginKind::ALL {
        let _ = writeln!(text, "\n### Kind `{}`", kind.name());
        for shipped in SHIPPED {
            let description = Plugin::read(shipped.source)?.description;
            if description.kind == *kind {
                page(&mut text, shipped.name, &description);
            }
        }
    }
    Ok(text)
}

fn page(text: &mut String, name: &str, description: &Description) {
    let _ = writeln!(text, "\n#### {} (`{name}`)\n\n{}\n", description.name, description.sentence);
    if !description.ending.is_empty() {
        let _ = writeln!(text, "Its files end in `.{}` if nothing else is given.\n", description.ending);
    }
    if description.parameters.is_empty() {
        return;
    }
    text.push_str("| parameter | what | if not given | |\n|---|---|---|---|\n");
    for Parameter { name, help, kind, initial, .. } in &description.parameters {
        let [kind, initial] = [kind.to_string(), initial.to_string()].map(|words| cell(&words));
        let _ = writeln!(text, "| `{name}` | {kind} | {initial} | {} |", cell(help));
    }
}

/// A table's cell has no bars of its own.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// Our functions as a Rhai definition file, each with what it does. Lists, maps and numbers of either kind are `?`.
pub fn definitions() -> String {
    let usage = |line: &str| -> Option<&Usage> {
        let name = line.strip_prefix("fn ")?.split('(').next()?;
        SUBJECTS.iter().flat_map(|(_, list)| *list).find(|(known, ..)| *known == name)
    };
    let mut text = "module static;\n".to_owned();
    for line in crate::host::definitions().lines() {
        let Some((_, written, does)) = usage(line) else { continue };
        // What it returns is told by the words: the engine knows only that it may fail.
        let head = line.split(" ->").next().unwrap_or(line).trim_end_matches(';');
        let _ = write!(text, "\n/// {does}\n///\n/// `{written}`\n{head} -> ?;\n");
    }
    text
}
