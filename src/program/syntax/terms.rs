//! The parts that blocks of every kind are made of: operands, axes and coordinates, feeds, tools, movements.
use super::path::Path;
use crate::base::diag::Span;
use crate::base::expr::QRef;

/// Letters of the shortest printed label without a colon, as in `KOT 180`.
pub const SHORTEST_LABEL: usize = 3;

/// Why something cannot be read. Its text is made from a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// The code of the diagnostic.
    pub code: &'static str,
    /// What is there.
    pub span: Span,
    /// A key for what was expected, or the very word in capitals.
    pub expected: &'static str,
}

/// A number or a Q parameter, signed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operand {
    /// Sign included.
    pub span: Span,
    /// Its value.
    pub amount: Amount,
}

/// The value of an operand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// A number.
    Number(f64),
    /// A parameter.
    Q {
        /// Whether a minus precedes it.
        negative: bool,
        /// The parameter.
        q: QRef,
    },
    /// A text in quotation marks, only where a jump compares; its place without them.
    Text(Span),
}

/// Name and unit of `BEGIN PGM` and `END PGM`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The program's name; it may contain blanks.
    pub name: Span,
    /// Whether the unit is INCH, not MM.
    pub inch: bool,
}

/// Axes and polar coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the axis of its letter; Pr and Pa are polar radius and angle")]
pub enum Axis {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,
    Pr,
    Pa,
}

impl Axis {
    /// The axis of an upper-case name, `PR` and `PA` included.
    pub fn by_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"X" => Self::X,
            b"Y" => Self::Y,
            b"Z" => Self::Z,
            b"A" => Self::A,
            b"B" => Self::B,
            b"C" => Self::C,
            b"U" => Self::U,
            b"V" => Self::V,
            b"W" => Self::W,
            b"PR" => Self::Pr,
            b"PA" => Self::Pa,
            _ => return None,
        })
    }

    /// The name as programs print it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
            Self::U => "U",
            Self::V => "V",
            Self::W => "W",
            Self::Pr => "PR",
            Self::Pa => "PA",
        }
    }
}

/// A coordinate: `X+10`, `IX-5`, `PA+Q3`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coord {
    /// The whole word.
    pub span: Span,
    /// The axis.
    pub axis: Axis,
    /// Whether `I` precedes it.
    pub incremental: bool,
    /// Its value: mm (or inch) or degrees.
    pub value: Operand,
}

/// A line of the blank definition.
#[derive(Clone, Debug)]
pub struct BlkForm {
    /// 1 for the minimum point, 2 for the maximum point.
    pub part: u8,
    /// The spindle axis, in part 1.
    pub axis: Option<Axis>,
    /// The corner.
    pub coords: Vec<Coord>,
}

/// A tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToolRef {
    /// A number, with the step after the point if there is one, or a parameter (`Q` or `QS`).
    Number(Operand),
    /// A name, without its quotation marks.
    Name(Span),
}

/// `TOOL CALL`.
#[derive(Clone, Debug)]
pub struct ToolCall {
    /// The tool; none when only speed or feed change.
    pub tool: Option<ToolRef>,
    /// The tool axis.
    pub axis: Option<Axis>,
    /// Spindle speed, rev/min.
    pub speed: Option<Operand>,
    /// Cutting speed in place of the spindle speed, m/min.
    pub cutting_speed: Option<Operand>,
    /// Feed.
    pub feed: Option<Feed>,
    /// Oversize of the length.
    pub dl: Option<Operand>,
    /// Oversize of the radius.
    pub dr: Option<Operand>,
    /// Oversize of the corner radius.
    pub dr2: Option<Operand>,
}

/// `TOOL DEF`.
#[derive(Clone, Debug)]
pub struct ToolDef {
    /// The tool.
    pub tool: ToolRef,
    /// Its length.
    pub length: Option<Operand>,
    /// Its radius.
    pub radius: Option<Operand>,
}

/// A contour element.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Its kind.
    pub path: Path,
    /// The coordinates, in the order written.
    pub coords: Vec<Coord>,
    /// The radius of `CR`, `RND` and free contours, the length of `CHF`; mm (or inch).
    pub radius: Option<Operand>,
    /// The direction of rotation: true for `DR+`, counter-clockwise.
    pub counter_clockwise: Option<bool>,
    /// Radius compensation.
    pub compensation: Option<Compensation>,
    /// Feed.
    pub feed: Option<Feed>,
    /// M functions.
    pub functions: Vec<MFunction>,
    /// What only some paths have: lengths and angles of approaches, what is known of a free contour, vectors.
    pub words: Vec<NamedWord>,
}

impl Motion {
    /// An element without words.
    pub const fn new(path: Path) -> Self {
        Self {
            path,
            coords: Vec::new(),
            radius: None,
            counter_clockwise: None,
            compensation: None,
            feed: None,
            functions: Vec::new(),
            words: Vec::new(),
        }
    }

    /// Makes it one without words that keeps its room.
    pub(super) fn clear(&mut self, path: Path) {
        self.coords.clear();
        self.functions.clear();
        self.words.clear();
        self.path = path;
        self.radius = None;
        self.counter_clockwise = None;
        self.compensation = None;
        self.feed = None;
    }

    /// The coordinate of an axis, the last one if it is written twice.
    pub fn coord(&self, axis: Axis) -> Option<&Coord> {
        self.coords.iter().rev().find(|coord| coord.axis == axis)
    }
}

/// Radius compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compensation {
    /// `R0`: none.
    R0,
    /// `RL`: tool to the left of the contour.
    Rl,
    /// `RR`: tool to the right of the contour.
    Rr,
    /// `R+`: the way along one axis is longer by the tool radius.
    Longer,
    /// `R-`: the way along one axis is shorter by the tool radius.
    Shorter,
}

/// A feed word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feed {
    /// The whole word.
    pub span: Span,
    /// Its value.
    pub kind: FeedKind,
}

/// The value of a feed word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FeedKind {
    /// `F500`: mm/min (or inch/min).
    Value(Operand),
    /// `FMAX`: rapid.
    Max,
    /// `FAUTO`: the feed of the tool call.
    Auto,
    /// `FU`: mm per revolution.
    PerRevolution(Operand),
    /// `FZ`: mm per tooth.
    PerTooth(Operand),
}

/// An M function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MFunction {
    /// The whole word, what belongs to it included (`M140 MB MAX`).
    pub span: Span,
    /// Its number.
    pub number: u16,
    /// What is written after it: `MB MAX`, `LA10`.
    pub with: Option<Span>,
}

/// A parameter of a cycle definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// From `Q` to the end of the value.
    pub span: Span,
    /// The parameter.
    pub q: QRef,
    /// Its place.
    pub q_span: Span,
    /// The value.
    pub value: Value,
    /// The label after `;`, trimmed; absent if there is no `;` or nothing after it.
    pub label: Option<Span>,
}

/// A value as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Its place; empty if it is missing.
    pub span: Span,
    /// What it is.
    pub kind: ValueKind,
}

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ValueKind {
    /// A number.
    Number(f64),
    /// A parameter.
    Q {
        /// Whether a minus precedes it.
        negative: bool,
        /// The parameter.
        q: QRef,
    },
    /// A word such as `FAUTO` or `PREDEF`.
    Word,
    /// A text: its place without the quotation marks.
    Text(Span),
    /// A sign alone, the direction of `X-`: true for minus.
    Sign(bool),
    /// Nothing.
    Missing,
}

/// A word with its value: `SPA+30`, `TURN`, `X+60`, `HEIGHT: +90`, `#5`; of some only the value is printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedWord {
    /// The whole word.
    pub span: Span,
    /// The name as printed, a colon included; empty where there is only a value.
    pub name: Span,
    /// The value.
    pub value: Value,
}
