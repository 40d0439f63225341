//! A program in millimetres that calls one in inches, or the other way round.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Called, Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "called-program-in-other-unit", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() {
        return;
    }
    let unit = |inch: bool| if inch { "INCH" } else { "MM" };
    for call in &facts.calls {
        if let Called::Is { callee, .. } = &call.called
            && let Some(inch) = callee.inch
            && inch != facts.inch
        {
            let finding = rule.at(facts, call.span).arg("name", facts.text(call.span).trim());
            found.push(finding.arg("own", unit(facts.inch)).arg("other", unit(inch)));
        }
    }
}
