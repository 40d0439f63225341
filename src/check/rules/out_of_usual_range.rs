//! A number outside of the range that another control's manual prints for the same parameter, where this control's
//! prints none; or of any manual for parameters of that meaning, or for what the parameter measures.
//!
//! What one control refuses, another one hardly takes; only the widest of those ranges counts. Silent where the
//! parameter does not act.
use std::cell::LazyCell;

use super::together;
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::guards::Written;
use crate::check::program::{number, shown};
use crate::check::{Definition, Facts, Rule};
use crate::spec::MM_PER_INCH;

pub(super) const RULE: Rule = Rule { code: "out-of-usual-range", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some((cycle, kept)) = definition.cycle().zip(definition.kept) else { return };
    let ranges = facts.against.labels.ranges_of(facts.against.catalogue, cycle, kept);
    if ranges.is_empty() {
        return;
    }
    let written = LazyCell::new(|| Written::of(facts, definition, cycle));
    for item in definition.items.iter().filter(|item| item.refusal.is_none()) {
        let Some((range, param)) = item.index.and_then(|at| ranges.get(&at)).zip(item.param) else { continue };
        let Some(number) = number(item) else { continue };
        let unit = if facts.inch && param.is_measured() { MM_PER_INCH } else { 1.0 };
        let (side, limit) = match number * unit {
            own if own < range.least => ("below", range.least),
            own if own > range.greatest => ("above", range.greatest),
            _ => continue,
        };
        if written.acts(cycle, param) == Some(false) {
            continue;
        }
        let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref()).arg("side", side);
        let finding = finding.arg("value", shown(item)).arg("limit", Arg::Number(limit / unit));
        let place = if range.control.is_some() { "control" } else { "any" };
        found.push(finding.arg("where", place).arg("control", range.control.as_deref().unwrap_or_default()));
    }
}
