//! A value that differs only by its sign, by a factor of ten or by two exchanged digits from the one that all other
//! definitions of the same cycle have there, or a depth of a plain plunge that differs so from all others.
//!
//! At least two others, and all of them equal. Coordinates, angles and choices are not compared. The clearance heights
//! of all touch-probe cycles are compared with each other, and so are those of all that measure tools. Of polar
//! coordinates in a row of blocks the radius is compared, and the angle, if it grows by the same in all the others; so are
//! the angles to which a program tilts the plane or turns the coordinates. The
//! feeds of cycles and of contours are compared with that of the tool call. Each is reported. So is the one point of a
//! path of many points that sticks out of it, where such a slip brings it back.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::{is_silent, number, with_meaning};
use crate::check::slip::is_slip;
use crate::check::spikes;
use crate::check::{Facts, Loaded, Pending, Rule};
use crate::program::syntax::{
    Amount, Axis, BlockKind, Compensates, CycleForm, FeedKind, Path, StatementKind, ValueKind,
};
use crate::spec::{CycleKey, Group, Quantity, Reference};

pub(super) const RULE: Rule = Rule { code: "value-unlike-others", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;
/// Others that make a rule.
const OTHERS: usize = 2;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut all: BTreeMap<(CycleKey, usize), Vec<(f64, Span)>> = BTreeMap::new();
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle().filter(|cycle| cycle.file.group != Group::Patterns) else { continue };
        if matches!(cycle.file.group, Group::Datum | Group::Measuring | Group::Rotation | Group::Turning) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        for item in &read.items {
            let (Some(param), Some(at)) = (item.param, item.index) else { continue };
            let measures = matches!(param.quantity, Quantity::Length | Quantity::Feed)
                && param.reference != Some(Reference::Absolute)
                && param.choices.is_empty();
            let written = item.value.is_some_and(|value| matches!(value.kind, ValueKind::Number(_)));
            if let Some(value) = number(item).filter(|_| measures && written) {
                all.entry((own.key, at)).or_default().push((value, item.value_span));
            }
        }
    }
    all.into_values().filter_map(odd).for_each(|own| tell(rule, facts, own, found));
    if let Some(own) = odd(plunges(facts)) {
        tell(rule, facts, own, found);
    }
    for meaning in HEIGHTS {
        let told = |(span, ..): &(Span, f64, f64), found: &[Diagnostic]| {
            let same = |own: &Diagnostic| own.place.as_ref().is_some_and(|place| place.span.start == span.start);
            found.iter().any(|own| own.code == rule.code && same(own))
        };
        if let Some(own) = odd(heights(facts, meaning)).filter(|own| !told(own, found)) {
            tell(rule, facts, own, found);
        }
    }
    for own in contour_feeds(facts).into_iter().filter_map(odd) {
        tell(rule, facts, own, found);
    }
    let (radii, angles) = polar(facts);
    for own in radii {
        tell(rule, facts, own, found);
    }
    for (span, value, other) in angles.into_iter().chain(turns(facts)) {
        found.push(rule.comparison(facts, span, "angle", value, other));
    }
    let depths = old_depths(facts);
    if let ([(depth, span)], true) = (
        depths.iter().filter(|own| own.0 > 0.0).copied().collect::<Vec<_>>().as_slice(),
        depths.iter().any(|own| own.0 < 0.0),
    ) {
        found.push(rule.comparison(facts, *span, "depth", *depth, -depth));
    }
    for (span, value) in lost_signs(facts) {
        found.push(rule.comparison(facts, span, "sign", value, -value));
    }
    let told: BTreeSet<usize> = found
        .iter()
        .filter(|own| own.code == rule.code)
        .filter_map(|own| own.place.as_ref().map(|place| place.span.start))
        .collect();
    for (span, value, other) in spikes::of(facts).into_iter().filter(|(span, ..)| !told.contains(&span.start)) {
        found.push(rule.comparison(facts, span, "path", value, other));
    }
    for (span, value, other) in feeds(facts).into_iter().filter(|(span, ..)| !told.contains(&span.start)) {
        found.push(rule.comparison(facts, span, "feed", value, other));
    }
}

/// The depths of cycles of the old form that no manual describes: the second value, after the clearance.
fn old_depths(facts: &Facts<'_>) -> Vec<(f64, Span)> {
    /// So many lines a cycle has that machines.
    const LINES: usize = 4;
    let mut depths = Vec::new();
    for own in facts.definitions.iter().filter(|own| own.related_cycle().is_none()) {
        let CycleForm::Lines(lines) = &own.view.form else { continue };
        let line = lines.iter().find(|own| own.line == 2).filter(|_| lines.len() >= LINES);
        if let Some([only]) = line.map(|own| own.words.as_slice())
            && let ValueKind::Number(depth) = only.value.kind
            && depth != 0.0
        {
            depths.push((depth, only.value.span));
        }
    }
    depths
}

/// Heights between two lower ones on one way at a feed that have lost their sign: with it they lie between those beside
/// them, or go on as they do.
fn lost_signs(facts: &Facts<'_>) -> Vec<(Span, f64)> {
    let mut found = Vec::new();
    // The last two heights of the way with their places.
    let mut last: Vec<(f64, Span)> = Vec::new();
    for block in facts.program.blocks().iter().filter(|_| facts.program.blocks().len() <= MOST) {
        let BlockKind::Motion(motion) = &block.kind else {
            if !is_silent(block) {
                last.clear();
            }
            continue;
        };
        let words = motion.words();
        let height = words.coord(Axis::Z).filter(|own| !own.incremental && words.path == Path::L);
        let across = words.coords.iter().any(|own| matches!(own.axis, Axis::X | Axis::Y));
        let value = height.and_then(|own| match own.value.amount {
            Amount::Number(number) => Some((number, own.value.span)),
            _ => None,
        });
        let Some(own) = value.filter(|_| across && !motion.outline().is_rapid()) else {
            last.clear();
            continue;
        };
        if let [before, middle] = last.as_slice()
            && before.0 < 0.0
            && middle.0 > 0.0
            && own.0 < 0.0
        {
            let mean = f64::midpoint(before.0, own.0);
            if (-middle.0 - mean).abs() <= 0.25 * mean.abs() {
                found.push((middle.1, middle.0));
            }
        }
        last.push(own);
        if last.len() > 2 {
            last.remove(0);
        }
    }
    found
}

/// The feed of milling, and that of drilling.
const FEEDS: [&str; 2] = ["milling-feed", "plunging-feed"];

/// Feeds of cycles and contours that are ten times that of the tool call, or a tenth of it.
fn feeds(facts: &Facts<'_>) -> Vec<(Span, f64, f64)> {
    let blocks = facts.program.blocks();
    let called = |loaded: Loaded| {
        let Loaded::By(block) = loaded else { return None };
        let BlockKind::ToolCall(call) = &blocks.get(block as usize)?.kind else { return None };
        match call.feed.as_ref()?.kind {
            FeedKind::Value(value) => facts.number(&value).filter(|feed| *feed > 0.0),
            _ => None,
        }
    };
    let slips = |own: f64, feed: f64| [10.0, 0.1].iter().any(|factor| (own - feed * factor).abs() <= 1e-6 * own);
    let mut found: Vec<(Span, f64, f64)> = Vec::new();
    let mut seen = BTreeSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Some(feed)) = (call.modal.pending, called(call.modal.loaded)) else {
            continue;
        };
        let Some(own) = facts.definitions.get(index as usize).filter(|_| seen.insert(index)) else { continue };
        let meaning = match own.related_cycle().map(|cycle| cycle.file.group) {
            Some(Group::Pockets | Group::Surfaces) => FEEDS[0],
            Some(Group::Drilling)
                if own.related_cycle().is_some_and(|own| with_meaning(own, "milling-type").is_none()) =>
            {
                FEEDS[1]
            }
            _ => continue,
        };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, value)) = read.item(meaning).and_then(|item| Some((item, number(item)?))) else { continue };
        if slips(value, feed) {
            found.push((item.value_span, value, feed));
        }
    }
    for (index, block) in facts.shaped().filter(|_| blocks.len() <= MOST) {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.outline().compensates() != Compensates::Beside || !motion.outline().has_feed() {
            continue;
        }
        let Some(feed) = facts.run.before(index).and_then(|modal| called(modal.loaded)) else { continue };
        let Some(own) = motion.words().feed else { continue };
        let FeedKind::Value(value) = own.kind else { continue };
        if let Some(number) = facts.number(&value).filter(|number| slips(*number, feed)) {
            found.push((own.span, number, feed));
        }
    }
    found
}

/// The meanings of the heights and clearances to which a probe or a tool is lifted.
const HEIGHTS: [&str; 4] = ["clearance-height", "tool-clearance-height", "set-up-clearance", "second-set-up-clearance"];

/// The clearance heights that the definitions of all cycles have.
fn heights(facts: &Facts<'_>, meaning: &str) -> Vec<(f64, Span)> {
    let mut heights = Vec::new();
    for own in &facts.definitions {
        if own.related_cycle().is_none_or(|cycle| with_meaning(cycle, meaning).is_none()) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(meaning) else { continue };
        if let Some(ValueKind::Number(height)) = item.value.map(|value| value.kind) {
            heights.push((height, item.value_span));
        }
    }
    heights
}

/// A value that differs, and the one that would fit.
type Odd = (Span, f64, f64);

/// What differs from the others in rows of polar coordinates: the radii, and the angles between equal steps.
fn polar(facts: &Facts<'_>) -> (Vec<Odd>, Vec<Odd>) {
    let (mut lengths, mut turns) = (Vec::new(), Vec::new());
    let (mut radii, mut angles): (Vec<(f64, Span)>, Vec<(f64, Span)>) = (Vec::new(), Vec::new());
    let blocks = facts.program.blocks();
    for block in blocks.iter().filter(|own| blocks.len() <= MOST && !is_silent(own)) {
        let words = match &block.kind {
            BlockKind::Motion(motion) if motion.path() == Path::Lp && !block.skip => motion.words(),
            // Corners are rounded and broken between the same points.
            BlockKind::Motion(motion) if matches!(motion.path(), Path::Rnd | Path::Chf) => continue,
            _ => {
                lengths.extend(odd(std::mem::take(&mut radii)));
                turns.extend(step(&std::mem::take(&mut angles), is_slip));
                continue;
            }
        };
        for (axis, row) in [(Axis::Pr, &mut radii), (Axis::Pa, &mut angles)] {
            match words.coord(axis) {
                Some(own) if !own.incremental => match own.value.amount {
                    Amount::Number(number) => row.push((number, own.value.span)),
                    _ => row.clear(),
                },
                Some(_) => row.clear(),
                None => {}
            }
        }
    }
    (lengths, turns)
}

/// What differs from the others in the angles of the planes, and in those of the rotations, one after the other.
fn turns(facts: &Facts<'_>) -> Vec<Odd> {
    let mut rows: BTreeMap<String, Vec<(f64, Span)>> = BTreeMap::new();
    let blocks = facts.program.blocks();
    for block in blocks.iter().filter(|block| blocks.len() <= MOST && !block.skip) {
        let words = match &block.kind {
            BlockKind::Statement(own) if matches!(own.kind, StatementKind::Plane | StatementKind::Trans) => &own.words,
            BlockKind::OldCycleLine(own) => &own.words,
            _ => continue,
        };
        for word in words {
            let name = facts.text(word.name).trim().to_ascii_uppercase();
            if let (true, ValueKind::Number(angle)) = (ANGLE_WORDS.contains(&name.as_str()), word.value.kind) {
                rows.entry(name).or_default().push((angle, word.value.span));
            }
        }
    }
    let wrong = |row: Vec<(f64, Span)>| {
        // Each plane or rotation may be taken back before the next one.
        let taken_back = row.iter().filter(|(angle, _)| *angle == 0.0).count() > 1;
        let row: Vec<_> = row.into_iter().filter(|(angle, _)| !taken_back || *angle != 0.0).collect();
        let (span, written, meant) = step(&row, |_, _| true).filter(|_| row.len() >= ANGLES)?;
        // The first or the last one may be meant for something else.
        let inside = row.iter().skip(1).rev().skip(1).any(|(_, own)| *own == span);
        (inside || is_slip(written, meant)).then_some((span, written, meant))
    };
    rows.into_values().filter_map(wrong).collect()
}

/// The words of a plane that is tilted by spatial angles, and of a rotation.
const ANGLE_WORDS: [&str; 4] = ["SPA", "SPB", "SPC", "ROT"];

/// So many angles make a row of which one can differ.
const ANGLES: usize = 5;

/// The one angle that breaks a row of equal steps, with the one that fits.
fn step(row: &[(f64, Span)], may_be: fn(f64, f64) -> bool) -> Option<(Span, f64, f64)> {
    // Holes all around a circle need fewer.
    let around = (row.len() > OTHERS).then(|| 360.0 / row.len() as f64);
    if row.len() <= OTHERS {
        return None;
    }
    let turn = |angle: f64| {
        let rest = angle.rem_euclid(360.0);
        rest.min(360.0 - rest)
    };
    let many = row.len() >= ANGLES;
    let steps = row.windows(2).map(|two| two[1].0 - two[0].0).filter(|_| many);
    let around = around.into_iter().flat_map(|by| [by, -by]).filter(|_| !many);
    steps.chain(around).filter(|own| own.abs() > 1e-9).find_map(|by| {
        // The row begins with one that is right.
        [0, 1].into_iter().find_map(|first| {
            let begin = row[first].0;
            let fits = |at: usize| begin + by * (at as f64 - first as f64);
            let wrong: Vec<usize> = (0..row.len()).filter(|at| turn(row[*at].0 - fits(*at)) > 1e-6).collect();
            let [only] = wrong.as_slice() else { return None };
            let (written, span) = row[*only];
            let meant = fits(*only);
            // The one before may have been copied.
            let copied = (turn(written - meant) - turn(by)).abs() <= 1e-6;
            let slip = copied || may_be(written, meant) || may_be(written, meant.rem_euclid(360.0));
            slip.then_some((span, written, meant))
        })
    })
}

fn tell(rule: &Rule, facts: &Facts<'_>, (span, value, other): (Span, f64, f64), found: &mut Vec<Diagnostic>) {
    // What is wrong by itself was reported before.
    let known = |own: &Diagnostic| {
        own.code == super::early_cycle_wrong::RULE.code && own.place.as_ref().is_some_and(|own| own.span == span)
    };
    if found.iter().any(known) {
        return;
    }
    found.push(rule.comparison(facts, span, "others", value, other));
}

/// The heights to which plain movements along the tool axis alone go at a feed.
fn plunges(facts: &Facts<'_>) -> Vec<(f64, Span)> {
    let mut heights = Vec::new();
    let blocks = facts.program.blocks();
    for block in blocks.iter().filter(|_| blocks.len() <= MOST) {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.path() != Path::L || motion.outline().is_rapid() {
            continue;
        }
        if let [only] = motion.words().coords.as_slice()
            && only.axis == Axis::Z
            && !only.incremental
            && let Amount::Number(height) = only.value.amount
        {
            heights.push((height, only.value.span));
        }
    }
    heights
}

/// The feeds that the elements of each contour with RL or RR have, in programs that a person wrote.
fn contour_feeds(facts: &Facts<'_>) -> Vec<Vec<(f64, Span)>> {
    let blocks = facts.program.blocks();
    let (mut all, mut own, mut within) = (Vec::new(), Vec::new(), false);
    for block in blocks.iter().filter(|block| blocks.len() <= MOST && !is_silent(block)) {
        let BlockKind::Motion(motion) = &block.kind else {
            (within, own) = (false, Vec::new());
            continue;
        };
        match motion.outline().compensates() {
            Compensates::Beside => within = true,
            Compensates::Off => {
                within = false;
                all.push(std::mem::take(&mut own));
            }
            Compensates::Unsaid | Compensates::Along => {}
        }
        // The way to the contour and the one into a corner have feeds of their own.
        if within
            && matches!(motion.path(), Path::L | Path::C | Path::Cr | Path::Ct)
            && let Some(FeedKind::Value(value)) = motion.words().feed.map(|own| own.kind)
            && let Amount::Number(feed) = value.amount
        {
            own.push((feed, value.span));
        }
    }
    all
}

/// The one value that differs so from all others, with the others.
fn odd(all: Vec<(f64, Span)>) -> Option<(Span, f64, f64)> {
    if all.len() <= OTHERS {
        return None;
    }
    let first = all.first()?.0;
    let usual = if all.iter().filter(|(own, _)| *own == first).count() > 1 { first } else { all.get(1)?.0 };
    let mut others = all.iter().filter(|(own, _)| *own != usual);
    let (value, span) = *others.next()?;
    (others.next().is_none() && is_slip(value, usual)).then_some((span, value, usual))
}
