//! Units of exchange: a text, an attribute or a variant of one, with its source and its translation.
//!
//! The identifier of a unit is the key of the text, and for a variant of it `#` with the number of the selection and the
//! name of the variant: `holes#0[one]`. It does not depend on what else is in a file.
use std::collections::{BTreeSet, HashMap};

use intl_pluralrules::{PluralCategory, PluralRuleType, PluralRules};
use unic_langid::LanguageIdentifier;

use super::fluent::{Pattern, Piece, Select};
use super::prose::{self, Page};
use super::status::State;
use crate::base::diag::Place;
use crate::language::consistency;
use crate::language::locale::{LocaleError, Locales, Meanings, Pair, SOURCE_LANGUAGE};

/// What a translator sees.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its identifier.
    pub id: String,
    /// The key of its text.
    pub key: String,
    /// The message without suffixes and attribute.
    pub message: String,
    /// The file below the folder of the language.
    pub file: String,
    /// What the source says.
    pub source: Vec<Piece>,
    /// What the translation says; nothing if there is none.
    pub target: Vec<Piece>,
    /// Why the text is open, if it is.
    pub state: Option<State>,
    /// What is said to the translator, a line each.
    pub notes: Vec<String>,
    /// The greatest number of characters, where there is one.
    pub most: Option<u32>,
}

/// A text with everything that writing a translation of it needs.
pub(super) struct Text {
    pub(super) pair: Pair,
    /// The file of the translation, whether it exists or not.
    pub(super) path: String,
    pub(super) source: Pattern,
    pub(super) target: Option<Pattern>,
}

/// The units of a text, and where each is in the translation.
pub(super) fn units_of(text: &Text, tag: &str) -> Vec<(Unit, Option<Pattern>)> {
    let original = text.pair.source.source.text();
    let mut units = Vec::new();
    match (&text.target, &text.pair.target) {
        (Some(target), Some(place)) => {
            collect(
                text,
                Side { source: &text.source, target: Some(target), file: place.source.text() },
                "",
                tag,
                &mut units,
            );
        }
        _ => collect(text, Side { source: &text.source, target: None, file: original }, "", tag, &mut units),
    }
    units
}

#[derive(Clone, Copy)]
struct Side<'p> {
    source: &'p Pattern,
    target: Option<&'p Pattern>,
    /// The file of the translation.
    file: &'p str,
}

fn collect(text: &Text, side: Side, path: &str, tag: &str, units: &mut Vec<(Unit, Option<Pattern>)>) {
    let original = text.pair.source.source.text();
    let shape = side.target.unwrap_or(side.source);
    let shape_file = if side.target.is_some() { side.file } else { original };
    if shape.selects().next().is_none() || shape.has_words(shape_file) {
        let unit = Unit {
            id: format!("{}{path}", text.pair.key),
            key: text.pair.key.clone(),
            message: text.pair.id.clone(),
            file: text.pair.source.source.name().splitn(3, '/').nth(2).unwrap_or_default().to_owned(),
            source: side.source.pieces(original),
            target: side.target.map_or_else(Vec::new, |target| target.pieces(side.file)),
            state: None,
            notes: Vec::new(),
            most: None,
        };
        units.push((unit, side.target.cloned()));
    }
    for (index, select) in shape.selects().enumerate() {
        let other = side.source.selects().nth(index);
        for key in keys(select, if side.target.is_some() { None } else { Some(tag) }) {
            let target = side.target.and_then(|_| select.variants.iter().find(|variant| variant.key == key));
            let source = other.and_then(|other| variant(other, &key)).unwrap_or(side.source);
            let inner = Side { source, target: target.map(|variant| &variant.value), file: side.file };
            collect(text, inner, &format!("{path}#{index}[{key}]"), tag, units);
        }
    }
}

/// The variant with this key, or the default.
pub(super) fn variant<'s>(select: &'s Select, key: &str) -> Option<&'s Pattern> {
    let same = select.variants.iter().find(|variant| variant.key == key);
    same.or_else(|| select.variants.iter().find(|variant| variant.default)).map(|variant| &variant.value)
}

/// Numbers that between them have every category that a language uses for whole numbers and decimal ones.
const MOST: u32 = 120;

/// The keys of a selection; where a language is named and they are categories of numbers, those of that language.
pub(super) fn keys(select: &Select, tag: Option<&str>) -> Vec<String> {
    let own: Vec<String> = select.variants.iter().map(|variant| variant.key.clone()).collect();
    let categories = ["zero", "one", "two", "few", "many", "other"];
    let is_plural = own.iter().any(|key| key == "one") && own.iter().any(|key| key == "other");
    let only = own.iter().all(|key| categories.contains(&key.as_str()) || key.parse::<f64>().is_ok());
    let rules =
        tag.and_then(|tag| PluralRules::create(tag.parse::<LanguageIdentifier>().ok()?, PluralRuleType::CARDINAL).ok());
    let (Some(rules), true) = (rules, is_plural && only) else { return own };
    let mut used = BTreeSet::new();
    used.extend((0..=MOST).filter_map(|number| rules.select(number).ok()).map(place));
    used.extend(["0.1", "1.5", "10.0"].iter().filter_map(|number| rules.select(*number).ok()).map(place));
    used.insert(5);
    let numbers = own.into_iter().filter(|key| key.parse::<f64>().is_ok());
    numbers.chain(used.into_iter().filter_map(|at| categories.get(at)).map(|key| (*key).to_owned())).collect()
}

const fn place(category: PluralCategory) -> usize {
    match category {
        PluralCategory::ZERO => 0,
        PluralCategory::ONE => 1,
        PluralCategory::TWO => 2,
        PluralCategory::FEW => 3,
        PluralCategory::MANY => 4,
        PluralCategory::OTHER => 5,
    }
}

/// All texts of a language in the order of the source files, then variants for which it has only a text with other facts.
///
/// # Errors
/// If the source language was not loaded.
pub(super) fn texts(locales: &Locales, tag: &str) -> Result<Vec<Text>, LocaleError> {
    let pattern = |place: &Place| Pattern::after(place.source.text(), place.span.start..place.span.end);
    let mut pairs = locales.pairs(tag)?;
    if locales.language(tag).is_ok() {
        let lacks = consistency::lacking(locales, tag).into_iter();
        pairs.extend(lacks.map(|(key, id, source)| Pair { key, id, source, target: None }));
    }
    let texts = pairs.into_iter().filter_map(|pair| {
        let source = pattern(&pair.source)?;
        let target = pair.target.as_ref().and_then(pattern);
        let from = format!("locales/{SOURCE_LANGUAGE}/");
        let path = match &pair.target {
            Some(place) => place.source.name().to_owned(),
            None => pair.source.source.name().replacen(&from, &format!("locales/{tag}/"), 1),
        };
        Some(Text { pair, path, source, target })
    });
    Ok(texts.collect())
}

/// The units of a language with their states.
///
/// # Errors
/// If the source language was not loaded.
pub fn units(locales: &Locales, meanings: &Meanings, tag: &str) -> Result<Vec<Unit>, LocaleError> {
    let mut open: HashMap<String, (State, Option<String>)> = HashMap::new();
    if locales.language(tag).is_ok() {
        let audit = locales.audit_with(tag, meanings)?;
        for (state, findings) in
            [(State::SameAsSource, audit.same), (State::Unaccepted, audit.unrecorded), (State::Stale, audit.stale)]
        {
            open.extend(findings.into_iter().map(|finding| (finding.key, (state, finding.change))));
        }
    }
    let texts = texts(locales, tag)?;
    let of_texts = texts.iter().flat_map(|text| units_of(text, tag)).map(|(unit, _)| unit);
    let mut all: Vec<Unit> = of_texts.collect();
    all.extend(prose::pages(locales, tag).iter().flat_map(Page::units));
    for unit in &mut all {
        let known = open.get(&unit.key);
        unit.state = if unit.target.is_empty() { Some(State::Missing) } else { known.map(|(state, _)| *state) };
        unit.notes.push(unit.id.clone());
        unit.notes.extend(known.and_then(|(_, change)| change.clone()));
    }
    Ok(all)
}
