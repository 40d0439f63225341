//! What plans are made of: items, actions, guards and the calculations in them.
//!
//! Invariant: data only; every name has become a slot and every text an id.
use std::sync::Arc;

use super::{Slot, Watched};
use crate::base::diag::Place;
use crate::base::expr::{Code, QRef};
use crate::engine::strategy::Strategy;
use crate::engine::table::TableKind;
use crate::spec::{Moment, Outcome};

/// A compiled expression with the slots that must have a value before it can be evaluated.
#[derive(Clone, Debug)]
pub struct Calc {
    /// The code.
    pub code: Code,
    /// Slots that it reads and that may be without a value: names bound by actions, old-style fields.
    pub needs: Box<[Slot]>,
    /// Its place.
    pub place: Place,
}

/// A named value.
#[derive(Clone, Debug)]
pub struct Let {
    /// Where the value goes.
    pub slot: Slot,
    /// The value.
    pub value: Calc,
}

/// A condition under which the cycle is refused, skipped or doubted.
#[derive(Clone, Debug)]
pub struct Guard {
    /// Its code.
    pub code: Arc<str>,
    /// When it applies.
    pub when: Calc,
    /// What then.
    pub then: Outcome,
    /// The machine datum (neutral name) that switches it off when it is 0.
    pub switched_off_by: Option<Arc<str>>,
    /// When it is looked at.
    pub at: Moment,
}

/// An item of a run.
#[derive(Clone, Debug)]
pub enum Item {
    /// A numbered sentence with its actions.
    Step(Step),
    /// A titled section.
    Group {
        /// Only executed if this holds.
        when: Option<Calc>,
        /// Its items.
        items: Vec<Item>,
    },
    /// A series.
    Each(Box<Series>),
    /// Values that are noted.
    Watch(Watched),
}

/// A numbered sentence with its actions.
#[derive(Clone, Debug)]
pub struct Step {
    /// Its id.
    pub id: Arc<str>,
    /// The index of its sentence in [`super::Plan::sentences`].
    pub sentence: usize,
    /// Only executed if this holds.
    pub when: Option<Calc>,
    /// What is done.
    pub block: Block,
}

/// Actions, a choice, and actions after it.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// Actions.
    pub first: Vec<Do>,
    /// The choice: the first case whose conditions all hold is executed.
    pub choose: Vec<Case>,
    /// Actions after the choice.
    pub then: Vec<Do>,
}

/// A case of a choice.
#[derive(Clone, Debug)]
pub struct Case {
    /// Conditions that must all hold, each with whether it is negated.
    pub when: Vec<(Calc, bool)>,
    /// The index of its sentence in [`super::Plan::sentences`], if it has one.
    pub say: Option<usize>,
    /// What is done.
    pub acts: Vec<Do>,
    /// Values that every case has under the same name: from the slot here to the slot after the choice.
    pub exports: Vec<(Slot, Slot)>,
}

/// A series with what is done for its members.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its kind with its calculations.
    pub kind: SeriesKind,
    /// The slots of a member's fields, in the order of [`SeriesKind::members`].
    pub member: Slot,
    /// Only executed if this holds.
    pub when: Option<Calc>,
    /// Done for every member.
    pub body: Vec<Item>,
    /// Done between two members.
    pub between: Vec<Item>,
    /// What every turn adds to a list.
    pub collect: Option<Collect>,
    /// Its place.
    pub place: Place,
}

/// What every turn adds to a list.
#[derive(Clone, Debug)]
pub struct Collect {
    /// The index of the list.
    pub list: usize,
    /// The value.
    pub value: Calc,
}

/// The finite series.
#[derive(Clone, Debug)]
pub enum SeriesKind {
    /// From one coordinate to another by infeeds that may decrease down to a least one.
    Infeeds {
        /// Where the first infeed begins, mm.
        from: Calc,
        /// Where the last one ends, mm.
        to: Calc,
        /// The first infeed, mm, without sign.
        by: Calc,
        /// By how much each infeed is less than the one before, mm.
        less: Option<Calc>,
        /// No infeed is less than this, mm, apart from the last one.
        least: Option<Calc>,
    },
    /// Angles with equal steps.
    Angles {
        /// The first angle, degrees.
        start: Calc,
        /// The step, degrees.
        step: Calc,
        /// How many.
        count: Calc,
    },
    /// Counting from 1.
    Count {
        /// How many.
        of: Calc,
    },
}

/// An action with the condition under which it is executed.
#[derive(Clone, Debug)]
pub struct Do {
    /// Only executed if this holds.
    pub when: Option<Calc>,
    /// What is done.
    pub act: Act,
    /// Its place.
    pub place: Place,
}

/// Where a move goes.
#[derive(Clone, Debug)]
pub enum Target {
    /// To a point.
    Point(Calc),
    /// To coordinates in the main, minor and tool axis; axes not named stay.
    Axes([Option<Calc>; 3]),
}

/// How the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpindleTurn {
    /// Seen from the spindle clockwise.
    Clockwise,
    /// Seen from the spindle counter-clockwise.
    CounterClockwise,
    /// Not at all.
    Stop,
}

/// The coolant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cooling {
    /// Switched on.
    On,
    /// Switched off.
    Off,
}

/// What `cancel` ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cancel {
    /// Radius compensation.
    RadiusCompensation,
    /// The datum shift.
    DatumShift,
    /// The mirror image.
    Mirroring,
    /// The rotation.
    Rotation,
    /// Scaling.
    Scaling,
    /// Scaling by axes.
    AxisScaling,
}

impl Cancel {
    /// The one of that word.
    pub fn by_word(word: &str) -> Option<Self> {
        Some(match word {
            "radius-compensation" => Self::RadiusCompensation,
            "datum-shift" => Self::DatumShift,
            "mirroring" => Self::Mirroring,
            "rotation" => Self::Rotation,
            "scaling" => Self::Scaling,
            "axis-scaling" => Self::AxisScaling,
            _ => return None,
        })
    }
}

/// Changes of the coordinate system, from old-style fields or values.
#[derive(Clone, Debug)]
pub enum Transform {
    /// Datum shift by the coordinates of the field of that id.
    DatumShift(Arc<str>),
    /// Datum shift by the row of the active datum table that the field names.
    DatumRow(Arc<str>),
    /// Rotation by the angle of the field.
    Rotation(Arc<str>),
    /// Mirror the axes of the field; without it nothing is mirrored.
    Mirroring(Arc<str>),
    /// Scale by the factor of the field.
    Scaling(Arc<str>),
    /// Scale axes by the factors of a field about the centre of another one.
    AxisScaling(Arc<str>, Arc<str>),
    /// Tilt the working plane by the angles of the field; without it nothing is tilted.
    Tilting(Arc<str>),
    /// The preset of that row.
    Preset(Calc),
    /// What is no longer active.
    Cancel(Vec<Cancel>),
}

/// A strategy with its arguments.
#[derive(Clone, Debug)]
pub struct StrategyCall {
    /// Which one.
    pub strategy: &'static Strategy,
    /// Its arguments, one for each of its parameters.
    pub with: Vec<Option<Calc>>,
    /// Slots of its results, one for each of its outputs; none if nothing reads them.
    pub results: Vec<Slot>,
}

/// A fragment where it is used.
#[derive(Clone, Debug)]
pub struct Inlined {
    /// Its arguments and named values, in the order of evaluation.
    pub lets: Vec<Let>,
    /// Its guards.
    pub guards: Vec<Guard>,
    /// What is done.
    pub block: Block,
}

/// What a curve is fitted to.
#[derive(Clone, Debug)]
pub enum Fitted {
    /// The points of a list.
    List(usize),
    /// These points.
    Points(Vec<Calc>),
}

/// What is done.
#[derive(Clone, Debug)]
pub enum Act {
    /// Move at rapid traverse.
    Rapid(Target),
    /// Move at a feed in mm/min.
    Feed(Target, Calc),
    /// Move along the tool axis in step with the spindle, which turns as the thread asks.
    Synchronized {
        /// The height to move to.
        tool: Calc,
        /// The pitch, mm per turn: positive for a right-hand thread.
        pitch: Calc,
        /// By how much faster than programmed the spindle turns.
        speed_factor: Option<Calc>,
    },
    /// Move on an arc about an axis parallel to the tool axis.
    Arc {
        /// The centre.
        centre: Calc,
        /// The end.
        to: Calc,
        /// Counter-clockwise if positive.
        direction: Calc,
        /// The feed in mm/min, or rapid traverse.
        feed: Option<Calc>,
    },
    /// Wait, seconds.
    Dwell(Calc),
    /// Probe towards a point; the ball centre at contact goes to the slot.
    Probe {
        /// The direction: from the ball centre towards this point.
        towards: Calc,
        /// By how much the spindle turns the probe from its calibration angle, degrees, where that is fixed.
        turned: Option<Calc>,
        /// Where the ball centre at contact goes.
        into: Option<Slot>,
    },
    /// Call the last call-active cycle that was defined.
    CallLast,
    /// Set Q parameters.
    Set(Vec<(QRef, Calc)>),
    /// Set the Q parameter that a field names.
    Store {
        /// The id of the field.
        field: Arc<str>,
        /// How many parameters after the one that the field names.
        next: Option<Calc>,
        /// The value.
        value: Calc,
    },
    /// Bind names.
    Let(Vec<Let>),
    /// Change the coordinate system.
    Transform(Transform),
    /// Read a table.
    ReadTable {
        /// The table.
        table: TableKind,
        /// The row.
        row: Calc,
        /// The column.
        column: Arc<str>,
        /// Where the value goes.
        into: Slot,
    },
    /// Write a table.
    WriteTable {
        /// The table.
        table: TableKind,
        /// The row.
        row: Calc,
        /// The column.
        column: Arc<str>,
        /// The value.
        value: Calc,
        /// Whether it is added to what is there.
        add: bool,
    },
    /// Write a log.
    Log {
        /// Its name.
        name: Arc<str>,
        /// Whether it is shown on the screen and not written to a file.
        screen: bool,
        /// Values for it.
        with: Vec<(Arc<str>, Calc)>,
    },
    /// The circle or the sphere that fits points best.
    Fit {
        /// Whether it is a sphere.
        sphere: bool,
        /// The points.
        points: Fitted,
        /// One more point.
        also: Option<Calc>,
        /// Where the centre goes; that of a circle lies at the mean height of the points.
        centre: Slot,
        /// Where the radius goes.
        radius: Slot,
    },
    /// Lock a tool.
    Lock(Calc),
    /// Turn the spindle.
    Spindle(SpindleTurn),
    /// Orient the spindle, degrees.
    Orient(Calc),
    /// Switch the coolant.
    Coolant(Cooling),
    /// Stop with an error of that code.
    Fail(Arc<str>),
    /// Show a message.
    Message(Arc<str>),
    /// Show a message and wait for the operator; whether he agreed goes to the slot.
    Ask {
        /// The message.
        id: Arc<str>,
        /// Where the answer goes; without it a refusal stops the program.
        into: Option<Slot>,
    },
    /// Keep values by name for the cycles that follow.
    Remember(Vec<(Arc<str>, Calc)>),
    /// Do what a fragment says.
    Use(Box<Inlined>),
    /// A named strategy.
    Strategy(StrategyCall),
}
