//! An approach without radius compensation, or a departure while none is active.
//!
//! Without RL or RR the tool centre runs on the contour. Where a program approaches with R0, its departures are left
//! alone, but for one after another departure in the text: that one has left the contour. Only reported where
//! compensation is certainly off. An approach perpendicular to the contour or on an arc of a given angle needs a side:
//! an error.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Approach, BlockKind, Compensation, IsoKind, Path};

/// The code of DIN/ISO for a tangential approach.
const APPROACH: u16 = 26;

pub(super) const RULE: Rule = Rule { code: "approach-without-compensation", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Whether the contour is one that is meant for the tool centre.
    let mut centre = false;
    // Whether the contour has been left, and nothing but rapid movements come after.
    let mut left = false;
    for (from, to, modal) in facts.run.stretches() {
        let off = modal.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::No);
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            if let BlockKind::Iso(own) = &block.kind
                && let IsoKind::Blend(code) = own.kind
                && off
            {
                let what = if code == APPROACH { "approach" } else { "departure" };
                found.push(rule.at(facts, block.comment().unwrap_or(block.span)).arg("what", what));
            }
            let BlockKind::Motion(motion) = &block.kind else {
                left &= matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
                continue;
            };
            if !matches!(motion.path(), Path::Dep(_)) {
                left &= !block.skip && motion.path() == Path::L && motion.outline().is_rapid();
            }
            let (what, wrong) = match motion.path() {
                Path::Appr(_) => {
                    let written = motion.compensation;
                    centre |= off && !matches!(written, Some(Compensation::Rl | Compensation::Rr));
                    let without = !matches!(written, Some(Compensation::Rl | Compensation::Rr));
                    ("approach", written == Some(Compensation::R0) || (off && without))
                }
                Path::Dep(_) => {
                    let again = std::mem::replace(&mut left, !block.skip);
                    ("departure", off && (!centre || again))
                }
                _ => continue,
            };
            if wrong {
                let sided = |form| matches!(form, Approach::Ln | Approach::Ct | Approach::Pln | Approach::Pct);
                let refused = matches!(motion.path(), Path::Appr(form) if sided(form));
                let severity = if refused { Severity::Error } else { rule.severity };
                let finding = rule.at(facts, facts.content(block)).arg("what", what);
                found.push(Diagnostic { severity, ..finding });
            }
        }
    }
}
