//! A place that is probed where the part cannot be: far beside the blank, or, of cycles that probe along the tool axis,
//! next to it; a corner that gets the coordinates of another one of the blank; a centre that misses the only pocket or
//! hole by a slip of the keyboard in one coordinate; a hole or pocket as large as the blank, or a stud larger than it; one
//! side of the blank that is probed as if it were narrower; a second hole within the first one; an angle of a circle of holes
//! at which the program makes none; a hole that is probed as wider than it is measured afterwards; a coordinate that is measured
//! in one axis, with limits that are those of another; a surface that a pocket has removed; a width that is probed along the
//! length of what was milled.
//!
//! All but the last only in programs with a box as their blank, without transformations, before another preset is set.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::contours::place_of_call;
use crate::check::cycle::{probes, probes_around, removes_material};
use crate::check::milled::Milled;
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
/// The meanings of the height at which is measured, and of the limits of a coordinate.
const HEIGHT: &str = "measuring-height";
const LIMITS: [&str; 2] = ["greatest-dimension", "least-dimension"];
/// The meanings of sizes, with the axes of the plane along which they lie.
const SIZES: [(&str, &[usize]); 5] = [
    ("probing-nominal-diameter", &[0, 1]),
    ("first-side-length", &[0]),
    ("second-side-length", &[1]),
    ("probing-first-side-length", &[0]),
    ("probing-second-side-length", &[1]),
];
/// The meanings of the sides of a rectangle, whether for the datum or measured.
const SIDES: [[&str; 2]; 2] = [[SIZES[1].0, SIZES[3].0], [SIZES[2].0, SIZES[4].0]];
/// The meanings of the points that are probed along the tool axis.
const TOUCHED: [[&str; 3]; 4] = [
    ["first-point-main", "first-point-minor", TOOL_POINT],
    ["second-point-main", "second-point-minor", "second-point-tool"],
    ["third-point-main", "third-point-minor", "third-point-tool"],
    [ABOVE, "probe-axis-point-minor", "probe-axis-point-tool"],
];
/// The meanings of widths that are probed in one axis.
const WIDTHS: [&str; 3] = ["slot-width", "ridge-width", "nominal-length"];
/// The meanings of the angles at which three holes are measured, and those of a circle of holes.
const HOLES: [&str; 3] = ["first-hole-angle", "second-hole-angle", "third-hole-angle"];
const CIRCLE: [&str; 6] = [
    "pitch-circle-centre-main",
    "pitch-circle-centre-minor",
    "pitch-circle-diameter",
    "pattern-starting-angle",
    "pattern-stepping-angle",
    "number-of-operations",
];
/// The words in the names of cycles that probe inside of something.
const INSIDE: [&str; 3] = ["inside", "hole", "pocket"];
/// The meanings of the points of a corner, and of the datum that it gets.
const CORNER: [[&str; 2]; 2] = [["first-point-main", "third-point-main"], ["third-point-minor", "first-point-minor"]];
const DATUM: [&str; 2] = ["new-datum-main", "new-datum-minor"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for own in facts.definitions.iter().filter(|own| own.key.keyword == Keyword::TchProbe) {
        let related = own.as_related_cycle();
        if let Some((span, place, limit)) = other_axis(&facts.read(&related), facts.millimetre()) {
            found.push(rule.comparison(facts, span, "axis", place, limit));
        }
    }
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins() && !facts.flow.unread.any()) else { return };
    let unit = facts.millimetre();
    let milled = milled(facts);
    let (known, circles, shapes) = (holes(facts), circles(facts), Milled::all(facts));
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
            far.push(blank.distance([x, y]) > FAR * unit);
            found.push(rule.comparison(facts, span, "outside", x, y));
        } else if let Some((span, [x, y])) = missed(&read, &milled) {
            found.push(rule.comparison(facts, span, "centre", x, y));
        } else if let Some((span, height, floor)) = removed(facts, &read, &shapes) {
            found.push(rule.comparison(facts, span, "removed", height, floor));
        } else if let Some((span, size, width)) = across(facts, &read, &shapes) {
            found.push(rule.comparison(facts, span, "across", size, width));
        } else if let Some((span, size, room)) = too_large(&read, cycle, &blank) {
            found.push(rule.comparison(facts, span, "size", size, room));
        } else if let Some((span, size, room)) = narrower(facts, &read, cycle, &blank) {
            found.push(rule.comparison(facts, span, "side", size, room));
        } else if let Some((span, apart, diameter)) = within(&read, &known) {
            found.push(rule.comparison(facts, span, "apart", apart, diameter));
        } else if let Some((span, angle)) = beside_holes(&read, &circles) {
            let finding = rule.at(facts, span).arg("what", "angle").arg("value", Arg::Number(angle));
            found.push(finding.arg("other", ""));
        } else if let Some((span, size, later)) = wider_than_later(facts, &read, cycle) {
            found.push(rule.comparison(facts, span, "later", size, later));
        } else if let Some((item, datum)) = corner(&read, &blank, unit) {
            let span = read.item(item).map_or(own.view.head, |item| item.value_span);
            found.push(rule.comparison(facts, span, "corner", datum, 0.0));
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
    let most = match (INSIDE.iter().any(|own| name.contains(own)), probes_around(cycle)) {
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

/// A side of a stud that is probed before anything was machined, far less than that of the blank, although the other side
/// and the centre are those of the blank.
fn narrower(facts: &Facts<'_>, read: &Definition<'_>, cycle: &Cycle, blank: &Blank) -> Option<(Span, f64, f64)> {
    /// A blank may be so much larger than the part, of its side.
    const ALLOWANCE: f64 = 0.2;
    let around = probes_around(cycle);
    if let Some(exchanged) = exchanged(read, blank, NEAR * facts.millimetre()).filter(|_| around) {
        return Some(exchanged);
    }
    let machined = facts
        .definitions
        .iter()
        .any(|own| own.view.first < read.view.first && own.related_cycle().is_none_or(removes_material));
    let shaped = facts.shaped().next().is_some_and(|(index, _)| index < read.view.first);
    if !around || machined || shaped {
        return None;
    }
    let near = NEAR * facts.millimetre();
    let middle = |axis: usize, at: f64| (at - (blank.high[axis] + blank.low[axis]) / 2.0).abs() <= near;
    if let Some((item, diameter)) = read.item(SIZES[0].0).and_then(|item| Some((item, number(item)?))) {
        // A round blank may be named by the box around it.
        let room = (blank.high[0] - blank.low[0]).min(blank.high[1] - blank.low[1]);
        let centre = [read.item(PLACES[0][0]).and_then(number)?, read.item(PLACES[0][1]).and_then(number)?];
        let lost = diameter < (1.0 - ALLOWANCE) * room && is_slip(diameter, room);
        return (lost && middle(0, centre[0]) && middle(1, centre[1])).then_some((item.value_span, diameter, room));
    }
    let items = SIDES.map(|pair| pair.into_iter().find_map(|meaning| read.item(meaning)));
    let sides = [number(items[0]?)?, number(items[1]?)?];
    let centre = [number(read.item(PLACES[0][0])?)?, number(read.item(PLACES[0][1])?)?];
    let room = [0, 1].map(|axis| blank.high[axis] - blank.low[axis]);
    let whole = |axis: usize| (sides[axis] - room[axis]).abs() <= near;
    let narrow = |axis: usize| sides[axis] < (1.0 - ALLOWANCE) * room[axis];
    let axis = (0..2).find(|axis| narrow(*axis) && whole(1 - axis))?;
    (middle(0, centre[0]) && middle(1, centre[1])).then_some((items[axis]?.value_span, sides[axis], room[axis]))
}

/// The sides of a stud that are those of the blank, exchanged: the shorter one, with the side of the blank.
fn exchanged(read: &Definition<'_>, blank: &Blank, near: f64) -> Option<(Span, f64, f64)> {
    let items = SIDES.map(|pair| pair.into_iter().find_map(|meaning| read.item(meaning)));
    let sides = [number(items[0]?)?, number(items[1]?)?];
    let room = [0, 1].map(|axis| blank.high[axis] - blank.low[axis]);
    let other = (0..2).all(|axis| (sides[axis] - room[1 - axis]).abs() < 1e-6);
    let short = if sides[0] < sides[1] { 0 } else { 1 };
    (other && room[short] - sides[short] > near).then_some((items[short]?.value_span, sides[short], room[short]))
}

/// A diameter that is probed inside, and is greater than the one of a hole that is measured afterwards at the same centre
/// and at nearly the same height: holes do not become narrower.
fn wider_than_later(facts: &Facts<'_>, read: &Definition<'_>, cycle: &Cycle) -> Option<(Span, f64, f64)> {
    /// The two heights may differ by so much, mm, and a worn hole is wider than its nominal diameter by no more, mm.
    const HEIGHTS: f64 = 5.0;
    const WORN: f64 = 1.0;
    let inside = |cycle: &Cycle| INSIDE.iter().any(|own| cycle.file.name.as_str().contains(own));
    let unit = facts.millimetre();
    let of = |read: &Definition<'_>| {
        let value = |meaning: &str| read.item(meaning).and_then(number);
        Some([value(PLACES[0][0])?, value(PLACES[0][1])?, value(SIZES[0].0)?, value(HEIGHT)?])
    };
    let [x, y, size, height] = of(read).filter(|_| inside(cycle))?;
    let later = facts.definitions.iter().filter(|own| own.view.first > read.view.first).filter_map(|own| {
        own.related_cycle().filter(|cycle| probes(cycle) && inside(cycle))?;
        facts.run.before(own.view.first).filter(is_unmoved)?;
        let related = own.as_related_cycle();
        let [own_x, own_y, own_size, own_height] = of(&facts.read(&related))?;
        let here = (own_x - x).abs() < 1e-3 && (own_y - y).abs() < 1e-3;
        (here && (own_height - height).abs() <= HEIGHTS * unit).then_some(own_size)
    });
    let narrowest = later.reduce(f64::min).filter(|later| size - later > WORN * unit)?;
    Some((read.item(SIZES[0].0)?.value_span, size, narrowest))
}

/// A coordinate that is measured in one axis though its limits lie far from there, and include the place in another axis:
/// the place and the greatest limit.
fn other_axis(read: &Definition<'_>, unit: f64) -> Option<(Span, f64, f64)> {
    /// So far from the place no limit lies, and so near to it those of the right axis are, mm.
    const APART: f64 = 5.0;
    const CLOSE: f64 = 1.0;
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let item = read.item(AXIS)?;
    let axis = [1.0, 2.0, 3.0].iter().position(|own| number(item) == Some(*own))?;
    let at = [value(PLACES[1][0])?, value(PLACES[1][1])?, value(HEIGHT)?];
    let [most, least] = LIMITS.map(value);
    let (most, least) = (most?, least?);
    let from = |place: f64| (least - place).max(place - most).max(0.0);
    let other = (0..3).any(|own| own != axis && from(at[own]) <= CLOSE * unit);
    (most > least && other && from(at[axis]) > APART * unit).then_some((item.value_span, at[axis], most))
}

/// A point that is probed along the tool axis where a pocket or a stud has removed the surface: the height, and the floor
/// there.
fn removed(facts: &Facts<'_>, read: &Definition<'_>, milled: &[Milled]) -> Option<(Span, f64, f64)> {
    /// So far from walls and floors, mm.
    const CLEAR: f64 = 1.0;
    let clear = CLEAR * facts.millimetre();
    let block = read.view.first;
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let along = value(AXIS) == Some(3.0);
    TOUCHED.iter().find_map(|[main, minor, tool]| {
        if *main == ABOVE && value(IN_AXIS) != Some(1.0) {
            return None;
        }
        let (item, y) = (read.item(main)?, value(minor)?);
        let place = [number(item)?, y];
        let height = value(tool).or_else(|| value(HEIGHT).filter(|_| along))?;
        let here = |own: &&Milled| own.block < block && own.removes(place, clear) && own.same_datum(facts, block);
        let floors = milled.iter().filter(here).map(|own| own.heights[1]);
        let lowest = floors.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::min)?;
        (height > lowest + clear).then_some((item.value_span, height, lowest))
    })
}

/// A width that is probed along the other axis than the one in which the program has milled it, or two sides that are
/// exchanged: the size, and how wide it is there.
fn across(facts: &Facts<'_>, read: &Definition<'_>, milled: &[Milled]) -> Option<(Span, f64, f64)> {
    /// Sizes that are so near are the same, mm.
    const SAME: f64 = 1.0;
    let same = |one: f64, other: f64| (one - other).abs() <= SAME * facts.millimetre();
    let block = read.view.first;
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let place = [PLACES[0], PLACES[4]].iter().find_map(|[main, minor]| Some([value(main)?, value(minor)?]))?;
    let here =
        |own: &&Milled| own.block < block && own.same_datum(facts, block) && own.shape.holds(own.from(place), 0.0);
    let widths = milled.iter().rfind(here)?.shape.widths()?;
    if let Some(item) = read.item(AXIS) {
        let axis = [1.0, 2.0].iter().position(|own| number(item) == Some(*own))?;
        let nominal = WIDTHS.iter().find_map(|own| value(own))?;
        let wrong = same(nominal, widths[1 - axis]) && !same(nominal, widths[axis]);
        return wrong.then_some((item.value_span, nominal, widths[axis]));
    }
    let items = SIDES.map(|pair| pair.into_iter().find_map(|meaning| read.item(meaning)));
    let sides = [number(items[0]?)?, number(items[1]?)?];
    let exchanged = (0..2).all(|axis| same(sides[axis], widths[1 - axis])) && !same(sides[0], widths[0]);
    exchanged.then_some((items[0]?.value_span, sides[0], widths[0]))
}

/// The holes that are probed at a place: centre and diameter.
fn holes(facts: &Facts<'_>) -> Vec<([f64; 2], f64)> {
    let inside = facts.definitions.iter().filter(|own| {
        own.related_cycle().is_some_and(|cycle| {
            INSIDE.iter().any(|word| cycle.file.name.as_str().contains(word)) && with_meaning(cycle, HOLES[0]).is_none()
        })
    });
    let of = |own: &Defined<'_>| {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        Some(([value(PLACES[0][0])?, value(PLACES[0][1])?], value(SIZES[0].0)?))
    };
    inside.filter_map(of).collect()
}

/// A centre of a second hole that lies within a hole whose diameter is probed elsewhere, at the centre of the first: the
/// distance of the two, and the diameter.
fn within(read: &Definition<'_>, known: &[([f64; 2], f64)]) -> Option<(Span, f64, f64)> {
    let place = |pair: [&str; 2]| Some([read.item(pair[0]).and_then(number)?, read.item(pair[1]).and_then(number)?]);
    let (first, second) = (place(PLACES[5])?, place(PLACES[6])?);
    let apart = |one: [f64; 2], other: [f64; 2]| libm::hypot(one[0] - other[0], one[1] - other[1]);
    let hole = known.iter().find(|(centre, _)| apart(*centre, first) < 1e-3 || apart(*centre, second) < 1e-3)?;
    let axis = if (first[0] - second[0]).abs() >= (first[1] - second[1]).abs() { 0 } else { 1 };
    let span = read.item(PLACES[6][axis])?.value_span;
    (apart(first, second) < hole.1).then_some((span, apart(first, second), hole.1))
}

/// A circle of holes that is made by a pattern: centre, diameter and angles.
struct Circle {
    at: [f64; 3],
    angles: Vec<f64>,
}

/// The circles of a program.
fn circles(facts: &Facts<'_>) -> Vec<Circle> {
    /// So many positions are looked at.
    const MOST: f64 = 1_000.0;
    let of = |own: &Defined<'_>| {
        own.related_cycle().filter(|cycle| with_meaning(cycle, CIRCLE[2]).is_some())?;
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let [x, y, diameter, start, step, count] = CIRCLE.map(value);
        let (start, step, count) = (start?, step?, count?);
        if step == 0.0 || !(1.0..MOST).contains(&count) {
            return None;
        }
        let angles = (0..count as usize).map(|at| start + at as f64 * step).collect();
        Some(Circle { at: [x?, y?, diameter?], angles })
    };
    facts.definitions.iter().filter_map(of).collect()
}

/// An angle at which a hole of a circle is measured and none was made, while the others of the three are there.
fn beside_holes(read: &Definition<'_>, circles: &[Circle]) -> Option<(Span, f64)> {
    /// Angles that are so near are the same, degrees.
    const SAME: f64 = 0.01;
    let items = HOLES.map(|meaning| read.item(meaning));
    let at = [PLACES[0][0], PLACES[0][1], SIZES[0].0].map(|meaning| read.item(meaning).and_then(number));
    let same = |own: &&Circle| own.at.iter().zip(at).all(|(own, at)| at.is_some_and(|at| (own - at).abs() < 1e-3));
    let all: Vec<f64> = circles.iter().filter(same).flat_map(|own| own.angles.iter().copied()).collect();
    let made = |angle: f64| {
        all.iter().any(|own| {
            let apart = (own - angle).rem_euclid(360.0);
            !(SAME..=360.0 - SAME).contains(&apart)
        })
    };
    let angles = [number(items[0]?)?, number(items[1]?)?, number(items[2]?)?];
    let mut none = (0..3).filter(|own| !made(angles[*own]));
    let (first, None) = (none.next()?, none.next()) else { return None };
    Some((items[first]?.value_span, angles[first]))
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
