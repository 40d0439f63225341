//! An arc or a rounding while the axes of its plane are scaled by different factors, which only a straight line is
//! (TNC 640, 001: 6656).
//!
//! Reported once a program, and only where every definition that scales has different factors for X and Y and the tool
//! axis is Z: then the factors of the arc are certain.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Aspect, Facts, Item, Rule, Tri, Way};
use crate::program::syntax::{Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "arc-in-unequal-scaling", severity: Severity::Warning, run };

/// The meaning of the field with the factors.
const FACTORS: &str = "axis-scaling-factors";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut scaling = None;
    let uncertain = facts.find_meaning(FACTORS, |definition, factors| {
        match factors.next().and_then(plane) {
            Some([x, y]) if x == 1.0 && y == 1.0 => {}
            Some([x, y]) if x != y => scaling = scaling.or(Some(definition.key)),
            _ => return Some(()),
        }
        None
    });
    let Some(key) = scaling.filter(|_| uncertain.is_none()) else { return };
    let scaled = |modal: &crate::check::Modal| {
        modal.is(Aspect::AxisScaling) == Tri::Yes && modal.is(Aspect::OtherAxis) == Tri::No
    };
    for (from, to, _) in facts.run.stretches().filter(|(_, _, modal)| modal.as_ref().is_some_and(scaled)) {
        let arc = facts.program.blocks().get(from..to).unwrap_or_default().iter().find(|block| is_arc(block));
        if let Some(arc) = arc {
            found.push(rule.at(facts, facts.content(arc)).arg("cycle", key.to_string()));
            return;
        }
    }
    // A contour that is called with and without the scaling.
    let called = facts.run.graph.uses.iter().filter(|own| own.way == Way::Call).find_map(|own| {
        facts.run.before(own.block).filter(scaled)?;
        let start = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark))?;
        let part = facts.subprogram(start)?;
        let plain = |block: &&Block| matches!(block.kind, BlockKind::Motion(_) | BlockKind::Functions(_));
        part.iter().filter(|block| !is_silent(block)).take_while(plain).find(|block| is_arc(block))
    });
    if let Some(arc) = called {
        found.push(rule.at(facts, facts.content(arc)).arg("cycle", key.to_string()));
    }
}

fn is_arc(block: &Block) -> bool {
    matches!(&block.kind, BlockKind::Motion(motion)
        if matches!(motion.path(), Path::C | Path::Cr | Path::Ct | Path::Cp | Path::Ctp | Path::Rnd))
}

/// The factors of X and Y; nothing if they are no numbers. An axis that is not written keeps its size.
fn plane(item: &Item<'_>) -> Option<[f64; 2]> {
    let mut factors = [1.0; 2];
    for word in item.printed.split_ascii_whitespace() {
        for (factor, axis) in factors.iter_mut().zip(['X', 'Y']) {
            if let Some(number) = word.strip_prefix(axis) {
                *factor = number.replace(',', ".").parse().ok()?;
            }
        }
    }
    Some(factors)
}
