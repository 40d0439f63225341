//! M functions in one block of which only one can be meant: two that turn the spindle in opposite directions, or one
//! that switches something on and one that switches it off.
//!
//! Functions that act at the end of the block, such as M5 and M9, may well be next to those that act at its start.
//! The end of the program, which stops the spindle and the coolant, contradicts what starts them.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::each_function;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "functions-contradict", severity: Severity::Warning, run };

/// Of each of these at most one is in a block.
const ONE_OF: [&[u16]; 18] = [
    &[2, 30],
    &[101, 102],
    &[107, 108],
    &[144, 145],
    &[3, 4],
    &[13, 14],
    &[3, 14],
    &[4, 13],
    &[8, 9],
    // One calls the cycle in every block, the other one ends that (001: 1253-1258).
    &[89, 99],
    &[91, 92],
    &[97, 98],
    &[109, 110, 111],
    &[116, 117],
    &[126, 127],
    &[128, 129],
    &[136, 137],
    &[148, 149],
];

/// The ends of a program, and what none of them leaves on.
const ENDS_AND_STARTS: [&[u16]; 10] =
    [&[2, 3], &[2, 4], &[2, 8], &[2, 13], &[2, 14], &[3, 30], &[4, 30], &[8, 30], &[13, 30], &[14, 30]];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let mut count = 0;
        each_function(block, |_| count += 1);
        if count < 2 {
            continue;
        }
        let functions = facts.functions(block);
        for group in ONE_OF.into_iter().chain(ENDS_AND_STARTS) {
            let mut own = functions.iter().filter(|function| group.contains(&function.number));
            let (Some(first), Some(second)) = (own.next(), own.next()) else { continue };
            if first.number != second.number {
                let finding = rule.at(facts, second.span).arg("first", format!("M{}", first.number));
                found.push(finding.arg("second", format!("M{}", second.number)));
            }
        }
    }
}
