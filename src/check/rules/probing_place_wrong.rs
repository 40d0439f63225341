//! A place that is probed where the part cannot be: far beside the blank, or, of cycles that probe along the tool axis,
//! next to it; a corner that gets the coordinates of another one of the blank; a centre that misses the only pocket or
//! hole by a slip of the keyboard in one coordinate; a hole or pocket as large as the blank, or a stud larger than it.
//!
//! Only in programs with a box as their blank, without transformations, before another preset is set.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::contours::place_of_call;
use crate::check::program::{number, with_meaning};
use crate::check::slip::is_slip;
use crate::check::{Defined, Definition, Facts, Pending, Rule};
use crate::spec::{Cycle, Group, Keyword};

pub(super) const RULE: Rule = Rule { code: "probing-place-wrong", severity: Severity::Warning, run };

/// So far beside the blank nothing is probed, mm, and so far where the tool comes from above.
const FAR: f64 = 60.0;
const ASIDE: f64 = 3.0;
/// So near to a corner of the blank a datum is that of it, mm.
const NEAR: f64 = 2.0;
/// The meanings of places in the plane, in pairs.
const PLACES: [[&str; 2]; 9] = [
    ["probing-centre-main", "probing-centre-minor"],
    ["first-point-main", "first-point-minor"],
    ["second-point-main", "second-point-minor"],
    ["third-point-main", "third-point-minor"],
    ["probing-start-main", "probing-start-minor"],
    ["first-centre-main", "first-centre-minor"],
    ["second-centre-main", "second-centre-minor"],
    ["third-centre-main", "third-centre-minor"],
    ["probe-axis-point-main", "probe-axis-point-minor"],
];
/// The place at which the probe axis itself is probed, and the choice of that.
const ABOVE: &str = "probe-axis-point-main";
const IN_AXIS: &str = "probing-in-probe-axis";
/// The meanings of the height of a point, and of the axis in which one is probed.
const TOOL_POINT: &str = "first-point-tool";
const AXIS: &str = "measuring-axis";
/// The meanings of sizes, with the axes of the plane along which they lie.
const SIZES: [(&str, &[usize]); 5] = [
    ("probing-nominal-diameter", &[0, 1]),
    ("first-side-length", &[0]),
    ("second-side-length", &[1]),
    ("probing-first-side-length", &[0]),
    ("probing-second-side-length", &[1]),
];
/// The words in the names of cycles that probe inside of something, and around it.
const INSIDE: [&str; 3] = ["inside", "hole", "pocket"];
const AROUND: [&str; 2] = ["outside", "stud"];
/// The meanings of the points of a corner, and of the datum that it gets.
const CORNER: [[&str; 2]; 2] = [["first-point-main", "third-point-main"], ["third-point-minor", "first-point-minor"]];
const DATUM: [&str; 2] = ["new-datum-main", "new-datum-minor"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins() && !facts.flow.unread.any()) else { return };
    let unit = facts.millimetre();
    let milled = milled(facts);
    // How many are far outside: of several parts in a fixture the blank is only one.
    let mut far = Vec::new();
    let first = found.len();
    for own in facts.definitions.iter().filter(|own| own.key.keyword == Keyword::TchProbe) {
        let Some(cycle) = own.related_cycle().filter(|cycle| cycle.file.group != Group::ToolMeasurement) else {
            continue;
        };
        if !facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal)) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let along = with_meaning(cycle, TOOL_POINT).is_some() || value(AXIS) == Some(3.0);
        let outside = PLACES.into_iter().find_map(|[main, minor]| {
            if main == ABOVE && value(IN_AXIS) != Some(1.0) {
                return None;
            }
            let place = [value(main)?, value(minor)?];
            let room = if along || main == ABOVE { ASIDE } else { FAR };
            (blank.distance(place) > room * unit).then_some((main, minor, place))
        });
        if let Some((main, minor, [x, y])) = outside {
            let beyond = x < blank.low[0] || blank.high[0] < x;
            let item = read.item(if beyond { main } else { minor });
            let span = item.map_or(own.view.head, |item| item.value_span);
            let finding = rule.at(facts, span).arg("what", "outside").arg("value", Arg::Number(x));
            far.push(blank.distance([x, y]) > FAR * unit);
            found.push(finding.arg("other", Arg::Number(y)));
        } else if let Some((span, [x, y])) = missed(&read, &milled) {
            let finding = rule.at(facts, span).arg("what", "centre").arg("value", Arg::Number(x));
            found.push(finding.arg("other", Arg::Number(y)));
        } else if let Some((span, size, room)) = too_large(&read, cycle, &blank) {
            let finding = rule.at(facts, span).arg("what", "size").arg("value", Arg::Number(size));
            found.push(finding.arg("other", Arg::Number(room)));
        } else if let Some((item, datum)) = corner(&read, &blank, unit) {
            let span = read.item(item).map_or(own.view.head, |item| item.value_span);
            let finding = rule.at(facts, span).arg("what", "corner").arg("value", Arg::Number(datum));
            found.push(finding.arg("other", Arg::Number(0.0)));
        }
    }
    if far.len() > 1 || (!far.is_empty() && rows(facts) > 1) {
        found.truncate(first);
    }
}

/// A size inside or outside that is larger than the blank allows, with that of the blank.
fn too_large(read: &Definition<'_>, cycle: &Cycle, blank: &Blank) -> Option<(Span, f64, f64)> {
    /// A part may be larger than the blank that is named for it, but no more.
    const OUTSIDE: f64 = 1.3;
    let name = cycle.file.name.as_str();
    let most = match (INSIDE.iter().any(|own| name.contains(own)), AROUND.iter().any(|own| name.contains(own))) {
        (true, false) => 1.0,
        (false, true) => OUTSIDE,
        _ => return None,
    };
    SIZES.iter().find_map(|(meaning, axes)| {
        let item = read.item(meaning)?;
        let size = number(item)?;
        let room = axes.iter().map(|axis| blank.high[*axis] - blank.low[*axis]).fold(f64::INFINITY, f64::min);
        (size >= most * room).then_some((item.value_span, size, room))
    })
}

/// How many rows of tables are written: each may be another part.
fn rows(facts: &Facts<'_>) -> usize {
    let of = |own: &Defined<'_>| {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        read.item("datum-row-number").and_then(number).map(f64::to_bits)
    };
    facts.definitions.iter().filter_map(of).collect::<std::collections::BTreeSet<u64>>().len()
}

/// The places of pockets and holes that the blocks of their calls name.
fn milled(facts: &Facts<'_>) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for call in facts.run.calls.iter().filter(|call| is_unmoved(&call.modal)) {
        let Pending::Definition(index) = call.modal.pending else { return Vec::new() };
        let group = facts.definitions.get(index as usize).and_then(|own| own.related_cycle()).map(|own| own.file.group);
        match group {
            Some(Group::Pockets | Group::Drilling) => places.extend(place_of_call(facts, call.block)),
            Some(Group::Threads) => {}
            _ => return Vec::new(),
        }
    }
    places
}

/// A centre that is probed where nothing was milled, and differs in one coordinate, by a slip, from a place where
/// something was: that coordinate, and the place.
fn missed(read: &Definition<'_>, milled: &[[f64; 2]]) -> Option<(Span, [f64; 2])> {
    /// Places that are so near are the same, mm or inch.
    const SAME: f64 = 1e-3;
    let items = [read.item(PLACES[0][0])?, read.item(PLACES[0][1])?];
    let at = [number(items[0])?, number(items[1])?];
    let differs =
        |place: &[f64; 2]| -> Vec<usize> { (0..2).filter(|own| (at[*own] - place[*own]).abs() > SAME).collect() };
    if milled.iter().any(|place| differs(place).is_empty()) {
        return None;
    }
    milled.iter().find_map(|place| match differs(place).as_slice() {
        [only] if is_slip(at[*only], place[*only]) => Some((items[*only].value_span, *place)),
        _ => None,
    })
}

/// A corner outside that is probed on one side of the blank and gets the coordinate of the other side: the point that
/// says it, and the coordinate.
fn corner(read: &Definition<'_>, blank: &Blank, unit: f64) -> Option<(&'static str, f64)> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    read.item(CORNER[0][1])?;
    (0..2).find_map(|axis| {
        // A point of the other side, and the one that touches this side.
        let [far, side] = CORNER[axis];
        let (far, at, datum) = (value(far)?, value(side)?, value(DATUM[axis])?);
        let (low, high) = (blank.low[axis], blank.high[axis]);
        let is = |one: f64, other: f64| (one - other).abs() <= NEAR * unit;
        let right = at > far;
        let (own, other) = if right { (high, low) } else { (low, high) };
        // The part lies so that the probed side is where the blank has it, and the datum is that of the other side.
        (is(datum, other) && !is(datum, own) && is(at, own)).then_some((side, datum))
    })
}
