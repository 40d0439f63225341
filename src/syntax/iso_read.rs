//! The reader of DIN/ISO: from physical lines to blocks.
//!
//! A block is a line; a cycle goes on in the lines behind it that are its Q parameters and have no number of their own, and `~`
//! joins lines as in Klartext. Invariant: the blocks' spans lie one behind the other and cover the text, and each line is
//! looked at a bounded number of times, whatever the text.
use std::sync::Arc;

use super::assemble::{Assembled, FOREIGN};
use super::cursor::{Cursor, Read, trim};
use super::element::Checker;
use super::iso::{IsoBlock, IsoKind, is_of_language, is_path};
use super::lines::{Line, line_at};
use super::statement::NamedWord;
use super::tree::{Axis, Block, BlockKind, Comment, Frame, Parameter, SyntaxError, Value, ValueKind};
use super::words::{from_operand, nameless, opt_value};
use super::{blocks, cycle, motion};
use crate::diag::{Source, Span};

/// The number that the controls give to a program's last block.
const LAST_NUMBER: u32 = 99_999_999;
/// D functions whose words are those of the language; of the others what stands behind the number is kept as it is printed.
const WORDED: std::ops::RangeInclusive<u16> = 0..=14;
/// The code that gives a tool its length and radius.
const TOOL_DEFINITION: f64 = 99.0;
/// The first code that is the number of a cycle.
const FIRST_OF_CYCLES: u16 = 100;

/// The blocks of a text.
pub(super) fn assemble(source: &Arc<Source>) -> Assembled {
    let text = source.text();
    let mut reader = Reader { checker: Some(Checker::new(source)), ..Reader::new(text) };
    while let Some(line) = line_at(text.as_bytes(), reader.at) {
        reader.block(line);
    }
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
}

impl<'t> Reader<'t> {
    const fn new(text: &'t str) -> Self {
        Self { text, checker: None, at: 0, line: 1, blocks: Vec::new(), warnings: Vec::new(), path: None, begun: false }
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

    /// `N10` without a blank behind it is a number, too.
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

    /// Cuts off the `*` that ends the block, before the comment or behind it; whether there was one.
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
                // A comment behind several parameters belongs to none of them.
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
            return Ok(BlockKind::Comment);
        }
        block.kind = self.kind(&block, content)?;
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
            return Ok(IsoKind::Function(number as u16));
        }
        for code in &codes {
            let kind = match code {
                98 => IsoKind::Label,
                99 | 51 => IsoKind::ToolDef,
                30 => IsoKind::Blank(1),
                31 => IsoKind::Blank(2),
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

/// Whether a block is written as in Klartext: its first word is a word, or it assigns a value.
fn is_klartext(cursor: &Cursor<'_>) -> bool {
    let word = cursor.peek_name();
    let mut ahead = *cursor;
    if ahead.opt_q().is_some() || ahead.peek_word().is(b"QC") {
        return true;
    }
    let letters = word.as_bytes();
    letters.len() > 2 && !matches!(letters, b"FMAX" | b"FAUTO") || matches!(letters, b"IF" | b"FN")
}

/// One word, or a text in brackets.
fn word(cursor: &mut Cursor<'_>, block: &mut IsoBlock) -> Read<()> {
    let start = cursor.at;
    if cursor.byte() == b'(' {
        let inside = cursor.text.get(start..cursor.end).unwrap_or_default();
        let length = inside.find(')').ok_or_else(|| cursor.expected("closing-bracket"))?;
        cursor.at = start + length + 1;
        block.remarks.push(Span::new(start, cursor.at));
        return Ok(());
    }
    if let Some(parameter) = opt_parameter(cursor)? {
        block.parameters.push(parameter);
        return Ok(());
    }
    if cursor.opt_mark(b',') {
        let value = from_operand(cursor.operand()?);
        block.words.push(NamedWord {
            span: Span::new(start, value.span.end),
            name: Span::new(start, start + 1),
            value,
        });
        return Ok(());
    }
    if cursor.opt_mark(b':') || ends_before_remark(cursor) {
        return Ok(());
    }
    let letters = cursor.peek_name();
    let name = |length: usize| Span::new(start, start + length);
    let length = match letters.as_bytes() {
        b"M" => {
            block.functions.extend(motion::opt_function(cursor)?);
            return Ok(());
        }
        b"G" => {
            cursor.at = start + 1;
            cursor.blanks();
            let value = code(cursor)?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name: name(1), value });
            if let ValueKind::Number(number) = value.kind
                && number >= f64::from(FIRST_OF_CYCLES)
            {
                block.name = cycle_name(cursor);
            }
            return Ok(());
        }
        b"D" => {
            cursor.at = start + 1;
            let value = code(cursor)?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name: name(1), value });
            let worded = matches!(value.kind, ValueKind::Number(n) if WORDED.contains(&(n as u16)) || matches!(n as u16, 18 | 19 | 29));
            cursor.opt_mark(b':');
            if !worded {
                cursor.blanks();
                let rest = cursor.rest();
                if rest.start < rest.end {
                    block.words.push(nameless(Value { span: rest, kind: ValueKind::Word }));
                }
            }
            return Ok(());
        }
        b"P" => {
            cursor.at = start + 1;
            let digits = cursor.opt_whole().ok_or_else(|| cursor.expected("number"))?;
            let name = Span::new(start, cursor.at);
            let value = if digits > 99 { None } else { entry(cursor)? };
            let value = value.ok_or_else(|| cursor.expected("value"))?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name, value });
            return Ok(());
        }
        b"DR"
            if cursor.byte_at(start + 2) == b'2' && matches!(cursor.byte_at(start + 3), b'+' | b'-' | b'Q' | b'q') =>
        {
            3
        }
        b"DL" | b"DR" | b"ID" | b"NR" => 2,
        b"IDX" => 3,
        b"FMAX" | b"FAUTO" => 1,
        b"PAT" => {
            cursor.at = start + 3;
            let value = Value { span: name(3), kind: ValueKind::Word };
            block.words.push(nameless(value));
            return Ok(());
        }
        [
            b'A' | b'B' | b'C' | b'E' | b'F' | b'H' | b'I' | b'J' | b'K' | b'L' | b'R' | b'S' | b'T' | b'U' | b'V'
            | b'W' | b'X' | b'Y' | b'Z',
        ] => 1,
        _ => {
            // A value alone: the parameter that a D function sets, a name.
            return match opt_value(cursor)? {
                Some(value) => {
                    block.words.push(nameless(value));
                    Ok(())
                }
                None => Err(cursor.expected("word")),
            };
        }
    };
    cursor.at = start + length;
    // Behind a label a comma is no decimal sign: `L1,0`. Behind G99 it is a length.
    let defines = |word: &NamedWord| {
        cursor.byte_at(word.name.start).eq_ignore_ascii_case(&b'G')
            && word.value.kind == ValueKind::Number(TOOL_DEFINITION)
    };
    let calls = letters.is(b"L") && !block.words.iter().any(defines);
    let read = if calls { label(cursor)? } else { opt_value(cursor)? };
    let value = match read {
        Some(value) => value,
        None => bare(cursor, letters.as_bytes())?,
    };
    // Nothing stands directly behind its letter.
    let nothing = Value { span: Span::new(start + length, start + length), ..value };
    let value = if value.kind == ValueKind::Missing { nothing } else { value };
    let end = value.span.end;
    block.words.push(NamedWord { span: Span::new(start, end), name: name(length), value });
    Ok(())
}

/// Passes the `*` that ends a block before a text in brackets.
fn ends_before_remark(cursor: &mut Cursor<'_>) -> bool {
    let mut ahead = *cursor;
    let ends = ahead.opt_mark(b'*') && {
        ahead.blanks();
        ahead.byte() == b'('
    };
    cursor.at = if ends { ahead.at } else { cursor.at };
    ends
}

/// A label: number, name or parameter.
fn label(cursor: &mut Cursor<'_>) -> Read<Option<Value>> {
    cursor.blanks();
    let start = cursor.at;
    match cursor.opt_whole() {
        Some(number) => {
            let span = Span::new(start, cursor.at);
            Ok(Some(Value { span, kind: ValueKind::Number(f64::from(number)) }))
        }
        None => opt_value(cursor),
    }
}

/// What stands behind a letter that is no number: `MAX` and `AUTO` behind a feed, a sign or nothing behind an axis.
fn bare(cursor: &mut Cursor<'_>, letter: &[u8]) -> Read<Value> {
    let start = cursor.at;
    if letter.first() == Some(&b'F') {
        let word = cursor.peek_word();
        if word.is(b"MAX") || word.is(b"AUTO") {
            cursor.at = word.span.end;
            return Ok(Value { span: word.span, kind: ValueKind::Word });
        }
    }
    if Axis::by_name(letter).is_none() {
        return Err(cursor.expected("value"));
    }
    let sign = cursor.byte();
    if matches!(sign, b'+' | b'-') {
        cursor.at += 1;
        return Ok(Value { span: Span::new(start, cursor.at), kind: ValueKind::Sign(sign == b'-') });
    }
    Ok(Value { span: Span::new(start, start), kind: ValueKind::Missing })
}

fn code(cursor: &mut Cursor<'_>) -> Read<Value> {
    let start = cursor.at;
    let number = cursor.opt_whole().filter(|number| *number < 1000).ok_or_else(|| cursor.expected("number"))?;
    Ok(Value { span: Span::new(start, cursor.at), kind: ValueKind::Number(f64::from(number)) })
}

/// The value of `P01`: a number, a parameter, a text, or an axis with a coordinate or a direction.
fn entry(cursor: &mut Cursor<'_>) -> Read<Option<Value>> {
    if let Some(value) = opt_value(cursor)? {
        return Ok(Some(value));
    }
    let start = cursor.at;
    let letter = cursor.peek_name();
    let path = cursor.byte_at(letter.span.end) == b':';
    if Axis::by_name(letter.as_bytes()).is_none() || letter.as_bytes().len() != 1 || path {
        // A path, as it is printed.
        let rest = cursor.bytes.get(start..cursor.end).unwrap_or_default();
        let length = rest.iter().position(|b| b.is_ascii_whitespace() || *b == b'~').unwrap_or(rest.len());
        cursor.at = start + length;
        let begins = rest.first().is_some_and(u8::is_ascii_alphabetic);
        return Ok(begins.then_some(Value { span: Span::new(start, cursor.at), kind: ValueKind::Word }));
    }
    cursor.at = letter.span.end;
    if cursor.opt_operand().is_none() && matches!(cursor.byte(), b'+' | b'-') {
        cursor.at += 1;
    }
    Ok(Some(Value { span: Span::new(start, cursor.at), kind: ValueKind::Word }))
}

/// The name behind the code of a cycle: words up to a parameter or the end of the line.
fn cycle_name(cursor: &mut Cursor<'_>) -> Option<Span> {
    cursor.blanks();
    let rest = cursor.bytes.get(cursor.at..cursor.end).unwrap_or_default();
    let line = rest.iter().position(|b| matches!(b, b'\r' | b'\n' | b'~' | b';' | b'(')).unwrap_or(rest.len());
    // Words of the language, such as `P01 2` or `X+10`, are no name.
    let first = cursor.text.get(cursor.at..cursor.at + line)?.split_whitespace().next()?;
    let letters = first.chars().take_while(|c| c.is_alphabetic() || matches!(c, '-' | '.')).count();
    let short = letters < super::SHORTEST_LABEL;
    let spoken = letters > 0 && !first.contains(['=', '+']) && !(short && first.contains(|c: char| c.is_ascii_digit()));
    if !spoken {
        return None;
    }
    let begins_word = |at: usize| at > 0 && rest.get(at - 1).is_some_and(|b| matches!(b, b' ' | b'\t'));
    let is_parameter = |at: &usize| {
        let mut ahead = Cursor { at: cursor.at + at, ..*cursor };
        begins_word(*at) && ahead.opt_q().is_some() && ahead.opt_mark(b'=')
    };
    let length = (0..line).find(is_parameter).unwrap_or(line);
    let name = trim(cursor.bytes, Span::new(cursor.at, cursor.at + length));
    cursor.at = name.end;
    Some(name)
}

/// `Q200=+2`, if it stands here.
fn opt_parameter(cursor: &mut Cursor<'_>) -> Read<Option<Parameter>> {
    cursor.blanks();
    let start = cursor.at;
    let mut ahead = *cursor;
    let Some(q) = ahead.opt_q() else { return Ok(None) };
    let q_span = Span::new(start, ahead.at);
    if !ahead.opt_mark(b'=') {
        return Ok(None);
    }
    *cursor = ahead;
    let after = cursor.at;
    let missing = Value { span: Span::new(after, after), kind: ValueKind::Missing };
    let value = match opt_value(cursor)? {
        Some(value) => {
            // In `Q201= Q202=5` the first value is missing.
            let mut next = *cursor;
            let is_next = matches!(value.kind, ValueKind::Q { .. }) && next.opt_mark(b'=');
            cursor.at = if is_next { after } else { cursor.at };
            if is_next { missing } else { value }
        }
        None => {
            cursor.blanks();
            let word = cursor.peek_name();
            cursor.at = word.span.end;
            // A feed per turn or per tooth has its number behind the word.
            let feed = matches!(word.as_bytes(), b"FU" | b"FZ") && cursor.opt_operand().is_some();
            let span = Span::new(word.span.start, if feed { cursor.at } else { word.span.end });
            cursor.at = if span.start < span.end { span.end } else { after };
            if span.start < span.end { Value { span, kind: ValueKind::Word } } else { missing }
        }
    };
    Ok(Some(Parameter { span: Span::new(start, value.span.end.max(after)), q, q_span, value, label: None }))
}
