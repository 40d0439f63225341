//! A tool number in a contour cycle that names another tool than the one which roughs out: pilot drilling for a tool that
//! does not rough out, or a coarse tool that has not.
//!
//! Only of numbers, and where a cycle roughs out with a tool that a number calls.
use std::collections::HashSet;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::{Facts, Loaded, Pending, Rule};
use crate::program::syntax::{BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "rough-out-tool-other", severity: Severity::Warning, run };

/// The meaning of the tool for which holes are drilled, of the one that has roughed out coarsely, and of what only roughing
/// out has.
const PILOT: &str = "rough-out-tool";
const COARSE: &str = "coarse-roughing-tool";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The tools that rough out, in the order of the calls.
    let mut roughs: Vec<(usize, Loaded, f64)> = Vec::new();
    // Those of them that rough out first, and not what another tool has left.
    let mut firsts: Vec<(usize, f64)> = Vec::new();
    let mut wanted = Vec::new();
    let mut seen = HashSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { return };
        if !seen.insert((index, call.modal.loaded)) {
            continue;
        }
        let Some(own) = facts.definitions.get(index as usize) else { return };
        let Some(cycle) = own.related_cycle() else { continue };
        let (pilot, coarse) = (with_meaning(cycle, PILOT).is_some(), with_meaning(cycle, COARSE).is_some());
        if !pilot && !coarse {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let item = read.item(if pilot { PILOT } else { COARSE });
        let named = item.and_then(|item| Some((number(item)?, item.value_span)));
        wanted.extend(named.map(|(tool, span)| (call.block, call.modal.loaded, tool, span, pilot)));
        if coarse {
            let Some(tool) = tool(facts, call.modal.loaded) else { return };
            if named.is_none_or(|(coarse, _)| coarse == 0.0) {
                firsts.push((call.block, tool));
            }
            roughs.push((call.block, call.modal.loaded, tool));
        }
    }
    // What is drilled for a tool that only clears what another one has left does not serve that one, which plunges first.
    let pilots: Vec<f64> = wanted.iter().filter(|own| own.4).map(|own| own.2).collect();
    for (block, loaded, tool, span, pilot) in wanted.into_iter().filter(|(_, _, tool, ..)| *tool > 0.0) {
        // What does both with one tool call is an example, not a part.
        let other =
            |(at, own, _): &&(usize, Loaded, f64)| *own != loaded && if pilot { *at > block } else { *at < block };
        let mut own = roughs.iter().filter(other).peekable();
        let Some((.., first)) = own.peek().copied().copied() else { continue };
        let first = firsts.iter().find(|(at, _)| pilot && *at > block).map_or(first, |(_, own)| *own);
        let in_vain = pilot && first != tool && !pilots.contains(&first) && !firsts.iter().any(|(_, own)| *own == tool);
        if in_vain || own.all(|(.., own)| *own != tool) {
            let finding = rule.at(facts, span).arg("what", if pilot { "pilot" } else { "coarse" });
            found.push(finding.arg("value", Arg::Number(tool)).arg("other", Arg::Number(first)));
        }
    }
}

/// The number of the tool in the spindle.
fn tool(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    let Loaded::By(block) = loaded else { return None };
    let BlockKind::ToolCall(call) = &facts.program.blocks().get(block as usize)?.kind else { return None };
    match call.tool? {
        ToolRef::Number(operand) => facts.number(&operand),
        ToolRef::Name(_) => None,
    }
}
