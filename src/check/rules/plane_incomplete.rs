//! A PLANE that lacks an angle, component or coordinate of its form, or a word that says how the axes turn.
//!
//! A warning where a word of which the missing one is a part is there. The words of each form are in the file of the language.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::words;
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "plane-incomplete", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind != StatementKind::Plane {
            continue;
        }
        let lacking = words::of(facts, block).iter().find_map(words::Words::lacking);
        if let Some(lacking) = lacking {
            // Controls know some words by a longer name, such as PROROT.
            let alike = facts.text(facts.content(block)).to_ascii_uppercase().contains(lacking.as_str());
            let severity = if alike { Severity::Warning } else { rule.severity };
            found.push(Diagnostic { severity, ..rule.at(facts, facts.content(block)).arg("word", lacking) });
        }
    }
}
