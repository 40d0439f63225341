//! How far the translations of a language are: counts by file and control, and the texts that are open.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use serde::Serialize;

use crate::base::diag::{Arg, Place};
use crate::language::locale::{Finding, LocaleError, Locales, Meanings, SourceText};
use crate::language::{consistency, label};
use crate::spec::{self, Catalogue, Cycle, OnControl};

/// Findings about texts that are longer than a control takes.
const TOO_LONG: [&str; 2] = ["label-too-long", "prompt-too-long"];

/// Why a text is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// There is none.
    Missing,
    /// Its source, or what the specifications mean by it, has changed.
    Stale,
    /// It was never accepted.
    Unaccepted,
    /// It has the words of the source.
    SameAsSource,
}

/// So many texts of a file, a control or a language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub struct Count {
    /// Texts of the source language.
    pub texts: usize,
    /// Those with a translation that is accepted and up to date.
    pub translated: usize,
    /// Those without a translation.
    pub missing: usize,
    /// Those whose source has changed since they were accepted.
    pub stale: usize,
    /// Those that were never accepted, or have got the words of another text since.
    pub unaccepted: usize,
    /// Those with the words of the source.
    pub same_as_source: usize,
    /// Labels, names and prompts that are longer than a control takes.
    pub over_long: usize,
    /// Words of the source texts that are missing or stale, or that the translation has as they are.
    pub words_to_do: usize,
}

impl Count {
    fn add(&mut self, state: State, words: usize) {
        match state {
            State::Missing => self.missing += 1,
            State::Stale => self.stale += 1,
            State::Unaccepted => self.unaccepted += 1,
            State::SameAsSource => self.same_as_source += 1,
        }
        if state != State::Unaccepted {
            self.words_to_do += words;
        }
    }

    fn settle(mut self) -> Self {
        self.translated = self.texts.saturating_sub(self.missing + self.stale + self.unaccepted);
        self
    }
}

/// A text that is open.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub struct Open {
    /// Its key.
    pub key: String,
    /// Why.
    pub state: State,
    /// The file of the translation, where it is or belongs, below the folder of the language.
    pub file: String,
    /// The line there; of a missing text, that of the source text.
    pub line: usize,
    /// What changed in the source text, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub change: Option<String>,
}

/// How far one language is.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub struct LanguageStatus {
    /// Its tag.
    pub language: String,
    /// All of it.
    pub total: Count,
    /// By file, below the folder of the language.
    pub files: BTreeMap<String, Count>,
    /// The texts of the cycles of a control.
    pub controls: BTreeMap<String, Count>,
    /// The texts of the cycles of a group, on any control.
    pub groups: BTreeMap<String, Count>,
    /// What is open, in the order of files and lines.
    pub open: Vec<Open>,
}

/// How far a language is.
///
/// # Errors
/// If the language or the source language was not loaded.
pub fn status(
    catalogue: &Catalogue,
    locales: &Locales,
    meanings: &Meanings,
    tag: &str,
) -> Result<LanguageStatus, LocaleError> {
    let audit = locales.audit_with(tag, meanings)?;
    let sources = locales.sources()?;
    let lacking = lacking(locales, tag, &audit.missing);
    let of = |sources: &SourceText| file(&sources.place);
    let by_key: HashMap<&str, &SourceText> = sources.iter().map(|text| (text.key.as_str(), text)).collect();
    let by_id: HashMap<&str, &SourceText> = sources.iter().rev().map(|text| (text.id.as_str(), text)).collect();
    let mut files: BTreeMap<String, Count> = BTreeMap::new();
    for text in &sources {
        files.entry(of(text)).or_default().texts += 1;
    }
    let mut open = Vec::new();
    // What is stale is read anew, whatever else is said of it.
    let stale: BTreeSet<&str> = audit.stale.iter().map(|finding| finding.key.as_str()).collect();
    let besides = |all: &[Finding]| -> Vec<Finding> {
        all.iter().filter(|finding| !stale.contains(finding.key.as_str())).cloned().collect()
    };
    let (moved, same) = (besides(&audit.moved), besides(&audit.same));
    let lists = [
        (State::Missing, &audit.missing),
        (State::Missing, &lacking),
        (State::Stale, &audit.stale),
        (State::Unaccepted, &audit.unrecorded),
        (State::Unaccepted, &moved),
        (State::SameAsSource, &same),
    ];
    for (state, findings) in lists {
        for finding in findings.iter().filter(|finding| !finding.key.starts_with('-')) {
            let source = by_key.get(finding.key.as_str()).or_else(|| by_id.get(base(&finding.key)));
            let own = finding.place.as_ref().map_or_else(String::new, file);
            files.entry(source.map_or_else(|| own.clone(), |text| of(text))).or_default().add(state, words(source));
            open.push(entry(state, finding, own));
        }
    }
    open.sort_by(|a, b| (&a.file, a.line, &a.key, a.state).cmp(&(&b.file, b.line, &b.key, b.state)));
    let long = TooLong::of(catalogue, locales, tag);
    for (file, _) in &long.places {
        files.entry(file.clone()).or_default().over_long += 1;
    }
    let total = files.values().fold(Count::default(), |sum, count| Count {
        texts: sum.texts + count.texts,
        translated: 0,
        missing: sum.missing + count.missing,
        stale: sum.stale + count.stale,
        unaccepted: sum.unaccepted + count.unaccepted,
        same_as_source: sum.same_as_source + count.same_as_source,
        over_long: sum.over_long + count.over_long,
        words_to_do: sum.words_to_do + count.words_to_do,
    });
    let (mut controls, mut groups) = (by_control(catalogue, &sources, &open), by_group(catalogue, &sources, &open));
    for (control, ..) in &long.controls {
        controls.entry(control.clone()).or_default().over_long += 1;
    }
    for (group, ..) in &long.groups {
        groups.entry(group.clone()).or_default().over_long += 1;
    }
    let files = files.into_iter().map(|(file, count)| (file, count.settle())).collect();
    Ok(LanguageStatus { language: tag.to_owned(), total: total.settle(), files, controls, groups, open })
}

/// The labels that are longer than a control takes, each once: by its place, for each control and for each group.
#[derive(Default)]
struct TooLong {
    places: BTreeSet<(String, usize)>,
    controls: BTreeSet<(String, String, usize)>,
    groups: BTreeSet<(String, String, usize)>,
}

impl TooLong {
    fn of(catalogue: &Catalogue, locales: &Locales, tag: &str) -> Self {
        let mut all = Self::default();
        let prefix = format!("locales/{tag}/");
        for found in label::check(catalogue, locales).iter().filter(|found| TOO_LONG.contains(&found.code)) {
            let Some(place) = found.place.as_ref().filter(|place| place.source.name().starts_with(&prefix)) else {
                continue;
            };
            let (file, at) = (file(place), place.span.start);
            all.places.insert((file.clone(), at));
            let Some(Arg::Text(control)) = found.get("control") else { continue };
            all.controls.insert((control.clone(), file.clone(), at));
            let cycles = catalogue.controls.get(control).into_iter().flat_map(|on| on.cycles.values());
            let is_own =
                |cycle: &&Cycle| matches!(found.get("cycle"), Some(Arg::Text(key)) if *key == cycle.key.to_string());
            let groups = cycles.filter(is_own).map(|cycle| cycle.file.group.as_str().to_owned());
            all.groups.extend(groups.map(|group| (group, file.clone(), at)));
        }
        all
    }
}

/// Variants of source texts for which the language has only a text with other facts.
fn lacking(locales: &Locales, tag: &str, missing: &[Finding]) -> Vec<Finding> {
    let known: BTreeSet<&str> = missing.iter().map(|finding| finding.key.as_str()).collect();
    let lacks = consistency::lacking(locales, tag).into_iter().filter(|(key, ..)| !known.contains(key.as_str()));
    lacks.map(|(key, _, place)| Finding { key, place: Some(place), argument: None, change: None }).collect()
}

/// The texts that the cycles of each control need.
fn by_control(catalogue: &Catalogue, sources: &[SourceText], open: &[Open]) -> BTreeMap<String, Count> {
    let used = |on: &OnControl| -> BTreeSet<String> {
        on.cycles.values().flat_map(|cycle| spec::texts(cycle, on)).map(|text| text.id).collect()
    };
    catalogue.controls.iter().map(|(name, on)| (name.clone(), of_used(&used(on), sources, open))).collect()
}

/// The texts that the cycles of each group need.
fn by_group(catalogue: &Catalogue, sources: &[SourceText], open: &[Open]) -> BTreeMap<String, Count> {
    let mut used: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let own = used.entry(cycle.file.group.as_str().to_owned()).or_default();
            own.extend(spec::texts(cycle, on).into_iter().map(|text| text.id));
        }
    }
    used.into_iter().map(|(group, used)| (group, of_used(&used, sources, open))).collect()
}

/// The counts of the messages that are used.
fn of_used(used: &BTreeSet<String>, sources: &[SourceText], open: &[Open]) -> Count {
    let mut count = Count::default();
    let mut words_of = HashMap::new();
    for text in sources.iter().filter(|text| used.contains(&text.id)) {
        count.texts += 1;
        words_of.insert(text.key.as_str(), words(Some(&text)));
    }
    for text in open.iter().filter(|text| used.contains(base(&text.key))) {
        count.add(text.state, words_of.get(text.key.as_str()).copied().unwrap_or_default());
    }
    count.settle()
}

fn entry(state: State, finding: &Finding, file: String) -> Open {
    let line = finding.place.as_ref().map_or(0, |place| place.start().line);
    Open { key: finding.key.clone(), state, file, line, change: finding.change.clone() }
}

/// The file of a place below the folder of its language.
fn file(place: &Place) -> String {
    place.source.name().splitn(3, '/').nth(2).unwrap_or_default().to_owned()
}

/// A key without suffixes and attribute.
fn base(key: &str) -> &str {
    let id = key.split('.').next().unwrap_or_default();
    id.split_once("__").map_or(id, |(base, _)| base)
}

/// How many words a source text has that someone translates.
fn words(source: Option<&&SourceText>) -> usize {
    let has_letter = |word: &&str| word.chars().any(char::is_alphabetic) && !word.contains(['{', '$', '"']);
    source.map_or(0, |source| source.text.split_whitespace().filter(has_letter).count())
}
