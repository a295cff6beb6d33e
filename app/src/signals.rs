//! What the system says by signals, where it has them.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A write beyond the largest size that files may have (`ulimit -f`) fails from now on, as on a full disk: by itself it
/// would end the program in the middle of the write.
pub(crate) fn fail_at_the_size_limit() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Sets `flag` when the program is told to end (SIGTERM, SIGINT, SIGHUP), so that what it has begun is cleared away. Told
/// a second time, it ends at once. What it was started to ignore it still ignores.
pub(crate) fn set_when_told_to_end(flag: &Arc<AtomicBool>) {
    #[cfg(unix)]
    let _ = hear(flag);
    #[cfg(not(unix))]
    let _ = flag;
}

/// Gives the signals by which `flag` is set from now on, and which end the program if it is set already.
#[cfg(unix)]
fn hear(flag: &Arc<AtomicBool>) -> std::io::Result<Vec<i32>> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let ignored = crate::storage::ignored_signals();
    let heard: Vec<i32> =
        [SIGTERM, SIGINT, SIGHUP].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0).collect();
    for &signal in &heard {
        // In this order: the first time, the flag is set too late to end the program.
        signal_hook::flag::register_conditional_default(signal, Arc::clone(flag))?;
        signal_hook::flag::register(signal, Arc::clone(flag))?;
    }
    Ok(heard)
}

/// Has `last` done, on a thread of its own, when the program is told to end (SIGTERM, SIGINT, SIGHUP); then it ends as it
/// would have by itself. Told a second time, it ends at once. What it was started to ignore it still ignores.
///
/// # Errors
/// If the system gives no thread or no pipe.
#[cfg(unix)]
pub(crate) fn before_the_end(last: impl FnOnce() + Send + 'static) -> std::io::Result<()> {
    use signal_hook::iterator::Signals;
    use signal_hook::low_level;

    let heard = hear(&Arc::default())?;
    let mut signals = Signals::new(&heard)?;
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            last();
            let _ = low_level::emulate_default_handler(signal);
        }
    };
    std::thread::Builder::new().name("signals".into()).spawn(wait).map(drop)
}

/// Elsewhere a program is told to end by its window alone.
///
/// # Errors
/// None.
#[cfg(not(unix))]
pub(crate) fn before_the_end(_last: impl FnOnce() + Send + 'static) -> std::io::Result<()> {
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use std::os::unix::process::ExitStatusExt;
    use std::path::Path;
    use std::process::Command;

    /// Where the child is told what to do last; unset in the parent.
    const CHILD_FILE: &str = "CLOUDWRIGHT_TEST_WRITES_LAST";
    const CHILD_SIGNAL: &str = "CLOUDWRIGHT_TEST_SIGNAL";

    /// Whether this program was started to ignore `signal`, as by nohup.
    fn is_ignored(signal: i32) -> bool {
        crate::storage::ignored_signals() >> (signal - 1) & 1 == 1
    }

    /// Not a test of its own: a program that is told to end. It ends by itself only where it ignores that.
    #[test]
    fn child() {
        let Some(file) = std::env::var_os(CHILD_FILE) else { return };
        let signal: i32 = std::env::var(CHILD_SIGNAL).expect("set").parse().expect("a number");
        let last = move || crate::storage::write_atomic(Path::new(&file), b"done").expect("writable");
        super::before_the_end(last).expect("a thread");
        signal_hook::low_level::raise(signal).expect("a signal");
        let wait_s = if is_ignored(signal) { 1 } else { 60 };
        std::thread::sleep(std::time::Duration::from_secs(wait_s));
    }

    /// How the child ends by a signal, and whether it did the last thing.
    fn end(folder: &Path, signal: i32, wrapper: &str) -> (Option<i32>, bool) {
        let file = folder.join(format!("{signal}{wrapper}"));
        let this = std::env::current_exe().expect("this test");
        let words = format!("{wrapper} exec \"$0\" --exact signals::tests::child --test-threads=1");
        let status = Command::new("sh")
            .args(["-c", &words])
            .arg(this)
            .envs([(CHILD_FILE, file.as_os_str()), (CHILD_SIGNAL, signal.to_string().as_ref())])
            .stdout(std::process::Stdio::null())
            .status()
            .expect("a shell");
        (status.signal(), file.exists())
    }

    #[test]
    fn the_last_thing_is_done_and_the_signal_ends_the_program() {
        let folder = tempfile::tempdir().expect("a folder");
        for signal in [SIGTERM, SIGINT, SIGHUP] {
            // What the tests were started to ignore, their children ignore too.
            let wanted = if is_ignored(signal) { (None, false) } else { (Some(signal), true) };
            assert_eq!(end(folder.path(), signal, ""), wanted, "{signal}");
        }
        #[cfg(target_os = "linux")]
        assert_eq!(end(folder.path(), SIGHUP, "trap '' HUP;"), (None, false), "as by nohup");
    }
}
