//! Which files there are: below a directory, next to a program, above it.
use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use super::{Trouble, parent};

/// What there is below a path.
#[derive(Debug, Default)]
pub struct Below {
    /// The files, in the order of paths.
    pub files: Vec<PathBuf>,
    /// What could not be looked into (`io-read`).
    pub troubles: Vec<Trouble>,
    /// What was passed over: what has one of the extensions and is no file (a pipe, a link that leads nowhere), and links
    /// to directories.
    pub passed_over: Vec<PathBuf>,
}

/// The file itself, or all files below a directory that have one of the extensions, in any case. Hidden files are passed
/// over, and links to directories are not followed; nor are those to files, unless `links` says so: what they name may
/// lie anywhere.
pub fn files_below(path: &Path, extensions: &[&str], links: bool) -> Below {
    if !path.is_dir() {
        return Below { files: vec![path.to_owned()], ..Below::default() };
    }
    let mut below = Below::default();
    let mut open = vec![path.to_owned()];
    while let Some(directory) = open.pop() {
        if let Err(error) = look_into(&directory, extensions, links, &mut below, &mut open) {
            below.troubles.push(Trouble::new("io-read", &directory, &error));
        }
    }
    below.files.sort();
    below.passed_over.sort();
    below
}

fn look_into(
    directory: &Path,
    extensions: &[&str],
    links: bool,
    below: &mut Below,
    open: &mut Vec<PathBuf>,
) -> io::Result<()> {
    for entry in fs::read_dir(directory)? {
        let entry = entry?;
        let own = entry.path();
        let wanted = || own.extension().is_some_and(|own| extensions.iter().any(|it| own.eq_ignore_ascii_case(it)));
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        let kind = entry.file_type()?;
        if kind.is_dir() {
            open.push(own);
        } else if kind.is_symlink() && own.is_dir() {
            below.passed_over.push(own);
        } else if wanted() {
            let taken = kind.is_file() || (links && kind.is_symlink() && own.is_file());
            (if taken { &mut below.files } else { &mut below.passed_over }).push(own);
        }
    }
    Ok(())
}

/// The nearest of that name in the directory of a path or above it.
pub fn nearest(path: &Path, name: &str) -> Option<PathBuf> {
    let whole = fs::canonicalize(path).or_else(|_| env::current_dir()).ok()?;
    // Also what cannot be read: the caller shall see that.
    whole.ancestors().map(|directory| directory.join(name)).find(|file| fs::symlink_metadata(file).is_ok())
}

/// The path of a file as seen from a directory, with `/`; as it is given if it lies elsewhere.
pub fn seen_from(directory: &Path, path: &Path) -> String {
    let whole = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let (own, root) = (whole(path), whole(directory));
    let relative = own.strip_prefix(root).map_or_else(|_| path.to_owned(), Path::to_path_buf);
    relative.to_string_lossy().replace('\\', "/")
}

/// The other files in the directory of a file that have an extension, in any case, by name. They are spelled as the
/// file is: without a directory if it has none.
///
/// # Errors
/// `io-read` if the directory cannot be read.
pub fn beside(path: &Path, extension: &str) -> Result<Vec<PathBuf>, Trouble> {
    let directory = parent(path);
    let entries = fs::read_dir(directory).map_err(|error| Trouble::new("io-read", directory, &error))?;
    let spelled = |name: OsString| path.with_file_name(name);
    let paths = entries.filter_map(|entry| entry.ok().map(|entry| spelled(entry.file_name())));
    let has = |other: &PathBuf| other.extension().is_some_and(|own| own.eq_ignore_ascii_case(extension));
    let mut paths: Vec<PathBuf> = paths.filter(|other| other != path && has(other) && other.is_file()).collect();
    paths.sort();
    Ok(paths)
}

/// The one spelling of a path, whatever way it is given: its directory without links and detours. The file itself
/// may be a link: what it names is next to the link. Standard input (`-`) stays what it is.
pub fn spelled(path: &Path) -> PathBuf {
    if path == Path::new("-") {
        return path.to_owned();
    }
    match (fs::canonicalize(parent(path)), path.file_name()) {
        (Ok(directory), Some(name)) => directory.join(name),
        _ => path.to_owned(),
    }
}

/// The files of a directory as they were when it was looked into, found by name.
#[derive(Debug)]
pub struct Folder {
    directory: PathBuf,
    /// By name in small letters, in the order of names.
    files: HashMap<String, Vec<OsString>>,
}

impl Folder {
    /// The files in a directory.
    ///
    /// # Errors
    /// `io-read` if the directory cannot be read.
    pub fn of(directory: &Path) -> Result<Self, Trouble> {
        let trouble = |error: io::Error| Trouble::new("io-read", directory, &error);
        let mut files: HashMap<String, Vec<OsString>> = HashMap::new();
        for entry in fs::read_dir(directory).map_err(trouble)?.flatten() {
            let is_file = match entry.file_type() {
                Ok(kind) if kind.is_symlink() => entry.path().is_file(),
                Ok(kind) => kind.is_file(),
                Err(_) => false,
            };
            if is_file {
                let name = entry.file_name();
                files.entry(name.to_string_lossy().to_ascii_lowercase()).or_default().push(name);
            }
        }
        files.values_mut().for_each(|names| names.sort());
        Ok(Self { directory: directory.to_owned(), files })
    }

    /// Whether there is a file with an extension, in any case.
    pub fn has_extension(&self, extension: &str) -> bool {
        let own = |name: &String| name.rsplit_once('.').map(|(_, own)| own.to_owned());
        self.files.keys().filter_map(own).any(|own| own.eq_ignore_ascii_case(extension))
    }

    /// The file of a name, in any case; the first one of several.
    pub fn file(&self, name: &str) -> Option<PathBuf> {
        self.files.get(&name.to_ascii_lowercase())?.first().map(|own| self.directory.join(own))
    }
}
