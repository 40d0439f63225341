//! Strategies along one contour, open or closed: where a tool begins beside it, and how it follows it.
//!
//! The centre of the tool is at its radius and the allowance beside the contour, on the side that the program says.
//! With the tool on the left a pass in the sense of the contour is a climb cut, and against it an up-cut. Invariant: the
//! tool never comes nearer to any element of the contour.
use glam::DVec3;

use super::{Contours, OverContours, draw};
use crate::engine::region::Way;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::milling::shape_impossible;
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::{results, strategy};

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;

impl Contours {
    /// The way of a tool along the contour. With `climb` 0 passes with an even number go back.
    fn train(&self, tool_radius: f64, allowance: f64, climb: f64, turn: f64) -> Result<Way, Fault> {
        let contour = self.open.first().ok_or_else(|| Fault::program("contour-not-defined"))?;
        let left = contour.side > 0;
        let distance = (tool_radius + allowance) * if left { 1.0 } else { -1.0 };
        let mut ways = contour.way.beside(distance);
        // More than one: the tool does not get through between them.
        let (Some(way), true) = (ways.pop(), ways.is_empty()) else {
            return Err(shape_impossible(2.0 * tool_radius, 0.0));
        };
        let climbs = if climb == 0.0 { turn % 2.0 != 0.0 } else { climb > 0.0 };
        Ok(if climbs == left { way } else { way.reversed() })
    }
}

strategy! {
    /// Where the tool begins beside the contour; reads the contour, too.
    FindContourStart = "find-contour-start" {
        /// What stays at the contour, mm.
        allowance: f64 = Length,
        /// Climb if positive, up-cut if negative, to and fro if 0.
        climb: f64 = Number,
    }
}

results! {
    /// A place beside the contour.
    ContourStart {
        /// Main coordinate, mm.
        main: f64 = Length,
        /// Minor coordinate, mm.
        minor: f64 = Length,
    }
}

impl Action for FindContourStart {
    type Results = ContourStart;

    fn act(&self, control: &mut dyn Control) -> Done<ContourStart> {
        control.read_first_contour()?;
        let way = control.contours().train(control.tool_radius(), self.allowance, self.climb, 1.0)?;
        Ok(ContourStart { main: way.start.x, minor: way.start.y })
    }
}

strategy! {
    /// Over the beginning of a pass at rapid traverse: up to where nothing is in the way, and across. Where the tool is
    /// at the beginning it stays.
    MoveOverContourStart = "move-over-contour-start" {
        /// What stays at the contour, mm.
        allowance: f64 = Length,
        /// Climb if positive, up-cut if negative, to and fro if 0.
        climb: f64 = Number,
        /// The number of the pass, from 1.
        turn: f64 = Number,
        /// The height at which nothing is in the way, mm.
        above: f64 = Length,
    }
}

strategy! {
    /// Along the contour at one level.
    FollowContour = "follow-contour" {
        /// The height of the level, mm.
        level: f64 = Length,
        /// What stays at the contour, mm.
        allowance: f64 = Length,
        /// Climb if positive, up-cut if negative, to and fro if 0.
        climb: f64 = Number,
        /// The number of the pass, from 1.
        turn: f64 = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl OverContours for MoveOverContourStart {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let way = contours.train(tool.radius, self.allowance, self.climb, self.turn)?;
        let over = |height: f64| -> DVec3 { way.start.extend(height) };
        if !pen.is_at(over(pen.here().z)) {
            if pen.here().z < self.above {
                pen.down(self.above, RAPID);
            }
            pen.line(over(pen.here().z), RAPID);
        }
        Ok(())
    }
}

impl OverContours for FollowContour {
    fn mill(&self, contours: &Contours, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let way = contours.train(tool.radius, self.allowance, self.climb, self.turn)?;
        pen.line(way.start.extend(self.level), self.at);
        for edge in &way.edges {
            draw(edge, self.level, self.at, pen);
        }
        Ok(())
    }
}
