//! A blank whose corners do not make a body: the second one is not greater than the first one in an axis, an axis is
//! missing, or one of the two lines is.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlkForm, Block, BlockKind, Coord, StatementKind};

pub(super) const RULE: Rule = Rule { code: "blank-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut first: Option<(&Block, &BlkForm)> = None;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::BlkForm(form) if form.part == 1 => {
                if let Some((alone, _)) = first.replace((block, form)) {
                    found.push(rule.at(facts, facts.content(alone)).arg("what", "second"));
                    found.push(rule.at(facts, facts.content(block)).arg("what", "again"));
                }
            }
            BlockKind::BlkForm(form) => match first.take() {
                Some((line, corner)) => {
                    if corner.axis.is_none() {
                        found.push(rule.at(facts, facts.content(line)).arg("what", "tool"));
                    }
                    lacking(rule, facts, line, corner, found);
                    lacking(rule, facts, block, form, found);
                    corners(rule, facts, corner, form, found);
                }
                None => found.push(rule.at(facts, facts.content(block)).arg("what", "first")),
            },
            BlockKind::Statement(own) if own.kind == StatementKind::BlkForm => {
                let text = facts.text(facts.content(block)).to_ascii_uppercase();
                let mut words = text.split_ascii_whitespace().skip(2);
                let has = |names: &[&str]| {
                    own.words.iter().any(|word| names.iter().any(|own| facts.text(word.name).eq_ignore_ascii_case(own)))
                };
                let form = words.next();
                if form == Some("CYLINDER") && !(has(&["R", "D"]) && has(&["L"])) {
                    found.push(rule.at(facts, facts.content(block)).arg("what", "cylinder"));
                }
                let axis = words.next().is_some_and(|word| word.starts_with(['X', 'Y', 'Z', 'U', 'V', 'W']));
                if matches!(form, Some("CYLINDER" | "ROTATION")) && !axis {
                    found.push(rule.at(facts, facts.content(block)).arg("what", "tool"));
                }
            }
            // A line that cannot be read may be the missing one.
            BlockKind::Unknown(_) => return,
            _ => {}
        }
    }
    if let Some((alone, _)) = first {
        found.push(rule.at(facts, facts.content(alone)).arg("what", "second"));
    }
}

/// Of a corner with coordinates none can be left out.
fn lacking(rule: &Rule, facts: &Facts<'_>, block: &Block, form: &BlkForm, found: &mut Vec<Diagnostic>) {
    let has = |axis: Axis| form.coords.iter().any(|coord| coord.axis == axis);
    if let Some(axis) = [Axis::X, Axis::Y, Axis::Z].into_iter().find(|axis| !has(*axis)) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "axis").arg("axis", axis.name()));
    }
}

fn corners(rule: &Rule, facts: &Facts<'_>, first: &BlkForm, second: &BlkForm, found: &mut Vec<Diagnostic>) {
    let number = |coord: &Coord| match coord.value.amount {
        Amount::Number(number) => Some(number),
        Amount::Q { .. } | Amount::Text(_) => None,
    };
    for high in &second.coords {
        let Some(low) = first.coords.iter().find(|low| low.axis == high.axis) else { continue };
        let (Some(from), Some(to)) = (number(low), number(high)) else { continue };
        let to = if high.incremental { from + to } else { to };
        if to <= from {
            found.push(rule.at(facts, high.span).arg("what", "order").arg("axis", high.axis.name()));
        }
    }
}
