//! Parallel axes (U, V, W) beside the linear ones: where they are, and what a program has chosen of them.
//!
//! A parallel axis that moves by itself is no part of the way of the tool: what it carries is the machine builder's
//! matter. It is one where the program says so: instead of the linear axis (`FUNCTION PARAXMODE`), or with the linear axis
//! taking its way back (`FUNCTION PARAXCOMP MOVE`). Invariant: neither choice moves the tool.
use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use crate::engine::geometry::Axis;
use crate::engine::machine::{Machine, ParallelAxis};

/// The linear axis to which a parallel axis is parallel.
pub(crate) const fn beside(letter: char) -> Option<Axis> {
    match letter {
        'U' => Some(Axis::X),
        'V' => Some(Axis::Y),
        'W' => Some(Axis::Z),
        _ => None,
    }
}

/// A parallel axis that moves instead of the linear one beside it.
#[derive(Clone, Copy, Debug)]
struct Driving {
    axis: Axis,
    letter: char,
    /// Its coordinate while that of the tool tip in the machine is 0.
    zero: f64,
    /// Where the linear axis stays.
    stays: f64,
}

/// The parallel axes of a machine.
#[derive(Clone, Debug, Default)]
pub(crate) struct Parallels {
    /// Where they are, mm; of those that move instead of linear axes, where they were before.
    at: BTreeMap<char, f64>,
    /// Those whose way the linear axis takes back.
    compensated: BTreeSet<char>,
    driving: Vec<Driving>,
    /// Where they have brought the tool tip beside what the linear axes say.
    carried: DVec3,
}

impl Parallels {
    /// Those of a machine, at 0 or as near to it as they can be.
    pub(crate) fn new(axes: &[ParallelAxis]) -> Self {
        let at = axes.iter().map(|axis| (axis.letter, 0.0_f64.clamp(axis.min, axis.max))).collect();
        Self { at, ..Self::default() }
    }

    /// Where one is while it moves by itself.
    pub(crate) fn at(&self, letter: char) -> f64 {
        self.at.get(&letter).copied().unwrap_or_default()
    }

    /// One has moved by itself.
    pub(crate) fn moved(&mut self, letter: char, to: f64) {
        let way = to - self.at(letter);
        self.at.insert(letter, to);
        if let (true, Some(axis)) = (self.compensated.contains(&letter), beside(letter)) {
            self.carried = axis.with(self.carried, axis.of(self.carried) + way);
        }
    }

    /// The linear axis that takes back the way of a parallel one.
    pub(crate) fn taken_back_by(&self, letter: char) -> Option<Axis> {
        beside(letter).filter(|_| self.compensated.contains(&letter))
    }

    /// Linear axes take back the ways of these, and of these only.
    pub(crate) fn compensate(&mut self, letters: BTreeSet<char>) {
        self.compensated = letters;
    }

    /// Whether one moves instead of a linear axis.
    pub(crate) fn drive(&self) -> bool {
        !self.driving.is_empty()
    }

    /// Whether this one does.
    pub(crate) fn drives(&self, letter: char) -> bool {
        self.driving.iter().any(|own| own.letter == letter)
    }

    /// From now on these move instead of the linear axes beside them; the tool tip is there in the machine.
    pub(crate) fn choose(&mut self, letters: &[char], tip: DVec3) {
        for own in std::mem::take(&mut self.driving) {
            self.at.insert(own.letter, own.axis.of(tip) + own.zero);
            self.carried = own.axis.with(self.carried, own.axis.of(tip) - own.stays);
        }
        for letter in letters {
            let Some(axis) = beside(*letter) else { continue };
            let zero = self.at(*letter) - axis.of(tip);
            self.driving.push(Driving { axis, letter: *letter, zero, stays: axis.of(tip - self.carried) });
        }
    }

    /// What programs have chosen ends.
    pub(crate) fn end(&mut self, tip: DVec3) {
        self.choose(&[], tip);
        self.compensated.clear();
    }

    /// Where they have brought the tool tip beside what the linear axes say, while none moves instead of one.
    pub(crate) const fn carried(&self) -> DVec3 {
        self.carried
    }

    /// Where the linear axes are while the tool tip is there in the machine.
    pub(crate) fn linear(&self, tip: DVec3) -> DVec3 {
        self.driving.iter().fold(tip - self.carried, |linear, own| own.axis.with(linear, own.stays))
    }

    /// The first of those that move instead of linear ones that leaves its range, and where it would be.
    pub(crate) fn beyond<'m>(&self, machine: &'m Machine, tip: DVec3) -> Option<(&'m ParallelAxis, f64)> {
        self.driving.iter().find_map(|own| {
            let (axis, at) = (machine.parallel(own.letter)?, own.axis.of(tip) + own.zero);
            (!(axis.min..=axis.max).contains(&at)).then_some((axis, at))
        })
    }

    /// The rapid rate of a way, mm/min.
    pub(crate) fn rapid_feed(&self, machine: &Machine, way: DVec3) -> f64 {
        if self.driving.is_empty() {
            return machine.rapid_feed(way);
        }
        let rest = self.driving.iter().fold(way, |rest, own| own.axis.with(rest, 0.0));
        let length = way.length();
        let others =
            if rest == DVec3::ZERO { f64::INFINITY } else { machine.rapid_feed(rest) / rest.length() * length };
        let own = self.driving.iter().filter_map(|own| {
            let part = own.axis.of(way).abs();
            (part > 0.0).then_some(machine.parallel(own.letter)?.rapid / part * length)
        });
        own.fold(others, f64::min)
    }
}
