//! A rounding or chamfer that is no corner of a contour: two in a row, a chamfer at an arc, none of the two between its
//! elements, or one that needs more of a straight line than there is.
//!
//! Lengths are compared where the corners of both lines are written as numbers, one behind the other, in the plane of X
//! and Y. Silent at free contours and around blocks that may be skipped.
use crate::check::{Facts, Rule};
use crate::diag::{Arg, Diagnostic, Severity};
use crate::syntax::{Amount, Axis, Block, BlockKind, Element, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "corner-wrong", severity: Severity::Warning, run };

/// What a corner may be too large, mm or inch: coordinates are rounded.
const TOLERANCE: f64 = 0.01;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    for (index, block) in blocks.iter().enumerate() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !motion.path().is_corner() || block.skip {
            continue;
        }
        let before = blocks[..index].iter().rev().filter(|block| acts(block)).take(3).collect::<Vec<_>>();
        let behind = blocks.get(index + 1..).unwrap_or_default().iter().find(|block| acts(block));
        if let Some((what, least)) = wrong(motion, &before, behind) {
            let finding = rule.at(facts, facts.content(block)).arg("what", what);
            found.push(finding.arg("least", Arg::Number(libm::round(least * 1e4) / 1e4)));
        }
    }
}

/// Whether a block is more than a comment.
fn acts(block: &Block) -> bool {
    !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

fn element(block: Option<&Block>) -> Option<&Element> {
    match block {
        Some(Block { skip: false, kind: BlockKind::Motion(motion), .. }) => Some(motion),
        _ => None,
    }
}

fn wrong(own: &Element, before: &[&Block], behind: Option<&Block>) -> Option<(&'static str, f64)> {
    let first = element(before.first().copied())?;
    if first.path().is_corner() {
        return Some(("twice", 0.0));
    }
    let second = element(behind)?;
    let arc = |motion: &Element| matches!(motion.path(), Path::C | Path::Cr | Path::Ct | Path::Cp | Path::Ctp);
    if own.path() == Path::Chf && (arc(first) || arc(second)) {
        return Some(("arc", 0.0));
    }
    if first.path() != Path::L || second.path() != Path::L {
        return None;
    }
    let size = match own.words().radius?.amount {
        Amount::Number(number) => number.abs(),
        Amount::Q { .. } | Amount::Text(_) => return None,
    };
    let corner = target(before)?;
    let start = target(before.get(1..)?)?;
    let end = moved(corner, &second.words())?;
    let one = [start[0] - corner[0], start[1] - corner[1]];
    let other = [end[0] - corner[0], end[1] - corner[1]];
    let (long, wide) = (libm::hypot(one[0], one[1]), libm::hypot(other[0], other[1]));
    let cosine = (one[0] * other[0] + one[1] * other[1]) / (long * wide);
    // What the corner takes off both lines: its length, or the radius over the tangent of half the angle.
    let needed = match own.path() {
        Path::Chf => size,
        _ if cosine < 1.0 - 1e-9 => size * libm::sqrt((1.0 + cosine) / (1.0 - cosine)),
        _ => return None,
    };
    let short = long.min(wide);
    (needed.is_finite() && needed > short + TOLERANCE).then_some(("long", short))
}

/// Where the first of blocks in reverse leads in X and Y, its own words and those of the line before it being numbers.
fn target(before: &[&Block]) -> Option<[f64; 2]> {
    let own = element(before.first().copied()).filter(|own| own.path() == Path::L)?.words();
    let from = element(before.get(1).copied()).filter(|own| own.path() == Path::L).map(|own| plain(&own.words()));
    let [x, y] = plain(&own);
    let [fx, fy] = from.unwrap_or([None, None]);
    flat(&own).then_some([
        x.or(if names(&own, Axis::X) { None } else { fx })?,
        y.or(if names(&own, Axis::Y) { None } else { fy })?,
    ])
}

/// The absolute numbers of X and Y.
fn plain(own: &Motion) -> [Option<f64>; 2] {
    [Axis::X, Axis::Y].map(|axis| match own.coord(axis) {
        Some(coord) if !coord.incremental => match coord.value.amount {
            Amount::Number(number) => Some(number),
            Amount::Q { .. } | Amount::Text(_) => None,
        },
        _ => None,
    })
}

fn names(own: &Motion, axis: Axis) -> bool {
    own.coord(axis).is_some()
}

fn flat(own: &Motion) -> bool {
    own.coords.iter().all(|coord| matches!(coord.axis, Axis::X | Axis::Y)) && own.functions.is_empty()
}

/// Where a line leads from a place.
fn moved(from: [f64; 2], own: &Motion) -> Option<[f64; 2]> {
    let mut to = from;
    for (at, axis) in [Axis::X, Axis::Y].into_iter().enumerate() {
        if let Some(coord) = own.coord(axis) {
            let Amount::Number(number) = coord.value.amount else { return None };
            to[at] = if coord.incremental { from[at] + number } else { number };
        }
    }
    flat(own).then_some(to)
}
