//! Strategies that recess: one recess, one level turned in a groove, one flank, the floor, or a way over the groove.
//!
//! What is recessed was said before ([`groove_shape`](super::groove_shape)). Invariant: at a feed the insert stays on
//! the contour with its allowance or above it, and at rapid traverse where it has cut before or where nothing is.
use glam::DVec2;

use super::groove::Groove;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::contour::{Contours, OverContours};
use crate::engine::strategy::milling::too_many;
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// What calculation may add to a height, mm.
const SPARE: f64 = 1e-9;
/// What is higher by no more than this, mm, is touched and not cut.
const TOUCHES: f64 = 1e-6;
/// More infeeds for one recess than this are refused.
const MAX_INFEEDS: f64 = 10_000.0;
/// So much of the straight part of a cutting edge cuts may be shorter at most (TNC 640 manual, line 8720).
const SHORTEST: f64 = 0.8;

strategy! {
    /// Out to the height at which the tool goes across, if it is lower.
    ClearGroove = "clear-groove" {}
}

strategy! {
    /// Out of the groove and across, over a place, at rapid traverse.
    MoveOverGroove = "move-over-groove" {
        /// The coordinate across the groove.
        side: f64 = Length,
    }
}

strategy! {
    /// One recess where the tool is, to what roughing leaves there; with a greatest infeed the tool goes out between
    /// infeeds and comes back at the feed.
    RecessPass = "recess-pass" {
        /// The greatest infeed, mm; 0 is none.
        depth_limit: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// One recess to a level, where the cut at that level begins.
    RecessToLevel = "recess-to-level" {
        /// The level: a diameter, or a coordinate on the rotary axis.
        level: f64 = Length,
        /// The number of the cut, from 1.
        cut: f64 = Number,
        /// Whether all cuts go in the direction of the contour.
        one_way: bool = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// All cuts at a level across the groove; cuts after the second one are shorter at their end, each by more.
    TurnRecessPass = "turn-recess-pass" {
        /// The level.
        level: f64 = Length,
        /// The number of the cut, from 1.
        cut: f64 = Number,
        /// Whether all cuts go in the direction of the contour.
        one_way: bool = Number,
        /// By how much each cut is shorter than the one before it, mm.
        shorter: f64 = Length,
        /// By how much the tool is lifted while it turns across, mm.
        compensation: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Out by a clearance, and back to where the cut at a level began at rapid traverse.
    LiftAndReturn = "lift-and-return" {
        /// The level.
        level: f64 = Length,
        /// The clearance, mm.
        clearance: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// To the height at which the tool goes across over a flank, at rapid traverse.
    MoveToGrooveFlank = "move-to-groove-flank" {
        /// Whether to the second flank.
        second: bool = Number,
        /// Whether to the contour with the allowance of roughing.
        rough: bool = Number,
    }
}

strategy! {
    /// Down the flank at which the tool is; where roughing has recessed between walls as far from each other as the insert is
    /// wide, nothing is left of it.
    FollowGrooveWall = "follow-groove-wall" {
        /// Whether the second flank.
        second: bool = Number,
        /// Whether on the allowance of roughing.
        rough: bool = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Along the floor to the other flank.
    FinishGrooveFloor = "finish-groove-floor" {
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// To the middle of the groove, from a flank down its wall where the tool is above.
    FinishHalfOfGroove = "finish-half-of-groove" {
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Along all that is left of the contour to its end.
    FinishWholeGroove = "finish-whole-groove" {
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Straight out of the groove at rapid traverse.
    LeaveGroove = "leave-groove" {}
}

strategy! {
    /// Out of the groove, across and to where the cycle began, at rapid traverse.
    ReturnFromGroove = "return-from-groove" {}
}

/// What is recessed.
fn groove(contours: &Contours) -> Result<&Groove, Fault> {
    contours.groove.as_ref().ok_or_else(|| Fault::program("contour-not-defined"))
}

/// Straight out to where the tool goes across.
fn out(groove: &Groove, pen: &mut Pen) {
    let here = groove.here(pen);
    groove.line(pen, DVec2::new(here.x, groove.over.max(here.y)), RAPID);
}

/// Out and across.
fn over(groove: &Groove, pen: &mut Pen, x: f64) {
    out(groove, pen);
    let here = groove.here(pen);
    groove.line(pen, DVec2::new(x, here.y), RAPID);
}

/// Whether a cut goes in the direction of the contour.
fn goes_on(cut: f64, one_way: bool) -> bool {
    one_way || libm::fmod(cut, 2.0) != 0.0
}

impl OverContours for ClearGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        out(groove(contours)?, pen);
        Ok(())
    }
}

impl OverContours for MoveOverGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        over(groove, pen, groove.place(self.side));
        Ok(())
    }
}

impl OverContours for RecessPass {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let top = groove.here(pen);
        let bottom = groove.rough.low(top.x);
        let infeed = if self.depth_limit > 0.0 { self.depth_limit } else { f64::INFINITY };
        if (top.y - bottom) / infeed > MAX_INFEEDS {
            return Err(too_many(MAX_INFEEDS));
        }
        // Where nothing of a blank is left there is nothing to recess; the first infeed counts from where there is.
        let mut reached = match &groove.material {
            None => top.y,
            Some(_) => groove.touches(top.x).unwrap_or(bottom).min(top.y),
        };
        if reached <= bottom + TOUCHES && groove.material.is_some() {
            return Ok(());
        }
        let mut first = true;
        while reached > bottom + SPARE {
            if !std::mem::take(&mut first) {
                groove.line(pen, top, RAPID);
            }
            reached = (reached - infeed).max(bottom);
            if reached < bottom + SPARE {
                reached = bottom;
            }
            groove.line(pen, DVec2::new(top.x, reached), self.at);
        }
        Ok(())
    }
}

impl OverContours for RecessToLevel {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let level = groove.sight.height(self.level).max(groove.rough.floor);
        let cuts = groove.cuts(level);
        let first = if goes_on(self.cut, self.one_way) { cuts.first() } else { cuts.last() };
        if let Some(&[from, to]) = first {
            let here = groove.here(pen);
            let x = here.x.clamp(from, to);
            if groove.rough.is_free(here.y, here.x, x) {
                groove.line(pen, DVec2::new(x, here.y), self.at);
            } else {
                over(groove, pen, x);
            }
            groove.line(pen, DVec2::new(x, level), self.at);
        }
        Ok(())
    }
}

impl OverContours for TurnRecessPass {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let level = groove.sight.height(self.level).max(groove.rough.floor);
        let height = level + self.compensation.max(-groove.allowance);
        let mut cuts = groove.cuts(level);
        if !goes_on(self.cut, self.one_way) {
            cuts.reverse();
            cuts.iter_mut().for_each(|cut| cut.reverse());
        }
        let count = cuts.len();
        let longest = SHORTEST * groove.edge.straight();
        let shorter = ((self.cut - 2.0).max(0.0) * self.shorter.max(0.0)).min(longest);
        for (number, [from, to]) in cuts.into_iter().enumerate() {
            if number > 0 {
                over(groove, pen, from);
            }
            let here = groove.here(pen);
            groove.line(pen, DVec2::new(here.x, height), self.at);
            let short = if number + 1 == count { shorter.min((to - here.x).abs()) } else { 0.0 };
            groove.line(pen, DVec2::new(to - (to - from).signum() * short, height), self.at);
        }
        Ok(())
    }
}

impl OverContours for LiftAndReturn {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let level = groove.sight.height(self.level).max(groove.rough.floor);
        let here = groove.here(pen);
        if let Some(&[from, to]) = groove.cuts(level).first() {
            let one = here.x <= to + SPARE && self.clearance > 0.0;
            let height = if one { (here.y + self.clearance).min(groove.over.max(here.y)) } else { groove.over };
            groove.line(pen, DVec2::new(here.x, height.max(here.y)), self.at);
            groove.line(pen, DVec2::new(from, height.max(here.y)), RAPID);
        }
        Ok(())
    }
}

impl OverContours for MoveToGrooveFlank {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let reach = groove.reach(self.rough);
        over(groove, pen, if self.second { reach.end.x } else { reach.begin.x });
        Ok(())
    }
}

impl OverContours for FollowGrooveWall {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let reach = groove.reach(self.rough);
        if self.rough && reach.is_one_place() {
            // The recess that came down there was all of it.
            return Ok(());
        }
        let foot = reach.feet[usize::from(self.second)];
        groove.follow(reach, pen, DVec2::new(foot, reach.floor), self.at);
        Ok(())
    }
}

impl OverContours for FinishGrooveFloor {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let ([first, last], here) = (groove.finished.feet, groove.here(pen).x);
        let to = if (here - first).abs() <= (here - last).abs() { last } else { first };
        groove.follow(&groove.finished, pen, DVec2::new(to, groove.finished.floor), self.at);
        Ok(())
    }
}

impl OverContours for FinishHalfOfGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        let [first, last] = groove.finished.feet;
        let middle = first.midpoint(last);
        groove.follow(&groove.finished, pen, DVec2::new(middle, groove.finished.low(middle)), self.at);
        Ok(())
    }
}

impl OverContours for FinishWholeGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        groove.follow(&groove.finished, pen, groove.finished.end, self.at);
        Ok(())
    }
}

impl OverContours for LeaveGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        out(groove(contours)?, pen);
        Ok(())
    }
}

impl OverContours for ReturnFromGroove {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let groove = groove(contours)?;
        over(groove, pen, groove.start.x);
        groove.line(pen, groove.start, RAPID);
        Ok(())
    }
}
