//! A path that the same tool has gone under another transformation, and a movement that a loop or a repeat brings back to the
//! same way again and again: the value that was to change does not. Also a path that removes nothing under a transformation,
//! though the same blocks have cut under another one. And a contour that other blocks have gone before, to which the tool
//! comes from another place: it was copied without its pole or its coordinates being changed.
//!
//! Where an execution shows it. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "path-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::PathTwice => Some("transformed"),
        Incident::PathRepeated => Some("repeated"),
        Incident::PathInAir => Some("air"),
        Incident::ContourCopied => Some("copied"),
        _ => None,
    });
    if let Some((span, what)) = first {
        found.push(rule.at(facts, span).arg("what", what));
    }
}
