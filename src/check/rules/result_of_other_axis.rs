//! A coordinate that is the result of another axis: cycles and functions write the angles of A, B and C, and the places in X,
//! Y and Z that a probe has touched, into parameters of their own, one for each axis.
//!
//! Only movements that name the parameter alone, in programs that do not write these parameters themselves.
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{QKind, QRef};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlockKind};

pub(super) const RULE: Rule = Rule { code: "result-of-other-axis", severity: Severity::Warning, run };

/// The parameters with the results of axes: the touched place, then the angles that tilt the working plane.
const RESULTS: [(u16, Axis); 6] =
    [(115, Axis::X), (116, Axis::Y), (117, Axis::Z), (120, Axis::A), (121, Axis::B), (122, Axis::C)];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Most programs have none of them.
    let text = facts.program.source().text();
    if !RESULTS.iter().any(|(number, _)| text.contains(&format!("Q{number}"))) {
        return;
    }
    let of = |q: QRef| RESULTS.iter().find(|(number, _)| q.kind == QKind::Q && q.number == *number);
    let written = facts.program.blocks().iter().any(|block| match &block.kind {
        BlockKind::FnAssign(own) => of(own.target).is_some(),
        BlockKind::Formula(own) => of(own.target).is_some(),
        _ => false,
    });
    if written {
        return;
    }
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !motion.outline().has_parameters() {
            continue;
        }
        for coord in &motion.words().coords {
            let Amount::Q { q, .. } = coord.value.amount else { continue };
            let Some((number, axis)) = of(q) else { continue };
            let alike = RESULTS.iter().filter(|(_, own)| is_linear(*own) == is_linear(*axis));
            if coord.axis != *axis && alike.into_iter().any(|(_, own)| *own == coord.axis) {
                let finding = rule.at(facts, coord.value.span).arg("parameter", format!("Q{number}"));
                found.push(finding.arg("axis", format!("{axis:?}")).arg("other", format!("{:?}", coord.axis)));
            }
        }
    }
}

const fn is_linear(axis: Axis) -> bool {
    matches!(axis, Axis::X | Axis::Y | Axis::Z)
}
