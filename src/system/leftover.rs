//! Files next to their targets until they are whole, programs that run for this one, and how both go away when the
//! program is asked to end.
//!
//! Invariant: whatever a signal interrupts, nothing that was made here is left behind;
//! the sender of the signal sees it end by that signal. For this, code that puts something into a directory made
//! here, or takes it away, does so [undisturbed]: a directory that changes meanwhile cannot be removed.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError, RwLock, RwLockWriteGuard};
use std::time::Duration;
use std::{fs, io};

/// What there is now.
static MADE: RwLock<Vec<Made>> = RwLock::new(Vec::new());

fn made() -> RwLockWriteGuard<'static, Vec<Made>> {
    MADE.write().unwrap_or_else(PoisonError::into_inner)
}

/// What goes away at a signal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Made {
    /// A file or directory.
    Path(PathBuf),
    /// The process that leads a group of its own, with all that belong to it.
    Group(u32),
}

impl Made {
    pub(super) fn at(path: &Path) -> Self {
        Self::Path(path.to_owned())
    }

    fn remove(&self) {
        // What cannot be taken away stays; there is no one left to report it to.
        let _ = match self {
            Self::Path(path) if path.is_dir() => fs::remove_dir_all(path),
            Self::Path(path) => fs::remove_file(path),
            Self::Group(leader) => kill_group(*leader),
        };
    }
}

/// Something that goes away at a signal, as long as this lives.
#[derive(Debug)]
pub(super) struct Leftover {
    made: Made,
    /// Open, so that other processes see that it is [held](hold).
    _held: Option<fs::File>,
}

impl Leftover {
    /// Makes it go away now.
    pub(super) fn end(self) {
        self.made.remove();
    }
}

impl Drop for Leftover {
    fn drop(&mut self) {
        made().retain(|own| *own != self.made);
    }
}

/// Makes something that is to go away at a signal.
pub(super) fn make<T>(
    make: impl FnOnce() -> io::Result<T>,
    what: impl FnOnce(&T) -> Made,
) -> io::Result<(Leftover, T)> {
    listen();
    // A signal waits until it is known what was made.
    let mut all = made();
    let own = make()?;
    let what = what(&own);
    all.push(what.clone());
    let held = match &what {
        Made::Path(path) => held(path),
        Made::Group(_) => None,
    };
    Ok((Leftover { made: what, _held: held }, own))
}

#[cfg(unix)]
fn held(path: &Path) -> Option<fs::File> {
    fs::File::open(path).ok().filter(hold)
}

#[cfg(not(unix))]
fn held(_: &Path) -> Option<fs::File> {
    None
}

/// Does something that no signal may interrupt; several threads may do so at a time.
/// Nothing is [made](make) in it.
pub(super) fn undisturbed<T>(act: impl FnOnce() -> T) -> T {
    let _waiting = MADE.read().unwrap_or_else(PoisonError::into_inner);
    act()
}

/// How names of files and directories in the making begin.
pub(super) const PREFIX: &str = ".ciklo-";
/// Younger ones may be in the making, although nobody holds them yet.
const YOUNG: Duration = Duration::from_secs(60);

/// Removes what runs of this program that were killed have left in a directory: names of the kind that is made here, not
/// held by any process, and older than a minute. What cannot be removed stays.
#[cfg(unix)]
pub(super) fn clear(directory: &Path) {
    static CLEARED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    // Once a directory is enough.
    if !CLEARED.lock().unwrap_or_else(PoisonError::into_inner).insert(directory.to_owned()) {
        return;
    }
    for entry in fs::read_dir(directory).into_iter().flatten().flatten() {
        if is_name_of_ours(&entry.file_name().to_string_lossy()) && is_abandoned(&entry.path()) {
            Made::Path(entry.path()).remove();
        }
    }
}

#[cfg(not(unix))]
pub(super) fn clear(_: &Path) {}

#[cfg(unix)]
fn is_name_of_ours(name: &str) -> bool {
    name.strip_prefix(PREFIX).is_some_and(|rest| rest.len() == 6 && rest.bytes().all(|it| it.is_ascii_alphanumeric()))
}

#[cfg(unix)]
fn is_abandoned(path: &Path) -> bool {
    let Ok(known) = fs::symlink_metadata(path) else { return false };
    let is_old = known.modified().is_ok_and(|time| time.elapsed().is_ok_and(|age| age > YOUNG));
    let kind = known.file_type();
    is_old && (kind.is_dir() || kind.is_file()) && fs::File::open(path).is_ok_and(|file| hold(&file))
}

/// Holds a file or directory in the making for as long as it is open; whether no other process does.
#[cfg(unix)]
fn hold(file: &fs::File) -> bool {
    rustix::fs::flock(file, rustix::fs::FlockOperation::NonBlockingLockExclusive).is_ok()
}

#[cfg(unix)]
fn kill_group(leader: u32) -> io::Result<()> {
    use rustix::process::{Pid, Signal, kill_process_group};
    let group = i32::try_from(leader).ok().and_then(Pid::from_raw).ok_or(io::ErrorKind::InvalidInput)?;
    Ok(kill_process_group(group, Signal::KILL)?)
}

/// Groups of processes are nothing that all systems have; the code that started the process ends it.
#[cfg(not(unix))]
fn kill_group(_: u32) -> io::Result<()> {
    Ok(())
}

/// Whatever a signal of the limit on the size of files does, writing fails then, and that is reported.
#[cfg(unix)]
pub(super) fn outlive_limits() {
    use signal_hook::consts::SIGXFSZ;
    // Where that is refused, the program ends as others do.
    let _ = signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default());
}

#[cfg(not(unix))]
pub(super) fn outlive_limits() {}

/// The signals by which a program is asked to end, and those that end it if it does not hear them.
#[cfg(unix)]
const HEARD: [i32; 8] = {
    use signal_hook::consts::{SIGALRM, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2};
    [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, signal_hook::consts::SIGXCPU]
};

#[cfg(unix)]
fn listen() {
    use signal_hook::iterator::Signals;
    use std::sync::mpsc;
    use std::thread;

    static LISTENING: std::sync::Once = std::sync::Once::new();
    LISTENING.call_once(|| {
        let ignored = ignored();
        let heard = HEARD.into_iter().filter(move |signal| !has(ignored, *signal));
        let (ready, listens) = mpsc::channel();
        // Signals are taken over by the thread that hears them: where there is none, they end the program.
        let listener = move || {
            let Ok(mut signals) = Signals::new(heard) else { return };
            let _ = ready.send(());
            for signal in signals.forever() {
                let all = made();
                all.iter().for_each(Made::remove);
                // It ends here, before anything else is made.
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            }
        };
        if thread::Builder::new().spawn(listener).is_ok() {
            let _ = listens.recv();
        }
    });
}

/// Whether the parent process wants a signal to be ignored.
#[cfg(unix)]
pub(super) fn is_ignored(signal: i32) -> bool {
    has(ignored(), signal)
}

#[cfg(unix)]
fn has(signals: u64, signal: i32) -> bool {
    signals >> (signal - 1) & 1 == 1
}

/// Signals that the parent process wants it to ignore, a bit each; none where that cannot be known.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default()
}

#[cfg(not(unix))]
fn listen() {}
