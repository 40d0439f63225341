//! A clearance height that lies not above what the touch probe touches.
//!
//! At a measuring height the ball touches the workpiece, so there is material up to there; at the height of a point of
//! a surface there is, too, and a probing along the probe axis begins by the set-up clearance above it. A tip at a
//! clearance height that is no higher does not come free. What the probe table adds is not known here and left
//! out. Silent for points that a cycle does not probe, and where one of the two is a parameter.
use super::together;
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::guards::Written;
use crate::check::program::with_meaning;
use crate::check::{Definition, Facts, Rule};
use crate::spec::{Cycle, Param};

pub(super) const RULE: Rule = Rule { code: "clearance-height-too-low", severity: Severity::Warning, run: together };

/// The height at which nothing is in the way.
const CLEARANCE_HEIGHT: &str = "clearance-height";
/// What is added in front of a touch point.
const CLEARANCE: &str = "probing-clearance";
/// Heights at which the workpiece is touched from the side.
const BESIDE: [&str; 2] = ["measuring-height", "surface-point-tool"];
/// Heights at which it is touched along the probe axis.
const ABOVE: [&str; 4] = ["first-point-tool", "second-point-tool", "third-point-tool", "probe-axis-point-tool"];

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some(cycle) = definition.cycle() else { return };
    let is = |meaning: &str| with_meaning(cycle, meaning);
    let Some(param) = is(CLEARANCE_HEIGHT) else { return };
    let written = Written::of(facts, definition, cycle);
    let Some(height) = written.number_of(param) else { return };
    let clearance = is(CLEARANCE).and_then(|param| written.number_of(param)).unwrap_or(0.0).max(0.0);
    let beside = BESIDE.iter().filter_map(|meaning| needed(&written, cycle, is(meaning)?, 0.0));
    let above = ABOVE.iter().filter_map(|meaning| needed(&written, cycle, is(meaning)?, clearance));
    let highest = beside.chain(above).max_by(|one, other| one.1.total_cmp(&other.1));
    let written_for =
        |param: &Param| definition.items.iter().find(|item| item.param.is_some_and(|own| std::ptr::eq(own, param)));
    if let (Some((touched, least)), Some(item)) = (highest.filter(|(_, least)| height <= *least), written_for(param)) {
        // Where the clearance height is one, the other height is the strange one.
        let strange = if height > 0.0 { written_for(touched).unwrap_or(item) } else { item };
        let finding = rule.at(facts, strange.value_span).arg("parameter", item.name.as_ref());
        let finding = finding.arg("cycle", definition.key.to_string()).arg("value", item.printed.as_ref());
        found.push(finding.arg("touched", touched.label_in(definition.key.number)).arg("least", Arg::Number(least)));
    }
}

/// The height that the clearance height must exceed because of a parameter, if it acts and its value is known.
fn needed<'p>(written: &Written, cycle: &Cycle, param: &'p Param, clearance: f64) -> Option<(&'p Param, f64)> {
    let height = written.number_of(param)?;
    (written.acts(cycle, param)? && height.is_finite()).then_some((param, height + clearance))
}
