//! Blocks of DIN/ISO programs.
//!
//! They form the same tree as those of Klartext: what both languages write alike is the same kind of block,
//! everything else is a block of words. Invariant: as for Klartext, nothing here knows what a cycle's number or
//! parameter means; the codes of the language itself (motions, planes,
//! labels) are distinguished from those of cycles and no more.
use super::terms::{MFunction, NamedWord, Parameter, SyntaxError};
use crate::base::diag::Span;

/// The language of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// Klartext.
    #[default]
    Klartext,
    /// DIN/ISO.
    Iso,
}

impl Dialect {
    /// The language that the name of a file stands for. It counts where the text leaves it open, and reading takes
    /// nothing else from a name.
    pub fn of_name(name: &str) -> Self {
        let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
        if matches!(extension.as_deref(), Some("i" | "iso")) { Self::Iso } else { Self::Klartext }
    }
}

/// A block of words.
#[derive(Clone, Debug)]
pub struct IsoBlock {
    /// What it is.
    pub kind: IsoKind,
    /// Letters with their values in the order written. After `G`, `D` and `M` the value is the number of the code;
    /// after `P` the number of the parameter belongs to the name.
    pub words: Vec<NamedWord>,
    /// M functions; they are no words.
    pub functions: Vec<MFunction>,
    /// The printed name of a cycle.
    pub name: Option<Span>,
    /// Q parameters of a cycle, in the order written.
    pub parameters: Vec<Parameter>,
    /// Texts in brackets.
    pub remarks: Vec<Span>,
    /// What cannot be read inside of a cycle, at most one for a line.
    pub errors: Vec<SyntaxError>,
}

/// What a block of words is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IsoKind {
    /// A motion, with the code that acts, written here or earlier; nothing if none has been written yet.
    Path(Option<u16>),
    /// `I+20 J+30` alone, or `G29`: centre or pole.
    Centre,
    /// `G24`: chamfer.
    Chamfer,
    /// `G25`: rounding.
    Rounding,
    /// `G26` or `G27`: tangential approach and departure, with the code.
    Blend(u16),
    /// `G30` or `G31`: a corner of the blank, 1 or 2.
    Blank(u8),
    /// `T`: tool, speed.
    ToolCall,
    /// `G99`: tool definition; `G51`: the next tool.
    ToolDef,
    /// `G98 L1`.
    Label,
    /// `L1,0`.
    CallLabel,
    /// `%:TAB: "NAME"` and its like: what is selected, and its name.
    Select {
        /// `TAB`, `PAT`, `CNT`, `PGM`.
        what: Span,
        /// The name, without quotation marks.
        name: Span,
    },
    /// `%<>%`.
    CallSelected,
    /// `D00` to `D39`, with the number.
    Function(u16),
    /// `G79`.
    Call,
    /// A code of a cycle, with its number.
    Cycle(u16),
    /// `G38`.
    Stop,
    /// Modal codes alone: `G90`, `G17`.
    Modal,
}

impl IsoKind {
    /// The name of the kind in machine-readable output: that of the block of Klartext, where there is one.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Path(Some(2 | 3 | 5)) => "c",
            Self::Path(Some(6)) => "ct",
            Self::Path(Some(7)) => "axis",
            Self::Path(Some(10 | 11)) => "lp",
            Self::Path(Some(12 | 13 | 15)) => "cp",
            Self::Path(Some(16)) => "ctp",
            Self::Path(_) => "l",
            Self::Centre => "cc",
            Self::Chamfer => "chf",
            Self::Rounding => "rnd",
            Self::Blend(_) => "iso-blend",
            Self::Blank(_) => "blk-form",
            Self::ToolCall => "tool-call",
            Self::ToolDef => "tool-def",
            Self::Label => "lbl",
            Self::CallLabel => "call-lbl",
            Self::Select { .. } => "sel",
            Self::CallSelected => "call-selected",
            Self::Function(0..=8 | 13) => "fn-assign",
            Self::Function(9..=12) => "fn-jump",
            Self::Function(18) => "sysread",
            Self::Function(_) => "fn",
            Self::Call => "cycl-call",
            Self::Cycle(_) => "iso-cycle",
            Self::Stop => "stop",
            Self::Modal => "iso-modal",
        }
    }
}

/// Codes of the language that are no cycles, in ascending order.
const LANGUAGE: [u16; 38] = [
    0, 1, 2, 3, 5, 6, 7, 10, 11, 12, 13, 15, 16, 17, 18, 19, 20, 24, 25, 26, 27, 29, 30, 31, 38, 40, 41, 42, 43, 44,
    51, 70, 71, 79, 90, 91, 98, 99,
];

/// Codes of cycles of older software, which the controls still read and no manual here describes.
const OLDER: [u16; 13] = [56, 57, 58, 59, 74, 75, 76, 77, 78, 83, 84, 85, 86];

/// Whether a code is that of a cycle of older software.
pub fn is_older(code: u16) -> bool {
    OLDER.contains(&code)
}

/// Whether a code belongs to the language and not to a cycle.
pub const fn is_of_language(code: u16) -> bool {
    let mut at = 0;
    while at < LANGUAGE.len() {
        if LANGUAGE[at] == code {
            return true;
        }
        at += 1;
    }
    false
}

/// Whether a code is that of a motion; it acts until the next one.
pub const fn is_path(code: u16) -> bool {
    matches!(code, 0..=3 | 5..=7 | 10..=13 | 15 | 16)
}

/// Whether a text is a DIN/ISO program: it begins with `%`; a file of that kind may begin with something else, but not
/// with the first block of Klartext.
pub(super) fn is_iso(text: &str, name: &str) -> bool {
    let of_kind = Dialect::of_name(name) == Dialect::Iso;
    let said = |line| {
        let line = str::trim_start(line).trim_start_matches(['N', 'n']);
        line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start()
    };
    let first = text.lines().map(said).find(|line| !line.is_empty() && !line.starts_with(';')).unwrap_or_default();
    let foreign = |line: &&str| line.is_empty() || *line == "%" || line.starts_with(['(', ';']);
    if first.trim_end() == "%" || first.starts_with('(') {
        // Marks of a transfer and sheets of a simulator precede programs of both languages.
        let next = text.lines().map(str::trim).find(|line| !foreign(line)).unwrap_or_default();
        return !is_begin(next.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace()))
            && (first.starts_with('%') || of_kind);
    }
    let klartext = is_begin(first);
    first.starts_with('%') || (of_kind && !klartext)
}

fn is_begin(text: &str) -> bool {
    text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case("BEGIN"))
}
