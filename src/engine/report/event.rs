//! Events: what a run reports while it goes on.
//!
//! Invariant: every effect of a program on the world is one event; lengths are mm, angles degrees, feeds mm/min,
//! times seconds.
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::QRef;
use crate::engine::geometry::{Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::machine::{Insert, Tool};
use crate::engine::params::Content;
use crate::engine::report::fault::Fault;
use crate::engine::solid::Path;
use crate::spec::CycleKey;

/// The version of the JSON form.
pub const FORMAT: &str = "ciklo-events/1";

/// Where in the program an event belongs.
#[derive(Clone, Debug, Default)]
pub struct At {
    /// The file name of the program.
    pub program: Arc<str>,
    /// The physical line, from 1.
    pub line: usize,
    /// The printed block number.
    pub block: Option<u32>,
    /// Inside a cycle: its key, and the id of the step once one has begun.
    pub cycle: Option<(CycleKey, Option<Arc<str>>)>,
}

/// An event.
#[derive(Clone, Debug)]
pub struct Event {
    /// Where it belongs.
    pub at: At,
    /// What happens.
    pub kind: EventKind,
}

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveKind {
    /// Straight at rapid traverse.
    Rapid,
    /// Straight at a feed.
    Feed,
    /// On an arc in the working plane.
    Arc {
        /// A point of the axis, at the height of the start.
        centre: DVec3,
        /// The working plane.
        plane: WorkingPlane,
        /// The angle in degrees, counter-clockwise positive.
        angle: f64,
        /// The way along the tool axis, mm.
        rise: f64,
        /// Whether it goes at rapid traverse.
        rapid: bool,
    },
}

/// What a move in turning ends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnDiameter {
    /// The diameter at the end of the move: the coordinate of X as the program has it, mm.
    pub diameter: f64,
    /// The speed of the turning spindle there, 1/min; 0 while it is stationary.
    pub speed: f64,
}

impl OnDiameter {
    /// A point of the active coordinate system as a program has it: in turning X is a diameter.
    pub fn programmed(turned: Option<Self>, point: DVec3) -> DVec3 {
        if turned.is_some() { DVec3::new(2.0 * point.x, point.y, point.z) } else { point }
    }
}

/// A probing movement, in the active coordinate system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probing {
    /// The ball centre where it begins.
    pub from: DVec3,
    /// Where the ball centre would be at the end of the probing path.
    pub target: DVec3,
    /// The point of the workpiece that was touched, and the ball centre at that moment as the control knows it.
    pub contact: Option<(DVec3, DVec3)>,
    /// The probing feed.
    pub feed: f64,
}

/// The coordinate system in effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    /// The row of the preset table, if the preset is one of its rows.
    pub preset: f64,
    /// The preset in machine coordinates.
    pub origin: DVec3,
    /// The spatial angles of the preset.
    pub basic_rotation: DVec3,
    /// The datum shift in the coordinates of the preset.
    pub datum: DVec3,
    /// The rotation in the working plane, degrees.
    pub rotation: f64,
    /// Axes that are mirrored have -1, others 1: linear and rotary ones.
    pub mirror: (DVec3, DVec3),
    /// The scaling factor, and the factors of the axes with the point that stays.
    pub scaling: (f64, Option<(DVec3, DVec3)>),
    /// The spatial angles of a tilted working plane.
    pub tilt: Option<DVec3>,
    /// Whether the tool tip is held on the workpiece while rotary axes turn.
    pub tip_held: bool,
    /// Whether positions count from where the rotary axes have brought tool and workpiece.
    pub axes_counted: bool,
    /// From program to machine coordinates: three rows, the last number of each is the shift.
    pub matrix: [[f64; 4]; 3],
    /// Where the rotary axes have the coordinate 0, in machine coordinates.
    pub angles: DVec3,
}

impl Coordinates {
    /// Whether another system differs by no more than calculating does: mm and degrees.
    pub(crate) fn is_near(&self, other: &Self) -> bool {
        /// The last digits of calculations.
        const SAME: f64 = 1e-10;
        let numbers = |own: &Self| {
            let vectors = [own.origin, own.basic_rotation, own.datum, own.mirror.0, own.mirror.1, own.angles];
            let numbers = vectors.into_iter().flat_map(|vector| vector.to_array());
            numbers.chain([own.preset, own.rotation]).chain(own.matrix.into_iter().flatten())
        };
        (self.scaling, self.tilt, self.tip_held, self.axes_counted)
            == (other.scaling, other.tilt, other.tip_held, other.axes_counted)
            && numbers(self).zip(numbers(other)).all(|(own, other)| (own - other).abs() <= SAME)
    }

    /// From program to machine coordinates.
    pub fn frame(&self) -> Frame {
        Frame::of_rows(self.matrix)
    }
}

/// How one rotary axis turns, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// The axis.
    pub axis: RotaryAxis,
    /// From where, in program coordinates.
    pub from: f64,
    /// Where to, in program coordinates.
    pub to: f64,
    /// Where to in machine coordinates.
    pub machine: f64,
}

/// How one parallel axis goes, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slid {
    /// Its letter.
    pub axis: char,
    /// From where.
    pub from: f64,
    /// Where to.
    pub to: f64,
}

/// A thread as the ways of the tool have cut it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threaded {
    /// Whether it was milled; else it was tapped.
    pub milled: bool,
    /// Whether it lies around a stud.
    pub outside: bool,
    /// Whether it is a right-hand thread.
    pub right: bool,
    /// The diameter that the cutting edge reached, mm.
    pub diameter: f64,
    /// The way along the axis in a turn, mm.
    pub pitch: f64,
    /// The end nearer to the spindle, on the axis, in the active coordinate system.
    pub top: DVec3,
    /// The other end.
    pub bottom: DVec3,
    /// Helices, or ways in.
    pub passes: u32,
}

/// What is found about a move in the material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FindingKind {
    /// A move at rapid traverse went through material; the amount is the greatest height of it in mm.
    Rapid,
    /// A tool went through material while the spindle was; the amount as above.
    SpindleStopped,
    /// Material was cut above the cutting edges; the amount is the length that the edges would need, mm.
    EdgesTooShort,
    /// A rotary axis turned while the tool moved: the stock knows where they ended, and not the way between.
    TurnsTogether,
    /// The tool has no radius, so what it removes is not known; the amount is its number.
    NoRadius,
    /// The workpiece turns, and it is no body of revolution about its axis, or was milled before: what an insert removes
    /// is not known to the stock; the amount is the number of the tool.
    Turned,
    /// The workpiece turns, and it is not known how the insert meets it; the amount is the number of the tool.
    InsertUnknown,
    /// A thread is turned, which is no body of revolution; the amount is the number of the tool.
    ThreadTurned,
}

impl FindingKind {
    /// All kinds.
    pub const ALL: [Self; 8] = [
        Self::Rapid,
        Self::SpindleStopped,
        Self::EdgesTooShort,
        Self::TurnsTogether,
        Self::NoRadius,
        Self::Turned,
        Self::InsertUnknown,
        Self::ThreadTurned,
    ];

    /// The word for it in JSON, and in the id of its message (`stock-<word>`).
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Rapid => "rapid-in-material",
            Self::SpindleStopped => "spindle-stopped",
            Self::EdgesTooShort => "edges-too-short",
            Self::TurnsTogether => "turns-together",
            Self::NoRadius => "no-radius",
            Self::Turned => "turned",
            Self::InsertUnknown => "insert-unknown",
            Self::ThreadTurned => "thread-turned",
        }
    }
}

/// The kinds of messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageKind {
    /// Worth knowing.
    Note,
    /// A guard warns.
    Warning,
    /// A guard skips the cycle.
    Skip,
    /// The operator must agree.
    Confirm,
    /// The operator is asked or shown something, and the program waits.
    Question,
    /// The program stops until the operator continues.
    Stop,
}

impl MessageKind {
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Skip => "skip",
            Self::Confirm => "confirm",
            Self::Question => "question",
            Self::Stop => "stop",
        }
    }
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Status {
    /// The program came to its end.
    Done,
    /// It stopped and no one continued it.
    Stopped,
    /// The control would stop with an error, or the program is wrong.
    Error,
    /// A limit of the engine was reached.
    Limit,
    /// The engine cannot do what the program wants.
    Unsupported,
}

impl Status {
    /// The word in JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Stopped => "stopped",
            Self::Error => "error",
            Self::Limit => "limit",
            Self::Unsupported => "unsupported",
        }
    }

    /// The status of that word.
    pub fn by_word(word: &str) -> Option<Self> {
        [Self::Done, Self::Stopped, Self::Error, Self::Limit, Self::Unsupported]
            .into_iter()
            .find(|status| status.as_str() == word)
    }
}

/// What stands for a cycle that nobody describes, where it is defined or called and the run goes on without it.
pub const PASSED_OVER: &str = "CYCL";

/// What happens.
#[derive(Clone, Debug)]
pub enum EventKind {
    /// The tool moves.
    Move {
        /// How.
        kind: MoveKind,
        /// From where, in the active coordinate system.
        from: DVec3,
        /// Where to.
        to: DVec3,
        /// Where to in machine coordinates.
        machine: DVec3,
        /// The feed along the path.
        feed: f64,
        /// The way of the tool tip in machine coordinates; JSON says it by the other members.
        path: Path,
        /// What is turned, in turning.
        turned: Option<OnDiameter>,
    },
    /// Rotary axes turn together.
    Turn {
        /// The axes that turn.
        axes: Vec<Turned>,
        /// The rate of the longest way in degrees/min.
        feed: f64,
        /// Whether at rapid traverse.
        rapid: bool,
        /// Whether at the same time as the move reported before.
        together: bool,
    },
    /// Parallel axes (U, V, W) go together; the tool is not moved by them.
    Slide {
        /// The axes that go.
        axes: Vec<Slid>,
        /// The rate of the longest way in mm/min.
        feed: f64,
        /// Whether at rapid traverse.
        rapid: bool,
        /// Whether at the same time as the movement reported before.
        together: bool,
    },
    /// The program waits.
    Dwell(f64),
    /// The spindle gets a tool, turns (+1 clockwise, -1 counter-clockwise), stops, or is oriented.
    Spindle {
        /// The tool that was called and the tool axis; nothing if the tool stays.
        tool: Option<(Tool, Axis)>,
        /// +1 clockwise (M3), -1 counter-clockwise (M4), 0 stop.
        direction: i8,
        /// The speed, rev/min; 0 while the spindle is stationary.
        speed: f64,
        /// The angle of an orientation; while it turns, where it is when the next move begins, which is in step with it.
        orient: Option<f64>,
    },
    /// From now on the insert of a turning tool meets the workpiece like this, until another tool is called.
    Insert(Insert),
    /// The coolant is switched.
    Coolant(bool),
    /// A block that neither moves the tool nor changes what other events say, as it is written: what goes to the PLC,
    /// how the drives keep the feed; or [`PASSED_OVER`].
    Function(Arc<str>),
    /// The probe moves towards the workpiece.
    Probe(Probing),
    /// A Q parameter changes.
    Set {
        /// The parameter.
        q: QRef,
        /// Its new value.
        value: Content,
    },
    /// The coordinate system changes.
    Transform(Coordinates),
    /// How far the path may deviate: the tolerance of the contour, the filter and the tolerance of rotary axes; nothing
    /// if it is that of the machine.
    Tolerance(Option<[f64; 3]>),
    /// A cell of a table is written.
    Table {
        /// The file.
        file: String,
        /// The row.
        row: f64,
        /// The column.
        column: String,
        /// The new value.
        value: Content,
    },
    /// A log is written.
    Log {
        /// The file; nothing if it is shown on the screen.
        file: Option<String>,
        /// What is written.
        text: String,
    },
    /// A message is shown to the operator.
    Message {
        /// What kind.
        kind: MessageKind,
        /// Its id: of a message or guard of a specification, or `stop`.
        id: Arc<str>,
        /// What the operator said, if he was asked.
        answer: Option<bool>,
    },
    /// A tool does not reach an area of a contour, and leaves material there.
    Left {
        /// Its size, mm².
        area: f64,
        /// The middle of it, on the floor, program coordinates.
        at: DVec3,
    },
    /// A thread was cut.
    Thread(Threaded),
    /// The move before did something in the material that it should not, or that is not known (`engine::stock`).
    Finding {
        /// What.
        kind: FindingKind,
        /// By how much.
        amount: f64,
    },
    /// The program ends with an error.
    Error(Fault),
    /// The run ends.
    End(Status),
}

impl EventKind {
    /// The name of the kind.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Move { .. } => "move",
            Self::Turn { .. } => "turn",
            Self::Slide { .. } => "slide",
            Self::Dwell(_) => "dwell",
            Self::Spindle { .. } => "spindle",
            Self::Insert(_) => "insert",
            Self::Coolant(_) => "coolant",
            Self::Function(_) => "function",
            Self::Probe(_) => "probe",
            Self::Set { .. } => "set",
            Self::Transform(_) => "transform",
            Self::Tolerance(_) => "tolerance",
            Self::Table { .. } => "table",
            Self::Log { .. } => "log",
            Self::Message { .. } => "message",
            Self::Left { .. } => "left",
            Self::Thread(_) => "thread",
            Self::Finding { .. } => "finding",
            Self::Error(_) => "error",
            Self::End(_) => "end",
        }
    }
}
