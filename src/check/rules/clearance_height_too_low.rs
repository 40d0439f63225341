//! A clearance height that lies not above what the touch probe touches.
//!
//! At a measuring height the ball touches the workpiece, so there is material up to there; at the height of a point of
//! a surface there is, too, and a probing along the probe axis begins by the set-up clearance above it. A tip at a
//! clearance height that is no higher does not come free. What the probe table adds is not known here and left
//! out. Silent for points that a cycle does not probe, and where one of the two is a parameter.
//!
//! Also one at which a cycle moves from one hole to another through a stud that the program has milled between them.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::base::expr::{cosd, sind};
use crate::check::blank::is_unmoved;
use crate::check::guards::Written;
use crate::check::milled::Milled;
use crate::check::program::{number, with_meaning};
use crate::check::{Defined, Definition, Facts, Rule};
use crate::spec::{Cycle, Param};

pub(super) const RULE: Rule = Rule { code: "clearance-height-too-low", severity: Severity::Warning, run };

/// The height at which nothing is in the way.
const CLEARANCE_HEIGHT: &str = "clearance-height";
/// What is added in front of a touch point.
const CLEARANCE: &str = "probing-clearance";
/// Heights at which the workpiece is touched from the side.
const BESIDE: [&str; 2] = ["measuring-height", "surface-point-tool"];
/// Heights at which it is touched along the probe axis.
const ABOVE: [&str; 4] = ["first-point-tool", "second-point-tool", "third-point-tool", "probe-axis-point-tool"];

/// The holes that a cycle measures one after the other: by their centres, or by angles on a circle.
const CENTRES: [[&str; 2]; 4] = [
    ["first-centre-main", "first-centre-minor"],
    ["second-centre-main", "second-centre-minor"],
    ["third-centre-main", "third-centre-minor"],
    ["fourth-centre-main", "fourth-centre-minor"],
];
const CIRCLE: [&str; 3] = ["probing-centre-main", "probing-centre-minor", "probing-nominal-diameter"];
const ANGLES: [&str; 3] = ["first-hole-angle", "second-hole-angle", "third-hole-angle"];

/// Studs between holes that a cycle measures.
fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let of_holes = |own: &&Defined<'_>| {
        let has = |cycle: &Cycle, meaning: &str| with_meaning(cycle, meaning).is_some();
        own.related_cycle()
            .is_some_and(|cycle| has(cycle, CLEARANCE_HEIGHT) && (has(cycle, CENTRES[1][0]) || has(cycle, ANGLES[0])))
    };
    let mut cycles = facts.definitions.iter().filter(of_holes).peekable();
    if cycles.peek().is_none() {
        return;
    }
    let milled = Milled::all(facts);
    for own in cycles {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, height)) = read.item(CLEARANCE_HEIGHT).and_then(|item| Some((item, number(item)?))) else {
            continue;
        };
        if !facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal)) {
            continue;
        }
        let holes = holes(&read);
        let before = |stud: &&Milled| stud.block < own.view.first && stud.blank.is_some();
        let studs = milled.iter().filter(before).filter(|stud| stud.same_datum(facts, own.view.first));
        let on_the_way = studs.filter_map(|stud| {
            let top = stud.heights[0].filter(|top| *top > height)?;
            let near =
                |ends: &[[f64; 2]]| matches!(ends, [from, to] if apart(stud.at, *from, *to) < stud.shape.inner());
            holes.windows(2).any(near).then_some(top)
        });
        if let Some(top) = on_the_way.reduce(f64::max) {
            let finding = rule.at(facts, item.value_span).arg("what", "stud").arg("parameter", item.name.as_ref());
            let finding = finding.arg("cycle", own.key.to_string()).arg("value", item.printed.as_ref());
            found.push(finding.arg("touched", "").arg("least", Arg::Number(top)));
        }
    }
}

/// The centres of the holes that a definition measures, in their order.
fn holes(read: &Definition<'_>) -> Vec<[f64; 2]> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    if let [Some(x), Some(y), Some(diameter)] = CIRCLE.map(value) {
        let radius = diameter / 2.0;
        let angles = ANGLES.iter().filter_map(|own| value(own));
        return angles.map(|angle| [x + radius * cosd(angle), y + radius * sind(angle)]).collect();
    }
    CENTRES.iter().filter_map(|[main, minor]| Some([value(main)?, value(minor)?])).collect()
}

/// How far a place is from a straight way.
fn apart(place: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let way = [to[0] - from[0], to[1] - from[1]];
    let square = way[0] * way[0] + way[1] * way[1];
    let along = (place[0] - from[0]) * way[0] + (place[1] - from[1]) * way[1];
    let part = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(from[0] + part * way[0] - place[0], from[1] + part * way[1] - place[1])
}

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
        let finding = rule.at(facts, strange.value_span).arg("what", "touched");
        let finding = finding.arg("parameter", item.name.as_ref());
        let finding = finding.arg("cycle", definition.key.to_string()).arg("value", item.printed.as_ref());
        found.push(finding.arg("touched", touched.label_in(definition.key.number)).arg("least", Arg::Number(least)));
    }
}

/// The height that the clearance height must exceed because of a parameter, if it acts and its value is known.
fn needed<'p>(written: &Written, cycle: &Cycle, param: &'p Param, clearance: f64) -> Option<(&'p Param, f64)> {
    let height = written.number_of(param)?;
    (written.acts(cycle, param)? && height.is_finite()).then_some((param, height + clearance))
}
