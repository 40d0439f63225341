//! What stands beside its target until it is whole, and goes away when the program is told to end.
//!
//! Invariant: whatever a signal interrupts, nothing that was made here is left behind;
//! who ended the program sees it end by that signal. For this, whoever puts something into a directory made
//! here, or takes it away, does so [undisturbed]: a directory that changes meanwhile cannot be removed.
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock, RwLockWriteGuard};

/// What there is now.
static MADE: RwLock<Vec<PathBuf>> = RwLock::new(Vec::new());

fn made() -> RwLockWriteGuard<'static, Vec<PathBuf>> {
    MADE.write().unwrap_or_else(PoisonError::into_inner)
}

/// Something that goes away at a signal, as long as this lives.
#[derive(Debug)]
pub(super) struct Leftover(PathBuf);

impl Drop for Leftover {
    fn drop(&mut self) {
        made().retain(|path| *path != self.0);
    }
}

/// Makes something that is to go away at a signal.
pub(super) fn make<T>(
    make: impl FnOnce() -> io::Result<T>,
    path: impl FnOnce(&T) -> &Path,
) -> io::Result<(Leftover, T)> {
    listen();
    // A signal waits until it is known what was made.
    let mut all = made();
    let own = make()?;
    let path = path(&own).to_owned();
    all.push(path.clone());
    Ok((Leftover(path), own))
}

/// Does something that no signal may interrupt; several threads may do so at a time.
/// Nothing is [made](make) in it.
pub(super) fn undisturbed<T>(act: impl FnOnce() -> T) -> T {
    let _waiting = MADE.read().unwrap_or_else(PoisonError::into_inner);
    act()
}

#[cfg(unix)]
fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use std::{fs, thread};

    static LISTENING: std::sync::Once = std::sync::Once::new();
    LISTENING.call_once(|| {
        let ignored = ignored();
        let heard = [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let Ok(mut signals) = Signals::new(heard) else { return };
        thread::spawn(move || {
            for signal in signals.forever() {
                let all = made();
                for path in all.iter() {
                    // What cannot be taken away stays; there is nobody left to tell.
                    let _ = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
                }
                // It ends here, before anything else is made.
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            }
        });
    });
}

/// Signals that whoever started the program wants it to pass over, a bit each; none where that cannot be known.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default()
}

#[cfg(not(unix))]
fn listen() {}
