//! The one point of a path of many points that lies beside its neighbours: no smooth path has such a spike.
//!
//! Invariant: a spike is far greater than the path bends anywhere else, and a slip of the keyboard brings it back
//! between its neighbours.
use super::Facts;
use super::program::is_silent;
use crate::base::diag::Span;
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Path};

/// Longer programs are written by posts, and nobody changes them by hand.
const MOST: usize = 30_000;
/// So many values make a path that bends in some way.
const LEAST: usize = 6;
/// A spike is so many times the bends of the path.
const TIMES: f64 = 6.0;
/// The same if one digit was replaced by another one: there are more of them.
const REPLACED: f64 = 12.0;
/// So much of the distance to its neighbours a value may bend at a corner.
const SLIGHT: f64 = 1e-6;

/// A coordinate as it is written.
type Written = (f64, Span);

/// The spikes of a program: the place of the coordinate, its value and the one that would fit.
pub(super) fn of(facts: &Facts<'_>) -> Vec<(Span, f64, f64)> {
    let blocks = facts.program.blocks();
    let mut found = Vec::new();
    if blocks.len() > MOST {
        return found;
    }
    let mut rows: [Vec<Written>; 3] = Default::default();
    for block in blocks.iter().filter(|block| !is_silent(block)) {
        let goes_on = note(block, &mut rows);
        if !goes_on {
            found.extend(judge(facts, &mut rows));
        }
    }
    found.extend(judge(facts, &mut rows));
    found
}

/// Adds the coordinates of a straight line of a path; whether the block is one.
fn note(block: &Block, rows: &mut [Vec<Written>; 3]) -> bool {
    let BlockKind::Motion(motion) = &block.kind else { return false };
    let path = matches!(motion.path(), Path::L | Path::Ln) && !motion.outline().is_rapid();
    if block.skip || !path || motion.functions().iter().any(|own| matches!(own.number, 91 | 92 | 99)) {
        return false;
    }
    let words = motion.words();
    let of = |axis: Axis| words.coord(axis);
    let all = [of(Axis::X), of(Axis::Y), of(Axis::Z)];
    // A movement along the tool axis alone is an infeed or a retraction.
    let infeeds = all[2].is_some() && all[0].is_none() && all[1].is_none();
    let plain = |amount: Amount| matches!(amount, Amount::Number(_));
    if infeeds || all.iter().flatten().any(|own| own.incremental || !plain(own.value.amount)) {
        return false;
    }
    for (row, coord) in rows.iter_mut().zip(all) {
        if let Some((Amount::Number(value), span)) = coord.map(|own| (own.value.amount, own.value.span)) {
            row.push((value, span));
        }
    }
    true
}

/// The path is over: its spikes.
fn judge(facts: &Facts<'_>, rows: &mut [Vec<Written>; 3]) -> Vec<(Span, f64, f64)> {
    let mut found = Vec::new();
    for (at, row) in rows.iter_mut().enumerate() {
        let row = std::mem::take(row);
        found.extend(spike(facts, &row, at == 2));
    }
    // A point that lies elsewhere is one mistake.
    found.truncate(1);
    found
}

/// The only spike of a row of values, with the value that would fit.
fn spike(facts: &Facts<'_>, row: &[Written], along: bool) -> Option<(Span, f64, f64)> {
    if row.len() < LEAST {
        return None;
    }
    let bends: Vec<f64> = row.windows(3).map(|own| bend(own[0].0, own[1].0, own[2].0)).collect();
    let (at, greatest) = bends.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1))?;
    let others = |own: &usize| own.abs_diff(at) > 1;
    let usual = bends.iter().enumerate().filter(|(own, _)| others(own)).map(|(_, own)| *own).fold(0.0, f64::max);
    let [before, (value, span), after] = *row.get(at..at + 3)? else { return None };
    let (low, high) = (before.0.min(after.0), before.0.max(after.0));
    let count = bends.iter().enumerate().filter(|(own, _)| others(own)).count();
    if count < LEAST - 3 || (low..=high).contains(&value) || *greatest <= TIMES * usual {
        return None;
    }
    // Across the tool axis a corner may stick out: there the path goes on in one direction.
    let steps = row.windows(2).enumerate().filter(|(own, _)| *own != at && *own != at + 1);
    let goes_on = steps.map(|(_, own)| own[1].0 - own[0].0).chain([after.0 - before.0]).collect::<Vec<_>>();
    let one_way = goes_on.iter().all(|step| *step > 0.0) || goes_on.iter().all(|step| *step < 0.0);
    let flat = goes_on.iter().all(|step| *step == 0.0);
    if !one_way && (!along || flat && value > high) {
        return None;
    }
    let middle = f64::midpoint(low, high);
    let reach = (2.0 * usual).max((high - low) / 2.0) + SLIGHT * middle.abs();
    let text = facts.text(span).trim().replace(',', ".");
    let fits = |own: &f64| (own - middle).abs() <= reach;
    let meant = slips(&text).into_iter().filter(fits);
    let replaced = *greatest > REPLACED * usual && !flat;
    let replaced = exchanges(&text).into_iter().filter(|own| replaced && fits(own));
    let meant = meant.chain(replaced).min_by(|one, other| (one - middle).abs().total_cmp(&(other - middle).abs()))?;
    Some((span, value, meant))
}

/// How far a value is from the middle of its neighbours.
fn bend(before: f64, own: f64, after: f64) -> f64 {
    (own - f64::midpoint(before, after)).abs()
}

/// The values in place of which somebody may have written a text: with the decimal point elsewhere, with another sign,
/// with a digit less, or with two digits exchanged.
fn slips(text: &str) -> Vec<f64> {
    let Ok(value) = text.parse::<f64>() else { return Vec::new() };
    let mut all: Vec<f64> = [10.0, 0.1, 100.0, 0.01].into_iter().map(|factor| value * factor).collect();
    all.push(-value);
    let signs: Vec<char> = text.chars().collect();
    for at in (0..signs.len()).filter(|at| signs[*at].is_ascii_digit()) {
        let mut less = signs.clone();
        less.remove(at);
        all.extend(read(&less));
        if at + 1 < signs.len() && signs[at + 1].is_ascii_digit() {
            let mut exchanged = signs.clone();
            exchanged.swap(at, at + 1);
            all.extend(read(&exchanged));
        }
    }
    all
}

/// The values of a text with another digit in place of one.
fn exchanges(text: &str) -> Vec<f64> {
    let signs: Vec<char> = text.chars().collect();
    let digits = (0..signs.len()).filter(|at| signs[*at].is_ascii_digit());
    digits
        .flat_map(|at| {
            ('0'..='9').filter_map({
                let signs = &signs;
                move |digit| {
                    let mut other = signs.clone();
                    *other.get_mut(at)? = digit;
                    read(&other)
                }
            })
        })
        .collect()
}

fn read(signs: &[char]) -> Option<f64> {
    signs.iter().collect::<String>().parse().ok()
}
