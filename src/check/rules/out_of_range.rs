//! A number outside of the range that the control's manual prints, or a text or list longer than it may be.
//!
//! Silent where the manual prints no range. Ranges of lengths and feeds are in mm; in a program in inches the limit is
//! reported in inches.
use super::together;
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{each_refused, shown};
use crate::check::{Definition, Facts, Rule};
use crate::spec::{ParameterKind, Refusal};

pub(super) const RULE: Rule = Rule { code: "out-of-range", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    each_refused(definition, |item, param, refusal, cycle| {
        let (side, limit) = match *refusal {
            Refusal::Below(limit) => ("below", limit),
            Refusal::Above(limit) => ("above", limit),
            Refusal::TooLong(limit) if param.kind == ParameterKind::LabelList => ("many", f64::from(limit)),
            Refusal::TooLong(limit) if param.lists_axes() => ("axes", f64::from(limit)),
            Refusal::TooLong(limit) => ("long", f64::from(limit)),
            Refusal::Kind | Refusal::NotOffered => return,
        };
        let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref()).arg("cycle", cycle);
        found.push(finding.arg("side", side).arg("limit", Arg::Number(limit)).arg("value", shown(item)));
    });
}
