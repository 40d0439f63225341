//! A cycle that a manual forbids while a transformation is active, defined while it certainly is.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::aspect_of;
use crate::check::{Facts, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "transformation-forbidden", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let Some(cycle) = definition.related_cycle().filter(|cycle| !cycle.file.refuses.is_empty()) else { continue };
        let Some(modal) = facts.run.before(definition.view.first) else { continue };
        let is_active = |name: &&crate::spec::RefusedState| {
            aspect_of(name.state.as_str()).is_some_and(|aspect| modal.is(aspect) == Tri::Yes)
        };
        if let Some(own) = cycle.file.refuses.iter().find(is_active) {
            let what = own.state.as_str().replace('_', "-");
            let finding = rule.at(facts, definition.view.head).arg("what", what);
            found.push(finding.arg("cycle", definition.key.to_string()));
        }
    }
}
