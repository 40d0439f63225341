//! Strategies that clear a level of a pocket or slot and finish its wall or floor.
//!
//! Invariant: one level at a time; all of them are the same few paths over the outline of a figure: a core in the
//! middle, then outlines that grow by equal steps. What no path can make is a fault.
use glam::{DVec2, DVec3};

use crate::engine::contour::outline::{Outline, Place, Tangent, left_of, unit};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// What calculation may add to a whole number of steps, and to a size.
const SPARE: f64 = 1e-9;
/// Outlines of a rectangle at a distance of more tool radii than this leave material in their corners: 1 + √½.
const CORNERS_CLEARED: f64 = 1.7;
/// More outlines or lines of one level than this are refused.
pub(super) const MAX_OUTLINES: f64 = 10_000.0;

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
    fn steps(&self, stepover: f64, tool_radius: f64) -> Result<(f64, u32), Fault> {
        let most = match self {
            Self::Rectangle { .. } => stepover.min(CORNERS_CLEARED * tool_radius),
            _ => stepover,
        };
        let room = self.room();
        if room <= SPARE {
            return Ok((0.0, 0));
        }
        let steps = libm::ceil(room / most - SPARE).max(1.0);
        // An overlap of nothing gives infinitely many.
        if steps.is_nan() || steps > MAX_OUTLINES {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_OUTLINES));
        }
        Ok((room / steps, steps as u32))
    }
}

/// A figure with how it is milled.
struct Work {
    place: Place,
    figure: Figure,
    /// The direction of travel along the wall, + counter-clockwise.
    direction: f64,
    feed: f64,
}

impl Work {
    fn outline(&self, inset: f64) -> Outline {
        self.figure.outline(inset).towards(self.direction)
    }

    /// The quarter circle on the inside.
    fn tangent(&self, outline: &Outline, radius: f64) -> Tangent {
        Tangent::at(outline, radius, self.direction)
    }
}

impl<'e> Run<'_, 'e> {
    /// Place, direction and feed of a figure; its size follows from what each strategy is given.
    fn work(&self, call: &StrategyCall, rotation: f64, figure: Figure, exec: &Exec<'_, 'e>) -> Result<Work, Fault> {
        let centre = self.point(Self::argument(call, 0)?, exec)?;
        let climb = self.given(call, 1, exec)?;
        let place = Place::new(centre, rotation);
        let direction = if climb < 0.0 { -1.0 } else { 1.0 };
        Ok(Work { place, figure, direction, feed: self.feed_given(call, exec)? })
    }

    /// The radius of the tool in the units of the program, which may be scaled.
    pub(super) fn tool_radius(&self) -> f64 {
        self.drives.world.tool().map_or(0.0, |tool| tool.radius) / self.drives.world.system.plane_scale().unwrap_or(1.0)
    }

    /// Length, width, corner radius and rotation of a rectangle.
    fn rectangle(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Work, Fault> {
        let [length, width, corner, rotation] = self.all_given(call, 2, exec)?;
        let radius = self.tool_radius();
        let half = DVec2::new(length, width) / 2.0 - DVec2::splat(radius);
        let least = length.min(width);
        if half.min_element() < -SPARE || corner > least / 2.0 + SPARE {
            return Err(self.drives.shape_impossible(2.0 * radius.max(corner), least));
        }
        let half = half.max(DVec2::ZERO);
        let corner = (corner - radius).clamp(0.0, half.min_element());
        self.work(call, rotation, Figure::Rectangle { half, corner }, exec)
    }

    fn circle(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Work, Fault> {
        let diameter = self.given(call, 2, exec)?;
        let radius = diameter / 2.0 - self.tool_radius();
        if radius < -SPARE {
            return Err(self.drives.shape_impossible(2.0 * self.tool_radius(), diameter));
        }
        self.work(call, 0.0, Figure::Circle { radius: radius.max(0.0) }, exec)
    }

    /// Half the width of the path in a slot. Where the tool is wider than the allowance leaves room for, it takes
    /// a part of the allowance.
    fn half_width(&self, width: f64, allowance: f64) -> Result<f64, Fault> {
        let half = width / 2.0 - self.tool_radius();
        if half < -SPARE {
            return Err(self.drives.shape_impossible(2.0 * self.tool_radius(), width));
        }
        Ok((half - allowance).max(0.0))
    }

    fn slot(&self, call: &StrategyCall, allowance: f64, exec: &Exec<'_, 'e>) -> Result<Work, Fault> {
        let [length, width, rotation] = self.all_given(call, 2, exec)?;
        if length < width - SPARE {
            return Err(self.drives.shape_impossible(width, length));
        }
        let radius = self.half_width(width, allowance)?;
        self.work(call, rotation, Figure::Slot { reach: (length - width).max(0.0) / 2.0, radius }, exec)
    }

    fn band(&self, call: &StrategyCall, allowance: f64, exec: &Exec<'_, 'e>) -> Result<Work, Fault> {
        let [diameter, begin, opening, width] = self.all_given(call, 2, exec)?;
        let half = self.half_width(width, allowance)?;
        if diameter < width {
            return Err(self.drives.shape_impossible(width, diameter));
        }
        let (begin, opening) = if opening < 0.0 { (begin + opening, -opening) } else { (begin, opening) };
        self.work(call, 0.0, Figure::Band { radius: diameter / 2.0, begin, opening, half }, exec)
    }

    pub(super) fn clear_rectangle_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.rectangle(call, exec)?;
        let stepover = self.given(call, 6, exec)?;
        self.clear(&work, stepover)
    }

    pub(super) fn clear_circle_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.circle(call, exec)?;
        let stepover = self.given(call, 3, exec)?;
        self.clear(&work, stepover)
    }

    pub(super) fn clear_slot_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.slot(call, self.given(call, 5, exec)?, exec)?;
        self.clear(&work, self.tool_radius())
    }

    pub(super) fn clear_circular_slot_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.band(call, self.given(call, 6, exec)?, exec)?;
        self.clear(&work, self.tool_radius())
    }

    /// From the core to the wall, and away from it on a quarter circle.
    fn clear(&mut self, work: &Work, stepover: f64) -> Done {
        let (step, count) = work.figure.steps(stepover, self.tool_radius())?;
        let Work { place, feed, .. } = work;
        if let Figure::Circle { radius } = work.figure {
            return self.clear_circle(work, radius, step, count);
        }
        self.mill_core(work)?;
        if count == 0 {
            return Ok(());
        }
        for outline in (1..count).rev().map(|inside| work.outline(f64::from(inside) * step)) {
            self.drives.mill_to(place, outline.start, *feed)?;
            self.drives.mill_outline(place, &outline, *feed)?;
        }
        let outline = work.outline(0.0);
        let tangent = work.tangent(&outline, step.min(self.tool_radius()) / 2.0);
        self.drives.mill_join(place, &tangent, &outline, *feed)?;
        self.drives.mill_outline(place, &outline, *feed)?;
        self.drives.mill_leave(place, &tangent, *feed)
    }

    /// A spiral of half circles, each half a step wider than the one before, then the wall.
    fn clear_circle(&mut self, work: &Work, radius: f64, step: f64, count: u32) -> Done {
        let Work { place, feed, direction, .. } = work;
        self.drives.mill_to(place, DVec2::ZERO, *feed)?;
        if count == 0 {
            return Ok(());
        }
        let height = self.drives.in_plane(self.drives.world.here).z;
        let at = |half: u32| {
            let distance = if half == 2 * count { radius } else { f64::from(half) * step / 2.0 };
            DVec2::new(if half.is_multiple_of(2) { distance } else { -distance }, 0.0)
        };
        for half in 1..=2 * count {
            let (from, to) = (at(half - 1), at(half));
            self.drives.mill_around(place, ((from + to) / 2.0, to), height, *direction, *feed)?;
        }
        let outline = work.outline(0.0);
        self.drives.mill_outline(place, &outline, *feed)?;
        let tangent = work.tangent(&outline, step.min(self.tool_radius()) / 2.0);
        self.drives.mill_leave(place, &tangent, *feed)
    }

    /// To and fro along the core, to where the outlines begin.
    fn mill_core(&mut self, work: &Work) -> Done {
        let Work { place, feed, .. } = work;
        match work.figure {
            Figure::Rectangle { half, .. } => {
                let end = half - DVec2::splat(half.min_element());
                self.drives.mill_to(place, -end, *feed)?;
                self.drives.mill_to(place, end, *feed)?;
                // The outlines begin in the middle of the right side.
                let begin = DVec2::new(end.x, 0.0);
                if end.y > 0.0 { self.drives.mill_to(place, begin, *feed) } else { Ok(()) }
            }
            Figure::Slot { reach, .. } => {
                for end in [-reach, reach, -reach] {
                    self.drives.mill_to(place, DVec2::new(end, 0.0), *feed)?;
                }
                Ok(())
            }
            Figure::Band { radius, begin, opening, .. } => {
                let height = self.drives.in_plane(self.drives.world.here).z;
                let first = unit(begin) * radius;
                let last = if opening >= 360.0 { first } else { unit(begin + opening) * radius };
                let mut way = vec![(first, -1.0), (last, 1.0), (first, -1.0)];
                let here = place.back(self.drives.in_plane(self.drives.world.here).truncate());
                if (here - first).length() < SPARE || (here - last).length() > SPARE {
                    // The tool is at the beginning, or comes from somewhere else.
                    self.drives.mill_to(place, first, *feed)?;
                    way.remove(0);
                }
                for (end, direction) in way.into_iter().filter(|_| opening > 0.0) {
                    self.drives.mill_around(place, (DVec2::ZERO, end), height, direction, *feed)?;
                }
                Ok(())
            }
            Figure::Circle { .. } => self.drives.mill_to(place, DVec2::ZERO, *feed),
        }
    }

    pub(super) fn finish_rectangle_side(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.rectangle(call, exec)?;
        self.finish_side(&work, self.given(call, 6, exec)?)
    }

    pub(super) fn finish_circle_side(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.circle(call, exec)?;
        self.finish_side(&work, self.given(call, 3, exec)?)
    }

    pub(super) fn finish_slot_side(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.slot(call, 0.0, exec)?;
        self.finish_side(&work, self.given(call, 5, exec)?)
    }

    pub(super) fn finish_circular_slot_side(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.band(call, 0.0, exec)?;
        self.finish_side(&work, self.given(call, 6, exec)?)
    }

    /// Beside the wall, down to the level, on a quarter circle to the wall, once around and away again.
    fn finish_side(&mut self, work: &Work, level: f64) -> Done {
        let Work { place, feed, .. } = work;
        let outline = work.outline(0.0);
        let tangent = work.tangent(&outline, work.figure.room().min(self.tool_radius()) / 2.0);
        self.drives.mill_to(place, tangent.before, *feed)?;
        self.drives.mill_down(level, *feed)?;
        self.drives.mill_join(place, &tangent, &outline, *feed)?;
        self.drives.mill_outline(place, &outline, *feed)?;
        self.drives.mill_leave(place, &tangent, *feed)
    }

    pub(super) fn finish_rectangle_floor(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.rectangle(call, exec)?;
        let [stepover, from, level] = self.all_given(call, 6, exec)?;
        self.finish_floor(&work, stepover, from, level)
    }

    pub(super) fn finish_circle_floor(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.circle(call, exec)?;
        let [stepover, from, level] = self.all_given(call, 3, exec)?;
        self.finish_floor(&work, stepover, from, level)
    }

    pub(super) fn finish_slot_floor(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.slot(call, 0.0, exec)?;
        let [from, level] = self.all_given(call, 5, exec)?;
        self.finish_floor(&work, self.tool_radius(), from, level)
    }

    pub(super) fn finish_circular_slot_floor(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let work = self.band(call, 0.0, exec)?;
        let [from, level] = self.all_given(call, 6, exec)?;
        self.finish_floor(&work, self.tool_radius(), from, level)
    }

    /// Down to the floor on a turn about where the clearing begins, then as a level is cleared.
    fn finish_floor(&mut self, work: &Work, stepover: f64, from: f64, level: f64) -> Done {
        let Work { place, feed, .. } = work;
        let radius = work.figure.room().min(self.tool_radius()) / 2.0;
        let (centre, out) = match work.figure {
            Figure::Rectangle { .. } | Figure::Circle { .. } => (DVec2::ZERO, DVec2::X),
            Figure::Slot { reach, .. } => (DVec2::new(-reach, 0.0), DVec2::X),
            Figure::Band { radius, begin, .. } => (unit(begin) * radius, left_of(unit(begin))),
        };
        if radius > SPARE {
            let beside = centre + out * radius;
            self.drives.mill_to(place, beside, *feed)?;
            self.drives.mill_down(from, *feed)?;
            self.drives.mill_around(place, (centre, beside), level, work.direction, *feed)?;
            self.drives.mill_around(place, (centre, beside), level, work.direction, *feed)?;
            self.drives.mill_to(place, centre, *feed)?;
        } else {
            self.drives.mill_to(place, centre, *feed)?;
            self.drives.mill_down(level, *feed)?;
        }
        self.clear(work, stepover)
    }

    /// A point argument.
    pub(super) fn point_given(&self, call: &StrategyCall, index: usize, exec: &Exec<'_, 'e>) -> Result<DVec3, Fault> {
        self.point(Self::argument(call, index)?, exec)
    }
}
