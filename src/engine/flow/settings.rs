//! What a run is given: texts, other programs, and how much it may do.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic};
use crate::engine::plan::Compiled;
use crate::engine::report::envelope::Touching;
use crate::program::syntax::Program;
use crate::spec::{CycleKey, OnControl};

/// Texts that a run needs for logs, in the language of the program.
pub trait Texts {
    /// The text of a message of the locale files.
    ///
    /// # Errors
    /// The message is missing or cannot be formatted.
    fn message(&self, id: &str, args: &[(&str, Arg)]) -> Result<String, Diagnostic>;

    /// The template of a log: the extension of its file and its text.
    fn template(&self, name: &str) -> Option<(String, String)>;
}

/// Texts for runs that write no log: every look-up fails.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTexts;

impl Texts for NoTexts {
    fn message(&self, id: &str, _: &[(&str, Arg)]) -> Result<String, Diagnostic> {
        Err(Diagnostic::global("log-text").arg("reason", id))
    }

    fn template(&self, _: &str) -> Option<(String, String)> {
        None
    }
}

/// Programs that are looked for when they are called.
pub trait Programs {
    /// The program that is called by this [key](program_key), if there is one.
    fn program(&self, key: &str) -> Option<&Program>;
}

/// How much a run may do before it ends with a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Blocks executed.
    pub blocks: u64,
    /// Jumps back, repeats and calls.
    pub jumps: u64,
    /// Nested calls of subprograms and programs.
    pub depth: usize,
    /// Members of one series.
    pub members: u32,
    /// Moves of the tool, also those of cycles.
    pub moves: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { blocks: 10_000_000, jumps: 1_000_000, depth: 19, members: 100_000, moves: 10_000_000 }
    }
}

/// What a run is given next to its program and its scene.
pub(crate) struct Settings<'e> {
    /// Programs that are known by name.
    pub(crate) others: BTreeMap<String, &'e Program>,
    /// Programs that are looked for.
    pub(crate) around: Option<&'e dyn Programs>,
    /// The control.
    pub(crate) on: &'e OnControl,
    pub(crate) texts: &'e dyn Texts,
    pub(crate) limits: Limits,
    /// Whether blocks that begin with `/` are left out.
    pub(crate) skip_blocks: bool,
    /// Whether the envelopes of probing cycles are asked for.
    pub(crate) envelope: bool,
    /// Whether the program goes on where it can: after a cycle that does not come to its end, or that nobody describes.
    pub(crate) after_faults: bool,
    /// What stops the probe.
    pub(crate) touching: Touching,
    /// Other controls, for cycles that the manual of this one only names.
    pub(crate) others_on: Vec<&'e OnControl>,
    /// A cycle of which values are noted.
    pub(crate) watching: Watching<'e>,
}

impl Settings<'_> {
    /// Whether the run only assumes what a machine would find: then it writes no logs and passes over what it does not
    /// know.
    pub(crate) fn only_assumes(&self) -> bool {
        self.touching == Touching::AsExpected
    }
}

/// A cycle with its run, which notes values.
pub(crate) type Watching<'e> = Option<(CycleKey, &'e Compiled)>;
