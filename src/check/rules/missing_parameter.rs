//! Parameters or fields that the cycle needs and the definition lacks: one finding for all that are missed at a place.
//!
//! Of the old form it is reported where the field would be, be it after the gap that a lost line leaves. What the
//! control adds itself to programs of earlier versions is distinguished (`older-parameter-set`).
//!
//! Silent where a line of the definition cannot be read: it may be the one that is missed.
use super::together;
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Definition, Facts, Rule};
use crate::program::syntax::CycleForm;
use crate::spec::Param;

pub(super) const RULE: Rule = Rule { code: "missing-parameter", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.torn {
        return;
    }
    let mut missed: Vec<(Span, Vec<String>)> = Vec::new();
    for param in definition.missing.iter().filter(|param| param.supplied().is_none()) {
        let (place, name) = (gap(definition, param), param.label_in(definition.key.number));
        match missed.iter_mut().find(|(own, _)| *own == place) {
            Some((_, names)) => names.push(name),
            None => missed.push((place, vec![name])),
        }
    }
    for (place, names) in missed {
        let finding = rule.at(facts, place).arg("parameter", names.join(", "));
        found.push(finding.arg("count", names.len()).arg("cycle", definition.key.to_string()));
    }
}

/// Where a parameter is missed: of the old form on the line on which its field would be; where that line is lost, on
/// the one after the gap, and at the end on the last one.
pub(super) fn gap(definition: &Definition<'_>, param: &Param) -> Span {
    let (CycleForm::Lines(lines), Some(field)) = (&definition.view.form, &param.field) else {
        return definition.view.head;
    };
    let after = lines.iter().filter(|line| line.line >= field.line).min_by_key(|line| line.line);
    after.or(lines.last()).map_or(definition.view.head, |line| line.head)
}
