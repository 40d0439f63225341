//! What is left of a blank in a plane along the main and the tool axis: the height of the material over the main axis.
//!
//! Invariant: whatever the tool went through is gone from there upwards, as tools cut that come from above.
use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3};

use super::stroke::{Stroke, Way};
use crate::base::expr::tand;

/// Heights that differ by less are one.
const LEVEL: f64 = 1e-6;
/// A way that sinks is cut into pieces of at most so many millimetres.
const PIECE: f64 = 0.5;
/// So many straight pieces make the section of a rounded corner.
const ROUND: usize = 8;

/// A stretch of the main axis with a straight bottom.
#[derive(Clone, Copy, Debug)]
struct Cut {
    from: f64,
    to: f64,
    bottom: [f64; 2],
}

impl Cut {
    fn at(&self, u: f64) -> f64 {
        let share = if self.to > self.from { (u - self.from) / (self.to - self.from) } else { 0.0 };
        self.bottom[0] + (self.bottom[1] - self.bottom[0]) * share
    }
}

/// The surface after the strokes in the plane at that secondary coordinate: points from `left` to `right`.
pub(super) fn surface(strokes: &[Stroke], minor: f64, [left, right]: [f64; 2], top: f64) -> Vec<DVec2> {
    let mut cuts: Vec<Cut> = Vec::new();
    for stroke in strokes.iter().filter(|stroke| stroke.way == Way::Feed) {
        for pair in stroke.points.windows(2) {
            sweep(pair[0], pair[1], stroke, minor, top, &mut cuts);
        }
    }
    let mut places: Vec<f64> = vec![left, right];
    places.extend(cuts.iter().flat_map(|cut| [cut.from, cut.to]).filter(|u| (left..right).contains(u)));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < LEVEL);
    let mut line: Vec<DVec2> = Vec::new();
    for pair in places.windows(2) {
        let middle = (pair[0] + pair[1]) / 2.0;
        let over = cuts.iter().filter(|cut| cut.from < middle && middle < cut.to);
        let lowest = over.min_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
        for u in [pair[0], pair[1]] {
            let height = lowest.map_or(top, |cut| cut.at(u).min(top));
            add(&mut line, DVec2::new(u, height));
        }
    }
    line
}

/// Adds a point, without keeping points between two others on a line.
fn add(line: &mut Vec<DVec2>, p: DVec2) {
    if line.last().is_some_and(|last| (*last - p).length() < LEVEL) {
        return;
    }
    if let [.., a, b] = line.as_slice()
        && (*b - *a).perp_dot(p - *b).abs() < LEVEL * (p - *a).length()
    {
        line.pop();
    }
    line.push(p);
}

/// What a tool takes away on a straight way.
fn sweep(from: DVec3, to: DVec3, stroke: &Stroke, minor: f64, top: f64, cuts: &mut Vec<Cut>) {
    if from.z.min(to.z) >= top - LEVEL {
        return;
    }
    let flat = (to - from).truncate().length();
    if flat < LEVEL {
        let low = if from.z < to.z { from } else { to };
        plunge(low, stroke, minor, cuts);
        return;
    }
    let sinks = (to.z - from.z).abs() > LEVEL;
    let pieces = if sinks { (flat / PIECE).ceil().clamp(1.0, 60.0) as usize } else { 1 };
    for n in 0..pieces {
        let place = |k: usize| from.lerp(to, k as f64 / pieces as f64);
        let (a, b) = (place(n), place(n + 1));
        if stroke.tool.corner > 0.0 {
            rounded(a, b, stroke, minor, cuts);
            continue;
        }
        let reach = band(a.truncate(), b.truncate(), stroke.tool.radius, minor);
        let bottom = a.z.max(b.z);
        let known = |cut: &&mut Cut| {
            (cut.bottom[0] - bottom).abs() < LEVEL
                && (cut.bottom[1] - bottom).abs() < LEVEL
                && reach.is_some_and(|[l, r]| l <= cut.to && cut.from <= r)
        };
        match (reach, cuts.iter_mut().find(known)) {
            (Some([l, r]), Some(cut)) => (cut.from, cut.to) = (cut.from.min(l), cut.to.max(r)),
            (Some([l, r]), None) => cuts.push(Cut { from: l, to: r, bottom: [bottom; 2] }),
            (None, _) => {}
        }
    }
}

/// What a tool takes away that goes straight down to a point: its tip may be pointed.
fn plunge(low: DVec3, stroke: &Stroke, minor: f64, cuts: &mut Vec<Cut>) {
    let radius = stroke.tool.radius;
    let half = half_chord(radius, low.y - minor);
    if half <= 0.0 {
        return;
    }
    if stroke.tool.corner > 0.0 && stroke.tool.point <= 0.0 {
        return rounded(low, low, stroke, minor, cuts);
    }
    let rise = if stroke.tool.point > 0.0 { half / tand(stroke.tool.point / 2.0) } else { 0.0 };
    if rise > 0.0 {
        cuts.push(Cut { from: low.x - half, to: low.x, bottom: [low.z + rise, low.z] });
        cuts.push(Cut { from: low.x, to: low.x + half, bottom: [low.z, low.z + rise] });
    } else {
        cuts.push(Cut { from: low.x - half, to: low.x + half, bottom: [low.z; 2] });
    }
}

/// What a tool with a rounded end takes away on a straight way: a floor, and pieces that rise from it on both sides.
fn rounded(a: DVec3, b: DVec3, stroke: &Stroke, minor: f64, cuts: &mut Vec<Cut>) {
    let radius = stroke.tool.radius;
    let corner = stroke.tool.corner.min(radius);
    let bottom = a.z.max(b.z);
    // How far the way stays from the line, at least: no place of it is cut by what is nearer to the axis of the tool.
    let (near, far) = (a.y.min(b.y) - minor, a.y.max(b.y) - minor);
    let off = near.max(-far).max(0.0);
    let from = libm::asin(((off - (radius - corner)) / corner).clamp(0.0, 1.0));
    let mut inner: Option<([f64; 2], f64)> = None;
    for n in 0..=ROUND {
        let angle = from + (FRAC_PI_2 - from) * n as f64 / ROUND as f64;
        // A little more than the least of them, so that it meets the line.
        let ring = (radius - corner + corner * libm::sin(angle)).max(off + LEVEL);
        let height = bottom + corner * (1.0 - libm::cos(angle));
        let Some([l, r]) = band(a.truncate(), b.truncate(), ring, minor) else { continue };
        match inner {
            None => cuts.push(Cut { from: l, to: r, bottom: [height; 2] }),
            Some(([il, ir], lower)) => {
                cuts.push(Cut { from: l, to: il, bottom: [height, lower] });
                cuts.push(Cut { from: ir, to: r, bottom: [lower, height] });
            }
        }
        inner = Some(([l, r], height));
    }
}

fn half_chord(radius: f64, off: f64) -> f64 {
    let square = radius * radius - off * off;
    if square > 0.0 { square.sqrt() } else { 0.0 }
}

/// The stretch of the line at `minor` over which a disc goes on its straight way: its track is convex.
fn band(a: DVec2, b: DVec2, radius: f64, minor: f64) -> Option<[f64; 2]> {
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut take = |u: f64| (least, greatest) = (least.min(u), greatest.max(u));
    for end in [a, b] {
        let half = half_chord(radius, end.y - minor);
        if half > 0.0 {
            take(end.x - half);
            take(end.x + half);
        }
    }
    let way = b - a;
    if way.y.abs() > LEVEL {
        let side = way.normalize().perp() * radius;
        for edge in [a + side, a - side] {
            let share = (minor - edge.y) / way.y;
            if (0.0..=1.0).contains(&share) {
                take(edge.x + way.x * share);
            }
        }
    }
    (least < greatest).then_some([least, greatest])
}
