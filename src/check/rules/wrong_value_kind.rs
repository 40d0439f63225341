//! A value of a kind that the parameter does not take: a text instead of a number, a word that it
//! does not offer, a fraction where a whole number is needed, nothing at all.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::{each_refused, kind, shown};
use crate::check::{Definition, Facts, Item, Rule};
use crate::spec::Refusal;

pub(super) const RULE: Rule = Rule { code: "wrong-value-kind", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    each_refused(definition, |item, param, refusal, cycle| {
        if *refusal == Refusal::Kind && !is_given(facts, item) {
            let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref()).arg("cycle", cycle);
            let finding = finding.arg("kind", kind(item, param).as_str()).arg("value", shown(item));
            found.push(finding.arg("words", param.words.join(", ")).arg("words-count", param.words.len()));
        }
    });
}

/// Whether the value is that of a GLOBAL DEF of the program. The manuals list the word for some parameters only, and
/// say in general that it links any parameter to the definition of the same number.
fn is_given(facts: &Facts<'_>, item: &Item<'_>) -> bool {
    let q = item.param.and_then(|param| param.q);
    item.printed == "PREDEF" && q.is_some_and(|q| facts.given.contains_key(&q))
}
