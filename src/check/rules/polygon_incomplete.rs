//! A regular polygon in polar coordinates that lacks a corner: all corners lie on one circle about the pole, and all steps
//! between them are equal but one, which is twice as great.
//!
//! Only corners that are written as straight lines with numbers, one after the other, about a pole with numbers, of polygons
//! with five corners or more.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::base::expr::atan2d;
use crate::check::contours::led;
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "polygon-incomplete", severity: Severity::Warning, run };

/// A polygon has so many corners at least, besides the one that it lacks.
const LEAST: usize = 4;
/// Steps that differ by less are equal, degrees, and what is so near to the circle lies on it, mm or inch.
const EQUAL: f64 = 0.05;
const NEAR: f64 = 0.02;

/// The corners of a polygon under way.
#[derive(Default)]
struct Corners {
    radius: Option<f64>,
    angles: Vec<f64>,
    last: Option<Span>,
    /// The pole, and where the tool is before the first corner.
    pole: Option<[f64; 2]>,
    before: Option<[f64; 2]>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut corners = Corners::default();
    let (mut pole, mut at) = (None, None);
    for block in facts.program.blocks() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ => {
                judge(rule, facts, &std::mem::take(&mut corners), None, found);
                at = None;
                continue;
            }
        };
        match motion.path {
            Path::Rnd | Path::Chf => continue,
            Path::Cc => {
                judge(rule, facts, &std::mem::take(&mut corners), None, found);
                pole = led(None, &motion);
                continue;
            }
            _ => {}
        }
        let own = corner(&motion, corners.radius);
        match own {
            Some((radius, angle)) if corners.radius.is_none_or(|own| (own - radius).abs() < 1e-6) => {
                if corners.angles.is_empty() {
                    (corners.pole, corners.before) = (pole, at);
                }
                corners.radius = Some(radius);
                corners.angles.push(angle);
                corners.last = Some(facts.content(block));
                at = None;
            }
            _ => {
                at = led(None, &motion);
                judge(rule, facts, &std::mem::take(&mut corners), at, found);
            }
        }
    }
}

/// The polar coordinates of a straight line; a radius that is not written is the one before.
fn corner(motion: &Motion, before: Option<f64>) -> Option<(f64, f64)> {
    if motion.path != Path::Lp || motion.coords.iter().any(|own| own.incremental) {
        return None;
    }
    let number = |axis: Axis| match motion.coord(axis)?.value.amount {
        Amount::Number(number) => Some(number),
        _ => None,
    };
    let radius = if motion.coord(Axis::Pr).is_some() { number(Axis::Pr) } else { before };
    Some((radius?, number(Axis::Pa)?))
}

fn judge(rule: &Rule, facts: &Facts<'_>, own: &Corners, after: Option<[f64; 2]>, found: &mut Vec<Diagnostic>) {
    let (Some(pole), Some(radius), Some(place)) = (own.pole, own.radius, own.last) else { return };
    let mut angles: Vec<f64> = own.angles.iter().map(|own| own.rem_euclid(360.0)).collect();
    // A corner that is named twice is reported by itself.
    let same = |one: &f64, other: &f64| (one - other).abs() < EQUAL;
    let inner = angles.get(1..).unwrap_or_default();
    if inner.iter().enumerate().any(|(at, one)| inner.iter().skip(at + 1).any(|other| same(one, other))) {
        return;
    }
    // A corner at the beginning or at the end may be written in other coordinates.
    for [x, y] in [own.before, after].into_iter().flatten() {
        let arm = [x - pole[0], y - pole[1]];
        if (libm::hypot(arm[0], arm[1]) - radius).abs() < NEAR {
            angles.push(atan2d(arm[1], arm[0]).rem_euclid(360.0));
        }
    }
    angles.sort_by(f64::total_cmp);
    // What ends where it begins names that corner twice.
    angles.dedup_by(|one, other| (*one - *other).abs() < EQUAL);
    let count = angles.len();
    if count < LEAST {
        return;
    }
    let step = 360.0 / (count as f64 + 1.0);
    let next = angles.iter().skip(1).copied().chain(angles.first().map(|first| first + 360.0));
    let steps: Vec<(f64, f64)> = angles.iter().zip(next).map(|(from, to)| (*from, to - from)).collect();
    let (double, equal): (Vec<_>, Vec<_>) = steps.into_iter().partition(|(_, own)| (own - 2.0 * step).abs() < EQUAL);
    let [(from, _)] = double.as_slice() else { return };
    if equal.iter().all(|(_, own)| (own - step).abs() < EQUAL) {
        let angle = libm::round((from + step).rem_euclid(360.0) * 1e3) / 1e3;
        let finding = rule.at(facts, place).arg("value", Arg::Number(angle));
        found.push(finding.arg("count", count + 1));
    }
}
