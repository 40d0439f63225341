//! The box that a program names as its blank.
use super::{Aspect, Modal, Tri};
use crate::program::syntax::{
    Amount, Axis, BlkForm, BlockKind, NamedWord, Program, Statement, StatementKind, ValueKind,
};

/// The axes of places inside of it, in the order of its corners.
pub(super) const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The corners of a blank along Z, the lower one first; in the unit of the program.
pub(super) struct Blank {
    pub low: [f64; 3],
    pub high: [f64; 3],
}

impl Blank {
    /// The blank of a program that names one box and no more.
    pub(super) fn of(program: &Program) -> Option<Self> {
        let mut forms = program.blocks().iter().filter_map(|block| match &block.kind {
            BlockKind::BlkForm(form) => Some(form.as_ref()),
            _ => None,
        });
        let (first, second) = (forms.next()?, forms.next()?);
        (forms.next().is_none() && first.part == 1 && second.part == 2).then(|| Self::between(first, second))?
    }

    /// The blank with its corners in order.
    pub(super) fn between(first: &BlkForm, second: &BlkForm) -> Option<Self> {
        if first.axis != Some(Axis::Z) {
            return None;
        }
        let number = |form: &BlkForm, axis: Axis| {
            let coord = form.coords.iter().find(|coord| coord.axis == axis)?;
            match coord.value.amount {
                Amount::Number(number) => Some((number, coord.incremental)),
                Amount::Q { .. } | Amount::Text(_) => None,
            }
        };
        let mut blank = Self { low: [0.0; 3], high: [0.0; 3] };
        for (place, axis) in AXES.into_iter().enumerate() {
            let (one, _) = number(first, axis)?;
            let (other, incremental) = number(second, axis)?;
            let other = if incremental { one + other } else { other };
            (blank.low[place], blank.high[place]) = (one.min(other), one.max(other));
        }
        Some(blank)
    }

    /// Whether a place of the plane lies inside, the edges left out.
    pub(super) fn holds(&self, x: f64, y: f64) -> bool {
        self.low[0] < x && x < self.high[0] && self.low[1] < y && y < self.high[1]
    }

    /// How far a place of the plane is outside; 0 inside.
    pub(super) fn distance(&self, place: [f64; 2]) -> f64 {
        let beyond = |axis: usize| (self.low[axis] - place[axis]).max(place[axis] - self.high[axis]).max(0.0);
        libm::hypot(beyond(0), beyond(1))
    }

    /// Whether a place of the plane lies outside, the edges left out.
    pub(super) fn lacks(&self, x: f64, y: f64) -> bool {
        x < self.low[0] || self.high[0] < x || y < self.low[1] || self.high[1] < y
    }
}

/// Whether coordinates are those of the blank: nothing shifts, turns, mirrors, scales or tilts them.
pub(super) fn is_unmoved(modal: &Modal) -> bool {
    keeps_heights(modal) && modal.is(Aspect::Rotation) == Tri::No
}

/// Whether heights are those of the blank: coordinates may be turned, but nothing else changes them.
pub(super) fn keeps_heights(modal: &Modal) -> bool {
    const MOVING: [Aspect; 5] =
        [Aspect::DatumShift, Aspect::Mirroring, Aspect::Scaling, Aspect::AxisScaling, Aspect::Tilting];
    MOVING.iter().all(|own| modal.is(*own) == Tri::No)
}

/// The height of the upper face of a blank along Z: of the one box, or of the one cylinder.
pub(super) fn top(program: &Program) -> Option<f64> {
    if let Some(blank) = Blank::of(program) {
        return Some(blank.high[2]);
    }
    let form = cylinder(program)?;
    match word(program, form, "DIST").map(|word| word.value.kind) {
        None => Some(0.0),
        Some(ValueKind::Number(number)) => Some(number),
        Some(_) => None,
    }
}

/// The diameter of the one cylinder along Z that a program names as its blank, about X 0 and Y 0.
pub(super) fn diameter(program: &Program) -> Option<f64> {
    let form = cylinder(program)?;
    let value = |name: &str| match word(program, form, name)?.value.kind {
        ValueKind::Number(number) => Some(number),
        _ => None,
    };
    value("D").or_else(|| Some(2.0 * value("R")?))
}

/// The statement of the one cylinder along Z.
fn cylinder(program: &Program) -> Option<&Statement> {
    let mut forms = program.blocks().iter().filter_map(|block| match &block.kind {
        BlockKind::Statement(own) if own.kind == StatementKind::BlkForm => Some(own.as_ref()),
        _ => None,
    });
    let form = forms.next().filter(|_| forms.next().is_none())?;
    let last = program.slice(form.head).split_whitespace().last()?;
    (word(program, form, "Z").is_some() && last.eq_ignore_ascii_case("CYLINDER")).then_some(form)
}

fn word<'p>(program: &Program, form: &'p Statement, name: &str) -> Option<&'p NamedWord> {
    form.words.iter().find(|word| program.slice(word.name).trim().eq_ignore_ascii_case(name))
}
