//! The touch probe of a scene: its row in the probe table, and what is true of it.
//!
//! Invariant: what the control believes is in tables; here is only what is so.
use glam::DVec2;

use super::rows;
use crate::base::expr::cosd;
use crate::engine::read::Reader;
use crate::engine::table::{Cell, Table};
use crate::spec::{Kind, Node};

/// The keys of a probe that are no columns of the table.
const OWN: &[&str] =
    &["ball_radius", "offset", "length", "shaft", "orientation", "pre_travel", "scatter", "measurements", "confidence"];
/// A control measures a point at most so often.
const MOST_MEASUREMENTS: f64 = 3.0;

/// How the spindle can turn the probe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Orientation {
    /// Not at all, or to one angle only.
    Fixed,
    /// To two angles, half a turn apart (a probe with a cable).
    Two,
    /// To any angle.
    #[default]
    Any,
}

/// The shaft that carries the ball: a cylinder from the centre of the ball upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Its radius in mm, below that of the ball.
    pub radius: f64,
    /// How far it reaches from the centre of the ball, mm.
    pub length: f64,
}

/// How far the surface pushes the ball in, along its normal, before the probe triggers, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreTravel {
    /// Across the probe axis, on average.
    pub radial: f64,
    /// Along the probe axis.
    pub axial: f64,
    /// By how much it is more in the directions where the stylus yields most.
    pub amplitude: f64,
    /// How many such directions there are.
    pub lobes: f64,
    /// One of them, in degrees from the main axis while the probe is at its calibration angle.
    pub phase: f64,
}

impl PreTravel {
    /// In a direction into the material: its angle about the probe axis as the stylus sees it, and its share along the
    /// probe axis. Never below 0.
    pub fn towards(&self, angle: f64, along: f64) -> f64 {
        let radial = self.radial + self.amplitude * cosd(self.lobes * (angle - self.phase));
        (radial + (self.axial - radial) * along * along).max(0.0)
    }
}

/// The touch probe as it really is; what the control believes is in the probe table and the tool table.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// The number of its row in the probe table.
    pub row: f64,
    /// The true radius of the ball in mm.
    pub ball_radius: f64,
    /// The true offset of the ball centre from the spindle axis in mm, in main and secondary axis, while the probe
    /// is at its calibration angle.
    pub offset: DVec2,
    /// The true length in mm, if it is not the one that the tool table has at the start.
    pub length: Option<f64>,
    /// The shaft of the stylus, if anything is to be found out about it.
    pub shaft: Option<Shaft>,
    /// How the spindle can turn it.
    pub orientation: Orientation,
    /// What lies between touching and triggering.
    pub pre_travel: PreTravel,
    /// By how much each trigger comes later than it should, mm, in turn.
    pub scatter: Vec<f64>,
    /// How often the control measures a point, if no machine parameter says it.
    pub measurements: Option<u32>,
    /// How far these measurements may lie apart, mm, if it is limited.
    pub confidence: Option<f64>,
}

/// A row of the probe table and what is true of the probe.
pub(super) fn probe(node: &Node, table: &mut Table, r: &mut Reader<'_>) -> Option<Probe> {
    let entries = r.entries(node);
    let columns = entries.iter().filter(|(key, _)| !OWN.contains(&&*key.text));
    let row = rows::row(node, columns, Some(1.0), table, r);
    let ball_radius = r.need(node, "ball_radius").and_then(|node| r.positive(node));
    let length = node.get("length").map(|node| r.positive(node));
    let shaft = node.get("shaft").map(|node| shaft(node, ball_radius, r));
    let orientation = node.get("orientation").map_or(Some(Orientation::default()), |node| orientation(node, r));
    let pre_travel = node.get("pre_travel").map_or(Some(PreTravel::default()), |node| pre_travel(node, r));
    let list = node.get("scatter").map_or(&[][..], |node| r.items(node));
    let scatter: Option<Vec<f64>> = list.iter().map(|item| r.length(item)).collect();
    let measurements = node.get("measurements").map(|node| measurements(node, r));
    let confidence = node.get("confidence").map(|node| r.positive(node));
    let row = row?;
    for (column, value) in [("F", 300.0), ("FMAX", 3000.0), ("DIST", 10.0), ("SET_UP", 2.0)] {
        if node.get(column).is_none() {
            // The standard columns have room for these.
            let _ = table.set(row, column, &Cell::Number(value));
        }
    }
    let believed = |column| table.number(row, column).ok().flatten().unwrap_or_default();
    let offset = match node.get("offset") {
        None => DVec2::new(believed("CAL_OF1"), believed("CAL_OF2")),
        Some(node) => match r.items(node) {
            [main, secondary] => DVec2::new(r.length(main)?, r.length(secondary)?),
            _ => {
                r.expected(node, "two-numbers");
                return None;
            }
        },
    };
    Some(Probe {
        row,
        ball_radius: ball_radius?,
        offset,
        length: given(length)?,
        shaft: given(shaft)?,
        orientation: orientation?,
        pre_travel: pre_travel?,
        scatter: scatter?,
        measurements: given(measurements)?,
        confidence: given(confidence)?,
    })
}

/// A value that may be missing but must not be wrong.
fn given<T>(value: Option<Option<T>>) -> Option<Option<T>> {
    match value {
        None => Some(None),
        Some(value) => value.map(Some),
    }
}

fn shaft(node: &Node, ball_radius: Option<f64>, r: &mut Reader<'_>) -> Option<Shaft> {
    r.only_keys(node, &["diameter", "length"]);
    let diameter = r.need(node, "diameter")?;
    let (radius, length) = (r.positive(diameter)? / 2.0, r.need(node, "length").and_then(|node| r.positive(node))?);
    if ball_radius.is_some_and(|ball| radius >= ball) {
        r.expected(diameter, "shaft");
        return None;
    }
    Some(Shaft { radius, length })
}

fn orientation(node: &Node, r: &mut Reader<'_>) -> Option<Orientation> {
    match node.text() {
        Some("fixed") => Some(Orientation::Fixed),
        Some("two") => Some(Orientation::Two),
        Some("any") => Some(Orientation::Any),
        _ => {
            r.expected(node, "orientation");
            None
        }
    }
}

/// One length for all directions, or how it depends on them.
fn pre_travel(node: &Node, r: &mut Reader<'_>) -> Option<PreTravel> {
    let Kind::Map(_) = node.kind else {
        let length = r.length(node)?;
        return Some(PreTravel { radial: length, axial: length, ..PreTravel::default() });
    };
    r.only_keys(node, &["radial", "axial", "amplitude", "lobes", "phase"]);
    let radial = node.get("radial").map_or(Some(0.0), |node| r.length(node))?;
    Some(PreTravel {
        radial,
        axial: node.get("axial").map_or(Some(radial), |node| r.length(node))?,
        amplitude: node.get("amplitude").map_or(Some(0.0), |node| r.length(node))?,
        lobes: node.get("lobes").map_or(Some(3.0), |node| r.number(node))?,
        phase: node.get("phase").map_or(Some(0.0), |node| r.number(node))?,
    })
}

fn measurements(node: &Node, r: &mut Reader<'_>) -> Option<u32> {
    let number = r.number(node)?;
    if (1.0..=MOST_MEASUREMENTS).contains(&number) && number.fract() == 0.0 {
        return Some(number as u32);
    }
    r.expected(node, "measurements");
    None
}
