//! The typed blocks of a program, with the place of everything in them.
//!
//! Invariant: the spans of a program's blocks, line ends included, follow one another and cover
//! its text; nothing here knows what a cycle's number or parameter means.
pub use super::definition::{CallForm, CyclCall, CycleDef, CycleKeyword, OldCycleLine};
use super::element::Element;
pub use super::flow::{CallLbl, FnAssign, FnJump, FnOp, Formula, Label, LabelRef, Relation};
use super::iso::{IsoBlock, IsoKind};
use super::path::Path;
use super::statement::{ContourFormula, GlobalDef, PatternDef, Selection, Statement, TextFormula};
pub use super::terms::*;
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
