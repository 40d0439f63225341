//! `TRANS`: the blocks that shift, mirror, turn and scale the coordinate system as the cycles for that do.
//!
//! Invariant: a word that is not executed is a fault, never ignored.
use glam::DVec3;

use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::motion::axis::{linear, rotary};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::TableKind;
use crate::program::syntax::{self, Statement};
use crate::spec::Transformation;

fn unknown(word: &str) -> Fault {
    Fault::unsupported("unsupported-block").arg("word", format!("TRANS {word}"))
}

impl Run<'_, '_> {
    /// `TRANS DATUM`, `TRANS MIRROR`, `TRANS ROTATION`, `TRANS SCALE`.
    pub(super) fn transform_system(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        let what = head.split_ascii_whitespace().nth(1).unwrap_or_default();
        self.drives.not_beside_contour(format!("TRANS {what}"))?;
        let before = self.drives.world.system.reported();
        match what {
            "DATUM" => self.shift_datum(statement)?,
            "MIRROR" => self.mirror_axes(statement)?,
            "ROTATION" => self.rotate_plane(statement)?,
            "SCALE" => self.scale_system(statement)?,
            other => return Err(unknown(other).into()),
        }
        self.drives.transformed(before);
        Ok(())
    }

    /// `TRANS MIRROR AXIS X Y`: these axes and no others.
    fn mirror_axes(&mut self, statement: &Statement) -> Done {
        let (mut signs, mut rotary_signs) = (DVec3::ONE, DVec3::ONE);
        for word in &statement.words {
            let name = self.slice(word.name).to_ascii_uppercase();
            if matches!(&*name, "AXIS" | "RESET") {
                continue;
            }
            let axis = syntax::Axis::by_name(name.as_bytes()).ok_or_else(|| unknown(&format!("MIRROR {name}")))?;
            match rotary(axis) {
                Some(RotaryAxis(axis)) => rotary_signs = axis.with(rotary_signs, -1.0),
                None => signs = linear(axis)?.with(signs, -1.0),
            }
        }
        self.drives.world.system.unexecuted.remove(&Transformation::Mirroring);
        self.drives.world.system.set_mirror(signs, rotary_signs);
        Ok(())
    }

    /// `TRANS ROTATION ROT+30`, `IROT+30`: about the datum in the working plane.
    fn rotate_plane(&mut self, statement: &Statement) -> Done {
        let mut angle = None;
        for word in &statement.words {
            angle = Some(match &*self.slice(word.name).to_ascii_uppercase() {
                "ROT" => self.number_of(&word.value)?,
                "IROT" => self.drives.world.system.rotation() + self.number_of(&word.value)?,
                "RESET" => 0.0,
                other => return Err(unknown(&format!("ROTATION {other}")).into()),
            });
        }
        let angle = angle.ok_or_else(|| Fault::program("value-missing"))?;
        self.drives.world.system.set_rotation(angle);
        Ok(())
    }

    /// `TRANS SCALE SCL0.5`: all axes, about the datum.
    fn scale_system(&mut self, statement: &Statement) -> Done {
        let mut factor = None;
        for word in &statement.words {
            factor = Some(match &*self.slice(word.name).to_ascii_uppercase() {
                "SCL" => self.number_of(&word.value)?,
                "RESET" => 1.0,
                other => return Err(unknown(&format!("SCALE {other}")).into()),
            });
        }
        let factor = factor.ok_or_else(|| Fault::program("value-missing"))?;
        if factor <= 0.0 {
            return Err(Fault::program("scaling-factor-zero").arg("found", factor).into());
        }
        self.drives.world.system.unexecuted.remove(&Transformation::Scaling);
        self.drives.world.system.set_scale(factor);
        Ok(())
    }

    /// `TRANS DATUM`: the datum shift of the datum cycle.
    fn shift_datum(&mut self, statement: &Statement) -> Done {
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
                        let axis: Axis = linear(axis)?;
                        let from = if incremental { axis.of(shift) } else { 0.0 };
                        shift = axis.with(shift, from + value * self.drives.unit());
                    }
                }
            }
        }
        self.drives.world.system.angle_shift = angles;
        self.drives.world.system.set_datum(shift);
        Ok(())
    }
}
