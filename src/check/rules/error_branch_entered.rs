//! A branch for errors that good parts come to, too: the run falls into it because M30 before it is missing, or the jump
//! over a stop is taken when a tool or a workpiece is bad. Also two jumps in a row to one label that compare the
//! same parameter in the same direction with two limits: one of them says nothing. And a jump whose condition does not
//! fit its branch: its label, a comment there or a stop says for which parts or tools that is. Also a jump that asks for
//! the fault of a tool which the cycle measures anew and compares with nothing, and one to a branch that ends in an error
//! message, whose condition holds with the numbers of the program and the radius of the tool.
//!
//! Such a branch is the last part of a program that nowhere ends with M2 or M30, begins with a label to which only
//! conditional jumps lead, and stops for the operator.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{Expr, Node, Op, QKind, QRef};
use crate::check::outcomes::{Purpose, Taken, begins_with_stop, halts, measurement, purpose, taken};
use crate::check::program::{is_silent, number, reads, stops};
use crate::check::tools::Tools;
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Amount, Block, BlockKind, FnJump, FnOp, Operand, Relation, StatementKind};

pub(super) const RULE: Rule = Rule { code: "error-branch-entered", severity: Severity::Warning, run };

/// The meanings of whether a tool is checked, and of what that says.
const CHECK: &str = "tool-check";
const STATUS: &str = "tool-status";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    turned(rule, facts, found);
    implied(rule, facts, found);
    unfit(rule, facts, found);
    unchecked(rule, facts, found);
    always(rule, facts, found);
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
        let rest = |block: &&Block| !is_silent(block) && (halts(block) || !matches!(block.kind, BlockKind::Motion(_)));
        let mut between = blocks.get(own.block + 1..target).unwrap_or_default().iter().filter(rest);
        let only_stop = between.next().is_some_and(halts) && between.next().is_none();
        let never_good = |own: &Taken| own.outcomes[0] == Some(false);
        if only_stop
            && let Some(result) = taken(facts, own.block, jump).filter(never_good)
            && let Some(block) = blocks.get(own.block)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "turned");
            found.push(finding.arg("parameter", result.q.to_string()));
        }
    }
}

/// The jumps to an error message that are always taken. A number that is 0 may still have to be entered.
fn always(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    let mut tools = None;
    for own in graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let Some(block) = blocks.get(own.block).filter(|block| !block.skip) else { continue };
        let BlockKind::FnJump(jump) = &block.kind else { continue };
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark)).filter(|target| *target > own.block);
        let grows = matches!(jump.relation, Relation::Less | Relation::Greater) && jump.decided().is_none();
        if !grows || !target.is_some_and(|target| is_error(blocks, target)) || facts.run.before(own.block).is_none() {
            continue;
        }
        let tools = tools.get_or_insert_with(|| Tools::of(facts));
        let value =
            |operand: &Operand| value(facts, tools.as_ref(), own.block, operand, DEEP).filter(|own| *own != 0.0);
        if let (Some(a), Some(b)) = (value(&jump.a), value(&jump.b))
            && jump.relation.holds(a, b) == Some(true)
        {
            let what = if jump.relation == Relation::Less { "less" } else { "greater" };
            return found.push(rule.comparison(facts, facts.content(block), what, a, b).arg("parameter", ""));
        }
    }
}

/// Whether a branch shows an error message before anything ends it.
fn is_error(blocks: &[Block], target: usize) -> bool {
    let branch = blocks.get(target + 1..).unwrap_or_default().iter().filter(|block| !is_silent(block));
    let message = |block: &Block| matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Fn(14));
    let plain = |block: &&Block| {
        let plain = matches!(block.kind, BlockKind::Motion(_) | BlockKind::Functions(_)) && !stops(block);
        plain || message(block)
    };
    branch.take_while(plain).any(message)
}

/// So many formulas are followed back.
const DEEP: usize = 4;
/// The parameter in which the control keeps the radius of the tool.
const RADIUS: QRef = QRef { kind: QKind::Q, number: 108 };

/// The number of an operand, if it is certain, or follows from the radius of the tool.
fn value(facts: &Facts<'_>, tools: Option<&Tools>, at: usize, operand: &Operand, deep: usize) -> Option<f64> {
    let known = facts.number(operand);
    match operand.amount {
        Amount::Q { q, negative } if known.is_none() => {
            let number = parameter(facts, tools, at, q, deep)?;
            Some(if negative { -number } else { number })
        }
        _ => known,
    }
}

/// The number of a parameter before a block: the one that the blocks directly before it calculate.
fn parameter(facts: &Facts<'_>, tools: Option<&Tools>, at: usize, q: QRef, deep: usize) -> Option<f64> {
    if q == RADIUS {
        return Some(tools?.get(facts.run.before(at)?.loaded)?.radius);
    }
    let deep = deep.checked_sub(1)?;
    for (index, block) in facts.program.blocks().iter().enumerate().take(at).rev() {
        match &block.kind {
            BlockKind::Formula(own) if own.target == q => {
                let start = own.text.start;
                return calculated(facts, tools, (index, start), &own.expr, deep);
            }
            BlockKind::FnAssign(own) if own.target == q => {
                let a = value(facts, tools, index, &own.a, deep)?;
                let b = || value(facts, tools, index, own.b.as_ref()?, deep);
                return match own.op {
                    FnOp::Set => Some(a),
                    FnOp::Add => Some(a + b()?),
                    FnOp::Sub => Some(a - b()?),
                    FnOp::Mul => Some(a * b()?),
                    FnOp::Div => Some(a / b()?),
                    _ => None,
                };
            }
            BlockKind::Formula(_) | BlockKind::FnAssign(_) | BlockKind::Motion(_) | BlockKind::FnJump(_) => {}
            BlockKind::ToolCall(_) | BlockKind::Functions(_) => {}
            _ if is_silent(block) => {}
            _ => return None,
        }
        if block.skip {
            return None;
        }
    }
    None
}

/// What a formula of a block makes, with the place of its text.
fn calculated(
    facts: &Facts<'_>,
    tools: Option<&Tools>,
    (at, start): (usize, usize),
    expr: &Expr,
    deep: usize,
) -> Option<f64> {
    let each = |own: &Expr| calculated(facts, tools, (at, start), own, deep);
    match &expr.node {
        Node::Number(number) => Some(*number),
        Node::Q(q) => {
            let span = Span::new(start + expr.span.start, start + expr.span.end);
            facts.known_at(span, false).or_else(|| parameter(facts, tools, at, *q, deep))
        }
        Node::Unary(Op::Sub, inner) => Some(-each(inner)?),
        Node::Unary(Op::Add, inner) => each(inner),
        Node::Binary(op, left, right) => {
            let (left, right) = (each(left)?, each(right)?);
            match op {
                Op::Add => Some(left + right),
                Op::Sub => Some(left - right),
                Op::Mul => Some(left * right),
                Op::Div => Some(left / right).filter(|own| own.is_finite()),
                _ => None,
            }
        }
        _ => None,
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

/// A jump that asks for the outcome of a measurement.
struct Asks {
    block: usize,
    target: usize,
    taken: Taken,
}

/// Jumps that are not taken with what their branch is for, or are taken with good parts though it is for others.
fn unfit(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    /// So many jumps are compared.
    const MOST: usize = 1 << 7;
    let blocks = facts.program.blocks();
    let graph = &facts.run.graph;
    let asks = graph.uses.iter().filter(|own| own.way == Way::Jump).filter_map(|own| {
        let BlockKind::FnJump(jump) = &blocks.get(own.block)?.kind else { return None };
        let target = graph.block_of(own.mark.as_ref()?)?;
        Some(Asks { block: own.block, target, taken: taken(facts, own.block, jump)? })
    });
    let asks: Vec<Asks> = asks.take(MOST).collect();
    for own in &asks {
        let same = || asks.iter().filter(|other| other.taken.measured == own.taken.measured);
        // What other jumps to the same branch are taken with belongs to it, too.
        let all = |outcome: usize, value: bool| {
            let mut of = same().filter(|other| other.target == own.target).map(|other| other.taken.outcomes[outcome]);
            if value { of.any(|taken| taken == Some(true)) } else { of.all(|taken| taken == Some(false)) }
        };
        // Good parts may have left before.
        let left = same().any(|other| other.block < own.block && other.taken.outcomes[0] == Some(true));
        let good = !left && own.taken.outcomes[0] == Some(true);
        let named = purpose(facts, own.target);
        let what = match named {
            Some(Purpose::Good) => all(0, false).then_some("branch"),
            Some(Purpose::Rework) if all(1, false) => Some("branch"),
            Some(Purpose::Lost) if all(2, false) => Some("branch"),
            Some(_) => good.then_some("good"),
            None => (good && own.taken.tool && begins_with_stop(facts, own.target)).then_some("good"),
        };
        if let (Some(what), Some(block)) = (what, blocks.get(own.block)) {
            let what = if good && named != Some(Purpose::Good) { "good" } else { what };
            let finding = rule.at(facts, facts.content(block)).arg("what", what);
            found.push(finding.arg("parameter", own.taken.q.to_string()));
        }
    }
}

/// Jumps that ask for the state of a tool which was measured anew: nothing was compared.
fn unchecked(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let asked = |cycle: &crate::spec::Cycle| {
        cycle.file.results.iter().find(|own| own.is.as_str() == STATUS).and_then(|own| own.q)
    };
    for own in &facts.definitions {
        let Some(q) = own.related_cycle().and_then(asked) else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(CHECK).filter(|item| number(item) == Some(0.0)) else { continue };
        let mut used = Vec::new();
        let asks = facts.marked().any(|(index, block)| {
            used.clear();
            if index > own.view.first && matches!(block.kind, BlockKind::FnJump(_)) {
                reads(block, &mut used);
            }
            let here = || measurement(facts, index, q).is_some_and(|(last, _)| last.view.first == own.view.first);
            used.iter().any(|(read, _)| *read == q) && here()
        });
        if asks {
            let finding = rule.at(facts, item.value_span).arg("what", "unchecked");
            found.push(finding.arg("parameter", q.to_string()));
        }
    }
}
