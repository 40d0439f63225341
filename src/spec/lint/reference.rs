//! References between files: controls, sources, cycles, options, machine data, errata.
use std::collections::{BTreeMap, BTreeSet};

use super::super::catalogue::{Catalogue, Cycle, CycleKey, Known, OnControl};
use super::super::decode::Name;
use super::super::form::ManualLines;
use super::super::vocabulary::{Group, Keyword};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{Expr, Node, QRef};

/// `10`, `10-20` and lists of them with commas; ends in order.
fn lines_are_well_formed(lines: &str) -> bool {
    lines.split(',').all(|part| {
        let mut ends = part.trim().splitn(2, '-').map(|end| end.trim().parse::<u32>());
        match (ends.next(), ends.next()) {
            (Some(Ok(first)), Some(Ok(last))) => first > 0 && first <= last,
            (Some(Ok(first)), None) => first > 0,
            _ => false,
        }
    })
}

fn source(lines: &ManualLines, on: &OnControl, found: &mut Vec<Diagnostic>) {
    if !lines_are_well_formed(&lines.lines) {
        found.push(Diagnostic::error("spec-lines-form", lines.place.clone()).arg("lines", lines.lines.as_str()));
    }
    if !on.control.manuals.contains(&lines.manual) {
        found.push(
            Diagnostic::error("spec-foreign-manual", lines.place.clone())
                .arg("manual", lines.manual.as_str())
                .arg("control", on.id()),
        );
    }
}

pub(super) fn cycle(cycle: &Cycle, on: &OnControl, found: &mut Vec<Diagnostic>) {
    let described = &cycle.described;
    if described.sources.is_empty() {
        found.push(Diagnostic::error("spec-no-source", described.place.clone()));
    }
    described.sources.iter().for_each(|lines| source(lines, on, found));
    for option in &described.options {
        if !on.control.options.iter().any(|known| known.number == *option) {
            found.push(
                Diagnostic::error("spec-unknown-option", described.place.clone())
                    .arg("option", *option as usize)
                    .arg("control", on.id()),
            );
        }
    }
    for see in &cycle.file.see {
        let key = CycleKey::new(see.keyword, see.cycle);
        if matches!(on.known(key), Known::Unknown) {
            found.push(unknown_cycle(see.place.clone(), key, on));
        }
    }
    super::names::duplicates(cycle.file.notes.iter().map(|note| &note.note), found);
    cycle.file.notes.iter().for_each(|note| super::names::slug(&note.note, found));
    for result in &cycle.file.results {
        super::names::slug(&result.is, found);
        let chosen = result.field.as_ref().is_some_and(|id| {
            cycle.params.iter().any(|param| param.field.as_ref().is_some_and(|field| field.id == *id))
        });
        if result.q.is_some() == result.field.is_some() || (result.field.is_some() && !chosen) {
            found.push(Diagnostic::error("spec-result-target", result.place.clone()).arg("name", result.is.as_str()));
        }
        if let Some(q) = result.of
            && cycle.param(q).is_none()
        {
            found.push(
                Diagnostic::error("spec-unknown-parameter", result.place.clone())
                    .arg("name", q.to_string())
                    .arg("cycle", cycle.key.to_string()),
            );
        }
    }
    for doubt in &cycle.file.doubts {
        let has = |q: QRef| {
            let stands =
                |param: &super::super::catalogue::Param| param.field.as_ref().and_then(|field| field.stands_for);
            // Contour cycles also read the data that they share.
            let shared = cycle.file.group == Group::Contours && (1..=20).contains(&q.number);
            shared || cycle.params.iter().any(|param| param.q == Some(q) || stands(param) == Some(q))
        };
        let unknown = doubt.when.expr.q_refs().into_iter().chain([doubt.about]).find(|q| !has(*q));
        let named = expr_names(&doubt.when.expr);
        if let Some(name) = unknown.map(|q| q.to_string()).or(named) {
            let unknown = Diagnostic::error("spec-unknown-parameter", doubt.when.place.clone());
            found.push(unknown.arg("name", name).arg("cycle", cycle.key.to_string()));
        }
        super::names::slug(&doubt.code, found);
    }
    for guard in &cycle.file.guards {
        if let Some(datum) = &guard.switched_off_by
            && on.datum(datum.as_str()).is_none()
        {
            found.push(unknown_datum(datum.place.clone(), datum.as_str(), on));
        }
    }
}

/// What doubts may ask besides parameters: whether the tool axis is another one than Z, whether the plane is tilted, and
/// what the tool table says.
const ASKED: [[&str; 2]; 6] = [
    ["active", "other_axis"],
    ["active", "tilting"],
    ["tool", "radius"],
    ["tool", "lcuts"],
    ["tool", "pitch"],
    ["tool", "speed"],
];

/// The first name in a formula of a doubt that it cannot read.
fn expr_names(expr: &Expr) -> Option<String> {
    let mut first = None;
    expr.walk(&mut |expr| {
        if let (Node::Name(path), None) = (&expr.node, &first)
            && !ASKED.iter().any(|own| path == own)
        {
            first = Some(path.join("."));
        }
    });
    first
}

pub(super) fn unknown_cycle(place: Place, key: CycleKey, on: &OnControl) -> Diagnostic {
    Diagnostic::error("spec-unknown-cycle", place).arg("cycle", key.to_string()).arg("control", on.id())
}

fn unknown_datum(place: Place, datum: &str, on: &OnControl) -> Diagnostic {
    Diagnostic::error("spec-unknown-datum", place).arg("name", datum).arg("control", on.id())
}

pub(super) fn control(on: &OnControl, found: &mut Vec<Diagnostic>) {
    let named = &on.control.named;
    for (index, entry) in named.iter().enumerate() {
        let same =
            |other: &&super::super::profile::Named| other.keyword == entry.keyword && other.number == entry.number;
        if let Some(first) = named[..index].iter().find(same) {
            found.push(
                Diagnostic::error("spec-duplicate-cycle", entry.place.clone())
                    .arg("cycle", CycleKey::new(entry.keyword, entry.number).to_string())
                    .arg("name", entry.name.as_str())
                    .related("first-place", first.place.clone()),
            );
        }
        if !lines_are_well_formed(&entry.source.lines) {
            found.push(
                Diagnostic::error("spec-lines-form", entry.source.place.clone())
                    .arg("lines", entry.source.lines.as_str()),
            );
        }
    }
    for (table, _) in &on.control.files.0 {
        if !on.cycles.values().flat_map(|cycle| &cycle.file.tables).any(|used| used.table == *table) {
            found.push(super::names::unused_name(table.as_str(), table.place.clone()));
        }
    }
    super::names::duplicates(on.control.data.0.iter().map(|(name, _)| name), found);
}

/// Entries of the errata name controls and cycles that exist, and no id twice.
pub(super) fn errata(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    super::names::duplicates(catalogue.errata.iter().map(|entry| &entry.id), found);
    for entry in catalogue.errata.iter() {
        super::names::slug(&entry.id, found);
        let on = match &entry.control {
            Some(control) => match catalogue.on(control.as_str()) {
                Some(on) => Some(on),
                None => {
                    found.push(unknown_control(control, catalogue));
                    continue;
                }
            },
            None => None,
        };
        if let Some(cycle) = &entry.cycle {
            let key = key_of(cycle.as_str());
            let known = key.is_some_and(|key| match on {
                Some(on) => !matches!(on.known(key), Known::Unknown),
                None => catalogue.controls.values().any(|on| !matches!(on.known(key), Known::Unknown)),
            });
            if !known {
                found.push(
                    Diagnostic::error("spec-unknown-cycle", cycle.place.clone())
                        .arg("cycle", cycle.as_str())
                        .arg("control", entry.control.as_ref().map_or("", |control| control.as_str())),
                );
            }
        }
        if let Some(lines) = &entry.lines
            && !lines_are_well_formed(lines)
        {
            found.push(Diagnostic::error("spec-lines-form", entry.place.clone()).arg("lines", lines.as_str()));
        }
    }
}

/// Topics name controls that exist and lines of their manuals, and no id twice.
pub(super) fn topics(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    super::names::duplicates(catalogue.topics.iter().map(|topic| &topic.topic), found);
    for topic in catalogue.topics.iter() {
        super::names::slug(&topic.topic, found);
        for covered in &topic.controls {
            match catalogue.on(covered.control.as_str()) {
                Some(_) if covered.sources.is_empty() => {
                    found.push(Diagnostic::error("spec-no-source", covered.place.clone()));
                }
                Some(on) => covered.sources.iter().for_each(|lines| source(lines, on, found)),
                None => found.push(unknown_control(&covered.control, catalogue)),
            }
        }
    }
}

/// Every note of a cycle has one section, and what is listed there is a note of a cycle; themes lead to topics.
pub(super) fn pages(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    let Some(pages) = catalogue.pages.as_ref() else { return };
    let cycles = || catalogue.controls.values().flat_map(|on| on.cycles.values());
    let used: BTreeMap<&str, &Name> =
        cycles().flat_map(|cycle| &cycle.file.notes).map(|note| (note.note.as_str(), &note.note)).collect();
    let listed = || pages.sections.iter().flat_map(|section| &section.notes);
    super::names::duplicates(listed(), found);
    super::names::duplicates(pages.themes.iter().flat_map(|theme| &theme.notes), found);
    for name in listed().chain(pages.themes.iter().flat_map(|theme| &theme.notes)) {
        if !used.contains_key(name.as_str()) {
            found.push(Diagnostic::error("spec-unused", name.place.clone()).arg("name", name.as_str()));
        }
    }
    let known: BTreeSet<&str> = listed().map(Name::as_str).collect();
    for (name, note) in used {
        if !known.contains(name) {
            found.push(Diagnostic::error("spec-note-without-section", note.place.clone()).arg("note", name));
        }
    }
    for topic in pages.themes.iter().filter_map(|theme| theme.topic.as_ref()) {
        if !catalogue.topics.iter().any(|own| own.topic.as_str() == topic.as_str()) {
            found.push(Diagnostic::error("spec-unknown-topic", topic.place.clone()).arg("topic", topic.as_str()));
        }
    }
}

fn unknown_control(control: &Name, catalogue: &Catalogue) -> Diagnostic {
    let known: Vec<&str> = catalogue.controls.keys().map(String::as_str).collect();
    Diagnostic::error("spec-unknown-control", control.place.clone())
        .arg("control", control.as_str())
        .arg("known", known.join(", "))
}

/// Reads `CYCL DEF 200` or `TCH PROBE 412`.
fn key_of(text: &str) -> Option<CycleKey> {
    let (keyword, number) = text.rsplit_once(' ')?;
    Some(CycleKey::new(Keyword::by_word(keyword)?, number.parse().ok()?))
}
