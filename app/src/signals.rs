//! What the system says by signals, where it has them.

/// A write beyond the largest size that files may have (`ulimit -f`) fails from now on, as on a full disk: by itself it
/// would end the program in the middle of the write.
pub(crate) fn fail_at_the_size_limit() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
}
