//! Strategies over the walls of contours: how many there are, and how a tool follows one of them.
//!
//! Where contours have depths of their own each band of the region has walls, numbered from 1, from above. Invariant: the
//! centre of the tool never leaves the region where it may be.
use std::rc::Rc;

use glam::DVec2;

use super::{Contours, Depths, Followed, OverContours, Wall, centres, draw, heights};
use crate::engine::region::{Boundary, Edge, Nearest, Region};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::milling::shape_impossible;
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::{results, strategy};

/// The arc onto a wall and away from it has at most so many tool radii; where there is less room it is halved.
const JOIN: f64 = 1.0;
/// An arc onto a wall is not made smaller than this, in tool radii: where it has no room the tool goes down at the wall.
const LEAST_JOIN: f64 = 1e-3;
/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// What calculation may add to a distance, mm.
const SPARE: f64 = 1e-6;

strategy! {
    /// How many walls the region has.
    FindPartialContours = "find-partial-contours" {
        /// What stays at the walls, mm.
        allowance: f64 = Length,
        /// The least radius of the path in inside corners, mm.
        rounding: f64 = Length,
    }
}

results! {
    /// The walls of a region.
    PartialContours {
        /// How many there are.
        count: f64 = Number,
    }
}

impl Action for FindPartialContours {
    type Results = PartialContours;

    fn act(&self, control: &mut dyn Control) -> Done<PartialContours> {
        let walls = control.contours().walls(control.tool_radius(), self.allowance, self.rounding);
        if walls.is_empty() {
            return Err(shape_impossible(2.0 * control.tool_radius(), 0.0).into());
        }
        Ok(PartialContours { count: walls.len() as f64 })
    }
}

strategy! {
    /// Along the wall of one boundary of the region at one level, joined and left on arcs.
    FollowContourSide = "follow-contour-side" {
        /// The number of the boundary, from 1.
        contour: f64 = Number,
        /// The height of the level, mm.
        level: f64 = Length,
        /// What stays at the wall, mm.
        allowance: f64 = Length,
        /// The least radius of the path in inside corners, mm.
        rounding: f64 = Length,
        /// Pockets counter-clockwise and islands clockwise if not negative: climb milling.
        direction: f64 = Number,
        /// The feed down to the level, mm/min.
        plunging_feed: f64 = Feed,
        /// The height between boundaries, to which the tool goes at rapid traverse, mm.
        height: f64 = Length,
        /// The height to which it goes down at rapid traverse, mm.
        above: f64 = Length,
        /// The feed along the wall, mm/min.
        at: f64 = Feed,
    }
}

impl Contours {
    /// The walls of the contours, band by band from above; those of the frame around islands are none.
    pub fn walls(&self, tool_radius: f64, allowance: f64, rounding: f64) -> Rc<Vec<Wall>> {
        let (asked, mut kept) = ([tool_radius, allowance, rounding], self.memory.followed.borrow_mut());
        if let Some(known) = kept.as_ref().filter(|known| known.asked == asked) {
            return Rc::clone(&known.walls);
        }
        let mut walls = Vec::new();
        for band in &self.bands {
            let centres = Rc::new(centres(&band.region, tool_radius, allowance, rounding));
            let is_frame = |wall: &Boundary| self.only_islands && !wall.is_clockwise();
            let own = centres.boundaries().filter(|wall| !is_frame(wall));
            let (from, to) = (band.from, band.to);
            walls.extend(own.map(|boundary| Wall { boundary, centres: Rc::clone(&centres), from, to }));
        }
        let walls = Rc::new(walls);
        *kept = Some(Followed { asked, walls: Rc::clone(&walls) });
        walls
    }

    /// The wall of a number, from 1.
    fn wall(&self, number: f64, tool_radius: f64, allowance: f64, rounding: f64) -> Result<Wall, Fault> {
        let walls = self.walls(tool_radius, allowance, rounding);
        let wall = walls.get((number.max(1.0) - 1.0) as usize).cloned();
        wall.ok_or_else(|| shape_impossible(2.0 * tool_radius, 0.0))
    }
}

strategy! {
    /// Between which heights a wall is milled: those of the contours, or less where they have depths of their own.
    FindDepthsOfWall = "find-depths-of-wall" {
        /// The number of the wall, from 1.
        contour: f64 = Number,
        /// What stays at the wall, mm.
        allowance: f64 = Length,
        /// The least radius of the path in inside corners, mm.
        rounding: f64 = Length,
        /// The height of the surface, mm.
        surface: f64 = Length,
        /// From there to the floor of the deepest contour, with sign, mm.
        depth: f64 = Length,
    }
}

impl Action for FindDepthsOfWall {
    type Results = Depths;

    fn act(&self, control: &mut dyn Control) -> Done<Depths> {
        let wall = control.contours().wall(self.contour, control.tool_radius(), self.allowance, self.rounding)?;
        Ok(heights((wall.from, wall.to), self.surface, self.depth, 0.0))
    }
}

impl OverContours for FollowContourSide {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let Wall { boundary: wall, centres, .. } =
            contours.wall(self.contour, tool.radius, self.allowance, self.rounding)?;
        let wall = if self.direction < 0.0 { wall.reversed() } else { wall };
        // Into the region: on the left of the way in climb milling.
        let side = if self.direction < 0.0 { -1.0 } else { 1.0 };
        let (wall, join) = joined(&centres, &wall, side, [tool.radius * JOIN, tool.radius * LEAST_JOIN]);
        let (start, heading) = (wall.start(), wall.heading());
        let centre = start + heading.perp() * side * join;
        let (before, after) = (centre - heading * join, centre + heading * join);
        if pen.here().z < self.height {
            pen.down(self.height, RAPID);
        }
        pen.line(before.extend(pen.here().z), RAPID);
        pen.line(before.extend(self.above), RAPID);
        pen.line(before.extend(self.level), self.plunging_feed);
        if join > 0.0 {
            draw(&Edge::Arc { to: start, centre, sweep: 90.0 * side }, self.level, self.at, pen);
        }
        for edge in wall.edges() {
            draw(&edge, self.level, self.at, pen);
        }
        if join > 0.0 {
            draw(&Edge::Arc { to: after, centre, sweep: 90.0 * side }, self.level, self.at, pen);
        }
        pen.down(self.height, RAPID);
        Ok(())
    }
}

/// A wall from where there is most room for an arc onto it, with the radius of that: the circle of the arc stays in the
/// region, which lies on the side 1 (left) or -1 of the wall. Tried in the middle of each edge; 0 where it has no room.
fn joined(centres: &Region, wall: &Boundary, side: f64, [most, least]: [f64; 2]) -> (Boundary, f64) {
    let near = Nearest::of(centres);
    let mut at = wall.start();
    let middles: Vec<(DVec2, DVec2)> = wall
        .edges()
        .iter()
        .map(|edge| {
            let from = std::mem::replace(&mut at, edge.to());
            let middle = edge.shortened(from, edge.length(from) / 2.0).to();
            (middle, edge.heading(from, middle).perp() * side)
        })
        .collect();
    let mut radius = most;
    while radius > least {
        for (middle, inwards) in &middles {
            let centre = *middle + *inwards * radius;
            let deep = near.nearest(centre).is_some_and(|(_, distance)| distance >= radius - SPARE);
            if deep && centres.contains(centre) {
                return (wall.from_nearest(*middle), radius);
            }
        }
        radius /= 2.0;
    }
    (wall.clone(), 0.0)
}
