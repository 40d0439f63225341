//! A program that is called and is not where the control looks for it.
//!
//! A name without a folder means the folder of the calling program. It is a warning where that folder was checked as a
//! whole, a note where single files were: the other one may only not be here. Silent where the call names a folder.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Called, Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "called-program-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for call in &facts.calls {
        if let Called::Missing(severity) = call.called {
            let finding = rule.at(facts, call.span).arg("name", facts.text(call.span).trim());
            found.push(Diagnostic { severity, ..finding });
        }
    }
}
