//! A rounding or chamfer that is no corner of a contour: two in a row, a chamfer at an arc, none of the two between its
//! elements, a movement along the tool axis next to it, or one that needs more of a straight line than there is.
//!
//! Lengths are compared where the corners of both lines are written as numbers, one after the other, in the plane of X
//! and Y. Silent at free contours and around blocks that may be skipped.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::contours::led;
use crate::check::{Aspect, Facts, Rule, Tri, Way};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Element, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "corner-wrong", severity: Severity::Warning, run };

/// The kinds that no control machines; of others it may make something.
const REFUSED: [&str; 4] = ["arc", "first", "long", "twice"];

/// How many blocks are looked back through for coordinates.
const BACK: usize = 8;
/// What a corner may be too large, mm or inch: coordinates are rounded.
const TOLERANCE: f64 = 0.01;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    for (index, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !motion.path().is_corner() || block.skip {
            continue;
        }
        let before = blocks[..index].iter().rev().filter(|block| acts(block)).take(BACK).collect::<Vec<_>>();
        let after = blocks.get(index + 1..).unwrap_or_default().iter().find(|block| acts(block));
        let upright = facts.run.before(index).is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::No);
        let aside = if upright { out_of_plane(&before, after) } else { None };
        // An approach is one also where its length cannot be read.
        let begun = |block: &&Block| {
            let text = facts.text(facts.content(block));
            block.is_unread() && text.get(..4).is_some_and(|own| own.eq_ignore_ascii_case("APPR"))
        };
        let first = motion.path() == Path::Chf && before.first().is_some_and(begun);
        if first || before.first().is_some_and(|block| begins_contour(facts, block)) {
            let finding = rule.at(facts, facts.content(block)).arg("what", "first").arg("least", Arg::Number(0.0));
            found.push(Diagnostic { severity: Severity::Error, ..finding });
            continue;
        }
        if let Some((what, least)) = aside.or_else(|| wrong(motion, &before, after)) {
            let finding = rule.at(facts, facts.content(block)).arg("what", what);
            let severity = if REFUSED.contains(&what) { Severity::Error } else { rule.severity };
            let finding = finding.arg("least", Arg::Number(libm::round(least * 1e4) / 1e4));
            found.push(Diagnostic { severity, ..finding });
        }
    }
}

/// Whether a block sets the label of a contour that only cycles read.
fn begins_contour(facts: &Facts<'_>, block: &Block) -> bool {
    if !matches!(block.kind, BlockKind::Lbl(_)) {
        return false;
    }
    let graph = &facts.run.graph;
    let here = facts.program.blocks().iter().position(|own| std::ptr::eq(own, block));
    let mut uses = graph.uses.iter().filter(|own| own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == here);
    uses.next().is_some_and(|first| first.way == Way::Named && uses.all(|own| own.way == Way::Named))
}

/// Whether a block is more than a comment.
fn acts(block: &Block) -> bool {
    !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_)) && !block.is_blend()
}

fn is_corner(block: &Block) -> bool {
    matches!(&block.kind, BlockKind::Motion(motion) if motion.path().is_corner())
}

/// A corner between a movement along the tool axis Z alone and one in the plane.
fn out_of_plane(before: &[&Block], after: Option<&Block>) -> Option<(&'static str, f64)> {
    let (first, second) = (element(before.first().copied())?, element(after)?);
    let names = |own: &Element, axes: &[Axis]| own.words().coords.iter().any(|coord| axes.contains(&coord.axis));
    let rises = |own: &Element| own.path() == Path::L && names(own, &[Axis::Z]) && own.words().coords.len() == 1;
    let flat = |own: &Element| names(own, &[Axis::X, Axis::Y]);
    match (rises(first), rises(second)) {
        (true, _) if flat(second) => Some(("first", 0.0)),
        (_, true) if flat(first) => Some(("alone", 0.0)),
        _ => None,
    }
}

fn element(block: Option<&Block>) -> Option<&Element> {
    match block {
        Some(Block { skip: false, kind: BlockKind::Motion(motion), .. }) => Some(motion),
        _ => None,
    }
}

fn wrong(own: &Element, before: &[&Block], after: Option<&Block>) -> Option<(&'static str, f64)> {
    let first = element(before.first().copied())?;
    if first.path().is_corner() {
        return Some(("twice", 0.0));
    }
    if let Amount::Number(size) = own.words().radius.map_or(Amount::Number(1.0), |own| own.amount)
        && size <= 0.0
    {
        return Some(("size", 0.0));
    }
    // A contour begins with a straight line or an arc, not with a chamfer.
    if own.path() == Path::Chf && matches!(first.path(), Path::Appr(_)) {
        return Some(("first", 0.0));
    }
    let ends = |block: &Block| {
        matches!(block.kind, BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) | BlockKind::ToolCall(_))
    };
    if after.is_some_and(ends) {
        return Some(("alone", 0.0));
    }
    let second = element(after)?;
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
    let lines: Vec<&Block> = before.iter().copied().filter(|block| !is_corner(block)).collect();
    let corner = target(&lines)?;
    let start = target(lines.get(1..)?)?;
    let end = Some(second.words()).filter(flat).and_then(|second| led(Some(corner), &second))?;
    let one = [start[0] - corner[0], start[1] - corner[1]];
    let other = [end[0] - corner[0], end[1] - corner[1]];
    let (long, wide) = (libm::hypot(one[0], one[1]), libm::hypot(other[0], other[1]));
    let cosine = (one[0] * other[0] + one[1] * other[1]) / (long * wide);
    // What the corner takes off both lines: its length, or the radius over the tangent of half the angle.
    let needed = match own.path() {
        _ if cosine > 1.0 - 1e-9 => return Some(("back", 0.0)),
        Path::Chf => size,
        Path::Rnd => size * libm::sqrt((1.0 + cosine) / (1.0 - cosine)),
        _ => return None,
    };
    let short = long.min(wide);
    (needed.is_finite() && needed > short + TOLERANCE).then_some(("long", short))
}

/// Where the first of blocks in reverse leads in X and Y: what it does not say, those before it say.
fn target(before: &[&Block]) -> Option<[f64; 2]> {
    let mut found = [None, None];
    for block in before {
        let own = element(Some(block)).filter(|own| leads(own.path()))?.words();
        if own.functions.iter().any(|function| !matches!(function.number, 0..=9 | 13 | 14)) {
            return None;
        }
        for ((found, written), axis) in found.iter_mut().zip(plain(&own)).zip([Axis::X, Axis::Y]) {
            if found.is_none() && own.coord(axis).is_some() {
                *found = Some(written?);
            }
        }
        if let [Some(x), Some(y)] = found {
            return Some([x, y]);
        }
    }
    None
}

/// Whether the coordinates of an element are those of its end.
const fn leads(path: Path) -> bool {
    matches!(path, Path::L | Path::Appr(_) | Path::C | Path::Cr | Path::Ct)
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

/// Whether a line leads nowhere but in X and Y.
fn flat(own: &Motion) -> bool {
    own.coords.iter().all(|coord| matches!(coord.axis, Axis::X | Axis::Y)) && own.functions.is_empty()
}
