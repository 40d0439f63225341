//! Contours of which some have a depth of their own and others none.
//!
//! The manual asks for a depth at all of them then, 0 if need be (TNC 640, 001: 5602). Reported once a program, at the
//! first one that has none.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Statement, StatementKind};

pub(super) const RULE: Rule = Rule { code: "contour-depth-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let declarations: Vec<&Statement> = facts
        .marked()
        .filter_map(|(_, block)| match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::DeclareContour => Some(&**own),
            _ => None,
        })
        // What goes on in the next line of a listing is not known.
        .filter(|own| !own.words.is_empty())
        .collect();
    let deep =
        |own: &&&Statement| own.words.iter().any(|word| facts.program.slice(word.name).eq_ignore_ascii_case("DEPTH"));
    if !declarations.iter().any(|own| deep(&own)) {
        return;
    }
    if let Some(word) = declarations.iter().find(|own| !deep(own)).and_then(|own| own.words.first()) {
        found.push(rule.at(facts, word.name).arg("contour", facts.program.slice(word.name)));
    }
}
