//! Programs in the place of the host that die, babble, are silent or don't listen: each an error of its kind, in time,
//! and none of them left behind.

use crate::{plugin, run_by};
use cloudwright::scripting::Host;
use cloudwright_scripts::{Fault, Patience};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::time::{Duration, Instant};

/// Begun, as a host says it.
const BEGUN: &str = r#"echo '{"Time":"Script"}'"#;

fn fake(folder: &Path, name: &str, script: &str) -> Host {
    let path = folder.join(name);
    std::fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("writable");
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).expect("its own");
    Host::at(path)
}

#[test]
fn none_of_them_holds_the_caller_up() {
    let _alone = crate::alone();
    let folder = tempfile::tempdir().expect("a folder");
    let begun = |rest: &str| format!("{BEGUN}\n{rest}");
    // A request that no pipe holds: who does not read it must not be waited for.
    let long = plugin("edit", &"// a long remark that is handed on as well\n".repeat(5_000));
    for (name, script, fault, words) in [
        ("dies", "exit 7".into(), Fault::Broken, "ended without an answer (code 7)"),
        ("complains", "echo oh no >&2; exit 7".into(), Fault::Broken, "(code 7): oh no"),
        ("succeeds", "exit 0".into(), Fault::Broken, "ended without an answer (code 0)"),
        ("is_killed", "kill -KILL $$".into(), Fault::Limit, "the system has ended"),
        ("breaks", "kill -SEGV $$".into(), Fault::Broken, "broke down (signal 11)"),
        ("aborts", "echo 'memory allocation of 9 bytes failed' >&2; kill -ABRT $$".into(), Fault::Limit, "more memory"),
        ("overflows", "echo 'thread x has overflowed its stack' >&2; kill -ABRT $$".into(), Fault::Limit, "too deep"),
        ("babbles", "echo hello".into(), Fault::Broken, "what can't be read"),
        ("babbles_bytes", "head -c 100000 /dev/urandom; echo".into(), Fault::Broken, "what can't be read"),
        ("babbles_later", begun("cat >/dev/null & echo '{}'; exec sleep 100"), Fault::Broken, "what can't be read"),
        ("stops_in_the_middle", begun(r#"printf '{"Ended":{"Ok":'"#), Fault::Broken, "without an answer"),
        ("never_ends_a_line", "exec cat /dev/zero".into(), Fault::Broken, "answers without end"),
        ("repeats", format!("while true; do {BEGUN}; done"), Fault::Limit, "takes too long"),
        ("is_silent", begun("exec sleep 100"), Fault::Limit, "takes too long"),
        ("closes_its_mouth", "exec >&-; exec sleep 100".into(), Fault::Broken, "answers nothing"),
        ("closes_its_ears", begun("exec <&-; exec sleep 100"), Fault::Limit, "takes too long"),
        ("fills_stderr", "cat /dev/zero >&2 & sleep 1; kill $!; exit 3".into(), Fault::Broken, "(code 3)"),
        ("leaves_one_behind", "sleep 20 & exit 4".into(), Fault::Broken, "(code 4)"),
    ] {
        let host = fake(folder.path(), name, &script);
        let patience = Patience { until: Some(Instant::now() + Duration::from_millis(300)), ..Patience::usual() };
        let start = Instant::now();
        let error = run_by(&host, &long, &patience).expect_err(name);
        let took = start.elapsed();
        assert_eq!(error.fault, fault, "{name}: {error}");
        assert!(error.to_string().contains(words), "{name}: {error}");
        assert!(!error.hint.is_empty(), "{name}: {error}");
        assert!(took < Duration::from_secs(4), "{name}: {took:?}");
    }
    #[cfg(target_os = "linux")]
    assert!(crate::watched::children().iter().all(|(_, state)| *state != 'Z'), "{:?}", crate::watched::children());
}

#[test]
fn what_is_no_program_is_told() {
    let _alone = crate::alone();
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("text"), "no program").expect("writable");
    for name in ["missing", "text"] {
        let host = Host::at(folder.path().join(name));
        let error = run_by(&host, &plugin("edit", ""), &Patience::usual()).expect_err(name);
        assert_eq!(error.fault, Fault::Broken, "{error}");
        assert!(error.to_string().contains("can't be started"), "{error}");
    }
}
