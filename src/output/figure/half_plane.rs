//! The half plane of turning: the insert to scale, and what its cuts leave of the blank.
//!
//! `x` is the rotary axis and `y` the radius. Invariant: the insert takes away what it sweeps at a feed, and nothing else;
//! of a thread, what it covers once a revolution.
use glam::DVec2;

use super::slabs;
use super::stroke::{Stroke, Way};
use crate::base::expr::{atan2d, cosd, sind};

/// Points that are nearer to each other are one, mm.
const SAME: f64 = 1e-5;
/// What is smaller is not seen, mm².
pub(super) const SPECK: f64 = 0.02;
/// How far the edges of an insert go from its nose where the table does not say it, mm.
const EDGE: f64 = 12.0;
/// The angles of an insert of which the table says none: a rhombus of 80 degrees, as most roughing tools have.
const USUAL: [f64; 2] = [95.0, 80.0];
/// A nose is drawn by chords over so many degrees.
const CHORD: f64 = 10.0;

/// How an insert stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stand {
    /// The signs of the directions from the centre of its nose to its tip: along the rotary axis, and of the radius.
    pub(super) tip: DVec2,
    /// Whether it goes into the part along the rotary axis, if it is one for recesses or threads.
    pub(super) axial: bool,
    /// The pitch of the thread that it cuts, mm.
    pub(super) pitch: Option<f64>,
}

/// An insert as a tool table describes it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Insert {
    /// The radius of its nose, mm.
    pub(super) radius: f64,
    /// The length of its edges, mm, if it is known.
    pub(super) length: Option<f64>,
    /// The width of one for recesses, mm.
    pub(super) width: Option<f64>,
    /// The angle of its edge from the direction of the feed, and that of its point, degrees.
    pub(super) angles: Option<[f64; 2]>,
}

/// A blank: what is between two places, but for a convex polygon.
#[derive(Clone, Debug)]
pub(super) struct Blank {
    pub(super) least: DVec2,
    pub(super) greatest: DVec2,
    pub(super) lacks: Vec<DVec2>,
}

/// What is turned, as it is at a moment.
#[derive(Clone, Debug, Default)]
pub(super) struct HalfPlane {
    /// The insert about its tip.
    pub(super) insert: Vec<DVec2>,
    /// The outline of the blank.
    pub(super) blank: Vec<Vec<DVec2>>,
    /// What is left of it: closed lines, holes among them.
    pub(super) left: Vec<Vec<DVec2>>,
    /// What will be left of it at the end of the run, if that is something else.
    pub(super) finished: Vec<Vec<DVec2>>,
}

impl HalfPlane {
    /// What is left of a blank after the ways of an insert, and after later ones.
    pub(super) fn new(stand: Stand, insert: Insert, blank: Blank, [strokes, later]: [&[Stroke]; 2]) -> Self {
        let insert = outline(stand, insert);
        let edges = [blank.least, blank.greatest];
        let mut taken: Vec<Vec<DVec2>> = vec![blank.lacks];
        let blank = without(edges, &taken);
        taken.extend(cuts(strokes, &insert, stand));
        let left = without(edges, &taken);
        let later = cuts(later, &insert, stand);
        let finished = if later.is_empty() {
            Vec::new()
        } else {
            taken.extend(later);
            without(edges, &taken)
        };
        Self { insert, blank, left, finished }
    }

    /// The outlines of the blank and of what is or will be left of it.
    fn lines(&self) -> impl Iterator<Item = &Vec<DVec2>> {
        self.blank.iter().chain(&self.left).chain(&self.finished)
    }

    /// Whether a corner of the blank or of what is or will be left has a coordinate, of the rotary axis (0) or of the radius (1).
    pub(super) fn has(&self, axis: usize, at: f64) -> bool {
        self.lines().flatten().any(|p| (p[axis] - at).abs() < 1e-3)
    }

    /// How far a place is from the surface of the blank or of what is or will be left.
    pub(super) fn distance(&self, place: DVec2) -> f64 {
        let sides = self.lines().flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
        sides.map(|(a, b)| distance(place, *a, *b)).fold(f64::INFINITY, f64::min)
    }
}

/// How far a point is from a line between two others.
pub(super) fn distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let way = b - a;
    let share =
        if way.length_squared() > 0.0 { ((p - a).dot(way) / way.length_squared()).clamp(0.0, 1.0) } else { 0.0 };
    (p - a - way * share).length()
}

/// The outlines of what is left of a blank without some polygons, without specks.
fn without(blank: [DVec2; 2], cuts: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    let [min, max] = blank;
    let meets = |cut: &&Vec<DVec2>| {
        let (low, high) = bounds(cut);
        low.cmplt(max).all() && high.cmpgt(min).all()
    };
    let cuts: Vec<Vec<DVec2>> = cuts.iter().filter(meets).cloned().collect();
    let lines = slabs::left(blank, &cuts).into_iter().map(|line| corners_of(&line));
    lines.filter(|line| line.len() > 2 && area(line).abs() > SPECK).collect()
}

/// The area within a closed line, negative of one that runs clockwise.
pub(super) fn area(line: &[DVec2]) -> f64 {
    line.iter().zip(line.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)))
}

/// The corners of a closed line, without those that lie between two others.
pub(super) fn corners_of(line: &[DVec2]) -> Vec<DVec2> {
    let mut corners: Vec<DVec2> = Vec::new();
    // Begins at a corner, the lowest one farthest to the left.
    let first =
        (0..line.len()).min_by(|a, b| line[*a].x.total_cmp(&line[*b].x).then(line[*a].y.total_cmp(&line[*b].y)));
    for p in line.iter().cycle().skip(first.unwrap_or_default()).take(line.len()).copied() {
        if corners.last().is_some_and(|last| last.distance(p) < 1e-3) {
            continue;
        }
        if let [.., a, b] = corners.as_slice()
            && (*b - *a).perp_dot(p - *b).abs() < 1e-4 * (p - *a).length()
            && (*b - *a).dot(p - *b) > 0.0
        {
            corners.pop();
        }
        corners.push(p);
    }
    corners
}

/// What the insert takes away: convex polygons.
fn cuts(strokes: &[Stroke], insert: &[DVec2], stand: Stand) -> Vec<Vec<DVec2>> {
    let mut all: Vec<Vec<DVec2>> = Vec::new();
    let mut gone = 0.0;
    for stroke in strokes {
        if stroke.way != Way::Feed {
            gone = 0.0;
            continue;
        }
        let points: Vec<DVec2> = stroke.points.iter().map(|p| DVec2::new(p.z, p.x)).collect();
        for pair in points.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            match stand.pitch {
                Some(pitch) => gone = turns((from, to), (pitch, gone), stand, insert, &mut all),
                None => all.push(hull(insert, from, to)),
            }
        }
    }
    let mut once: Vec<Vec<DVec2>> = Vec::new();
    for cut in all {
        if !once.contains(&cut) {
            once.push(cut);
        }
    }
    once
}

/// Where the insert is after each revolution on a straight way; how far it has gone along the thread at its end.
fn turns(
    (from, to): (DVec2, DVec2),
    (pitch, gone): (f64, f64),
    stand: Stand,
    insert: &[DVec2],
    all: &mut Vec<Vec<DVec2>>,
) -> f64 {
    let axis = usize::from(stand.axial);
    let way = (to - from)[axis].abs();
    if way < SAME {
        return gone;
    }
    let mut turn = (gone / pitch - SAME).ceil().max(0.0);
    while turn * pitch <= gone + way + SAME {
        let at = from.lerp(to, (turn * pitch - gone) / way);
        all.push(insert.iter().map(|p| *p + at).collect());
        turn += 1.0;
    }
    gone + way
}

/// What an insert covers on a straight way.
fn hull(insert: &[DVec2], from: DVec2, to: DVec2) -> Vec<DVec2> {
    around(insert.iter().flat_map(|p| [*p + from, *p + to]).collect())
}

/// The convex line around some points.
pub(super) fn around(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup_by(|a, b| a.distance(*b) < SAME);
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut kept: Vec<DVec2> = Vec::new();
        for p in points {
            while let [.., a, b] = kept.as_slice()
                && (*b - *a).perp_dot(p - *b) <= 1e-9
            {
                kept.pop();
            }
            kept.push(p);
        }
        kept.pop();
        kept
    };
    let mut hull = half(&mut points.iter().copied());
    hull.extend(half(&mut points.iter().rev().copied()));
    hull
}

/// An insert about its tip.
fn outline(stand: Stand, insert: Insert) -> Vec<DVec2> {
    let length = insert.length.unwrap_or(EDGE);
    match insert.width {
        Some(width) => recessing(stand, insert.radius, width, length),
        None => {
            let [angle, point] = insert.angles.unwrap_or(USUAL);
            pointed(stand, insert.radius, [angle, angle + point], length)
        }
    }
}

/// An insert for recesses: its tip is one of its two corners.
fn recessing(stand: Stand, radius: f64, width: f64, length: f64) -> Vec<DVec2> {
    let (along, radial) = (DVec2::new(stand.tip.x, 0.0), DVec2::new(0.0, stand.tip.y));
    let (into, across) = if stand.axial { (along, radial) } else { (radial, along) };
    let at = |over: f64, back: f64| -(across * over) - into * back;
    let mut points = Vec::new();
    if radius > 0.0 {
        let turns = (90.0 / CHORD) as usize;
        let arc = |n: usize| {
            let angle = 90.0 * n as f64 / turns as f64;
            (radius * cosd(angle), radius * sind(angle))
        };
        points.extend((0..=turns).map(arc).map(|(c, s)| at(radius - c, radius - s)));
        points.extend((0..=turns).map(arc).map(|(c, s)| at(width - radius + s, radius - c)));
    } else {
        points.extend([at(0.0, 0.0), at(width, 0.0)]);
    }
    points.extend([at(width, length), at(0.0, length)]);
    points
}

/// An insert with a nose between two edges; their angles count from the direction of the feed.
fn pointed(stand: Stand, radius: f64, angles: [f64; 2], length: f64) -> Vec<DVec2> {
    let [front, back] = angles.map(|angle| {
        let (along, away) = (cosd(angle), sind(angle));
        if stand.axial {
            DVec2::new(-away * stand.tip.x, along * stand.tip.y)
        } else {
            DVec2::new(along * stand.tip.x, -away * stand.tip.y)
        }
    });
    let centre = -stand.tip * radius;
    let out = |edge: DVec2, other: DVec2| if edge.perp().dot(other) < 0.0 { edge.perp() } else { -edge.perp() };
    let (first, last) = (out(front, back), out(back, front));
    let mut points = Vec::new();
    if radius > 0.0 {
        let from = atan2d(first.y, first.x);
        let sweep = (atan2d(last.y, last.x) - from + 180.0).rem_euclid(360.0) - 180.0;
        let mut turns: Vec<f64> = (0..=(sweep.abs() / CHORD).ceil() as usize)
            .map(|n| (n as f64 * CHORD).min(sweep.abs()))
            // Where the nose is farthest along an axis.
            .chain([0.0, 90.0, 180.0, 270.0].map(|side| ((side - from) * sweep.signum()).rem_euclid(360.0)))
            .filter(|turn| *turn <= sweep.abs())
            .collect();
        turns.sort_by(f64::total_cmp);
        turns.dedup_by(|a, b| (*a - *b).abs() < 0.5);
        let place = |turn: f64| from + turn * sweep.signum();
        points.extend(turns.into_iter().map(place).map(|angle| centre + DVec2::new(cosd(angle), sind(angle)) * radius));
    } else {
        points.push(centre);
    }
    let (begin, end) = (centre + first * radius, centre + last * radius);
    points.extend([end + back * length, begin.midpoint(end) + (front + back) * length, begin + front * length]);
    points
}
