//! What belongs to a cycle definition: its lines, as far as they go.
//!
//! Invariant: nothing is read here; the reader of a line says what is in it.
use super::definition::Assignment;
use super::lines::Line;
use super::terms::{Parameter, SyntaxError};
use crate::base::diag::Span;

/// A cycle definition in the making.
pub(super) struct CycleBody {
    pub(super) first: Line,
    /// The last line that was taken.
    pub(super) last: Line,
    pub(super) parameters: Vec<Parameter>,
    pub(super) errors: Vec<SyntaxError>,
    pub(super) end: usize,
    pub(super) lines: usize,
    /// Whether its lines are joined by `~`.
    pub(super) tilde: bool,
    /// Whether its parameters have block numbers.
    pub(super) numbered: bool,
    /// Whether all its parameters have blanks before `=`, as simulators print them.
    pub(super) loose: bool,
    /// Whether the last line ends with a comment that goes on.
    pub(super) in_comment: bool,
}

impl CycleBody {
    /// Takes a line and the `lines` counted since the last one.
    pub(super) fn take(&mut self, line: Line, lines: &mut usize) {
        self.in_comment = line.wraps;
        self.last = line;
        self.end = line.next;
        self.lines += std::mem::take(lines);
    }

    /// What a line with a parameter is to the cycle.
    pub(super) fn parameter(&mut self, line: &Line, own: Assignment, label: Option<Span>) -> Role {
        if !self.accepts(line, Some(&own)) {
            return Role::Ends;
        }
        self.loose &= !own.tight;
        let Assignment { span, q, q_span, value, .. } = own;
        Role::Parameter(Parameter { span, q, q_span, value, label })
    }

    /// Whether a line `Qn=…` is a parameter of this cycle and not an assignment after it.
    pub(super) fn accepts(&self, line: &Line, read: Option<&Assignment>) -> bool {
        let tight = read.is_none_or(|assignment| assignment.tight);
        match (line.number.is_some(), self.first.number.is_some()) {
            // Only a listing that numbers every line has numbers here.
            (true, _) => {
                let listing = self.parameters.is_empty() || self.numbered;
                tight && line.comment.is_some() && (self.last.joined || (listing && !self.tilde))
            }
            _ if self.last.joined => true,
            (false, true) => true,
            (false, false) => {
                (tight && (line.comment.is_some() || (!self.tilde && read.is_some())))
                    || (self.loose
                        && !self.tilde
                        && line.comment.is_some()
                        && read.is_some_and(Assignment::is_of_cycle))
            }
        }
    }
}

/// What a line is to the cycle before it.
pub(super) enum Role {
    /// No part of it.
    Ends,
    /// Part of it if more of it follows.
    Between,
    /// A parameter.
    Parameter(Parameter),
    /// A parameter that cannot be read.
    Unreadable(SyntaxError),
    /// Nothing that can be read: part of it if more of it follows.
    Torn(SyntaxError),
    /// A comment of it.
    Comment,
    /// What a comment of it goes on with.
    Text,
}
