//! What all pages of a control in a language share: words, contents and links.
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};

use minijinja::Value;
use minijinja::value::Serde;

use crate::diag::Diagnostic;
use crate::locale::{Args, Language, LocaleError, Scope};
use crate::spec::{Cycle, CycleKey, Keyword, OnControl};

/// The prefixes of messages that are words without arguments.
const WORDS: [&str; 4] = ["site-", "caption-", "reference-", "optional-"];

/// A control in a language.
pub(super) struct Section<'a> {
    pub(super) on: &'a OnControl,
    pub(super) language: &'a Language,
    /// The name of the language in itself.
    pub(super) language_name: String,
    /// The words of the site, for templates.
    pub(super) words: Value,
    /// The cycles by key.
    pub(super) entries: Vec<Entry<'a>>,
    by_key: HashMap<CycleKey, usize>,
}

/// A page of a cycle.
pub(super) struct Entry<'a> {
    pub(super) cycle: &'a Cycle,
    pub(super) name: String,
    /// The file name of its page.
    pub(super) file: String,
}

impl<'a> Section<'a> {
    pub(super) fn new(
        on: &'a OnControl,
        language: &'a Language,
        source: Option<&Language>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut faults = Vec::new();
        let words = words(language, source, &mut faults);
        let mut entries = Vec::new();
        for cycle in on.cycles.values() {
            let scope = Scope::new(cycle.name(), on.id());
            match language.plain(&format!("cycle-{}", cycle.name()), &scope) {
                Ok(name) => entries.push(Entry { cycle, name: name.into_owned(), file: file_of(cycle.key) }),
                Err(error) => faults.push(of_cycle(error, cycle)),
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let by_key = entries.iter().enumerate().map(|(at, entry)| (entry.cycle.key, at)).collect();
        let language_name = words.get("language_name").cloned().unwrap_or_default();
        Ok(Self { on, language, language_name, words: Value::from(Serde(&words)), entries, by_key })
    }

    /// The path of a file of this section.
    pub(super) fn path(&self, file: &str) -> String {
        format!("{}/{}/{file}", self.on.id(), self.language.tag())
    }

    pub(super) fn entry(&self, key: CycleKey) -> Option<&Entry<'a>> {
        self.by_key.get(&key).and_then(|at| self.entries.get(*at))
    }

    /// A text with arguments that belongs to no cycle.
    pub(super) fn text(&self, key: &str, args: &Args) -> Result<Cow<'_, str>, Vec<Diagnostic>> {
        self.language.text(key, &Scope::control(self.on.id()), args).map_err(|error| vec![error.into()])
    }
}

fn of_cycle(error: LocaleError, cycle: &Cycle) -> Diagnostic {
    let mut diagnostic = Diagnostic::from(error);
    diagnostic.place.get_or_insert_with(|| cycle.file.name.place.clone());
    diagnostic
}

/// All words, by their ids as templates write them: `site-by-name` is `words.by_name`, and
/// `caption-unit` is `words.caption_unit`. Every language must have those of the source language.
fn words(language: &Language, source: Option<&Language>, faults: &mut Vec<Diagnostic>) -> BTreeMap<String, String> {
    let ids = source.unwrap_or(language).ids().filter(|id| WORDS.iter().any(|prefix| id.starts_with(prefix)));
    let mut words = BTreeMap::new();
    for id in ids {
        match language.plain(id, &Scope::NONE) {
            Ok(word) => {
                words.insert(id.strip_prefix(WORDS[0]).unwrap_or(id).replace('-', "_"), word.into_owned());
            }
            Err(error) => faults.push(error.into()),
        }
    }
    words
}

/// The file name of the page of a cycle: `tch-probe-412.html`.
pub(super) fn file_of(key: CycleKey) -> String {
    format!("{}-{}.html", key.keyword.as_str().to_lowercase().replace(' ', "-"), key.number)
}

/// The cycle that a link such as `cycle:TCH-PROBE-412` means.
pub(super) fn link_target(link: &str) -> Option<CycleKey> {
    let (keyword, number) = link.strip_prefix("cycle:")?.rsplit_once('-')?;
    Some(CycleKey::new(Keyword::by_word(&keyword.replace('-', " "))?, number.parse().ok()?))
}
