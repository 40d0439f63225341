//! `PLANE` as the manuals' programs use it, and `TRANS DATUM`: the blocks that change the coordinate system without a
//! cycle.
//!
//! Invariant: a tilted plane is the one of the tilting cycle, whichever block defines it; a form or word that the
//! engine does not execute is a fault, never ignored.
use glam::DVec3;

use crate::base::expr::{QKind, QRef};
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::machine::RotaryMachineAxis;
use crate::engine::motion::axis::rotary;
use crate::engine::motion::moves::Speed;
use crate::engine::report::fault::Fault;
use crate::engine::run::{Content, Done, Run};
use crate::engine::table::TableKind;
use crate::program::syntax::{self, NamedWord, Statement, Value, ValueKind};
use crate::spec::Transformation;

/// Where the positions of the rotary axes are told: A, then B, then C.
const POSITIONS: u16 = 120;
/// Parts of a direction below this are rounding: the axis does not move.
const STILL: f64 = 1e-9;

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

/// How far the tool is retracted before the axes turn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Back {
    By(f64),
    ToLimit,
}

/// What the words of a `PLANE` block say.
struct Words {
    angles: [Option<f64>; 3],
    way: Option<Way>,
    distance: f64,
    back: Option<Back>,
    speed: Option<Speed>,
}

impl Run<'_, '_> {
    /// `PLANE SPATIAL` and `PLANE RESET`.
    pub(in crate::engine) fn plane(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        let form = head.split_ascii_whitespace().nth(1).unwrap_or_default();
        if !matches!(form, "SPATIAL" | "RESET") {
            return Err(Fault::unsupported("unsupported-block").arg("word", format!("PLANE {form}")).into());
        }
        self.not_beside_contour("PLANE")?;
        let words = self.words_of_plane(&statement.words)?;
        let angles = match (form, words.angles) {
            ("RESET", _) => DVec3::ZERO,
            (_, [Some(a), Some(b), Some(c)]) => DVec3::new(a, b, c),
            _ => return Err(Fault::program("value-missing").into()),
        };
        if let Some(back) = words.back {
            self.retract_before_turning(back)?;
        }
        let before = self.world.system.told();
        self.world.system.unexecuted.remove(&Transformation::Tilting);
        self.world.carry_system();
        self.world.system.set_tilt(angles);
        self.transformed(before);
        let to = if angles == DVec3::ZERO { DVec3::ZERO } else { self.rotary_positions()? };
        for (index, axis) in (0..).zip(RotaryAxis::ALL) {
            let q = QRef { kind: QKind::Q, number: POSITIONS + index };
            self.set(q, Content::Number(axis.of(to)))?;
        }
        let speed = words.speed.map_or_else(|| self.speed(None), Ok);
        match words.way {
            Some(Way::Stay) => Ok(()),
            Some(Way::Turn) => {
                let turns = self.turns_in_program(to);
                self.turn_to(&turns, speed)
            }
            Some(Way::Move) => self.turn_about_point(to, words.distance, speed),
            None => Err(Fault::program("value-missing").into()),
        }
    }

    fn words_of_plane(&mut self, written: &[NamedWord]) -> Done<Words> {
        let mut words = Words { angles: [None; 3], way: None, distance: 0.0, back: None, speed: None };
        let [a, b, c] = &mut words.angles;
        for word in written {
            let name = self.slice(word.name).to_ascii_uppercase();
            let length = |value: &Value| Ok::<_, Fault>(self.number_of(value)? * self.unit());
            match &*name {
                "SPA" => *a = Some(self.number_of(&word.value)?),
                "SPB" => *b = Some(self.number_of(&word.value)?),
                "SPC" => *c = Some(self.number_of(&word.value)?),
                "TURN" => words.way = Some(Way::Turn),
                "MOVE" => words.way = Some(Way::Move),
                "STAY" => words.way = Some(Way::Stay),
                "DIST" | "ABST" => words.distance = length(&word.value)?,
                "MBMAX" => words.back = Some(Back::ToLimit),
                "MB" if word.value.kind != ValueKind::Missing => words.back = Some(Back::By(length(&word.value)?)),
                "FMAX" => words.speed = Some(Speed::Rapid),
                "F" if word.value.kind != ValueKind::Missing => {
                    words.speed = Some(Speed::of_feed(length(&word.value)?)?);
                }
                other => {
                    return Err(Fault::unsupported("unsupported-block").arg("word", format!("PLANE {other}")).into());
                }
            }
        }
        Ok(words)
    }

    /// Back along the tool, as far as the axes go if it shall be the greatest way.
    fn retract_before_turning(&mut self, back: Back) -> Done {
        let machine = &self.world.scene.machine;
        let along = machine.head(self.world.angles).vector(machine.spindle.unit()).normalize();
        let here = self.world.machine;
        let way = match back {
            Back::By(way) => way,
            Back::ToLimit => machine
                .axes
                .iter()
                .filter(|axis| axis.axis.of(along).abs() > STILL)
                .map(|axis| {
                    let part = axis.axis.of(along);
                    (if part > 0.0 { axis.max } else { axis.min } - axis.axis.of(here)) / part
                })
                .fold(f64::INFINITY, f64::min),
        };
        let to = here + along * way.max(0.0);
        self.straight_to(self.world.to_program(to), Some(to), Ok(Speed::Rapid))
    }

    /// Positions of all rotary axes of the machine, in program coordinates, as targets.
    fn turns_in_program(&self, to: DVec3) -> Vec<(RotaryAxis, f64)> {
        let wanted = to * self.world.system.mirror().1 + self.world.system.angle_datum();
        let of_machine = |axis: &RotaryMachineAxis| (axis.axis, axis.axis.of(wanted));
        self.world.scene.machine.rotary.iter().map(of_machine).collect()
    }

    /// Turns the axes; the point that far before the tip keeps its place on the workpiece, and the tool returns to it.
    pub(in crate::engine) fn turn_about_point(
        &mut self,
        to: DVec3,
        distance: f64,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let turns = self.turns_in_program(to);
        let machine = &self.world.scene.machine;
        let direction = machine.head(self.world.angles).vector(machine.spindle.unit());
        let system = &self.world.system;
        let held = self.world.here - system.back().vector(direction).normalize() * distance;
        let to = held + system.plane.tool.unit() * distance;
        self.turn_to(&turns, speed.clone())?;
        self.straight_to(to, None, speed)
    }

    /// `TRANS DATUM`: the datum shift of the datum cycle.
    pub(in crate::engine) fn shift_datum(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        if !head.ends_with("DATUM") {
            return Err(Fault::unsupported("unsupported-block").arg("word", head).into());
        }
        self.not_beside_contour("TRANS DATUM")?;
        let system = &self.world.system;
        let (mut shift, mut angles) = (system.datum(), system.angle_shift);
        for word in &statement.words {
            let name = self.slice(word.name).to_ascii_uppercase();
            match &*name {
                "AXIS" | "TABLE" => {}
                "RESET" => (shift, angles) = (DVec3::ZERO, DVec3::ZERO),
                "TABLINE" => {
                    let (row, table) = (self.number_of(&word.value)?, self.world.table(TableKind::Datum)?);
                    let number = |column| table.number(row, column).map(Option::unwrap_or_default);
                    shift = DVec3::new(number("X")?, number("Y")?, number("Z")?);
                    angles = DVec3::new(number("A")?, number("B")?, number("C")?);
                }
                _ => {
                    let (letter, incremental) = name.strip_prefix('I').map_or((&*name, false), |rest| (rest, true));
                    let unknown = || Fault::unsupported("unsupported-block").arg("word", format!("TRANS {name}"));
                    let axis = syntax::Axis::by_name(letter.as_bytes()).ok_or_else(unknown)?;
                    let value = self.number_of(&word.value)?;
                    if let Some(RotaryAxis(axis)) = rotary(axis) {
                        angles = axis.with(angles, value + if incremental { axis.of(angles) } else { 0.0 });
                    } else {
                        let axis: Axis = crate::engine::motion::axis::linear(axis)?;
                        let from = if incremental { axis.of(shift) } else { 0.0 };
                        shift = axis.with(shift, from + value * self.unit());
                    }
                }
            }
        }
        let before = self.world.system.told();
        self.world.system.angle_shift = angles;
        self.world.system.set_datum(shift);
        self.transformed(before);
        Ok(())
    }
}
