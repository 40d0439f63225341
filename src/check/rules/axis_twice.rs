//! An axis that stands twice in a block.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Place, Severity};
use crate::syntax::{BlockKind, CallForm, Coord};

pub(super) const RULE: Rule = Rule { code: "axis-twice", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in facts.program.blocks() {
        let coords: &[Coord] = match &block.kind {
            BlockKind::Motion(motion) => &motion.coords,
            BlockKind::BlkForm(form) => &form.coords,
            BlockKind::CyclCall(call) => match &call.form {
                CallForm::Position(coords) => coords,
                _ => continue,
            },
            _ => continue,
        };
        for (at, coord) in coords.iter().enumerate() {
            let first = coords.iter().take(at).find(|first| first.axis == coord.axis);
            if let Some(first) = first {
                let place = Place::new(facts.program.source(), first.span);
                found.push(rule.at(facts, coord.span).arg("axis", coord.axis.name()).related("first-place", place));
                break;
            }
        }
    }
}
