//! The programs next to one that is executed.
//!
//! Invariant: a file is read when the run calls it and not before; what is never called may be whatever it is.
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::program::PROGRAMS;
use super::{Failure, program};
use crate::engine::run::{Programs, program_key};
use crate::program::syntax::Program;
use crate::spec::Catalogue;
use crate::system;

/// A file, and the program in it once it was called.
struct Neighbour {
    path: PathBuf,
    read: OnceCell<Option<program::Understood>>,
}

/// The programs in the folder of another one.
pub(super) struct Neighbours<'c> {
    path: PathBuf,
    catalogue: &'c Catalogue,
    /// By the key that calls them.
    files: OnceCell<BTreeMap<String, Neighbour>>,
    /// Why something that was called could not be read.
    failed: RefCell<Option<Failure>>,
}

impl<'c> Neighbours<'c> {
    /// Those of the program at a path.
    pub(super) fn new(path: &Path, catalogue: &'c Catalogue) -> Self {
        Self { path: path.to_owned(), catalogue, files: OnceCell::new(), failed: RefCell::default() }
    }

    /// Whether all that was called could be read.
    pub(super) fn readable(&self) -> Result<(), Failure> {
        self.failed.take().map_or(Ok(()), Err)
    }

    fn files(&self) -> BTreeMap<String, Neighbour> {
        let mut files = BTreeMap::new();
        for extension in PROGRAMS {
            match system::beside(&self.path, extension) {
                Ok(paths) => files.extend(paths.into_iter().filter_map(|path| {
                    let key = program_key(&path.file_name()?.to_string_lossy());
                    Some((key, Neighbour { path, read: OnceCell::new() }))
                })),
                Err(trouble) => self.fail(trouble.into()),
            }
        }
        files
    }

    fn fail(&self, failure: Failure) {
        self.failed.borrow_mut().get_or_insert(failure);
    }
}

impl Programs for Neighbours<'_> {
    fn program(&self, key: &str) -> Option<&Program> {
        let neighbour = self.files.get_or_init(|| self.files()).get(key)?;
        let read = || program::understand(&neighbour.path, self.catalogue).map_err(|failure| self.fail(failure)).ok();
        neighbour.read.get_or_init(read).as_ref().map(|file| &file.program)
    }
}
