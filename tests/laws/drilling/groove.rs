//! The groove of a milled thread, measured on the part: a tool with a single row of teeth leaves a groove whose turns lie
//! one pitch above the other, rising with the hand, from the bottom on, as far out as the diameter says.
use glam::DVec2;
use proptest::prelude::*;

use super::setup::{HALF, HEIGHT, Made, Setup};

/// What a single row of teeth cuts.
#[derive(Clone, Debug)]
pub(super) struct Groove {
    pub(super) centre: DVec2,
    /// The radius that the edge reaches, and the radius of the way of the tool's centre.
    pub(super) reach: f64,
    pub(super) way: f64,
    pub(super) tool: f64,
    /// Height of the teeth.
    pub(super) tooth: f64,
    pub(super) pitch: f64,
    pub(super) right: bool,
    /// Heights of the tip at the lower ends of the helices, and the turns of each.
    pub(super) helices: Vec<(f64, u32)>,
    /// The ring that the tool enters: between core and edge, or between edge and stud.
    pub(super) ring: (f64, f64),
    pub(super) outside: bool,
}

impl Groove {
    /// Height of the tip over a direction in the first turn above the lower end of a helix.
    fn height(&self, low: f64, angle: f64) -> f64 {
        let share = angle.to_degrees().rem_euclid(360.0) / 360.0;
        low + self.pitch * if self.right { share } else { 1.0 - share }
    }

    /// By how much a tooth is over a place before and after it passes: the half angle under which the tool covers it.
    fn covers(&self, far: f64) -> Option<f64> {
        let cos = (far * far + self.way * self.way - self.tool * self.tool) / (2.0 * far * self.way);
        (cos.abs() < 1.0).then(|| cos.acos())
    }

    /// The whole stock against this groove. How many columns and ridges were looked at.
    pub(super) fn measured(&self, setup: &Setup, made: &Made) -> Result<(u32, u32), TestCaseError> {
        let (columns, rows) = made.stock.size();
        let (mut looked, mut ridges) = (0, 0);
        let bottom = setup.surface - HEIGHT;
        let lowest = self.helices.iter().map(|(low, _)| *low).fold(f64::INFINITY, f64::min);
        let highest =
            self.helices.iter().map(|(low, turns)| low + self.pitch * f64::from(*turns)).fold(bottom, f64::max);
        for row in 0..rows {
            for column in 0..columns {
                let place = setup.unseen(made.stock.place(column, row)) - self.centre;
                let far = place.length();
                let left = made.stock.column(column, row);
                let (near, beyond) = if self.outside {
                    (far > self.reach + 1e-3, far < self.reach - 1e-3)
                } else {
                    (far < self.reach - 1e-3, far > self.reach + 1e-3)
                };
                if beyond {
                    let whole = left.len() == 1
                        && left
                            .iter()
                            .all(|[low, high]| (low - bottom).abs() < 1e-9 && (high - setup.surface).abs() < 1e-9);
                    prop_assert!(whole, "{:?} beyond the thread at {}: {:?} {:?}{}", left, far, place, self, made.text);
                }
                if !near || far < self.ring.0 || far > self.ring.1 {
                    continue;
                }
                let Some(half) = self.covers(far) else { continue };
                let angle = place.to_angle();
                let solid = |z: f64| left.iter().any(|[low, high]| *low < z && z < *high);
                looked += 1;
                // Every turn is there …
                for (low, turns) in &self.helices {
                    for turn in 0..*turns {
                        let z = self.height(*low, angle) + self.pitch * f64::from(turn) + self.tooth / 2.0;
                        prop_assert!(!solid(z), "no groove at {} {} {:?}{}", place, z, self, made.text);
                    }
                }
                // … with a ridge halfway to the next one where the teeth leave one …
                let rise = self.pitch * half.to_degrees() / 360.0;
                if self.tooth + 2.0 * rise < 0.8 * self.pitch {
                    for (low, turns) in &self.helices {
                        for turn in 1..*turns {
                            let z = self.height(*low, angle) + self.pitch * (f64::from(turn) - 0.5) + self.tooth / 2.0;
                            if z < setup.surface {
                                ridges += 1;
                                prop_assert!(solid(z), "no ridge at {} {} {:?}{}", place, z, self, made.text);
                            }
                        }
                    }
                }
                // … and nothing is cut below or above what joining and leaving it takes.
                let under = lowest - self.pitch / 2.0 - rise;
                let over = highest + self.pitch / 2.0 + rise + self.tooth;
                let missing = |from: f64, to: f64| {
                    let (from, to) = (from.max(bottom), to.min(setup.surface));
                    let kept: f64 = left.iter().map(|[low, high]| (high.min(to) - low.max(from)).max(0.0)).sum();
                    (to - from).max(0.0) - kept
                };
                prop_assert!(missing(bottom, under) < 1e-6, "below the thread at {} {:?}{}", place, self, made.text);
                prop_assert!(
                    missing(over, setup.surface) < 1e-6,
                    "above the thread at {} {:?}{}",
                    place,
                    self,
                    made.text
                );
            }
        }
        prop_assert!(looked > 0, "no column in the ring of {:?} within {}", self, HALF);
        Ok((looked, ridges))
    }
}
