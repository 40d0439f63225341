//! The words and templates of logs, from the locale files and templates that the program works on.
//!
//! Invariant: the bridge between the engine, which knows no language, and the locales; nothing else.
use crate::base::diag::{Arg, Diagnostic};
use crate::engine::run::Texts;
use crate::language::locale::{Args, Language, Scope};

/// The folder of log templates.
const FOLDER: &str = "templates/logs/";
/// The message that is no text but the tag of the language.
const TAG: &str = "log-language";

/// Texts of logs in one language.
#[derive(Debug)]
pub struct LogTexts<'t> {
    language: &'t Language,
    control: &'t str,
    files: &'t [(String, String)],
}

impl<'t> LogTexts<'t> {
    /// Texts in that language for a control, with the templates among `files`.
    pub const fn new(language: &'t Language, control: &'t str, files: &'t [(String, String)]) -> Self {
        Self { language, control, files }
    }
}

impl Texts for LogTexts<'_> {
    fn message(&self, id: &str, args: &[(&str, Arg)]) -> Result<String, Diagnostic> {
        if id == TAG {
            return Ok(self.language.tag().to_owned());
        }
        let given = args.iter().fold(Args::new(), |all, (name, value)| match value {
            Arg::Text(text) => all.text(name, text.as_str()),
            Arg::Number(number) => all.number(name, *number),
        });
        let scope = Scope { cycle: None, control: Some(self.control) };
        match self.language.text(id, &scope, &given) {
            Ok(text) => Ok(text.into_owned()),
            Err(error) => Err(error.into()),
        }
    }

    fn template(&self, name: &str) -> Option<(String, String)> {
        template(self.files, name)
    }
}

/// The template of a log among the files of the data: the extension of what it writes, and its text.
pub fn template(files: &[(String, String)], name: &str) -> Option<(String, String)> {
    let matching = |(path, text): &(String, String)| {
        let (stem, extension) = path.strip_prefix(FOLDER)?.rsplit_once('.')?;
        (stem == name).then(|| (extension.to_owned(), text.clone()))
    };
    files.iter().find_map(matching)
}
