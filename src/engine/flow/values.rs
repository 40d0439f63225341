//! Values as a program writes them: operands, coordinates and feeds, and Q parameters that get new ones.
use glam::DVec3;

use super::exec::Exec;
use super::state::Run;
use crate::base::diag::Span;
use crate::base::expr::{EvalError, QRef};
use crate::engine::geometry::Axis as LinearAxis;
use crate::engine::motion::axis::linear;
use crate::engine::motion::moves::Speed;
use crate::engine::params::Content;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Amount, Axis, Coord, Feed, FeedKind, Operand, Value, ValueKind};

impl<'e> Run<'_, 'e> {
    /// The text at a place of the program being executed.
    pub(crate) fn slice(&self, span: crate::base::diag::Span) -> &'e str {
        self.calls.here().map_or("", |prepared| prepared.program.slice(span))
    }

    /// The value of an operand.
    pub(crate) fn operand(&self, operand: &Operand) -> Result<f64, Fault> {
        match operand.amount {
            Amount::Number(number) => Ok(number),
            Amount::Q { negative, q } => {
                let value = self.params.number(q)?;
                Ok(if negative { -value } else { value })
            }
            Amount::Text(_) => Err(Fault::unsupported("unsupported-block").arg("word", self.slice(operand.span))),
        }
    }

    /// The number of a value that is not a word.
    pub(crate) fn number_of(&self, value: &Value) -> Result<f64, Fault> {
        match value.kind {
            ValueKind::Number(number) => Ok(number),
            ValueKind::Q { negative, q } => {
                let number = self.params.number(q)?;
                Ok(if negative { -number } else { number })
            }
            _ => Err(Fault::program("text-or-number")),
        }
    }

    /// A number or Q parameter as it is written.
    pub(crate) fn written_number(&self, text: &str) -> Result<f64, Fault> {
        let text = text.trim();
        let (sign, bare) = match text.strip_prefix('-') {
            Some(rest) => (-1.0, rest.trim()),
            None => (1.0, text.strip_prefix('+').unwrap_or(text).trim()),
        };
        if let Some(q) = QRef::parse(bare) {
            return Ok(sign * self.params.number(q)?);
        }
        let number = bare.replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite());
        number.map(|number| sign * number).ok_or_else(|| Fault::program("value-missing"))
    }

    pub(crate) fn coordinate(&self, coord: &Coord, now: f64) -> Result<f64, Fault> {
        if let (Axis::X, Some(length)) = (coord.axis, self.drives.world.system.unrolled) {
            let value = self.operand(&coord.value)? * length;
            return Ok(if coord.incremental { now + value } else { value });
        }
        let linear = coord.axis == Axis::Pr || linear(coord.axis).is_ok();
        let unit = if linear { self.drives.unit() } else { 1.0 };
        // A diameter in turning.
        let halved = if coord.axis == Axis::X { self.drives.world.system.doubled(LinearAxis::X) } else { 1.0 };
        let value = self.operand(&coord.value)? * unit / halved;
        Ok(if coord.incremental { now + value } else { value })
    }

    /// The position with the coordinates of the block, others as they are.
    pub(crate) fn target(&self, coords: &[Coord], from: DVec3) -> Result<DVec3, Fault> {
        let mut to = from;
        for coord in coords {
            if matches!(coord.axis, Axis::Pr | Axis::Pa) {
                continue;
            }
            let axis = linear(coord.axis)?;
            to = axis.with(to, self.coordinate(coord, axis.of(from))?);
        }
        Ok(to)
    }

    /// The speed of a block; a feed word stays in force. What is missing shows only if the tool moves.
    pub(crate) fn speed(&mut self, feed: Option<&Feed>) -> Result<Speed, Fault> {
        match feed.map(|feed| feed.kind) {
            Some(FeedKind::Max) => return Ok(Speed::Rapid),
            Some(FeedKind::Value(value)) => self.modal.feed = Some(self.operand(&value)? * self.drives.unit()),
            Some(FeedKind::Auto) => self.modal.feed = self.modal.tool_feed,
            Some(FeedKind::PerRevolution(value)) => {
                self.modal.feed = Some(self.operand(&value)? * self.drives.unit() * self.drives.switched.spindle.speed);
            }
            Some(FeedKind::PerTooth(value)) => {
                let teeth = self.drives.world.tool().map_or(0.0, |tool| tool.teeth);
                self.modal.feed =
                    Some(self.operand(&value)? * self.drives.unit() * self.drives.switched.spindle.speed * teeth);
            }
            None => {}
        }
        Speed::of_feed(self.modal.feed.unwrap_or(0.0))
    }

    /// Gives a Q parameter a value, and reports it if that changes it.
    pub(crate) fn set(&mut self, q: QRef, value: Content) -> Result<(), Fault> {
        let changed = self.params.set(q, &value).map_err(|error| match error {
            EvalError::Undefined(q) => Fault::program("no-such-parameter").arg("q", q.to_string()),
            other => other.into(),
        })?;
        if changed {
            self.drives.report.report(EventKind::Set { q, value });
        }
        Ok(())
    }

    /// Sets a Q parameter of the run: where a field says where the result goes, there.
    pub(crate) fn set_of_cycle(&mut self, q: QRef, value: Content, exec: &mut Exec<'_, 'e>) -> Result<(), Fault> {
        if let (true, Content::Number(number)) = (exec.is_redirected(q), &value) {
            let Some(target) = exec.redirected(q, *number) else { return Ok(()) };
            return self.set(target, value);
        }
        match (value, exec.definition.scale_of(q)) {
            (Content::Number(number), scale) if scale != 1.0 => self.set(q, Content::Number(number / scale)),
            (value, _) => self.set(q, value),
        }
    }

    pub(crate) fn not_executed(&self, head: Span) -> Fault {
        let word = self.slice(head).split_ascii_whitespace().next().unwrap_or_default();
        Fault::unsupported("unsupported-block").arg("word", word)
    }
}
