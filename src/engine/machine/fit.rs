//! The kinematics that explain a survey best: places, and on request directions, of the lines about which axes turn.
//!
//! Invariant: the sum of squared distances between where the sphere was seen and where it is expected is least, over the
//! place of the sphere and two coordinates (and two angles) of each axis that was measured; what the positions do not
//! tell stays as it is and is named. Places enter linearly, so one step finds them; directions take a few.
use glam::DVec3;
use nalgebra::{DMatrix, DVector};

use super::Machine;
use super::survey::Survey;
use crate::engine::geometry::{Axis, RotaryAxis};

/// Steps at most, and the length of one, mm, after which nothing changes any more.
const STEPS: usize = 24;
const DONE: f64 = 1e-13;
/// Directions are determined by positions whose effect is at least this share of the greatest.
const TOLD: f64 = 1e-3;
/// What takes part in a combination that nothing tells with more than this share is not told either.
const TAKES_PART: f64 = 1e-3;
/// Degrees that move a point at a lever of 100 mm by 1 mm: so angles weigh like lengths.
const DEGREES: f64 = 180.0 / std::f64::consts::PI / 100.0;
/// How far places, mm, and angles, in the same measure, are changed to see the effect.
const APART: [f64; 2] = [1.0, 0.01];
/// The rating of positions that tell a place as exactly as one position of the sphere is measured.
const GOOD: f64 = 4.0;

/// What an unknown is: a coordinate of the sphere, of a line or an angle of it, along or about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unknown {
    Sphere(Axis),
    Place(RotaryAxis, Axis),
    Direction(RotaryAxis, Axis),
}

impl Unknown {
    fn of(self) -> Option<RotaryAxis> {
        match self {
            Self::Sphere(_) => None,
            Self::Place(axis, _) | Self::Direction(axis, _) => Some(axis),
        }
    }

    fn apart(self) -> f64 {
        APART[usize::from(matches!(self, Self::Direction(..)))]
    }
}

/// Kinematics that fit a survey.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The machine.
    pub machine: Machine,
    /// Where the sphere is while the table is at 0.
    pub sphere: DVec3,
    /// The axes of which the positions do not tell all.
    pub undetermined: Vec<RotaryAxis>,
    /// How many times the error of one position the error of a place is.
    spread: Vec<(RotaryAxis, f64)>,
}

/// A guess: the machine and the sphere.
#[derive(Clone)]
struct Guess {
    machine: Machine,
    sphere: DVec3,
}

impl Guess {
    fn change(&mut self, unknown: Unknown, by: f64) {
        let add = |axis: Axis, v: DVec3, by: f64| axis.with(v, axis.of(v) + by);
        match unknown {
            Unknown::Sphere(axis) => self.sphere = add(axis, self.sphere, by),
            Unknown::Place(of, axis) => {
                if let Some(line) = self.machine.rotary.iter_mut().find(|known| known.axis == of) {
                    line.centre = add(axis, line.centre, by);
                }
            }
            Unknown::Direction(of, axis) => {
                if let Some(line) = self.machine.rotary.iter_mut().find(|known| known.axis == of) {
                    line.askew = add(axis, line.askew, by * DEGREES);
                }
            }
        }
    }

    fn expected(&self, survey: &Survey) -> Vec<DVec3> {
        survey.stations.iter().map(|station| survey.expected(&self.machine, self.sphere, station.angles)).collect()
    }
}

impl Fit {
    /// Fits a survey; with the directions of the axes or only their places.
    pub fn of(survey: &Survey, directions: bool) -> Self {
        let mut unknowns: Vec<Unknown> = Axis::ALL.into_iter().map(Unknown::Sphere).collect();
        for plan in survey.axes() {
            let Some(line) = survey.model.rotary(plan.axis) else { continue };
            let across = || Axis::ALL.into_iter().filter(|axis| *axis != line.about.0);
            unknowns.extend(across().map(|axis| Unknown::Place(plan.axis, axis)));
            if directions {
                unknowns.extend(across().map(|axis| Unknown::Direction(plan.axis, axis)));
            }
        }
        let first = survey.stations.first();
        let sphere = first.map_or(DVec3::ZERO, |station| survey.sphere(&survey.model, station));
        let mut guess = Guess { machine: survey.model.clone(), sphere };
        let (mut open, mut spread) = (Vec::new(), Vec::new());
        for _ in 0..STEPS {
            let effects = effects(survey, &guess, &unknowns);
            let found = guess.expected(survey);
            let gaps =
                survey.stations.iter().zip(&found).flat_map(|(station, found)| (station.seen - found).to_array());
            let mut gaps: Vec<f64> = gaps.collect();
            gaps.resize(effects.nrows(), 0.0);
            let parts = effects.svd(true, true);
            let least = parts.singular_values.max() * TOLD;
            let step = parts.solve(&DVector::from_vec(gaps), least);
            let Ok(step) = step else { break };
            (open, spread) = told(&parts.singular_values, parts.v_t.as_ref(), least, &unknowns);
            unknowns.iter().zip(step.iter()).for_each(|(unknown, by)| guess.change(*unknown, *by));
            if step.amax() < DONE {
                break;
            }
        }
        let mut undetermined: Vec<RotaryAxis> = open.iter().filter_map(|unknown| unknown.of()).collect();
        undetermined.dedup();
        // What is not told stays as it was.
        for axis in &mut guess.machine.rotary {
            if let Some(known) = survey.model.rotary(axis.axis).filter(|_| undetermined.contains(&axis.axis)) {
                *axis = *known;
            }
        }
        Self { machine: guess.machine, sphere: guess.sphere, undetermined, spread }
    }

    /// Whether the positions tell all that was looked for of an axis.
    pub fn determines(&self, axis: RotaryAxis) -> bool {
        !self.undetermined.contains(&axis)
    }

    /// How well the positions tell the place of an axis: 4 where it is as exact as a single position of the sphere, more
    /// where it is more exact, 0 where they do not tell it.
    pub fn rating(&self, axis: RotaryAxis) -> f64 {
        let spread = self.spread.iter().filter(|(known, _)| *known == axis).map(|(_, spread)| *spread);
        let worst = spread.fold(0.0, f64::max);
        if worst > 0.0 && self.determines(axis) { GOOD / worst } else { 0.0 }
    }

    /// The greatest change of a coordinate of an axis, mm.
    pub fn greatest_change(&self, before: &Machine) -> f64 {
        let changes = self.machine.rotary.iter().zip(&before.rotary).map(|(now, old)| (now.centre - old.centre).abs());
        changes.map(DVec3::max_element).fold((self.machine.base - before.base).abs().max_element(), f64::max)
    }
}

/// How the expected positions change with each unknown; rows of zeros are added where there are fewer rows than unknowns.
fn effects(survey: &Survey, guess: &Guess, unknowns: &[Unknown]) -> DMatrix<f64> {
    let rows = (3 * survey.stations.len()).max(unknowns.len());
    let mut effects = DMatrix::zeros(rows, unknowns.len());
    for (column, unknown) in unknowns.iter().enumerate() {
        let apart = unknown.apart();
        let at = |by: f64| {
            let mut guess = guess.clone();
            guess.change(*unknown, by);
            guess.expected(survey)
        };
        let (more, less) = (at(apart), at(-apart));
        let values = more.iter().zip(&less).flat_map(|(more, less)| ((more - less) / (2.0 * apart)).to_array());
        values.enumerate().for_each(|(row, value)| effects[(row, column)] = value);
    }
    effects
}

/// Which unknowns are not told, and how uncertain the places of axes are.
fn told(
    values: &DVector<f64>,
    parts: Option<&DMatrix<f64>>,
    least: f64,
    unknowns: &[Unknown],
) -> (Vec<Unknown>, Vec<(RotaryAxis, f64)>) {
    let (mut open, mut spread) = (Vec::new(), Vec::new());
    let Some(parts) = parts else { return (unknowns.to_vec(), spread) };
    for (column, unknown) in unknowns.iter().enumerate() {
        let share = |row: usize| parts[(row, column)];
        if (0..values.len()).any(|row| values[row] <= least && share(row).abs() > TAKES_PART) {
            open.push(*unknown);
        }
        if let Unknown::Place(axis, _) = unknown {
            let kept = (0..values.len()).filter(|row| values[*row] > least);
            let variance: f64 = kept.map(|row| (share(row) / values[row]) * (share(row) / values[row])).sum();
            spread.push((*axis, libm::sqrt(variance)));
        }
    }
    (open, spread)
}
