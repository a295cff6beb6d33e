//! This program's children, as the system sees them.

use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// Ids and states of this program's children; Z is a zombie.
pub(crate) fn children() -> Vec<(u32, char)> {
    let own = std::process::id().to_string();
    let stat = |entry: fs::DirEntry| {
        let id: u32 = entry.file_name().to_str()?.parse().ok()?;
        let text = fs::read_to_string(entry.path().join("stat")).ok()?;
        let mut fields = text.rsplit_once(") ")?.1.split(' ');
        let state = fields.next()?.chars().next()?;
        (fields.next()? == own).then_some((id, state))
    };
    fs::read_dir("/proc").expect("it is there").flatten().filter_map(stat).collect()
}

/// The line of a child's file that begins so.
fn line(child: u32, file: &str, begin: &str) -> Option<String> {
    let text = fs::read_to_string(format!("/proc/{child}/{file}")).ok()?;
    text.lines().find_map(|line| line.strip_prefix(begin)).map(String::from)
}

/// What was seen of children: the most memory that one had, KiB, and the bound that it held itself within, bytes.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Seen {
    pub(crate) resident_kib: u64,
    pub(crate) addresses_kib: u64,
    pub(crate) bound: u64,
    pub(crate) files: Option<u64>,
}

/// Looks at all children again and again until asked.
pub(crate) struct Watch {
    stop: Arc<AtomicBool>,
    thread: JoinHandle<BTreeMap<u32, Seen>>,
}

impl Watch {
    pub(crate) fn start() -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        let thread = std::thread::spawn(move || {
            let mut all: BTreeMap<u32, Seen> = BTreeMap::new();
            while !stopped.load(Ordering::Relaxed) {
                for (child, _) in children() {
                    look(child, all.entry(child).or_default());
                }
                std::thread::sleep(Duration::from_millis(2));
            }
            all
        });
        Self { stop, thread }
    }

    /// The most of each that one child had.
    pub(crate) fn end(self) -> Seen {
        self.stop.store(true, Ordering::Relaxed);
        let all = self.thread.join().expect("it watched");
        all.values().fold(Seen::default(), |most, seen| Seen {
            resident_kib: most.resident_kib.max(seen.resident_kib),
            addresses_kib: most.addresses_kib.max(seen.addresses_kib),
            bound: most.bound.max(seen.bound),
            files: most.files.or(seen.files),
        })
    }
}

fn look(child: u32, seen: &mut Seen) {
    let kib = |begin| line(child, "status", begin)?.trim().trim_end_matches(" kB").parse::<u64>().ok();
    let limit = |begin| line(child, "limits", begin)?.split_whitespace().next()?.parse::<u64>().ok();
    // Before it holds itself it is this program still, or the loader.
    let Some(bound) = limit("Max address space") else { return };
    seen.bound = bound;
    seen.files = limit("Max open files");
    seen.resident_kib = seen.resident_kib.max(kib("VmHWM:").unwrap_or(0));
    seen.addresses_kib = seen.addresses_kib.max(kib("VmPeak:").unwrap_or(0));
}
