//! The outside world: files, the environment and the terminal.
//!
//! Invariant: nothing half-written is ever found under the name that was asked for. A file is written
//! next to its target and renamed; a directory is filled next to its target and exchanged when whole. Nothing of that is
//! left behind, nor a program that was started, also when a signal ends this one.
mod answering;
mod folders;
mod leftover;
mod replace;
mod serving;
mod staged;

use std::ffi::OsString;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{env, fs};

use crate::base::diag::Diagnostic;

pub use answering::{Answering, LONGEST_LINE, NoAnswer, line_of, next_line};
pub use folders::{Below, Folder, beside, files_below, nearest, seen_from, spelled};
pub use replace::{Seen, write, write_all, write_parts};
pub use serving::{Asked, Server, Status};
pub use staged::Staged;

/// So many bytes are read from standard input, a pipe or a device.
const MOST_OF_A_STREAM: u64 = 1 << 30;
/// How deep directories with data may be.
const DEEPEST: usize = 16;

/// Something outside that failed.
#[derive(Debug)]
pub struct Trouble {
    code: &'static str,
    path: PathBuf,
    reason: &'static str,
    detail: String,
}

impl Trouble {
    fn new(code: &'static str, path: &Path, error: &io::Error) -> Self {
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "not-found",
            io::ErrorKind::PermissionDenied => "permission",
            io::ErrorKind::IsADirectory => "is-directory",
            io::ErrorKind::NotADirectory => "not-directory",
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "full",
            io::ErrorKind::ReadOnlyFilesystem => "read-only",
            io::ErrorKind::FileTooLarge => "too-large",
            _ => "other",
        };
        Self { code, path: path.to_owned(), reason, detail: error.to_string() }
    }
}

impl From<Trouble> for Diagnostic {
    fn from(trouble: Trouble) -> Self {
        Self::global(trouble.code)
            .arg("path", trouble.path.display().to_string())
            .arg("reason", trouble.reason)
            .arg("detail", trouble.detail)
    }
}

/// Makes a limit of the system on the size of files an error like others instead of the end of the program.
pub fn outlive_limits() {
    leftover::outlive_limits();
}

/// The words of the command line, the program's name first.
pub fn arguments() -> impl Iterator<Item = OsString> {
    env::args_os()
}

/// A variable of the environment; nothing if it is not set or not text.
#[expect(clippy::disallowed_methods, reason = "this is the place to ask")]
pub fn variable(name: &str) -> Option<String> {
    env::var(name).ok()
}

/// Whether progress can be shown: standard error is a terminal.
pub fn shows_progress() -> bool {
    io::stderr().is_terminal()
}

/// Whether standard output and standard error take colours.
pub fn colours() -> (bool, bool) {
    let never = anstream::ColorChoice::Never;
    (
        anstream::AutoStream::choice(&io::stdout()) != never && io::stdout().is_terminal(),
        anstream::AutoStream::choice(&io::stderr()) != never && io::stderr().is_terminal(),
    )
}

/// What to say if standard output does not take any more.
pub fn stdout_trouble(error: &io::Error) -> Trouble {
    Trouble::new("io-write", Path::new("-"), error)
}

/// The bytes of a file; of standard input for `-`. Of a pipe or a device not more than [`MOST_OF_A_STREAM`] are read, for
/// it may have no end.
///
/// # Errors
/// `io-read` if it cannot be read or has no end.
pub fn read(path: &Path) -> Result<Vec<u8>, Trouble> {
    let read = if path == Path::new("-") {
        read_stream(io::stdin().lock())
    } else if is_no_file(path) && !path.is_dir() {
        fs::File::open(path).and_then(read_stream)
    } else {
        fs::read(path)
    };
    read.map_err(|error| Trouble::new("io-read", path, &error))
}

/// The bytes of something that may have no end.
fn read_stream(stream: impl io::Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::Read::read_to_end(&mut io::Read::take(stream, MOST_OF_A_STREAM + 1), &mut bytes)?;
    if bytes.len() as u64 > MOST_OF_A_STREAM { Err(io::ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
}

/// The bytes of a file that no one named: nothing else is read, as pipes may wait for ever and devices may have no end.
///
/// # Errors
/// `io-read` if it is no file or cannot be read.
pub fn read_file(path: &Path) -> Result<Vec<u8>, Trouble> {
    if is_no_file(path) {
        let error = if path.is_dir() { io::ErrorKind::IsADirectory.into() } else { not_regular() };
        return Err(Trouble::new("io-read", path, &error));
    }
    read(path)
}

/// Whether something is there that is no file.
pub fn is_no_file(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|known| !known.is_file())
}

/// How many bytes a file has, if that is known.
pub fn size(path: &Path) -> Option<u64> {
    fs::metadata(path).ok().map(|known| known.len())
}

fn not_regular() -> io::Error {
    io::Error::other("not a regular file")
}

/// All files below some directories in `root`, by path with `/`, in the order of paths. Hidden files
/// are passed over.
///
/// # Errors
/// `io-read` if `root` is no directory, or something in it cannot be read or is a link to a directory.
pub fn read_tree(root: &Path, tops: &[&str]) -> Result<Vec<(String, Vec<u8>)>, Trouble> {
    fs::read_dir(root).map_err(|error| Trouble::new("io-read", root, &error))?;
    let mut files = Vec::new();
    for top in tops {
        let path = root.join(top);
        if path.is_dir() {
            collect(&path, top, 0, &mut files)?;
        }
    }
    files.sort();
    Ok(files)
}

fn collect(directory: &Path, name: &str, depth: usize, files: &mut Vec<(String, Vec<u8>)>) -> Result<(), Trouble> {
    let trouble = |error: io::Error| Trouble::new("io-read", directory, &error);
    for entry in fs::read_dir(directory).map_err(trouble)? {
        let entry = entry.map_err(trouble)?;
        let own = entry.file_name().to_string_lossy().into_owned();
        let (path, name) = (entry.path(), format!("{name}/{own}"));
        if own.starts_with('.') {
            continue;
        }
        let known = fs::metadata(&path).map_err(|error| Trouble::new("io-read", &path, &error))?;
        // It could lead round in a circle, or through the whole disk.
        if known.is_dir() && entry.file_type().map_err(trouble)?.is_symlink() {
            return Err(Trouble { reason: "link", ..Trouble::new("io-read", &path, &not_regular()) });
        }
        if known.is_file() {
            files.push((name, read(&path)?));
        } else if !known.is_dir() {
            // A pipe would wait for ever.
            return Err(Trouble::new("io-read", &path, &not_regular()));
        } else if depth < DEEPEST {
            collect(&path, &name, depth + 1, files)?;
        }
    }
    Ok(())
}

/// The files and folders of a tree with their times and sizes.
pub type TreeState = Vec<(PathBuf, Option<SystemTime>, u64)>;

/// The state of the files of some directories in `root`: it is another one when a file has come, gone or changed. What cannot be
/// read is left out.
pub fn state_of_tree(root: &Path, tops: &[&str]) -> TreeState {
    let mut state = Vec::new();
    let mut waiting: Vec<(PathBuf, usize)> = tops.iter().map(|top| (root.join(top), 0)).collect();
    while let Some((directory, depth)) = waiting.pop() {
        for entry in fs::read_dir(&directory).into_iter().flatten().flatten() {
            let Ok(known) = entry.metadata() else { continue };
            if entry.file_name().to_string_lossy().starts_with('.') {
                continue;
            }
            if known.is_dir() && depth < DEEPEST {
                waiting.push((entry.path(), depth + 1));
            }
            state.push((entry.path(), known.modified().ok().filter(|_| known.is_file()), known.len()));
        }
    }
    state.sort();
    state
}

/// The names of the folders in this one, sorted; those that begin with a dot are not looked at.
///
/// # Errors
/// `io-read` if it cannot be read.
pub fn folders(path: &Path) -> Result<Vec<String>, Trouble> {
    let trouble = |error: io::Error| Trouble::new("io-read", path, &error);
    let mut names = Vec::new();
    for entry in fs::read_dir(path).map_err(trouble)? {
        let entry = entry.map_err(trouble)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.starts_with('.') && entry.file_type().map_err(trouble)?.is_dir() {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}

/// Where this program may keep what it can find out again: the place that the platform names for that.
pub fn cache_directory() -> Option<PathBuf> {
    let named = |name: &str| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let absolute = |path: &PathBuf| path.is_absolute();
    let base = if cfg!(windows) {
        named("LOCALAPPDATA")?
    } else if cfg!(target_os = "macos") {
        named("HOME")?.join("Library/Caches")
    } else {
        named("XDG_CACHE_HOME").filter(absolute).or_else(|| Some(named("HOME")?.join(".cache")))?
    };
    Some(base.join("ciklo")).filter(absolute)
}

/// Makes a directory, unless it is there.
///
/// # Errors
/// `io-write` if it cannot be made.
pub fn create_directory(path: &Path) -> Result<(), Trouble> {
    fs::create_dir_all(path).map_err(|error| Trouble::new("io-write", path, &error))
}

/// A file of that name in a directory; whatever in the name leads elsewhere is left out.
pub fn inside(directory: &Path, name: &str) -> PathBuf {
    let parts = name.split(['/', '\\']).filter(|part| !matches!(*part, "" | "." | ".."));
    directory.join(parts.collect::<PathBuf>())
}

fn parent(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}
