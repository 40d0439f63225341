//! What is complete, missing, stale or not executed, for every cycle on every control.
//!
//! Invariant: counts and lists only; what is wrong is the linter's, how it is shown the caller's.
use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::engine::plan;
use crate::language::locale::{Language, LocaleError, Locales, Scope};
use crate::spec::{Catalogue, Cycle, CycleKey, OnControl, measurable, not_in_figures, texts};

/// The name and version of the report's form.
pub const FORMAT: &str = "ciklo-coverage/1";

/// The whole report.
#[derive(Clone, Debug, Serialize)]
pub struct Coverage {
    /// `ciklo-coverage/1`.
    pub format: &'static str,
    /// The controls, by id.
    pub controls: Vec<ControlCoverage>,
}

/// One control.
#[derive(Clone, Debug, Serialize)]
pub struct ControlCoverage {
    /// Its id.
    pub control: String,
    /// Its printed name.
    pub title: String,
    /// How many cycles have a specification.
    pub described: usize,
    /// How many cycles a manual names that have none.
    pub named_only: usize,
    /// The cycles, by key.
    pub cycles: Vec<CycleCoverage>,
}

/// One cycle on one control.
#[derive(Clone, Debug, Serialize)]
pub struct CycleCoverage {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// Its number.
    pub number: u32,
    /// The name of its specification.
    pub name: String,
    /// Its texts in each language.
    pub texts: Vec<TextCoverage>,
    /// How many sentences its run has.
    pub sentences: usize,
    /// The sentences that no example executes.
    pub unexecuted: Vec<String>,
    /// The guards and errors that no example provokes.
    pub unprovoked: Vec<String>,
    /// How many lengths, angles and positions it has.
    pub measurable: usize,
    /// Those that no figure shows, and for which the specification gives no reason.
    pub not_in_figures: Vec<String>,
}

/// The texts of a cycle in one language.
#[derive(Clone, Debug, Serialize)]
pub struct TextCoverage {
    /// The language.
    pub language: String,
    /// How many texts the cycle needs.
    pub needed: usize,
    /// Those that are missing.
    pub missing: Vec<String>,
    /// Those whose English has changed since they were translated.
    pub stale: Vec<String>,
}

impl CycleCoverage {
    /// Whether nothing is missing, stale, unexecuted or unprovoked.
    pub fn is_complete(&self) -> bool {
        let texts = self.texts.iter().all(|text| text.missing.is_empty() && text.stale.is_empty());
        texts && self.not_in_figures.is_empty() && self.unexecuted.is_empty() && self.unprovoked.is_empty()
    }
}

/// What the examples of the specifications left out of one cycle on one control.
#[derive(Clone, Debug, Default)]
pub struct LeftOut {
    /// Sentences that were not executed.
    pub unexecuted: BTreeSet<String>,
    /// Guards and errors that were not provoked.
    pub unprovoked: BTreeSet<String>,
}

/// What the examples left out, by control and cycle.
pub type Executed = BTreeMap<(String, CycleKey), LeftOut>;

/// The report. `executed` comes from running the examples; a cycle that it does not name was not run at all.
///
/// # Errors
/// If a language cannot be compared with the source language.
pub fn coverage(catalogue: &Catalogue, locales: &Locales, executed: &Executed) -> Result<Coverage, LocaleError> {
    let mut stale = BTreeMap::new();
    for language in locales.iter() {
        let keys: BTreeSet<String> = locales.audit(language.tag())?.stale.into_iter().map(|found| found.key).collect();
        stale.insert(language.tag().to_owned(), keys);
    }
    let of_control = |on: &OnControl| ControlCoverage {
        control: on.id().to_owned(),
        title: on.control.title.clone(),
        described: on.cycles.len(),
        named_only: named_only(on),
        cycles: on.cycles.values().map(|cycle| of_cycle(cycle, on, locales, &stale, executed)).collect(),
    };
    Ok(Coverage { format: FORMAT, controls: catalogue.controls.values().map(of_control).collect() })
}

fn named_only(on: &OnControl) -> usize {
    let named = on.control.named.iter().map(|named| CycleKey::new(named.keyword, named.number));
    named.filter(|key| !on.cycles.contains_key(key)).count()
}

fn of_cycle(
    cycle: &Cycle,
    on: &OnControl,
    locales: &Locales,
    stale: &BTreeMap<String, BTreeSet<String>>,
    executed: &Executed,
) -> CycleCoverage {
    let plan = &plan::compiled(cycle, on).plan;
    let all = || plan.sentences.iter().map(|sentence| sentence.id.to_string());
    let left_out = executed.get(&(on.id().to_owned(), cycle.key)).cloned();
    let left_out = left_out.unwrap_or_else(|| LeftOut { unexecuted: all().collect(), unprovoked: BTreeSet::new() });
    let none = BTreeSet::new();
    let texts = locales.iter().map(|language| {
        let stale = stale.get(language.tag()).unwrap_or(&none);
        of_language(cycle, on, language, stale)
    });
    CycleCoverage {
        keyword: cycle.key.keyword.as_str(),
        number: cycle.key.number,
        name: cycle.name().to_owned(),
        texts: texts.collect(),
        sentences: plan.sentences.len(),
        unexecuted: left_out.unexecuted.into_iter().collect(),
        unprovoked: left_out.unprovoked.into_iter().collect(),
        measurable: measurable(cycle).count(),
        not_in_figures: not_in_figures(on, cycle).iter().map(|param| param.label_in(cycle.key.number)).collect(),
    }
}

fn of_language(cycle: &Cycle, on: &OnControl, language: &Language, stale: &BTreeSet<String>) -> TextCoverage {
    let scope = Scope::new(cycle.name(), on.id());
    let needed = texts(cycle, on);
    let mut coverage = TextCoverage {
        language: language.tag().to_owned(),
        needed: needed.len(),
        missing: Vec::new(),
        stale: Vec::new(),
    };
    for text in &needed {
        let attribute = text.attribute.map(|attribute| format!(".{attribute}")).unwrap_or_default();
        let plain = format!("{}{attribute}", text.id);
        if !language.has(plain.as_str(), &scope) {
            coverage.missing.push(plain);
            continue;
        }
        let suffixes =
            [format!("__{}__{}", cycle.name(), on.id()), format!("__{}", cycle.name()), format!("__{}", on.id())];
        let variants = suffixes.iter().map(|suffix| format!("{}{suffix}{attribute}", text.id));
        coverage.stale.extend(variants.chain([plain]).filter(|key| stale.contains(key)));
    }
    coverage
}
