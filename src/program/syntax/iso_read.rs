//! The reader of DIN/ISO: from physical lines to blocks.
//!
//! A block is a line; a cycle goes on in the lines after it that are its Q parameters and have no number of their own,
//! and `~` joins lines as in Klartext. Invariant: the blocks' spans follow one another and cover the text, and
//! each line is visited a bounded number of times, whatever the text.
use std::sync::Arc;

use super::assemble::{Assembled, FOREIGN};
use super::cursor::{Cursor, Read, trim};
use super::element::Checker;
use super::iso::{IsoBlock, IsoKind, is_of_language, is_path};
use super::iso_words::{is_klartext, opt_parameter, word};
use super::lines::{LONGEST_BLOCK, Line, line_at, too_long};
use super::terms::{Axis, Frame, NamedWord, Parameter, SyntaxError, ValueKind};
use super::tree::{Block, BlockKind, Comment};
use super::{blocks, cycle, iso_doubts};
use crate::base::diag::{Source, Span};

/// The number that the controls give to a program's last block.
const LAST_NUMBER: u32 = 99_999_999;
/// The last number of a D function.
const LAST_FUNCTION: f64 = 39.0;

/// The blocks of a text.
pub(super) fn assemble(source: &Arc<Source>) -> Assembled {
    let text = source.text();
    let mut reader = Reader { checker: Some(Checker::new(source)), ..Reader::new(text) };
    while let Some(line) = line_at(text.as_bytes(), reader.at) {
        reader.block(line);
    }
    reader.warnings.extend(iso_doubts::without_end(text, &reader.blocks));
    reader.warnings.extend(reader.remark.or_else(|| iso_doubts::remark(&reader.blocks)));
    Assembled { blocks: reader.blocks, warnings: reader.warnings }
}

/// What a block says, without number, end and comment; the joints of its lines stay.
pub(super) fn content_of(text: &str, block: Span) -> Span {
    let reader = Reader::new(text);
    let Some(mut first) = line_at(text.as_bytes(), block.start) else { return Span::new(block.start, block.start) };
    reader.number(&mut first);
    reader.without_end(&mut first);
    let mut last = first;
    while last.next < block.end
        && let Some(mut line) = line_at(text.as_bytes(), last.next)
    {
        reader.without_end(&mut line);
        last = line;
    }
    Span::new(first.content.start, last.content.end.max(first.content.start))
}

struct Reader<'t> {
    text: &'t str,
    /// Checks contour elements of Klartext; not needed where only the parts of lines are looked for.
    checker: Option<Checker<'t>>,
    at: usize,
    line: usize,
    blocks: Vec<Block>,
    warnings: Vec<SyntaxError>,
    /// The code of the motion that acts.
    path: Option<u16>,
    /// Whether the program's first block has been read.
    begun: bool,
    /// The first block that is only a text in brackets.
    remark: Option<SyntaxError>,
}

impl<'t> Reader<'t> {
    const fn new(text: &'t str) -> Self {
        Self {
            text,
            checker: None,
            at: 0,
            line: 1,
            blocks: Vec::new(),
            warnings: Vec::new(),
            path: None,
            begun: false,
            remark: None,
        }
    }

    fn klartext(&mut self, cursor: &mut Cursor<'_>) -> Read<BlockKind> {
        match &mut self.checker {
            Some(checker) => blocks::content(cursor, checker),
            None => Err(cursor.expected("block")),
        }
    }
    fn block(&mut self, mut first: Line) {
        self.number(&mut first);
        if first.is_blank() {
            return self.empty(first);
        }
        let ended = self.without_end(&mut first);
        if first.content.start == first.content.end {
            let kind =
                if first.comment.is_some() || first.number.is_none() { BlockKind::Comment } else { BlockKind::Empty };
            let (start, end) = (first.start, first.next);
            return self.push(&first, Span::new(start, end), 1, kind);
        }
        let alone = self.text.get(first.content.start..first.content.end) == Some("%");
        if alone && first.number.is_none() && first.comment.is_none() {
            // The mark of a transfer, not of the program.
            self.warnings.push(SyntaxError { code: FOREIGN, span: first.content, expected: "block" });
            return self.push(&first, Span::new(first.start, first.next), 1, BlockKind::Comment);
        }
        let (last, lines, ended) = if ended { (first, 1, true) } else { self.join(first) };
        let content = Span::new(first.content.start, last.content.end.max(first.content.start));
        let comment = first.comment;
        let mut kind = match self.content(content, first.number) {
            Ok(kind) => kind,
            Err(error) => BlockKind::Unknown(Box::new(error)),
        };
        let (mut end, mut more) = (last.next, 0);
        if let Some((mut parameters, mut errors)) = parameters_of(&mut kind) {
            if let [parameter] = parameters.as_mut_slice()
                && parameter.label.is_none()
            {
                parameter.label = comment.and_then(|comment| cycle::label(self.text, comment));
            }
            if !ended {
                (end, more) = self.parameters(&first, &last, &mut parameters, &mut errors);
            }
            put_back(&mut kind, parameters, errors);
        }
        first.comment = first.comment.or(last.comment);
        self.push(&first, Span::new(first.start, end), lines + more, kind);
    }

    fn push(&mut self, first: &Line, span: Span, lines: usize, kind: BlockKind) {
        self.blocks.push(Block {
            span,
            line: self.line,
            lines,
            number: first.number,
            skip: first.skip,
            comment: Comment::new(span.start, first.comment),
            kind,
        });
        self.at = span.end;
        self.line += lines;
    }

    fn empty(&mut self, first: Line) {
        let (mut end, mut lines) = (first.next, 1);
        while let Some(line) = line_at(self.text.as_bytes(), end).filter(Line::is_blank) {
            end = line.next;
            lines += 1;
        }
        self.push(&first, Span::new(first.start, end), lines, BlockKind::Empty);
    }

    /// `N10` without a blank after it is a number, too.
    fn number(&self, line: &mut Line) {
        let written = self.text.get(line.content.start..line.content.end).unwrap_or_default();
        let Some(rest) = written.strip_prefix(['N', 'n']).filter(|_| line.number.is_none()) else { return };
        let rest = rest.trim_start_matches([' ', '\t']);
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let Some(number) = rest.get(..digits).and_then(|digits| digits.parse().ok()) else { return };
        line.number = Some(number);
        line.content.start = line.content.end - (rest.len() - digits);
        line.content = trim(self.text.as_bytes(), line.content);
        if !line.skip
            && self.text.as_bytes().get(line.content.start) == Some(&b'/')
            && line.content.start < line.content.end
        {
            line.skip = true;
            line.content.start += 1;
            line.content = trim(self.text.as_bytes(), line.content);
        }
    }

    /// Cuts off the `*` that ends the block, before the comment or after it; whether there was one.
    fn without_end(&self, line: &mut Line) -> bool {
        let bytes = self.text.as_bytes();
        let mut ended = false;
        for part in [Some(&mut line.content), line.comment.as_mut()].into_iter().flatten() {
            if part.end > part.start && bytes.get(part.end - 1) == Some(&b'*') {
                *part = trim(bytes, Span::new(part.start, part.end - 1));
                ended = true;
            }
        }
        ended
    }

    /// The last line that `~` joins to `first`, how many lines there are, and whether the block ends there.
    fn join(&self, first: Line) -> (Line, usize, bool) {
        let (mut last, mut lines, mut ended) = (first, 1, false);
        while last.joined && !ended {
            let next =
                line_at(self.text.as_bytes(), last.next).filter(|next| next.number.is_none() && !next.is_blank());
            let Some(mut next) = next.filter(|next| !cycle::starts_parameter(self.text, next.content)) else { break };
            ended = self.without_end(&mut next);
            last = next;
            lines += 1;
        }
        (last, lines, ended)
    }

    /// Takes the lines of a cycle's parameters.
    fn parameters(
        &self,
        first: &Line,
        last: &Line,
        parameters: &mut Vec<Parameter>,
        errors: &mut Vec<SyntaxError>,
    ) -> (usize, usize) {
        let (mut end, mut lines, mut pending) = (last.next, 0, 0);
        let (mut at, mut before) = (last.next, *last);
        while let Some(mut line) = line_at(self.text.as_bytes(), at).filter(|line| line.number.is_none()) {
            at = line.next;
            pending += 1;
            if line.is_blank() {
                continue;
            }
            let ended = self.without_end(&mut line);
            let unlabelled = before.comment.is_none() && parameters.last().is_some_and(|last| last.label.is_none());
            if line.is_comment() && (unlabelled || before.joined) {
                if let (Some(last), true) = (parameters.last_mut(), unlabelled) {
                    last.label = line.comment.and_then(|comment| cycle::label(self.text, comment));
                }
            } else if cycle::starts_parameter(self.text, line.content)
                && (first.number.is_some()
                    || before.joined
                    || line.comment.is_some()
                    || cycle::starts_tight_parameter(self.text, line.content))
            {
                let count = parameters.len();
                if let Err(error) = self.parameter_line(line, parameters) {
                    parameters.truncate(count);
                    errors.push(error);
                }
                // A comment after several parameters belongs to none of them.
                if let Some([own]) = parameters.get_mut(count..) {
                    own.label = line.comment.and_then(|comment| cycle::label(self.text, comment));
                }
            } else if self.text.get(line.content.start..line.content.end).is_some_and(str::is_empty) && ended {
                // A star on a line of its own ends the block.
            } else {
                break;
            }
            before = line;
            end = at;
            lines += std::mem::take(&mut pending);
            if ended {
                break;
            }
        }
        (end, lines)
    }

    fn parameter_line(&self, line: Line, parameters: &mut Vec<Parameter>) -> Read<()> {
        let mut cursor = Cursor::new(self.text, line.content);
        while !cursor.done() {
            match opt_parameter(&mut cursor)? {
                Some(parameter) => parameters.push(parameter),
                None => return Err(cursor.expected("parameter")),
            }
        }
        Ok(())
    }

    fn content(&mut self, content: Span, number: Option<u32>) -> Read<BlockKind> {
        if content.end - content.start > LONGEST_BLOCK {
            return Err(too_long(self.text, content));
        }
        let mut cursor = Cursor::new(self.text, content);
        cursor.blanks();
        match cursor.byte() {
            b'%' => return self.percent(&mut cursor, number),
            b'*' => return self.klartext(&mut cursor),
            _ => {}
        }
        if is_klartext(&cursor) {
            return self.klartext(&mut cursor);
        }
        let mut block = IsoBlock {
            kind: IsoKind::Modal,
            words: Vec::with_capacity(4),
            functions: Vec::new(),
            name: None,
            parameters: Vec::new(),
            remarks: Vec::new(),
            errors: Vec::new(),
        };
        while !cursor.done() {
            let start = cursor.at;
            word(&mut cursor, &mut block)?;
            // Whatever is read must pass something, or this would never end.
            if cursor.at == start {
                return Err(cursor.expected("word"));
            }
        }
        if block.words.is_empty() && block.parameters.is_empty() && !block.functions.is_empty() {
            return Ok(BlockKind::Functions(block.functions));
        }
        if block.words.is_empty() && block.parameters.is_empty() {
            let remark = |span: Span| SyntaxError { code: "syntax-bracket-comment", span, expected: "block" };
            self.remark = self.remark.or(block.remarks.first().copied().map(remark));
            return Ok(BlockKind::Comment);
        }
        block.kind = self.kind(&block, content)?;
        if let Some(span) = iso_doubts::stray(self.text, &block) {
            return Err(SyntaxError { code: "syntax-unexpected", span, expected: "word" });
        }
        self.warnings.extend(iso_doubts::excluded(self.text, &block));
        Ok(BlockKind::Iso(Box::new(block)))
    }

    /// `%NAME G71`, the call of a program, a selection.
    fn percent(&mut self, cursor: &mut Cursor<'_>, number: Option<u32>) -> Read<BlockKind> {
        let start = cursor.at + 1;
        cursor.at = start;
        let rest = cursor.rest();
        let text = self.text.get(rest.start..rest.end).unwrap_or_default();
        let kind = |kind| {
            let (words, functions, parameters) = (Vec::new(), Vec::new(), Vec::new());
            let (remarks, errors) = (Vec::new(), Vec::new());
            Ok(BlockKind::Iso(Box::new(IsoBlock { kind, words, functions, name: None, parameters, remarks, errors })))
        };
        if text.trim_start().starts_with("<>") {
            return kind(IsoKind::CallSelected);
        }
        if let Some(selection) = text.strip_prefix(':') {
            let length = selection.find(':').ok_or_else(|| cursor.expected("selection"))?;
            let what = Span::new(rest.start + 1, rest.start + 1 + length);
            let mut name = Cursor { at: what.end + 1, end: rest.end, ..*cursor };
            let name = match name.opt_text()? {
                Some(text) => text,
                None => name.rest(),
            };
            return match name.start < name.end {
                true => kind(IsoKind::Select { what, name }),
                false => Err(cursor.expected("name")),
            };
        }
        for (code, inch) in [("G70", true), ("G71", false)] {
            let at = text.len().checked_sub(code.len());
            let Some(at) = at.filter(|&at| text.get(at..).is_some_and(|unit| unit.eq_ignore_ascii_case(code))) else {
                continue;
            };
            let name = trim(self.text.as_bytes(), Span::new(rest.start, rest.start + at));
            let frame = Box::new(Frame { name, inch });
            let last = number == Some(LAST_NUMBER) || self.begun;
            self.begun = true;
            return Ok(if last { BlockKind::EndPgm(frame) } else { BlockKind::BeginPgm(frame) });
        }
        let mut name = Cursor { at: rest.start, end: rest.end, ..*cursor };
        if let Some(text) = name.opt_text()? {
            return Ok(BlockKind::CallPgm(text));
        }
        if rest.start == rest.end { Err(cursor.expected("name")) } else { Ok(BlockKind::CallPgm(rest)) }
    }

    /// Whether coordinates come before `G79`: the block is a movement, and the cycle is called at its end.
    fn comes_after_coordinates(&self, block: &IsoBlock) -> bool {
        let slice = |span: Span| self.text.get(span.start..span.end).unwrap_or_default();
        let calls =
            |word: &NamedWord| word.value.kind == ValueKind::Number(79.0) && slice(word.name).eq_ignore_ascii_case("G");
        let Some(at) = block.words.iter().position(calls) else { return false };
        let position = block.words.get(at).and_then(|word| self.text.as_bytes().get(word.span.end)) == Some(&b':');
        let is_axis = |word: &NamedWord| {
            let name = slice(word.name).to_ascii_uppercase();
            Axis::by_name(name.as_bytes()).is_some() || name == "H"
        };
        !position && block.words.iter().take(at).any(is_axis)
    }

    /// What the words make of a block; keeps the code of a motion.
    fn kind(&mut self, block: &IsoBlock, content: Span) -> Read<IsoKind> {
        let text = self.text;
        let is = |word: &NamedWord, name: &str| {
            text.get(word.name.start..word.name.end).is_some_and(|written| written.eq_ignore_ascii_case(name))
        };
        let code = |word: &NamedWord| match word.value.kind {
            ValueKind::Number(number) if is(word, "G") => Some(number as u16),
            _ => None,
        };
        let codes: Vec<u16> = block.words.iter().filter_map(code).collect();
        let named = |name: &str| block.words.iter().any(|word| is(word, name));
        let path = codes.iter().copied().rev().find(|code| is_path(*code));
        if let Some(function) = block.words.first().filter(|word| is(word, "D"))
            && let ValueKind::Number(number) = function.value.kind
        {
            if number > LAST_FUNCTION {
                let span = function.value.span;
                return Err(SyntaxError { code: "syntax-unexpected", span, expected: "number" });
            }
            return Ok(IsoKind::Function(number as u16));
        }
        for code in &codes {
            let kind = match code {
                98 => IsoKind::Label,
                99 | 51 if !named("T") => {
                    let span = Span::new(content.end, content.end);
                    return Err(SyntaxError { code: "syntax-incomplete", span, expected: "tool" });
                }
                99 | 51 => IsoKind::ToolDef,
                30 => IsoKind::Blank(1),
                31 => IsoKind::Blank(2),
                79 if self.comes_after_coordinates(block) => continue,
                79 => IsoKind::Call,
                24 => IsoKind::Chamfer,
                25 => IsoKind::Rounding,
                26 | 27 => IsoKind::Blend(*code),
                29 => IsoKind::Centre,
                38 => IsoKind::Stop,
                code if !is_of_language(*code) => IsoKind::Cycle(*code),
                _ => continue,
            };
            return Ok(kind);
        }
        if !block.parameters.is_empty() {
            let span = block.parameters.first().map_or(content, |parameter| parameter.span);
            return Err(SyntaxError { code: "syntax-unexpected", span, expected: "block" });
        }
        if named("L") {
            return Ok(IsoKind::CallLabel);
        }
        if named("T") {
            return Ok(IsoKind::ToolCall);
        }
        self.path = path.or(self.path);
        let axis = |word: &&NamedWord| {
            let name = text.get(word.name.start..word.name.end).unwrap_or_default().to_ascii_uppercase();
            Axis::by_name(name.as_bytes()).is_some() || matches!(&*name, "H" | "R" | "F")
        };
        let compensates = codes.iter().any(|code| matches!(code, 40..=44));
        Ok(if path.is_some() || compensates || block.words.iter().any(|word| axis(&word)) {
            IsoKind::Path(self.path)
        } else if ["I", "J", "K"].into_iter().any(named) {
            IsoKind::Centre
        } else if named("S") {
            IsoKind::ToolCall
        } else if codes.len() == block.words.len() {
            IsoKind::Modal
        } else {
            let span = block.words.iter().find(|word| !is(word, "G")).map_or(content, |word| word.span);
            return Err(SyntaxError { code: "syntax-unexpected", span, expected: "word" });
        })
    }
}

/// Takes the list that parameters on lines of their own go to, if a block is a definition.
fn parameters_of(kind: &mut BlockKind) -> Option<(Vec<Parameter>, Vec<SyntaxError>)> {
    use std::mem::take;
    match kind {
        BlockKind::Iso(block) if matches!(block.kind, IsoKind::Cycle(_)) => {
            Some((take(&mut block.parameters), take(&mut block.errors)))
        }
        BlockKind::GlobalDef(own) => Some((take(&mut own.parameters), take(&mut own.errors))),
        BlockKind::CycleDef(own) => Some((own.parameters.to_vec(), take(&mut own.errors))),
        _ => None,
    }
}

/// Puts that list back.
fn put_back(kind: &mut BlockKind, parameters: Vec<Parameter>, errors: Vec<SyntaxError>) {
    match kind {
        BlockKind::Iso(block) => (block.parameters, block.errors) = (parameters, errors),
        BlockKind::GlobalDef(own) => (own.parameters, own.errors) = (parameters, errors),
        BlockKind::CycleDef(own) => (own.parameters, own.errors) = (parameters.as_slice().into(), errors),
        _ => {}
    }
}
