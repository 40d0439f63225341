//! The typed blocks of a program, with the place of everything in them.
//!
//! Invariant: the spans of a program's blocks, line ends included, follow one another and cover
//! its text; nothing here knows what a cycle's number or parameter means.
pub use super::definition::{CallForm, CyclCall, CycleDef, CycleKeyword, OldCycleLine, Parameter, Value, ValueKind};
use super::element::Element;
pub use super::flow::{CallLbl, FnAssign, FnJump, FnOp, Formula, Label, LabelRef, Relation};
use super::iso::{IsoBlock, IsoKind};
use super::path::Path;
use super::statement::{ContourFormula, GlobalDef, NamedWord, PatternDef, Statement, TextFormula};
use crate::base::diag::Span;
use crate::base::expr::QRef;

/// One block: a line, or several joined by `~` or belonging to one cycle definition.
#[derive(Clone, Debug)]
pub struct Block {
    /// All its physical lines, the last line end included.
    pub span: Span,
    /// Its first physical line, from 1.
    pub line: usize,
    /// How many physical lines it has.
    pub lines: usize,
    /// The printed block number.
    pub number: Option<u32>,
    /// Whether `/` lets the operator skip the block.
    pub skip: bool,
    /// Where its comment is.
    pub(super) comment: Comment,
    /// What it says.
    pub kind: BlockKind,
}

/// The place of a comment, counted from the beginning of its block, packed without padding; empty if
/// there is none.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Comment {
    start: [u8; 4],
    length: [u8; 3],
}

impl Comment {
    /// That of a block that begins at a byte.
    pub(super) fn new(block: usize, comment: Option<Span>) -> Self {
        // A block that is longer than any file of a control has no comment.
        let place = |comment: Span| {
            let start = u32::try_from(comment.start.checked_sub(block)?).ok()?.to_le_bytes();
            let [a, b, c, 0] = u32::try_from(comment.end.checked_sub(comment.start)?).ok()?.to_le_bytes() else {
                return None;
            };
            Some(Self { start, length: [a, b, c] })
        };
        comment.and_then(place).unwrap_or_default()
    }
}

impl Block {
    /// The comment from `;` on, without a `~` at its end; of a cycle, the comment of its first line.
    pub fn comment(&self) -> Option<Span> {
        let Comment { start, length: [a, b, c] } = self.comment;
        let start = self.span.start + u32::from_le_bytes(start) as usize;
        let end = start + u32::from_le_bytes([a, b, c, 0]) as usize;
        (start < end).then(|| Span::new(start, end))
    }

    /// Whether it only rounds the way to a contour or from it: `G26`, `G27`. The block before it says where it ends.
    pub fn is_blend(&self) -> bool {
        matches!(&self.kind, BlockKind::Iso(own) if matches!(own.kind, IsoKind::Blend(_)))
    }

    /// Whether it gives a centre or pole: `CC`, `FPOL`.
    pub fn sets_pole(&self) -> bool {
        matches!(&self.kind, BlockKind::Motion(motion) if matches!(motion.path(), Path::Cc | Path::Fpol))
    }

    /// Whether it ends a subprogram: `LBL 0`.
    pub fn ends_subprogram(&self) -> bool {
        matches!(&self.kind, BlockKind::Lbl(label) if label.target == Label::END)
    }

    /// Whether it cannot be read.
    pub const fn is_unread(&self) -> bool {
        matches!(self.kind, BlockKind::Unknown(_))
    }

    /// The same block, marked as having no comment.
    pub fn without_comment(self) -> Self {
        Self { comment: Comment::default(), ..self }
    }
}

/// What a block says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum BlockKind {
    /// Blank lines, as many as follow each other.
    Empty,
    /// A comment only.
    Comment,
    /// A structure block: `* - text`; the span of the text.
    Structure(Span),
    /// `BEGIN PGM name MM`.
    BeginPgm(Box<Frame>),
    /// `END PGM name MM`.
    EndPgm(Box<Frame>),
    /// `BLK FORM 0.1 …` and `0.2`.
    BlkForm(Box<BlkForm>),
    /// `TOOL CALL`.
    ToolCall(Box<ToolCall>),
    /// `TOOL DEF`.
    ToolDef(Box<ToolDef>),
    /// A contour element or positioning: `L`, `C`, `CC` and so on.
    Motion(Element),
    /// M functions only.
    Functions(Vec<MFunction>),
    /// `LBL`.
    Lbl(Box<LabelRef>),
    /// `CALL LBL`, with or without `REP`.
    CallLbl(Box<CallLbl>),
    /// `CALL PGM`: the name without quotation marks.
    CallPgm(Span),
    /// `SEL TABLE`, `SEL PATTERN` …
    Sel(Box<Selection>),
    /// `FN 0` to `FN 8` and `FN 13`.
    FnAssign(Box<FnAssign>),
    /// `FN 9` to `FN 12`, or the short `IF … GOTO`.
    FnJump(Box<FnJump>),
    /// `Q1 = …` or `QS1 = …`, also `DECLARE STRING`.
    Formula(Box<Formula>),
    /// A cycle definition with Q parameters.
    CycleDef(Box<CycleDef>),
    /// One line of a cycle definition of the old form.
    OldCycleLine(Box<OldCycleLine>),
    /// `CYCL CALL`.
    CyclCall(Box<CyclCall>),
    /// `STOP`, with its M functions.
    Stop(Vec<MFunction>),
    /// A block of words after its name: `PLANE`, `FUNCTION`, `TRANS` …
    Statement(Box<Statement>),
    /// `PATTERN DEF`.
    PatternDef(Box<PatternDef>),
    /// `GLOBAL DEF`.
    GlobalDef(Box<GlobalDef>),
    /// `QC1 = …`.
    ContourFormula(Box<ContourFormula>),
    /// An assignment with functions on texts.
    TextFormula(Box<TextFormula>),
    /// A block of DIN/ISO that Klartext writes in other words.
    Iso(Box<IsoBlock>),
    /// What no rule reads.
    Unknown(Box<SyntaxError>),
}

impl BlockKind {
    /// The name of the kind in machine-readable output.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::Comment => "comment",
            Self::Structure(_) => "structure",
            Self::BeginPgm(_) => "begin-pgm",
            Self::EndPgm(_) => "end-pgm",
            Self::BlkForm(_) => "blk-form",
            Self::ToolCall(_) => "tool-call",
            Self::ToolDef(_) => "tool-def",
            Self::Motion(element) => element.path().name(),
            Self::Functions(_) => "m",
            Self::Lbl(_) => "lbl",
            Self::CallLbl(_) => "call-lbl",
            Self::CallPgm(_) => "call-pgm",
            Self::Sel(_) => "sel",
            Self::FnAssign(_) => "fn-assign",
            Self::FnJump(_) => "fn-jump",
            Self::Formula(formula) => formula_name(formula.target),
            Self::TextFormula(formula) => formula_name(formula.target),
            Self::CycleDef(cycle) => cycle.keyword.kind_name(),
            Self::OldCycleLine(line) => line.keyword.kind_name(),
            Self::CyclCall(_) => "cycl-call",
            Self::Stop(_) => "stop",
            Self::Statement(statement) => statement.kind.name(),
            Self::PatternDef(_) => "pattern-def",
            Self::GlobalDef(_) => "global-def",
            Self::ContourFormula(_) => "contour-formula",
            Self::Iso(block) => block.kind.name(),
            Self::Unknown(_) => "unknown",
        }
    }
}

const fn formula_name(target: QRef) -> &'static str {
    match target.kind {
        crate::base::expr::QKind::Qs => "string-formula",
        _ => "formula",
    }
}

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

/// `SEL TABLE` and its like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// `TABLE`, `PATTERN` …
    pub what: Span,
    /// The name, without quotation marks.
    pub name: Span,
}
