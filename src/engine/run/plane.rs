//! `PLANE` as the manuals' programs use it.
//!
//! Invariant: a tilted plane is the one of the tilting cycle, whichever block defines it; a form or word that the
//! engine does not execute is a fault, never ignored.
use std::collections::BTreeMap;

use glam::DVec3;

use crate::base::expr::{QKind, QRef};
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, Frame, RotaryAxis};
use crate::engine::motion::moves::Speed;
use crate::engine::motion::tilt::Back;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{NamedWord, Statement, Value, ValueKind};
use crate::spec::Transformation;

/// Where the positions of the rotary axes are reported: A, then B, then C.
const POSITIONS: u16 = 120;
/// Vectors that are shorter have no direction.
const SAME: f64 = 1e-9;
/// The greatest projected angle, degrees: at 90 the plane has no trace.
const STEEPEST: f64 = 89.9999;
/// The words of angles and vectors.
const VALUES: [&str; 22] = [
    "SPA", "SPB", "SPC", "PROPR", "PROMIN", "PROROT", "ROT", "EULPR", "EULNU", "EULROT", "BX", "BY", "BZ", "NX", "NY",
    "NZ", "A", "B", "C", "IA", "IB", "IC",
];

/// How the rotary axes get to the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// They turn, the tool follows the workpiece.
    Move,
    /// They turn, nothing else moves.
    Turn,
    /// The program turns them.
    Stay,
}

/// Which of two positions of the rotary axes is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Solution {
    /// `SEQ+`: the one with a positive angle of the master axis.
    Positive,
    /// `SEQ-`: the one with a negative angle.
    Negative,
}

/// What the words of a `PLANE` block say.
#[derive(Default)]
struct Words {
    /// Angles and coordinates by their names; lengths in mm.
    values: BTreeMap<String, f64>,
    way: Option<Way>,
    distance: f64,
    back: Option<Back>,
    speed: Option<Speed>,
    solution: Option<Solution>,
    /// Whether the table takes over the rotation about the tool, where it can.
    turns_table: bool,
}

impl Words {
    fn get(&self, name: &str) -> Option<f64> {
        self.values.get(name).copied()
    }

    /// Values that must be there.
    fn all<const N: usize>(&self, names: [&str; N]) -> Result<[f64; N], Fault> {
        let mut values = [0.0; N];
        for (value, name) in values.iter_mut().zip(names) {
            *value = self.get(name).ok_or_else(|| Fault::program("value-missing"))?;
        }
        Ok(values)
    }

    /// A vector or point that must be there.
    fn vector(&self, names: [&str; 3]) -> Result<DVec3, Fault> {
        self.all(names).map(DVec3::from)
    }
}

/// A vector of length 1 in that direction.
fn unit(vector: DVec3) -> Result<DVec3, Fault> {
    let length = vector.length();
    if length < SAME { Err(Fault::control("direction-undefined").arg("distance", length)) } else { Ok(vector / length) }
}

impl Run<'_, '_> {
    /// `PLANE` in all forms.
    pub(super) fn plane(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        let form = head.split_ascii_whitespace().nth(1).unwrap_or_default();
        self.drives.not_compensated("PLANE")?;
        let words = self.words_of_plane(&statement.words)?;
        let angles = self.tilt_of(form, &words)?;
        let positions = if form == "AXIAL" { Some(self.positions_of_axes(&words)) } else { None };
        if let Some(back) = words.back {
            self.drives.retract_before_turning(back)?;
        }
        let before = self.drives.world.system.reported();
        self.drives.world.system.unexecuted.remove(&Transformation::Tilting);
        self.drives.world.carry_system();
        self.drives.world.system.set_tilt(angles);
        self.drives.counted_alone()?;
        self.drives.transformed(before);
        let to = match (positions, words.solution) {
            (Some(positions), _) => positions,
            _ if form == "RESET" || (angles == DVec3::ZERO && !words.turns_table) => DVec3::ZERO,
            (None, solution) => {
                let positive = solution.map(|solution| solution == Solution::Positive);
                let to = self.drives.rotary_positions_with(positive)?;
                if words.turns_table { self.drives.with_table_turned(to)? } else { to }
            }
        };
        for (index, axis) in (0..).zip(RotaryAxis::ALL) {
            let q = QRef { kind: QKind::Q, number: POSITIONS + index };
            self.set(q, Content::Number(axis.of(to)))?;
        }
        let speed = words.speed.map_or_else(|| self.speed(None), Ok);
        match words.way {
            Some(Way::Stay) => Ok(()),
            Some(Way::Turn) => {
                let turns = self.drives.turns_in_program(to);
                self.drives.turn_to(&turns, speed)
            }
            Some(Way::Move) => self.drives.turn_about_point(to, words.distance, speed),
            None => Err(Fault::program("value-missing").into()),
        }
    }

    /// The spatial angles of the plane that a form of `PLANE` defines.
    fn tilt_of(&self, form: &str, words: &Words) -> Result<DVec3, Fault> {
        let plane = self.drives.world.system.plane;
        Ok(match form {
            "RESET" => DVec3::ZERO,
            "SPATIAL" => words.vector(["SPA", "SPB", "SPC"])?,
            "PROJECTED" => self.projected(words)?,
            "EULER" => {
                let [precession, nutation, rotation] = words.all(["EULPR", "EULNU", "EULROT"])?;
                let about_main = Frame::rotate(plane.main, nutation).of(Frame::rotate(plane.tool, rotation));
                Frame::rotate(plane.tool, precession).of(about_main).spatial_angles()
            }
            "VECTOR" => {
                let (base, normal) = (words.vector(["BX", "BY", "BZ"])?, unit(words.vector(["NX", "NY", "NZ"])?)?);
                Frame::with_axes(plane, unit(base.reject_from(normal))?, normal).spatial_angles()
            }
            "POINTS" => {
                let point = |n: u32| words.vector([&*format!("P{n}X"), &*format!("P{n}Y"), &*format!("P{n}Z")]);
                let (first, second, third) = (point(1)?, point(2)?, point(3)?);
                let main = unit(second - first)?;
                Frame::with_axes(plane, main, unit(main.cross(third - first))?).spatial_angles()
            }
            "RELATIV" | "RELATIVE" => {
                let now = Frame::placed(DVec3::ZERO, self.drives.world.system.tilt().unwrap_or_default());
                let turned = [("SPA", Axis::X), ("SPB", Axis::Y), ("SPC", Axis::Z)];
                let turned = turned.into_iter().filter_map(|(name, axis)| Some((axis, words.get(name)?)));
                let [(axis, angle)] = turned.collect::<Vec<_>>()[..] else {
                    return Err(Fault::program("value-missing"));
                };
                now.of(Frame::rotate(axis, angle)).spatial_angles()
            }
            "AXIAL" => self.drives.tilt_by_axes(self.positions_of_axes(words)).spatial_angles(),
            _ => return Err(Fault::unsupported("unsupported-block").arg("word", format!("PLANE {form}"))),
        })
    }

    /// The plane whose traces in the plane of main and tool axis and in that of secondary and tool axis are turned by these
    /// angles, right-handed about the secondary and the main axis. Its main axis is the first trace, turned in the plane.
    fn projected(&self, words: &Words) -> Result<DVec3, Fault> {
        let plane = self.drives.world.system.plane;
        let [first, second] = words.all(["PROPR", "PROMIN"])?;
        let turned = words.get("ROT").or_else(|| words.get("PROROT")).ok_or_else(|| Fault::program("value-missing"))?;
        if let Some(steep) = [first, second].into_iter().find(|angle| angle.abs() > STEEPEST) {
            return Err(Fault::program("parameter-out-of-range").arg("value", steep));
        }
        let in_first = Frame::rotate(plane.secondary, first).vector(plane.main.unit());
        let in_second = Frame::rotate(plane.main, second).vector(plane.secondary.unit());
        let traced = Frame::with_axes(plane, in_first, unit(in_first.cross(in_second))?);
        Ok(traced.of(Frame::rotate(plane.tool, turned)).spatial_angles())
    }

    /// Where `PLANE AXIAL` puts the rotary axes, in program coordinates; those that are not named stay.
    fn positions_of_axes(&self, words: &Words) -> DVec3 {
        let system = &self.drives.world.system;
        let now = (self.drives.world.angles - system.angle_datum()) * system.mirror().1;
        RotaryAxis::ALL.into_iter().fold(now, |to, axis| {
            let letter = axis.letter();
            let by = words.get(&format!("I{letter}")).map(|by| axis.of(now) + by);
            words.get(&letter.to_string()).or(by).map_or(to, |angle| axis.with(to, angle))
        })
    }

    fn words_of_plane(&mut self, written: &[NamedWord]) -> Done<Words> {
        let mut words = Words::default();
        for word in written {
            let name = self.slice(word.name).to_ascii_uppercase();
            let length = |value: &Value| Ok::<_, Fault>(self.number_of(value)? * self.drives.unit());
            let has_value = word.value.kind != ValueKind::Missing;
            match &*name {
                "TURN" => words.way = Some(Way::Turn),
                "MOVE" => words.way = Some(Way::Move),
                "STAY" => words.way = Some(Way::Stay),
                "SEQ" | "SEQ+" | "SEQ-" => {
                    words.solution = match self.slice(word.span).trim_end().chars().next_back() {
                        Some('+') => Some(Solution::Positive),
                        Some('-') => Some(Solution::Negative),
                        _ => return Err(Fault::program("value-missing").into()),
                    }
                }
                // What the plane has beyond the positions of the axes is a rotation of its coordinates.
                "COORD ROT" => words.turns_table = false,
                "TABLE ROT" => words.turns_table = true,
                "DIST" | "ABST" => words.distance = length(&word.value)?,
                // `MB MAX` written apart is two words.
                "MB" if !has_value => {}
                "MBMAX" | "MAX" => words.back = Some(Back::ToLimit),
                "MB" if has_value => words.back = Some(Back::By(length(&word.value)?)),
                "FMAX" => words.speed = Some(Speed::Rapid),
                "F" if has_value => words.speed = Some(Speed::of_feed(length(&word.value)?)?),
                point if point.starts_with('P') && point.len() == 3 && has_value => {
                    let value = length(&word.value)?;
                    words.values.insert(name, value);
                }
                known if VALUES.contains(&known) && has_value => {
                    let value = self.number_of(&word.value)?;
                    words.values.insert(name, value);
                }
                other => {
                    return Err(Fault::unsupported("unsupported-block").arg("word", format!("PLANE {other}")).into());
                }
            }
        }
        Ok(words)
    }
}
