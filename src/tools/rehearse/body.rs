//! The blank of a program, with the tool axis upwards.
use glam::DVec3;

use crate::engine::geometry::{Axis, WorkingPlane};
use crate::program::syntax::{self, Amount, BlkForm, BlockKind, Program, Statement, StatementKind, ValueKind};
use crate::spec::MM_PER_INCH;

/// A blank: a box, or a cylinder about the tool axis; lengths in mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    /// The tool axis.
    pub(super) axis: Axis,
    /// The lowest corner of the box that holds it: main axis, secondary axis, tool axis.
    pub(super) low: DVec3,
    /// The highest one.
    pub(super) high: DVec3,
    /// Whether it is a cylinder about the middle of that box, and the radius of the bore in it.
    bore: Option<f64>,
}

impl Body {
    /// The blank that a program names, if its size is certain.
    pub(super) fn of(program: &Program) -> Option<Self> {
        let (mut unit, mut corners) = (1.0, Vec::new());
        for block in program.blocks() {
            match &block.kind {
                BlockKind::BeginPgm(frame) if frame.inch => unit = MM_PER_INCH,
                BlockKind::BlkForm(form) => corners.push(form.as_ref()),
                BlockKind::Statement(own) if own.kind == StatementKind::BlkForm => {
                    return Self::turned(program, own, unit);
                }
                _ => {}
            }
        }
        match corners.as_slice() {
            [first, second] if first.part == 1 && second.part == 2 => Self::between(first, second, unit),
            _ => None,
        }
    }

    /// `BLK FORM 0.1` and `0.2`.
    fn between(first: &BlkForm, second: &BlkForm, unit: f64) -> Option<Self> {
        let axis = axis_of(first.axis?)?;
        let plane = WorkingPlane::of_tool_axis(axis);
        let value = |form: &BlkForm, axis: Axis| {
            let coord = form.coords.iter().find(|coord| axis_of(coord.axis) == Some(axis))?;
            match coord.value.amount {
                Amount::Number(number) => Some((number * unit, coord.incremental)),
                Amount::Q { .. } | Amount::Text(_) => None,
            }
        };
        let (mut low, mut high) = (DVec3::ZERO, DVec3::ZERO);
        for (place, axis) in [plane.main, plane.secondary, plane.tool].into_iter().enumerate() {
            let (one, _) = value(first, axis)?;
            let (other, incremental) = value(second, axis)?;
            let other = if incremental { one + other } else { other };
            (low[place], high[place]) = (one.min(other), one.max(other));
        }
        low.cmplt(high).all().then_some(Self { axis, low, high, bore: None })
    }

    /// `BLK FORM CYLINDER`: about the tool axis, from the displacement down by the length.
    fn turned(program: &Program, form: &Statement, unit: f64) -> Option<Self> {
        let head = program.slice(form.head).to_ascii_uppercase();
        if !head.ends_with("CYLINDER") {
            return None;
        }
        let value = |wanted: &str| {
            let word = form.words.iter().find(|word| program.slice(word.name).trim().eq_ignore_ascii_case(wanted))?;
            match word.value.kind {
                ValueKind::Number(number) => Some(number * unit),
                _ => None,
            }
        };
        let letter = form.words.iter().find_map(|word| match program.slice(word.name).trim() {
            "X" => Some(Axis::X),
            "Y" => Some(Axis::Y),
            "Z" => Some(Axis::Z),
            _ => None,
        });
        let radius = value("R").or_else(|| value("D").map(|own| own / 2.0))?;
        let bore = value("RI").or_else(|| value("DI").map(|own| own / 2.0)).unwrap_or(0.0);
        let top = value("DIST").unwrap_or(0.0);
        let low = DVec3::new(-radius, -radius, top - value("L")?);
        let high = DVec3::new(radius, radius, top);
        low.cmplt(high).all().then_some(Self { axis: letter?, low, high, bore: Some(bore) })
    }

    /// The corners of the box that holds it, in the order of the axes.
    pub(super) fn corners(&self) -> [DVec3; 2] {
        let plane = WorkingPlane::of_tool_axis(self.axis);
        [self.low, self.high].map(|own| plane.lift(own.truncate(), own.z))
    }

    /// How far a place is beside it in the plane; 0 inside.
    pub(super) fn distance(&self, place: DVec3) -> f64 {
        if let Some(bore) = self.bore {
            let middle = (self.low + self.high) / 2.0;
            let out = (place - middle).truncate().length();
            return (out - (self.high.x - self.low.x) / 2.0).max(bore - out).max(0.0);
        }
        let beyond = (self.low - place).max(place - self.high).max(DVec3::ZERO);
        libm::hypot(beyond.x, beyond.y)
    }

    /// Whether a place is at least so far inside of its faces.
    pub(super) fn holds(&self, place: DVec3, skin: f64) -> bool {
        let inside = (place - self.low).min_element() > skin && (self.high - place).min_element() > skin;
        inside
            && self.bore.is_none_or(|bore| {
                let out = (place - (self.low + self.high) / 2.0).truncate().length();
                out < (self.high.x - self.low.x) / 2.0 - skin && out > bore + skin * bore.signum()
            })
    }
}

fn axis_of(axis: syntax::Axis) -> Option<Axis> {
    match axis {
        syntax::Axis::X => Some(Axis::X),
        syntax::Axis::Y => Some(Axis::Y),
        syntax::Axis::Z => Some(Axis::Z),
        _ => None,
    }
}
