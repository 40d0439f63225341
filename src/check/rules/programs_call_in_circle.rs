//! A program that calls another one which calls it back, be it through others.
//!
//! Where conditional jumps or blocks that may be skipped are in the calling program, it may end all the same, and this
//! is a warning. A program that calls itself directly is reported by a rule of its own.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Called, Facts, Rule, Way};

pub(super) const RULE: Rule = Rule { code: "programs-call-in-circle", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let conditional = facts.flow.skips || facts.run.graph.uses.iter().any(|own| own.way == Way::Jump);
    for call in &facts.calls {
        if let Called::Is { round: true, .. } = call.called {
            let finding = rule.at(facts, call.span).arg("name", facts.text(call.span).trim());
            found.push(Diagnostic {
                severity: if conditional { Severity::Warning } else { finding.severity },
                ..finding
            });
        }
    }
}
