//! A cycle that no manual of the specifications names and that is not the machine builder's. A warning: controls have
//! cycles of other software versions, of which the manuals here do not speak.
use super::cycle_not_on_control::elsewhere;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::CycleForm;
use crate::spec::{CycleKey, Keyword, Known, OldCycle};

pub(super) const RULE: Rule = Rule { code: "unknown-cycle", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        if !matches!(definition.known, Known::Unknown) {
            continue;
        }
        let covered = facts.against.on.covers(definition.key) && elsewhere(facts, definition.key).is_empty();
        if covered || has_other_keyword(facts, definition) {
            let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
            // Those of the first controls still run.
            let is_it = |own: &&OldCycle| own.number == definition.key.number;
            let old = facts.against.catalogue.old_cycles.iter().find(is_it);
            let old = old.filter(|_| definition.key.keyword == Keyword::CyclDef);
            let severity = if old.is_some() { Severity::Note } else { rule.severity };
            let name = old.map_or("none", |own| own.name.as_str());
            found.push(Diagnostic { severity, ..finding.arg("name", name) });
        }
    }
}

/// Whether the control has a cycle of that number under the other keyword, and this definition is written like it. In
/// the old form both keywords have cycles of the same numbers.
pub(super) fn has_other_keyword(facts: &Facts<'_>, definition: &Defined<'_>) -> bool {
    let other = match definition.key.keyword {
        Keyword::CyclDef => Keyword::TchProbe,
        Keyword::TchProbe => Keyword::CyclDef,
    };
    let known = facts.against.on.known(CycleKey::new(other, definition.key.number));
    let new = matches!(definition.view.form, CycleForm::Parameters(_));
    new && matches!(known, Known::Described(cycle) if !cycle.is_old_style())
}
