//! From physical lines to blocks: joins, cycles of many lines, and what to do with lines that no rule reads.
//!
//! Invariant: the blocks' spans follow one another and cover the text; each line is visited a
//! bounded number of times, whatever the text.
use std::cell::RefCell;
use std::sync::Arc;

use super::body::{CycleBody, Role};
use super::cursor::{Cursor, Read, trim};
use super::definition::Assignment;
use super::element::Checker;
use super::flow::Label;
use super::lines::{LONGEST_BLOCK, Line, line_at, too_long};
use super::path::Path;
use super::statement::StatementKind;
use super::terms::{Parameter, SyntaxError};
use super::tree::{Block, BlockKind, Comment};
use super::{blocks, cycle, plain, statements};
use crate::base::diag::{Source, Span};

/// Bytes of a usual block.
const USUAL: usize = 32;

/// How many unreadable lines may be between two parameters of one cycle.
const MAX_TORN: usize = 8;

/// The code of the warning about text after a tab.
pub(super) const REMARK: &str = "syntax-text-after-tab";

/// The code of the warning about a line that only other languages have.
pub(super) const FOREIGN: &str = "syntax-foreign-line";

/// The code of the warning about a block that controls may know and no manual describes.
pub(super) const UNDESCRIBED: &str = "syntax-undescribed";

/// The code of the error about a block that a control could not read, as it says itself.
pub(super) const REFUSED: &str = "syntax-refused-block";

/// What some write for `CYCL`.
const CYCLE: &[u8] = b"CYCLE";

/// The code of the error about a word that is understood, though controls spell it differently or miss it.
pub(super) const SPELLING: &str = "syntax-spelling";

/// The blocks of a text, and what was found odd besides unreadable blocks.
pub(super) struct Assembled {
    pub(super) blocks: Vec<Block>,
    pub(super) warnings: Vec<SyntaxError>,
}

pub(super) fn assemble(source: &Arc<Source>) -> Assembled {
    let text = source.text();
    // Room that is not needed is never touched, and given back.
    let blocks = Vec::with_capacity(text.len() / USUAL);
    let checker = RefCell::new(Checker::new(source));
    let mut assembler = Assembler { text, at: 0, line: 1, blocks, warnings: Vec::new(), checker, room: Vec::new() };
    loop {
        if assembler.plain() {
            continue;
        }
        let Some(line) = line_at(text.as_bytes(), assembler.at) else { break };
        assembler.block(line);
    }
    let mut blocks = assembler.blocks;
    blocks.shrink_to_fit();
    Assembled { blocks, warnings: assembler.warnings }
}

struct Assembler<'t> {
    text: &'t str,
    checker: RefCell<Checker<'t>>,
    /// The first byte that belongs to no block yet, and the number of its line.
    at: usize,
    line: usize,
    blocks: Vec<Block>,
    warnings: Vec<SyntaxError>,
    /// Room for the parameters of a definition.
    room: Vec<Parameter>,
}

impl Assembler<'_> {
    fn line_at(&self, at: usize) -> Option<Line> {
        line_at(self.text.as_bytes(), at)
    }

    fn content(&self, span: Span) -> Read<BlockKind> {
        blocks::content(&mut Cursor::new(self.text, span), &mut self.checker.borrow_mut())
    }

    /// Makes the block of a contour element in the usual words, if the next line is one.
    fn plain(&mut self) -> bool {
        let Some(own) = plain::element(self.text.as_bytes(), self.at) else { return false };
        let Some(element) = self.checker.borrow().plain(&own) else { return false };
        self.blocks.push(Block {
            span: Span::new(self.at, own.next),
            line: self.line,
            lines: 1,
            number: own.number,
            skip: false,
            comment: Comment::default(),
            kind: BlockKind::Motion(element),
        });
        self.at = own.next;
        self.line += 1;
        true
    }

    /// Makes the block that starts with `first`.
    fn block(&mut self, first: Line) {
        if first.is_blank() {
            self.empty(first);
        } else if first.is_comment() {
            self.comment(first);
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
        self.warnings.extend(self.misspelled(first, &kind));
        self.blocks.push(Block {
            span: Span::new(first.start, end),
            line: self.line,
            lines,
            number: first.number,
            skip: first.skip,
            comment: Comment::new(first.start, first.comment),
            kind,
        });
        self.at = end;
        self.line += lines;
    }

    /// A word of a block that is read though controls spell it differently, or have it.
    fn misspelled(&self, first: &Line, kind: &BlockKind) -> Option<SyntaxError> {
        let bytes = self.text.as_bytes();
        let cycle = |head: Span| {
            let word = Span::new(head.start, head.start + CYCLE.len());
            let written = bytes.get(word.start..word.end)?.eq_ignore_ascii_case(CYCLE);
            written.then_some(SyntaxError { code: SPELLING, span: word, expected: "CYCL" })
        };
        match kind {
            BlockKind::CycleDef(definition) => cycle(definition.head),
            BlockKind::OldCycleLine(line) => cycle(line.head),
            BlockKind::CyclCall(call) => cycle(call.head),
            BlockKind::CallLbl(call) if call.repeat.is_none() => {
                let end = first.content.end;
                let bare = bytes.get(call.label.span.end..end).is_some_and(|rest| !rest.is_empty());
                bare.then_some(SyntaxError { code: SPELLING, span: Span::new(end, end), expected: "value" })
            }
            BlockKind::Motion(own)
                if own.path() == Path::Axis && matches!(bytes.get(first.content.start), Some(b'L' | b'l')) =>
            {
                Some(SyntaxError { code: UNDESCRIBED, span: first.content, expected: "block" })
            }
            // A feed word without its value ends the block.
            BlockKind::Motion(_) if matches!(bytes.get(..first.content.end), Some([.., b' ' | b'\t', b'F' | b'f'])) => {
                let end = first.content.end;
                Some(SyntaxError { code: SPELLING, span: Span::new(end, end), expected: "value" })
            }
            BlockKind::Lbl(label) if matches!(label.target, Label::Q(_)) => {
                Some(SyntaxError { code: UNDESCRIBED, span: label.span, expected: "block" })
            }
            BlockKind::Statement(own) if own.kind == StatementKind::CallSelected => {
                let last = self.text.get(own.head.start..own.head.end)?.trim_end();
                let contour = last.get(last.len().checked_sub(7)?..)?.eq_ignore_ascii_case("CONTOUR");
                contour.then_some(SyntaxError { code: UNDESCRIBED, span: own.head, expected: "block" })
            }
            BlockKind::Statement(own) if own.kind == StatementKind::Indirect => {
                Some(SyntaxError { code: UNDESCRIBED, span: first.content, expected: "block" })
            }
            BlockKind::Statement(own) if own.kind == StatementKind::Refused => {
                Some(SyntaxError { code: REFUSED, span: first.content, expected: "block" })
            }
            BlockKind::BeginPgm(frame) | BlockKind::EndPgm(frame) => {
                let unit = trim(bytes, Span::new(frame.name.end, first.content.end.max(frame.name.end)));
                match bytes.get(unit.start..unit.end)? {
                    [] => Some(SyntaxError { code: SPELLING, span: unit, expected: "unit" }),
                    unit_text if unit_text.len() == 2 && unit_text.eq_ignore_ascii_case(b"IN") => {
                        Some(SyntaxError { code: SPELLING, span: unit, expected: "INCH" })
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn empty(&mut self, first: Line) {
        let (mut end, mut lines) = (first.next, 1);
        while let Some(line) = self.line_at(end).filter(Line::is_blank) {
            end = line.next;
            lines += 1;
        }
        self.push(&first, end, lines, BlockKind::Empty, None);
    }

    /// A comment, with the lines that `~` joins to it.
    fn comment(&mut self, first: Line) {
        let (mut last, mut lines) = (first, 1);
        while last.joined
            && let Some(next) = self.line_at(last.next)
            && self.goes_on(&first, &next)
        {
            last = next;
            lines += 1;
        }
        self.push(&first, last.next, lines, BlockKind::Comment, None);
    }

    /// Whether a line continues the text of a comment: where blocks have numbers, the next one begins with its own;
    /// where they have none, a line that is a block is one.
    fn goes_on(&self, first: &Line, next: &Line) -> bool {
        let free = next.number.is_none() && !next.is_blank();
        free && (first.number.is_some()
            || next.is_comment()
            || matches!(self.read(next.content).0, BlockKind::Unknown(_)))
    }

    /// Whether the comment of a block's first line goes on in the next one: an error begins with that line's text.
    fn is_wrapped(&self, first: &Line, kind: &BlockKind) -> bool {
        let BlockKind::Unknown(error) = kind else { return false };
        let (Some(comment), Some((next, _))) = (first.comment, self.after_blanks(first.next)) else { return false };
        let after = self.text.get(comment.end..first.next).is_some_and(|rest| rest.contains('~'));
        let words = self.text.get(next.content.start..next.content.end).unwrap_or_default();
        let in_words = words.chars().take(3).filter(|c| c.is_alphabetic()).count() == 3 || words.contains(' ');
        // In a formula a dash and a word could go on with it.
        let inside = error.code == "syntax-formula" && error.span.start > next.content.start;
        after && in_words && (error.span.start == next.content.start || inside)
    }

    /// A block of one line, that is read already, or of several joined by `~`.
    fn written(&mut self, first: Line, kind: BlockKind, remark: Option<Span>) {
        if first.joined || takes_lines(&kind) {
            return self.joined(first);
        }
        self.push(&first, first.next, 1, kind, remark);
    }

    /// A block of one line or of several joined by `~`.
    fn joined(&mut self, first: Line) {
        let (mut last, mut lines) = self.join(first);
        let mut first = first;
        let written = first;
        first.comment = last.comment.or(first.comment);
        let mut content = Span::new(first.content.start, last.content.end.max(first.content.start));
        let (mut kind, mut remark) = self.read(content);
        if lines > 1 && self.is_wrapped(&written, &kind) {
            (kind, remark) = self.read(written.content);
            first.comment = written.comment;
            // Where blocks have no numbers, a line that is a block is no comment.
            if self.after_blanks(written.next).is_some_and(|(next, _)| !self.goes_on(&written, &next)) {
                (last, lines, content) = (written, 1, written.content);
            }
        }
        self.doubled(&written);
        if last.joined {
            self.dangling(&last);
        }
        if matches!(kind, BlockKind::Unknown(_)) && self.is_foreign(content) {
            self.warnings.push(SyntaxError { code: FOREIGN, span: content, expected: "block" });
            return self.push(&first, last.next, lines, BlockKind::Comment, None);
        }
        if !takes_lines(&kind) {
            return self.push(&first, last.next, lines, kind, remark);
        }
        let (end, more) = self.own_lines(&first, content, last.next);
        // Printed listings break a definition without a mark; its lines are read as one.
        let whole = trim(self.text.as_bytes(), Span::new(content.start, end));
        if more > 0
            && self.is_definition(content)
            && let (kind, None) = self.read(whole)
            && !matches!(kind, BlockKind::Unknown(_))
        {
            return self.push(&first, end, lines + more, kind, None);
        }
        self.push(&first, end, lines + more, kind, remark);
    }

    /// Whether content is what other languages and transfers have: a comment in brackets, or `%` alone; or the number
    /// of a block and nothing after it, as generators number their blank lines.
    fn is_foreign(&self, content: Span) -> bool {
        let text = self.text.get(content.start..content.end).unwrap_or_default();
        text.starts_with('(') || text == "%" || (!text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()))
    }

    /// The last line that `~` joins to `first`, and how many lines there are.
    fn join(&self, first: Line) -> (Line, usize) {
        let (mut last, mut lines) = (first, 1);
        while last.joined {
            match self.after_blanks(last.next) {
                Some((next, blanks)) if next.number.is_none() || self.is_list(&next) => {
                    last = next;
                    lines += blanks + 1;
                }
                _ => break,
            }
        }
        (last, lines)
    }

    /// Whether a line is a part of a list of labels, whose first one looks like the number of a block: `2 /3`.
    fn is_list(&self, line: &Line) -> bool {
        let list = |b: &u8| b.is_ascii_digit() || matches!(b, b' ' | b'\t' | b'/' | b',' | b'~');
        let end = line.content.end.max(line.content.start);
        let written = self.text.as_bytes().get(line.start..end).unwrap_or_default();
        written.contains(&b'/') && written.iter().all(list)
    }

    /// A second `~` before the joint says nothing: a slip, or a line that went lost between them.
    fn doubled(&mut self, line: &Line) {
        if line.twice {
            // The one that is left is the last byte of the comment or, before one, of the content.
            let ends = |own: &Span| self.text.get(own.start..own.end).is_some_and(|text| text.ends_with('~'));
            let Some(own) = line.comment.filter(ends).or(Some(line.content).filter(ends)) else { return };
            let span = Span::new(own.end - 1, own.end);
            self.warnings.push(SyntaxError { code: "syntax-doubled-continuation", span, expected: "parameter" });
        }
    }

    fn dangling(&mut self, line: &Line) {
        let end = line.comment.map_or(line.content.end, |comment| comment.end);
        // The mark is after the comment or before it.
        let after = |from: usize, to: usize| self.text.get(from..to)?.find('~').map(|at| from + at);
        let mark = after(end, line.next).or_else(|| after(line.content.end, end));
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

    /// Reads a block's content; if that fails, once more without what is after its last tab.
    fn read(&self, content: Span) -> (BlockKind, Option<Span>) {
        if content.end - content.start > LONGEST_BLOCK {
            return (BlockKind::Unknown(Box::new(too_long(self.text, content))), None);
        }
        let error = match self.content(content) {
            Ok(kind) => return (kind, None),
            Err(error) => error,
        };
        if let Some(kind) = statements::opt_indirect(self.text, content) {
            return (kind, None);
        }
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
    fn own_lines(&self, first: &Line, content: Span, from: usize) -> (usize, usize) {
        let (mut end, mut lines) = (from, 0);
        let definition = self.is_definition(content);
        let (mut at, mut pending, mut listing) = (from, 0, first.number.is_some());
        let mut open_bracket = definition && self.is_open(content.start, from).unwrap_or_default();
        while let Some(line) = self.line_at(at).filter(|line| line.number.is_none()) {
            at = line.next;
            pending += 1;
            let parameter =
                cycle::starts_tight_parameter(self.text, line.content) && (listing || line.comment.is_some());
            let open = definition && (self.is_part(line.content) || open_bracket);
            let more = open || self.is_position(line.content);
            if parameter || more {
                listing |= parameter;
                open_bracket = definition && self.is_open(end, at).unwrap_or(open_bracket);
                end = at;
                lines += std::mem::take(&mut pending);
            } else if !(line.is_blank() || (listing && line.is_comment())) {
                break;
            }
        }
        (end, lines)
    }

    /// Whether content begins a definition that listings break into lines.
    fn is_definition(&self, content: Span) -> bool {
        let word = Cursor::new(self.text, content).peek_word();
        matches!(word.as_bytes(), b"PATTERN" | b"CONTOUR")
    }

    /// `POS1(…)` and the other lines of a pattern definition.
    fn is_position(&self, content: Span) -> bool {
        let word = Cursor::new(self.text, content).peek_word();
        matches!(word.as_bytes(), b"POS" | b"ROW" | b"PAT" | b"FRAME" | b"CIRC" | b"PITCHCIRC")
    }

    /// `I2 = …` and the other lines of a contour definition, and brackets that begin a line.
    fn is_part(&self, content: Span) -> bool {
        let cursor = Cursor::new(self.text, content);
        let word = cursor.peek_word();
        match word.as_bytes() {
            b"DEPTH" => true,
            b"P" | b"I" => cursor.byte_at(word.span.end).is_ascii_digit(),
            b"" => matches!(cursor.byte(), b'=' | b'('),
            _ => false,
        }
    }

    /// Whether a bracket is open at the end of a part; nothing if it has none.
    fn is_open(&self, start: usize, end: usize) -> Option<bool> {
        let part = self.text.as_bytes().get(start..end).unwrap_or_default();
        part.iter().rev().find(|b| matches!(b, b'(' | b')')).map(|last| *last == b'(')
    }

    fn cycle(&mut self, first: Line) {
        let (mut kind, remark) = self.read(first.content);
        if !matches!(kind, BlockKind::CycleDef(_) | BlockKind::GlobalDef(_)) {
            return self.written(first, kind, remark);
        }
        let mut parameters = std::mem::take(&mut self.room);
        if let BlockKind::CycleDef(definition) = &kind {
            parameters.extend(&definition.parameters);
        }
        let inline = !parameters.is_empty();
        let mut body = CycleBody {
            first,
            last: first,
            parameters,
            errors: Vec::new(),
            end: first.next,
            lines: 1,
            tilde: first.joined || inline,
            numbered: false,
            loose: true,
            in_comment: first.wraps,
        };
        self.doubled(&first);
        self.parameters(&mut body);
        if body.last.joined {
            self.dangling(&body.last);
        }
        let CycleBody { mut parameters, errors, end, lines, .. } = body;
        match &mut kind {
            BlockKind::CycleDef(own) => (own.parameters, own.errors) = (parameters.as_slice().into(), errors),
            // It has the form of a cycle's definition, and is none.
            BlockKind::GlobalDef(own) => (own.parameters, own.errors) = (parameters.clone(), errors),
            _ => {}
        }
        parameters.clear();
        self.room = parameters;
        self.push(&first, end, lines, kind, remark);
    }

    /// Takes the lines that belong to the cycle, as far as they go.
    fn parameters(&mut self, body: &mut CycleBody) {
        let (mut at, mut lines, mut torn) = (body.end, 0, Vec::new());
        loop {
            let (line, role) = match plain::parameter(self.text, at) {
                Some((line, assignment, label)) => (line, body.parameter(&line, assignment, label)),
                // A contour element is no part of a definition.
                None if plain::element(self.text.as_bytes(), at).is_some() => return,
                None => match self.line_at(at) {
                    Some(line) if line.is_blank() => (line, Role::Between),
                    Some(line) => (line, self.role(body, &line, torn.is_empty())),
                    None => return,
                },
            };
            at = line.next;
            lines += 1;
            match role {
                Role::Ends => return,
                Role::Between => {}
                Role::Torn(error) if !body.last.joined && torn.len() < MAX_TORN => torn.push(error),
                Role::Torn(error) if body.last.joined => {
                    body.errors.push(error);
                    body.take(line, &mut lines);
                }
                Role::Torn(_) => return,
                Role::Parameter(parameter) => {
                    self.doubled(&line);
                    body.errors.append(&mut torn);
                    body.parameters.push(parameter);
                    body.numbered |= line.number.is_some();
                    body.tilde |= line.joined;
                    body.take(line, &mut lines);
                }
                Role::Unreadable(error) => {
                    body.errors.append(&mut torn);
                    body.errors.push(error);
                    body.take(line, &mut lines);
                }
                Role::Comment => {
                    body.tilde |= line.joined;
                    body.take(line, &mut lines);
                }
                Role::Text => {
                    body.take(line, &mut lines);
                    body.in_comment = line.joined;
                }
            }
        }
    }

    /// What a line that is not blank is to the cycle before it.
    fn role(&self, body: &mut CycleBody, line: &Line, whole: bool) -> Role {
        if line.is_comment() {
            return self.comment_role(body, line, whole);
        }
        let read = self.parameter(line);
        if read.is_err() && !cycle::starts_parameter(self.text, line.content) {
            // A block, or one that cannot be read.
            if line.number.is_some() {
                return Role::Ends;
            }
            return match self.read(line.content).0 {
                BlockKind::Unknown(_) if body.in_comment && self.is_comment_text(line) => Role::Text,
                BlockKind::Unknown(error) => Role::Torn(*error),
                _ => Role::Ends,
            };
        }
        match read {
            Ok(own) => body.parameter(line, own, line.comment.and_then(|comment| cycle::label(self.text, comment))),
            Err(_) if !body.accepts(line, None) => Role::Ends,
            Err(error) => {
                body.loose = false;
                Role::Unreadable(error)
            }
        }
    }

    /// Whether a line that is no block can be what a comment before it goes on with: words, and no parameter that was
    /// meant to be one.
    fn is_comment_text(&self, line: &Line) -> bool {
        let text = self.text.get(line.content.start..line.content.end).unwrap_or_default();
        let in_words = text.starts_with(|c: char| c.is_alphanumeric() || matches!(c, '(' | '"'));
        let mut cursor = Cursor::new(self.text, line.content);
        let torn = cursor.opt_q().is_some() && {
            cursor.blanks();
            !cursor.byte().is_ascii_alphabetic()
        };
        line.number.is_none() && line.comment.is_none() && in_words && !torn && !text.contains('=')
    }

    fn parameter(&self, line: &Line) -> Read<Assignment> {
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
        if let Some(last) = body.parameters.last_mut()
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

/// Whether lines without a number that look like its parts belong to such a block.
fn takes_lines(kind: &BlockKind) -> bool {
    match kind {
        BlockKind::PatternDef(_) | BlockKind::Unknown(_) => true,
        BlockKind::Statement(statement) => statement.kind == StatementKind::ContourDef,
        _ => false,
    }
}
