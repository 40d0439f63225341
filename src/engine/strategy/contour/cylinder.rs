//! Strategies on the surface of a cylinder that the rotary table turns: a contour of its development, a slot along a
//! centre path, a ridge along one.
//!
//! The tool stays across the rotary axis and keeps its direction; the table turns what it mills under it. Heights are
//! distances from the rotary axis. Invariant: at rapid traverse the tool moves in its own direction, or at a height at
//! which it is clear of the cylinder.
use std::f64::consts::PI;

use glam::DVec2;

use super::cylinder_wall::{Beside, Ridge, along, beside, radii_of_walls, swing};
use crate::engine::geometry::Around;
use crate::engine::region::{Way, contours::Contour};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::milling::{shape_impossible, too_many};
use crate::engine::strategy::signature::{results, strategy};

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// What calculation may take from the room of a tool, mm.
const SPARE: f64 = 1e-6;
/// The datum may lie so far beside the rotary axis, mm: what setting it by touching may leave.
const CENTRED: f64 = 0.1;
/// A slot is reworked so often at most.
const MOST_REWORKS: usize = 1000;

strategy! {
    /// Reads the contour in the development of a cylinder, and looks where the tool and the datum are.
    WrapOnCylinder = "wrap-on-cylinder" {
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// Coordinates of X are degrees if 0, lengths if 1.
        dimensions: f64 = Number,
    }
}

results! {
    /// Where things are about the rotary axis.
    OnCylinder {
        /// How far the tool is from it in its own direction.
        height: f64 = Length,
        /// 1 if the datum lies on it, otherwise 0.
        centred: f64 = Number,
    }
}

impl Action for WrapOnCylinder {
    type Results = OnCylinder;

    fn act(&self, control: &mut dyn Control) -> Done<OnCylinder> {
        let wrong = |value: f64| Fault::program("parameter-out-of-range").arg("q", "").arg("value", value);
        if self.radius <= 0.0 {
            return Err(wrong(self.radius).into());
        }
        let mm_in_degree = match self.dimensions {
            0.0 => Some(self.radius * PI / 180.0),
            1.0 => None,
            other => return Err(wrong(other).into()),
        };
        let centred = f64::from(u8::from(control.datum_off_table()? <= CENTRED));
        let results = OnCylinder { height: control.around()?.height, centred };
        control.read_developed_contour(mm_in_degree)?;
        Ok(results)
    }
}

strategy! {
    /// Back along the tool to a height, at rapid traverse.
    RetractFromCylinder = "retract-from-cylinder" {
        /// The distance from the rotary axis, mm.
        height: f64 = Length,
    }
}

impl Action for RetractFromCylinder {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let here = control.around()?;
        if here.height < self.height {
            control.go_around(Around { height: self.height, ..here }, 1.0, RAPID)?;
        }
        Ok(())
    }
}

strategy! {
    /// Down along the tool to a level, at a feed.
    PlungeIntoCylinder = "plunge-into-cylinder" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Action for PlungeIntoCylinder {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let here = control.around()?;
        control.go_around(Around { height: self.level, ..here }, 1.0, self.at)
    }
}

/// The contour that was read.
fn contour(control: &dyn Control) -> Result<&Contour, Fault> {
    control.contours().open.first().ok_or_else(|| Fault::program("contour-not-defined"))
}

/// 1 with the tool on the left of the contour, -1 on its right.
fn side(contour: &Contour) -> f64 {
    f64::from(contour.side.signum())
}

/// Over a place at rapid traverse: back to a height, round and along, and down to it.
fn over(place: &Beside, radius: f64, height: f64, control: &mut dyn Control) -> Done {
    let here = control.around()?;
    let above = here.height.max(height);
    control.go_around(Around { height: above, ..here }, radius, RAPID)?;
    control.go_around(place.around(radius, above), radius, RAPID)?;
    control.go_around(place.around(radius, height), radius, RAPID)
}

/// Along a path at a level.
fn follow(path: &[Beside], (radius, level): (f64, f64), feed: f64, control: &mut dyn Control) -> Done {
    path.iter().try_for_each(|place| control.go_around(place.around(radius, level), radius, feed))
}

/// The way of the tool centre beside the contour, in the development.
fn way_beside(control: &dyn Control, allowance: f64) -> Result<Way, Fault> {
    let (contour, tool) = (contour(control)?, control.tool_radius());
    let mut ways = contour.way.beside((tool + allowance) * side(contour));
    // More than one: the tool does not get through between them.
    match (ways.pop(), ways.is_empty()) {
        (Some(way), true) => Ok(way),
        _ => Err(shape_impossible(2.0 * tool, 0.0)),
    }
}

strategy! {
    /// Over the beginning of the way beside a contour of the development.
    MoveOverWrappedContour = "move-over-wrapped-contour" {
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// What stays at the contour, mm.
        allowance: f64 = Length,
        /// The distance from the rotary axis at which the tool is clear of the cylinder, mm.
        height: f64 = Length,
    }
}

strategy! {
    /// Along a contour of the development at one level, with the tool pointing at the rotary axis.
    FollowWrappedContour = "follow-wrapped-contour" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// What stays at the contour, mm.
        allowance: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Action for MoveOverWrappedContour {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let way = way_beside(control, self.allowance)?;
        let first = Beside { centre: way.start, arm: DVec2::ZERO };
        over(&first, self.radius, self.height, control)
    }
}

impl Action for FollowWrappedContour {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let path = along(&way_beside(control, self.allowance)?);
        follow(&path, (self.radius, self.level), self.at, control)
    }
}

/// How far beside the centre path of a slot a tool is that mills its walls.
fn arm_in_slot(control: &dyn Control, width: f64, allowance: f64) -> Result<f64, Fault> {
    let (tool, room) = (control.tool_radius(), width / 2.0 - allowance);
    if tool > room + SPARE {
        return Err(shape_impossible(2.0 * tool, 2.0 * room));
    }
    Ok((room - tool).max(0.0))
}

/// Along a wall of a slot: forwards along the first one, back along the other. With RL the first one is on the right of
/// the centre path, so that both are milled in climb.
fn wall_of_slot(control: &dyn Control, arm: f64, share: f64, back: bool) -> Result<Vec<Beside>, Fault> {
    let contour = contour(control)?;
    let way = if back { contour.way.reversed() } else { contour.way.clone() };
    Ok(beside(&way, -side(contour) * arm, share))
}

/// The fault of a path without a place.
fn empty() -> Fault {
    Fault::program("contour-not-defined")
}

strategy! {
    /// Over the beginning of the first wall of a slot.
    MoveOverSlotStart = "move-over-slot-start" {
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// The width of the slot, mm.
        width: f64 = Length,
        /// What stays at each wall, mm.
        allowance: f64 = Length,
        /// The distance from the rotary axis at which the tool is clear of the cylinder, mm.
        height: f64 = Length,
    }
}

strategy! {
    /// Along a wall of a slot at one level, with the tool parallel to the radius through the centre path.
    FollowSlotWall = "follow-slot-wall" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// The width of the slot, mm.
        width: f64 = Length,
        /// What stays at each wall, mm.
        allowance: f64 = Length,
        /// Whether it is the opposite wall: from the end back over the beginning.
        back: bool = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Reworks both walls of a slot at its floor until nowhere more stays than the tolerance.
    ApproximateSlotWalls = "approximate-slot-walls" {
        /// The distance of the floor from the rotary axis, mm.
        level: f64 = Length,
        /// The radius of the cylinder, mm.
        radius: f64 = Length,
        /// The width of the slot, mm.
        width: f64 = Length,
        /// What stays at each wall, mm.
        allowance: f64 = Length,
        /// How much more than the allowance may stay, mm.
        tolerance: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Action for MoveOverSlotStart {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let arm = arm_in_slot(control, self.width, self.allowance)?;
        let first = *wall_of_slot(control, arm, 1.0, false)?.first().ok_or_else(empty)?;
        over(&first, self.radius, self.height, control)
    }
}

impl Action for FollowSlotWall {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let arm = arm_in_slot(control, self.width, self.allowance)?;
        let mut path = wall_of_slot(control, arm, 1.0, self.back)?;
        if self.back {
            // And across the slot to where it began.
            path.extend(wall_of_slot(control, arm, 1.0, false)?.first());
        }
        follow(&path, (self.radius, self.level), self.at, control)
    }
}

impl Action for ApproximateSlotWalls {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let arm = arm_in_slot(control, self.width, self.allowance)?;
        let radii = radii_of_walls(self.radius, self.level, arm, self.tolerance, MOST_REWORKS);
        for radius in radii.ok_or_else(|| too_many(MOST_REWORKS as f64))? {
            for back in [false, true] {
                let path = wall_of_slot(control, arm, radius / self.radius, back)?;
                follow(&path, (self.radius, self.level), self.at, control)?;
            }
        }
        Ok(())
    }
}

/// Declares a strategy that goes round a ridge.
macro_rules! on_ridge {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The radius of the cylinder, mm.
                radius: f64 = Length,
                /// The distance of the floor beside the ridge from the rotary axis, mm.
                floor: f64 = Length,
                /// The width of the ridge, mm.
                width: f64 = Length,
                /// What stays at each wall, mm.
                allowance: f64 = Length,
                $($more)*
            }
        }

        impl $name {
            fn round(&self, control: &dyn Control) -> Result<RoundRidge, Fault> {
                RoundRidge::new(control, self.radius, self.floor, self.width / 2.0 + self.allowance)
            }
        }
    };
}

on_ridge! {
    /// Over the starting point beside a ridge: half the width of the ridge and the diameter of the tool beside the
    /// beginning of its centre path.
    MoveOverRidgeStart = "move-over-ridge-start" {
        /// The distance from the rotary axis at which the tool is clear of the cylinder, mm.
        height: f64 = Length,
    }
}

on_ridge! {
    /// From the starting point onto the wall of a ridge on a tangential arc.
    ApproachRidgeWall = "approach-ridge-wall" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

on_ridge! {
    /// Once round a ridge at one level: along one wall, round the end on a semicircle, back along the other wall, and
    /// round the beginning.
    FollowRidgeWall = "follow-ridge-wall" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

on_ridge! {
    /// Off the wall of a ridge on a tangential arc, back to the starting point.
    LeaveRidgeWall = "leave-ridge-wall" {
        /// The distance of the level from the rotary axis, mm.
        level: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

/// The way of a tool round a ridge.
struct RoundRidge {
    ridge: Ridge,
    way: Way,
    /// Positive with the tool on the left of the centre path.
    side: f64,
    /// From the centre path to the tool on the wall, with sign.
    reach: f64,
    tool: f64,
}

impl RoundRidge {
    /// `half` is half the width of the ridge with its allowance.
    fn new(control: &dyn Control, radius: f64, floor: f64, half: f64) -> Result<Self, Fault> {
        let (contour, tool) = (contour(control)?, control.tool_radius());
        if half < 0.0 {
            return Err(shape_impossible(0.0, 2.0 * half));
        }
        let (side, reach) = (side(contour), half + tool);
        let ridge = Ridge::new(&contour.way, (radius, floor), reach, tool);
        Ok(Self { ridge, way: contour.way.clone(), side, reach: reach * side, tool })
    }

    /// On the wall, beside the beginning.
    fn first(&self) -> Result<Beside, Fault> {
        beside(&self.way, self.reach, 1.0).first().copied().ok_or_else(empty)
    }

    /// Where it begins: a tool radius away from the wall.
    fn start(&self) -> Result<Beside, Fault> {
        let first = self.first()?;
        let outwards = first.arm.normalize_or_zero() * self.tool;
        self.clear(&[Beside { arm: first.arm + outwards, ..first }])?.first().copied().ok_or_else(empty)
    }

    /// The same path, unless the tool does not get round somewhere.
    fn clear(&self, path: &[Beside]) -> Result<Vec<Beside>, Fault> {
        self.ridge.kept_clear(path).ok_or_else(|| shape_impossible(2.0 * self.tool, 0.0))
    }

    /// The semicircle between the starting point and the wall, without its beginning: onto the wall in the direction of
    /// the centre path, or off it in that direction.
    fn join(&self, onto: bool) -> Result<Vec<Beside>, Fault> {
        let (first, start) = (self.first()?, self.start()?);
        let middle = Beside { centre: first.centre, arm: (first.arm + start.arm) / 2.0 };
        // The arc runs about a point between them; places are given from the centre path.
        let from = if onto { start } else { first };
        let about = Beside { centre: middle.centre, arm: from.arm - middle.arm };
        let path = swing(&about, 180.0 * self.side).into_iter();
        let path: Vec<Beside> = path.map(|place| Beside { arm: place.arm + middle.arm, ..place }).collect();
        self.clear(&path)
    }

    /// Once round the ridge, from its beginning on.
    fn once(&self) -> Result<Vec<Beside>, Fault> {
        let mut path = Vec::new();
        for way in [self.way.clone(), self.way.reversed()] {
            path.extend(beside(&way, self.reach, 1.0));
            if let Some(last) = path.last().copied() {
                path.extend(swing(&last, -180.0 * self.side));
            }
        }
        self.clear(&path)
    }
}

impl Action for MoveOverRidgeStart {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let start = self.round(control)?.start()?;
        over(&start, self.radius, self.height, control)
    }
}

impl Action for ApproachRidgeWall {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let path = self.round(control)?.join(true)?;
        follow(&path, (self.radius, self.level), self.at, control)
    }
}

impl Action for FollowRidgeWall {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let path = self.round(control)?.once()?;
        follow(&path, (self.radius, self.level), self.at, control)
    }
}

impl Action for LeaveRidgeWall {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let path = self.round(control)?.join(false)?;
        follow(&path, (self.radius, self.level), self.at, control)
    }
}
