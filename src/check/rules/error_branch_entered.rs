//! A branch for errors that good parts come to, too: the run falls into it because M30 before it is missing, or the jump
//! over a stop is taken when a tool or a workpiece is bad. Also two jumps in a row to one label that compare the
//! same parameter in the same direction with two limits: one of them says nothing.
//!
//! Such a branch is the last part of a program that nowhere ends with M2 or M30, begins with a label to which only
//! conditional jumps lead, and stops for the operator.
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::program::{each_function, is_silent, stops};
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Amount, Block, BlockKind, FnJump, Relation, StatementKind};

pub(super) const RULE: Rule = Rule { code: "error-branch-entered", severity: Severity::Warning, run };

/// The meanings of results that are 0 where all is well.
const FAULTS: [&str; 3] = ["tool-status", "status-rework", "status-scrap"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    turned(rule, facts, found);
    implied(rule, facts, found);
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    let ends = |block: &Block| stops(block) && !matches!(block.kind, BlockKind::EndPgm(_));
    if !facts.begins() || facts.flow.unread.any() || facts.flow.skips || blocks.iter().any(ends) {
        return;
    }
    let last = blocks.iter().rposition(|block| matches!(block.kind, BlockKind::Lbl(_)));
    let Some(at) = last.filter(|at| blocks.get(*at).is_some_and(|block| !block.ends_subprogram())) else { return };
    let leads = graph.uses.iter().filter(|own| own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == Some(at));
    let leads: Vec<_> = leads.collect();
    let forward = !leads.is_empty() && leads.iter().all(|own| own.way == Way::Jump && own.block < at);
    let fault = blocks.get(at..).unwrap_or_default().iter().any(halts);
    // What is between the last jump and the label is the work of a good part.
    let from = leads.iter().map(|own| own.block).max().unwrap_or(at);
    let work = blocks.get(from + 1..at).unwrap_or_default();
    let before = work.iter().rev().find(|block| !is_silent(block));
    let falls = before
        .is_some_and(|block| !halts(block) && !matches!(block.kind, BlockKind::FnJump(_)) && !block.ends_subprogram());
    let conditional = leads.iter().all(|own| match blocks.get(own.block).map(|block| &block.kind) {
        Some(BlockKind::FnJump(jump)) => jump.decided() != Some(true),
        _ => false,
    });
    if forward
        && fault
        && falls
        && conditional
        && facts.run.before(at).is_some()
        && let Some(block) = blocks.get(at)
    {
        found.push(rule.at(facts, facts.content(block)).arg("what", "entered").arg("parameter", ""));
    }
}

/// The jumps over a stop that are taken where something is wrong.
fn turned(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    for own in graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let Some(BlockKind::FnJump(jump)) = blocks.get(own.block).map(|block| &block.kind) else { continue };
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        let Some(target) = target.filter(|target| *target > own.block) else { continue };
        let mut between =
            blocks.get(own.block + 1..target).unwrap_or_default().iter().filter(|block| !is_silent(block));
        let only_stop = between.next().is_some_and(halts) && between.next().is_none();
        if let Some(name) = fault(facts, own.block, jump).filter(|_| only_stop)
            && let Some(block) = blocks.get(own.block)
        {
            found.push(rule.at(facts, facts.content(block)).arg("what", "turned").arg("parameter", name));
        }
    }
}

/// Two jumps in a row to the same label of which one says nothing: of a lower and an upper limit one comparison is
/// reversed.
fn implied(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut last: Option<&FnJump> = None;
    for block in facts.program.blocks().iter().filter(|block| !is_silent(block)) {
        let BlockKind::FnJump(jump) = &block.kind else {
            last = None;
            continue;
        };
        if let Some(before) = last.replace(jump).filter(|_| !block.skip)
            && facts.text(before.label.span) == facts.text(jump.label.span)
            && let (Some(one), Some(other)) = (limit(before), limit(jump))
            && one.0 == other.0
            && one.1 == other.1
            && one.2 != other.2
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "implied");
            return found.push(finding.arg("parameter", one.0.to_string()));
        }
    }
}

/// The parameter that a jump compares, whether it is taken above the limit, and the limit.
fn limit(jump: &FnJump) -> Option<(QRef, bool, f64)> {
    let above = match jump.relation {
        Relation::Greater => true,
        Relation::Less => false,
        _ => return None,
    };
    match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, Amount::Number(limit)) => Some((q, above, limit)),
        (Amount::Number(limit), Amount::Q { q, negative: false }) => Some((q, !above, limit)),
        _ => None,
    }
}

/// The result that says a fault where a jump is taken.
fn fault(facts: &Facts<'_>, at: usize, jump: &FnJump) -> Option<String> {
    let (Amount::Q { q, negative: false }, Amount::Number(value)) = (jump.a.amount, jump.b.amount) else { return None };
    let bad = match jump.relation {
        Relation::Equal => value != 0.0,
        Relation::NotEqual | Relation::Greater => value == 0.0,
        _ => false,
    };
    let cycle = facts.definition_before(at)?.related_cycle()?;
    let result = cycle.file.results.iter().find(|result| result.q == Some(q))?;
    (bad && FAULTS.contains(&result.is.as_str())).then(|| q.to_string())
}

/// Whether a block stops for the operator.
fn halts(block: &Block) -> bool {
    let mut stops = matches!(&block.kind, BlockKind::Stop(_));
    stops |= matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Fn(14));
    each_function(block, |number| stops |= number == 0);
    stops
}
