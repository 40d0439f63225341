//! The catalogue: every cycle of every control, resolved from the files; see [`load`](super::load) for how.
//!
//! Invariant: whoever reads it cannot tell whether all files were read at once or each when it was asked for.
use std::collections::BTreeMap;
use std::sync::Arc;

use super::decode::Name;
use super::form::{Choice, CycleFile, Described, Fragment, Meaning};
use super::language::{BlockWords, Global, OldCycle};
use super::pages::Pages;
use super::profile::{Control, Erratum, Named, Topic};
use super::vocabulary::{Doubtful, Keyword, ParameterKind, Quantity, Reference, Shape};
use super::worked::Worked;
use crate::base::demand::{Deferred, Made, OnDemand};
use crate::base::diag::{Mistakes, Place};
use crate::base::expr::{QKind, QRef};

/// The key of a cycle: how it is written and its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CycleKey {
    /// How it is written.
    pub keyword: Keyword,
    /// Its number.
    pub number: u32,
}

impl CycleKey {
    /// The key of that keyword and number.
    pub const fn new(keyword: Keyword, number: u32) -> Self {
        Self { keyword, number }
    }

    /// Whether the number is reserved for cycles of the machine builder.
    pub const fn is_builders(self) -> bool {
        matches!((self.keyword, self.number), (Keyword::CyclDef, 300..=399) | (_, 500..=599))
    }
}

impl std::fmt::Display for CycleKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.keyword.as_str(), self.number)
    }
}

/// Where an old-style field is and how it is written.
#[derive(Clone, Debug)]
pub struct Field {
    /// The index of its form.
    pub form: usize,
    /// The number of its line after the point.
    pub line: u32,
    /// Whether the line may be repeated with following numbers.
    pub repeat: bool,
    /// Its id.
    pub id: Name,
    /// How it is written.
    pub shape: Shape,
    /// The fixed word of the shape `word`.
    pub word: Option<String>,
    /// Whether it may be incremental.
    pub incremental: bool,
    /// Whether it may be left out.
    pub optional: bool,
    /// The Q parameter of the cycle of the new form that it stands for.
    pub stands_for: Option<QRef>,
}

/// A parameter of a cycle on one control, with everything that the dictionary adds.
#[derive(Clone, Debug)]
pub struct Param {
    /// The Q parameter; nothing for old-style fields.
    pub q: Option<QRef>,
    /// The old-style field.
    pub field: Option<Field>,
    /// Its meaning.
    pub is: Name,
    /// What kind of entry.
    pub kind: ParameterKind,
    /// What it measures.
    pub quantity: Quantity,
    /// What it counts from, as printed.
    pub reference: Option<Reference>,
    /// The least value, inclusive.
    pub min: Option<f64>,
    /// The greatest value, inclusive.
    pub max: Option<f64>,
    /// The greatest number of characters of a text, or of labels of a list.
    pub max_length: Option<u32>,
    /// Words instead of a number.
    pub words: Vec<String>,
    /// The values offered.
    pub choices: Vec<Choice>,
    /// The values that are hardly meant.
    pub doubtful: Vec<Doubtful>,
    /// The least and the greatest value that anybody means, in mm, mm/min and s.
    pub plausible: [Option<f64>; 2],
    /// The characters that a text may have besides letters, digits and blanks; nothing if it may have any.
    pub characters: Option<String>,
    /// The condition under which it acts.
    pub effective: Option<Name>,
    /// Its value on controls that lack it.
    pub neutral: Option<f64>,
    /// Its value in programs of older controls, where that is not the neutral one.
    pub imported: Option<f64>,
    /// What the control adds for it to programs of an earlier software version: a number, or another parameter of the
    /// cycle whose value it takes; empty where that is not known.
    pub added: Option<String>,
    /// The printed example value.
    pub example: Option<String>,
    /// Where it is in the file.
    pub place: Place,
}

impl Param {
    /// Whether its value is a list of axes.
    pub fn lists_axes(&self) -> bool {
        self.field.as_ref().is_some_and(|field| field.shape == Shape::Axes)
    }

    /// How other programs name it: `Q200`, or `31.2 height` for a field of the cycle of that number.
    pub fn label_in(&self, number: u32) -> String {
        match (&self.q, &self.field) {
            (Some(q), _) => q.to_string(),
            (None, Some(field)) => format!("{number}.{} {}", field.line, field.id.as_str()),
            (None, None) => String::new(),
        }
    }

    /// Whether its value is a length or a feed, in the unit of the program.
    pub const fn is_measured(&self) -> bool {
        matches!(self.quantity, Quantity::Length | Quantity::Feed)
    }

    /// What the control adds where a definition of an earlier software version, or of an earlier control, lacks the
    /// parameter: a number or the parameter whose value it takes; empty where only that it does so is known, nothing
    /// where the definition is wrong without it.
    pub fn supplied(&self) -> Option<String> {
        self.q?;
        let number = self.imported.or(self.neutral);
        self.added.clone().or_else(|| number.map(|value| value.to_string()))
    }

    /// The text parameter that holds a name, if the parameter takes a number or a name.
    pub fn q_of_name(&self) -> Option<QRef> {
        let q = self.q.filter(|_| self.kind == ParameterKind::NumberOrName)?;
        Some(QRef { kind: QKind::Qs, ..q })
    }
}

/// A cycle on one control.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Its key.
    pub key: CycleKey,
    /// The id of the control.
    pub control: Arc<str>,
    /// Where and with which options the control describes it.
    pub described: Described,
    /// Its parameters in the order of the dialog, old-style fields included.
    pub params: Vec<Param>,
    /// Parameters that other controls have, with the values that the run uses here.
    pub lacking: Vec<(QRef, f64)>,
    /// DIN/ISO codes of the cycle and its forms.
    pub iso: Vec<String>,
    /// The file for this control; `run` and what belongs to it come from the cycle named by `like`.
    pub file: CycleFile,
}

impl Cycle {
    /// Its name, the base of its message ids.
    pub fn name(&self) -> &str {
        self.file.name.as_str()
    }

    /// The parameter of that Q number.
    pub fn param(&self, q: QRef) -> Option<&Param> {
        self.params.iter().find(|param| param.q == Some(q))
    }

    /// The parameter that a definition writes under that Q number.
    pub fn written(&self, q: QRef) -> Option<&Param> {
        self.params.get(self.place_of(q)?)
    }

    /// The place of that parameter among all.
    pub fn place_of(&self, q: QRef) -> Option<usize> {
        self.params.iter().position(|param| param.q == Some(q) || param.q_of_name() == Some(q))
    }

    /// Whether it is written in the old form, a block a line.
    pub fn is_old_style(&self) -> bool {
        !self.file.forms.is_empty()
    }

    /// The fields of one form, in order.
    pub fn fields(&self, form: usize) -> impl Iterator<Item = (&Param, &Field)> {
        let with_field = self.params.iter().filter_map(|param| param.field.as_ref().map(|field| (param, field)));
        with_field.filter(move |(_, field)| field.form == form)
    }
}

/// What a control knows of a number.
#[derive(Clone, Copy, Debug)]
pub enum Known<'c> {
    /// A specification exists.
    Described(&'c Cycle),
    /// A manual names it only.
    Named(&'c Named),
    /// A cycle of the machine builder.
    Builders,
    /// Nothing.
    Unknown,
}

/// What is known of a cycle without reading its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// Its name, the base of its message ids.
    pub name: String,
    /// The cycle whose run it has.
    pub like: Option<String>,
    /// Its DIN/ISO codes, each with the index of the form that it stands for.
    pub codes: Vec<(Option<usize>, String)>,
    /// The Q parameters that its definition has.
    pub parameters: Vec<QRef>,
}

/// All cycles of one control.
#[derive(Clone, Debug)]
pub struct OnControl {
    /// The control.
    pub control: Control,
    /// Its cycles by key.
    pub cycles: OnDemand<CycleKey, Cycle>,
    /// What each of them is, in a few words.
    pub outlines: BTreeMap<CycleKey, Outline>,
    /// The fragments by name.
    pub fragments: OnDemand<String, Fragment>,
    /// The dictionary.
    pub meanings: Arc<OnDemand<String, Meaning>>,
    /// Its worked programs, in the order of their files.
    pub worked: Deferred<Vec<Worked>>,
    /// What others make of each cycle once: its compiled run.
    pub made: Made<CycleKey>,
}

impl OnControl {
    /// The id of the control.
    pub fn id(&self) -> &str {
        self.control.control.as_str()
    }

    /// What the control knows of a cycle.
    pub fn known(&self, key: CycleKey) -> Known<'_> {
        if let Some(cycle) = self.cycles.get(&key) {
            return Known::Described(cycle);
        }
        match self.named(key) {
            Some(named) => Known::Named(named),
            None if key.is_builders() => Known::Builders,
            None => Known::Unknown,
        }
    }

    /// Whether its manuals give the cycles of this keyword in full.
    pub fn covers(&self, key: CycleKey) -> bool {
        self.control.covers.contains(&key.keyword)
    }

    /// What the overviews of its manuals say of a cycle, described or not.
    pub fn named(&self, key: CycleKey) -> Option<&Named> {
        self.control.named.iter().find(|named| named.keyword == key.keyword && named.number == key.number)
    }

    /// The cycle of that name.
    pub fn by_name(&self, name: &str) -> Option<&Cycle> {
        let (key, _) = self.outlines.iter().find(|(_, outline)| outline.name == name)?;
        self.cycles.get(key)
    }

    /// What each cycle has that writes a parameter under that Q number.
    pub fn all_written(&self, q: QRef) -> impl Iterator<Item = &Param> {
        let has = move |outline: &Outline| outline.parameters.iter().any(|own| own.number == q.number);
        let keys = self.outlines.iter().filter(move |(_, outline)| has(outline)).map(|(key, _)| key);
        keys.filter_map(move |key| self.cycles.get(key)?.written(q))
    }

    /// The cycle that has the run of the one of that name.
    pub fn follower_of(&self, name: &str) -> Option<&Cycle> {
        let (key, _) = self.outlines.iter().find(|(_, outline)| outline.like.as_deref() == Some(name))?;
        self.cycles.get(key)
    }

    /// The printed name of a machine datum.
    pub fn datum(&self, neutral: &str) -> Option<&str> {
        self.control.data.get(neutral).map(Name::as_str)
    }
}

/// What is printed for all parameters that mean the same and are of the same kind, on any control.
#[derive(Clone, Debug, PartialEq)]
pub struct PrintedRange {
    /// What they mean.
    pub meaning: String,
    /// What kind of entry.
    pub kind: ParameterKind,
    /// What they measure.
    pub quantity: Quantity,
    /// Whether they are fields of old-style lines.
    pub field: bool,
    /// The widest range of those that have both ends.
    pub range: Option<(f64, f64)>,
    /// The greatest value of any.
    pub greatest: Option<f64>,
}

/// Everything that the files say.
#[derive(Clone, Debug, Default)]
pub struct Catalogue {
    /// The controls, by id in alphabetical order.
    pub controls: OnDemand<String, OnControl>,
    /// The errata.
    pub errata: Deferred<Vec<Erratum>>,
    /// The topics, in the order of the overview.
    pub topics: Deferred<Vec<Topic>>,
    /// What pages of the manual need beyond cycles and topics.
    pub pages: Deferred<Option<Pages>>,
    /// Blocks of the language that are no cycles; those with more words come after those with fewer.
    pub blocks: Deferred<Vec<BlockWords>>,
    /// What GLOBAL DEF gives.
    pub globals: Deferred<Vec<Global>>,
    /// Cycles of the first controls, which the ones after them still carry out.
    pub old_cycles: Deferred<Vec<OldCycle>>,
    /// The ranges of all parameters.
    pub ranges: Deferred<Vec<PrintedRange>>,
    /// What was found in files that were read when they were asked for.
    pub mistakes: Mistakes,
}

impl Catalogue {
    /// A cycle as the control with the highest id describes it: what is said of it where the own control's manuals are
    /// silent.
    pub fn describing(&self, key: CycleKey) -> Option<(&OnControl, &Cycle)> {
        self.controls.values().rev().find_map(|on| match on.known(key) {
            Known::Described(cycle) => Some((on, cycle)),
            _ => None,
        })
    }

    /// Whether the errata explain what a parameter does otherwise than in other cycles.
    pub fn explains(&self, on: &OnControl, cycle: &Cycle, param: &Param) -> bool {
        let Some(q) = param.q.map(|q| q.to_string()) else { return false };
        let key = cycle.key.to_string();
        self.errata.iter().any(|entry| {
            entry.q.as_ref().is_some_and(|own| own.as_str() == q)
                && entry.cycle.as_ref().is_some_and(|own| own.as_str() == key)
                && entry.control.as_ref().is_none_or(|own| own.as_str() == on.id())
        })
    }

    /// The widest range that the controls whose manuals print one give for a parameter of a cycle: its least and
    /// greatest value, and one of those controls. Where none does, the widest one for parameters of that meaning or, of
    /// plain numbers, for what it measures, without a control. Nothing if the control itself prints one.
    pub fn range_elsewhere(
        &self,
        on: &OnControl,
        cycle: &Cycle,
        param: &Param,
    ) -> Option<(f64, f64, Option<&OnControl>)> {
        if param.min.is_some() || param.max.is_some() {
            return None;
        }
        let same = |other: &&Param| {
            let field = |own: &Param| own.field.as_ref().map(|field| (field.form, field.line, field.shape));
            let kind = |own: &Param| (own.q, own.kind, own.quantity);
            other.is.as_str() == param.is.as_str() && kind(other) == kind(param) && field(other) == field(param)
        };
        let others = self.controls.values().filter(|other| other.id() != on.id());
        let ranges = others.filter_map(|other| {
            let own = other.cycles.get(&cycle.key)?.params.iter().find(same)?;
            Some((own.min?, own.max?, Some(other)))
        });
        let wider = |one: (f64, f64, _), other: (f64, f64, _)| (one.0.min(other.0), one.1.max(other.1), one.2);
        let of_cycle = ranges.reduce(wider);
        if of_cycle.is_some() || param.field.is_some() {
            return of_cycle;
        }
        let alike =
            |other: &&PrintedRange| !other.field && other.kind == param.kind && other.quantity == param.quantity;
        let all = || self.ranges.iter().filter(alike);
        let range = |own: &PrintedRange| own.range.map(|(least, greatest)| (least, greatest, None));
        let meant = all().filter(|other| other.meaning == param.is.as_str()).filter_map(range).reduce(wider);
        let measures = matches!(param.quantity, Quantity::Length | Quantity::Feed | Quantity::Angle | Quantity::Time);
        let plain = measures && param.kind == ParameterKind::Number && param.choices.is_empty();
        meant.or_else(|| all().filter(|_| plain).filter_map(range).reduce(wider))
    }

    /// The greatest value that any manual prints for a parameter that measures this.
    pub fn greatest(&self, quantity: Quantity) -> Option<f64> {
        let own = self.ranges.iter().filter(|range| range.quantity == quantity);
        own.filter_map(|range| range.greatest).max_by(f64::total_cmp)
    }

    /// The cycles of a control, by its id or another of its names.
    pub fn on(&self, control: &str) -> Option<&OnControl> {
        // Ids are written in small letters; titles of controls are not.
        let control = control.to_lowercase();
        self.controls.get(&*control).or_else(|| self.controls.values().find(|on| on.control.is_called(&control)))
    }
}
