//! Blocks in one spelling.
//!
//! Invariant: two blocks with the same spelling are read alike by a control. A block whose words may be
//! names keeps them as they are; only white space between them is made one.
use std::ops::Range;

use crate::base::diag::Span;
use crate::check::{Against, Facts};
use crate::program::syntax::{
    Block, BlockKind, CycleDef, CycleForm, Element, Frame, Motion, NamedWord, OldCycleLine, Path, Program,
    Statement as Worded, ToolCall, ToolRef, Value, ValueKind,
};

/// Kinds of blocks whose words are all known: they contain no name outside of quotation marks.
const PLAIN: &[&str] = &[
    "blk-form",
    "tool-call",
    "tool-def",
    "l",
    "lp",
    "cc",
    "c",
    "cr",
    "ct",
    "cp",
    "ctp",
    "rnd",
    "chf",
    "m",
    "lbl",
    "call-lbl",
    "fn-assign",
    "fn-jump",
    "formula",
    "string-formula",
    "cycl-call",
    "stop",
];

/// First words of blocks that have numbers and words, but never a name outside of quotation marks.
const NAMELESS: &[&str] = &["PLANE", "TRANS", "LN", "APPR", "DEP", "FL", "FC", "FLT", "FCT", "FPOL", "FSELECT"];

/// What a control reads of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// In one spelling.
    pub text: String,
    /// Where the block is in its program.
    pub span: Span,
    /// Its first physical line, from 1.
    pub line: usize,
    /// How many physical lines it has.
    pub lines: usize,
}

impl Statement {
    fn of(block: &Block, text: &str) -> Self {
        Self { text: text.to_owned(), span: block.span, line: block.line, lines: block.lines }
    }
}

/// The statements of a program, in order. Comments, structure blocks and blank lines are none.
pub fn statements(program: &Program, against: &Against<'_>) -> Vec<Statement> {
    let mut all = Vec::new();
    each(program, against, |block, text| all.push(Statement::of(block, text)));
    all
}

/// Hands over the statements one by one, with their blocks: long programs have millions of them.
pub(super) fn each(program: &Program, against: &Against<'_>, mut take: impl FnMut(&Block, &str)) {
    let mut speller = Speller::new(program, against);
    for block in program.blocks().iter().filter(|block| speaks(block)) {
        speller.block(block);
        take(block, &speller.out);
    }
}

/// The statements in some stretches of all, which follow one another.
pub(super) fn those(program: &Program, against: &Against<'_>, stretches: &[Range<usize>]) -> Vec<Vec<Statement>> {
    let mut all = vec![Vec::new(); stretches.len()];
    if stretches.is_empty() {
        return all;
    }
    let mut speller = Speller::new(program, against);
    let mut wanted = stretches.iter().zip(&mut all).peekable();
    for (at, block) in program.blocks().iter().filter(|block| speaks(block)).enumerate() {
        while wanted.next_if(|(stretch, _)| stretch.end <= at).is_some() {}
        if let Some((stretch, found)) = wanted.peek_mut()
            && stretch.contains(&at)
        {
            speller.block(block);
            found.push(Statement::of(block, &speller.out));
        }
    }
    all
}

fn speaks(block: &Block) -> bool {
    !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

/// Where words of the old form are that name a field, and which.
fn fields(program: &Program, against: &Against<'_>) -> Vec<(usize, usize)> {
    let facts = Facts::unrun(program, against);
    let mut fields = Vec::new();
    for definition in facts.definitions.iter().filter(|own| matches!(own.view.form, CycleForm::Lines(_))) {
        let items = facts.read(definition).items;
        fields.extend(items.iter().filter_map(|item| Some((item.label?.start, item.index?))));
    }
    fields.sort_unstable();
    fields
}

/// Writes one block after the other in one spelling.
struct Speller<'p> {
    program: &'p Program,
    fields: Vec<(usize, usize)>,
    /// The spelling of the block.
    out: String,
    /// Where the tokens of the words begin that are being written.
    tokens: Vec<usize>,
    /// Room for the words of an element.
    motion: Motion,
}

impl<'p> Speller<'p> {
    fn new(program: &'p Program, against: &Against<'_>) -> Self {
        let fields = fields(program, against);
        Self { program, fields, out: String::new(), tokens: Vec::new(), motion: Motion::new(Path::L) }
    }

    fn block(&mut self, block: &Block) {
        self.out.clear();
        if block.skip {
            self.out.push_str("/ ");
        }
        match &block.kind {
            BlockKind::CycleDef(cycle) if cycle.errors.is_empty() => self.definition(cycle),
            BlockKind::OldCycleLine(line) => self.old_line(line),
            BlockKind::Motion(own) => self.element(own),
            BlockKind::ToolCall(call) => self.tool_call(call),
            BlockKind::BeginPgm(frame) => self.frame("BEGIN", frame),
            BlockKind::EndPgm(frame) => self.frame("END", frame),
            BlockKind::CallPgm(name) => {
                self.out.push_str("CALL PGM ");
                close_up(self.program.slice(*name), &mut self.out);
            }
            BlockKind::CallLbl(call) => {
                self.out.push_str("CALL LBL ");
                self.tokens_at(call.label.span);
                if let Some(times) = call.repeat {
                    self.out.push_str(" REP ");
                    self.tokens_at(times.span);
                }
            }
            BlockKind::Statement(own) => self.statement(own),
            // What Klartext has no equivalent of is in a comment.
            BlockKind::Iso(_) => {
                let said = block.comment().unwrap_or_else(|| self.program.content(block));
                close_up(self.program.slice(said), &mut self.out);
            }
            kind => {
                let content = content(self.program, block);
                let first: String = content.chars().take_while(char::is_ascii_alphabetic).collect();
                let plain = PLAIN.contains(&kind.name()) || NAMELESS.contains(&first.to_ascii_uppercase().as_str());
                if plain { self.words(&content) } else { close_up(&content, &mut self.out) }
            }
        }
    }

    /// The first and last block of a program. Its name keeps its letters.
    fn frame(&mut self, word: &str, frame: &Frame) {
        self.out.push_str(word);
        self.out.push_str(" PGM ");
        close_up(self.program.slice(frame.name), &mut self.out);
        self.out.push_str(if frame.inch { " INCH" } else { " MM" });
    }

    /// The words of a contour element in one order; a control reads them in any.
    fn element(&mut self, element: &Element) {
        let mut motion = std::mem::replace(&mut self.motion, Motion::new(Path::L));
        element.read_into(&mut motion);
        // A straight line that only has functions is the block of the functions.
        let bare = motion.path == Path::L
            && motion.coords.is_empty()
            && motion.compensation.is_none()
            && motion.feed.is_none()
            && !motion.functions.is_empty();
        if bare {
            for (at, function) in motion.functions.iter().enumerate() {
                self.out.push_str(if at > 0 { " " } else { "" });
                self.tokens_at(function.span);
            }
        } else {
            self.motion(&motion);
        }
        self.motion = motion;
    }

    fn motion(&mut self, motion: &Motion) {
        self.name(motion.path.name());
        if let Path::Appr(form) | Path::Dep(form) = motion.path {
            self.out.push_str(&format!(" {form:?}"));
        }
        for coord in &motion.coords {
            self.part(coord.span);
        }
        if let Some(radius) = motion.radius {
            self.out.push_str(" R");
            self.part(radius.span);
        }
        for word in &motion.words {
            self.out.push(' ');
            self.named(word);
        }
        if let Some(counter) = motion.counter_clockwise {
            self.out.push_str(if counter { " DR +" } else { " DR -" });
        }
        if let Some(own) = motion.compensation {
            self.out.push(' ');
            self.name(&format!("{own:?}"));
        }
        if let Some(feed) = motion.feed {
            self.part(feed.span);
        }
        for function in &motion.functions {
            self.part(function.span);
        }
    }

    fn tool_call(&mut self, call: &ToolCall) {
        self.out.push_str("TOOL CALL");
        match call.tool {
            Some(ToolRef::Number(number)) => self.part(number.span),
            Some(ToolRef::Name(name)) => {
                self.out.push_str(" \"");
                self.out.push_str(self.program.slice(name));
                self.out.push('"');
            }
            None => {}
        }
        if let Some(axis) = call.axis {
            self.out.push(' ');
            self.out.push_str(axis.name());
        }
        if let Some(feed) = call.feed {
            self.part(feed.span);
        }
        let words =
            [("S", call.speed), ("VC", call.cutting_speed), ("DL", call.dl), ("DR", call.dr), ("DR2", call.dr2)];
        for (name, value) in words {
            if let Some(value) = value {
                self.out.push(' ');
                self.out.push_str(name);
                self.part(value.span);
            }
        }
    }

    fn statement(&mut self, own: &Worded) {
        self.tokens_at(own.head);
        for word in &own.words {
            self.out.push(' ');
            self.named(word);
        }
    }

    fn named(&mut self, word: &NamedWord) {
        self.printed_name(word.name);
        self.out.push(' ');
        self.value(&word.value);
    }

    fn definition(&mut self, cycle: &CycleDef) {
        self.out.push_str(&format!("{} {}", cycle.keyword.as_str(), cycle.number));
        for parameter in &cycle.parameters {
            self.out.push_str(&format!(" {}=", parameter.q));
            self.value(&parameter.value);
        }
    }

    /// A line of the old form; a printed word that is a label gives way to the number of its field.
    fn old_line(&mut self, line: &OldCycleLine) {
        self.out.push_str(&format!("{} {}.{}", line.keyword.as_str(), line.number, line.line));
        for word in &line.words {
            self.out.push(' ');
            let start = word.name.start;
            match self.fields.binary_search_by_key(&start, |(place, _)| *place).ok().and_then(|at| self.fields.get(at))
            {
                Some((_, field)) if start < word.name.end => self.out.push_str(&format!("[{field}] ")),
                _ => self.printed_name(word.name),
            }
            self.value(&word.value);
        }
    }

    fn value(&mut self, value: &Value) {
        let printed = self.program.slice(value.span);
        match value.kind {
            ValueKind::Number(_) | ValueKind::Q { .. } | ValueKind::Sign(_) => self.words(printed),
            ValueKind::Word => {
                let from = self.out.len();
                self.words(printed);
                let word = self.out.get(from..).unwrap_or_default();
                let other = match word {
                    "AUTO" => "FAUTO".to_owned(),
                    "MAX" => "FMAX".to_owned(),
                    word if word.starts_with('F') => return,
                    // A list of labels: `1 /2 /3` is `1/2/3`.
                    list if list.starts_with(|c: char| c.is_ascii_digit()) && printed.contains('/') => {
                        list.replace([' ', '~'], "")
                    }
                    _ => closed_up(printed),
                };
                self.out.truncate(from);
                self.out.push_str(&other);
            }
            ValueKind::Text(_) | ValueKind::Missing => close_up(printed, &mut self.out),
        }
    }

    /// A name with one blank where there were several, in capitals.
    fn printed_name(&mut self, name: Span) {
        let from = self.out.len();
        close_up(self.program.slice(name), &mut self.out);
        if let Some(own) = self.out.get_mut(from..) {
            own.make_ascii_uppercase();
        }
    }

    /// A word of our own in capitals.
    fn name(&mut self, name: &str) {
        self.out.extend(name.chars().map(|c| c.to_ascii_uppercase()));
    }

    /// A blank, and the tokens that are there.
    fn part(&mut self, span: Span) {
        self.out.push(' ');
        self.tokens_at(span);
    }

    fn tokens_at(&mut self, span: Span) {
        self.words(self.program.slice(span));
    }

    /// The text in words, numbers and signs with a blank between any two: words in capitals, numbers without
    /// signs and zeros that say nothing.
    fn words(&mut self, text: &str) {
        self.tokens.clear();
        let mut rest = text;
        while let Some(sign) = rest.chars().next() {
            let length = match sign {
                '"' => rest[1..].find('"').map_or(rest.len(), |at| at + 2),
                c if c.is_ascii_digit() || is_point(rest) => number_length(rest),
                c if c.is_alphabetic() || c == '_' => word_length(rest),
                c => c.len_utf8(),
            };
            let (token, after) = rest.split_at(length.max(1));
            rest = after;
            if sign.is_whitespace() {
                continue;
            }
            let number = sign.is_ascii_digit() || (matches!(sign, '.' | ',') && token.len() > 1);
            if number {
                let (whole, fraction) = canonical(token);
                self.token(whole);
                if !fraction.is_empty() {
                    self.out.push('.');
                    self.out.push_str(fraction);
                }
            } else if sign == '"' || token.bytes().all(|byte| byte.is_ascii() && !byte.is_ascii_lowercase()) {
                self.token(token);
            } else {
                self.token(&token.to_uppercase());
            }
        }
    }

    /// A token that was written, the first one before the last one for 1.
    fn before(&self, by: usize) -> Option<&str> {
        let at = self.tokens.len().checked_sub(by + 1)?;
        let end = self.tokens.get(at + 1).map_or(self.out.len(), |next| next - 1);
        self.out.get(*self.tokens.get(at)?..end)
    }

    /// Adds a token, a number without its fraction. A plus is left out where it is the sign of what follows,
    /// and `F MAX` is `FMAX`.
    fn token(&mut self, token: &str) {
        let is_value = |token: &str| token.starts_with(|c: char| c.is_ascii_digit()) || token.starts_with('Q');
        let operand =
            |token: &str| token.starts_with(|c: char| c.is_ascii_digit() || c == '"') || matches!(token, ")" | "PI");
        let unary = self.before(0) == Some("+") && !self.before(1).is_some_and(operand);
        if unary
            && (is_value(token) || token == "-")
            && let Some(start) = self.tokens.pop()
        {
            // The blank before it goes too, unless it is the first one.
            self.out.truncate(start - usize::from(!self.tokens.is_empty()));
        }
        if self.before(0) == Some("F") && matches!(token, "MAX" | "AUTO") {
            self.out.push_str(token);
            return;
        }
        if !self.tokens.is_empty() {
            self.out.push(' ');
        }
        self.tokens.push(self.out.len());
        self.out.push_str(token);
    }
}

/// The text of a block without skip mark, number, comments and continuation, its lines joined by blanks.
fn content(program: &Program, block: &Block) -> String {
    let remark = program.remark(block).map_or(block.span.end, |remark| remark.start);
    let start = program.content(block).start;
    let mut out = String::new();
    for line in program.slice(Span::new(start, remark.max(start))).split(['\n', '\r']) {
        let rest = without_comment(line).trim_end();
        out.push_str(rest.strip_suffix('~').unwrap_or(rest).trim());
        out.push(' ');
    }
    out.truncate(out.trim_end().len());
    out
}

fn without_comment(line: &str) -> &str {
    let mut quoted = false;
    let at = line.bytes().position(|byte| {
        quoted ^= byte == b'"';
        byte == b';' && !quoted
    });
    line.get(..at.unwrap_or(line.len())).unwrap_or(line)
}

/// The text with one blank where there were several, texts in quotation marks as they are.
fn closed_up(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    close_up(text, &mut out);
    out
}

/// Adds it to what is written already.
fn close_up(text: &str, out: &mut String) {
    let (mut quoted, mut blank) = (false, false);
    for sign in text.trim().chars() {
        quoted ^= sign == '"';
        if sign.is_whitespace() && !quoted {
            blank = true;
            continue;
        }
        if std::mem::take(&mut blank) {
            out.push(' ');
        }
        out.push(sign);
    }
}

fn is_point(text: &str) -> bool {
    let bytes = text.as_bytes();
    matches!(bytes.first(), Some(b'.' | b',')) && bytes.get(1).is_some_and(u8::is_ascii_digit)
}

/// A word goes as far as its letters, but a parameter after an axis is a word of its own: `XQ1`.
fn word_length(text: &str) -> usize {
    let end = text.find(|c: char| !(c.is_alphabetic() || c == '_')).unwrap_or(text.len());
    let (word, after) = text.split_at(end);
    if !after.starts_with(|c: char| c.is_ascii_digit()) {
        return end;
    }
    let before = |name: &&str| {
        let at = end.checked_sub(name.len())?;
        word.get(at..).filter(|own| own.eq_ignore_ascii_case(name)).map(|_| at)
    };
    ["QL", "QR", "QS", "Q"].iter().find_map(before).filter(|at| *at > 0).unwrap_or(end)
}

fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let whole = digits(0);
    match bytes.get(whole) {
        Some(b'.') => whole + 1 + digits(whole + 1),
        // A comma is a decimal sign only between digits.
        Some(b',') if digits(whole + 1) > 0 => whole + 1 + digits(whole + 1),
        _ => whole,
    }
}

/// `007.50` as `7.5`, `,5` as `0.5`, `5.` as `5`: what is before the point and after it.
fn canonical(number: &str) -> (&str, &str) {
    let (whole, fraction) = number.split_once(['.', ',']).unwrap_or((number, ""));
    let (whole, fraction) = (whole.trim_start_matches('0'), fraction.trim_end_matches('0'));
    (if whole.is_empty() { "0" } else { whole }, fraction)
}
