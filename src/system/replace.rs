//! Files that are rewritten in place.
//!
//! Invariant: a file is either the old one or whole, and stays the old one if it cannot be written, if it may not be
//! changed, or if someone else has changed it since it was read. What is written is next to it until then.
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::{fs, iter};

use sha2::{Digest as _, Sha256};

use super::leftover::Made;
use super::{Trouble, is_no_file, leftover, parent};

/// So many links are followed one after the other.
const MOST_LINKS: usize = 40;

/// What the bytes of a file come to.
type Digest = [u8; 32];

/// A file as it was read, which shows whether someone has changed it since.
#[derive(Debug)]
pub struct Seen {
    path: PathBuf,
    digest: Digest,
}

impl Seen {
    /// The file with the bytes that were read from it.
    pub fn of(path: &Path, bytes: &[u8]) -> Self {
        Self { path: path.to_owned(), digest: Sha256::digest(bytes).into() }
    }

    /// Whether a path leads to it, also through a link.
    fn is_at(&self, path: &Path) -> bool {
        // Standard input is no file, whatever is named like it.
        self.path != Path::new("-") && (self.path == path || is_same(&self.path, path))
    }

    /// Whether it is as it was.
    fn is_unchanged(&self, path: &Path) -> io::Result<bool> {
        // Whoever writes while it is read shows in the time.
        let stamp = || fs::metadata(path).map(|known| (known.len(), known.modified().ok()));
        let before = stamp()?;
        Ok(digest_of(path)? == self.digest && stamp()? == before)
    }
}

#[cfg(unix)]
fn is_same(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let number = |path| fs::metadata(path).ok().map(|known| (known.dev(), known.ino()));
    number(one).is_some_and(|own| number(other) == Some(own))
}

#[cfg(not(unix))]
fn is_same(one: &Path, other: &Path) -> bool {
    fs::canonicalize(one).is_ok_and(|own| fs::canonicalize(other).is_ok_and(|other| own == other))
}

/// The digest of a file's bytes, which are not kept.
fn digest_of(path: &Path) -> io::Result<Digest> {
    let mut digest = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    let mut file = fs::File::open(path)?;
    loop {
        match io::Read::read(&mut file, &mut buffer) {
            Ok(0) => return Ok(digest.finalize().into()),
            Ok(length) => digest.update(buffer.get(..length).unwrap_or_default()),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// Writes a file so that it is either the old one or whole.
///
/// # Errors
/// `io-write` if it cannot be written; the old file is then untouched.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Trouble> {
    write_parts(path, None, iter::once(bytes))
}

/// Writes a file in parts that follow one another. If they are made from a file that was read and this is it,
/// it must be as it was read until it is replaced.
///
/// # Errors
/// `io-write` if it cannot be written, `fix-file-changed` if someone has changed it; the old file is then untouched.
pub fn write_parts<'p>(path: &Path, from: Option<&Seen>, parts: impl Iterator<Item = &'p [u8]>) -> Result<(), Trouble> {
    let from = from.filter(|from| from.is_at(path));
    match write_beside(path, from, parts) {
        Ok(true) => Ok(()),
        Ok(false) => Err(Trouble::new("fix-file-changed", path, &io::Error::other("changed"))),
        Err(error) => Err(Trouble::new("io-write", path, &error)),
    }
}

fn put_parts<'p>(file: impl io::Write, mut parts: impl Iterator<Item = &'p [u8]>) -> io::Result<()> {
    let mut file = io::BufWriter::new(file);
    parts.try_for_each(|part| file.write_all(part))?;
    file.flush()
}

/// A new file next to the one whose place it will take.
struct Beside {
    target: PathBuf,
    file: tempfile::NamedTempFile,
    /// Whether there is an old one.
    known: bool,
    /// Dropped last, when the file is gone.
    _leftover: leftover::Leftover,
}

/// Writes several files so that either all of them are the new ones or none is.
///
/// # Errors
/// `io-write` with the first that cannot be written; all are then as they were, new ones are gone.
pub fn write_all(files: &[(PathBuf, &[u8])]) -> Result<(), Trouble> {
    let trouble = |path: &Path, error: &io::Error| Trouble::new("io-write", path, error);
    let mut ready = Vec::new();
    for (path, bytes) in files {
        let old = fs::read(path).ok();
        ready.push((beside(path, iter::once(*bytes)).map_err(|error| trouble(path, &error))?, old));
    }
    place_all(&ready).map_err(|(at, error)| trouble(files.get(at).map_or(Path::new(""), |(path, _)| path), &error))?;
    for (new, _) in &ready {
        sync_directory(parent(&new.target)).map_err(|error| trouble(&new.target, &error))?;
    }
    Ok(())
}

/// Puts the new files in their places; if one cannot be, those before it go back, and its number is reported.
fn place_all(ready: &[(Beside, Option<Vec<u8>>)]) -> Result<(), (usize, io::Error)> {
    leftover::undisturbed(|| {
        for (at, (new, _)) in ready.iter().enumerate() {
            let swapped = if new.known { exchange(new.file.path(), &new.target) } else { Ok(false) };
            let put = swapped.and_then(|swapped| match swapped {
                true => Ok(()),
                false => fs::rename(new.file.path(), &new.target),
            });
            if let Err(error) = put {
                ready.iter().take(at).rev().for_each(|(done, old)| done.take_back(old.as_deref()));
                return Err((at, error));
            }
        }
        Ok(())
    })
}

impl Beside {
    /// Puts the old file back.
    fn take_back(&self, old: Option<&[u8]>) {
        let is_old = |path: &Path| fs::read(path).ok().as_deref() == old;
        // There is no one left to report a second failure to: the first one is reported.
        let _ = match old {
            None => fs::remove_file(&self.target),
            Some(_) if is_old(&self.target) => Ok(()),
            Some(_) if is_old(self.file.path()) => exchange(self.file.path(), &self.target).map(|_| ()),
            Some(bytes) => fs::write(&self.target, bytes),
        };
    }
}

/// Whether the file was replaced; it is not if it is another one than was read.
fn write_beside<'p>(path: &Path, from: Option<&Seen>, parts: impl Iterator<Item = &'p [u8]>) -> io::Result<bool> {
    // A device such as /dev/stdout or a pipe cannot be replaced by renaming.
    if is_no_file(path) {
        return put_parts(fs::File::create(path)?, parts).map(|()| true);
    }
    let Beside { target, file, known, _leftover } = beside(path, parts)?;
    // Nothing that takes time comes between this and the exchange.
    if let Some(from) = from
        && !from.is_unchanged(&target)?
    {
        return Ok(false);
    }
    let replaced = match from {
        Some(from) if known => exchange_if_unchanged(file, &target, from)?,
        _ => file.persist(&target).map(|_| true).map_err(|error| error.error)?,
    };
    sync_directory(parent(&target))?;
    Ok(replaced)
}

/// Writes the new file next to the old one, whole and on the disk.
fn beside<'p>(path: &Path, parts: impl Iterator<Item = &'p [u8]>) -> io::Result<Beside> {
    let target = target(path)?;
    let known = fs::metadata(&target).ok();
    if known.is_some() {
        // Whoever may rename in a directory may not change every file in it.
        fs::OpenOptions::new().write(true).open(&target)?;
    }
    leftover::clear(parent(&target));
    let (leftover, mut file) = leftover::make(|| temporary(parent(&target)), |file| Made::at(file.path()))?;
    put_parts(&mut file, parts)?;
    if let Some(known) = &known {
        keep_owner(file.as_file(), known);
        file.as_file().set_permissions(known.permissions())?;
    }
    file.as_file().sync_all()?;
    Ok(Beside { target, file, known: known.is_some(), _leftover: leftover })
}

/// Puts the new file in the place of the old one, and back if the old one turns out to have changed in between.
fn exchange_if_unchanged(file: tempfile::NamedTempFile, target: &Path, from: &Seen) -> io::Result<bool> {
    if !exchange(file.path(), target)? {
        return file.persist(target).map(|_| true).map_err(|error| error.error);
    }
    // The old file has the name of the temporary one now, and goes away with it.
    let is_ours = digest_of(file.path()).is_ok_and(|digest| digest == from.digest);
    if !is_ours {
        exchange(file.path(), target)?;
    }
    Ok(is_ours)
}

/// Exchanges two names in one step; whether the system and the file system can do that.
#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
pub(super) fn exchange(one: &Path, other: &Path) -> io::Result<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    match renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(true),
        Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => Ok(false),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
pub(super) fn exchange(_: &Path, _: &Path) -> io::Result<bool> {
    Ok(false)
}

/// Waits until the names in a directory have reached the disk.
#[cfg(unix)]
fn sync_directory(directory: &Path) -> io::Result<()> {
    match fs::File::open(directory)?.sync_all() {
        // Some file systems cannot do that for directories.
        Err(error) if error.kind() == io::ErrorKind::InvalidInput => Ok(()),
        synced => synced,
    }
}

#[cfg(not(unix))]
fn sync_directory(_: &Path) -> io::Result<()> {
    Ok(())
}

/// The file that a path leads to; a link stays, and what it names is made if it is not there.
fn target(path: &Path) -> io::Result<PathBuf> {
    let missing = match fs::canonicalize(path) {
        Ok(target) => return Ok(target),
        Err(error) => error,
    };
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = parent(&target).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(missing)
}

/// Gives a new file to the owner of the old one, or at least to the group, as far as that is allowed.
#[cfg(unix)]
fn keep_owner(file: &fs::File, known: &fs::Metadata) {
    use std::os::unix::fs::{MetadataExt as _, fchown};
    let (user, group) = (known.uid(), known.gid());
    let is_kept = file.metadata().is_ok_and(|own| (own.uid(), own.gid()) == (user, group));
    if !is_kept && fchown(file, Some(user), Some(group)).is_err() {
        // Only the administrator may give files away.
        let _ = fchown(file, None, Some(group));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &fs::File, _: &fs::Metadata) {}

#[cfg(unix)]
fn temporary(directory: &Path) -> io::Result<tempfile::NamedTempFile> {
    use std::os::unix::fs::PermissionsExt as _;
    // Reduced by the user's mask, as for any new file.
    let permissions = fs::Permissions::from_mode(0o666);
    tempfile::Builder::new().prefix(leftover::PREFIX).permissions(permissions).tempfile_in(directory)
}

#[cfg(not(unix))]
fn temporary(directory: &Path) -> io::Result<tempfile::NamedTempFile> {
    tempfile::Builder::new().prefix(leftover::PREFIX).tempfile_in(directory)
}
