//! The program's own texts, in the language of its user.
//!
//! These are the only texts that fall back to the source language. Invariant: something readable
//! always comes out, even for a code that no file knows.
use std::fmt::Write as _;

use super::args::Args;
use super::error::LocaleError;
use super::language::{Language, Scope};
use super::number::Numbers;
use super::{Locales, SOURCE_LANGUAGE};
use crate::base::diag::{Arg, Diagnostic, Severity};

/// The language in which the program speaks.
#[derive(Clone, Copy, Debug)]
pub struct Ui<'l> {
    own: Option<&'l Language>,
    /// The same language as the program carries it, where `own` is that of a working copy.
    carried: Option<&'l Language>,
    fallback: Option<&'l Language>,
}

impl<'l> Ui<'l> {
    /// The language that was asked for; without one, that of the environment, given as the values of
    /// `LC_ALL`, `LC_MESSAGES` and `LANG` in this order; the source language if the environment names
    /// one that is not here.
    ///
    /// # Errors
    /// If a language was asked for and is not here.
    pub fn new(locales: &'l Locales, asked: Option<&str>, environment: &[Option<&str>]) -> Result<Self, LocaleError> {
        let fallback = locales.source();
        let own = match asked {
            Some(tag) => Some(locales.language(tag)?),
            None => {
                let set = environment.iter().flatten().find(|value| !value.is_empty());
                set.and_then(|value| locales.language(language_of(value)).ok()).or(fallback)
            }
        };
        Ok(Self { own, carried: None, fallback })
    }

    /// The texts of a working copy, where it has the language, before those that the program carries.
    ///
    /// # Errors
    /// If a language was asked for and neither has it.
    pub fn of_copy(
        copy: &'l Locales,
        carried: &'l Locales,
        asked: Option<&str>,
        environment: &[Option<&str>],
    ) -> Result<Self, LocaleError> {
        let inside = Self::new(carried, asked, environment);
        let Ok(own) = Self::new(copy, asked, environment) else { return inside };
        let fallback = carried.source();
        // What the environment names may be here and not there.
        let is_same = |other: &Self| own.own.is_none() || other.tag() == own.tag();
        let carried = inside.ok().filter(is_same).and_then(|ui| ui.own);
        Ok(Self { own: own.own.or(carried), carried, fallback })
    }

    /// The source language, whatever was asked for.
    pub fn source(locales: &'l Locales) -> Self {
        let fallback = locales.source();
        Self { own: fallback, carried: None, fallback }
    }

    /// The tag of the language.
    pub fn tag(&self) -> &'l str {
        self.own.map_or(SOURCE_LANGUAGE, Language::tag)
    }

    /// The way of writing numbers.
    pub fn numbers(&self) -> Numbers {
        self.own.map_or_else(Numbers::plain, |language| language.numbers().clone())
    }

    /// A text of the program; its key if no language has it.
    pub fn text(&self, key: &str, args: &Args) -> String {
        self.find(key, args).unwrap_or_else(|| key.to_owned())
    }

    /// The same, or nothing if no language has it.
    pub fn find(&self, key: &str, args: &Args) -> Option<String> {
        let mut texts = self.languages().map(|language| language.text(key, &Scope::NONE, args));
        texts.find_map(Result::ok).map(|text| text.into_owned())
    }

    /// All codes that some text explains: the messages with the prefix, without it, sorted.
    pub fn codes(&self, prefix: &str) -> Vec<&'l str> {
        let mut codes: Vec<&str> =
            self.languages().flat_map(Language::ids).filter_map(|id: &'l str| id.strip_prefix(prefix)).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }

    /// A text as it reads without arguments; its key if no language has it.
    pub fn sketch(&self, key: &str) -> String {
        self.languages().find_map(|language| language.sketch(key)).unwrap_or_else(|| key.to_owned())
    }

    /// The same with words in place of arguments, if words will do.
    pub fn filled(&self, key: &str, word: &dyn Fn(&str) -> String) -> Option<String> {
        self.languages().find_map(|language| language.filled(key, word))
    }

    /// In which languages a text is looked for, in this order.
    fn languages(&self) -> impl Iterator<Item = &'l Language> + use<'l> {
        [self.own, self.carried, self.fallback].into_iter().flatten()
    }

    /// The word for a severity.
    pub fn severity(&self, severity: Severity) -> String {
        self.text(&format!("severity-{}", severity.as_str()), &Args::new())
    }

    /// The text of a diagnostic: the message `diag-<code>` with its arguments, or the sentence that it
    /// brings along as its argument `message`. A code without either is named, with whatever arguments
    /// there are.
    pub fn diagnostic(&self, diagnostic: &Diagnostic) -> String {
        if let Some(Arg::Text(message)) = diagnostic.get("message") {
            return message.clone();
        }
        let args = Args::of(diagnostic);
        self.find(&format!("diag-{}", diagnostic.code), &args).unwrap_or_else(|| {
            let mut values = String::new();
            for (name, value) in &diagnostic.args {
                let _ = match value {
                    Arg::Text(text) => write!(values, " {name}={text}"),
                    Arg::Number(number) => write!(values, " {name}={number}"),
                };
            }
            let args = Args::new().text("code", diagnostic.code).text("values", values.as_str());
            self.find("diagnostic-without-text", &args).unwrap_or_else(|| format!("{}{values}", diagnostic.code))
        })
    }

    /// The caption of a place that belongs to a diagnostic: the message `related-<caption>`.
    pub fn caption(&self, caption: &str, diagnostic: &Diagnostic) -> String {
        self.text(&format!("related-{caption}"), &Args::of(diagnostic))
    }
}

/// The language in a value such as `fi_FI.UTF-8`; the source language for `C` and `POSIX`.
fn language_of(value: &str) -> &str {
    let language = value.split(['_', '.', '@', '-']).next().unwrap_or_default();
    if language == "C" || language == "POSIX" { SOURCE_LANGUAGE } else { language }
}
