//! A measurement that corrects or monitors a tool which has not machined before: the number belongs to another tool.
//!
//! In the order of the text: no call of that tool comes before the measurement, but calls of others do. Silent where a
//! parameter or a name calls a tool, where subprograms call tools or other programs are called, and in what comes after the
//! end of the main part.
use std::collections::BTreeSet;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "monitored-tool-idle", severity: Severity::Warning, run };

/// The meaning of the tool that a measurement corrects.
const MONITORED: &str = "monitored-tool";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let measures = |own: &&crate::check::Defined<'_>| {
        own.related_cycle().is_some_and(|cycle| with_meaning(cycle, MONITORED).is_some())
    };
    let mut measurements = facts.definitions.iter().filter(measures).peekable();
    if measurements.peek().is_none() || facts.flow.programs || facts.flow.unread.any() || !facts.begins() {
        return;
    }
    let mut called: BTreeSet<u64> = BTreeSet::new();
    // Tools that were called with a speed.
    let mut machining = false;
    let mut ended = false;
    let mut open = Vec::new();
    for (index, block) in facts.marked() {
        while let Some(own) = measurements.next_if(|own| own.view.first < index) {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let Some(item) = read.item(MONITORED) else { continue };
            let Some(tool) = number(item).filter(|tool| *tool > 0.0) else { continue };
            if machining && !ended && !called.contains(&tool.to_bits()) {
                open.push((item.value_span, tool, own.key));
            }
        }
        if let BlockKind::ToolCall(call) = &block.kind
            && let Some(tool) = call.tool
        {
            let ToolRef::Number(operand) = tool else { return };
            let Some(tool) = facts.number(&operand) else { return };
            if ended {
                return;
            }
            called.insert(tool.to_bits());
            machining |= call.speed.is_some() && tool > 0.0;
        }
        ended |= facts.ends(block);
    }
    for (span, tool, key) in open {
        let finding = rule.at(facts, span).arg("tool", Arg::Number(tool));
        found.push(finding.arg("cycle", key.to_string()));
    }
}
