//! The labels of a control's cycles in all languages, what else the checker keeps of a cycle, and the language of a
//! program.
//!
//! Invariant: a text that a language lacks matches nothing; labels are compared without regard to
//! case and blanks, as programs come from many hands.
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::definition::{Defined, Definition, Place};
use super::facts::Facts;
use super::flow::Deed;
use super::guards::{self, Ready};
use crate::language::locale::{Language, Locales};
use crate::language::text::{CycleText, Vocabulary};
use crate::program::syntax::CycleForm;
use crate::spec::{Catalogue, Cycle, CycleKey, Known, OnControl, Param, ParameterKind, Quantity, Shape};

/// The labels of a control, put together when a cycle is first asked for.
pub struct LabelBook<'a> {
    on: &'a OnControl,
    locales: &'a Locales,
    cycles: BTreeMap<CycleKey, Kept>,
    limits: OnceLock<Limits>,
    /// The cycles by their names.
    names: OnceLock<BTreeMap<String, Vec<CycleKey>>>,
    /// Labels of cycles that only other controls describe.
    elsewhere: Mutex<BTreeMap<CycleKey, Arc<CycleLabels>>>,
}

/// The greatest values that any manual prints for the parameters of cycles.
#[derive(Debug)]
pub(super) struct Limits {
    /// Of a spindle speed.
    pub(super) speed: Option<f64>,
    /// Of a feed in mm/min.
    pub(super) feed: Option<f64>,
}

/// What is kept of a cycle for all its definitions.
pub(super) struct Kept {
    /// Its place among the cycles of the control.
    place: usize,
    /// Whether words stand before values of its old form that are labels.
    labelled: bool,
    /// A bit for each kind that a parameter of it has.
    kinds: u32,
    labels: OnceLock<CycleLabels>,
    guards: OnceLock<Vec<Ready>>,
    ranges: OnceLock<BTreeMap<usize, Elsewhere>>,
    deed: OnceLock<Deed>,
}

/// The range that other controls' manuals print for a parameter.
#[derive(Debug)]
pub(super) struct Elsewhere {
    pub(super) least: f64,
    pub(super) greatest: f64,
    /// The title of one of those controls; nothing where the range is that of parameters like this one.
    pub(super) control: Option<String>,
}

/// The labels of a cycle in all languages, in the order of their tags.
#[derive(Debug)]
pub struct CycleLabels {
    /// The labels in each language.
    pub languages: Vec<LanguageLabels>,
}

/// The labels of a cycle in a language.
#[derive(Debug)]
pub struct LanguageLabels {
    /// The tag of the language.
    pub tag: String,
    /// The name in NC blocks and its printed variants.
    pub name: ParamLabels,
    /// The labels of the parameters, in the order of the cycle's.
    pub params: Vec<ParamLabels>,
}

/// A label with its variants.
#[derive(Debug, Default)]
pub struct ParamLabels {
    /// The label as it is printed; the printed word of an old-style field.
    pub label: Option<String>,
    /// It and its variants, folded.
    folded: Vec<String>,
}

impl ParamLabels {
    fn new(label: Option<String>, aliases: Vec<String>) -> Self {
        let label = label.filter(|label| !label.is_empty());
        let folded = label.iter().chain(&aliases).map(|label| fold(label).into_owned()).collect();
        Self { label, folded }
    }

    /// Whether a printed label is this one.
    pub fn matches(&self, printed: &str) -> bool {
        self.matches_folded(&fold(printed))
    }

    /// Whether a printed label is this one letter by letter, as [`fold`] leaves it.
    pub(super) fn is_exactly(&self, printed: &str) -> bool {
        self.folded.iter().any(|own| own == printed)
    }

    /// Whether one of its forms, as [`fold`] leaves them, is such.
    pub(super) fn any_folded(&self, is: impl Fn(&str) -> bool) -> bool {
        self.folded.iter().any(|own| is(own))
    }

    /// Whether a label made ready by [`fold`] is this one.
    pub(super) fn matches_folded(&self, printed: &str) -> bool {
        self.folded.iter().any(|own| own == printed)
    }
}

/// A label for comparison: capitals, single blanks, no colon at the end.
pub(super) fn fold(label: &str) -> Cow<'_, str> {
    if is_folded(label) { Cow::Borrowed(label) } else { Cow::Owned(folded(label)) }
}

/// Whether nothing has to change: most labels are printed in capitals, with single blanks.
fn is_folded(label: &str) -> bool {
    let mut before = b' ';
    for &byte in label.as_bytes() {
        if byte.is_ascii_lowercase() || byte.is_ascii_control() || (byte == b' ' && before == b' ') {
            return false;
        }
        before = byte;
    }
    !matches!(before, b' ' | b':')
        && (label.is_ascii() || label.chars().all(|c| c.is_ascii() || !(c.is_lowercase() || c.is_whitespace())))
}

fn folded(label: &str) -> String {
    let mut folded = String::with_capacity(label.len());
    for word in label.split_whitespace() {
        if !folded.is_empty() {
            folded.push(' ');
        }
        folded.push_str(word);
    }
    folded.truncate(folded.trim_end_matches(':').len());
    if folded.is_ascii() {
        folded.make_ascii_uppercase();
        return folded;
    }
    folded.to_uppercase()
}

impl<'a> LabelBook<'a> {
    /// The labels of a control in all languages that are loaded.
    pub fn new(on: &'a OnControl, locales: &'a Locales) -> Self {
        let kept = |(place, (key, cycle)): (usize, (&CycleKey, &Cycle))| (*key, Kept::of(place, cycle));
        let cycles = on.cycles.iter().enumerate().map(kept).collect();
        Self { on, locales, cycles, limits: OnceLock::new(), names: OnceLock::new(), elsewhere: Mutex::default() }
    }

    /// The tags of its languages, in the order in which cycles have them.
    pub(super) fn languages(&self) -> impl Iterator<Item = &str> {
        self.locales.iter().map(Language::tag)
    }

    /// The labels of a cycle; nothing if the control does not describe it.
    pub fn cycle(&self, key: CycleKey) -> Option<&CycleLabels> {
        let cycle = self.on.cycles.get(&key)?;
        Some(self.labels_of(cycle, self.cycles.get(&key)?))
    }

    /// What is kept of a cycle that the control describes.
    pub(super) fn kept(&self, key: CycleKey) -> Option<&Kept> {
        self.cycles.get(&key)
    }

    /// The labels of a cycle of which that is kept.
    pub(super) fn labels_of<'k>(&self, cycle: &Cycle, kept: &'k Kept) -> &'k CycleLabels {
        kept.labels.get_or_init(|| CycleLabels {
            languages: self.locales.iter().map(|language| labels(self.on, cycle, language)).collect(),
        })
    }

    /// The labels of a cycle that another control describes and this one does not.
    pub(super) fn labels_elsewhere(&self, on: &OnControl, cycle: &Cycle) -> Arc<CycleLabels> {
        let mut known = self.elsewhere.lock().unwrap_or_else(PoisonError::into_inner);
        let all = || self.locales.iter().map(|language| labels(on, cycle, language)).collect();
        Arc::clone(known.entry(cycle.key).or_insert_with(|| Arc::new(CycleLabels { languages: all() })))
    }

    /// The cycles of the control that have a name made ready by [`fold`], in whatever language.
    pub(super) fn named(&self, name: &str) -> &[CycleKey] {
        let names = self.names.get_or_init(|| {
            let mut names: BTreeMap<String, Vec<CycleKey>> = BTreeMap::new();
            for (key, cycle) in &self.on.cycles {
                let Some(kept) = self.cycles.get(key) else { continue };
                for own in self.labels_of(cycle, kept).languages.iter().flat_map(|language| &language.name.folded) {
                    names.entry(own.clone()).or_default().push(*key);
                }
            }
            names
        });
        names.get(name).map_or(&[], Vec::as_slice)
    }

    /// Its guards.
    pub(super) fn guards_of<'k>(&self, cycle: &Cycle, kept: &'k Kept) -> &'k [Ready] {
        kept.guards.get_or_init(|| guards::of(self.on, cycle))
    }

    /// The greatest values that any manual prints.
    pub(super) fn limits(&self, catalogue: &Catalogue) -> &Limits {
        self.limits.get_or_init(|| {
            let all = || catalogue.controls.values().flat_map(|on| on.cycles.values()).flat_map(|cycle| &cycle.params);
            let greatest = |quantity| {
                let own = all().filter(|param| param.quantity == quantity).filter_map(|param| param.max);
                own.max_by(f64::total_cmp)
            };
            Limits { speed: greatest(Quantity::Speed), feed: greatest(Quantity::Feed) }
        })
    }

    /// The ranges that other controls' manuals print for parameters for which this one's prints none, by their place.
    pub(super) fn ranges_of<'k>(
        &self,
        catalogue: &Catalogue,
        cycle: &Cycle,
        kept: &'k Kept,
    ) -> &'k BTreeMap<usize, Elsewhere> {
        kept.ranges.get_or_init(|| {
            let range = |(at, param)| {
                let (least, greatest, other) = catalogue.range_elsewhere(self.on, cycle, param)?;
                let control = other.map(|other| other.control.title.clone());
                Some((at, Elsewhere { least, greatest, control }))
            };
            cycle.params.iter().enumerate().filter_map(range).collect()
        })
    }
}

impl Kept {
    fn of(place: usize, cycle: &Cycle) -> Self {
        let labelled = |param: &Param| param.field.as_ref().is_some_and(|field| field.shape == Shape::Labelled);
        Self {
            place,
            labelled: cycle.params.iter().any(labelled),
            kinds: cycle.params.iter().fold(0, |kinds, param| kinds | (1 << param.kind as u32)),
            labels: OnceLock::new(),
            guards: OnceLock::new(),
            ranges: OnceLock::new(),
            deed: OnceLock::new(),
        }
    }

    /// Whether a parameter of the cycle is of that kind.
    pub(super) const fn has_kind(&self, kind: ParameterKind) -> bool {
        self.kinds & (1 << kind as u32) != 0
    }

    /// What the definitions of the cycle do to the state of the control.
    pub(super) fn deed(&self, cycle: &Cycle) -> &Deed {
        self.deed.get_or_init(|| Deed::of(Known::Described(cycle), cycle.key.keyword))
    }
}

fn labels(on: &OnControl, cycle: &Cycle, language: &Language) -> LanguageLabels {
    let vocabulary = Vocabulary::of(on, cycle, language);
    let text = CycleText::new(on, cycle, language, &vocabulary);
    let own = |text: &CycleText<'_>, param| {
        ParamLabels::new(text.label_of(param).map(|label| label.into_owned()), text.label_aliases_of(param))
    };
    LanguageLabels {
        tag: language.tag().to_owned(),
        name: ParamLabels::new(Some(text.nc_name().into_owned()), text.nc_name_aliases()),
        params: cycle.params.iter().map(|param| own(&text, param)).collect(),
    }
}

impl CycleLabels {
    /// The labels in a language.
    pub fn language(&self, tag: &str) -> Option<&LanguageLabels> {
        self.languages.iter().find(|language| language.tag == tag)
    }
}

/// What a definition's name and labels are in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Speech {
    /// It has none, or none that tells a language.
    Silent,
    /// A language that is loaded, by its tag.
    In(String),
    /// A language that is not: it has the labels that a control writes, and no language here has them.
    Foreign,
}

/// Whether a text looks like a label: letters in capitals, no longer than labels of the control are.
pub(crate) fn is_label(text: &str, most: u32) -> bool {
    let letters = text.chars().filter(|c| c.is_alphabetic());
    letters.count() > 1 && !text.chars().any(char::is_lowercase) && text.chars().count() <= most as usize
}

/// Whether a definition without comments has a name in a language that is not loaded. Older software has names of its
/// own, so that alone tells nothing of a program of which the language is known otherwise.
fn is_foreign_name<'a>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &CycleLabels) -> bool {
    let known = |name: &str| labels.languages.iter().any(|language| language.name.matches(name));
    let most = facts.against.on.control.label.max_length;
    let silent = !definition.torn && definition.items.iter().all(|item| item.label.is_none() && item.index.is_some());
    silent && definition.view.name.map(|name| facts.text(name)).is_some_and(|name| is_label(name, most) && !known(name))
}

/// Whether any definition has labels in a language that is not loaded.
fn foreign_labels(facts: &Facts<'_>) -> bool {
    let any = || facts.readings().any(|own| facts.labels(&own).is_some_and(|labels| is_foreign(facts, &own, labels)));
    *facts.foreign.get_or_init(any)
}

/// How many of a definition's names and labels each language has.
fn votes<'a, 'l>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &'l CycleLabels) -> Vec<(&'l str, usize)> {
    let name = definition.view.name.map(|name| fold(facts.text(name)));
    let count = |language: &LanguageLabels| {
        let named = name.as_ref().is_some_and(|name| language.name.matches_folded(name));
        let labelled = definition.items.iter().filter(|item| {
            let own = item.index.and_then(|index| language.params.get(index));
            item.label.zip(own).is_some_and(|(label, own)| own.matches(facts.text(label)))
        });
        labelled.count() + usize::from(named)
    };
    labels.languages.iter().map(|language| (language.tag.as_str(), count(language))).collect()
}

/// The language of a definition's name and labels. Among equals it is the program's, or that of the control's manual.
pub fn speech<'a>(facts: &Facts<'a>, definition: &Definition<'a>) -> Speech {
    let Some(labels) = facts.labels(definition) else { return Speech::Silent };
    if is_foreign(facts, definition, labels) {
        return Speech::Foreign;
    }
    if is_foreign_name(facts, definition, labels) && (facts.language.is_none() || foreign_labels(facts)) {
        return Speech::Foreign;
    }
    let (own, manual) = (facts.language.as_deref(), facts.against.on.control.language.as_str());
    let votes = votes(facts, definition, labels).into_iter().filter(|(_, count)| *count > 0);
    let best = votes.max_by_key(|(tag, count)| (*count, Some(*tag) == own, *tag == manual));
    best.map_or(Speech::Silent, |(tag, _)| Speech::In(tag.to_owned()))
}

/// Whether a definition says nothing in another language than the program: it has no labels, or its name and labels are
/// letter by letter those of the language. Most definitions of long programs are such.
pub(super) fn is_spoken(facts: &Facts<'_>, definition: &Defined<'_>) -> bool {
    let Some(kept) = definition.kept.filter(|_| definition.cycle().is_some()) else { return true };
    let unlabelled = matches!(definition.view.form, CycleForm::Lines(_)) && !kept.labelled;
    unlabelled || facts.has_usual_labels(definition)
}

/// Whether a definition is one that a control wrote in a language that is not loaded.
///
/// Of its parameters at most one of eight is not the cycle's own: newer software has more of them. Two or more and at
/// least half of them have a comment, three of four comments have the form of labels, and at most one of four is a
/// label in a language that is loaded.
fn is_foreign<'a>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &CycleLabels) -> bool {
    let most = facts.against.on.control.label.max_length;
    let items = &definition.items;
    let added = items.iter().filter(|item| item.index.is_none()).count();
    if definition.torn || added * 8 > items.len() {
        return false;
    }
    let known_name = |name: &str| labels.languages.iter().any(|language| language.name.matches(name));
    let name = definition.view.name.map(|name| facts.text(name));
    let written: Vec<Cow<'_, str>> =
        items.iter().filter_map(|item| item.label).map(|label| fold(facts.text(label))).collect();
    let is_known = |label: &&Cow<'_, str>| {
        labels.languages.iter().any(|own| own.params.iter().any(|param| param.matches_folded(label)))
    };
    let (known, shaped) = (
        written.iter().filter(is_known).count(),
        items.iter().filter(|item| item.label.is_some_and(|label| is_label(facts.text(label), most))).count(),
    );
    let enough = written.len() > 1 && written.len() * 2 >= items.len();
    enough && known * 4 <= written.len() && shaped * 4 >= written.len() * 3 && !name.is_some_and(known_name)
}

/// Languages by their places among those of the book: a bit each. More than there are bits nobody has labels in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Tongues(u64);

impl Tongues {
    const ALL: Self = Self(u64::MAX);

    fn of<'l>(languages: &'l [LanguageLabels], is: impl Fn(&'l LanguageLabels) -> bool) -> Self {
        let bit = |(place, language)| u64::from(is(language)) << place;
        Self(languages.iter().take(u64::BITS as usize).enumerate().map(bit).sum())
    }

    /// Whether the language of that place is among them.
    pub(super) const fn has(self, place: u32) -> bool {
        self.0.unbounded_shr(place) & 1 == 1
    }
}

/// Which languages have a text as a name or label.
#[derive(Clone, Copy)]
struct Heard<'a> {
    text: &'a str,
    /// Those that have it without regard to case and blanks.
    matching: Tongues,
    /// Those that have it letter by letter.
    exact: Tongues,
}

impl<'a> Heard<'a> {
    fn of<'l>(
        text: &'a str,
        languages: &'l [LanguageLabels],
        own: impl Fn(&'l LanguageLabels) -> Option<&'l ParamLabels>,
    ) -> Self {
        let folded = fold(text);
        Self {
            text,
            matching: Tongues::of(languages, |language| own(language).is_some_and(|own| own.matches_folded(&folded))),
            exact: Tongues::of(languages, |language| own(language).is_some_and(|own| own.is_exactly(text))),
        }
    }
}

/// What was heard last of a cycle: its name and, by their places, the labels of its parameters. Definitions of a cycle
/// mostly have the same ones.
#[derive(Default)]
struct Memory<'a> {
    name: Option<Heard<'a>>,
    labels: Vec<Option<Heard<'a>>>,
}

/// What the names and labels of a program's definitions tell.
pub(super) struct Told {
    /// The language that most of them belong to; among equals the language of the control's manual.
    pub(super) language: Option<String>,
    /// The languages that have all of a definition's letter by letter, none of one that has no labels.
    pub(super) usual: Vec<Tongues>,
}

/// Listens to the names and labels of a program.
pub(super) fn told_by(facts: &Facts<'_>) -> Told {
    // Every cycle has the languages in the same order.
    let mut votes: Vec<(&str, usize)> = Vec::new();
    let mut memories: Vec<Memory<'_>> = Vec::new();
    let mut usual = Vec::with_capacity(facts.definitions.len());
    for definition in &facts.definitions {
        let Some(((cycle, kept), labels)) = definition.cycle().zip(definition.kept).zip(facts.labels(definition))
        else {
            usual.push(Tongues::default());
            continue;
        };
        let languages = labels.languages.as_slice();
        if votes.is_empty() {
            votes = languages.iter().map(|language| (language.tag.as_str(), 0)).collect();
        }
        if memories.len() <= kept.place {
            memories.resize_with(kept.place + 1, Memory::default);
        }
        let Memory { name, labels } = &mut memories[kept.place];
        let (mut any, mut exact) = (false, Tongues::ALL);
        let mut hear = |heard: Heard<'_>| {
            exact.0 &= heard.exact.0;
            // Most names and labels belong to one language.
            let mut rest = heard.matching.0;
            while rest != 0 {
                if let Some((_, votes)) = votes.get_mut(rest.trailing_zeros() as usize) {
                    *votes += 1;
                }
                rest &= rest - 1;
            }
        };
        if let Some(text) = definition.view.name.map(|name| facts.text(name)) {
            let known = name.filter(|known| known.text == text);
            let heard = known.unwrap_or_else(|| Heard::of(text, languages, |language| Some(&language.name)));
            hear(*name.insert(heard));
        }
        each_label(facts, definition, cycle, kept, |index, text| {
            any = true;
            if labels.len() <= index {
                labels.resize(index + 1, None);
            }
            let last = &mut labels[index];
            let known = last.filter(|known| known.text == text);
            let heard = known.unwrap_or_else(|| Heard::of(text, languages, |language| language.params.get(index)));
            hear(*last.insert(heard));
        });
        usual.push(if any { exact } else { Tongues::default() });
    }
    let manual = facts.against.on.control.language.as_str();
    let best = votes.into_iter().filter(|(_, count)| *count > 0).max_by_key(|(tag, count)| (*count, *tag == manual));
    Told { language: best.map(|(tag, _)| tag.to_owned()), usual }
}

/// The labels of a definition with the places of their parameters in the cycle.
fn each_label<'a>(
    facts: &Facts<'a>,
    definition: &Defined<'a>,
    cycle: &'a Cycle,
    kept: &Kept,
    mut each: impl FnMut(usize, &'a str),
) {
    match &definition.view.form {
        CycleForm::Parameters(written) => {
            let mut place = Place::default();
            for parameter in &written.parameters {
                let own = place.of(cycle, parameter.q);
                if let (Some(own), Some(label)) = (own, parameter.label) {
                    each(own, facts.text(label));
                }
            }
        }
        CycleForm::Lines(_) => {
            if !kept.labelled {
                return;
            }
            for item in &facts.read(definition).items {
                if let (Some(own), Some(label)) = (item.index, item.label) {
                    each(own, facts.text(label));
                }
            }
        }
    }
}
