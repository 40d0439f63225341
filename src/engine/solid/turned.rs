//! Inserts in the half plane of turning: the ways of their tips there, and what they take away of a half section.
//!
//! The half plane has the rotary axis as `x` and the radius as `y`. Invariant: an insert takes away what it sweeps, as if
//! the workpiece turned without end.
use glam::{DVec2, DVec3};

use super::Path;
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::Frame;
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::region::section::{Cell, Section};
use crate::engine::region::sweep::{Rounded, TipWay};

/// The edges of an insert are so long, mm, if the tool table does not say it.
const EDGE: f64 = 10_000.0;
/// How far from the rotary axis is on it, mm; how far directions may differ.
const SAME: f64 = 1e-6;

/// A way in the half plane, and whether its rotary axis has the direction of that of the program (1) or not (-1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfWay {
    /// The way of the tip.
    pub way: TipWay,
    /// The sense of the rotary axis.
    pub sense: f64,
}

impl HalfWay {
    /// A path in machine coordinates in the half plane of a rotary axis (a point of it and its direction), and the frame
    /// of the program. Nothing if the program has its rotary axis elsewhere, or the path is not in the plane through it.
    pub fn of(path: &Path, (origin, axis): (DVec3, DVec3), program: &Frame) -> Option<Self> {
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
        Some(Self { way, sense })
    }
}

/// An insert in the half plane.
#[derive(Clone, Debug)]
pub struct Shaped {
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
pub struct Taken {
    /// Volume, mm³.
    pub volume: f64,
    /// The greatest thickness of material, mm, radially.
    pub depth: f64,
    /// The least and the greatest distance from the way, on its left.
    across: [f64; 2],
    /// How far from the nose material was met, mm.
    pub reach: f64,
}

impl Taken {
    const NOTHING: Self = Self { volume: 0.0, depth: 0.0, across: [f64::INFINITY, f64::NEG_INFINITY], reach: 0.0 };

    /// The extent of what was cut across the way, mm.
    pub fn width(&self) -> f64 {
        (self.across[1] - self.across[0]).max(0.0)
    }
}

impl Shaped {
    /// An insert that is turned so; `skin` is what its smaller form lacks on all sides, mm.
    pub fn new(insert: &Insert, sense: f64, skin: f64) -> Self {
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
    pub fn has_sense(&self, sense: f64) -> bool {
        self.sense == sense
    }

    /// Takes away what it meets on a way: all of it, or what is deeper than the skin. What it did with its edges, and
    /// with what is behind them.
    pub fn cut(&self, section: &mut Section, way: TipWay, all: bool, joined: bool) -> (Taken, Taken) {
        let which = usize::from(all);
        let (mut done, mut behind) = (Taken::NOTHING, Taken::NOTHING);
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

    fn note(&self, done: &mut Taken, cell: &Cell, way: TipWay) {
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
