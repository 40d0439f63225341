//! A machining cycle, or one that measures the tool, with tool 0 in the spindle.
//!
//! TOOL CALL 0 empties the spindle: there is nothing that could cut or be measured. A touch probe may be called as tool 0
//! (TNC 426/430, 003: 1578), so cycles that probe the workpiece are passed over. Reported once for a tool call, where the
//! number is certain.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::{Defined, Facts, Loaded, Pending, Rule};
use crate::program::syntax::{BlockKind, ToolRef};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "tool-zero", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calls = facts.run.calls.iter().filter_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.related_cycle().is_some_and(removes_material).then_some((call.span, call.modal.loaded, own))
    });
    let measures =
        |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::ToolMeasurement);
    let measured = facts.definitions.iter().filter(measures).filter_map(|own| {
        let modal = facts.run.before(own.view.first)?;
        Some((own.view.head, modal.loaded, own))
    });
    let mut all: Vec<_> = calls.chain(measured).filter(|(_, loaded, _)| is_zero(facts, *loaded)).collect();
    all.sort_by_key(|(span, ..)| span.start);
    let mut said = BTreeSet::new();
    for (span, loaded, own) in all {
        if let Loaded::By(block) = loaded
            && said.insert(block)
        {
            found.push(rule.at(facts, span).arg("cycle", own.key.to_string()));
        }
    }
}

/// Whether the tool in the spindle is certainly none.
fn is_zero(facts: &Facts<'_>, loaded: Loaded) -> bool {
    let Loaded::By(block) = loaded else { return false };
    let Some(BlockKind::ToolCall(call)) = facts.program.blocks().get(block as usize).map(|block| &block.kind) else {
        return false;
    };
    matches!(call.tool, Some(ToolRef::Number(number)) if facts.number(&number) == Some(0.0))
}
