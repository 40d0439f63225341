//! A GLOBAL DEF that does not exist, that lacks a parameter, has a foreign or doubled one or a value that no cycle
//! takes, or that gives other values before a cycle has used the ones given before;
//! PREDEF for a parameter that no GLOBAL DEF gives.
//!
//! What each gives is in the file of the language. PREDEF is passed over in parts of programs, which others may
//! precede.
use std::collections::{BTreeMap, BTreeSet};

use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::refused_by_all;
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, CycleForm, GlobalDef, ValueKind};
use crate::spec::CycleKey;

pub(super) const RULE: Rule = Rule { code: "global-def-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.against.catalogue.globals.is_empty() {
        return;
    }
    let mut last: BTreeMap<u32, usize> = BTreeMap::new();
    for (index, block) in facts.marked() {
        let BlockKind::GlobalDef(own) = &block.kind else { continue };
        one(rule, facts, own, found);
        if let Some(before) = last.insert(own.number, index) {
            let used = facts.definition_before(index).is_some_and(|cycle| before <= cycle.view.first);
            if !used && !facts.flow.jumps && !facts.flow.programs {
                report(rule, facts, own.head, "again", own, "", found);
            }
        }
    }
    if !facts.begins() || !facts.calls.is_empty() || facts.flow.programs || !mentions_it(facts) {
        return;
    }
    for definition in &facts.definitions {
        let CycleForm::Parameters(written) = &definition.view.form else { continue };
        for parameter in written.parameters.iter().filter(|own| own.value.kind == ValueKind::Word) {
            if !matches!(facts.text(parameter.value.span), "PREDEF" | "predef") {
                continue;
            }
            let what = match facts.given.get(&parameter.q) {
                None => "nothing",
                // A part of the program that is called may be anywhere.
                Some(first) if *first > definition.view.first && !facts.flow.jumps => "later",
                Some(_) => continue,
            };
            let finding = rule.at(facts, parameter.value.span).arg("what", what).arg("number", 0);
            let key: CycleKey = definition.key;
            let finding = finding.arg("parameter", parameter.q.to_string()).arg("value", key.to_string());
            let severity = if what == "nothing" { Severity::Error } else { rule.severity };
            found.push(Diagnostic { severity, ..finding });
        }
    }
}

/// Whether the program has the word at all.
fn mentions_it(facts: &Facts<'_>) -> bool {
    let text = facts.program.source().text().as_bytes();
    ["PREDEF", "predef"].iter().any(|word| memmem::find(text, word.as_bytes()).is_some())
}

fn report(
    rule: &Rule,
    facts: &Facts<'_>,
    span: Span,
    what: &str,
    own: &GlobalDef,
    parameter: &str,
    found: &mut Vec<Diagnostic>,
) {
    let finding = rule.at(facts, span).arg("what", what).arg("number", own.number as usize);
    let value = if what == "value" { facts.text(span).trim() } else { "" };
    found.push(finding.arg("parameter", parameter).arg("value", value));
}

fn one(rule: &Rule, facts: &Facts<'_>, own: &GlobalDef, found: &mut Vec<Diagnostic>) {
    let Some(known) = facts.against.catalogue.globals.iter().find(|known| known.number == own.number) else {
        return report(rule, facts, own.head, "unknown", own, "", found);
    };
    let mut written = BTreeSet::new();
    for parameter in &own.parameters {
        let name = parameter.q.to_string();
        if !written.insert(parameter.q) {
            report(rule, facts, parameter.span, "twice", own, &name, found);
        } else if !known.parameters.contains(&parameter.q) {
            report(rule, facts, parameter.span, "foreign", own, &name, found);
        } else {
            let offered = match parameter.value.kind {
                ValueKind::Number(number) if !known.values.is_empty() => known.values.contains(&number),
                ValueKind::Number(_) => refused_by_all(facts, parameter.q, parameter, None, 1) != Some(true),
                ValueKind::Missing | ValueKind::Text(_) => false,
                _ => true,
            };
            if !offered {
                report(rule, facts, parameter.value.span, "value", own, &name, found);
            }
        }
    }
    if own.errors.is_empty() && !own.parameters.is_empty() {
        for q in known.parameters.iter().filter(|q| !written.contains(*q)) {
            report(rule, facts, own.head, "missing", own, &q.to_string(), found);
        }
    }
}
