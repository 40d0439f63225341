//! The catalogue: every cycle of every control, resolved from the files.
//!
//! Stages: read trees → filter for a control → decode → resolve meanings and `like`. What each file
//! means together with the others is checked in `check`.
use std::collections::BTreeMap;
use std::sync::Arc;

use super::decode::{Context, Decode, Name};
use super::filter;
use super::form::{Choice, CycleFile, Described, Dictionary, Fragment, Meaning, Parameter};
use super::language::{BlockWords, Global, OldCycle, Tongue};
use super::profile::{Control, Errata, Erratum, Named, Topic, Topics};
use super::vocabulary::{Doubtful, Keyword, ParameterKind, Quantity, Reference, Shape};
use super::yaml::{self, Node};
use crate::base::diag::{Diagnostic, Place, Source, dedupe};
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
    /// The characters that a text may have besides letters, digits and blanks; nothing if it may have any.
    pub characters: Option<String>,
    /// The condition under which it acts.
    pub effective: Option<Name>,
    /// Its value on controls that lack it.
    pub neutral: Option<f64>,
    /// Its value in programs of older controls, where that is not the neutral one.
    pub imported: Option<f64>,
    /// What the control adds for it to programs of an earlier software version; empty where that is not known.
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

/// All cycles of one control.
#[derive(Clone, Debug)]
pub struct OnControl {
    /// The control.
    pub control: Control,
    /// Its cycles by key.
    pub cycles: BTreeMap<CycleKey, Cycle>,
    /// The fragments by name.
    pub fragments: BTreeMap<String, Fragment>,
    /// The dictionary.
    pub meanings: BTreeMap<String, Meaning>,
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
        self.cycles.values().find(|cycle| cycle.name() == name)
    }

    /// The printed name of a machine datum.
    pub fn datum(&self, neutral: &str) -> Option<&str> {
        self.control.data.get(neutral).map(Name::as_str)
    }
}

/// Everything that the files say.
#[derive(Clone, Debug, Default)]
pub struct Catalogue {
    /// The controls, by id in alphabetical order.
    pub controls: BTreeMap<String, OnControl>,
    /// The errata.
    pub errata: Vec<Erratum>,
    /// The topics, in the order of the overview.
    pub topics: Vec<Topic>,
    /// Blocks of the language that are no cycles; those with more words come after those with fewer.
    pub blocks: Vec<BlockWords>,
    /// What GLOBAL DEF gives.
    pub globals: Vec<Global>,
    /// Cycles of the first controls, which the ones after them still carry out.
    pub old_cycles: Vec<OldCycle>,
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
}

struct File {
    source: Arc<Source>,
    node: Node,
}

/// Files by the folder that says what they are.
#[derive(Default)]
struct Files {
    controls: Vec<File>,
    dictionary: Vec<File>,
    fragments: Vec<File>,
    cycles: Vec<File>,
    errata: Vec<File>,
    topics: Vec<File>,
    language: Vec<File>,
}

fn sort_files(files: &[(String, String)], found: &mut Vec<Diagnostic>) -> Files {
    let mut sorted = Files::default();
    for (path, text) in files {
        let Some(rest) = path.strip_prefix("cycle-specs/") else { continue };
        if !rest.ends_with(".yaml") || rest.starts_with("machines/") {
            continue;
        }
        let source = Source::new(path.clone(), text.clone());
        let Some(node) = yaml::read(&source, found) else { continue };
        let list = match rest.split_once('/') {
            None if rest == "topics.yaml" => &mut sorted.topics,
            None if rest == "language.yaml" => &mut sorted.language,
            None => &mut sorted.errata,
            Some(("controls", _)) => &mut sorted.controls,
            Some(("parameters", _)) => &mut sorted.dictionary,
            Some(("fragments", _)) => &mut sorted.fragments,
            Some(_) => &mut sorted.cycles,
        };
        list.push(File { source, node });
    }
    sorted
}

fn decode<T: Decode>(source: &Arc<Source>, node: &Node, found: &mut Vec<Diagnostic>) -> Option<T> {
    T::decode(node, &mut Context { source, found })
}

impl Catalogue {
    /// Reads all files, given as path and text with paths such as `cycle-specs/drilling/200-drilling.yaml`.
    /// Every mistake of every file is reported; what could be read is there all the same.
    pub fn load(files: &[(String, String)]) -> (Self, Vec<Diagnostic>) {
        let mut found = Vec::new();
        let files = sort_files(files, &mut found);
        let profiles: Vec<Control> =
            files.controls.iter().filter_map(|file| decode(&file.source, &file.node, &mut found)).collect();
        let ids: Vec<&str> = profiles.iter().map(|profile| profile.control.as_str()).collect();
        for file in files.dictionary.iter().chain(&files.fragments).chain(&files.cycles) {
            filter::check(&file.node, &ids, &file.source, &mut found);
        }
        let mut catalogue = Self::default();
        for file in &files.errata {
            catalogue.errata.extend(
                decode::<Errata>(&file.source, &file.node, &mut found)
                    .and_then(|errata| errata.errata)
                    .unwrap_or_default(),
            );
        }
        for file in &files.topics {
            let topics = decode::<Topics>(&file.source, &file.node, &mut found).and_then(|topics| topics.topics);
            catalogue.topics.extend(topics.unwrap_or_default());
        }
        for file in &files.language {
            let Some(tongue) = decode::<Tongue>(&file.source, &file.node, &mut found) else { continue };
            catalogue.blocks.extend(tongue.blocks.unwrap_or_default());
            catalogue.globals.extend(tongue.globals.unwrap_or_default());
            catalogue.old_cycles.extend(tongue.old_cycles.unwrap_or_default());
        }
        for profile in &profiles {
            let on_control = load_control(profile, &files, &mut found);
            if let Some(first) = catalogue.controls.insert(profile.control.text.to_string(), on_control) {
                found.push(
                    Diagnostic::error("spec-duplicate-name", profile.control.place.clone())
                        .arg("name", profile.control.as_str())
                        .related("first-place", first.control.control.place.clone()),
                );
            }
        }
        dedupe(&mut found);
        (catalogue, found)
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
            |other: &&Param| other.field.is_none() && other.kind == param.kind && other.quantity == param.quantity;
        let all =
            || self.controls.values().flat_map(|on| on.cycles.values()).flat_map(|cycle| &cycle.params).filter(alike);
        let range = |own: &Param| Some((own.min?, own.max?, None));
        let meant = all().filter(|other| other.is.as_str() == param.is.as_str()).filter_map(range).reduce(wider);
        let measures = matches!(param.quantity, Quantity::Length | Quantity::Feed | Quantity::Angle | Quantity::Time);
        let plain = measures && param.kind == ParameterKind::Number && param.choices.is_empty();
        meant.or_else(|| all().filter(|_| plain).filter_map(range).reduce(wider))
    }

    /// The cycles of a control, by its id or another of its names.
    pub fn on(&self, control: &str) -> Option<&OnControl> {
        // Ids are written in small letters; titles of controls are not.
        let control = control.to_lowercase();
        self.controls.get(&*control).or_else(|| self.controls.values().find(|on| on.control.is_called(&control)))
    }
}

fn load_control(profile: &Control, files: &Files, found: &mut Vec<Diagnostic>) -> OnControl {
    let id = profile.control.as_str();
    let mut on = OnControl {
        control: profile.clone(),
        cycles: BTreeMap::new(),
        fragments: BTreeMap::new(),
        meanings: BTreeMap::new(),
    };
    for file in &files.dictionary {
        let Some(dictionary) = decode::<Dictionary>(&file.source, &filter::for_control(&file.node, id), found) else {
            continue;
        };
        for (name, meaning) in dictionary.parameters.0 {
            if on.meanings.insert(name.text.to_string(), meaning).is_some() {
                found.push(Diagnostic::error("spec-duplicate-name", name.place.clone()).arg("name", name.as_str()));
            }
        }
    }
    for file in &files.fragments {
        let Some(fragment) = decode::<Fragment>(&file.source, &filter::for_control(&file.node, id), found) else {
            continue;
        };
        let name = fragment.fragment.clone();
        if on.fragments.insert(name.text.to_string(), fragment).is_some() {
            found.push(Diagnostic::error("spec-duplicate-name", name.place).arg("name", &*name.text));
        }
    }
    for file in &files.cycles {
        load_cycle(file, id, &mut on, found);
    }
    share_runs(&mut on, found);
    on
}

fn load_cycle(file: &File, control: &str, on: &mut OnControl, found: &mut Vec<Diagnostic>) {
    let filtered = filter::for_control(&file.node, control);
    let listed = filtered.get("controls").map_or(&[][..], Node::items);
    if !listed.iter().any(|item| item.get("control").and_then(Node::text) == Some(control)) {
        // Read all the same, so that a file which no control describes is still checked.
        let nobody = !listed.iter().any(|item| item.get("control").is_some());
        if nobody {
            decode::<CycleFile>(&file.source, &filtered, found);
        }
        return;
    }
    let Some(cycle) = decode::<CycleFile>(&file.source, &filtered, found) else { return };
    let Some(described) = cycle.controls.iter().find(|d| d.control.as_str() == control).cloned() else { return };
    let key = CycleKey::new(cycle.keyword, cycle.cycle);
    let mut params = Vec::new();
    for parameter in &cycle.parameters {
        params.extend(resolve(parameter, None, &on.meanings, found));
    }
    for (form, lines) in cycle.forms.iter().enumerate().map(|(index, form)| (index, &form.lines)) {
        for line in lines {
            for field in &line.fields {
                params.extend(resolve(field, Some((form, line.line, line.repeat)), &on.meanings, found));
            }
        }
    }
    let iso =
        cycle.iso.iter().chain(cycle.forms.iter().flat_map(|form| &form.iso)).map(|iso| iso.code.clone()).collect();
    let lacking = lacking(&file.node, &params);
    let entry = Cycle { key, control: control.into(), described, params, lacking, iso, file: cycle };
    let place = entry.file.name.place.clone();
    let same_name = on.by_name(entry.name()).map(|other| other.file.name.place.clone());
    if let Some(first) = same_name.or_else(|| on.cycles.get(&key).map(|other| other.file.name.place.clone())) {
        found.push(
            Diagnostic::error("spec-duplicate-cycle", place)
                .arg("cycle", key.to_string())
                .arg("name", entry.name())
                .related("first-place", first),
        );
        return;
    }
    on.cycles.insert(key, entry);
}

/// Parameters of the unfiltered file that this control lacks, with their neutral values.
fn lacking(node: &Node, params: &[Param]) -> Vec<(QRef, f64)> {
    let listed = node.get("parameters").map_or(&[][..], Node::items);
    let mut result: Vec<(QRef, f64)> = Vec::new();
    for item in listed {
        let q = item.get("q").and_then(Node::text).and_then(QRef::parse);
        let neutral = item.get("neutral").and_then(Node::text).and_then(|text| text.parse().ok());
        if let (Some(q), Some(neutral)) = (q, neutral)
            && !params.iter().any(|param| param.q == Some(q))
            && !result.iter().any(|(known, _)| *known == q)
        {
            result.push((q, neutral));
        }
    }
    result
}

fn resolve(
    parameter: &Parameter,
    line: Option<(usize, u32, bool)>,
    meanings: &BTreeMap<String, Meaning>,
    found: &mut Vec<Diagnostic>,
) -> Option<Param> {
    let Some(meaning) = meanings.get(parameter.is.as_str()) else {
        let place = parameter.is.place.clone();
        found.push(Diagnostic::error("spec-unknown-meaning", place).arg("name", parameter.is.as_str()));
        return None;
    };
    let ranges = parameter.ranges.as_ref().unwrap_or(&meaning.ranges);
    let words = parameter.words.as_ref().unwrap_or(&meaning.words);
    let field = line.and_then(|(form, line, repeat)| {
        Some(Field {
            form,
            line,
            repeat,
            id: parameter.id.clone()?,
            shape: parameter.shape?,
            word: parameter.word.clone(),
            incremental: parameter.incremental,
            optional: parameter.optional,
            stands_for: parameter.stands_for,
        })
    });
    if field.is_none() && (line.is_some() || parameter.q.is_none()) {
        let key = if line.is_none() {
            "q"
        } else if parameter.id.is_none() {
            "id"
        } else {
            "shape"
        };
        found.push(Diagnostic::error("spec-missing-key", parameter.is.place.clone()).arg("key", key));
        return None;
    }
    Some(Param {
        q: parameter.q,
        field,
        is: parameter.is.clone(),
        kind: parameter.kind.or(meaning.kind).unwrap_or(ParameterKind::Number),
        quantity: parameter.quantity.or(meaning.quantity).unwrap_or(Quantity::None),
        reference: parameter.reference.or(meaning.reference),
        min: ranges.first().and_then(|range| range.min),
        max: ranges.first().and_then(|range| range.max),
        max_length: ranges.first().and_then(|range| range.max_length),
        words: words.iter().map(|word| word.word.clone()).collect(),
        choices: parameter.choices.as_ref().unwrap_or(&meaning.choices).clone(),
        doubtful: parameter.doubtful.as_ref().unwrap_or(&meaning.doubtful).clone(),
        characters: meaning.characters.clone(),
        effective: parameter.effective.clone(),
        neutral: parameter.neutral,
        imported: parameter.imported,
        added: parameter.added.clone(),
        example: parameter.example.clone(),
        place: parameter.place.clone(),
    })
}

/// Gives every cycle with `like` the run of the cycle that it names.
fn share_runs(on: &mut OnControl, found: &mut Vec<Diagnostic>) {
    let followers: Vec<CycleKey> =
        on.cycles.values().filter(|cycle| cycle.file.like.is_some()).map(|cycle| cycle.key).collect();
    for key in followers {
        let Some(like) = on.cycles.get(&key).and_then(|cycle| cycle.file.like.clone()) else { continue };
        let Some(model) = on.by_name(like.as_str()).filter(|model| model.file.like.is_none()).cloned() else {
            found.push(Diagnostic::error("spec-unknown-cycle-name", like.place.clone()).arg("name", like.as_str()));
            continue;
        };
        if let Some(cycle) = on.cycles.get_mut(&key) {
            let own = &mut cycle.file;
            own.lets = model.file.lets;
            own.conditions = model.file.conditions;
            own.guards.extend(model.file.guards);
            own.doubts.extend(model.file.doubts);
            own.run = model.file.run;
            if own.results.is_empty() {
                own.results = model.file.results;
            }
            if own.tables.is_empty() {
                own.tables = model.file.tables;
            }
        }
    }
}
