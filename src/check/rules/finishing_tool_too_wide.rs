//! A side that is finished with a tool so wide that it finishes beyond what the roughing tool has reached: the allowance
//! that it leaves and its radius must be less than the allowance and the radius of roughing (TNC 640, 001: 4795).
//!
//! Only where both radii are known and the allowances are numbers. Said once a definition.
use std::collections::HashSet;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::tools::Tools;
use crate::check::{Defined, Facts, Pending, Rule};

pub(super) const RULE: Rule = Rule { code: "finishing-tool-too-wide", severity: Severity::Warning, run };

/// The meanings of the allowance that roughing leaves, of what only roughing out has, and of the allowance that finishing
/// leaves.
const ALLOWANCE: &str = "side-allowance";
const COARSE: &str = "coarse-roughing-tool";
const REMAINING: &str = "remaining-side-allowance";
/// A program of the manual finishes with exactly the sum of roughing (001: 5803): that is passed over.
const SAME: f64 = 1e-6;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    // The contour data by the blocks that define them: other cycles with such an allowance keep none.
    let data = facts.definitions.iter().filter(|own| has(own, ALLOWANCE) && !has(own, COARSE) && !removes(own));
    let data: Vec<(usize, Option<f64>)> = data.map(|own| (own.view.first, value(facts, own, ALLOWANCE))).collect();
    let mut roughing: Option<f64> = None;
    let mut seen = HashSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { return };
        let Some(own) = facts.definitions.get(index as usize) else { return };
        let radius = tools.get(call.modal.loaded).map(|tool| tool.radius);
        if has(own, COARSE) {
            // What a second tool clears is no more than what the first has left.
            roughing = radius;
        } else if has(own, REMAINING) && seen.insert(index) {
            let before = data.partition_point(|(at, _)| *at < own.view.first);
            let rough = before.checked_sub(1).and_then(|at| data[at].1);
            let left = value(facts, own, REMAINING);
            if let (Some(coarse), Some(radius), Some(rough), Some(left)) = (roughing, radius, rough, left)
                && left + radius > rough + coarse + SAME
            {
                let finding = rule.at(facts, own.view.head).arg("value", Arg::Number(left + radius));
                found.push(finding.arg("other", Arg::Number(rough + coarse)));
            }
        }
    }
}

fn has(own: &Defined<'_>, meaning: &str) -> bool {
    own.related_cycle().is_some_and(|cycle| with_meaning(cycle, meaning).is_some())
}

fn removes(own: &Defined<'_>) -> bool {
    own.related_cycle().is_some_and(crate::check::cycle::removes_material)
}

fn value(facts: &Facts<'_>, own: &Defined<'_>, meaning: &str) -> Option<f64> {
    let related = own.as_related_cycle();
    facts.read(&related).item(meaning).and_then(number)
}
