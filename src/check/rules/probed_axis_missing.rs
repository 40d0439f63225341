//! A position to be probed that does not name the axis in which it is probed.
//!
//! The cycle measures one coordinate, and the probe moves from its pre-position towards the nominal value that the
//! position gives in that axis (001: 12654; 000: 4717-4719; 003: 1779). Without one the probe stays
//! where it happens to be.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "probed-axis-missing", severity: Severity::Warning, run };

/// The meanings of the direction and of the position.
const DIRECTION: &str = "probing-direction";
const POSITION: &str = "probing-position";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The parameters of a cycle of another form need not be read.
    let of_lines = facts.definitions.iter().filter(|own| matches!(own.view.form, CycleForm::Lines(_)));
    for definition in of_lines.filter(|own| own.cycle().is_some()).map(|own| facts.read(own)) {
        let written = definition.item(DIRECTION).zip(definition.item(POSITION));
        let Some((direction, position)) = written else { continue };
        let Some(axis) = direction.printed.trim_end_matches(['+', '-']).chars().next() else { continue };
        // `X+5`, or `IX+5`.
        let named = |word: &str| word.trim_start_matches('I').starts_with(axis);
        if !position.printed.split_whitespace().any(named) {
            let finding = rule.at(facts, position.span).arg("axis", axis.to_string());
            found.push(finding.arg("direction", direction.printed.as_ref()));
        }
    }
}
