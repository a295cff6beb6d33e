//! `cloudwright rendr sky.cloudscene`: a first word that is neither a subcommand nor a scene to open.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::table::Arguments;
use crate::storage;
use clap::CommandFactory;
use std::ffi::OsString;
use std::path::Path;

/// That the first word is not nearly a subcommand's name. A file of that name is a scene all the same.
pub(super) fn check(args: &[OsString]) -> Result<(), Failure> {
    let Some(word) = args.get(1).and_then(|word| word.to_str()) else { return Ok(()) };
    let is_word = word.bytes().all(|b| b.is_ascii_alphanumeric());
    let command = Arguments::command();
    let told = command.get_subcommands().filter(|subcommand| !subcommand.is_hide_set());
    let names: Vec<&str> = told.map(clap::Command::get_name).collect();
    let hint = did_you_mean(word, &names);
    if !is_word || hint.is_empty() || names.contains(&word) || storage::is_there(Path::new(word)) {
        return Ok(());
    }
    let what = format!("there is no subcommand “{word}”, and no scene of that name");
    Err(Failure::argument(what, format!("{hint}the subcommands are {}", names.join(", "))))
}
