//! What an earlier run measured, if it was of the same.

use crate::chart::report::{self, Report};
use crate::chart::subject::Subject;
use crate::cli::failure::Failure;
use crate::cli::say;
use crate::{opening, storage};
use cloudwright_core::formats::scene_file;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

/// No report is larger, bytes.
const MAX_BYTES: usize = 64 << 20;

/// Tells what is drawn from anything else: the scene's file, its atlas, the moment, and who draws.
pub(super) fn input(scene: &Path, subject: &Subject<'_>) -> Result<String, Failure> {
    let mut hasher = DefaultHasher::new();
    env!("CARGO_PKG_VERSION").hash(&mut hasher);
    storage::read(scene, scene_file::MAX_BYTES)?.hash(&mut hasher);
    for tile in 0..cloudwright_core::sprites::TILES {
        subject.atlas.level(tile, 0).texels.hash(&mut hasher);
    }
    subject.sight.moment.clock_s.to_bits().hash(&mut hasher);
    subject.sight.moment.time_h.unwrap_or(subject.scene.time_of_day_h).to_bits().hash(&mut hasher);
    Ok(format!("{:016x}", hasher.finish()))
}

/// `head` with the methods of the report in `file`, if that is of the same input, view and size.
pub(super) fn read(file: &Path, head: Report) -> Result<Report, Failure> {
    if !storage::is_there(file) {
        return Ok(head);
    }
    let bytes = storage::read(file, MAX_BYTES)?;
    let before = report::read(&bytes)
        .map_err(|problem| Failure::argument(opening::problem_line(file, &problem), "it would be overwritten"))?;
    let same = (&before.input, &before.view, before.size) == (&head.input, &head.view, head.size);
    if !same {
        say("the chart in that folder is of something else: it is measured anew");
        return Ok(head);
    }
    // Times of another adapter don't compare.
    let unfinished = before.unfinished || before.adapter != head.adapter;
    Ok(Report { methods: before.methods, unfinished, ..head })
}
