//! What a machine can do, as `ciklo.toml` says it: travel of its axes, greatest speed and feed, longest helix.
//!
//! Invariant: nothing is known that the file does not say.
use std::collections::BTreeMap;

/// The limits of a machine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Machine {
    /// The greatest spindle speed, rev/min.
    pub speed: Option<f64>,
    /// The greatest feed, mm/min.
    pub feed: Option<f64>,
    /// The greatest angle of one helix, degrees.
    pub helix: Option<f64>,
    /// The travel of axes by their letters: machine coordinates of both ends, mm or degrees.
    pub travel: BTreeMap<String, [f64; 2]>,
}

impl Machine {
    /// The axes that a machine may have.
    pub const AXES: [&'static str; 9] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];

    /// Takes what another one says in addition; what it says wins.
    pub(super) fn overlay(&mut self, other: &Self) {
        self.speed = other.speed.or(self.speed);
        self.feed = other.feed.or(self.feed);
        self.helix = other.helix.or(self.helix);
        self.travel.extend(other.travel.iter().map(|(axis, ends)| (axis.clone(), *ends)));
    }

    /// Whether it says anything.
    pub fn is_known(&self) -> bool {
        *self != Self::default()
    }
}
