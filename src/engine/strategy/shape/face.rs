//! The strategy that mills a flat surface at one level in lines.
//!
//! Invariant: the level begins where the tool is, at one of the corners of the surface.
use glam::DVec3;

use crate::engine::report::fault::Fault;
use crate::engine::strategy::milling::{MAX_OUTLINES, Milling, too_many};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// The mode in which all lines of a level have the same direction.
const SAME_DIRECTION: f64 = 2.0;

strategy! {
    /// Mills a flat surface at one level in lines.
    MillFaceLevel = "mill-face-level" {
        /// 2: all lines in the same direction; otherwise to and fro.
        mode: f64 = Number,
        /// The main coordinate beside the surface where the first line begins.
        begin: f64 = Length,
        /// The one beside the surface on the other side.
        end: f64 = Length,
        /// Where lines towards the beginning end that are not the last one: main coordinate.
        inner_begin: f64 = Length,
        /// Where lines towards the end end that are not the last one.
        inner_end: f64 = Length,
        /// The minor coordinate of the first line.
        first: f64 = Length,
        /// The signed distance of the lines, mm.
        step: f64 = Length,
        /// How many lines.
        lines: f64 = Number,
        /// The feed from line to line, mm/min.
        across: f64 = Feed,
        /// The height of the way back, where all lines have the same direction.
        lift: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Milling for MillFaceLevel {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let Self { begin, end, inner_begin, inner_end, first, step, across, lift, at: feed, .. } = *self;
        if self.lines.is_nan() || self.lines > MAX_OUTLINES {
            return Err(too_many(MAX_OUTLINES));
        }
        let lines = self.lines.max(1.0) as u32;
        let minor = |line: u32| first + step * f64::from(line);
        let here = pen.here();
        let level = here.z;
        let mut at_begin = (here.x - begin).abs() <= (here.x - end).abs();
        let backwards = (here.y - minor(lines - 1)).abs() < (here.y - minor(0)).abs();
        for done in 0..lines {
            let line = if backwards { lines - 1 - done } else { done };
            let last = done + 1 == lines;
            let main = match (at_begin, last) {
                (true, true) => end,
                (true, false) => inner_end,
                (false, true) => begin,
                (false, false) => inner_begin,
            };
            pen.line(DVec3::new(main, minor(line), level), feed);
            if last {
                break;
            }
            let next = minor(if backwards { line - 1 } else { line + 1 });
            if self.mode == SAME_DIRECTION {
                let back = if at_begin { begin } else { end };
                pen.line(DVec3::new(main, minor(line), lift), across);
                pen.line(DVec3::new(back, next, lift), across);
                pen.line(DVec3::new(back, next, level), across);
            } else {
                pen.line(DVec3::new(main, next, level), across);
                at_begin = !at_begin;
            }
        }
        Ok(())
    }
}
