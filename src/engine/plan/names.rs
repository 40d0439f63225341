//! Names and slots: what a name in an expression stands for, and what the known names are.
//!
//! Invariant: a name is bound once in its scope; slots are never shared by two names.
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::sync::Arc;

use super::Slot;
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{QRef, Resolve, Type};
use crate::spec::{Cycle, Name, OnControl};

/// How many fragments a cycle may use, those inside others counted each time: ten uses of ten uses of ten … would
/// fill any memory.
pub(super) const MAX_INLINED: usize = 2000;

/// A name that the engine gives a value to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Builtin {
    /// The programmed position now.
    Here,
    /// The position when the cycle began.
    Start,
    /// Radius of the tool, mm, oversize included.
    ToolRadius,
    /// Length of the tool, mm, oversize included.
    ToolLength,
    /// Greatest plunging angle of the tool, degrees.
    ToolAngle,
    /// Length of the tool's cutting edges, mm.
    ToolLcuts,
    /// The radius of its edge at the bottom.
    ToolCornerRadius,
    /// The number of the tool.
    ToolNumber,
    /// Whether a tool call has fixed the tool axis.
    ToolCalled,
    /// Distance kept from the touch point, mm.
    ProbeSetUp,
    /// Probing feed, mm/min.
    ProbeFeed,
    /// Feed between touch points, mm/min.
    ProbeFmax,
    /// The greatest probing path, mm.
    ProbeDist,
    /// The effective radius of the ball, mm.
    ProbeBallRadius,
    /// Whether pre-positioning is at the machine's rapid rate.
    ProbeMachineRapid,
    /// The spindle angle at which the probe was calibrated, degrees.
    ProbeAngle,
    /// Whether the spindle can turn the probe by half a turn.
    ProbeTurns,
    /// The calibrated offset of the ball from the spindle axis as the spindle is turned now.
    ProbeOffset,
    /// The direction from the tool tip to the ball centre.
    ProbeUp,
    /// The coordinate of a rotary axis of the machine, by their order; 0 if there is none.
    FurtherAxis(usize),
    /// A length among the machine data by its neutral name.
    MachineLength(Arc<str>),
    /// A place of the machine that a machine datum names, by its neutral name.
    MachinePoint(Arc<str>),
    /// A mirror image is active.
    ActiveMirror,
    /// A scaling is active.
    ActiveScaling,
    /// A scaling by axes is active.
    ActiveAxisScaling,
    /// A datum shift is active.
    ActiveDatumShift,
    /// A rotation is active.
    ActiveRotation,
    /// A basic rotation is active.
    ActiveBasicRotation,
    /// The working plane is tilted.
    ActiveTilting,
    /// Whether circles of the program go round the other way: an odd number of axes is mirrored.
    ActiveReversed,
    /// Turning is active.
    ActiveTurning,
    /// Whether the rotary axes are not where the tilted working plane wants them.
    ActiveAskew,
    /// Whether the tool tip is held on the workpiece while rotary axes turn.
    ActiveTcpm,
    /// A machine datum by its neutral name.
    Machine(Arc<str>),
    /// Whether the definition has the form of that number.
    Form(usize),
    /// Whether the old-style field of that id was programmed.
    Given(Arc<str>),
}

impl Builtin {
    /// Whether it has a value only while a touch probe is in the spindle.
    pub const fn is_of_probe(&self) -> bool {
        matches!(
            self,
            Self::ProbeSetUp
                | Self::ProbeFeed
                | Self::ProbeFmax
                | Self::ProbeDist
                | Self::ProbeBallRadius
                | Self::ProbeMachineRapid
                | Self::ProbeAngle
                | Self::ProbeTurns
                | Self::ProbeOffset
                | Self::ProbeUp
        )
    }

    /// Whether its value may change while a cycle is executed.
    pub const fn changes(&self) -> bool {
        matches!(
            self,
            Self::Here
                | Self::ProbeOffset
                | Self::ProbeUp
                | Self::ActiveMirror
                | Self::ActiveScaling
                | Self::ActiveAxisScaling
                | Self::ActiveDatumShift
                | Self::ActiveRotation
                | Self::ActiveBasicRotation
                | Self::ActiveTilting
                | Self::ActiveReversed
                | Self::ActiveTurning
                | Self::ActiveAskew
                | Self::ActiveTcpm
        )
    }
}

/// The known names that do not depend on the cycle or the control.
const FIXED: &[(&str, Builtin, Type)] = &[
    ("here", Builtin::Here, Type::Point),
    ("start", Builtin::Start, Type::Point),
    ("tool.radius", Builtin::ToolRadius, Type::Number),
    ("tool.length", Builtin::ToolLength, Type::Number),
    ("tool.angle", Builtin::ToolAngle, Type::Number),
    ("tool.corner_radius", Builtin::ToolCornerRadius, Type::Number),
    ("tool.lcuts", Builtin::ToolLcuts, Type::Number),
    ("tool.number", Builtin::ToolNumber, Type::Number),
    ("tool.called", Builtin::ToolCalled, Type::Bool),
    ("probe.set_up", Builtin::ProbeSetUp, Type::Number),
    ("probe.feed", Builtin::ProbeFeed, Type::Number),
    ("probe.fmax", Builtin::ProbeFmax, Type::Number),
    ("probe.dist", Builtin::ProbeDist, Type::Number),
    ("probe.ball_radius", Builtin::ProbeBallRadius, Type::Number),
    ("probe.machine_rapid", Builtin::ProbeMachineRapid, Type::Bool),
    ("probe.angle", Builtin::ProbeAngle, Type::Number),
    ("probe.turns", Builtin::ProbeTurns, Type::Bool),
    ("probe.offset", Builtin::ProbeOffset, Type::Point),
    ("probe.up", Builtin::ProbeUp, Type::Point),
    ("axis.fourth", Builtin::FurtherAxis(0), Type::Number),
    ("axis.fifth", Builtin::FurtherAxis(1), Type::Number),
    ("active.mirror", Builtin::ActiveMirror, Type::Bool),
    ("active.scaling", Builtin::ActiveScaling, Type::Bool),
    ("active.axis_scaling", Builtin::ActiveAxisScaling, Type::Bool),
    ("active.datum_shift", Builtin::ActiveDatumShift, Type::Bool),
    ("active.rotation", Builtin::ActiveRotation, Type::Bool),
    ("active.basic_rotation", Builtin::ActiveBasicRotation, Type::Bool),
    ("active.tilting", Builtin::ActiveTilting, Type::Bool),
    ("active.reversed", Builtin::ActiveReversed, Type::Bool),
    ("active.turning", Builtin::ActiveTurning, Type::Bool),
    ("active.askew", Builtin::ActiveAskew, Type::Bool),
    ("active.tcpm", Builtin::ActiveTcpm, Type::Bool),
];

struct Known {
    name: String,
    builtin: Builtin,
    ty: Type,
    /// Its slot, once an expression reads it.
    slot: Cell<Option<Slot>>,
}

/// The known names of a cycle on a control, the Q parameters that it may read, and the slots so far.
pub(super) struct Names {
    known: Vec<Known>,
    readable: BTreeSet<QRef>,
    slots: Cell<usize>,
}

/// A hyphen cannot be in a name of an expression.
pub(super) fn as_name(id: &str) -> String {
    id.replace('-', "_")
}

impl Names {
    pub(super) fn new(cycle: &Cycle, on: &OnControl) -> Self {
        let mut names = Self { known: Vec::new(), readable: BTreeSet::new(), slots: Cell::new(0) };
        for (name, builtin, ty) in FIXED {
            names.know((*name).to_owned(), builtin.clone(), *ty);
        }
        for (neutral, _) in &on.control.data.0 {
            let name = format!("machine.{}", as_name(neutral.as_str()));
            names.know(name, Builtin::Machine(Arc::clone(&neutral.text)), Type::Number);
            let name = format!("machine_length.{}", as_name(neutral.as_str()));
            names.know(name, Builtin::MachineLength(Arc::clone(&neutral.text)), Type::Number);
            let name = format!("machine_point.{}", as_name(neutral.as_str()));
            names.know(name, Builtin::MachinePoint(Arc::clone(&neutral.text)), Type::Point);
        }
        for (index, form) in cycle.file.forms.iter().enumerate() {
            names.know(format!("form_{}", as_name(form.form.as_str())), Builtin::Form(index), Type::Bool);
        }
        for field in cycle.params.iter().filter_map(|param| param.field.as_ref()) {
            let name = format!("given_{}", as_name(field.id.as_str()));
            if !names.known.iter().any(|known| known.name == name) {
                names.know(name, Builtin::Given(Arc::clone(&field.id.text)), Type::Bool);
            }
        }
        names.readable.extend(cycle.params.iter().filter_map(|param| param.q));
        names.readable.extend(cycle.lacking.iter().map(|(q, _)| *q));
        names.readable.extend(cycle.file.results.iter().filter_map(|result| result.q));
        names
    }

    fn know(&mut self, name: String, builtin: Builtin, ty: Type) {
        self.known.push(Known { name, builtin, ty, slot: Cell::new(None) });
    }

    /// A new slot.
    pub(super) fn slot(&self) -> Slot {
        let slot = self.slots.get();
        self.slots.set(slot + 1);
        slot
    }

    /// How many slots there are.
    pub(super) fn slots(&self) -> usize {
        self.slots.get()
    }

    /// From now on the parameter may be read.
    pub(super) fn allow(&mut self, q: QRef) {
        self.readable.insert(q);
    }

    /// The known names that some expression reads.
    pub(super) fn used_builtins(&self) -> Vec<(Slot, Builtin)> {
        let of = |known: &Known| known.slot.get().map(|slot| (slot, known.builtin.clone()));
        self.known.iter().filter_map(of).collect()
    }
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binding {
    /// A value that is there as soon as the name is.
    Value(Slot, Type),
    /// A value that may be missing when it is read.
    Maybe(Slot, Type),
    /// The result of a strategy that nobody knows: every field of it is a number.
    Open(Slot),
    /// A list of values of that type.
    List(usize, Type),
}

impl Binding {
    /// Whether both are values of the same type.
    pub(super) fn is_like(self, other: Self) -> bool {
        match (self, other) {
            (Self::Value(_, a) | Self::Maybe(_, a), Self::Value(_, b) | Self::Maybe(_, b)) => a == b,
            (Self::Open(_), Self::Open(_)) => true,
            _ => false,
        }
    }

    /// The slot of a value.
    pub(super) const fn slot(self) -> Option<Slot> {
        match self {
            Self::Value(slot, _) | Self::Maybe(slot, _) | Self::Open(slot) => Some(slot),
            Self::List(..) => None,
        }
    }

    /// The same kind of value in another slot; whether it is there is not sure.
    pub(super) const fn moved_to(self, slot: Slot) -> Self {
        match self {
            Self::Value(_, ty) | Self::Maybe(_, ty) => Self::Maybe(slot, ty),
            Self::Open(_) => Self::Open(slot),
            list @ Self::List(..) => list,
        }
    }
}

/// The names of a stretch of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope {
    names: Vec<(String, Binding)>,
}

impl Scope {
    /// The binding of a name.
    pub(super) fn get(&self, name: &str) -> Option<Binding> {
        self.names.iter().find(|(known, _)| known == name).map(|(_, binding)| *binding)
    }

    /// Binds a name without looking whether it is free.
    pub(super) fn push(&mut self, name: impl Into<String>, binding: Binding) {
        self.names.push((name.into(), binding));
    }

    /// A mark to return to.
    pub(super) const fn mark(&self) -> usize {
        self.names.len()
    }

    /// Forgets every name bound after the mark.
    pub(super) fn leave(&mut self, mark: usize) {
        self.names.truncate(mark);
    }

    /// The names bound after the mark.
    pub(super) fn since(&self, mark: usize) -> &[(String, Binding)] {
        &self.names[mark.min(self.names.len())..]
    }
}

/// Resolves names for one expression and notes what it reads.
pub(super) struct Resolver<'r> {
    pub(super) names: &'r Names,
    pub(super) scope: &'r Scope,
    /// Slots that may be without a value.
    pub(super) needs: RefCell<Vec<Slot>>,
}

impl Resolve for Resolver<'_> {
    fn name(&self, path: &[String]) -> Option<(usize, Type)> {
        let joined = path.join(".");
        let binding = self.scope.get(&joined).or_else(|| match self.scope.get(path.first()?)? {
            open @ Binding::Open(_) => Some(open),
            _ => None,
        });
        match binding {
            Some(Binding::Value(slot, ty)) => return Some((slot, ty)),
            Some(Binding::Maybe(slot, ty)) => {
                self.needs.borrow_mut().push(slot);
                return Some((slot, ty));
            }
            Some(Binding::Open(slot)) => {
                self.needs.borrow_mut().push(slot);
                return Some((slot, Type::Number));
            }
            Some(Binding::List(..)) | None => {}
        }
        let known = self.names.known.iter().find(|known| known.name == joined)?;
        let slot = known.slot.get().unwrap_or_else(|| self.names.slot());
        known.slot.set(Some(slot));
        if matches!(known.builtin, Builtin::MachinePoint(_)) {
            self.needs.borrow_mut().push(slot);
        }
        Some((slot, known.ty))
    }

    fn q(&self, q: QRef) -> bool {
        self.names.readable.contains(&q)
    }
}

impl super::Compiler<'_> {
    /// Binds a name, or says that it is taken.
    pub(super) fn bind(&mut self, name: &Name, binding: Binding, scope: &mut Scope) {
        self.bind_text(name.as_str(), &name.place, binding, scope);
    }

    pub(super) fn bind_text(&mut self, name: &str, place: &Place, binding: Binding, scope: &mut Scope) {
        let known = self.names.known.iter().any(|known| known.name == name);
        if known || scope.get(name).is_some() {
            self.found.push(Diagnostic::error("plan-name-taken", place.clone()).arg("name", name));
        } else if !name.starts_with(|c: char| c.is_ascii_lowercase())
            || name.contains(|c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || matches!(c, '_' | '.')))
        {
            self.found.push(Diagnostic::error("plan-name-form", place.clone()).arg("name", name));
        }
        scope.push(name, binding);
    }
}
