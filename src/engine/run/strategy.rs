//! The strategies that the engine has: storing datums, reading a tolerance band.
//!
//! Invariant: each does one thing with the values that it is given; none knows which cycle asked for it.
use glam::DVec3;

use super::cycle::Exec;
use super::fault::{Class, Fault};
use super::{Done, Run};
use crate::engine::geometry::{Axis, Frame};
use crate::engine::plan::{Strategy, StrategyCall};
use crate::engine::table::{Cell, TableKind};
use crate::expr::Value;

/// A point of the program and the coordinates that it shall have on some axes.
struct Wanted {
    /// The point in program coordinates, by axis.
    point: DVec3,
    /// Axis and coordinate.
    values: Vec<(Axis, f64)>,
}

impl Wanted {
    /// The coordinates as a vector; axes not named are 0.
    fn vector(&self) -> DVec3 {
        self.values.iter().fold(DVec3::ZERO, |vector, (axis, value)| axis.with(vector, *value))
    }
}

impl<'e> Run<'_, 'e> {
    pub(super) fn strategy(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        match call.strategy {
            Strategy::SetDatum => {
                let wanted = self.wanted(call, exec)?;
                self.set_datum(&wanted);
                Ok(())
            }
            Strategy::WritePreset => {
                let (wanted, row) = (self.wanted(call, exec)?, self.row(call, exec)?);
                self.write_preset(&wanted, row)
            }
            Strategy::WriteDatumRow => {
                let (wanted, row) = (self.wanted(call, exec)?, self.row(call, exec)?);
                self.write_datum_row(&wanted, row)
            }
            Strategy::PlungeOnHelix => self.plunge_on_helix(call, exec),
            Strategy::PlungeInStrokes => self.plunge_in_strokes(call, exec),
            Strategy::ToleranceBand => {
                let Some(Some(text)) = call.with.first() else { return Ok(()) };
                let Value::Text(text) = self.value(text, exec)? else { return Ok(()) };
                let band = tolerance_band(&text);
                let monitored = f64::from(u8::from(band.is_some()));
                let (upper, lower) = band.unwrap_or_default();
                for (slot, value) in call.results.iter().zip([upper, lower, monitored]) {
                    exec.put(*slot, Value::Number(value));
                }
                Ok(())
            }
        }
    }

    fn wanted(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Wanted, Fault> {
        let internal = || Fault::new(Class::Internal, "strategy-argument");
        let [Some(point), main, minor, tool, ..] = call.with.as_slice() else { return Err(internal()) };
        let plane = self.world.system.plane;
        let mut values = Vec::with_capacity(3);
        for (axis, calc) in [(plane.main, main), (plane.secondary, minor), (plane.tool, tool)] {
            if let Some(calc) = calc {
                values.push((axis, self.number(calc, exec)?));
            }
        }
        Ok(Wanted { point: self.world.system.axes(self.point(point, exec)?), values })
    }

    fn row(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<f64, Fault> {
        let Some(Some(row)) = call.with.get(4) else { return Err(Fault::new(Class::Internal, "strategy-argument")) };
        self.number(row, exec)
    }

    fn set_datum(&mut self, wanted: &Wanted) {
        let before = self.world.system.told();
        let change = wanted
            .values
            .iter()
            .fold(DVec3::ZERO, |change, (axis, value)| axis.with(change, value - axis.of(wanted.point)));
        let origin = self.world.system.origin - self.world.system.frame().vector(change);
        let (preset, basic) = (self.world.system.preset, self.world.system.basic);
        self.world.system.set_preset(preset, origin, basic);
        self.transformed(before);
    }

    /// The row keeps its spatial angles; a new row has none.
    fn write_preset(&mut self, wanted: &Wanted, row: f64) -> Done {
        let machine = self.world.system.frame().point(wanted.point);
        let has_row = self.world.table(TableKind::Preset)?.has_row(row);
        let basic = if has_row { self.world.preset(row)?.1 } else { DVec3::ZERO };
        let origin = machine - Frame::placed(DVec3::ZERO, basic).vector(wanted.vector());
        for (axis, _) in &wanted.values {
            let cell = Cell::Number(axis.of(origin));
            self.write_cell(TableKind::Preset, row, &axis.letter().to_string(), &cell)?;
        }
        Ok(())
    }

    fn write_datum_row(&mut self, wanted: &Wanted, row: f64) -> Done {
        let machine = self.world.system.frame().point(wanted.point);
        let datum = self.world.system.preset_frame().inverse().point(machine) - wanted.vector();
        for (axis, _) in &wanted.values {
            let cell = Cell::Number(axis.of(datum));
            self.write_cell(TableKind::Datum, row, &axis.letter().to_string(), &cell)?;
        }
        Ok(())
    }
}

/// Upper and lower limit of a tolerance text: an unsigned upper value, a minus with a lower value, or both.
/// Anything else monitors nothing.
fn tolerance_band(text: &str) -> Option<(f64, f64)> {
    let text = text.trim().replace(',', ".");
    let (upper, lower) = match text.split_once('-') {
        Some((upper, lower)) => (upper, Some(lower)),
        None => (text.as_str(), None),
    };
    let number = |part: &str| {
        let plain = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        part.parse::<f64>().ok().filter(|_| plain)
    };
    let upper = if upper.is_empty() && lower.is_some() { Some(0.0) } else { number(upper) }?;
    let lower = lower.map_or(Some(0.0), number)?;
    (upper > 0.0 || lower > 0.0).then_some((upper, -lower))
}

#[cfg(test)]
mod tests {
    use super::tolerance_band;

    /// The rows of the manual (004, lines 151-162) and what the example of the NC block says.
    #[test]
    fn tolerance_texts_read_as_the_manual_says() {
        assert_eq!(tolerance_band("0.4-0.1"), Some((0.4, -0.1)));
        assert_eq!(tolerance_band("0.4"), Some((0.4, -0.0)));
        assert_eq!(tolerance_band("-0.1"), Some((0.0, -0.1)));
        assert_eq!(tolerance_band("1-1"), Some((1.0, -1.0)));
        for none in [" ", "", "0", "0.1+0.1", "x", "-", "--1", "1e3", "0.1-"] {
            assert_eq!(tolerance_band(none), None, "{none:?}");
        }
    }
}
