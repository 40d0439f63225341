//! Strategies that say what is recessed: a groove from the values of a cycle.
//!
//! The groove begins at its first edge; its end point is the corner between the floor and the second flank, which goes
//! out to the height of the beginning (TNC 640 manual, lines 8847-8852). Invariant: nothing moves.
use glam::{DVec2, DVec3};

use super::area::Sight;
use super::groove::{Groove, Reach};
use super::insert_report::{Held, hold};
use super::shoulder::{Treated, points_elsewhere, way_through};
use crate::base::expr::tand;
use crate::engine::machine::TurningInsert;
use crate::engine::region::Way;
use crate::engine::region::groove::CuttingEdge;
use crate::engine::region::insert_envelope::{Allowance, Envelope, GoesBack};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::milling::shape_impossible;
use crate::engine::strategy::signature::{results, strategy};

/// Recesses beside each other are so many cutting widths apart (TNC 640 manual, line 9395).
const SIDE_INFEED: f64 = 0.8;
/// An insert that stays higher than the floor by more than this does not fit, mm.
const FITS: f64 = 1e-6;
/// What calculation may add to a whole number of infeeds.
const SPARE: f64 = 1e-9;

strategy! {
    /// A groove is recessed: from where the cycle began, or from where its contour begins.
    RecessGroove = "groove" {
        /// Whether it is recessed towards the rotary axis or away from it; else along the axis.
        radial: bool = Number,
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
        /// The angle of the first flank to the direction of recessing, degrees.
        first_flank: Option<f64> = Angle,
        /// At the first edge: 1 a chamfer, 2 a rounding.
        first_element: Option<f64> = Number,
        /// Its size, mm.
        first_size: Option<f64> = Length,
        /// The radius of both corners at the floor, mm.
        corner: Option<f64> = Length,
        /// The angle of the second flank, degrees.
        second_flank: Option<f64> = Angle,
        /// At the second edge: 1 a chamfer, 2 a rounding.
        second_element: Option<f64> = Number,
        /// Its size, mm.
        second_size: Option<f64> = Length,
        /// The greatest infeed of recess turning, mm; without it there are recesses only.
        largest_infeed: Option<f64> = Length,
        /// What roughing leaves on diameters, mm.
        allowance_diameter: f64 = Length,
        /// What it leaves along the rotary axis, mm.
        allowance_z: f64 = Length,
        /// What finishing leaves on diameters, mm.
        left_on_diameter: f64 = Length,
        /// What it leaves along the rotary axis, mm.
        left_in_z: f64 = Length,
    }
}

results! {
    /// The levels and places of a groove: diameters, or coordinates on the rotary axis.
    GrooveResults {
        /// Where infeeds begin.
        top: f64 = Length,
        /// Where the first one ends.
        first_depth: f64 = Length,
        /// Where roughing ends.
        rough_floor: f64 = Length,
        /// The infeed, all being the same.
        infeed: f64 = Length,
        /// The sign of the coordinate towards the floor.
        inward: f64 = Number,
        /// Where the first recess is.
        first_recess: f64 = Length,
        /// The same, but of recesses beside each other a side infeed before that: where infeeds to the side begin.
        first_side: f64 = Length,
        /// Where the last one is.
        last_side: f64 = Length,
        /// From one recess to the next one.
        side_infeed: f64 = Length,
        /// What the insert cannot reach, mm.
        left: f64 = Length,
    }
}

/// The cutting edge of the tool in the spindle, and how far the corner in front is ahead of the one whose position is
/// that of the tool.
pub(super) fn cutting_edge(control: &dyn Control, sight: Sight) -> Result<(CuttingEdge, f64), Fault> {
    let insert = control.insert()?;
    let TurningInsert { width, radius, .. } = insert;
    if width <= 0.0 || 2.0 * radius > width + SPARE {
        return Err(Fault::control("cutting-width-missing").arg("tool", insert.tool));
    }
    let Some(way) = insert.way else { return Ok((CuttingEdge { width, radius }, 0.0)) };
    let seen = sight.seen(way.x, way.y);
    if seen.y > 0.0 {
        return Err(points_elsewhere(&insert));
    }
    Ok((CuttingEdge { width, radius }, width * (1.0 - seen.x) / 2.0))
}

/// Whether turning updates a blank, and what is left of it as cuts see it.
pub(super) fn blank_of(control: &dyn Control, sight: Sight) -> Option<Option<Way>> {
    control.updates_blank().then(|| control.outline_of_blank(&|way| sight.seen_way(way)))
}

/// What is to be recessed of a profile, and how.
pub(super) struct Wanted {
    pub sight: Sight,
    pub profile: Way,
    pub edge: CuttingEdge,
    /// How far the corner in front is ahead of the position of the tool.
    pub lead: f64,
    /// Where the cycle began.
    pub start: DVec2,
    /// What roughing and finishing leave on diameters and along the rotary axis.
    pub allowances: [(f64, f64); 2],
    pub largest_infeed: Option<f64>,
    /// The cutting limit: the lowest height, and the place with whether what is beyond it stays.
    pub limit: (Option<f64>, Option<(f64, bool)>),
    /// Whether turning updates a blank, and what is left of it as cuts see it.
    pub blank: Option<Option<Way>>,
}

impl Wanted {
    fn allowances(&self) -> [Allowance; 2] {
        self.allowances.map(|(diameter, z)| match self.sight.face {
            true => Allowance { along: diameter / 2.0, away: z },
            false => Allowance { along: z, away: diameter / 2.0 },
        })
    }

    /// How far the part goes on beside the profile.
    fn far(&self) -> f64 {
        let widest = self.allowances().map(|allowance| allowance.along.abs()).into_iter().fold(0.0, f64::max);
        10.0 * (self.edge.width + widest) + (self.start - self.profile.start).length()
    }

    /// The groove, with what the insert cannot reach of it.
    pub(super) fn groove(&self) -> Result<(Groove, f64), GoesBack> {
        let far = self.far();
        let [allowance, left] = self.allowances();
        let reach = |allowance| Reach::new(&self.profile, self.edge, allowance, far);
        let ((rough, more), (finished, least)) = (reach(allowance)?, reach(left)?);
        let rough = rough.limited(self.edge, self.limit, far);
        let finished = finished.limited(self.edge, self.limit, far);
        let none = Allowance { along: 0.0, away: 0.0 };
        let material = match &self.blank {
            None => None,
            Some(None) => Some(Envelope::default()),
            Some(Some(outline)) => Some(self.edge.over(outline, none, 0.0)?),
        };
        let top = material
            .as_ref()
            .and_then(|own| own.summit([rough.begin.x - self.edge.width, rough.end.x + self.edge.width]));
        let highest = self.profile.edges.iter().map(|edge| edge.to().y).fold(self.profile.start.y, f64::max);
        let groove = Groove {
            sight: self.sight,
            edge: self.edge,
            lead: self.lead,
            over: self.start.y.max(highest).max(top.map_or(highest, |top| top.y)),
            rough,
            finished,
            start: self.start,
            allowance: allowance.away.max(0.0),
            material,
        };
        Ok((groove, more.max(least)))
    }

    /// The levels and places of a groove.
    pub(super) fn results(&self, groove: &Groove, left: f64) -> Result<GrooveResults, Fault> {
        let (rough, sight) = (&groove.rough, groove.sight);
        let top = groove.top();
        let whole = (top - rough.floor).max(0.0);
        let infeed = match self.largest_infeed {
            None => whole,
            Some(depth) if depth > 0.0 => whole / libm::ceil(whole / depth - SPARE).max(1.0),
            Some(depth) => return Err(Fault::program("parameter-out-of-range").arg("q", "").arg("value", depth)),
        };
        let first_depth = top - infeed;
        let apart = SIDE_INFEED * self.edge.width;
        let (first, before, last) = if self.largest_infeed.is_some() {
            let cuts = groove.cuts(first_depth);
            let first = cuts.first().map_or(rough.feet[0], |cut| cut[0]);
            (first, 0.0, cuts.last().map_or(rough.feet[1], |cut| cut[1]))
        } else {
            // A flank that is narrower than the side infeed is left to finishing, as it is between two recesses.
            let (feet, last) = (rough.feet, rough.feet[1].max(rough.end.x - apart));
            let first = feet[0].min(rough.begin.x + apart);
            let on_flank = |from: f64| libm::ceil((feet[0] - from) / apart - SPARE);
            let meets_floor = first + apart * on_flank(first) <= feet[1] + FITS || last <= feet[1] + FITS;
            // No recess would come down to a floor on which the insert has next to no room: then one begins there, and
            // others are beside it up the flank.
            let first = if meets_floor { first } else { feet[0] - apart * (on_flank(rough.begin.x) - 1.0).max(0.0) };
            (first, apart, last)
        };
        let scale = sight.level(1.0).abs();
        Ok(GrooveResults {
            top: sight.level(top),
            first_depth: sight.level(first_depth),
            rough_floor: sight.level(rough.floor),
            infeed: infeed * scale,
            inward: -sight.away,
            first_recess: groove.side(first),
            first_side: groove.side(first - before),
            last_side: groove.side(last),
            side_infeed: apart * groove.scale(),
            left,
        })
    }
}

impl RecessGroove {
    fn sight(&self) -> Sight {
        let towards = |from: f64, to: f64| if to < from { -1.0 } else { 1.0 };
        let (out, along) = (towards(self.end_diameter, self.start_diameter), towards(self.start_z, self.end_z));
        match self.radial {
            true => Sight { face: false, ahead: along, away: out },
            false => Sight { face: true, ahead: -out, away: -along },
        }
    }

    fn profile(&self, sight: Sight) -> Result<Way, Fault> {
        let seen = |diameter: f64, z: f64| sight.seen(diameter / 2.0, z);
        let (start, end) = (seen(self.start_diameter, self.start_z), seen(self.end_diameter, self.end_z));
        let lean = |angle: Option<f64>| tand(angle.unwrap_or_default()) * (start.y - end.y);
        let element = |kind: Option<f64>, size: Option<f64>| match kind.unwrap_or_default() {
            0.0 => Treated::Sharp,
            1.0 => Treated::Chamfer(size.unwrap_or_default()),
            _ => Treated::Round(size.unwrap_or_default()),
        };
        let corner = Treated::Round(self.corner.unwrap_or_default());
        let foot = DVec2::new(start.x + lean(self.first_flank), end.y);
        let outer = DVec2::new(end.x + lean(self.second_flank), start.y);
        if foot.x > end.x + SPARE {
            return Err(shape_impossible(0.0, end.x - foot.x));
        }
        let far = (start - end).length().max(1.0);
        way_through(&[
            (start - DVec2::X * far, Treated::Sharp),
            (start, element(self.first_element, self.first_size)),
            (foot, corner),
            (end, corner),
            (outer, element(self.second_element, self.second_size)),
            (outer + DVec2::X * far, Treated::Sharp),
        ])
    }
}

strategy! {
    /// A groove is recessed whose contour is the subprogram that is in effect.
    RecessGrooveOfContour = "groove-of-contour" {
        /// Whether it is recessed towards the rotary axis or away from it; else along the axis.
        radial: bool = Number,
        /// Where the cycle began, with a diameter as its main coordinate.
        start: DVec3 = Length,
        /// Whether it is recessed on one side of a limit only: that on which the cycle began.
        limited: bool = Number,
        /// The diameter of that limit.
        limit_diameter: f64 = Length,
        /// Its coordinate on the rotary axis.
        limit_z: f64 = Length,
        /// The greatest infeed of recess turning, mm; without it there are recesses only.
        largest_infeed: Option<f64> = Length,
        /// What roughing leaves on diameters, mm.
        allowance_diameter: f64 = Length,
        /// What it leaves along the rotary axis, mm.
        allowance_z: f64 = Length,
        /// What finishing leaves on diameters, mm.
        left_on_diameter: f64 = Length,
        /// What it leaves along the rotary axis, mm.
        left_in_z: f64 = Length,
    }
}

impl RecessGrooveOfContour {
    /// How the cuts see a contour: `x` of it is along the rotary axis, `y` a radius. The side of the part is that from
    /// which the contour goes down furthest.
    fn sight(&self, contour: &Way) -> Sight {
        let (mut least, mut most) = (contour.start, contour.start);
        for edge in &contour.edges {
            (least, most) = (least.min(edge.to()), most.max(edge.to()));
        }
        let (across, down) = (contour.end() - contour.start, [contour.start - least, most - contour.start]);
        let sign = |positive: bool| if positive { 1.0 } else { -1.0 };
        match self.radial {
            true => Sight { face: false, ahead: sign(across.x > 0.0), away: sign(down[0].y >= down[1].y) },
            false => Sight { face: true, ahead: sign(across.y > 0.0), away: sign(down[0].x >= down[1].x) },
        }
    }
}

impl Action for RecessGrooveOfContour {
    type Results = GrooveResults;

    fn act(&self, control: &mut dyn Control) -> Done<GrooveResults> {
        let contour = control.read_turned_contour()?;
        let sight = self.sight(&contour);
        let (edge, lead) = cutting_edge(control, sight)?;
        let start = sight.seen(self.start.x / 2.0, self.start.z) + DVec2::X * lead;
        let limit = sight.seen(self.limit_diameter / 2.0, self.limit_z);
        let height = (self.limited && start.y >= limit.y).then_some(limit.y);
        let side = (self.limited && (start.x - limit.x).abs() > FITS).then_some((limit.x, start.x < limit.x));
        let wanted = Wanted {
            sight,
            profile: sight.seen_way(&contour),
            edge,
            lead,
            start,
            allowances: [(self.allowance_diameter, self.allowance_z), (self.left_on_diameter, self.left_in_z)],
            largest_infeed: self.largest_infeed,
            limit: (height, side),
            blank: blank_of(control, sight),
        };
        let (groove, left) = wanted.groove().map_err(|GoesBack| shape_impossible(0.0, 0.0))?;
        if groove.rough.floor > groove.over - FITS {
            return Err(shape_impossible(edge.width, 0.0).into());
        }
        let results = wanted.results(&groove, left)?;
        control.keep_groove(groove);
        hold(control, sight, Held::Recessing(edge))?;
        Ok(results)
    }
}

impl Action for RecessGroove {
    type Results = GrooveResults;

    fn act(&self, control: &mut dyn Control) -> Done<GrooveResults> {
        let sight = self.sight();
        let (edge, lead) = cutting_edge(control, sight)?;
        let wanted = Wanted {
            sight,
            profile: self.profile(sight)?,
            edge,
            lead,
            start: sight.seen(self.start.x / 2.0, self.start.z) + DVec2::X * lead,
            allowances: [(self.allowance_diameter, self.allowance_z), (self.left_on_diameter, self.left_in_z)],
            largest_infeed: self.largest_infeed,
            limit: (None, None),
            blank: blank_of(control, sight),
        };
        let (groove, left) = wanted.groove().map_err(|GoesBack| shape_impossible(0.0, 0.0))?;
        let floor = sight.seen(self.end_diameter / 2.0, self.end_z).y;
        for (reach, allowance) in [&groove.rough, &groove.finished].into_iter().zip(wanted.allowances()) {
            if reach.floor > floor + allowance.away + FITS {
                let (from, to) = (wanted.profile.start.x, wanted.profile.end().x);
                let room = (to - from - 2.0 * allowance.along.abs()).max(0.0);
                return Err(shape_impossible(edge.width, room.min(edge.width)).into());
            }
        }
        let results = wanted.results(&groove, left)?;
        control.keep_groove(groove);
        hold(control, sight, Held::Recessing(edge))?;
        Ok(results)
    }
}
