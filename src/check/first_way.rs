//! What the first way through a program shows of the machining cycles of the first controls, and of the spindle:
//! `early.rs` follows it.
//!
//! Invariant: nothing but what was seen on that way.
use super::program::Work;
use crate::base::diag::Span;

/// A number with its place.
pub(super) type Placed = (f64, Span);

/// The definition of an early cycle; numbers that are not written are missing.
#[derive(Debug)]
pub(super) struct Early {
    pub work: Work,
    /// Its first block.
    pub first: usize,
    pub head: Span,
    /// What it is called: `CYCL DEF 1`, `G83`.
    pub name: String,
    pub clearance: Option<Placed>,
    pub depth: Option<Placed>,
    pub infeed: Option<Placed>,
    pub pitch: Option<Placed>,
    pub feeds: Vec<Placed>,
    /// The sides of a slot or pocket, or the diameter of a round one.
    pub sides: Vec<Placed>,
    /// The radius of the corners of a pocket.
    pub corner: Option<Placed>,
}

/// What the spindle does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Spindle {
    #[default]
    Unknown,
    Started,
    /// It turns counter-clockwise.
    Backwards,
    Stopped,
    /// Another tool was called, and nothing has turned the spindle on since.
    Unstarted,
}

/// A call of an early cycle.
#[derive(Debug)]
pub(super) struct EarlyCall {
    pub span: Span,
    /// Which definition.
    pub early: usize,
    /// The block of the tool call.
    pub tool: Option<usize>,
    pub spindle: Spindle,
    /// From where.
    pub place: [Option<f64>; 3],
}

/// A tool that machines while the spindle turns counter-clockwise.
#[derive(Debug)]
pub(super) struct Backwards {
    /// The block of its call.
    pub tool: usize,
    pub span: Span,
    /// Whether it taps.
    pub taps: bool,
}

/// The first way through a program.
#[derive(Debug, Default)]
pub(super) struct FirstWay {
    pub early: Vec<Early>,
    pub calls: Vec<EarlyCall>,
    /// Which of the definitions are passed.
    pub passed: Vec<bool>,
    pub backwards: Vec<Backwards>,
    /// Whether the end of the program is reached, and everything on the way is known.
    pub complete: bool,
    /// Whether it is the only way, and nothing is passed twice.
    pub only: bool,
    /// Whether another cycle that machines is called.
    pub others: bool,
    /// Whether anything turns the spindle clockwise.
    pub clockwise: bool,
}

impl FirstWay {
    /// The calls with their definitions.
    pub(super) fn called(&self) -> impl Iterator<Item = (&EarlyCall, &Early)> {
        self.calls.iter().filter_map(|call| Some((call, self.early.get(call.early)?)))
    }

    /// The definitions that are passed and never called.
    pub(super) fn uncalled(&self) -> impl Iterator<Item = &Early> {
        let called = |at: usize| self.calls.iter().any(|call| call.early == at);
        let passed = self.early.iter().zip(&self.passed).enumerate().filter(|(_, (_, passed))| **passed);
        passed.filter(move |(at, _)| !called(*at)).map(|(_, (own, _))| own)
    }
}
