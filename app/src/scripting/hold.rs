//! How a script's process holds itself: bounds of the system's, which nothing in it can lift.

use cloudwright_scripts::limits::MEMORY_BYTES;
use std::io;
use std::time::Duration;

/// With this code ends one that watches itself and finds too much.
pub(super) const OUT_OF_MEMORY: i32 = 86;
/// Between two looks: at the rate at which memory can be filled, a small part of the bound.
const LOOK: Duration = Duration::from_millis(5);

/// Holds this program from now on: it opens and starts nothing more, writes to no file, leaves no image of its memory when
/// it dies, and has at most [`MEMORY_BYTES`].
///
/// # Errors
/// If the system refuses; the program is no cage then.
pub(crate) fn hold() -> io::Result<()> {
    #[cfg(unix)]
    {
        use rlimit::Resource;
        // What it reads and writes is open already.
        for resource in [Resource::CORE, Resource::FSIZE, Resource::NOFILE] {
            resource.set(0, 0)?;
        }
        #[cfg(any(target_os = "linux", target_os = "android"))]
        Resource::AS.set(MEMORY_BYTES as u64, MEMORY_BYTES as u64)?;
    }
    // Elsewhere no limit of addresses is kept.
    if !cfg!(any(target_os = "linux", target_os = "android")) {
        watch(MEMORY_BYTES, || std::process::exit(OUT_OF_MEMORY))?;
    }
    Ok(())
}

/// Looks again and again how much memory this program has, and does `then` once it is more than `most`.
fn watch(most: usize, then: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let look = move || {
        while used().is_none_or(|used| used <= most) {
            std::thread::sleep(LOOK);
        }
        then();
    };
    std::thread::Builder::new().name("memory".into()).spawn(look).map(drop)
}

/// Bytes, on Windows also those that lie on disk; none if the system does not tell.
fn used() -> Option<usize> {
    memory_stats::memory_stats().map(|stats| if cfg!(windows) { stats.virtual_mem } else { stats.physical_mem })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::channel;

    #[test]
    fn what_is_watched_is_found_too_large() {
        let (sender, found) = channel();
        let start = used().expect("the system tells");
        watch(start + (256 << 20), move || _ = sender.send(())).expect("a thread");
        assert!(found.recv_timeout(LOOK * 10).is_err(), "not yet");
        let mut filled = vec![1_u8; 512 << 20];
        assert!(found.recv_timeout(Duration::from_secs(20)).is_ok());
        filled.clear();
    }
}
