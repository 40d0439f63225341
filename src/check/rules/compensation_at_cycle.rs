//! A cycle that is called, a touch-probe cycle, or PLANE, while radius compensation is certainly active.
//!
//! Cycles compensate for the tool themselves and want R0 where they begin. Reported once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Defined, Facts, Pending, Rule, Tri};
use crate::program::syntax::{BlockKind, StatementKind};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "compensation-at-cycle", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calls =
        facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Compensation) == Tri::Yes).filter_map(|call| {
            let definition = match call.modal.pending {
                Pending::Definition(index) => facts.definitions.get(index as usize),
                Pending::Unknown => before(facts, call.block),
                Pending::None => None,
            };
            Some((call.span, definition?))
        });
    let probes = facts.definitions.iter().filter(|own| own.key.keyword == Keyword::TchProbe).filter_map(|own| {
        let active = facts.run.before(own.view.first)?.is(Aspect::Compensation) == Tri::Yes;
        active.then_some((own.view.head, own))
    });
    if let Some((span, definition)) = calls.chain(probes).min_by_key(|(span, _)| span.start) {
        found.push(rule.at(facts, span).arg("cycle", definition.key.to_string()));
    }
    for (index, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        let tilts = own.kind == StatementKind::Plane;
        if tilts && facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes) {
            let name = facts.text(own.head).split_ascii_whitespace().collect::<Vec<_>>().join(" ");
            found.push(rule.at(facts, facts.content(block)).arg("cycle", name));
            break;
        }
    }
}

/// The definition before a call of a cycle that is not described, where the order of the text is that of the run.
fn before<'f, 'a>(facts: &'f Facts<'a>, block: usize) -> Option<&'f Defined<'a>> {
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.anything {
        return None;
    }
    let own = facts.definition_before(block)?;
    let machines = own.key.keyword == Keyword::CyclDef && (200..300).contains(&own.key.number);
    machines.then_some(own)
}
