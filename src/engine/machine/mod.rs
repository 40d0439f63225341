//! Machines: which axes there are, how far and how fast they go, what turns about what.
//!
//! Invariant: a machine and the tools for it are data; nothing here knows a position or a workpiece.
mod around;
mod course;
mod errors;
mod fit;
mod insert;
mod rotary;
mod saved;
mod survey;
mod tool;

pub use around::Across;
pub use course::{Course, Straight};
pub use errors::TrueMachine;
pub use fit::Fit;
pub use insert::{InsertCorrection, TurningInsert};
pub use rotary::{Carried, RotaryMachineAxis};
pub use saved::{MemoryReport, SavedKinematics, matches as matches_pattern};
pub use survey::{Arm, AxisPlan, AxisReport, LEAST_CIRCLE, Station, Survey, expected, on_grid, sphere};
pub use tool::{Insert, InsertForm, Neck, Tool};

use super::geometry::Axis;
use super::read::Reader;
use crate::base::diag::{Diagnostic, Source};
use crate::spec::{Node, read_yaml};
use glam::DVec3;
use std::sync::Arc;

/// How far rounding may take a position beyond a limit, mm: what turned coordinates lose, and no more.
const ROUNDING: f64 = 1e-9;

/// The acceleration of an axis that has none of its own, mm/s²: a middling machine.
const DEFAULT_ACCELERATION: f64 = 2000.0;

/// The version of machine files that is understood.
const VERSION: &str = "1";
/// Where machines with a name are kept.
const FOLDER: &str = "cycle-specs/machines/";

/// A linear axis of a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MachineAxis {
    /// Its letter.
    pub axis: Axis,
    /// The lowest machine coordinate in mm.
    pub min: f64,
    /// The highest machine coordinate in mm.
    pub max: f64,
    /// Rapid traverse in mm/min.
    pub rapid: f64,
    /// Acceleration in mm/s².
    pub acceleration: f64,
}

/// The letters of parallel axes: U beside X, V beside Y, W beside Z.
const PARALLEL: [char; 3] = ['U', 'V', 'W'];

/// A parallel axis of a machine: a further linear axis that moves beside X, Y or Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelAxis {
    /// `U`, `V` or `W`.
    pub letter: char,
    /// The lowest machine coordinate in mm.
    pub min: f64,
    /// The highest machine coordinate in mm.
    pub max: f64,
    /// Rapid traverse in mm/min.
    pub rapid: f64,
}

/// A machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// Its name.
    pub name: String,
    /// The axis along which the spindle and the touch probe point.
    pub spindle: Axis,
    /// Its linear axes.
    pub axes: Vec<MachineAxis>,
    /// Its parallel axes.
    pub parallel: Vec<ParallelAxis>,
    /// Its rotary axes; of those that carry the workpiece, and of those that carry the tool, each carries the next.
    pub rotary: Vec<RotaryMachineAxis>,
    /// The distance of the point about which a swivel head turns from the spindle nose, mm.
    pub pivot: f64,
    /// Where coordinates with M92 count from, in machine coordinates, mm; nothing where the machine has no such place.
    pub second_datum: Option<DVec3>,
    /// By how much presets are displaced in the machine, mm: what the compensation of a preset has found.
    pub base: DVec3,
}

impl Machine {
    /// The machine of that name among the data files (paths and texts).
    ///
    /// # Errors
    /// The mistakes in its file; an empty list if there is no such machine.
    pub fn named(name: &str, files: &[(String, String)]) -> Result<Self, Vec<Diagnostic>> {
        let path = format!("{FOLDER}{name}.yaml");
        let text =
            files.iter().find(|(known, _)| *known == path).map(|(_, text)| text.as_str()).ok_or_else(Vec::new)?;
        Self::parse(&Source::new(path, text))
    }

    /// The names of the machines among the data files.
    pub fn names(files: &[(String, String)]) -> Vec<&str> {
        files.iter().filter_map(|(path, _)| path.strip_prefix(FOLDER)?.strip_suffix(".yaml")).collect()
    }

    /// Reads a machine file.
    ///
    /// # Errors
    /// All mistakes with their places.
    pub fn parse(source: &Arc<Source>) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader::new(source);
        let node = read_yaml(source, &mut reader.found);
        let machine = node.and_then(|node| Self::read(&node, &mut reader));
        machine.filter(|_| reader.found.is_empty()).ok_or(reader.found)
    }

    /// Reads a machine written out in another file.
    pub(super) fn read(node: &Node, reader: &mut Reader<'_>) -> Option<Self> {
        let keys = ["machine", "name", "spindle", "axes", "parallel", "rotary", "pivot", "base", "second_datum"];
        if !reader.only_keys(node, &keys) {
            return None;
        }
        if let Some(version) = node.get("machine").filter(|version| version.text() != Some(VERSION)) {
            reader.report("scene-version", version, vec![("known", VERSION.into())]);
        }
        let name = node.get("name").and_then(|name| reader.text(name)).unwrap_or_default().to_owned();
        let spindle = node.get("spindle").map_or(Some(Axis::Z), |axis| reader.axis(axis));
        let list = reader.need(node, "axes")?;
        let mut axes: Vec<MachineAxis> = Vec::new();
        for item in reader.items(list) {
            let Some(axis) = read_axis(item, reader) else { continue };
            if axes.iter().any(|known| known.axis == axis.axis) {
                reader.report("scene-repeated", item, vec![("found", axis.axis.letter().to_string().into())]);
            }
            axes.push(axis);
        }
        let mut parallel: Vec<ParallelAxis> = Vec::new();
        for item in node.get("parallel").map_or(&[][..], |list| reader.items(list)) {
            let Some(axis) = read_parallel(item, reader) else { continue };
            if parallel.iter().any(|known| known.letter == axis.letter) {
                reader.report("scene-repeated", item, vec![("found", axis.letter.to_string().into())]);
            }
            parallel.push(axis);
        }
        let rotary = node.get("rotary").map_or_else(Vec::new, |list| rotary::read(list, reader));
        let pivot = node.get("pivot").map_or(Some(0.0), |pivot| reader.length(pivot))?;
        let base = node.get("base").map_or(Some(DVec3::ZERO), |base| reader.vector(base))?;
        let second_datum = match node.get("second_datum") {
            Some(datum) => Some(reader.vector(datum)?),
            None => None,
        };
        Some(Self { name, spindle: spindle?, axes, parallel, rotary, pivot, second_datum, base })
    }

    /// The data of an axis, if the machine has it.
    pub fn axis(&self, axis: Axis) -> Option<&MachineAxis> {
        self.axes.iter().find(|known| known.axis == axis)
    }

    /// The data of a parallel axis, if the machine has it.
    pub fn parallel(&self, letter: char) -> Option<&ParallelAxis> {
        self.parallel.iter().find(|known| known.letter == letter)
    }

    /// The first axis that a position in machine coordinates would take beyond its limits.
    pub fn beyond_limits(&self, position: DVec3) -> Option<&MachineAxis> {
        let within = |axis: &MachineAxis| axis.min - ROUNDING..=axis.max + ROUNDING;
        self.axes.iter().find(|axis| !within(axis).contains(&axis.axis.of(position)))
    }

    /// How far a position in machine coordinates is from the limits of the axes, mm.
    pub fn room(&self, position: DVec3) -> f64 {
        let room = |axis: &MachineAxis| {
            let at = axis.axis.of(position);
            (at - axis.min).min(axis.max - at)
        };
        self.axes.iter().map(room).fold(f64::INFINITY, f64::min)
    }

    /// The feed in mm/min along the path when every axis that moves keeps within its rapid traverse.
    pub fn rapid_feed(&self, way: DVec3) -> f64 {
        let length = way.length();
        // Along one axis the quotient is exactly 1, so its rapid rate comes out unchanged.
        let share = |axis: &MachineAxis| match axis.axis.of(way).abs() {
            0.0 if length > 0.0 => f64::INFINITY,
            0.0 => axis.rapid,
            part => axis.rapid * (length / part),
        };
        self.axes.iter().map(share).fold(f64::INFINITY, f64::min)
    }
}

fn read_axis(node: &Node, reader: &mut Reader<'_>) -> Option<MachineAxis> {
    reader.only_keys(node, &["axis", "min", "max", "rapid", "acceleration"]);
    let axis = reader.need(node, "axis").and_then(|node| reader.axis(node));
    let min = reader.need(node, "min").and_then(|node| reader.length(node));
    let max = reader.need(node, "max").and_then(|node| reader.length(node));
    let rapid = reader.need(node, "rapid").and_then(|node| reader.positive(node));
    let acceleration = node.get("acceleration").map_or(Some(DEFAULT_ACCELERATION), |node| reader.positive(node));
    let (axis, min, max, rapid, acceleration) = (axis?, min?, max?, rapid?, acceleration?);
    if min >= max {
        reader.report("scene-min-max", node, Vec::new());
        return None;
    }
    Some(MachineAxis { axis, min, max, rapid, acceleration })
}

fn read_parallel(node: &Node, reader: &mut Reader<'_>) -> Option<ParallelAxis> {
    reader.only_keys(node, &["axis", "min", "max", "rapid"]);
    let axis = reader.need(node, "axis")?;
    let letter = PARALLEL.into_iter().find(|letter| axis.text().is_some_and(|text| text == letter.to_string()));
    if letter.is_none() {
        reader.expected(axis, "parallel-axis");
    }
    let min = reader.need(node, "min").and_then(|node| reader.length(node));
    let max = reader.need(node, "max").and_then(|node| reader.length(node));
    let rapid = reader.need(node, "rapid").and_then(|node| reader.positive(node));
    let (letter, min, max, rapid) = (letter?, min?, max?, rapid?);
    if min >= max {
        reader.report("scene-min-max", node, Vec::new());
        return None;
    }
    Some(ParallelAxis { letter, min, max, rapid })
}
