//! `cloudwright check`: the problems of scenes, a line each.

use super::failure::{Failure, PROBLEMS_FOUND, UNUSABLE_INPUT};
use super::{answer, say};
use crate::opening::{self, Beside, OpenError};
use cloudwright_core::derived::Derived;
use cloudwright_core::problem::{self, Problem};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright check storm.cloudscene
  cloudwright check --json *.cloudscene

Each line reads FILE: PLACE: error or note: MESSAGE (HINT). A scene with errors can't be used; notes are worth a look.
Exit codes: 0 no problems, 1 problems found, 2 a file can't be read.")]
pub(super) struct Arguments {
    /// Scenes to check
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Answer as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct ProblemOut<'a> {
    file: String,
    severity: &'static str,
    place: &'a str,
    message: &'a str,
    hint: &'a str,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut unreadable = false;
    let mut found: Vec<(&Path, Problem)> = Vec::new();
    for path in &arguments.scenes {
        match problems_of(path) {
            Ok(problems) => found.extend(problems.into_iter().map(|problem| (path.as_path(), problem))),
            Err(error) => {
                say(&error.to_string());
                unreadable = true;
                // Who reads only the list must not take such a file for a clean one.
                if arguments.json {
                    found.push((path, Problem::error("file", error.to_string(), "check its name and permissions")));
                }
            }
        }
    }
    answer(&if arguments.json { as_json(&found)? } else { as_lines(&found) })?;
    match (unreadable, found.is_empty()) {
        (true, _) => Err(Failure::Told(UNUSABLE_INPUT)),
        (false, false) => Err(Failure::Told(PROBLEMS_FOUND)),
        (false, true) => {
            say("no problems");
            Ok(())
        }
    }
}

/// All that there is to say about a scene file, what it names and its sprites.
fn problems_of(path: &Path) -> Result<Vec<Problem>, OpenError> {
    let scene = match opening::open_scene(path) {
        Ok(scene) => scene,
        Err(OpenError::Problems { problems, .. }) => return Ok(problems),
        Err(error) => return Err(error),
    };
    let mut problems = problem::check_with_sprites(&scene, Derived::new(&scene).clouds());
    problems.extend(Beside::read(&scene, Some(path)).1);
    Ok(problems)
}

fn as_lines(found: &[(&Path, Problem)]) -> String {
    found.iter().map(|(path, problem)| opening::problem_line(path, problem) + "\n").collect()
}

fn as_json(found: &[(&Path, Problem)]) -> Result<String, Failure> {
    let list: Vec<ProblemOut<'_>> = found
        .iter()
        .map(|(path, problem)| ProblemOut {
            file: path.display().to_string(),
            severity: opening::severity_name(problem),
            place: &problem.place,
            message: &problem.message,
            hint: &problem.hint,
        })
        .collect();
    super::info::json_text(&list)
}
