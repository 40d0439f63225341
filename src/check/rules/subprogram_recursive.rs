//! A subprogram that calls itself, be it through others.
//!
//! Where the program has conditional jumps or blocks that may be skipped, it may end all the same, and this is a
//! warning.
use crate::check::{Facts, Rule, Way};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "subprogram-recursive", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let run = &facts.run;
    let conditional = facts.flow.skips || run.graph.uses.iter().any(|own| own.way == Way::Jump);
    for at in run.recursive_calls() {
        let Some(own) = run.graph.uses.get(at) else { continue };
        let finding =
            rule.at(facts, own.span).arg("label", own.mark.as_ref().map(ToString::to_string).unwrap_or_default());
        found.push(Diagnostic { severity: if conditional { Severity::Warning } else { finding.severity }, ..finding });
    }
}
