//! What is turned: a body of revolution with its half section, and the insert that cuts it.
//!
//! The half plane has the rotary axis as `x` and the radius as `y`. Invariant: the half section is exact; an insert
//! takes away what it sweeps, as if the workpiece turned without end.
use glam::{DVec2, DVec3};

use super::Blank;
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::Frame;
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::region::section::{Cell, Section};
use crate::engine::region::sweep::{Rounded, TipWay};
use crate::engine::region::{Edge, Way};
use crate::engine::solid::{Path, Shape};

/// The edges of an insert are so long, mm, if the tool table does not say it.
const EDGE: f64 = 10_000.0;
/// How far from the rotary axis is on it, mm; how far directions may differ.
const SAME: f64 = 1e-6;

/// A body of revolution.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// Its half section.
    pub section: Section,
    /// A point of its axis and the direction of that, in the coordinates of the blank.
    line: (DVec3, DVec3),
    /// From the coordinates of the blank to the machine.
    frame: Frame,
}

/// A way in the half plane, and whether its rotary axis has the direction of that of the program (1) or not (-1).
pub(super) struct HalfWay {
    pub way: TipWay,
    pub sense: f64,
}

impl Body {
    /// The body that a blank is; nothing of another one, or of one that is not along or across the columns.
    pub(super) fn of(blank: &Blank) -> Option<Self> {
        let mut line = None;
        let section = section(&blank.shape, &mut line)?;
        let (origin, axis) = line?;
        let along = axis.dot(blank.axis.unit()).abs();
        let is_held = blank.frame.is_rigid() && (along < 1e-12 || along > 1.0 - 1e-12);
        is_held.then_some(Self { section, line: (origin, axis), frame: blank.frame })
    }

    /// A path in the half plane: machine coordinates, as the parts were at the start, and the frame of the program.
    /// Nothing if the program has its rotary axis elsewhere, or the path is not in the plane through it.
    pub(super) fn half(&self, path: &Path, program: &Frame) -> Option<HalfWay> {
        let (origin, axis) = (self.frame.point(self.line.0), self.frame.vector(self.line.1).normalize_or_zero());
        let (main, rotary) = (program.vector(DVec3::X).normalize_or_zero(), program.vector(DVec3::Z));
        let sense = rotary.dot(axis).signum();
        let off = (program.point(DVec3::ZERO) - origin).reject_from(axis).length();
        if off > SAME || rotary.reject_from(axis).length() > SAME || main.dot(axis).abs() > SAME {
            return None;
        }
        let across = axis.cross(main);
        let in_plane = |point: DVec3| (point - origin).dot(across).abs() <= SAME;
        let half = |point: DVec3| DVec2::new((point - origin).dot(axis), (point - origin).dot(main));
        let way = match *path {
            Path::Line { from, to } => {
                if !in_plane(from) || !in_plane(to) {
                    return None;
                }
                TipWay::Line { from: half(from), to: half(to) }
            }
            Path::Arc { centre, axis: about, from, sweep, rise } => {
                let standing = about.normalize_or_zero().dot(across);
                if !in_plane(from) || !in_plane(centre) || standing.abs() < 1.0 - SAME || rise.abs() > SAME {
                    return None;
                }
                TipWay::Arc { centre: half(centre), from: half(from), sweep: sweep * standing.signum() }
            }
        };
        Some(HalfWay { way, sense })
    }

    /// What a line holds of it, given in the coordinates of the blank: stretches from low to high.
    pub(super) fn along(&self, point: DVec3, up: DVec3) -> Vec<[f64; 2]> {
        let (origin, axis) = self.line;
        let arm = point - origin;
        let (place, leans) = (arm.dot(axis), up.dot(axis));
        if leans.abs() > 0.5 {
            let stretches = self.section.along(arm.reject_from(axis).length());
            let mut found: Vec<[f64; 2]> = stretches
                .into_iter()
                .map(|ends| ends.map(|x| (x - place) / leans))
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect();
            found.sort_by(|a, b| a[0].total_cmp(&b[0]));
            return found;
        }
        let middle = -arm.dot(up);
        let beside = (arm + up * middle).reject_from(axis).length();
        let half = |radius: f64| libm::sqrt((radius * radius - beside * beside).max(0.0));
        let mut found = Vec::new();
        for [low, high] in self.section.at(place).into_iter().filter(|[_, high]| *high > beside) {
            let (inner, outer) = (half(low), half(high));
            if inner > 0.0 {
                found.extend([[middle - outer, middle - inner], [middle + inner, middle + outer]]);
            } else {
                found.push([middle - outer, middle + outer]);
            }
        }
        found.sort_by(|a, b| a[0].total_cmp(&b[0]));
        found
    }
}

/// The half section of a shape about an axis, which the first cylinder or cone gives.
fn section(shape: &Shape, line: &mut Option<(DVec3, DVec3)>) -> Option<Section> {
    match shape {
        Shape::Cylinder { from, to, radius } => {
            let [from, to] = ends(*from, *to, line)?;
            Some(Section::ring([from.min(to), from.max(to)], [0.0, *radius]))
        }
        Shape::Cone { from, to, radius_from, radius_to } => {
            let [from, to] = ends(*from, *to, line)?;
            let edges = [(to, 0.0), (to, *radius_to), (from, *radius_from)];
            let edges = edges.map(|(x, y)| Edge::Line(DVec2::new(x, y))).to_vec();
            Some(Section::within(&Way { start: DVec2::new(from, 0.0), edges }))
        }
        Shape::Sphere { centre, radius } => {
            let (origin, axis) = (*line)?;
            let arm = *centre - origin;
            let at = DVec2::new(arm.dot(axis), 0.0);
            let end = at - DVec2::X * *radius;
            let edges = vec![Edge::Arc { to: end, centre: at, sweep: 180.0 }];
            let start = at + DVec2::X * *radius;
            (arm.reject_from(axis).length() <= SAME).then(|| Section::within(&Way { start, edges }))
        }
        Shape::Union(shapes) => {
            let mut whole = Section::default();
            for shape in shapes {
                whole.add(&section(shape, line)?);
            }
            Some(whole)
        }
        Shape::Difference(shapes) => {
            let (first, others) = shapes.split_first()?;
            let mut rest = section(first, line)?;
            for shape in others {
                rest.take(&section(shape, line)?, &mut |_| {});
            }
            Some(rest)
        }
        Shape::HalfSpace { .. } | Shape::Box { .. } | Shape::Mesh(_) | Shape::Placed { .. } => None,
    }
}

/// The places of two points on an axis, which they are if there is none yet.
fn ends(from: DVec3, to: DVec3, line: &mut Option<(DVec3, DVec3)>) -> Option<[f64; 2]> {
    let (origin, axis) = *line.get_or_insert_with(|| {
        let axis = (to - from).normalize_or_zero();
        // Coordinates grow as those of the blank do.
        let axis = if axis.x + axis.y + axis.z < 0.0 { -axis } else { axis };
        (from - axis * from.dot(axis), axis)
    });
    let on = |point: DVec3| (point - origin).reject_from(axis).length() <= SAME;
    (on(from) && on(to)).then(|| [from, to].map(|point| (point - origin).dot(axis)))
}

/// An insert in the half plane.
#[derive(Clone, Debug)]
pub(super) struct Shaped {
    sense: f64,
    /// What its edges bound, and the same smaller by a skin.
    own: [Rounded; 2],
    /// Its noses alone, likewise.
    nose: [Rounded; 2],
    /// The same with edges without an end, if they have one.
    beyond: Option<Rounded>,
    /// From the tip to the centre of the nose.
    centre: DVec2,
}

/// What a move did.
#[derive(Clone, Copy, Debug)]
pub(super) struct Done {
    /// Volume, mm³.
    pub volume: f64,
    /// The greatest thickness of material, mm, radially.
    pub depth: f64,
    /// The least and the greatest distance from the way, on its left.
    across: [f64; 2],
    /// How far from the nose material was met, mm.
    pub reach: f64,
}

impl Done {
    const NOTHING: Self = Self { volume: 0.0, depth: 0.0, across: [f64::INFINITY, f64::NEG_INFINITY], reach: 0.0 };

    /// The extent of what was cut across the way, mm.
    pub(super) fn width(&self) -> f64 {
        (self.across[1] - self.across[0]).max(0.0)
    }
}

impl Shaped {
    /// An insert that is turned so; `skin` is what its smaller form lacks on all sides, mm.
    pub(super) fn new(insert: &Insert, sense: f64, skin: f64) -> Self {
        let direction = |angle: f64| DVec2::new(cosd(angle) * sense, sind(angle));
        let centre = -DVec2::new(insert.tip[1] * sense, insert.tip[0]) * insert.radius;
        let mut noses = vec![centre];
        let (width, across) = insert.width;
        if insert.form == InsertForm::Recessing {
            noses.push(centre + direction(across) * (width - 2.0 * insert.radius).max(0.0));
        }
        let with_edges = |length: f64| {
            let ends = noses.iter().flat_map(|nose| insert.edges.map(|edge| *nose + direction(edge) * length));
            let points: Vec<DVec2> = noses.iter().copied().chain(ends).collect();
            Rounded::around(&points, insert.radius)
        };
        let known = insert.length > 0.0;
        let both = |whole: Rounded| [whole.shrunk(skin), whole];
        let [own, nose] =
            [with_edges(if known { insert.length } else { EDGE }), Rounded::around(&noses, insert.radius)].map(both);
        let beyond = known.then(|| with_edges(EDGE));
        Self { sense, own, nose, beyond, centre }
    }

    /// Whether it was made for that sense of the rotary axis.
    pub(super) fn has_sense(&self, sense: f64) -> bool {
        self.sense == sense
    }

    /// Takes away what it meets on a way: all of it, or what is deeper than the skin. What it did with its edges, and
    /// with what is behind them.
    pub(super) fn cut(&self, section: &mut Section, way: TipWay, all: bool, joined: bool) -> (Done, Done) {
        let which = usize::from(all);
        let (mut done, mut behind) = (Done::NOTHING, Done::NOTHING);
        section.cut(&self.own[which].swept(way, joined), &mut |cell| self.note(&mut done, cell, way));
        if let (Some(beyond), true) = (&self.beyond, all) {
            section.cut(&beyond.swept(way, false), &mut |cell| self.note(&mut behind, cell, way));
        }
        // Beyond the axis a nose meets what comes round.
        let lowest = match way {
            TipWay::Line { from, to } => from.y.min(to.y),
            TipWay::Arc { centre, from, .. } => centre.y - centre.distance(from),
        };
        if lowest < 0.0 {
            let swept = self.nose[which].swept(way, joined).mirrored();
            section.cut(&swept, &mut |cell| self.note(&mut done, cell, way));
        }
        (done, behind)
    }

    fn note(&self, done: &mut Done, cell: &Cell, way: TipWay) {
        done.volume += cell.volume();
        done.depth = done.depth.max(cell.greatest());
        for corner in cell.corners() {
            let (across, reach) = match way {
                TipWay::Line { from, to } => {
                    let (along, arm) = (to - from, corner - from);
                    let share = (arm - self.centre).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
                    let near = from + self.centre + along * share.clamp(0.0, 1.0);
                    (along.normalize_or_zero().perp_dot(arm), near.distance(corner))
                }
                TipWay::Arc { centre, from, .. } => {
                    let apart = corner.distance(centre);
                    (apart, (corner - centre - self.centre).length() - centre.distance(from))
                }
            };
            done.across = [done.across[0].min(across), done.across[1].max(across)];
            done.reach = done.reach.max(reach.abs());
        }
    }
}
