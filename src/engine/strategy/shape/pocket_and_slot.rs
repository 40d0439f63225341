//! Strategies that clear a level of a pocket or slot and finish its wall or floor.
//!
//! Invariant: one level at a time; all of them are the same few paths over the outline of a figure: a core in the
//! middle, then outlines that grow by equal steps. What no path can make is a fault.
use glam::{DVec2, DVec3};

use crate::engine::geometry::left_of;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::milling::{MAX_OUTLINES, Milling, shape_impossible, too_many};
use crate::engine::strategy::outline::{Outline, Place, Tangent, unit};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// What calculation may add to a whole number of steps, and to a size.
const SPARE: f64 = 1e-9;
/// Outlines of a rectangle at a distance of more tool radii than this leave material in their corners: 1 + √½.
const CORNERS_CLEARED: f64 = 1.7;

/// Declares a strategy of rectangles: what all of them are given, and what it is given besides.
macro_rules! of_rectangle {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The middle of the rectangle.
                centre: DVec3 = Length,
                /// Climb milling if positive, for a spindle that turns clockwise.
                climb: f64 = Number,
                /// Its side along its first axis, mm.
                length: f64 = Length,
                /// Its other side, mm.
                width: f64 = Length,
                /// The radius of its corners, mm.
                corner: f64 = Length,
                /// The direction of its first axis, degrees.
                rotation: f64 = Angle,
                $($more)*
                /// The feed, mm/min.
                at: f64 = Feed,
            }
        }

        impl $name {
            fn work(&self, tool: Cutter) -> Result<Work, Fault> {
                let figure = Figure::rectangle([self.length, self.width, self.corner], tool)?;
                Ok(Work::new(Place::new(self.centre, self.rotation), figure, self.climb, self.at, tool))
            }
        }
    };
}

/// Declares a strategy of circles.
macro_rules! of_circle {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The centre.
                centre: DVec3 = Length,
                /// Climb milling if positive, for a spindle that turns clockwise.
                climb: f64 = Number,
                /// The diameter, mm.
                diameter: f64 = Length,
                $($more)*
                /// The feed, mm/min.
                at: f64 = Feed,
            }
        }

        impl $name {
            fn work(&self, tool: Cutter) -> Result<Work, Fault> {
                let figure = Figure::circle(self.diameter, tool)?;
                Ok(Work::new(Place::new(self.centre, 0.0), figure, self.climb, self.at, tool))
            }
        }
    };
}

/// Declares a strategy of slots.
macro_rules! of_slot {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The middle of the slot.
                centre: DVec3 = Length,
                /// Climb milling if positive, for a spindle that turns clockwise.
                climb: f64 = Number,
                /// Its length with both ends, mm.
                length: f64 = Length,
                /// Its width, mm.
                width: f64 = Length,
                /// The direction of its length, degrees.
                rotation: f64 = Angle,
                $($more)*
                /// The feed, mm/min.
                at: f64 = Feed,
            }
        }

        impl $name {
            fn work(&self, allowance: f64, tool: Cutter) -> Result<Work, Fault> {
                let figure = Figure::slot(self.length, self.width, allowance, tool)?;
                Ok(Work::new(Place::new(self.centre, self.rotation), figure, self.climb, self.at, tool))
            }
        }
    };
}

/// Declares a strategy of circular slots.
macro_rules! of_circular_slot {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The centre of the circle along which the slot lies.
                centre: DVec3 = Length,
                /// Climb milling if positive, for a spindle that turns clockwise.
                climb: f64 = Number,
                /// The diameter of that circle, mm.
                diameter: f64 = Length,
                /// Where the slot begins on it, degrees.
                begin: f64 = Angle,
                /// How far it goes from there, degrees.
                opening: f64 = Angle,
                /// Its width, mm.
                width: f64 = Length,
                $($more)*
                /// The feed, mm/min.
                at: f64 = Feed,
            }
        }

        impl $name {
            fn work(&self, allowance: f64, tool: Cutter) -> Result<Work, Fault> {
                let angles = (self.begin, self.opening);
                let figure = Figure::band(self.diameter, angles, self.width, allowance, tool)?;
                Ok(Work::new(Place::new(self.centre, 0.0), figure, self.climb, self.at, tool))
            }
        }
    };
}

of_rectangle! {
    /// Clears a level of a rectangle with round corners, from the inside to the wall: outlines about a core in the
    /// middle at equal distances.
    ClearRectangleLevel = "clear-rectangle-level" {
        /// The greatest distance of the outlines, mm; never more than 1.7 tool radii, beyond which corners would stay.
        stepover: f64 = Length,
    }
}

of_circle! {
    /// Clears a level of a circle on a spiral of half circles, from the centre to the wall.
    ClearCircleLevel = "clear-circle-level" {
        /// The greatest distance of the turns, mm.
        stepover: f64 = Length,
    }
}

of_slot! {
    /// Clears a level of a slot with steps of at most the tool radius.
    ClearSlotLevel = "clear-slot-level" {
        /// What stays on the wall, mm; less where the tool is too wide for that.
        allowance: f64 = Length,
    }
}

of_circular_slot! {
    /// Clears a level of a circular slot with steps of at most the tool radius.
    ClearCircularSlotLevel = "clear-circular-slot-level" {
        /// What stays on the wall, mm; less where the tool is too wide for that.
        allowance: f64 = Length,
    }
}

of_rectangle! {
    /// Cuts the wall of a rectangular pocket at one level.
    FinishRectangleSide = "finish-rectangle-side" {
        /// The height at which it is cut, mm.
        level: f64 = Length,
    }
}

of_circle! {
    /// Cuts the wall of a circular pocket at one level.
    FinishCircleSide = "finish-circle-side" {
        /// The height at which it is cut, mm.
        level: f64 = Length,
    }
}

of_slot! {
    /// Cuts the wall of a slot at one level.
    FinishSlotSide = "finish-slot-side" {
        /// The height at which it is cut, mm.
        level: f64 = Length,
    }
}

of_circular_slot! {
    /// Cuts the wall of a circular slot at one level.
    FinishCircularSlotSide = "finish-circular-slot-side" {
        /// The height at which it is cut, mm.
        level: f64 = Length,
    }
}

of_rectangle! {
    /// Cuts the floor of a rectangular pocket.
    FinishRectangleFloor = "finish-rectangle-floor" {
        /// The greatest distance of the outlines, mm.
        stepover: f64 = Length,
        /// The height of the floor that was roughed, mm.
        from: f64 = Length,
        /// The height of the finished floor, mm.
        level: f64 = Length,
    }
}

of_circle! {
    /// Cuts the floor of a circular pocket.
    FinishCircleFloor = "finish-circle-floor" {
        /// The greatest distance of the turns, mm.
        stepover: f64 = Length,
        /// The height of the floor that was roughed, mm.
        from: f64 = Length,
        /// The height of the finished floor, mm.
        level: f64 = Length,
    }
}

of_slot! {
    /// Cuts the floor of a slot.
    FinishSlotFloor = "finish-slot-floor" {
        /// The height of the floor that was roughed, mm.
        from: f64 = Length,
        /// The height of the finished floor, mm.
        level: f64 = Length,
    }
}

of_circular_slot! {
    /// Cuts the floor of a circular slot.
    FinishCircularSlotFloor = "finish-circular-slot-floor" {
        /// The height of the floor that was roughed, mm.
        from: f64 = Length,
        /// The height of the finished floor, mm.
        level: f64 = Length,
    }
}

impl Milling for ClearRectangleLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.clear(self.stepover, pen)
    }
}

impl Milling for ClearCircleLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.clear(self.stepover, pen)
    }
}

impl Milling for ClearSlotLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(self.allowance, tool)?.clear(tool.radius, pen)
    }
}

impl Milling for ClearCircularSlotLevel {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(self.allowance, tool)?.clear(tool.radius, pen)
    }
}

impl Milling for FinishRectangleSide {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.finish_side(self.level, pen);
        Ok(())
    }
}

impl Milling for FinishCircleSide {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.finish_side(self.level, pen);
        Ok(())
    }
}

impl Milling for FinishSlotSide {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(0.0, tool)?.finish_side(self.level, pen);
        Ok(())
    }
}

impl Milling for FinishCircularSlotSide {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(0.0, tool)?.finish_side(self.level, pen);
        Ok(())
    }
}

impl Milling for FinishRectangleFloor {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.finish_floor(self.stepover, self.from, self.level, pen)
    }
}

impl Milling for FinishCircleFloor {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(tool)?.finish_floor(self.stepover, self.from, self.level, pen)
    }
}

impl Milling for FinishSlotFloor {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(0.0, tool)?.finish_floor(tool.radius, self.from, self.level, pen)
    }
}

impl Milling for FinishCircularSlotFloor {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.work(0.0, tool)?.finish_floor(tool.radius, self.from, self.level, pen)
    }
}

/// A figure to be milled from the inside: the paths of the tool centre.
#[derive(Clone, Copy, Debug)]
enum Figure {
    /// Half the sides of the path along the wall, and the radius of its corners.
    Rectangle { half: DVec2, corner: f64 },
    /// Half the length of the core, and the radius of the path along the ends.
    Slot { reach: f64, radius: f64 },
    /// Radius of the core, angles, half the width of the path.
    Band { radius: f64, begin: f64, opening: f64, half: f64 },
    /// The radius of the path along the wall.
    Circle { radius: f64 },
}

impl Figure {
    fn rectangle([length, width, corner]: [f64; 3], tool: Cutter) -> Result<Self, Fault> {
        let half = DVec2::new(length, width) / 2.0 - DVec2::splat(tool.radius);
        let least = length.min(width);
        if half.min_element() < -SPARE || corner > least / 2.0 + SPARE {
            return Err(shape_impossible(2.0 * tool.radius.max(corner), least));
        }
        let half = half.max(DVec2::ZERO);
        Ok(Self::Rectangle { half, corner: (corner - tool.radius).clamp(0.0, half.min_element()) })
    }

    fn circle(diameter: f64, tool: Cutter) -> Result<Self, Fault> {
        let radius = diameter / 2.0 - tool.radius;
        if radius < -SPARE {
            return Err(shape_impossible(2.0 * tool.radius, diameter));
        }
        Ok(Self::Circle { radius: radius.max(0.0) })
    }

    fn slot(length: f64, width: f64, allowance: f64, tool: Cutter) -> Result<Self, Fault> {
        if length < width - SPARE {
            return Err(shape_impossible(width, length));
        }
        let radius = half_width(width, allowance, tool)?;
        Ok(Self::Slot { reach: (length - width).max(0.0) / 2.0, radius })
    }

    fn band(
        diameter: f64,
        (begin, opening): (f64, f64),
        width: f64,
        allowance: f64,
        tool: Cutter,
    ) -> Result<Self, Fault> {
        let half = half_width(width, allowance, tool)?;
        if diameter < width {
            return Err(shape_impossible(width, diameter));
        }
        let (begin, opening) = if opening < 0.0 { (begin + opening, -opening) } else { (begin, opening) };
        Ok(Self::Band { radius: diameter / 2.0, begin, opening, half })
    }

    /// How far the path along the wall lies from the core.
    fn room(&self) -> f64 {
        match *self {
            Self::Rectangle { half, .. } => half.min_element(),
            Self::Slot { radius, .. } | Self::Circle { radius } => radius,
            Self::Band { half, .. } => half,
        }
    }

    /// The path at a distance inside of the one along the wall.
    fn outline(&self, inset: f64) -> Outline {
        match *self {
            Self::Rectangle { half, corner } => {
                Outline::rectangle(half - DVec2::splat(inset), (corner - inset).max(0.0))
            }
            Self::Slot { reach, radius } => Outline::slot(reach, radius - inset),
            Self::Band { radius, begin, opening, half } => Outline::band(radius, begin, opening, half - inset),
            Self::Circle { radius } => Outline::circle(radius - inset),
        }
    }

    /// The distance of the outlines from each other, and how many there are next to the core.
    fn steps(&self, stepover: f64, tool: Cutter) -> Result<(f64, u32), Fault> {
        let most = match self {
            Self::Rectangle { .. } => stepover.min(CORNERS_CLEARED * tool.radius),
            _ => stepover,
        };
        let room = self.room();
        if room <= SPARE {
            return Ok((0.0, 0));
        }
        let steps = libm::ceil(room / most - SPARE).max(1.0);
        // An overlap of nothing gives infinitely many.
        if steps.is_nan() || steps > MAX_OUTLINES {
            return Err(too_many(MAX_OUTLINES));
        }
        Ok((room / steps, steps as u32))
    }
}

/// Half the width of the path in a slot. Where the tool is wider than the allowance leaves room for, it takes
/// a part of the allowance.
fn half_width(width: f64, allowance: f64, tool: Cutter) -> Result<f64, Fault> {
    let half = width / 2.0 - tool.radius;
    if half < -SPARE {
        return Err(shape_impossible(2.0 * tool.radius, width));
    }
    Ok((half - allowance).max(0.0))
}

/// A figure with how it is milled.
struct Work {
    place: Place,
    figure: Figure,
    /// The direction of travel along the wall, + counter-clockwise.
    direction: f64,
    feed: f64,
    tool: Cutter,
}

impl Work {
    fn new(place: Place, figure: Figure, climb: f64, feed: f64, tool: Cutter) -> Self {
        Self { place, figure, direction: if climb < 0.0 { -1.0 } else { 1.0 }, feed, tool }
    }

    fn outline(&self, inset: f64) -> Outline {
        self.figure.outline(inset).towards(self.direction)
    }

    /// The quarter circle on the inside.
    fn tangent(&self, outline: &Outline, radius: f64) -> Tangent {
        Tangent::at(outline, radius, self.direction)
    }

    /// From the core to the wall, and away from it on a quarter circle.
    fn clear(&self, stepover: f64, pen: &mut Pen) -> Result<(), Fault> {
        let (step, count) = self.figure.steps(stepover, self.tool)?;
        let Self { place, feed, .. } = self;
        if let Figure::Circle { radius } = self.figure {
            self.clear_circle(radius, step, count, pen);
            return Ok(());
        }
        self.mill_core(pen);
        if count == 0 {
            return Ok(());
        }
        for outline in (1..count).rev().map(|inside| self.outline(f64::from(inside) * step)) {
            pen.to(place, outline.start, *feed);
            pen.outline(place, &outline, *feed);
        }
        let outline = self.outline(0.0);
        let tangent = self.tangent(&outline, step.min(self.tool.radius) / 2.0);
        pen.join(place, &tangent, &outline, *feed);
        pen.outline(place, &outline, *feed);
        pen.leave(place, &tangent, *feed);
        Ok(())
    }

    /// A spiral of half circles, each half a step wider than the one before, then the wall.
    fn clear_circle(&self, radius: f64, step: f64, count: u32, pen: &mut Pen) {
        let Self { place, feed, direction, .. } = self;
        pen.to(place, DVec2::ZERO, *feed);
        if count == 0 {
            return;
        }
        let height = pen.here().z;
        let at = |half: u32| {
            let distance = if half == 2 * count { radius } else { f64::from(half) * step / 2.0 };
            DVec2::new(if half.is_multiple_of(2) { distance } else { -distance }, 0.0)
        };
        for half in 1..=2 * count {
            let (from, to) = (at(half - 1), at(half));
            pen.around(place, ((from + to) / 2.0, to), height, *direction, *feed);
        }
        let outline = self.outline(0.0);
        pen.outline(place, &outline, *feed);
        let tangent = self.tangent(&outline, step.min(self.tool.radius) / 2.0);
        pen.leave(place, &tangent, *feed);
    }

    /// To and fro along the core, to where the outlines begin.
    fn mill_core(&self, pen: &mut Pen) {
        let Self { place, feed, .. } = self;
        match self.figure {
            Figure::Rectangle { half, .. } => {
                let end = half - DVec2::splat(half.min_element());
                pen.to(place, -end, *feed);
                pen.to(place, end, *feed);
                // The outlines begin in the middle of the right side.
                if end.y > 0.0 {
                    pen.to(place, DVec2::new(end.x, 0.0), *feed);
                }
            }
            Figure::Slot { reach, .. } => {
                for end in [-reach, reach, -reach] {
                    pen.to(place, DVec2::new(end, 0.0), *feed);
                }
            }
            Figure::Band { radius, begin, opening, .. } => {
                let height = pen.here().z;
                let first = unit(begin) * radius;
                let last = if opening >= 360.0 { first } else { unit(begin + opening) * radius };
                let mut way = vec![(first, -1.0), (last, 1.0), (first, -1.0)];
                let here = place.back(pen.here().truncate());
                if (here - first).length() < SPARE || (here - last).length() > SPARE {
                    // The tool is at the beginning, or comes from somewhere else.
                    pen.to(place, first, *feed);
                    way.remove(0);
                }
                for (end, direction) in way.into_iter().filter(|_| opening > 0.0) {
                    pen.around(place, (DVec2::ZERO, end), height, direction, *feed);
                }
            }
            Figure::Circle { .. } => pen.to(place, DVec2::ZERO, *feed),
        }
    }

    /// Beside the wall, down to the level, on a quarter circle to the wall, once around and away again.
    fn finish_side(&self, level: f64, pen: &mut Pen) {
        let Self { place, feed, .. } = self;
        let outline = self.outline(0.0);
        let tangent = self.tangent(&outline, self.figure.room().min(self.tool.radius) / 2.0);
        pen.to(place, tangent.before, *feed);
        pen.down(level, *feed);
        pen.join(place, &tangent, &outline, *feed);
        pen.outline(place, &outline, *feed);
        pen.leave(place, &tangent, *feed);
    }

    /// Down to the floor on a turn about where the clearing begins, then as a level is cleared.
    fn finish_floor(&self, stepover: f64, from: f64, level: f64, pen: &mut Pen) -> Result<(), Fault> {
        let Self { place, feed, direction, .. } = self;
        let radius = self.figure.room().min(self.tool.radius) / 2.0;
        let (centre, out) = match self.figure {
            Figure::Rectangle { .. } | Figure::Circle { .. } => (DVec2::ZERO, DVec2::X),
            Figure::Slot { reach, .. } => (DVec2::new(-reach, 0.0), DVec2::X),
            Figure::Band { radius, begin, .. } => (unit(begin) * radius, left_of(unit(begin))),
        };
        if radius > SPARE {
            let beside = centre + out * radius;
            pen.to(place, beside, *feed);
            pen.down(from, *feed);
            pen.around(place, (centre, beside), level, *direction, *feed);
            pen.around(place, (centre, beside), level, *direction, *feed);
            pen.to(place, centre, *feed);
        } else {
            pen.to(place, centre, *feed);
            pen.down(level, *feed);
        }
        self.clear(stepover, pen)
    }
}
