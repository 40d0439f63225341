//! What is known of the control's state between two blocks.
//!
//! Invariant: everything only ever becomes less certain when ways of the run meet, so that following them ends.
use std::collections::{BTreeMap, BTreeSet};

use crate::expr::{QKind, QRef};

/// Whether something is so: no, yes, or nobody can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tri {
    /// Certainly not.
    No,
    /// Certainly.
    Yes,
    /// On some ways, or it depends on what the program does not say.
    Unknown,
}

impl Tri {
    fn join(self, other: Self) -> Self {
        if self == other { self } else { Self::Unknown }
    }

    /// The answer of what is known to be true or false.
    pub fn of(known: Option<bool>) -> Self {
        known.map_or(Self::Unknown, |known| if known { Self::Yes } else { Self::No })
    }

    /// True or false, if it is known.
    pub fn known(self) -> Option<bool> {
        match self {
            Self::No => Some(false),
            Self::Yes => Some(true),
            Self::Unknown => None,
        }
    }
}

/// What is followed through the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// A tool call has named the tool axis.
    Tool,
    /// A spindle speed has been programmed.
    Speed,
    /// The spindle turns.
    Spindle,
    /// A feed has been programmed.
    Feed,
    /// A circle centre or pole has been set.
    Pole,
    /// Radius compensation is active.
    Compensation,
    /// The working plane is tilted.
    Tilting,
    /// A mirror image is active.
    Mirroring,
    /// A scaling factor is active.
    Scaling,
    /// Scaling by axes is active.
    AxisScaling,
    /// A datum shift is active.
    DatumShift,
    /// A rotation is active.
    Rotation,
    /// Turning mode.
    Turning,
    /// A pattern of points is there.
    Pattern,
    /// A contour has been named.
    Contour,
}

const ASPECTS: usize = Aspect::Contour as usize + 1;

/// The cycle that a call means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pending {
    /// None is defined yet.
    None,
    /// The definition of that index.
    Definition(u32),
    /// Nobody can tell.
    Unknown,
}

/// The modal state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Modal {
    aspects: [Tri; ASPECTS],
    /// The cycle that a call means.
    pub pending: Pending,
}

impl Modal {
    /// The state at the beginning of a program.
    pub(super) const BEGIN: Self = Self { aspects: [Tri::No; ASPECTS], pending: Pending::None };
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self { aspects: [Tri::Unknown; ASPECTS], pending: Pending::Unknown };

    /// What is known of an aspect.
    pub fn is(&self, aspect: Aspect) -> Tri {
        self.aspects[aspect as usize]
    }

    pub(super) fn set(&mut self, aspect: Aspect, value: Tri) {
        self.aspects[aspect as usize] = value;
    }

    pub(super) fn join(&self, other: &Self) -> Self {
        let mut joined = *self;
        for (own, other) in joined.aspects.iter_mut().zip(&other.aspects) {
            *own = own.join(*other);
        }
        if joined.pending != other.pending {
            joined.pending = Pending::Unknown;
        }
        joined
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

/// Modal state and parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub(super) modal: Modal,
    numbers: BTreeMap<QRef, Known>,
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
        Self { modal, numbers: BTreeMap::new(), others: if blank { Known::Unset } else { Known::Unknown } }
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
        self.numbers.clear();
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

    pub(super) fn set(&mut self, q: QRef, value: Known) {
        // What the control itself writes is never known.
        let value = if q.kind == QKind::Q && (100..200).contains(&q.number) { Known::Unknown } else { value };
        self.numbers.insert(q, value);
    }

    /// Both ways lead here.
    pub(super) fn join(&self, other: &Self) -> Self {
        let keys: BTreeSet<QRef> = self.numbers.keys().chain(other.numbers.keys()).copied().collect();
        let meet = |q: QRef| {
            let (own, other) = (self.get(q), other.get(q));
            (q, if own == other { own } else { Known::Unknown })
        };
        Self {
            modal: self.modal.join(&other.modal),
            numbers: keys.into_iter().map(meet).collect(),
            others: if self.others == other.others { self.others } else { Known::Unknown },
        }
    }

    /// The state behind a call: what the called part does not touch is as it was before.
    pub(super) fn behind(before: &Self, exit: &Self, touched: &Touched) -> Self {
        if touched.everything {
            return exit.clone();
        }
        let mut state = before.clone();
        for (aspect, touched) in touched.aspects.iter().enumerate() {
            if *touched {
                state.modal.aspects[aspect] = exit.modal.aspects[aspect];
            }
        }
        if touched.pending {
            state.modal.pending = exit.modal.pending;
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
    aspects: [bool; ASPECTS],
    pending: bool,
    parameters: BTreeSet<QRef>,
    /// Anything at all.
    everything: bool,
}

impl Touched {
    /// Adds what a block changes: found by its effect on two opposite states.
    pub(super) fn note(&mut self, before: &[State; 2], after: &[State; 2]) {
        for (before, after) in before.iter().zip(after) {
            for (index, touched) in self.aspects.iter_mut().enumerate() {
                *touched |= before.modal.aspects[index] != after.modal.aspects[index];
            }
            self.pending |= before.modal.pending != after.modal.pending;
            self.everything |= before.others != after.others;
            self.parameters.extend(after.numbers.keys());
        }
    }

    pub(super) fn add(&mut self, other: &Self) -> bool {
        let before = self.clone();
        for (own, other) in self.aspects.iter_mut().zip(&other.aspects) {
            *own |= other;
        }
        self.pending |= other.pending;
        self.everything |= other.everything;
        self.parameters.extend(&other.parameters);
        *self != before
    }

    /// Everything may change.
    pub(super) fn everything() -> Self {
        Self { everything: true, ..Self::default() }
    }

    /// The two states that together show what a block changes.
    pub(super) fn probes() -> [State; 2] {
        let mut yes = State::begin(true, true);
        yes.modal.aspects = [Tri::Yes; ASPECTS];
        [State::begin(true, true), yes]
    }
}
