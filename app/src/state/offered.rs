//! How commands are offered now.

use crate::command::Command;
use std::collections::HashMap;

/// How a command is offered now.
#[derive(Debug, Clone)]
pub(crate) struct CommandState {
    /// Whether it has something to work on.
    pub(crate) enabled: bool,
    /// Whether what it switches is switched on.
    pub(crate) on: bool,
    /// What it would work on, by name, where that does not show.
    pub(crate) on_what: Option<String>,
}

/// Those that panels offer in menus of their own.
#[derive(Debug, Default)]
pub(crate) struct Offered(HashMap<Command, CommandState>);

impl Offered {
    /// Those `commands`, as `state` has them.
    pub(crate) fn new(commands: impl Iterator<Item = Command>, state: impl Fn(Command) -> CommandState) -> Self {
        Self(commands.map(|command| (command, state(command))).collect())
    }

    /// How it is offered; not at all if that was not asked before.
    pub(crate) fn of(&self, command: Command) -> CommandState {
        self.0.get(&command).cloned().unwrap_or(CommandState { enabled: false, on: false, on_what: None })
    }
}
