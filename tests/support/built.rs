//! The data that the program carries, read once for a test program.
#![allow(dead_code, reason = "not every test program asks for everything")]
use std::sync::{LazyLock, OnceLock};

use ciklo::base::data::{self, Files};
use ciklo::language::locale::Locales;
use ciklo::spec::Catalogue;

/// Files, catalogue and texts; mistakes in them are looked for elsewhere.
pub(crate) struct Built {
    pub(crate) files: Files,
    pub(crate) catalogue: Catalogue,
    /// Read when they are asked for.
    pub(crate) locales: LazyLock<Locales>,
}

pub(crate) fn built() -> &'static Built {
    static BUILT: OnceLock<Built> = OnceLock::new();
    BUILT.get_or_init(|| {
        let files = data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        let locales = || Locales::load(built().files.iter().map(|(path, text)| (path, text))).0;
        Built { files, catalogue, locales: LazyLock::new(locales) }
    })
}
