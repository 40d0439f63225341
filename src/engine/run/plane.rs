//! `PLANE` as the manuals' programs use it, and `TRANS DATUM`: the blocks that change the coordinate system without a
//! cycle.
//!
//! Invariant: a tilted plane is the one of the tilting cycle, whichever block defines it; a form or word that the
//! engine does not execute is a fault, never ignored.
use glam::DVec3;

use crate::base::expr::{QKind, QRef};
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::motion::axis::rotary;
use crate::engine::motion::moves::Speed;
use crate::engine::motion::tilt::Back;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::TableKind;
use crate::program::syntax::{self, NamedWord, Statement, Value, ValueKind};
use crate::spec::Transformation;

/// Where the positions of the rotary axes are reported: A, then B, then C.
const POSITIONS: u16 = 120;
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
    pub(super) fn plane(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        let form = head.split_ascii_whitespace().nth(1).unwrap_or_default();
        if !matches!(form, "SPATIAL" | "RESET") {
            return Err(Fault::unsupported("unsupported-block").arg("word", format!("PLANE {form}")).into());
        }
        self.drives.not_beside_contour("PLANE")?;
        let words = self.words_of_plane(&statement.words)?;
        let angles = match (form, words.angles) {
            ("RESET", _) => DVec3::ZERO,
            (_, [Some(a), Some(b), Some(c)]) => DVec3::new(a, b, c),
            _ => return Err(Fault::program("value-missing").into()),
        };
        if let Some(back) = words.back {
            self.drives.retract_before_turning(back)?;
        }
        let before = self.drives.world.system.reported();
        self.drives.world.system.unexecuted.remove(&Transformation::Tilting);
        self.drives.world.carry_system();
        self.drives.world.system.set_tilt(angles);
        self.drives.transformed(before);
        let to = if angles == DVec3::ZERO { DVec3::ZERO } else { self.drives.rotary_positions()? };
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

    fn words_of_plane(&mut self, written: &[NamedWord]) -> Done<Words> {
        let mut words = Words { angles: [None; 3], way: None, distance: 0.0, back: None, speed: None };
        let [a, b, c] = &mut words.angles;
        for word in written {
            let name = self.slice(word.name).to_ascii_uppercase();
            let length = |value: &Value| Ok::<_, Fault>(self.number_of(value)? * self.drives.unit());
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

    /// `TRANS DATUM`: the datum shift of the datum cycle.
    pub(super) fn shift_datum(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        if !head.ends_with("DATUM") {
            return Err(Fault::unsupported("unsupported-block").arg("word", head).into());
        }
        self.drives.not_beside_contour("TRANS DATUM")?;
        let system = &self.drives.world.system;
        let (mut shift, mut angles) = (system.datum(), system.angle_shift);
        for word in &statement.words {
            let name = self.slice(word.name).to_ascii_uppercase();
            match &*name {
                "AXIS" | "TABLE" => {}
                "RESET" => (shift, angles) = (DVec3::ZERO, DVec3::ZERO),
                "TABLINE" => {
                    let (row, table) = (self.number_of(&word.value)?, self.drives.world.table(TableKind::Datum)?);
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
                        shift = axis.with(shift, from + value * self.drives.unit());
                    }
                }
            }
        }
        let before = self.drives.world.system.reported();
        self.drives.world.system.angle_shift = angles;
        self.drives.world.system.set_datum(shift);
        self.drives.transformed(before);
        Ok(())
    }
}
