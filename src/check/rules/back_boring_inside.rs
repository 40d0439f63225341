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

/// Less than so much of what is below the surface is no blank with an allowance on its lower face; the same where holes
/// are drilled through the blank.
const MOST: f64 = 0.25;
const DRILLED: f64 = 0.8;

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
        let most = if drills_to(facts, own.view.first, blank.low[2]) { DRILLED } else { MOST };
        if unmoved && thickness > 0.0 && thickness < most * below {
            found.push(rule.comparison(facts, item.value_span, "thickness", thickness, below));
        }
    }
}

/// Whether a hole is drilled down to a height before a block.
fn drills_to(facts: &Facts<'_>, block: usize, bottom: f64) -> bool {
    facts.definitions.iter().take_while(|own| own.view.first < block).any(|own| {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        value("surface-coordinate").zip(value("depth")).is_some_and(|(surface, depth)| surface + depth <= bottom)
    })
}
