//! Counterboring from below whose material thickness ends far inside of the blank: the cutting edge would swing out in solid
//! material. Also a bar that does not fit through its hole beside the axis, where an execution shows it.
//!
//! Only in programs with a box as their blank, and where the thickness is far less than what is below the surface.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::incident::Incident;
use crate::check::program::number;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "back-boring-inside", severity: Severity::Warning, run };

/// Less than so much of what is below the surface is no blank with an allowance on its lower face.
const MOST: f64 = 0.25;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "hole", |own| match own {
        Incident::EdgeWiderThanHole { edge, hole } => Some((edge, hole)),
        _ => None,
    });
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins()) else { return };
    for own in &facts.definitions {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let (Some(item), Some(surface)) = (read.item("material-thickness"), read.item("surface-coordinate")) else {
            continue;
        };
        let unmoved = facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal));
        let (Some(thickness), Some(surface)) = (number(item), number(surface)) else { continue };
        let below = surface - blank.low[2];
        if unmoved && thickness > 0.0 && thickness < MOST * below {
            found.push(rule.comparison(facts, item.value_span, "thickness", thickness, below));
        }
    }
}
