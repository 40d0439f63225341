//! What ways of a tool look like on paper, for figures and for drawings of programs.
//!
//! Invariant: knows places on the sheet, not where they come from.
use glam::DVec2;

use super::pen::{ARROW, Pen, Rect};
use super::stroke::Way;

/// The class of the line of a way.
pub(super) const fn class(way: Way) -> &'static str {
    match way {
        Way::Rapid => "r",
        Way::Feed => "f",
        Way::Probe => "p",
    }
}

/// Draws the arrowhead of a way.
pub(super) fn head(pen: &mut Pen, way: Way, tip: DVec2, along: DVec2) {
    match way {
        Way::Rapid => pen.chevron("ra", tip, along),
        Way::Feed => pen.arrow("fa", tip, along),
        Way::Probe => pen.arrow("pa", tip, along),
    }
}

/// Draws the axes about a corner: where each goes, with its letter.
pub(super) fn axes(pen: &mut Pen, corner: DVec2, axes: &[(DVec2, char)]) {
    for (end, letter) in axes {
        pen.line("a", &[corner, corner + *end]);
        pen.arrow("aa", corner + *end, *end);
        pen.text("l", &letter.to_string(), corner + *end + end.normalize_or_zero() * 8.0);
    }
}

/// How wide a line of the legend with all of these words is.
pub(super) fn legend_width<'w>(ways: impl Iterator<Item = (Way, &'w String)>) -> f64 {
    ways.map(|(_, word)| 38.0 + Pen::size(word).x).sum()
}

/// Draws what the lines mean, from a place to the right and, where the sheet ends, upwards.
pub(super) fn legend<'w>(pen: &mut Pen, at: DVec2, right: f64, ways: impl Iterator<Item = (Way, &'w String)>) {
    let DVec2 { mut x, mut y } = at;
    for (way, word) in ways {
        let size = Pen::size(word);
        if x + 34.0 + size.x > right {
            (x, y) = (at.x, y - 16.0);
        }
        let (from, to) = (DVec2::new(x, y), DVec2::new(x + 26.0, y));
        pen.line(class(way), &[from, to]);
        head(pen, way, (from + to) / 2.0 + DVec2::new(ARROW / 2.0, 0.0), DVec2::X);
        pen.text("l", word, DVec2::new(x + 30.0 + size.x / 2.0, y));
        x += 38.0 + size.x;
    }
}

/// Where the arrowhead of a way is: beyond the middle of its longest straight piece.
pub(super) fn arrow_place(points: &[DVec2]) -> Option<(DVec2, DVec2)> {
    let total: f64 = points.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum();
    if total < 14.0 {
        return None;
    }
    let mut left = total / 2.0 + ARROW / 2.0;
    for pair in points.windows(2) {
        let way = pair[1] - pair[0];
        if way.length() >= left {
            return Some((pair[0] + way.normalize() * left, way));
        }
        left -= way.length();
    }
    None
}

/// The part of a line inside a rectangle: what leaves it ends there.
pub(super) fn clip_line(points: &[DVec2], rect: &Rect) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for pair in points.windows(2) {
        let Some((a, b)) = clip_pair(pair[0], pair[1], rect) else { continue };
        if kept.last() != Some(&a) {
            kept.push(a);
        }
        kept.push(b);
    }
    kept
}

/// The part of a line between two places inside a rectangle.
pub(super) fn clip_pair(a: DVec2, b: DVec2, rect: &Rect) -> Option<(DVec2, DVec2)> {
    let way = b - a;
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        for (gap, speed) in [(rect.min[axis] - a[axis], way[axis]), (a[axis] - rect.max[axis], -way[axis])] {
            if speed == 0.0 {
                if gap > 0.0 {
                    return None;
                }
            } else if speed > 0.0 {
                begin = begin.max(gap / speed);
            } else {
                end = end.min(gap / speed);
            }
        }
    }
    (begin <= end).then(|| (a + way * begin, a + way * end))
}
