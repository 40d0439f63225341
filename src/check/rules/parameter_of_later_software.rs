//! Parameters of a cycle that a later software version of the control added: the manual here does not have them.
//!
//! A note where the software version of the control is not given; nothing where it has them. One finding a definition.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::{Definition, Facts, Item, Rule};
use crate::spec::Since;

pub(super) const RULE: Rule = Rule { code: "parameter-of-later-software", severity: Severity::Note, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.in_order || definition.cycle().is_none() {
        return;
    }
    let later = definition.items.iter().filter(|item| since(facts, definition, item) == Since::Later);
    let later: Vec<&Item<'_>> = later.collect();
    let Some(first) = later.first() else { return };
    let names: Vec<&str> = later.iter().map(|item| item.name.as_ref()).collect();
    let finding = rule.at(facts, first.span).arg("cycle", definition.key.to_string());
    let software = facts.against.on.control.software.clone().unwrap_or_default();
    found.push(finding.arg("parameter", names.join(", ")).arg("count", names.len()).arg("software", software));
}

/// What the software of the control knows of a parameter that the manual does not have.
pub(super) fn since(facts: &Facts<'_>, definition: &Definition<'_>, item: &Item<'_>) -> Since {
    let Some(q) = QRef::parse(&item.name).filter(|_| item.param.is_none()) else { return Since::Never };
    let (keyword, number) = (definition.key.keyword, definition.key.number);
    facts.against.on.control.since(keyword, number, q, facts.against.software)
}
