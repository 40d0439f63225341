//! A CONTOUR DEF that does not begin with a pocket, that has more than nine contours, or two with the same number
//! (TNC 640, 001: 5861, 5922, 5929).
use std::collections::HashSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, NamedWord, StatementKind};

pub(super) const RULE: Rule = Rule { code: "contour-def-wrong", severity: Severity::Error, run };

/// The greatest number of contours in a simple formula.
const MOST: usize = 9;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::Statement(statement) = &block.kind else { continue };
        if statement.kind != StatementKind::ContourDef {
            continue;
        }
        let name = |word: &&NamedWord| facts.program.slice(word.name).to_ascii_uppercase();
        let is_contour = |word: &&NamedWord| name(word).ends_with(|last: char| last.is_ascii_digit());
        let contours: Vec<_> = statement.words.iter().filter(is_contour).collect();
        if let Some(first) = contours.first().filter(|first| !name(first).starts_with('P')) {
            found.push(rule.at(facts, first.name).arg("what", "island").arg("found", name(first)));
        }
        let number = |own: &&NamedWord| name(own).trim_start_matches(char::is_alphabetic).to_owned();
        let mut numbers = HashSet::new();
        for own in &contours {
            if !numbers.insert(number(own)) {
                found.push(rule.at(facts, own.name).arg("what", "number").arg("found", name(own)));
            }
        }
        if let Some(tenth) = contours.get(MOST) {
            found.push(rule.at(facts, tenth.name).arg("what", "many").arg("found", name(tenth)));
        }
    }
}
