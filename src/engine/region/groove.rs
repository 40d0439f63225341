//! Grooves: where an insert with a straight cutting edge between two noses may be over a profile.
//!
//! As a cut sees it, `x` goes across the groove and `y` away from the part. The tip is the corner of the insert that is
//! further in the direction of `x`. An insert comes from above only, so what hangs over counts as filled. Invariant:
//! lines and arcs stay lines and arcs.
use glam::DVec2;

use super::insert_envelope::{Allowance, Envelope, GoesBack, Insert};
use super::{Edge, Way};
use crate::base::expr::atan2d;

/// Angles and lengths below this are none, degrees and mm.
const SAME: f64 = 1e-9;
/// An eased insert is so much narrower, mm: what calculation loses of a groove, and what a program with six decimals does.
pub const EASED: [f64; 2] = [4e-9, 1.6e-6];

/// The cutting edge of a recessing insert.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuttingEdge {
    /// How wide it is, mm.
    pub width: f64,
    /// The radius of both its corners, mm.
    pub radius: f64,
}

impl CuttingEdge {
    /// What is straight of it, mm.
    pub fn straight(&self) -> f64 {
        (self.width - 2.0 * self.radius).max(0.0)
    }

    /// Where the tip of the insert may be over a profile with an allowance; before and after the profile there is part
    /// as high as it begins and ends, so far.
    ///
    /// # Errors
    /// The profile has arcs that end off their circle.
    pub fn over(&self, profile: &Way, allowance: Allowance, far: f64) -> Result<Envelope, GoesBack> {
        self.placed(profile, allowance, far, self.straight())
    }

    /// The same of an insert that is narrower by so much, mm: one of [`EASED`], with which it fits between walls that are
    /// as far from each other as it is wide.
    ///
    /// # Errors
    /// The profile has arcs that end off their circle.
    pub fn eased_over(
        &self,
        narrower: f64,
        (profile, allowance, far): (&Way, Allowance, f64),
    ) -> Result<Envelope, GoesBack> {
        self.placed(profile, allowance, far, (self.straight() - narrower).max(0.0))
    }

    fn placed(&self, profile: &Way, allowance: Allowance, far: f64, straight: f64) -> Result<Envelope, GoesBack> {
        let along = allowance.along.abs() + straight / 2.0;
        let insert = Insert { radius: self.radius, edges: None };
        let shift = DVec2::new(self.width / 2.0, 0.0);
        let mut whole = Envelope::default();
        for way in forwards(profile, far) {
            let way = moved(&way, shift);
            let own = Envelope::over(&way, Allowance { along, away: allowance.away }, insert, -DVec2::Y)?;
            whole = whole.higher(&own);
        }
        Ok(whole)
    }

    /// By how much at most what the insert leaves between two places is higher than what one nose of it would leave, mm.
    /// The insert stays on `own`.
    ///
    /// # Errors
    /// The profile has arcs that end off their circle.
    pub fn leaves(
        &self,
        (profile, allowance, far): (&Way, Allowance, f64),
        own: &Envelope,
        [from, to]: [f64; 2],
    ) -> Result<f64, GoesBack> {
        let nose = Self { width: 2.0 * self.radius, radius: self.radius };
        let alone = nose.over(profile, allowance, far)?;
        let straight = self.straight();
        let more = |x: f64| {
            let lowest = if straight > SAME { own.lowest([x, x + straight]) } else { own.height(x) };
            Some(lowest? - alone.height(x)?)
        };
        let places = alone.places().into_iter().filter(|x| (from - straight..=to).contains(x));
        Ok(places.filter_map(more).fold(0.0, f64::max))
    }
}

fn moved(way: &Way, by: DVec2) -> Way {
    let edges = way.edges.iter().map(|edge| match *edge {
        Edge::Line(to) => Edge::Line(to + by),
        Edge::Arc { to, centre, sweep } => Edge::Arc { to: to + by, centre: centre + by, sweep },
    });
    Way { start: way.start + by, edges: edges.collect() }
}

/// The parts of a profile that go forwards, and what is before and after it. Arcs end at the highest and the lowest
/// place of their circle, so that a wide insert lies on these. What goes back is below something that goes forwards.
fn forwards(profile: &Way, far: f64) -> Vec<Way> {
    let (first, last) = (profile.start, profile.end());
    let beside = DVec2::new(far, 0.0);
    let mut ways = vec![
        Way { start: first - beside, edges: vec![Edge::Line(first)] },
        Way { start: last, edges: vec![Edge::Line(last + beside)] },
    ];
    let mut at = first;
    let mut goes_on = false;
    for edge in profile.edges.iter().flat_map(|edge| {
        let from = std::mem::replace(&mut at, edge.to());
        quarters(from, edge)
    }) {
        let (from, edge) = edge;
        if edge.to().x < from.x {
            goes_on = false;
            continue;
        }
        match ways.last_mut() {
            Some(way) if goes_on => way.edges.push(edge),
            _ => ways.push(Way { start: from, edges: vec![edge] }),
        }
        goes_on = true;
    }
    ways
}

/// An edge with its beginning, arcs cut at the axes of their circle.
fn quarters(from: DVec2, edge: &Edge) -> Vec<(DVec2, Edge)> {
    let Edge::Arc { to, centre, sweep } = *edge else { return vec![(from, *edge)] };
    let arm = from - centre;
    let (begin, radius) = (atan2d(arm.y, arm.x), arm.length());
    let axes = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
    // The axes that it passes, by how far it has come there.
    let mut passed: Vec<(f64, DVec2)> = Vec::new();
    for (axis, angle) in axes.into_iter().zip([0.0, 90.0, 180.0, 270.0]) {
        let way = ((angle - begin) * sweep.signum()).rem_euclid(360.0);
        if way > SAME && way < sweep.abs() - SAME {
            passed.push((way, centre + axis * radius));
        }
    }
    passed.sort_by(|a, b| a.0.total_cmp(&b.0));
    passed.push((sweep.abs(), to));
    let (mut at, mut gone) = (from, 0.0);
    let pieces = passed.into_iter().map(|(way, to)| {
        let sweep = (way - std::mem::replace(&mut gone, way)) * sweep.signum();
        (std::mem::replace(&mut at, to), Edge::Arc { to, centre, sweep })
    });
    pieces.collect()
}
