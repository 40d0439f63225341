//! Strategies that say what is turned: a shoulder, or one with a plunge, from the values of a cycle.
//!
//! The end point of the contour is the corner between the surface that the cuts follow and the wall at which they end
//! (TNC 640 manual, lines 7553-7666); the wall goes out to where the contour begins. Invariant: nothing moves.
use std::f64::consts::SQRT_2;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::area::{Sight, Turned};
use super::insert_report::{Held, hold};
use crate::base::expr::{atan2d, tand};
use crate::engine::machine::TurningInsert;
use crate::engine::region::insert_envelope::{Allowance, Envelope, GoesBack, Insert};
use crate::engine::region::{Edge, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::milling::shape_impossible;
use crate::engine::strategy::signature::{results, strategy};

strategy! {
    /// A shoulder is turned: from where the cycle began, or from where its contour begins.
    TurnShoulder = "turn-shoulder" {
        /// Whether the cuts go across the rotary axis.
        face: bool = Number,
        /// Whether the contour begins with a flank on which the insert plunges.
        plunges: Option<bool> = Number,
        /// Where the cycle began, with a diameter as its main coordinate.
        start: DVec3 = Length,
        /// The diameter at which the contour begins.
        start_diameter: f64 = Length,
        /// Its coordinate on the rotary axis.
        start_z: f64 = Length,
        /// The diameter at which it ends.
        end_diameter: f64 = Length,
        /// Its coordinate on the rotary axis there.
        end_z: f64 = Length,
        /// The angle of the surface that the cuts follow, or of the flank to a right angle, degrees.
        surface: Option<f64> = Angle,
        /// The angle of the wall to a right angle, degrees.
        wall: Option<f64> = Angle,
        /// The radius of the corner between them, mm.
        corner: Option<f64> = Length,
        /// At the beginning: 1 a chamfer, 2 a rounding.
        start_element: Option<f64> = Number,
        /// Its size, mm.
        start_size: Option<f64> = Length,
        /// At the end: 1 a chamfer, 2 a rounding.
        end_element: Option<f64> = Number,
        /// Its size, mm.
        end_size: Option<f64> = Length,
        /// What stays on diameters, mm.
        diameter_oversize: f64 = Length,
        /// What stays along the rotary axis, mm.
        z_oversize: f64 = Length,
        /// The set-up clearance, mm.
        clearance: f64 = Length,
        /// The greatest infeed, mm.
        depth: f64 = Length,
    }
}

results! {
    /// The levels of an area that is turned: diameters, or coordinates on the rotary axis.
    TurnedArea {
        /// Where infeeds begin.
        from: f64 = Length,
        /// Where they end.
        to: f64 = Length,
        /// The infeed, all being the same.
        infeed: f64 = Length,
        /// What the insert cannot reach, mm.
        left: f64 = Length,
    }
}

/// The insert of the tool in the spindle, as cuts see it, and where its tip is from the centre of its nose, in nose
/// radii.
pub(super) fn insert_of(control: &dyn Control, sight: Sight) -> Result<(Insert, DVec2), Fault> {
    let own = control.insert()?;
    let tip = sight.tip(own.way).ok_or_else(|| points_elsewhere(&own))?;
    Ok((sight.insert(own.radius, own.angle, own.point), tip))
}

/// Where the insert touches the blank that turning updates, if it does.
pub(super) fn material_of(
    control: &dyn Control,
    sight: Sight,
    insert: Insert,
    tip: DVec2,
) -> Result<Option<Arc<Envelope>>, Fault> {
    if !control.updates_blank() {
        return Ok(None);
    }
    let outline = control.outline_of_blank(&|way| sight.seen_way(way));
    let found = Turned::over_blank(outline, insert, tip).map_err(|GoesBack| shape_impossible(0.0, 0.0))?;
    Ok(Some(Arc::new(found)))
}

/// The fault of an insert that does not point to the part, or not in the direction of the cuts.
pub(super) fn points_elsewhere(insert: &TurningInsert) -> Fault {
    Fault::control("insert-direction").arg("tool", insert.tool).arg("orientation", insert.orientation())
}

/// The area of what is turned, with infeeds that are all the same and not greater than a depth.
pub(super) fn area_of(turned: &Turned, depth: f64) -> Result<TurnedArea, Fault> {
    let [from, to] = turned.heights();
    let whole = from - to;
    if !(depth > 0.0) {
        return Err(Fault::program("parameter-out-of-range").arg("q", "").arg("value", depth));
    }
    let cuts = libm::ceil(whole / depth - 1e-9).max(1.0);
    let scale = turned.sight.level(1.0).abs();
    let (from, to) = (turned.sight.level(from), turned.sight.level(to.min(from)));
    Ok(TurnedArea { from, to, infeed: (whole / cuts).max(0.0) * scale, left: turned.left })
}

impl TurnShoulder {
    fn sight(&self) -> Sight {
        let towards = |from: f64, to: f64| if to < from { -1.0 } else { 1.0 };
        let (out, along) = (towards(self.end_diameter, self.start_diameter), towards(self.start_z, self.end_z));
        match self.face {
            true => Sight { face: true, ahead: -out, away: -along },
            false => Sight { face: false, ahead: along, away: out },
        }
    }

    fn profile(&self, sight: Sight) -> Result<Way, Fault> {
        let seen = |diameter: f64, z: f64| sight.seen(diameter / 2.0, z);
        let (start, end) = (seen(self.start_diameter, self.start_z), seen(self.end_diameter, self.end_z));
        let angle = |angle: Option<f64>| tand(angle.unwrap_or_default());
        let (first, wall) = (angle(self.surface), angle(self.wall));
        let size = |element: Option<f64>, size: Option<f64>| match element.unwrap_or_default() {
            0.0 => Treated::Sharp,
            1.0 => Treated::Chamfer(size.unwrap_or_default()),
            _ => Treated::Round(size.unwrap_or_default()),
        };
        let corner = Treated::Round(self.corner.unwrap_or_default());
        let outer = DVec2::new(end.x + wall * (start.y - end.y), start.y);
        let begin = size(self.start_element, self.start_size);
        let out = |at: DVec2, by: DVec2| (at + by, Treated::Sharp);
        // One element more at either end for the corner there; it is no part of the contour.
        let far = (start - end).length().max(1.0);
        let mut points = Vec::with_capacity(6);
        if self.plunges == Some(true) {
            let foot = DVec2::new(start.x + first * (start.y - end.y), end.y);
            points.extend([out(start, DVec2::new(-far, 0.0)), (start, begin), (foot, corner)]);
        } else {
            let near = DVec2::new(start.x, end.y - first * (end.x - start.x));
            points.extend([out(near, DVec2::new(0.0, -far)), (near, begin)]);
        }
        points.extend([
            (end, corner),
            (outer, size(self.end_element, self.end_size)),
            out(outer, DVec2::new(far, 0.0)),
        ]);
        way_through(&points)
    }
}

impl Action for TurnShoulder {
    type Results = TurnedArea;

    fn act(&self, control: &mut dyn Control) -> Done<TurnedArea> {
        let sight = self.sight();
        let (insert, tip) = insert_of(control, sight)?;
        let (across, along) = (self.diameter_oversize / 2.0, self.z_oversize);
        let allowance = match self.face {
            true => Allowance { along: across, away: along },
            false => Allowance { along, away: across },
        };
        let profile = self.profile(sight)?;
        let start = sight.seen(self.start.x / 2.0, self.start.z);
        let turned =
            Turned::new(sight, &profile, (allowance, insert, tip), (start, self.clearance), self.plunges == Some(true));
        let turned = turned.map_err(|GoesBack| shape_impossible(0.0, 0.0))?;
        let turned = turned.of_blank(material_of(control, sight, insert, tip)?.as_ref());
        let area = area_of(&turned, self.depth)?;
        control.keep_turned(turned);
        hold(control, sight, Held::Pointed(insert, tip))?;
        Ok(area)
    }
}

/// What becomes of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Treated {
    Sharp,
    /// The length of the chamfer on either side, mm.
    Chamfer(f64),
    /// The radius, mm.
    Round(f64),
}

/// A corner of a way, and what becomes of it.
struct Turning {
    at: DVec2,
    into: DVec2,
    out: DVec2,
    /// From the direction of the one side to that of the other: the sign of the turn, and the angle, degrees.
    side: f64,
    angle: f64,
    treated: Treated,
    /// How much of either side it takes, mm.
    cut: f64,
}

impl Turning {
    fn new(before: DVec2, (at, treated): (DVec2, Treated), after: DVec2) -> Self {
        let (into, out) = ((at - before).normalize_or_zero(), (after - at).normalize_or_zero());
        let turn = into.perp_dot(out);
        let angle = atan2d(turn.abs(), into.dot(out));
        let cut = match treated {
            _ if turn.abs() < 1e-9 => 0.0,
            Treated::Sharp => 0.0,
            Treated::Chamfer(length) => length.abs(),
            Treated::Round(radius) => radius.abs() * tand(angle / 2.0),
        };
        Self { at, into, out, side: turn.signum(), angle, treated, cut }
    }
}

/// The way through points with treated corners, without the first and the last element.
///
/// # Errors
/// There is no room for what becomes of a corner, alone or beside that of the next one.
pub(super) fn way_through(points: &[(DVec2, Treated)]) -> Result<Way, Fault> {
    let mut corners: Vec<Turning> = Vec::with_capacity(points.len());
    for around in points.windows(3) {
        let &[(before, _), at, (after, _)] = around else { continue };
        let corner = Turning::new(before, at, after);
        let room = before.distance(corner.at).min(corner.at.distance(after));
        if corner.cut > room + 1e-9 {
            return Err(shape_impossible(corner.cut, room));
        }
        if let Some(last) = corners.last()
            && last.cut + corner.cut > last.at.distance(corner.at) + 1e-9
        {
            let fault = Fault::program("elements-overlap").arg("least", last.cut + corner.cut);
            return Err(fault.arg("found", last.at.distance(corner.at)));
        }
        corners.push(corner);
    }
    let mut way: Option<Way> = None;
    for corner in corners {
        let (first, second) = (corner.at - corner.into * corner.cut, corner.at + corner.out * corner.cut);
        let way = match &mut way {
            None => way.insert(Way { start: first, edges: Vec::new() }),
            Some(way) => {
                if way.end().distance(first) > 1e-9 {
                    way.edges.push(Edge::Line(first));
                }
                way
            }
        };
        if corner.cut > 0.0 {
            way.edges.push(match corner.treated {
                Treated::Round(radius) => {
                    let centre = first + corner.into.perp() * (radius.abs() * corner.side);
                    Edge::Arc { to: second, centre, sweep: corner.angle * corner.side }
                }
                _ => Edge::Line(second),
            });
        }
    }
    way.filter(|way| !way.edges.is_empty()).ok_or_else(|| shape_impossible(SQRT_2, 0.0))
}
