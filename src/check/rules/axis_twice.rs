//! An axis that is written twice in a block.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, CallForm, axis_twice};

pub(super) const RULE: Rule = Rule { code: "axis-twice", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let motion = match &block.kind {
            BlockKind::Motion(motion) if motion.outline().has_odd_coords() => Some(motion.words()),
            _ => None,
        };
        let coords = match (&block.kind, &motion) {
            (_, Some(motion)) => motion.coords.as_slice(),
            (BlockKind::BlkForm(form), _) => form.coords.as_slice(),
            (BlockKind::CyclCall(call), _) => match &call.form {
                CallForm::Position(coords) => coords.as_slice(),
                _ => continue,
            },
            _ => continue,
        };
        if let Some((first, coord)) = axis_twice(coords) {
            let place = Place::new(facts.program.source(), first.span);
            found.push(rule.at(facts, coord.span).arg("axis", coord.axis.name()).related("first-place", place));
        }
    }
}
