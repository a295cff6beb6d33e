//! Why a script's process ended without an answer, in words for whoever wrote the script.

use super::hold::OUT_OF_MEMORY;
use cloudwright_scripts::ScriptError;
use cloudwright_scripts::limits::MEMORY_BYTES;
use std::process::ExitStatus;

/// What the standard library says last, on every system, when memory or a thread's stack is used up.
const NO_MEMORY: [&str; 2] = ["memory allocation of ", "out of memory"];
const NO_STACK: &str = "has overflowed its stack";
/// What Windows makes of the latter.
const WINDOWS_NO_STACK: i32 = 0xC000_00FD_u32.cast_signed();

/// `status` is none for one that had to be killed.
pub(super) fn why(status: Option<ExitStatus>, errors: &str) -> ScriptError {
    let Some(status) = status else {
        return ScriptError::broken("the script's host answers nothing");
    };
    let code = status.code();
    if code == Some(OUT_OF_MEMORY) || NO_MEMORY.iter().any(|words| errors.contains(words)) {
        return out_of_memory();
    }
    if code == Some(WINDOWS_NO_STACK) || errors.contains(NO_STACK) {
        let hint = "lists in lists, or functions kept in functions? keep them side by side";
        return ScriptError::limit("what the script makes lies too deep in itself", hint);
    }
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        const KILLED: i32 = 9;
        if signal == KILLED {
            return ScriptError::limit("the system has ended the script's host", "is the machine short of memory?");
        }
        return ScriptError::broken(format!("the script's host broke down (signal {signal})"));
    }
    let said = errors.lines().last().unwrap_or_default().trim();
    let said = if said.is_empty() { String::new() } else { format!(": {said}") };
    ScriptError::broken(format!("the script's host ended without an answer (code {}){said}", code.unwrap_or_default()))
}

fn out_of_memory() -> ScriptError {
    let hint = "does it keep all that it makes, or make longer and longer texts?";
    ScriptError::limit(format!("the script needs more memory than the {} MiB it may have", MEMORY_BYTES >> 20), hint)
}
