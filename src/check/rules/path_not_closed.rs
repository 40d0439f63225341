//! A subprogram in incremental coordinates that does not come back to where it begins, although the next infeed is at the same
//! place: with one coordinate put right, as after a slip of the keyboard, it would.
//!
//! Only subprograms of straight lines with numbers that are called twice with nothing but movements of the tool axis between.
//! A zigzag, which goes on from where it has come to, is not called like this.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::is_silent;
use crate::check::slip::is_slip;
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "path-not-closed", severity: Severity::Warning, run };

/// A closed path has so many lines.
const LEAST: usize = 4;
/// Less than this is no gap, mm or inch.
const NEAR: f64 = 1e-6;

/// A step along an axis of the plane.
type Step = (usize, f64, Span);

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let calls: Vec<(usize, usize)> = graph
        .uses
        .iter()
        .filter(|own| own.way == Way::Call)
        .filter_map(|own| Some((own.block, graph.block_of(own.mark.as_ref()?)?)))
        .collect();
    let mut seen = Vec::new();
    for pair in calls.windows(2) {
        let [(first, label), (second, other)] = pair else { continue };
        let between = facts.program.blocks().get(first + 1..*second).unwrap_or_default();
        if label != other || seen.contains(label) || !between.iter().all(only_lifts) {
            continue;
        }
        seen.push(*label);
        let steps = facts.subprogram(*label).and_then(steps);
        if let Some((span, value, other)) = steps.as_deref().and_then(wrong) {
            found.push(rule.comparison(facts, span, "step", value, other));
        }
    }
}

/// Whether a block moves the tool along its axis only, if it moves it.
fn only_lifts(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            motion.path() == Path::L && motion.words().coords.iter().all(|own| own.axis == Axis::Z) && !block.skip
        }
        _ => is_silent(block),
    }
}

/// The steps of a path in the plane, if it has nothing else but movements along the tool axis.
fn steps(blocks: &[Block]) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for block in blocks.iter().filter(|block| !only_lifts(block)) {
        let BlockKind::Motion(motion) = &block.kind else { return None };
        let words = motion.words();
        if words.path != Path::L || motion.outline().is_rapid() || motion.has_functions() || block.skip {
            return None;
        }
        for coord in &words.coords {
            let axis = [Axis::X, Axis::Y].iter().position(|own| *own == coord.axis);
            let Amount::Number(value) = coord.value.amount else { return None };
            steps.push((axis.filter(|_| coord.incremental)?, value, coord.value.span));
        }
    }
    Some(steps)
}

/// The last step whose slip leaves the path open, with the value that closes it.
fn wrong(steps: &[Step]) -> Option<(Span, f64, f64)> {
    let gap = |axis: usize| steps.iter().filter(|own| own.0 == axis).map(|own| own.1).sum::<f64>();
    let open: Vec<usize> = (0..2).filter(|axis| gap(*axis).abs() > NEAR).collect();
    let ([axis], true) = (open.as_slice(), steps.len() >= LEAST) else { return None };
    let meant = |own: &Step| ((own.1 - gap(*axis)) * 1e6).round() / 1e6;
    let own = steps.iter().rev().find(|own| own.0 == *axis && is_slip(own.1, meant(own)))?;
    Some((own.2, own.1, meant(own)))
}
