//! Strategies that turn: one level, one infeed, one retreat, or once along the contour.
//!
//! What is turned was said before ([`shoulder`](super::shoulder), [`contour`](super::contour)). Invariant: at a feed the tip stays on the
//! envelope of the contour or above it, and at rapid traverse where nothing is left to cut.
use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec2;

use super::area::Turned;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::contour::{Contours, OverContours};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// What is lower than the tool by less than this, mm, touches it.
const TOUCHING: f64 = 1e-5;
/// So near to the end of a cut the tool is at it, mm.
const NEAR: f64 = 1e-3;
/// What calculation may add to a level, mm.
const SPARE: f64 = 1e-6;

strategy! {
    /// To where cuts begin, where the cycle began within what is to be removed.
    ClearTurningArea = "clear-turning-area" {
        /// Whether away from the part before that.
        away: bool = Number,
    }
}

strategy! {
    /// To the beginning of the first cut at a level: straight at rapid traverse, or, where something is in front of it,
    /// over that and along the contour at the feed.
    InfeedToTurningLevel = "infeed-to-turning-level" {
        /// The level: a diameter, or a coordinate on the rotary axis.
        level: f64 = Length,
        /// The one before it.
        before: f64 = Length,
        /// The feed down into the part, mm/min; 0 or nothing for that of the cuts.
        plunging: Option<f64> = Feed,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// All cuts at a level; after each but the last over to the next one.
    RoughTurningLevel = "rough-turning-level" {
        /// The level.
        level: f64 = Length,
        /// The one before it.
        before: f64 = Length,
        /// The feed down into the part, mm/min; 0 or nothing for that of the cuts.
        plunging: Option<f64> = Feed,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Along the contour from a level to the one before it.
    FollowTurnedContour = "follow-turned-contour" {
        /// The level at which the tool is.
        from: f64 = Length,
        /// The one before it.
        to: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Back from a level to the one before it at 45 degrees.
    LiftOffTurnedContour = "lift-off-turned-contour" {
        /// The level at which the tool is.
        from: f64 = Length,
        /// The one before it.
        to: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// To where cuts begin, at rapid traverse: straight, or over what is in front of the cut.
    ReturnToStartOfCut = "return-to-start-of-cut" {}
}

strategy! {
    /// To the clearance before the contour at rapid traverse, axis by axis.
    ApproachTurningContour = "approach-turning-contour" {}
}

strategy! {
    /// Along the whole contour; the tool is in front of it.
    FinishTurnedContour = "finish-turned-contour" {
        /// The feed down into the part, mm/min; 0 or nothing for that of the cuts.
        plunging: Option<f64> = Feed,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Away from the contour by the clearance, at 45 degrees.
    RetractFromTurningContour = "retract-from-turning-contour" {
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// To where the cycle began at rapid traverse, axis by axis; where something is behind the tool and above it, out along
    /// the edge in front.
    ReturnToTurningStart = "return-to-turning-start" {}
}

/// What is turned.
pub(super) fn turned(contours: &Contours) -> Result<&Turned, Fault> {
    contours.turned.as_ref().ok_or_else(|| Fault::program("contour-not-defined"))
}

/// The feed down into the part.
fn down(plunging: Option<f64>, feed: f64) -> f64 {
    plunging.filter(|feed| *feed > 0.0).unwrap_or(feed)
}

/// Out to a height at rapid traverse. Over the contour the edge in front, if it leans back, may stand under what it has left
/// above: then along that edge, which takes the insert through nothing but where it is, seen as without end.
fn out(turned: &Turned, pen: &mut Pen, height: f64) {
    let here = turned.here(pen);
    let leans = if here.x > turned.beginning().x + SPARE { turned.leans_back } else { 0.0 };
    turned.line(pen, DVec2::new(here.x - (height - here.y).max(0.0) * leans, height), RAPID);
}

/// Back at 45 degrees to a height, as far as there is room; never steeper than the edge in front leans back.
fn lift(turned: &Turned, pen: &mut Pen, height: f64, feed: f64) {
    let here = turned.here(pen);
    let room = turned.cut_at(here.y, here.x).map_or(0.0, |[from, _]| here.x - from);
    let rise = (height - here.y).max(0.0);
    let back = rise.min(room.max(0.0)).max(rise * turned.leans_back);
    turned.line(pen, here + DVec2::new(-back, rise), feed);
}

/// To the beginning of a cut over what is in front of it, and down the contour.
fn plunge(turned: &Turned, pen: &mut Pen, cut: [f64; 2], (level, before): (f64, f64), (feed, down): (f64, f64)) {
    let above = turned.cut_at(before, cut[0]).filter(|above| !turned.is_open(*above));
    let near = [turned.begin.x.min(cut[0]), cut[0]];
    let from = above.map(|[x, _]| DVec2::new(x, before));
    let from = from.or_else(|| turned.envelope.summit(near)).unwrap_or(DVec2::new(cut[0], before));
    let here = turned.here(pen);
    let over = turned.over().max(here.y);
    out(turned, pen, over);
    if turned.along_contour && above.is_none() && turned.heading.y > -SPARE {
        // In front of the contour there is nothing, and above it what the cut before has left.
        turned.line(pen, DVec2::new(turned.beginning().x, over), RAPID);
        turned.line(pen, DVec2::new(turned.beginning().x, turned.begin.y), RAPID);
        turned.line(pen, turned.begin, feed);
        turned.follow_down(pen, DVec2::new(cut[0], level), feed, down);
        return;
    }
    let top = match (&turned.material, above) {
        (Some(material), _) => material.height(from.x).unwrap_or(from.y),
        // In front of the first cut there may be material as high as the contour.
        (None, None) => turned.highest,
        (None, Some(_)) => from.y,
    };
    let material = from.y.max(if turned.along_contour { before } else { top.min(before) });
    turned.line(pen, DVec2::new(from.x, over), RAPID);
    turned.line(pen, DVec2::new(from.x, (material + turned.clearance).min(over)), RAPID);
    turned.line(pen, from, feed);
    turned.follow_down(pen, DVec2::new(cut[0], level), feed, down);
}

/// To the beginning of a cut where there is neither blank nor contour: over what is in front of it, and down.
fn come_down(turned: &Turned, pen: &mut Pen, to: DVec2, feed: f64) {
    let (here, near) = (turned.here(pen), to.y + turned.clearance);
    // In front of all cuts the tool comes at the height of the cut.
    let open =
        turned.cut_at(to.y, to.x).is_some_and(|cut| turned.is_open(cut)) && here.x <= turned.beginning().x + SPARE;
    let first = turned.material.as_ref().and_then(|own| own.summit([turned.beginning().x, to.x]));
    let over = match open && first.is_none_or(|first| first.y <= to.y + SPARE) {
        true => near,
        false => turned.over().max(here.y),
    };
    out(turned, pen, over);
    turned.line(pen, DVec2::new(to.x, over), RAPID);
    turned.line(pen, DVec2::new(to.x, near.min(over)), RAPID);
    turned.line(pen, to, feed);
}

impl OverContours for ClearTurningArea {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let to = turned.beginning();
        if to != turned.start {
            let here = turned.here(pen);
            let height = if self.away { to.y } else { here.y };
            turned.line(pen, DVec2::new(here.x, height), RAPID);
            turned.line(pen, DVec2::new(to.x, height), RAPID);
        }
        Ok(())
    }
}

impl OverContours for InfeedToTurningLevel {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let (level, before) = (turned.sight.height(self.level), turned.sight.height(self.before));
        match turned.cuts_after(level, before).first() {
            None => {}
            Some(cut) if cut.begins_free => come_down(turned, pen, DVec2::new(cut.from, level), self.at),
            Some(cut) if turned.is_open(cut.range()) => {
                let (here, x) = (turned.here(pen), turned.beginning().x);
                if here.x > x + SPARE {
                    out(turned, pen, turned.over().max(here.y));
                    turned.line(pen, DVec2::new(x, turned.over().max(here.y)), RAPID);
                }
                turned.line(pen, DVec2::new(turned.here(pen).x, level), RAPID);
            }
            Some(cut) => plunge(turned, pen, cut.range(), (level, before), (self.at, down(self.plunging, self.at))),
        }
        Ok(())
    }
}

impl OverContours for RoughTurningLevel {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let (level, before) = (turned.sight.height(self.level), turned.sight.height(self.before));
        for (number, next) in turned.cuts_after(level, before).into_iter().enumerate() {
            let cut = next.range();
            if number > 0 && next.begins_free {
                lift(turned, pen, before, self.at);
                come_down(turned, pen, DVec2::new(next.from, level), self.at);
                turned.line(pen, DVec2::new(next.to, level), self.at);
                continue;
            }
            let here = turned.here(pen);
            let together = turned.along_contour
                && turned.cut_at(before, here.x).is_some_and(|[from, to]| from <= cut[0] && cut[0] <= to);
            if number > 0 && together {
                turned.follow_down(pen, DVec2::new(cut[0], level), self.at, down(self.plunging, self.at));
            } else if number > 0 {
                lift(turned, pen, before, self.at);
                plunge(turned, pen, cut, (level, before), (self.at, down(self.plunging, self.at)));
            }
            turned.line(pen, DVec2::new(cut[1], level), self.at);
        }
        Ok(())
    }
}

impl OverContours for FollowTurnedContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let (here, before) = (turned.here(pen), turned.sight.height(self.to));
        if (here.y - turned.sight.height(self.from)).abs() > SPARE {
            return Ok(());
        }
        // A cut that ended where nothing of a blank is left is not at the contour.
        if turned.material.is_some() && turned.cut_at(here.y, here.x).is_none_or(|[_, end]| here.x < end - NEAR) {
            lift(turned, pen, before, self.at);
        } else if let Some([_, end]) = turned.cut_at(before, here.x) {
            turned.follow(pen, DVec2::new(end, before), self.at);
        }
        Ok(())
    }
}

impl OverContours for LiftOffTurnedContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        if (turned.here(pen).y - turned.sight.height(self.from)).abs() <= SPARE {
            lift(turned, pen, turned.sight.height(self.to), self.at);
        }
        Ok(())
    }
}

/// Whether the way back to where cuts begin is in the open. Along a surface the tool does not go at rapid traverse.
fn is_free(turned: &Turned, here: DVec2) -> bool {
    turned.cuts(here.y - TOUCHING).first().is_some_and(|cut| turned.is_open(*cut) && here.x <= cut[1] + NEAR)
}

impl OverContours for ReturnToStartOfCut {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let (here, to) = (turned.here(pen), turned.beginning());
        if turned.material.is_some() && here.x <= to.x + SPARE {
            return Ok(());
        }
        let height = if is_free(turned, here) { here.y } else { turned.over().max(here.y) };
        out(turned, pen, height);
        turned.line(pen, DVec2::new(to.x, height), RAPID);
        Ok(())
    }
}

impl OverContours for ApproachTurningContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        // Where the contour goes up, an insert that leans forwards does not come from below.
        let along = if turned.heading.y > -SPARE { DVec2::X } else { turned.heading };
        let (here, mut to) = (turned.here(pen), turned.begin - along * turned.clearance);
        if along == DVec2::X {
            to.x = to.x.min(here.x);
        }
        let over = if here.x <= to.x.max(turned.begin.x) { here.y.max(to.y) } else { turned.over().max(here.y) };
        turned.line(pen, DVec2::new(here.x, over), RAPID);
        turned.line(pen, DVec2::new(to.x, over), RAPID);
        turned.line(pen, to, RAPID);
        Ok(())
    }
}

impl OverContours for FinishTurnedContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        turned.line(pen, turned.begin, self.at);
        turned.follow_down(pen, turned.end, self.at, down(self.plunging, self.at));
        Ok(())
    }
}

impl OverContours for RetractFromTurningContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let by = turned.clearance * FRAC_1_SQRT_2;
        turned.line(pen, turned.here(pen) + DVec2::new(-by, by), self.at);
        Ok(())
    }
}

impl OverContours for ReturnToTurningStart {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let turned = turned(contours)?;
        let (here, to) = (turned.here(pen), turned.start);
        // Of what is above the end of the contour, an insert leaves what its edge in front leans away from: a wedge that is
        // the wider the higher up.
        let wedge = (to.y - turned.end.y) * turned.leans_back;
        let high = here.y.max(to.y);
        let (over, x) = match wedge > turned.end.x - here.x {
            true if is_free(turned, here) => (here.y, here.x),
            // Out along the edge in front: the insert stays where it is already, seen as without end.
            true => (high, here.x - (high - here.y) * turned.leans_back),
            false => (high, here.x),
        };
        // On the surface in front of a contour there may be an allowance that is higher than where the cycle began.
        let way = [to.x.min(x), to.x.max(x)];
        let top = turned.envelope.summit(way).map_or(over, |summit| summit.y);
        let over = if top > over + TOUCHING { over.max(turned.over()) } else { over };
        turned.line(pen, DVec2::new(x, over), RAPID);
        turned.line(pen, DVec2::new(to.x, over), RAPID);
        turned.line(pen, to, RAPID);
        Ok(())
    }
}
