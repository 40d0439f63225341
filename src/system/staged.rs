//! Directories that are filled next to their targets and exchanged when they are whole.
//!
//! Invariant: at no moment is there neither the old directory nor the new one, and a file that was not written here is
//! never removed: the mark in the directory lists what was written, everything else is carried over.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{env, fs, io};

use super::leftover::Made;
use super::{Trouble, inside, leftover, parent};

/// Marks a directory as one that was written here: its first line is [`HEAD`], then the paths of the files follow.
const MARK: &str = ".ciklo-build";
const HEAD: &str = "ciklo build 2";

/// A directory in the making. Dropped before [`Staged::commit`], it leaves no trace.
#[derive(Debug)]
pub struct Staged {
    target: PathBuf,
    whole: PathBuf,
    old: PathBuf,
    /// Paths below the target, with `/`.
    written: Mutex<BTreeSet<String>>,
    /// Has both; there until this is dropped.
    scratch: Option<tempfile::TempDir>,
    /// Dropped last, when the directory is gone.
    _leftover: leftover::Leftover,
}

impl Drop for Staged {
    fn drop(&mut self) {
        let scratch = self.scratch.take();
        leftover::undisturbed(|| drop(scratch));
    }
}

impl Staged {
    /// Begins a directory that will become `target`; what was built there before stays until then.
    ///
    /// # Errors
    /// `io-foreign-directory` if something is there that was not written here; `io-write`.
    pub fn new(target: &Path) -> Result<Self, Trouble> {
        let trouble = |error: io::Error| Trouble::new("io-write", target, &error);
        let target = fs::canonicalize(target).unwrap_or_else(|_| target.to_owned());
        if !is_ours(&target).map_err(trouble)? {
            let error = io::Error::from(io::ErrorKind::AlreadyExists);
            return Err(Trouble::new("io-foreign-directory", &target, &error));
        }
        fs::create_dir_all(parent(&target)).map_err(trouble)?;
        leftover::clear(parent(&target));
        let temporary = || tempfile::Builder::new().prefix(leftover::PREFIX).tempdir_in(parent(&target));
        let (leftover, scratch) = leftover::make(temporary, |made| Made::at(made.path())).map_err(trouble)?;
        let [whole, old] = ["new", "old"].map(|name| scratch.path().join(name));
        let written = Mutex::default();
        let staged = Self { target: target.clone(), whole, old, written, scratch: Some(scratch), _leftover: leftover };
        leftover::undisturbed(|| fs::create_dir(&staged.whole)).map_err(trouble)?;
        Ok(staged)
    }

    /// Writes a file of the directory; `path` has `/` and stays inside.
    ///
    /// # Errors
    /// `io-write` if it cannot be written.
    pub fn write(&self, path: &str, bytes: &[u8]) -> Result<(), Trouble> {
        let file = inside(&self.whole, path);
        let write = || {
            fs::write(&file, bytes).or_else(|error| match error.kind() {
                io::ErrorKind::NotFound => fs::create_dir_all(parent(&file)).and_then(|()| fs::write(&file, bytes)),
                _ => Err(error),
            })
        };
        let written = leftover::undisturbed(write);
        written.map_err(|error| Trouble::new("io-write", &inside(&self.target, path), &error))?;
        let below = file.strip_prefix(&self.whole).map(slashed).unwrap_or_default();
        self.written.lock().unwrap_or_else(PoisonError::into_inner).insert(below);
        Ok(())
    }

    /// Puts the directory in its place, in exchange for what was built there before. Files that were not written here
    /// and the permissions of the old directory are kept.
    ///
    /// # Errors
    /// `io-write` if it cannot be moved; the old one then remains in its place.
    pub fn commit(self) -> Result<(), Trouble> {
        let exchanged = leftover::undisturbed(|| {
            let written = self.written.lock().unwrap_or_else(PoisonError::into_inner);
            let mark: String =
                [HEAD].into_iter().chain(written.iter().map(String::as_str)).map(|it| format!("{it}\n")).collect();
            fs::write(self.whole.join(MARK), mark)?;
            if self.target.is_dir() {
                let own = listed(&self.target);
                carry_over(&self.target, &self.whole, "", &|path| own.contains(path))?;
                fs::set_permissions(&self.whole, fs::metadata(&self.target)?.permissions())?;
            }
            sync(&self.whole)?;
            self.exchange()?;
            sync(parent(&self.target))
        });
        exchanged.map_err(|error| Trouble::new("io-write", &self.target, &error))
    }

    fn exchange(&self) -> io::Result<()> {
        if env::current_dir().is_ok_and(|own| own.starts_with(&self.target)) {
            return self.exchange_entries();
        }
        if self.target.exists() {
            swap(&self.whole, &self.target, &self.old)
        } else {
            fs::rename(&self.whole, &self.target)
        }
    }

    /// As [`Self::exchange`] for the directory that the user is in, which must stay the same one: entry by entry.
    fn exchange_entries(&self) -> io::Result<()> {
        fs::create_dir(&self.old)?;
        let mut fresh = BTreeSet::new();
        for entry in fs::read_dir(&self.whole)? {
            let name = entry?.file_name();
            let (new, own) = (self.whole.join(&name), self.target.join(&name));
            match own.symlink_metadata() {
                Ok(_) => swap(&new, &own, &self.old.join(&name))?,
                Err(_) => fs::rename(&new, &own)?,
            }
            fresh.insert(name);
        }
        for entry in fs::read_dir(&self.target)? {
            let name = entry?.file_name();
            // What was not written here has been carried over and is among the new ones.
            if !fresh.contains(&name) {
                fs::rename(self.target.join(&name), self.old.join(&name))?;
            }
        }
        Ok(())
    }
}

/// A relative path with `/`.
fn slashed(path: &Path) -> String {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}

/// Whether a directory may be replaced: it is not there, it is empty, or it was written here.
fn is_ours(target: &Path) -> io::Result<bool> {
    match fs::read_dir(target) {
        Ok(mut entries) => Ok(target.join(MARK).is_file() || entries.next().is_none()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(true),
        Err(error) => Err(error),
    }
}

/// The files that the mark of a directory lists. An older mark has no list: every file is carried over then.
fn listed(target: &Path) -> BTreeSet<String> {
    let mark = fs::read_to_string(target.join(MARK)).unwrap_or_default();
    let mut lines = mark.lines();
    let own = lines.next() == Some(HEAD);
    lines.filter(|_| own).chain([MARK]).map(str::to_owned).collect()
}

/// Puts everything of the old directory that is not ours into the new one, unless a new file has its place.
fn carry_over(old: &Path, new: &Path, below: &str, is_ours: &dyn Fn(&str) -> bool) -> io::Result<()> {
    for entry in fs::read_dir(old)? {
        let entry = entry?;
        let path = format!("{below}{}", entry.file_name().to_string_lossy());
        let (from, to) = (entry.path(), new.join(entry.file_name()));
        if entry.file_type()?.is_dir() {
            let was_empty = fs::read_dir(&from)?.next().is_none();
            let is_new = fs::create_dir(&to).is_ok();
            if is_new {
                fs::set_permissions(&to, fs::metadata(&from)?.permissions())?;
            }
            carry_over(&from, &to, &format!("{path}/"), is_ours)?;
            if is_new && !was_empty {
                // Only if nothing was put into it.
                let _ = fs::remove_dir(&to);
            }
        } else if !is_ours(&path) && to.symlink_metadata().is_err() {
            keep(&from, &to)?;
        }
    }
    Ok(())
}

/// The same file under a second name, or a copy where the file system has no second names.
fn keep(from: &Path, to: &Path) -> io::Result<()> {
    fs::hard_link(from, to).or_else(|_| fs::copy(from, to).map(drop))
}

/// Exchanges two entries of a file system in one step. Where that is not known, the old one is put away first.
fn swap(new: &Path, target: &Path, old: &Path) -> io::Result<()> {
    if super::replace::exchange(new, target)? {
        return Ok(());
    }
    fs::rename(target, old)?;
    fs::rename(new, target).inspect_err(|_| {
        // The error is that of the exchange.
        let _ = fs::rename(old, target);
    })
}

/// Waits until everything of the file system that a directory is on has reached the disk.
#[cfg(any(target_os = "linux", target_os = "android"))]
fn sync(directory: &Path) -> io::Result<()> {
    Ok(rustix::fs::syncfs(fs::File::open(directory)?)?)
}

#[cfg(not(any(target_os = "linux", target_os = "android")))]
fn sync(_: &Path) -> io::Result<()> {
    Ok(())
}
