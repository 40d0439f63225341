//! What is known of the control's state between two blocks.
//!
//! Invariant: everything only ever becomes less certain when ways of the run meet, so that following them ends.
use std::collections::{BTreeSet, HashMap};
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::Arc;

use crate::base::expr::{Env, EvalError, QKind, QRef, Value};
use crate::check::cycle::{Aspect, Tri};

/// The cycle that a call means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pending {
    /// None is defined yet.
    None,
    /// The definition of that index.
    Definition(u32),
    /// Not known.
    Unknown,
}

/// The tool in the spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Loaded {
    /// None was called yet.
    None,
    /// That of the tool call in that block.
    By(u32),
    /// Not known.
    Unknown,
}

/// The modal state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Modal {
    /// Two bits for each aspect, those of [`Tri`]: what two states disagree about has both.
    aspects: u64,
    /// The cycle that a call means.
    pub pending: Pending,
    /// The tool.
    pub loaded: Loaded,
}

/// The same for all aspects.
const fn all(value: Tri) -> u64 {
    (u64::MAX / 3) * value as u64
}

// Two bits for each: the last aspect must have its own.
const _: () = assert!(shift(Aspect::ShiftZ) < u64::BITS);

const fn shift(aspect: Aspect) -> u32 {
    2 * aspect as u32
}

impl Modal {
    /// The state at the beginning of a program.
    pub(super) const BEGIN: Self = Self { aspects: all(Tri::No), pending: Pending::None, loaded: Loaded::None };
    /// Nothing is known.
    pub(super) const UNKNOWN: Self =
        Self { aspects: all(Tri::Unknown), pending: Pending::Unknown, loaded: Loaded::Unknown };

    /// What is known of an aspect.
    pub const fn is(&self, aspect: Aspect) -> Tri {
        match (self.aspects >> shift(aspect)) & 3 {
            1 => Tri::No,
            2 => Tri::Yes,
            _ => Tri::Unknown,
        }
    }

    /// From here on an aspect is so; a datum shift is so along each axis.
    pub(super) const fn set(&mut self, aspect: Aspect, value: Tri) {
        self.put(aspect, value);
        if matches!(aspect, Aspect::DatumShift) {
            self.put(Aspect::ShiftX, value);
            self.put(Aspect::ShiftY, value);
            self.put(Aspect::ShiftZ, value);
        }
    }

    /// From here on the datum shift along some axes is so; along the others it stays.
    pub(super) fn shift(&mut self, axes: [Option<Tri>; 3]) {
        for ((aspect, _), value) in Aspect::SHIFTS.into_iter().zip(axes) {
            if let Some(value) = value {
                self.put(aspect, value);
            }
        }
        let all = Aspect::SHIFTS.map(|(aspect, _)| self.is(aspect));
        let whole = match () {
            () if all.contains(&Tri::Yes) => Tri::Yes,
            () if all.contains(&Tri::Unknown) => Tri::Unknown,
            () => Tri::No,
        };
        self.put(Aspect::DatumShift, whole);
    }

    const fn put(&mut self, aspect: Aspect, value: Tri) {
        self.aspects = self.aspects & !(3 << shift(aspect)) | ((value as u64) << shift(aspect));
    }

    pub(super) fn join(&self, other: &Self) -> Self {
        let pending = if self.pending == other.pending { self.pending } else { Pending::Unknown };
        let loaded = if self.loaded == other.loaded { self.loaded } else { Loaded::Unknown };
        Self { aspects: self.aspects | other.aspects, pending, loaded }
    }
}

/// What is known of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Known {
    /// Nothing has given it a value.
    Unset,
    /// Its number.
    Number(f64),
    /// It may have any value.
    Unknown,
}

/// Hashes parameters: there are not so many of them that anybody could choose bad ones.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mix(u64);

impl Hasher for Mix {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64(u64::from(*byte)));
    }

    fn write_u16(&mut self, number: u16) {
        self.write_u64(u64::from(number));
    }

    fn write_u64(&mut self, number: u64) {
        self.0 = (self.0.rotate_left(26) ^ number).wrapping_mul(0xF135_7AEA_2E62_A9C5);
    }

    fn write_isize(&mut self, number: isize) {
        self.write_u64(number.unsigned_abs() as u64);
    }
}

/// Modal state and parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub(super) modal: Modal,
    numbers: HashMap<QRef, Known, BuildHasherDefault<Mix>>,
    /// What holds of parameters that are not in the map.
    others: Known,
}

/// Parameters of the families that are free in every program.
const FREE: std::ops::Range<u16> = 0..100;

impl State {
    /// At the beginning of a program: of one that is started the modal state is known, and of one with a blank it is
    /// known that no other has filled its parameters.
    pub(super) fn begin(main: bool, blank: bool) -> Self {
        let modal = if main { Modal::BEGIN } else { Modal::UNKNOWN };
        Self { modal, numbers: HashMap::default(), others: if blank { Known::Unset } else { Known::Unknown } }
    }

    /// Where nothing is known.
    pub(super) fn unknown() -> Self {
        Self::begin(false, false)
    }

    /// Forgets everything.
    pub(super) fn forget(&mut self) {
        *self = Self::unknown();
    }

    /// Forgets the parameters that other programs and cycles can write.
    pub(super) fn forget_parameters(&mut self) {
        // The room is given back, too: there may be a state for each label.
        self.numbers = HashMap::default();
        self.others = Known::Unknown;
    }

    /// What is known of a parameter. The control and cycles fill all but the free ones; remanent ones last.
    pub(super) fn get(&self, q: QRef) -> Known {
        let written = self.numbers.get(&q).copied();
        written.unwrap_or(match (self.others, q.kind) {
            (Known::Unset, QKind::Q | QKind::Qs) if FREE.contains(&q.number) => Known::Unset,
            (Known::Unset, QKind::Ql) => Known::Unset,
            _ => Known::Unknown,
        })
    }

    /// Whether parameters can be without a value here or later.
    pub(super) fn may_be_unset(&self) -> bool {
        self.others == Known::Unset
    }

    pub(super) fn set(&mut self, q: QRef, value: Known) {
        // What the control itself writes is never known.
        let value = if q.kind == QKind::Q && (100..200).contains(&q.number) { Known::Unknown } else { value };
        self.numbers.insert(q, value);
    }

    /// From here on a call means the definition of that index.
    pub(super) fn pend(&mut self, index: usize) {
        self.modal.pending = u32::try_from(index).map_or(Pending::Unknown, Pending::Definition);
    }

    /// How many parameters are in it.
    pub(super) fn size(&self) -> usize {
        self.numbers.len()
    }

    /// Both ways lead here.
    pub(super) fn join(&self, other: &Self) -> Self {
        let all = if self.others == other.others { self.others } else { Known::Unknown };
        let meet = |q: QRef| {
            let (own, other) = (self.get(q), other.get(q));
            // What is not in the map is unknown where the others are.
            let met = if own == other { own } else { Known::Unknown };
            (all != Known::Unknown || met != Known::Unknown).then_some((q, met))
        };
        let others = other.numbers.keys().filter(|q| !self.numbers.contains_key(q));
        let numbers = self.numbers.keys().chain(others).filter_map(|q| meet(*q)).collect();
        Self { modal: self.modal.join(&other.modal), numbers, others: all }
    }

    /// The state after a call: what the called part does not touch is as it was before.
    pub(super) fn after(before: &Self, exit: &Self, touched: &Touched) -> Self {
        if touched.everything {
            return exit.clone();
        }
        let mut state = before.clone();
        state.modal.aspects = state.modal.aspects & !touched.aspects | exit.modal.aspects & touched.aspects;
        // A shift along one axis leaves those along the others.
        if Aspect::SHIFTS.iter().any(|(aspect, _)| touched.aspects & (3 << shift(*aspect)) != 0) {
            state.modal.shift([None; 3]);
        }
        if touched.pending {
            state.modal.pending = exit.modal.pending;
        }
        if touched.loaded {
            state.modal.loaded = exit.modal.loaded;
        }
        for q in &touched.parameters {
            state.numbers.insert(*q, exit.get(*q));
        }
        state
    }
}

/// What a part of a program may change.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Touched {
    /// Both bits of each aspect.
    aspects: u64,
    pending: bool,
    loaded: bool,
    parameters: BTreeSet<QRef>,
    /// Anything at all.
    everything: bool,
}

impl Touched {
    /// Adds what a block changes: found by its effect on two opposite states.
    pub(super) fn note(&mut self, before: &[State; 2], after: &[State; 2]) {
        for (before, after) in before.iter().zip(after) {
            let changed = before.modal.aspects ^ after.modal.aspects;
            let (low, high) = (changed & all(Tri::No), changed & all(Tri::Yes));
            self.aspects |= low | high | (low << 1) | (high >> 1);
            self.pending |= before.modal.pending != after.modal.pending;
            self.loaded |= before.modal.loaded != after.modal.loaded;
            self.everything |= before.others != after.others;
            self.parameters.extend(after.numbers.keys());
        }
    }

    /// Leaves out what other programs do not see: local parameters.
    pub(super) fn only_global(&mut self) {
        self.parameters.retain(|q| q.kind != QKind::Ql);
    }

    pub(super) fn add(&mut self, other: &Self) {
        self.aspects |= other.aspects;
        self.pending |= other.pending;
        self.loaded |= other.loaded;
        self.everything |= other.everything;
        self.parameters.extend(&other.parameters);
    }

    /// How many parameters it names.
    pub(super) fn size(&self) -> usize {
        self.parameters.len()
    }

    /// Everything may change.
    pub(super) fn everything() -> Self {
        Self { everything: true, ..Self::default() }
    }

    /// The two states that together show what a block changes.
    pub(super) fn probes() -> [State; 2] {
        let mut yes = State::begin(true, true);
        yes.modal.aspects = all(Tri::Yes);
        [State::begin(true, true), yes]
    }
}

/// The numbers of a state, and of parameters that are as good as written.
pub(super) struct Values<'s>(pub(super) &'s State, pub(super) &'s [(QRef, f64)]);

impl Env for Values<'_> {
    fn slot(&self, _: usize) -> &Value {
        // No name has a slot here, so nothing asks for one.
        const NONE: &Value = &Value::Number(f64::NAN);
        NONE
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        if let Some((_, number)) = self.1.iter().find(|(own, _)| *own == q) {
            return Ok(*number);
        }
        match self.0.get(q) {
            Known::Number(number) => Ok(number),
            _ => Err(EvalError::Undefined(q)),
        }
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        Err(EvalError::Undefined(q))
    }
}
