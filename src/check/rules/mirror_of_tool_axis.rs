//! A mirror image that names the tool axis.
//!
//! The tool axis and the axis next to it cannot be mirrored (TNC 640, 001: 6533).
//! Only reported where the tool axis is certain.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::CycleForm;

pub(super) const RULE: Rule = Rule { code: "mirror-of-tool-axis", severity: Severity::Warning, run };

/// The meaning of the axes that are mirrored.
const MIRRORED: &str = "mirrored-axes";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let mirrors = |own: &crate::spec::Param| own.is.as_str() == MIRRORED;
        let CycleForm::Lines(lines) = &definition.view.form else { continue };
        if !definition.related_cycle().is_some_and(|cycle| cycle.params.iter().any(mirrors)) {
            continue;
        }
        let is_z =
            |modal: crate::check::Modal| modal.is(Aspect::Tool) == Tri::Yes && modal.is(Aspect::OtherAxis) == Tri::No;
        if !facts.run.before(definition.view.first).is_some_and(is_z) {
            continue;
        }
        for word in lines.iter().filter(|line| line.line > 0).flat_map(|line| &line.words) {
            if facts.text(word.span).trim().eq_ignore_ascii_case("Z") {
                found.push(rule.at(facts, word.span).arg("axis", "Z"));
            }
        }
    }
}
