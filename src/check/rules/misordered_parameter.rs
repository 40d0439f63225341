//! A parameter that comes before one which it follows on the control.
//!
//! Controls know parameters by their numbers, so this is a warning; it is reported once a definition.
//! Lines of the old form are counted by their numbers; within a line their fields may be in any order, as may lines
//! that are repeated, such as those of a datum shift.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Item, Rule};
use crate::program::syntax::{CycleForm, OldCycleLine};
use crate::spec::Cycle;

pub(super) const RULE: Rule = Rule { code: "misordered-parameter", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if let CycleForm::Lines(lines) = &definition.view.form {
        let repeats =
            |cycle: &Cycle| cycle.params.iter().any(|own| own.field.as_ref().is_some_and(|field| field.repeat));
        if definition.cycle().is_some_and(repeats) {
            return;
        }
        let swapped = lines.windows(2).find(|pair| pair[1].line > 0 && pair[1].line < pair[0].line);
        if let Some([before, line]) = swapped {
            let name = |line: &OldCycleLine| format!("{}.{}", line.number, line.line);
            let finding = rule.at(facts, line.head).arg("parameter", name(line)).arg("before", name(before));
            found.push(finding.arg("cycle", definition.key.to_string()));
        }
        return;
    }
    if definition.in_order || definition.cycle().is_none_or(Cycle::is_old_style) {
        return;
    }
    let items: Vec<(usize, &Item<'_>)> = definition.items.iter().filter_map(|item| Some((item.index?, item))).collect();
    let places: Vec<usize> = items.iter().map(|(place, _)| *place).collect();
    let at = rising(&places).iter().zip(0..).take_while(|(right, at)| *right == at).count();
    let Some((own, item)) = items.get(at) else { return };
    // Those that are on the wrong side of it.
    let after = items.iter().take(at).rev().find(|(place, _)| place > own);
    let before = || items.iter().skip(at + 1).find(|(place, _)| place < own);
    let (first, second) = match after {
        Some((_, other)) => (*item, *other),
        None => match before() {
            Some((_, other)) => (*other, *item),
            None => return,
        },
    };
    let finding = rule.at(facts, item.span).arg("parameter", first.name.as_ref());
    found.push(finding.arg("before", second.name.as_ref()).arg("cycle", definition.key.to_string()));
}

/// The places in a list of as many numbers as possible that rise, or stay, from one to the next: the others are out of
/// order. Of equal ones those that come first.
fn rising(numbers: &[usize]) -> Vec<usize> {
    // The places of the numbers that end rows of the same length: of two the later one has the smaller number.
    let mut ends: Vec<Vec<usize>> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(numbers.len());
    for (at, own) in numbers.iter().enumerate() {
        let length = ends.partition_point(|ends| ends.last().is_some_and(|last| numbers[*last] <= *own));
        let shorter = length.checked_sub(1).map_or(&[] as &[usize], |shorter| ends[shorter].as_slice());
        before.push(shorter.get(shorter.partition_point(|end| numbers[*end] > *own)).copied());
        match ends.get_mut(length) {
            Some(ends) => ends.push(at),
            None => ends.push(vec![at]),
        }
    }
    let mut at = ends.last().and_then(|ends| ends.first().copied());
    let mut found = Vec::new();
    while let Some(place) = at {
        found.push(place);
        at = before[place];
    }
    found.reverse();
    found
}
