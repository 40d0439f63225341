//! A cycle that the control has and its manuals here do not describe, though they name it: it is measured by the manual
//! of another control, or by none.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::CycleForm;
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "cycle-not-described", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let Known::Named(named) = definition.known else { continue };
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        let finding = finding.arg("other", other(facts, definition));
        found.push(finding.arg("name", named.name.trim()));
    }
}

/// The title of the control whose description the definition is measured by.
pub(super) fn other(facts: &Facts<'_>, definition: &Defined<'_>) -> String {
    let lines = matches!(definition.view.form, CycleForm::Lines(_));
    let other = facts.against.catalogue.describing(definition.key).filter(|(_, cycle)| cycle.is_old_style() == lines);
    other.map_or_else(|| "none".to_owned(), |(on, _)| on.control.title.clone())
}
