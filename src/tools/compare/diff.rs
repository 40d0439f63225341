//! Where two lists differ.
//!
//! Equal ends are cut off; then what occurs once on both sides and in the same order holds the lists
//! together, and each gap is treated alike. Small gaps without such a hold are solved exactly, large ones
//! are reported as one difference. Invariant: the time is bounded by the size of the lists, whatever they hold.
use std::collections::HashMap;
use std::ops::Range;

/// How many pairs of a gap are compared with each other.
const MOST_PAIRS: usize = 1 << 22;

/// Stretches of `a` and of `b` that differ, in order; between them the lists are the same.
pub(super) fn hunks<T: Eq + std::hash::Hash>(a: &[T], b: &[T]) -> Vec<(Range<usize>, Range<usize>)> {
    // Most programs that are compared are the same but for a few blocks: their equal ends are not kept.
    let (left, right) = trimmed(a, b, 0..a.len(), 0..b.len(), |_, _| {});
    let (ends, mut pairs) = ((left.clone(), right.clone()), Vec::new());
    let mut open = vec![(left, right)];
    while let Some((left, right)) = open.pop() {
        let (left, right) = trimmed(a, b, left, right, |i, j| pairs.push((i, j)));
        if left.is_empty() || right.is_empty() {
            continue;
        }
        let holds = holds(a, b, &left, &right);
        if !holds.is_empty() {
            let mut from = (left.start, right.start);
            for (i, j) in holds {
                open.push((from.0..i, from.1..j));
                pairs.push((i, j));
                from = (i + 1, j + 1);
            }
            open.push((from.0..left.end, from.1..right.end));
        } else if left.len().saturating_mul(right.len()) <= MOST_PAIRS {
            longest(a, b, &left, &right, &mut pairs);
        }
    }
    pairs.sort_unstable();
    between(&pairs, ends)
}

/// Cuts off what is equal at both ends, and says which pairs that are.
fn trimmed<T: Eq>(
    a: &[T],
    b: &[T],
    mut left: Range<usize>,
    mut right: Range<usize>,
    mut equal: impl FnMut(usize, usize),
) -> (Range<usize>, Range<usize>) {
    while !left.is_empty() && !right.is_empty() && a[left.start] == b[right.start] {
        equal(left.start, right.start);
        left.start += 1;
        right.start += 1;
    }
    while !left.is_empty() && !right.is_empty() && a[left.end - 1] == b[right.end - 1] {
        left.end -= 1;
        right.end -= 1;
        equal(left.end, right.end);
    }
    (left, right)
}

/// The longest run of pairs that occur once on each side and come in the same order.
fn holds<T: Eq + std::hash::Hash>(a: &[T], b: &[T], left: &Range<usize>, right: &Range<usize>) -> Vec<(usize, usize)> {
    // How often each occurs on both sides, and where last. No memory holds so many that these numbers are too small.
    let mut seen: HashMap<&T, [(u32, u32); 2]> = HashMap::new();
    for (side, list, range) in [(0, a, left), (1, b, right)] {
        for at in range.clone() {
            let entry = &mut seen.entry(&list[at]).or_default()[side];
            *entry = (entry.0.saturating_add(1), u32::try_from(at).unwrap_or(u32::MAX));
        }
    }
    let once = seen.values().filter(|[a, b]| a.0 == 1 && b.0 == 1);
    let mut unique: Vec<(usize, usize)> = once.map(|[a, b]| (a.1 as usize, b.1 as usize)).collect();
    drop(seen);
    unique.sort_unstable();
    // Piles: for each length the pair with the smallest end, and for each pair the one before it.
    let mut piles: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(unique.len());
    for (at, pair) in unique.iter().enumerate() {
        let pile = piles.partition_point(|&top| unique[top].1 < pair.1);
        before.push(pile.checked_sub(1).map(|lower| piles[lower]));
        if pile == piles.len() {
            piles.push(at);
        } else {
            piles[pile] = at;
        }
    }
    let mut run = Vec::with_capacity(piles.len());
    let mut next = piles.last().copied();
    while let Some(at) = next {
        run.push(unique[at]);
        next = before[at];
    }
    run.reverse();
    run
}

/// The longest common part of two short stretches.
fn longest<T: Eq>(a: &[T], b: &[T], left: &Range<usize>, right: &Range<usize>, pairs: &mut Vec<(usize, usize)>) {
    let (rows, columns) = (left.len(), right.len());
    let width = columns + 1;
    let mut best = vec![0_u32; (rows + 1) * width];
    for i in (0..rows).rev() {
        for j in (0..columns).rev() {
            best[i * width + j] = if a[left.start + i] == b[right.start + j] {
                best[(i + 1) * width + j + 1] + 1
            } else {
                best[(i + 1) * width + j].max(best[i * width + j + 1])
            };
        }
    }
    let (mut i, mut j) = (0, 0);
    while i < rows && j < columns {
        if a[left.start + i] == b[right.start + j] {
            pairs.push((left.start + i, right.start + j));
            (i, j) = (i + 1, j + 1);
        } else if best[(i + 1) * width + j] >= best[i * width + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
}

/// What the pairs leave over of two stretches.
fn between(pairs: &[(usize, usize)], (a, b): (Range<usize>, Range<usize>)) -> Vec<(Range<usize>, Range<usize>)> {
    let mut hunks = Vec::new();
    let mut from = (a.start, b.start);
    for &(i, j) in pairs.iter().chain(std::iter::once(&(a.end, b.end))) {
        if i > from.0 || j > from.1 {
            hunks.push((from.0..i, from.1..j));
        }
        from = (i + 1, j + 1);
    }
    hunks
}
