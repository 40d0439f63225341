//! A value that no control refuses and hardly anybody means: a plunging depth of 0, a milling depth above the surface.
//!
//! Which values those are the dictionary of the parameters says. Silent where the parameter does not act, and where
//! something worse is reported of it.
use std::cell::LazyCell;

use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::guards::Written;
use crate::check::program::{number, shown};
use crate::check::{Definition, Facts, Rule};
use crate::spec::Doubtful;

pub(super) const RULE: Rule = Rule { code: "doubtful-value", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some(cycle) = definition.cycle() else { return };
    let written = LazyCell::new(|| Written::of(facts, definition, cycle));
    for item in definition.items.iter().filter(|item| item.refusal.is_none()) {
        let Some(param) = item.param.filter(|param| !param.doubtful.is_empty()) else { continue };
        let is = match number(item) {
            Some(number) if number < 0.0 => Doubtful::Negative,
            Some(number) if number > 0.0 => Doubtful::Positive,
            Some(0.0) => Doubtful::Zero,
            _ => continue,
        };
        if !param.doubtful.contains(&is) || written.acts(cycle, param) == Some(false) {
            continue;
        }
        // Findings of this definition about the same place come before.
        let written = |own: &Diagnostic| {
            own.place
                .as_ref()
                .is_some_and(|place| item.span.start <= place.span.start && place.span.end <= item.span.end)
        };
        if found.iter().rev().take(RECENT).any(written) {
            continue;
        }
        let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
        found.push(finding.arg("is", is.as_str()).arg("value", shown(item)).arg("cycle", definition.key.to_string()));
    }
}

/// So many findings one definition may have that are looked through.
const RECENT: usize = 64;
