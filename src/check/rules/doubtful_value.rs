//! A value that no control refuses and hardly anybody means: a plunging depth of 0, a milling depth above the surface, a
//! dwell of minutes, a feed of less than a millimetre a minute.
//!
//! Which values those are the dictionary of the parameters says. Silent where the parameter does not act, and where
//! something worse is reported of it.
use std::cell::LazyCell;

use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::guards::Written;
use crate::check::program::{number, shown};
use crate::check::{Definition, Facts, Rule};
use crate::spec::{Doubtful, MM_PER_INCH, Param, Quantity};

pub(super) const RULE: Rule = Rule { code: "doubtful-value", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some(cycle) = definition.cycle() else { return };
    let written = LazyCell::new(|| Written::of(facts, definition, cycle));
    for item in definition.items.iter().filter(|item| item.refusal.is_none()) {
        let Some((param, value)) = item.param.zip(number(item)) else { continue };
        let is = if value == 0.0 {
            Doubtful::Zero
        } else if value < 0.0 {
            Doubtful::Negative
        } else {
            Doubtful::Positive
        };
        let is = if param.doubtful.contains(&is) { Some(is.as_str()) } else { extreme(facts, param, value) };
        let Some(is) = is.filter(|_| written.acts(cycle, param) != Some(false)) else { continue };
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
        found.push(finding.arg("is", is).arg("value", shown(item)).arg("cycle", definition.key.to_string()));
    }
}

/// Whether a value is smaller or larger than anybody means. A small feed may be one of a revolution.
fn extreme(facts: &Facts<'_>, param: &Param, value: f64) -> Option<&'static str> {
    let scaled = matches!(param.quantity, Quantity::Length | Quantity::Feed);
    let value = if facts.inch && scaled { value * MM_PER_INCH } else { value };
    let [min, max] = param.plausible;
    let small = min.is_some_and(|min| value != 0.0 && value < min);
    if small && (param.quantity != Quantity::Feed || !facts.flow.per_revolution) {
        Some("small")
    } else if max.is_some_and(|max| value > max) {
        Some("large")
    } else {
        None
    }
}

/// So many findings one definition may have that are looked through.
const RECENT: usize = 64;
