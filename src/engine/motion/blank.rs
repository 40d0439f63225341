//! The blank of `FUNCTION TURNDATA BLANK`: what is left of it while cycles turn.
//!
//! Cycles only update it themselves (TNC 640 manual, line 7340): movements at a feed of a cycle that turns with an insert
//! take away what that sweeps. Invariant: it is fixed to the workpiece; datum shifts move what programs see of it.
use glam::{DVec2, DVec3};

use super::drives::Drives;
use crate::engine::geometry::Frame;
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::region::section::Section;
use crate::engine::region::sweep::TipWay;
use crate::engine::region::{Edge, Way};
use crate::engine::solid::{HalfWay, Path, Shaped};

/// Directions of rotary axes that differ by less are the same.
const SAME: f64 = 1e-6;
/// Ends of cuts that are nearer to each other, mm, are the same place.
const JOINED: f64 = 1e-10;

/// What is left of a blank that is turned.
#[derive(Clone, Debug)]
pub(crate) struct TurnedBlank {
    section: Section,
    /// Where the coordinates of the section have their origin, in the machine, and the direction of the rotary axis.
    line: (DVec3, DVec3),
    /// The insert that cut last, in its half plane.
    shaped: Option<(Insert, Shaped)>,
    /// Where the last cut ended.
    gone: Option<DVec2>,
}

impl TurnedBlank {
    /// What a closed way in the half plane encloses, `x` along the rotary axis, in the coordinates of a frame.
    pub(crate) fn new(way: &Way, frame: &Frame) -> Self {
        let line = (frame.point(DVec3::ZERO), frame.vector(DVec3::Z).normalize_or_zero());
        Self { section: Section::within(way), line, shaped: None, gone: None }
    }

    /// What is left, along what is furthest out as something sees it in the coordinates of a frame. Nothing if nothing is
    /// left, or if its rotary axis is another one.
    fn outline(&self, frame: &Frame, seen: &dyn Fn(&Way) -> Way) -> Option<Way> {
        let (origin, axis) = self.line;
        let sense = frame.vector(DVec3::Z).normalize_or_zero().dot(axis);
        if sense.abs() < 1.0 - SAME {
            return None;
        }
        let sense = sense.signum();
        let off = (frame.point(DVec3::ZERO) - origin).dot(axis);
        let placed = |at: DVec2| DVec2::new((at.x - off) * sense, at.y);
        let edge = |edge: &Edge| match *edge {
            Edge::Line(to) => Edge::Line(placed(to)),
            Edge::Arc { to, centre, sweep } => {
                Edge::Arc { to: placed(to), centre: placed(centre), sweep: sweep * sense }
            }
        };
        let way = |way: &Way| Way { start: placed(way.start), edges: way.edges.iter().map(edge).collect() };
        self.section.outline(&|own| seen(&way(own)))
    }

    /// Takes away what an insert sweeps on a path in machine coordinates.
    fn cut(&mut self, insert: Insert, path: &Path, frame: &Frame) {
        let Some(HalfWay { way, sense }) = HalfWay::of(path, self.line, frame) else { return };
        let shaped = match &mut self.shaped {
            Some((own, shaped)) if *own == insert && shaped.has_sense(sense) => shaped,
            other => {
                self.gone = None;
                &mut other.insert((insert, Shaped::new(&insert, sense, 0.0))).1
            }
        };
        let (TipWay::Line { from, .. } | TipWay::Arc { from, .. }) = way;
        let joined = self.gone.is_some_and(|gone| gone.distance(from) < JOINED);
        shaped.cut(&mut self.section, way, true, joined);
        self.gone = Some(way.end());
    }
}

impl Drives<'_, '_> {
    /// The blank that is updated, along what of it is furthest out, as something sees it.
    pub(crate) fn outline_of_blank(&self, seen: &dyn Fn(&Way) -> Way) -> Option<Way> {
        self.blank.as_ref()?.outline(self.world.system.frame(), seen)
    }

    /// Updates the blank by a movement at a feed of the tip, machine coordinates.
    pub(crate) fn cut_blank(&mut self, path: &Path) {
        let Some(insert) = self.held.filter(|insert| insert.form != InsertForm::Thread) else { return };
        if let Some(blank) = &mut self.blank
            && self.report.at().cycle.is_some()
            && !self.report.is_rehearsing()
        {
            blank.cut(insert, path, self.world.system.frame());
        }
    }
}
