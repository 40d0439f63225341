//! From files to the catalogue: read trees → filter for a control → decode → resolve meanings and `like`.
//!
//! Invariant: every mistake of every file is reported; what could be read is there all the same. What each file means
//! together with the others is checked in `lint`.
use std::collections::BTreeMap;
use std::sync::Arc;

use super::catalogue::{Catalogue, Cycle, CycleKey, Field, OnControl, Outline, Param, PrintedRange};
use super::decode::{Context, Decode};
use super::filter;
use super::form::{CycleFile, Dictionary, Fragment, Meaning, Parameter};
use super::language::LanguageFile;
use super::profile::{Control, Errata, Erratum, Topic, Topics};
use super::vocabulary::{ParameterKind, Quantity};
use super::worked::Worked;
use super::yaml::{self, Node};
use crate::base::demand::{Made, OnDemand};
use crate::base::diag::{Diagnostic, Source, dedupe};
use crate::base::expr::QRef;

/// The folder of worked programs, below that of the specifications.
const PROGRAMS: &str = "programs";

/// A file as a tree.
pub(super) struct File {
    pub(super) source: Arc<Source>,
    pub(super) node: Node,
}

/// Files by the folder that says what they are.
#[derive(Default)]
struct Files {
    controls: Vec<File>,
    dictionary: Vec<File>,
    fragments: Vec<File>,
    worked: Vec<File>,
    cycles: Vec<File>,
    errata: Vec<File>,
    topics: Vec<File>,
    pages: Vec<File>,
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
            None if rest == "pages.yaml" => &mut sorted.pages,
            None if rest == "language.yaml" => &mut sorted.language,
            None => &mut sorted.errata,
            Some(("controls", _)) => &mut sorted.controls,
            Some(("parameters", _)) => &mut sorted.dictionary,
            Some(("fragments", _)) => &mut sorted.fragments,
            Some((PROGRAMS, _)) => &mut sorted.worked,
            Some(_) => &mut sorted.cycles,
        };
        list.push(File { source, node });
    }
    sorted
}

impl File {
    /// What all controls have in common.
    pub(super) fn decode<T: Decode>(&self, found: &mut Vec<Diagnostic>) -> Option<T> {
        T::decode(&self.node, &mut Context { source: &self.source, found })
    }

    /// What a control has of a part.
    pub(super) fn decode_part<T: Decode>(&self, part: &Node, control: &str, found: &mut Vec<Diagnostic>) -> Option<T> {
        T::decode(&filter::for_control(part, control), &mut Context { source: &self.source, found })
    }

    /// What a control has.
    pub(super) fn decode_for<T: Decode>(&self, control: &str, found: &mut Vec<Diagnostic>) -> Option<T> {
        self.decode_part(&self.node, control, found)
    }
}

pub(super) fn errata(file: &File, found: &mut Vec<Diagnostic>) -> Vec<Erratum> {
    file.decode::<Errata>(found).and_then(|errata| errata.errata).unwrap_or_default()
}

pub(super) fn topics(file: &File, found: &mut Vec<Diagnostic>) -> Vec<Topic> {
    file.decode::<Topics>(found).and_then(|topics| topics.topics).unwrap_or_default()
}

/// The program of a file, if the control can execute it.
pub(super) fn worked(file: &File, control: &str, found: &mut Vec<Diagnostic>) -> Option<Worked> {
    Worked::new(file.decode_for(control, found)?, control)
}

/// The meanings of dictionary files on a control.
fn meanings(files: &[File], control: &str, found: &mut Vec<Diagnostic>) -> OnDemand<String, Meaning> {
    let mut meanings = OnDemand::default();
    for file in files {
        let Some(dictionary) = file.decode_for::<Dictionary>(control, found) else { continue };
        for (name, meaning) in dictionary.parameters.0 {
            if meanings.insert(name.text.to_string(), meaning).is_some() {
                found.push(Diagnostic::error("spec-duplicate-name", name.place.clone()).arg("name", name.as_str()));
            }
        }
    }
    meanings
}

impl Catalogue {
    /// Reads all files, given as path and text with paths such as `cycle-specs/drilling/200-drilling.yaml`.
    /// Every mistake of every file is reported; what could be read is there all the same.
    pub fn load(files: &[(String, String)]) -> (Self, Vec<Diagnostic>) {
        let mut found = Vec::new();
        let files = sort_files(files, &mut found);
        let profiles: Vec<Control> = files.controls.iter().filter_map(|file| file.decode(&mut found)).collect();
        let ids: Vec<&str> = profiles.iter().map(|profile| profile.control.as_str()).collect();
        let filtered = files.dictionary.iter().chain(&files.fragments).chain(&files.worked).chain(&files.cycles);
        for file in filtered {
            filter::check(&file.node, &ids, &file.source, &mut found);
        }
        let mut catalogue = Self {
            errata: files.errata.iter().flat_map(|file| errata(file, &mut found)).collect::<Vec<_>>().into(),
            topics: files.topics.iter().flat_map(|file| topics(file, &mut found)).collect::<Vec<_>>().into(),
            pages: files.pages.first().and_then(|file| file.decode(&mut found)).into(),
            ..Self::default()
        };
        let language: Vec<LanguageFile> = files.language.iter().filter_map(|file| file.decode(&mut found)).collect();
        let (mut blocks, mut globals, mut old_cycles) = (Vec::new(), Vec::new(), Vec::new());
        for own in language {
            blocks.extend(own.blocks.unwrap_or_default());
            globals.extend(own.globals.unwrap_or_default());
            old_cycles.extend(own.old_cycles.unwrap_or_default());
        }
        (catalogue.blocks, catalogue.globals) = (blocks.into(), globals.into());
        catalogue.old_cycles = old_cycles.into();
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
        catalogue.ranges = ranges(&catalogue).into();
        dedupe(&mut found);
        (catalogue, found)
    }
}

fn load_control(profile: &Control, files: &Files, found: &mut Vec<Diagnostic>) -> OnControl {
    let id = profile.control.as_str();
    let mut on = OnControl {
        control: profile.clone(),
        cycles: OnDemand::default(),
        outlines: BTreeMap::new(),
        fragments: OnDemand::default(),
        meanings: Arc::new(meanings(&files.dictionary, id, found)),
        worked: files.worked.iter().filter_map(|file| worked(file, id, found)).collect::<Vec<_>>().into(),
        made: Made::default(),
    };
    for file in &files.fragments {
        let Some(fragment) = file.decode_for::<Fragment>(id, found) else { continue };
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
    let Some(entry) = cycle(file, control, &on.meanings, found) else { return };
    let place = entry.file.name.place.clone();
    let same_name = on.by_name(entry.name()).map(|other| other.file.name.place.clone());
    if let Some(first) = same_name.or_else(|| on.cycles.get(&entry.key).map(|other| other.file.name.place.clone())) {
        found.push(
            Diagnostic::error("spec-duplicate-cycle", place)
                .arg("cycle", entry.key.to_string())
                .arg("name", entry.name())
                .related("first-place", first),
        );
        return;
    }
    on.outlines.insert(entry.key, outline(&entry));
    on.cycles.insert(entry.key, entry);
}

/// The cycle of a file on a control, as far as it does not come from another cycle.
pub(super) fn cycle(
    file: &File,
    control: &str,
    meanings: &OnDemand<String, Meaning>,
    found: &mut Vec<Diagnostic>,
) -> Option<Cycle> {
    let filtered = filter::for_control(&file.node, control);
    let listed = filtered.get("controls").map_or(&[][..], Node::items);
    let mut cx = Context { source: &file.source, found };
    if !listed.iter().any(|item| item.get("control").and_then(Node::text) == Some(control)) {
        // Read all the same, so that a file which no control describes is still checked.
        let nobody = !listed.iter().any(|item| item.get("control").is_some());
        if nobody {
            CycleFile::decode(&filtered, &mut cx);
        }
        return None;
    }
    let cycle = CycleFile::decode(&filtered, &mut cx)?;
    let described = cycle.controls.iter().find(|d| d.control.as_str() == control).cloned()?;
    let key = CycleKey::new(cycle.keyword, cycle.cycle);
    let mut params = Vec::new();
    for parameter in &cycle.parameters {
        params.extend(resolve(parameter, None, meanings, found));
    }
    for (form, lines) in cycle.forms.iter().enumerate().map(|(index, form)| (index, &form.lines)) {
        for line in lines {
            for field in &line.fields {
                params.extend(resolve(field, Some((form, line.line, line.repeat)), meanings, found));
            }
        }
    }
    let iso =
        cycle.iso.iter().chain(cycle.forms.iter().flat_map(|form| &form.iso)).map(|iso| iso.code.clone()).collect();
    let lacking = lacking(&file.node, &params);
    Some(Cycle { key, control: control.into(), described, params, lacking, iso, file: cycle })
}

/// What the index knows of a cycle.
fn outline(cycle: &Cycle) -> Outline {
    let whole = cycle.file.iso.iter().map(|iso| (None, iso.code.clone()));
    let forms = cycle.file.forms.iter().enumerate();
    let forms = forms.flat_map(|(at, form)| form.iso.iter().map(move |iso| (Some(at), iso.code.clone())));
    Outline {
        name: cycle.name().to_owned(),
        like: cycle.file.like.as_ref().map(|like| like.as_str().to_owned()),
        codes: whole.chain(forms).collect(),
        parameters: cycle.file.parameters.iter().filter_map(|parameter| parameter.q).collect(),
    }
}

/// The ranges of all parameters.
fn ranges(catalogue: &Catalogue) -> Vec<PrintedRange> {
    let mut ranges: BTreeMap<_, (Option<(f64, f64)>, Option<f64>)> = BTreeMap::new();
    let cycles = catalogue.controls.values().flat_map(|on| on.cycles.values());
    for param in cycles.flat_map(|cycle| &cycle.params) {
        let key = (param.is.as_str(), param.kind.as_str(), param.quantity.as_str(), param.field.is_some());
        let (range, greatest) = ranges.entry(key).or_default();
        if let Some((least, most)) = param.min.zip(param.max) {
            *range = Some(range.map_or((least, most), |(from, to)| (from.min(least), to.max(most))));
        }
        *greatest = [*greatest, param.max].into_iter().flatten().reduce(f64::max);
    }
    let printed = |((meaning, kind, quantity, field), (range, greatest)): ((&str, &str, &str, bool), _)| {
        printed_range(meaning, kind, quantity, field, range, greatest)
    };
    ranges.into_iter().filter_map(printed).collect()
}

/// The same of words; nothing if they are none.
pub(super) fn printed_range(
    meaning: &str,
    kind: &str,
    quantity: &str,
    field: bool,
    range: Option<(f64, f64)>,
    greatest: Option<f64>,
) -> Option<PrintedRange> {
    let (kind, quantity) = (ParameterKind::by_word(kind)?, Quantity::by_word(quantity)?);
    Some(PrintedRange { meaning: meaning.to_owned(), kind, quantity, field, range, greatest })
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
    meanings: &OnDemand<String, Meaning>,
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
        plausible: meaning.plausible.as_ref().map_or([None; 2], |own| [own.min, own.max]),
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
            share_run(cycle, model);
        }
    }
}

/// Gives a cycle the run of another one.
pub(super) fn share_run(cycle: &mut Cycle, model: Cycle) {
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
