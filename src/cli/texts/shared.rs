//! What the parts of `ciklo texts` share: the texts, the working copy, tags of languages.
use std::path::{Path, PathBuf};

use crate::base::diag::Diagnostic;
use crate::cli::Failure;
use crate::cli::session::{self, Session};
use crate::language::consistency;
use crate::language::locale::{Locales, Meanings, SOURCE_LANGUAGE};
use crate::spec::Catalogue;

/// The texts and what the specifications mean by them; mistakes in them are for `ciklo lint`.
pub(super) struct Texts {
    pub(super) catalogue: Catalogue,
    pub(super) locales: Locales,
    pub(super) meanings: Meanings,
}

impl Texts {
    pub(super) fn of(files: &[(String, String)]) -> Self {
        let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
        let (catalogue, _) = Catalogue::load(files);
        let meanings = consistency::meanings(&catalogue);
        Self { catalogue, locales, meanings }
    }

    /// The translations asked for; all without a choice.
    pub(super) fn chosen(&self, asked: &[String]) -> Result<Vec<String>, Failure> {
        for tag in asked {
            self.locales.language(tag)?;
        }
        let tags = self.locales.tags().filter(|tag| *tag != SOURCE_LANGUAGE);
        Ok(tags.filter(|tag| asked.is_empty() || asked.iter().any(|own| own == tag)).map(str::to_owned).collect())
    }
}

/// The working copy in which something is written: that of `--data`, or the present directory if it is one.
pub(super) fn writable(session: &Session, option: &str) -> Result<PathBuf, Failure> {
    let here = Path::new(".");
    match session.data().or_else(|| session::is_working_copy(here).then_some(here)) {
        Some(root) => Ok(root.to_owned()),
        None => Err(Diagnostic::global("needs-data").arg("option", option).into()),
    }
}

/// A tag that can be the name of a folder of translations.
pub(in crate::cli) fn language(tag: &str) -> Result<String, Failure> {
    let is_tag = tag.len() > 1 && tag.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    if !is_tag || tag == SOURCE_LANGUAGE {
        return Err(Diagnostic::global("texts-no-language").arg("language", tag).into());
    }
    Ok(tag.to_owned())
}
