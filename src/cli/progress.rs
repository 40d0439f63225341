//! How far long work has come, on standard error if that is a terminal.
//!
//! Invariant: nothing is written where it could end up in a file, and nothing stays on the screen.
use std::io::{self, Write as _};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::system;

/// How often the line is written anew.
const PAUSE: Duration = Duration::from_millis(100);

/// A count that several threads add to.
pub(super) struct Progress {
    word: String,
    total: usize,
    done: AtomicUsize,
    shown: Option<Mutex<Instant>>,
}

impl Progress {
    /// `word` says what is counted up to `total`.
    pub(super) fn new(word: String, total: usize) -> Self {
        let shown = system::shows_progress().then(|| Mutex::new(Instant::now()));
        Self { word, total, done: AtomicUsize::new(0), shown }
    }

    /// One more is done.
    pub(super) fn step(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        // Whoever finds the line busy leaves it to the next one.
        let Some(Ok(mut last)) = self.shown.as_ref().map(Mutex::try_lock) else { return };
        if last.elapsed() >= PAUSE {
            *last = Instant::now();
            let _ = write!(io::stderr(), "\r{} {}/{}\u{1b}[K", self.word, done.min(self.total), self.total);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown.is_some() {
            let _ = write!(io::stderr(), "\r\u{1b}[K");
        }
    }
}
