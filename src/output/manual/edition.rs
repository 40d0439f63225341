//! What all pages of a control in a language share: words, contents and links.
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::OnceLock;

use minijinja::Value;
use minijinja::value::Serde;

use super::links::Targets;
use super::{defined, for_control};
use crate::base::diag::{Diagnostic, Place};
use crate::language::locale::{Args, Language, LocaleError, Scope};
use crate::spec::{Cycle, CycleKey, Group, Keyword, Name, OnControl, Topic};

/// The prefixes of messages that are words without arguments.
const WORDS: [&str; 4] = ["site-", "caption-", "reference-", "optional-"];

/// A control in a language.
pub(super) struct Edition<'a> {
    pub(super) on: &'a OnControl,
    pub(super) language: &'a Language,
    /// The name of the language in itself.
    pub(super) language_name: String,
    /// The words of the site, for templates.
    pub(super) words: Value,
    /// The cycles by key.
    pub(super) entries: Vec<Entry<'a>>,
    /// The topics that its manual covers.
    pub(super) topics: Vec<TopicPage<'a>>,
    /// The terms of the glossary: ids without their prefix.
    pub(super) terms: Vec<&'a str>,
    /// What sentences can be linked with.
    pub(super) targets: Targets,
    by_key: HashMap<CycleKey, usize>,
    /// The cycles of each worked program.
    programs: OnceLock<Vec<BTreeSet<CycleKey>>>,
}

/// A page of a cycle.
pub(super) struct Entry<'a> {
    pub(super) cycle: &'a Cycle,
    pub(super) name: String,
    /// The file name of its page.
    pub(super) file: String,
}

/// A page of prose.
pub(super) struct TopicPage<'a> {
    pub(super) id: &'a str,
    pub(super) title: String,
    /// The file name of its page.
    pub(super) file: String,
    /// The groups of cycles that it is about.
    pub(super) groups: &'a [Group],
    /// The tables that it explains.
    pub(super) tables: &'a [Name],
    /// What is below the title, in Markdown: that of this control.
    pub(super) body: String,
}

/// The file of the list by Q parameter.
pub(super) const PARAMETERS: &str = "parameters.html";
/// The file of the glossary.
pub(super) const GLOSSARY: &str = "glossary.html";
/// The file of the overview.
pub(super) const OVERVIEW: &str = "index.html";

/// What the message of a term begins with.
pub(super) const TERM: &str = "term-";

impl<'a> Edition<'a> {
    /// The words, contents and links of a control in a language; `all` are the printed names of all controls by their ids.
    pub(super) fn new(
        topics: &'a [Topic],
        on: &'a OnControl,
        language: &'a Language,
        source: Option<&'a Language>,
        all: &BTreeMap<&str, &str>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut faults = Vec::new();
        let words = words(language, source).unwrap_or_else(|more| {
            faults.extend(more);
            BTreeMap::new()
        });
        let mut entries = Vec::new();
        for cycle in on.cycles.values() {
            let scope = Scope::new(cycle.name(), on.id());
            match language.plain(&format!("cycle-{}", cycle.name()), &scope) {
                Ok(name) => entries.push(Entry { cycle, name: name.into_owned(), file: file_of(cycle.key) }),
                Err(error) => faults.push(of_cycle(error, cycle)),
            }
        }
        let covers = |topic: &&Topic| topic.controls.iter().any(|own| own.control.as_str() == on.id());
        let covered: Vec<&Topic> = topics.iter().filter(covers).collect();
        let mut topics = Vec::new();
        for topic in &covered {
            match topic_page(topic, on, all, language) {
                Ok(page) => topics.push(page),
                Err(fault) => faults.push(fault),
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut terms: Vec<&str> = source.unwrap_or(language).ids().filter_map(|id| id.strip_prefix(TERM)).collect();
        terms.sort_unstable();
        let by_key = entries.iter().enumerate().map(|(at, entry)| (entry.cycle.key, at)).collect();
        let language_name = words.get("language_name").cloned().unwrap_or_default();
        let pages: Vec<_> = covered.iter().zip(&topics).map(|(topic, page)| (*topic, page.file.as_str())).collect();
        let targets = Targets::new(on, language, &pages, &terms);
        let words = Value::from(Serde(&words));
        Ok(Self {
            on,
            language,
            language_name,
            words,
            entries,
            topics,
            terms,
            targets,
            by_key,
            programs: OnceLock::new(),
        })
    }

    /// The path of a file of this edition.
    pub(super) fn path(&self, file: &str) -> String {
        format!("{}/{}/{file}", self.on.id(), self.language.tag())
    }

    pub(super) fn entry(&self, key: CycleKey) -> Option<&Entry<'a>> {
        self.by_key.get(&key).and_then(|at| self.entries.get(*at))
    }

    /// The cycles that each worked program defines, in the order of the programs.
    pub(super) fn cycles_of_programs(&self) -> &[BTreeSet<CycleKey>] {
        self.programs.get_or_init(|| self.on.worked.iter().map(defined::cycles).collect())
    }

    /// The title of a group.
    pub(super) fn group_title(&self, group: Group) -> Result<String, Vec<Diagnostic>> {
        Ok(self.text(&format!("cycle-group-{}", group.as_str()), &Args::new())?.into_owned())
    }

    /// A text with arguments that belongs to no cycle.
    pub(super) fn text(&self, key: &str, args: &Args) -> Result<Cow<'_, str>, Vec<Diagnostic>> {
        self.language.text(key, &Scope::control(self.on.id()), args).map_err(|error| vec![error.into()])
    }
}

/// The page of a topic: its first line is the title.
fn topic_page<'a>(
    topic: &'a Topic,
    on: &OnControl,
    all: &BTreeMap<&str, &str>,
    language: &'a Language,
) -> Result<TopicPage<'a>, Diagnostic> {
    let id = topic.topic.as_str();
    let lacking = |code, place| Diagnostic::error(code, place).arg("topic", id).arg("language", language.tag());
    let Some(page) = language.topic(id) else {
        return Err(lacking("manual-topic-missing", topic.topic.place.clone()));
    };
    let (first, body) = page.text().split_once('\n').unwrap_or((page.text(), ""));
    let Some(title) = first.strip_prefix("# ").map(str::trim).filter(|title| !title.is_empty()) else {
        return Err(lacking("manual-topic-title", Place::new(page, 0..first.len())));
    };
    let file = format!("topic-{id}.html");
    let titles = |own: bool| {
        let covered =
            topic.controls.iter().map(|covered| covered.control.as_str()).filter(move |id| (*id == on.id()) == own);
        covered.filter_map(|id| all.get(id)).flat_map(|title| for_control::names(title)).collect()
    };
    let names = for_control::Names { own: titles(true), others: titles(false) };
    Ok(TopicPage {
        id,
        title: title.to_owned(),
        file,
        groups: &topic.groups,
        tables: &topic.tables,
        body: for_control::keep(body, &names),
    })
}

fn of_cycle(error: LocaleError, cycle: &Cycle) -> Diagnostic {
    let mut diagnostic = Diagnostic::from(error);
    diagnostic.place.get_or_insert_with(|| cycle.file.name.place.clone());
    diagnostic
}

/// All words, by their ids as templates write them: `site-by-name` is `words.by_name`, and
/// `caption-unit` is `words.caption_unit`. Every language must have those of the source language.
pub(super) fn words(
    language: &Language,
    source: Option<&Language>,
) -> Result<BTreeMap<String, String>, Vec<Diagnostic>> {
    let ids = source.unwrap_or(language).ids().filter(|id| WORDS.iter().any(|prefix| id.starts_with(prefix)));
    let (mut words, mut faults) = (BTreeMap::new(), Vec::new());
    for id in ids {
        match language.plain(id, &Scope::NONE) {
            Ok(word) => {
                words.insert(id.strip_prefix(WORDS[0]).unwrap_or(id).replace('-', "_"), word.into_owned());
            }
            Err(error) => faults.push(error.into()),
        }
    }
    if faults.is_empty() { Ok(words) } else { Err(faults) }
}

/// The path of the page of a cycle on a control in a language, below the site.
pub fn path_of_cycle(control: &str, language: &str, key: CycleKey) -> String {
    format!("{control}/{language}/{}", file_of(key))
}

/// The path of the page of a topic, in the same way.
pub fn path_of_topic(control: &str, language: &str, topic: &str) -> String {
    format!("{control}/{language}/topic-{topic}.html")
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
