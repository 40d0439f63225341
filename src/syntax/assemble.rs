//! From physical lines to blocks: joins, cycles of many lines, and what to do with lines that no rule reads.
//!
//! Invariant: the blocks' spans lie one behind the other and cover the text; each line is looked at a
//! bounded number of times, whatever the text.
use super::cursor::{Cursor, Read, trim};
use super::lines::{Line, line_at};
use super::tree::{Block, BlockKind, CycleDef, Parameter, SyntaxError};
use super::{blocks, cycle};
use crate::diag::Span;

/// How many unreadable lines may stand between two parameters of one cycle.
const MAX_TORN: usize = 8;

/// The code of the warning about text behind a tab.
pub(super) const REMARK: &str = "syntax-remark";

/// The blocks of a text, and what was found odd besides unreadable blocks.
pub(super) struct Assembled {
    pub(super) blocks: Vec<Block>,
    pub(super) warnings: Vec<SyntaxError>,
}

pub(super) fn assemble(text: &str) -> Assembled {
    let mut assembler = Assembler { text, at: 0, line: 1, blocks: Vec::new(), warnings: Vec::new() };
    while let Some(line) = line_at(text.as_bytes(), assembler.at) {
        assembler.block(line);
    }
    Assembled { blocks: assembler.blocks, warnings: assembler.warnings }
}

struct Assembler<'t> {
    text: &'t str,
    /// The first byte that belongs to no block yet, and the number of its line.
    at: usize,
    line: usize,
    blocks: Vec<Block>,
    warnings: Vec<SyntaxError>,
}

impl Assembler<'_> {
    fn line_at(&self, at: usize) -> Option<Line> {
        line_at(self.text.as_bytes(), at)
    }

    fn content(&self, span: Span) -> Read<BlockKind> {
        blocks::content(&mut Cursor::new(self.text, span))
    }

    /// Makes the block that starts with `first`.
    fn block(&mut self, first: Line) {
        if first.is_blank() {
            self.empty(first);
        } else if first.is_comment() {
            self.push(&first, first.next, 1, BlockKind::Comment, None);
        } else if cycle::starts_definition(self.text, first.content) {
            self.cycle(first);
        } else {
            self.joined(first);
        }
    }

    fn push(&mut self, first: &Line, end: usize, lines: usize, kind: BlockKind, remark: Option<Span>) {
        if let Some(span) = remark {
            self.warnings.push(SyntaxError { code: REMARK, span, expected: "end" });
        }
        self.blocks.push(Block {
            span: Span::new(first.start, end),
            line: self.line,
            lines,
            number: first.number,
            skip: first.skip,
            comment: first.comment,
            kind,
        });
        self.at = end;
        self.line += lines;
    }

    fn empty(&mut self, first: Line) {
        let (mut end, mut lines) = (first.next, 1);
        while let Some(line) = self.line_at(end).filter(Line::is_blank) {
            end = line.next;
            lines += 1;
        }
        self.push(&first, end, lines, BlockKind::Empty, None);
    }

    /// A block of one line or of several joined by `~`.
    fn joined(&mut self, first: Line) {
        let (last, lines) = self.join(first);
        let mut first = first;
        first.comment = last.comment.or(first.comment);
        let content = Span::new(first.content.start, last.content.end.max(first.content.start));
        let (kind, remark) = self.read(content);
        if last.joined {
            self.dangling(&last);
        }
        let (end, more) = if takes_lines(&kind) { self.own_lines(&first, last.next) } else { (last.next, 0) };
        self.push(&first, end, lines + more, kind, remark);
    }

    /// The last line that `~` joins to `first`, and how many lines there are.
    fn join(&self, first: Line) -> (Line, usize) {
        let (mut last, mut lines) = (first, 1);
        while last.joined {
            match self.after_blanks(last.next) {
                Some((next, blanks)) if next.number.is_none() => {
                    last = next;
                    lines += blanks + 1;
                }
                _ => break,
            }
        }
        (last, lines)
    }

    fn dangling(&mut self, line: &Line) {
        let end = line.comment.map_or(line.content.end, |comment| comment.end);
        // The mark stands behind the comment or before it.
        let behind = |from: usize, to: usize| self.text.get(from..to)?.find('~').map(|at| from + at);
        let mark = behind(end, line.next).or_else(|| behind(line.content.end, end));
        let span = mark.map_or(Span::new(end, end), |mark| Span::new(mark, mark + 1));
        self.warnings.push(SyntaxError { code: "syntax-dangling-continuation", span, expected: "parameter" });
    }

    /// The first line from a byte on that is not blank, and the number of blank ones before it.
    fn after_blanks(&self, mut at: usize) -> Option<(Line, usize)> {
        let mut blanks = 0;
        loop {
            let line = self.line_at(at)?;
            if !line.is_blank() {
                return Some((line, blanks));
            }
            blanks += 1;
            at = line.next;
        }
    }

    /// Reads a block's content; if that fails, once more without what stands behind its last tab.
    fn read(&self, content: Span) -> (BlockKind, Option<Span>) {
        let error = match self.content(content) {
            Ok(kind) => return (kind, None),
            Err(error) => error,
        };
        if let Some((before, remark)) = self.without_remark(content, &error)
            && let Ok(kind) = self.content(before)
        {
            return (kind, Some(remark));
        }
        (BlockKind::Unknown(Box::new(error)), None)
    }

    /// Divides content at the last tab before an error, if a remark in words follows it.
    fn without_remark(&self, content: Span, error: &SyntaxError) -> Option<(Span, Span)> {
        let bytes = self.text.as_bytes();
        let before = bytes.get(content.start..error.span.start.min(content.end))?;
        let tab = content.start + before.iter().rposition(|&b| b == b'\t')?;
        let remark = trim(bytes, Span::new(tab, content.end));
        let words = self.text.get(remark.start..remark.end)?;
        let in_words = words.starts_with(char::is_alphabetic) && words.chars().nth(2).is_some();
        in_words.then(|| (trim(bytes, Span::new(content.start, tab)), remark))
    }

    /// Lines without a number that belong to the block before them: parameters and positions.
    fn own_lines(&self, first: &Line, from: usize) -> (usize, usize) {
        let (mut end, mut lines) = (from, 0);
        let (mut at, mut pending, mut listing) = (from, 0, first.number.is_some());
        while let Some(line) = self.line_at(at).filter(|line| line.number.is_none()) {
            at = line.next;
            pending += 1;
            let parameter =
                cycle::starts_tight_parameter(self.text, line.content) && (listing || line.comment.is_some());
            if parameter || self.is_position(line.content) || self.in_pattern(first, end, line.content) {
                listing |= parameter;
                end = at;
                lines += std::mem::take(&mut pending);
            } else if !(line.is_blank() || (listing && line.is_comment())) {
                break;
            }
        }
        (end, lines)
    }

    /// `POS1(…)` and the other lines of a pattern definition.
    fn is_position(&self, content: Span) -> bool {
        let word = Cursor::new(self.text, content).peek_word();
        matches!(word.as_bytes(), b"POS" | b"ROW" | b"PAT" | b"FRAME" | b"CIRC" | b"PITCHCIRC")
    }

    /// A line of a pattern definition that begins with `(`, or stands between parentheses.
    fn in_pattern(&self, first: &Line, end: usize, content: Span) -> bool {
        let before = self.text.get(first.content.start..end).unwrap_or_default();
        let pattern = before.get(..7).is_some_and(|word| word.eq_ignore_ascii_case("PATTERN"));
        let open = before.matches('(').count() > before.matches(')').count();
        pattern && content.start < content.end && (open || self.text.as_bytes().get(content.start) == Some(&b'('))
    }

    fn cycle(&mut self, first: Line) {
        let (kind, remark) = self.read(first.content);
        let BlockKind::CycleDef(definition) = kind else {
            self.joined(first);
            return;
        };
        let mut body = CycleBody {
            first,
            last: first,
            definition: *definition,
            end: first.next,
            lines: 1,
            tilde: first.joined,
            numbered: false,
        };
        self.parameters(&mut body);
        if body.last.joined {
            self.dangling(&body.last);
        }
        let CycleBody { definition, end, lines, .. } = body;
        self.push(&first, end, lines, BlockKind::CycleDef(Box::new(definition)), remark);
    }

    /// Takes the lines that belong to the cycle, as far as they go.
    fn parameters(&mut self, body: &mut CycleBody) {
        let (mut at, mut lines, mut torn) = (body.end, 0, Vec::new());
        while let Some(line) = self.line_at(at) {
            let role = if line.is_blank() { Role::Between } else { self.role(body, &line, torn.is_empty()) };
            at = line.next;
            lines += 1;
            match role {
                Role::Ends => return,
                Role::Between => {}
                Role::Torn(error) if !body.last.joined && torn.len() < MAX_TORN => torn.push(error),
                Role::Torn(error) if body.last.joined => {
                    body.definition.errors.push(error);
                    body.take(line, &mut lines);
                }
                Role::Torn(_) => return,
                Role::Parameter(parameter) => {
                    body.definition.errors.append(&mut torn);
                    body.definition.parameters.push(parameter);
                    body.numbered |= line.number.is_some();
                    body.tilde |= line.joined;
                    body.take(line, &mut lines);
                }
                Role::Unreadable(error) => {
                    body.definition.errors.append(&mut torn);
                    body.definition.errors.push(error);
                    body.take(line, &mut lines);
                }
                Role::Comment => {
                    body.tilde |= line.joined;
                    body.take(line, &mut lines);
                }
            }
        }
    }

    /// What a line that is not blank is to the cycle before it.
    fn role(&self, body: &mut CycleBody, line: &Line, whole: bool) -> Role {
        if line.is_comment() {
            return self.comment_role(body, line, whole);
        }
        if !cycle::starts_parameter(self.text, line.content) {
            return match self.read(line.content).0 {
                BlockKind::Unknown(error) if line.number.is_none() => Role::Torn(*error),
                _ => Role::Ends,
            };
        }
        let read = self.parameter(line);
        if !body.accepts(line, read.as_ref().ok()) {
            return Role::Ends;
        }
        match read {
            Ok(assignment) => Role::Parameter(Parameter {
                span: assignment.span,
                q: assignment.q,
                q_span: assignment.q_span,
                value: assignment.value,
                label: line.comment.and_then(|comment| cycle::label(self.text, comment)),
            }),
            Err(error) => Role::Unreadable(error),
        }
    }

    fn parameter(&self, line: &Line) -> Read<cycle::Assignment> {
        let read = |span| cycle::parameter(&mut Cursor::new(self.text, span));
        read(line.content).or_else(|error| match self.without_remark(line.content, &error) {
            Some((before, _)) => read(before).map_err(|_| error),
            None => Err(error),
        })
    }

    /// A comment line is the label of the parameter before it if that has none; it stays with the
    /// cycle if it cannot be a block of its own, controls numbering every block.
    fn comment_role(&self, body: &mut CycleBody, line: &Line, whole: bool) -> Role {
        if line.number.is_some() {
            return Role::Ends;
        }
        if !whole {
            return Role::Between;
        }
        let label = line.comment.and_then(|comment| cycle::label(self.text, comment));
        if let Some(last) = body.definition.parameters.last_mut()
            && last.label.is_none()
            && body.last.comment.is_none()
        {
            last.label = label;
            return Role::Comment;
        }
        let directly = body.end == line.start;
        if body.last.joined || (directly && body.first.number.is_some()) { Role::Comment } else { Role::Between }
    }
}

/// Whether lines without a number that look like parameters belong to such a block.
fn takes_lines(kind: &BlockKind) -> bool {
    matches!(kind, BlockKind::Other(_) | BlockKind::Unknown(_))
}

/// A cycle definition in the making.
struct CycleBody {
    first: Line,
    /// The last line that was taken.
    last: Line,
    definition: CycleDef,
    end: usize,
    lines: usize,
    /// Whether its lines are joined by `~`.
    tilde: bool,
    /// Whether its parameters have block numbers.
    numbered: bool,
}

impl CycleBody {
    /// Takes a line and the `lines` counted since the last one.
    fn take(&mut self, line: Line, lines: &mut usize) {
        self.last = line;
        self.end = line.next;
        self.lines += std::mem::take(lines);
    }

    /// Whether a line `Qn=…` is a parameter of this cycle and not an assignment behind it.
    fn accepts(&self, line: &Line, read: Option<&cycle::Assignment>) -> bool {
        let tight = read.is_none_or(|assignment| assignment.tight);
        match (line.number.is_some(), self.first.number.is_some()) {
            // Only a listing that numbers every line has numbers here.
            (true, _) => {
                let listing = self.definition.parameters.is_empty() || self.numbered;
                tight && line.comment.is_some() && (self.last.joined || (listing && !self.tilde))
            }
            _ if self.last.joined => true,
            (false, true) => true,
            (false, false) => tight && (line.comment.is_some() || (!self.tilde && read.is_some())),
        }
    }
}

/// What a line is to the cycle before it.
enum Role {
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
}
