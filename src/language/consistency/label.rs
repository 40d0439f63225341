//! Labels and names: no two parameters of a cycle have the same, and none has that of another.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Place};
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{Catalogue, OnControl, Param};

/// A parameter with its name and label in a language.
struct Named<'c> {
    param: &'c Param,
    name: String,
    label: String,
}

/// How much more of a label must fit another name than its own.
const CLEARLY: f64 = 0.4;

/// Reports labels that two parameters of a cycle share, and labels that speak of another parameter.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    for on in catalogue.controls.values() {
        let all: Vec<(&Language, BTreeMap<&str, Vec<Named>>)> =
            locales.iter().map(|language| (language, named(on, language))).collect();
        for (language, cycles) in &all {
            let names = by_label(cycles);
            for (cycle, params) in cycles {
                for (at, one) in params.iter().enumerate() {
                    let same = params[..at].iter().find(|other| other.label == one.label && other.name != one.name);
                    if let Some(other) = same
                        && !shared_elsewhere(&all, language, cycle, (&one.param.is.text, &other.param.is.text))
                    {
                        found.push(report("consistency-label-twice", language, on, cycle, one, other));
                    } else if catalogue_explains(catalogue, on, cycle, one) {
                        continue;
                    } else if let Some((other, is)) = of_another(one, &names)
                        && !elsewhere_of(&all, language, cycle, (&one.param.is.text, is))
                    {
                        found.push(report("consistency-label-of-another", language, on, cycle, one, &other));
                    }
                }
            }
        }
    }
}

fn catalogue_explains(catalogue: &Catalogue, on: &OnControl, cycle: &str, one: &Named) -> bool {
    on.by_name(cycle).is_some_and(|cycle| catalogue.explains(on, cycle, one.param))
}

fn report(
    code: &'static str,
    language: &Language,
    on: &OnControl,
    cycle: &str,
    one: &Named,
    other: &Named,
) -> Diagnostic {
    let place = language
        .raw(Key::from((format!("parameter-{}", one.param.is.as_str()).as_str(), "label")), Scope::new(cycle, on.id()))
        .map_or_else(|| one.param.is.place.clone(), |(_, place)| place);
    Diagnostic::error(code, place)
        .arg("language", language.tag())
        .arg("label", one.label.as_str())
        .arg("parameter", one.name.as_str())
        .arg("other", other.name.as_str())
}

/// Whether the two parameters share a label in another language, too: then the printed blocks do.
fn shared_elsewhere(
    all: &[(&Language, BTreeMap<&str, Vec<Named>>)],
    own: &Language,
    cycle: &str,
    (one, other): (&str, &str),
) -> bool {
    all.iter().filter(|(language, _)| language.tag() != own.tag()).any(|(_, cycles)| {
        let label = |is: &str| {
            let params = cycles.get(cycle)?;
            params.iter().find(|named| *named.param.is.text == *is).map(|named| named.label.as_str())
        };
        label(one).is_some() && label(one) == label(other)
    })
}

/// Whether another language has the label of the one parameter for the other one, too.
fn elsewhere_of(
    all: &[(&Language, BTreeMap<&str, Vec<Named>>)],
    own: &Language,
    cycle: &str,
    (one, other): (&str, &str),
) -> bool {
    all.iter().filter(|(language, _)| language.tag() != own.tag()).any(|(_, cycles)| {
        let label = cycles.get(cycle).and_then(|params| params.iter().find(|named| *named.param.is.text == *one));
        let Some(label) = label.map(|named| &named.label) else { return false };
        cycles.values().flatten().any(|named| *named.param.is.text == *other && named.label == *label)
    })
}

fn named<'c>(on: &'c OnControl, language: &Language) -> BTreeMap<&'c str, Vec<Named<'c>>> {
    let mut cycles = BTreeMap::new();
    for cycle in on.cycles.values() {
        let vocabulary = Vocabulary::of(on, cycle, language);
        let text = CycleText::new(on, cycle, language, &vocabulary);
        let params = cycle.params.iter().filter(|param| param.q.is_some());
        let named: Vec<Named> = params
            .filter_map(|param| {
                let texts = text.param(param);
                let (name, label) = (texts.name.into_owned(), texts.label?.into_owned());
                (!name.is_empty() && !label.is_empty()).then_some(Named { param, name, label })
            })
            .collect();
        cycles.insert(cycle.name(), named);
    }
    cycles
}

/// For each label the names of the parameters that have it.
fn by_label<'n>(cycles: &'n BTreeMap<&str, Vec<Named>>) -> BTreeMap<&'n str, BTreeSet<(&'n str, &'n str)>> {
    let mut names: BTreeMap<&str, BTreeSet<(&str, &str)>> = BTreeMap::new();
    for one in cycles.values().flatten() {
        names.entry(&one.label).or_default().insert((&one.name, one.param.is.as_str()));
    }
    names
}

/// Another parameter with the same label whose name the label fits clearly better than that of this one.
fn of_another<'c, 'n>(
    one: &Named<'c>,
    names: &BTreeMap<&'n str, BTreeSet<(&'n str, &'n str)>>,
) -> Option<(Named<'c>, &'n str)> {
    let own = likeness(&one.label, &one.name);
    let others = names.get(one.label.as_str())?;
    let fits = others.iter().filter(|(_, is)| *is != one.param.is.as_str());
    let (name, is) = fits.copied().find(|(name, _)| likeness(&one.label, name) >= own + CLEARLY)?;
    Some((Named { param: one.param, name: name.to_owned(), label: one.label.clone() }, is))
}

/// The share of the words of a label that begin, abbreviated or not, like a word of the name.
fn likeness(label: &str, name: &str) -> f64 {
    let words = |text: &str| -> Vec<String> {
        let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        words.map(str::to_lowercase).collect()
    };
    let (label, name) = (words(label), words(name));
    if label.is_empty() {
        return 0.0;
    }
    let alike = |a: &str, b: &str| {
        let shared = a.chars().zip(b.chars()).take_while(|(a, b)| a == b).count();
        shared >= 3 || shared == a.chars().count().min(b.chars().count())
    };
    let hits = label.iter().filter(|word| name.iter().any(|other| alike(word, other))).count();
    hits as f64 / label.len() as f64
}

/// Labels that two meanings share in one language and in no other. Shipped labels do so where the manual prints the same word for
/// both; a label that comes to do so was probably taken from another line.
pub(super) fn shared(locales: &Locales, found: &mut Vec<Diagnostic>) {
    type Labels<'l> = BTreeMap<(&'l str, &'l [Box<str>]), (String, Place)>;
    let labels = |language| -> Labels {
        let all = Language::keys(language).filter(|(key, _)| key.attribute == Some("label"));
        let label = |(key, suffixes): (Key<'_>, &'_ [Box<str>])| language.raw(key, scope_of(suffixes));
        all.filter_map(|(key, suffixes)| Some(((key.id, suffixes), label((key, suffixes))?))).collect()
    };
    let all: Vec<(&Language, Labels)> = locales.iter().map(|language| (language, labels(language))).collect();
    for (language, labels) in &all {
        let mut by_text: BTreeMap<&str, Vec<&(&str, &[Box<str>])>> = BTreeMap::new();
        labels.iter().for_each(|(key, (text, _))| by_text.entry(text).or_default().push(key));
        for (text, keys) in by_text {
            for (at, one) in keys.iter().enumerate() {
                for other in keys[..at].iter().filter(|other| other.0 != one.0) {
                    let agrees = |(own, labels): &(&Language, Labels)| {
                        let both = labels.get(*one).zip(labels.get(*other));
                        own.tag() != language.tag() && both.is_some_and(|((a, _), (b, _))| a == b)
                    };
                    let Some((_, place)) = labels.get(*one).filter(|_| !all.iter().any(agrees)) else { continue };
                    let name = |key: &(&str, &[Box<str>])| {
                        let suffixes: String = key.1.iter().map(|suffix| format!("__{suffix}")).collect();
                        format!("{}{suffixes}.label", key.0)
                    };
                    found.push(
                        Diagnostic::error("consistency-label-of-another", place.clone())
                            .arg("language", language.tag())
                            .arg("label", text)
                            .arg("key", name(one))
                            .arg("parameter", name(one))
                            .arg("other", name(other)),
                    );
                }
            }
        }
    }
}

fn scope_of(suffixes: &[Box<str>]) -> Scope<'_> {
    match suffixes {
        [] => Scope::NONE,
        [one] => Scope { cycle: Some(one), control: Some(one) },
        [cycle, control, ..] => Scope::new(cycle, control),
    }
}
