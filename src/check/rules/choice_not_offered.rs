//! A number that is none of the choices which the parameter offers.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::{each_refused, shown};
use crate::check::{Definition, Facts, Rule};
use crate::spec::Refusal;

pub(super) const RULE: Rule = Rule { code: "choice-not-offered", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    each_refused(definition, |item, param, refusal, cycle| {
        if *refusal == Refusal::NotOffered {
            let offered: Vec<&str> = param.choices.iter().map(|choice| choice.value.as_str()).collect();
            let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref()).arg("cycle", cycle);
            found.push(finding.arg("offered", offered.join(", ")).arg("value", shown(item)));
        }
    });
}
