//! The labels of a control's cycles in all languages, what else the checker keeps of a cycle, and the language of a
//! program.
//!
//! Invariant: a text that a language lacks matches nothing; labels are compared without regard to
//! case and blanks, as programs come from many hands.
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::effect::Effect;
use super::guard::{Ready, guards_of};
use crate::language::locale::{Language, Locales};
use crate::language::text::{self, CycleText, Vocabulary};
use crate::spec::{Catalogue, Cycle, CycleKey, OnControl, Param, ParameterKind, Quantity, Shape};

/// The labels of a control, put together when a cycle is first asked for.
pub struct LabelBook<'a> {
    on: &'a OnControl,
    locales: &'a Locales,
    cycles: BTreeMap<CycleKey, (usize, OnceLock<Kept>)>,
    limits: OnceLock<Limits>,
    /// The cycles by their names.
    names: OnceLock<BTreeMap<String, Vec<CycleKey>>>,
    /// The names of cycles on whatever control.
    names_anywhere: Mutex<BTreeMap<CycleKey, Arc<[String]>>>,
    /// Labels of cycles that only other controls describe.
    elsewhere: Mutex<BTreeMap<CycleKey, Arc<CycleLabels>>>,
}

/// The greatest values that any manual prints for the parameters of cycles.
#[derive(Debug)]
pub(in crate::check) struct Limits {
    /// Of a spindle speed.
    pub(in crate::check) speed: Option<f64>,
    /// Of a feed in mm/min.
    pub(in crate::check) feed: Option<f64>,
    /// Of a coordinate in mm.
    pub(in crate::check) coordinate: Option<f64>,
}

/// What is kept of a cycle for all its definitions.
pub(in crate::check) struct Kept {
    /// Its place among the cycles of the control.
    pub(in crate::check) place: usize,
    /// Whether words come before values of its old form that are labels.
    pub(in crate::check) labelled: bool,
    /// A bit for each kind that a parameter of it has.
    kinds: u32,
    labels: OnceLock<CycleLabels>,
    guards: OnceLock<Vec<Ready>>,
    ranges: OnceLock<BTreeMap<usize, Elsewhere>>,
    effect: OnceLock<Effect>,
}

/// The range that other controls' manuals print for a parameter.
#[derive(Debug)]
pub(in crate::check) struct Elsewhere {
    pub(in crate::check) least: f64,
    pub(in crate::check) greatest: f64,
    /// The title of one of those controls; nothing where the range is that of parameters like this one.
    pub(in crate::check) control: Option<String>,
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
    pub(in crate::check) fn is_exactly(&self, printed: &str) -> bool {
        self.folded.iter().any(|own| own == printed)
    }

    /// Whether a label made ready by [`fold`] is this one.
    pub(in crate::check) fn matches_folded(&self, printed: &str) -> bool {
        self.folded.iter().any(|own| own == printed)
    }
}

/// A label for comparison: capitals, single blanks, no colon at the end.
pub(in crate::check) fn fold(label: &str) -> Cow<'_, str> {
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
        let cycles = on.cycles.keys().enumerate().map(|(place, key)| (*key, (place, OnceLock::new()))).collect();
        Self {
            on,
            locales,
            cycles,
            limits: OnceLock::new(),
            names: OnceLock::new(),
            names_anywhere: Mutex::default(),
            elsewhere: Mutex::default(),
        }
    }

    /// The tags of its languages, in the order in which cycles have them.
    pub(in crate::check) fn languages(&self) -> impl Iterator<Item = &str> {
        self.locales.iter().map(Language::tag)
    }

    /// The labels of a cycle; nothing if the control does not describe it.
    pub fn cycle(&self, key: CycleKey) -> Option<&CycleLabels> {
        Some(self.labels_of(self.on.cycles.get(&key)?, self.kept(key)?))
    }

    /// What is kept of a cycle that the control describes.
    pub(in crate::check) fn kept(&self, key: CycleKey) -> Option<&Kept> {
        let (place, kept) = self.cycles.get(&key)?;
        let cycle = self.on.cycles.get(&key)?;
        Some(kept.get_or_init(|| Kept::of(*place, cycle)))
    }

    /// The labels of a cycle of which that is kept.
    pub(in crate::check) fn labels_of<'k>(&self, cycle: &Cycle, kept: &'k Kept) -> &'k CycleLabels {
        kept.labels.get_or_init(|| CycleLabels {
            languages: self.locales.iter().map(|language| labels(self.on, cycle, language)).collect(),
        })
    }

    /// The labels of a cycle that another control describes and this one does not.
    pub(in crate::check) fn labels_elsewhere(&self, on: &OnControl, cycle: &Cycle) -> Arc<CycleLabels> {
        let mut known = self.elsewhere.lock().unwrap_or_else(PoisonError::into_inner);
        let all = || self.locales.iter().map(|language| labels(on, cycle, language)).collect();
        Arc::clone(known.entry(cycle.key).or_insert_with(|| Arc::new(CycleLabels { languages: all() })))
    }

    /// The cycles of the control that have a name made ready by [`fold`], in whatever language.
    pub(in crate::check) fn named(&self, name: &str) -> &[CycleKey] {
        let names = self.names.get_or_init(|| {
            let mut names: BTreeMap<String, Vec<CycleKey>> = BTreeMap::new();
            for (key, outline) in &self.on.outlines {
                for own in self.names_on(self.on, &outline.name) {
                    names.entry(own).or_default().push(*key);
                }
            }
            names
        });
        names.get(name).map_or(&[], Vec::as_slice)
    }

    /// The names of a cycle in all languages, made ready by [`fold`], as the control with the highest id has them;
    /// nothing if no control describes it.
    pub(in crate::check) fn names_anywhere(&self, catalogue: &Catalogue, key: CycleKey) -> Option<Arc<[String]>> {
        let mut known = self.names_anywhere.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(names) = known.get(&key) {
            return Some(Arc::clone(names));
        }
        let mut controls = catalogue.controls.values().rev();
        let (on, outline) = controls.find_map(|on| Some((on, on.outlines.get(&key)?)))?;
        let names: Arc<[String]> = self.names_on(on, &outline.name).into();
        known.insert(key, Arc::clone(&names));
        Some(names)
    }

    fn names_on(&self, on: &OnControl, cycle: &str) -> Vec<String> {
        let printed = self.locales.iter().flat_map(|language| text::nc_names(on, cycle, language));
        printed.filter(|name| !name.is_empty()).map(|name| fold(&name).into_owned()).collect()
    }

    /// Its guards.
    pub(in crate::check) fn guards_of<'k>(&self, cycle: &Cycle, kept: &'k Kept) -> &'k [Ready] {
        kept.guards.get_or_init(|| guards_of(self.on, cycle))
    }

    /// The greatest values that any manual prints.
    pub(in crate::check) fn limits(&self, catalogue: &Catalogue) -> &Limits {
        self.limits.get_or_init(|| {
            let greatest = |quantity| catalogue.greatest(quantity);
            Limits {
                speed: greatest(Quantity::Speed),
                feed: greatest(Quantity::Feed),
                coordinate: greatest(Quantity::Length),
            }
        })
    }

    /// The ranges that other controls' manuals print for parameters for which this one's prints none, by their place.
    pub(in crate::check) fn ranges_of<'k>(
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
            effect: OnceLock::new(),
        }
    }

    /// Whether a parameter of the cycle is of that kind.
    pub(in crate::check) const fn has_kind(&self, kind: ParameterKind) -> bool {
        self.kinds & (1 << kind as u32) != 0
    }

    /// What the definitions of the cycle do to the state of the control.
    pub(in crate::check) fn effect(&self, cycle: &Cycle) -> &Effect {
        self.effect.get_or_init(|| Effect::of_cycle(cycle))
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

/// Whether a text looks like a label: letters in capitals, no longer than labels of the control are.
pub(crate) fn is_label(text: &str, most: u32) -> bool {
    let letters = text.chars().filter(|c| c.is_alphabetic());
    letters.count() > 1 && !text.chars().any(char::is_lowercase) && text.chars().count() <= most as usize
}

/// The same of a label that is known to be one by its place: a short word may have small letters (`2eme`), and other software
/// than that of the manuals has longer ones.
pub(crate) fn is_label_by_place(text: &str, most: u32) -> bool {
    let (mut letters, mut small) = (0, 0);
    for letter in text.chars().filter(|c| c.is_alphabetic()) {
        letters += 1;
        small += usize::from(letter.is_lowercase());
    }
    letters > 1 && small * 4 <= letters && text.chars().count() <= most as usize + LONGER
}

/// How much longer labels of other software are.
const LONGER: usize = 6;

/// Languages by their places among those of the book: a bit each. More than there are bits no one has labels in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::check) struct LabelLanguages(u64);

impl LabelLanguages {
    pub(in crate::check) const ALL: Self = Self(u64::MAX);

    /// Those of which something is so.
    pub(in crate::check) fn of<'l>(languages: &'l [LanguageLabels], is: impl Fn(&'l LanguageLabels) -> bool) -> Self {
        let bit = |(place, language)| u64::from(is(language)) << place;
        Self(languages.iter().take(u64::BITS as usize).enumerate().map(bit).sum())
    }

    /// Whether the language of that place is among them.
    pub(in crate::check) const fn has(self, place: u32) -> bool {
        self.0.unbounded_shr(place) & 1 == 1
    }

    /// Those that are among these and the others.
    pub(in crate::check) const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The places of those that are among them.
    pub(in crate::check) fn places(self) -> impl Iterator<Item = usize> {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            let place = rest.trailing_zeros();
            rest &= rest.wrapping_sub(1);
            (place < u64::BITS).then_some(place as usize)
        })
    }
}
