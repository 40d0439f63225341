//! A value of the old form without the word that controls print before it: `CYCL DEF 9.1 5`.
//!
//! Only where the line can have no other value, so that its meaning is clear.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Rule};
use crate::program::syntax::CycleForm;
use crate::spec::Shape;

pub(super) const RULE: Rule = Rule { code: "field-word-missing", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if matches!(definition.view.form, CycleForm::Parameters(_)) {
        return;
    }
    let Some(labels) = facts.labels(definition) else { return };
    for item in definition.items.iter().filter(|item| item.label.is_none()) {
        let Some((index, field)) = item.index.zip(item.param.and_then(|param| param.field.as_ref())) else { continue };
        if field.shape != Shape::Labelled {
            continue;
        }
        let own = facts.language.as_deref().unwrap_or(facts.against.on.control.language.as_str());
        let word = labels.language(own).and_then(|own| own.params.get(index)).and_then(|own| own.label.as_deref());
        let shown = format!("{} {} {}", item.name, word.unwrap_or_default(), item.printed);
        found.push(rule.at(facts, item.span).arg("shown", shown.split_whitespace().collect::<Vec<_>>().join(" ")));
    }
}
