//! A tool call, a rotary axis that turns at rapid, a plane that is tilted with MOVE or the end of the program while the
//! tool is inside of the blank, or just above it: it was not retracted.
//!
//! Places are followed from label to label in programs with a box as their blank. Silent while the control holds the tool
//! tip in its place (M128, FUNCTION TCPM). Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "retract-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut change, mut turn, mut tilt, mut end) = (false, false, false, false);
    for (span, own) in incidents(facts) {
        let (what, height, said) = match own {
            Incident::ToolChange(height) => ("change", *height, &mut change),
            Incident::Turn(height) => ("turn", *height, &mut turn),
            Incident::Tilt(height) => ("tilt", *height, &mut tilt),
            Incident::End(height) => ("end", *height, &mut end),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            found.push(rule.at(facts, *span).arg("what", what).arg("value", Arg::Number(height)));
        }
    }
}
