//! The layout of programs: block numbers, columns of cycle definitions, signs of coordinates.
//!
//! Invariant: what a control reads stays the same (`compare` says so); a program that is laid out already is
//! left as it is; nothing knows what a number or label means.
use std::ops::ControlFlow;

use crate::base::diag::{Edit, Span};
use crate::program::syntax::{Block, BlockKind, CallForm, Coord, Dialect, Motion, Parameter, Path, Program};

/// Blanks before a parameter.
const INDENT: &str = "    ";
/// Columns of the shortest assignment, so that most definitions have their labels below each other.
const NARROWEST: usize = 10;
/// How far apart the numbers of DIN/ISO blocks are where a program does not say it.
const ISO_STEP: u32 = 10;
/// The number that the controls give to the last block of a DIN/ISO program.
const LAST_NUMBER: u32 = 99_999_999;

/// What has to change, in the order of the text.
pub fn layout(program: &Program) -> Vec<Edit> {
    let mut edits = Vec::new();
    let _ = each(program, &mut |edit| {
        edits.push(edit);
        ControlFlow::Continue(())
    });
    edits
}

/// Whether nothing has to change.
pub fn is_laid_out(program: &Program) -> bool {
    each(program, &mut |_| ControlFlow::Break(())).is_continue()
}

/// The text of the program as it should be.
pub fn laid_out(program: &Program) -> String {
    let text = program.source().text();
    let (mut out, mut at) = (String::with_capacity(text.len()), 0);
    let _ = each(program, &mut |edit| {
        // Of changes that overlap the first one is made.
        if edit.span.start >= at {
            out.push_str(text.get(at..edit.span.start).unwrap_or_default());
            out.push_str(&edit.text);
            at = edit.span.end;
        }
        ControlFlow::Continue(())
    });
    out.push_str(text.get(at..).unwrap_or_default());
    out
}

/// What is done with a change; the others are not asked for when it breaks.
type Take<'t> = dyn FnMut(Edit) -> ControlFlow<()> + 't;

/// Hands over what has to change, in the order of the text: long programs have millions of changes.
fn each(program: &Program, take: &mut Take<'_>) -> ControlFlow<()> {
    let mut writer = Writer { program, edits: Vec::new() };
    match program.dialect() {
        Dialect::Iso => iso(&mut writer, take),
        Dialect::Klartext => klartext(&mut writer, take),
    }
}

fn klartext(writer: &mut Writer<'_>, take: &mut Take<'_>) -> ControlFlow<()> {
    let program = writer.program;
    let mut words = Motion::new(Path::L);
    let mut next: Option<u32> = None;
    for block in program.blocks() {
        each_number(program, block, |digits| {
            // The first number of the program stays.
            let number = next.or_else(|| program.slice(digits).parse().ok()).unwrap_or(0);
            writer.number(digits, number);
            next = Some(number.saturating_add(1));
        });
        match &block.kind {
            BlockKind::CycleDef(cycle) if cycle.errors.is_empty() => {
                writer.columns(block, &cycle.parameters.to_vec());
            }
            BlockKind::Motion(motion) if motion.outline().has_coords() => {
                motion.read_into(&mut words);
                writer.signs(&words.coords);
            }
            BlockKind::BlkForm(form) => writer.signs(&form.coords),
            BlockKind::CyclCall(call) => {
                if let CallForm::Position(coords) = &call.form {
                    writer.signs(coords);
                }
            }
            _ => {}
        }
        writer.hand_over(take)?;
    }
    ControlFlow::Continue(())
}

/// The numbers of a DIN/ISO program, numbered on with the step between the first two, and the
/// columns of its cycles. The last block keeps its number.
fn iso(writer: &mut Writer<'_>, take: &mut Take<'_>) -> ControlFlow<()> {
    let program = writer.program;
    let counted = |block: &Block| number_of(program, block).filter(|(number, _)| *number < LAST_NUMBER);
    let mut numbered = program.blocks().iter().filter_map(counted);
    let (first, second) = (numbered.next(), numbered.next());
    let step = match (first, second) {
        (Some((first, _)), Some((second, _))) if second > first => second - first,
        _ => ISO_STEP,
    };
    let mut next = first.map_or(0, |(number, _)| number);
    // Numbers that would reach that of the last block stay as they are.
    let others = u32::try_from(numbered.count()).unwrap_or(u32::MAX).saturating_add(1);
    let is_room = next.saturating_add(step.saturating_mul(others)) < LAST_NUMBER;
    for block in program.blocks() {
        if is_room && let Some((_, digits)) = counted(block) {
            writer.number(digits, next);
            next += step;
        }
        if let BlockKind::Iso(own) = &block.kind
            && own.errors.is_empty()
        {
            writer.columns(block, &own.parameters);
        }
        writer.hand_over(take)?;
    }
    ControlFlow::Continue(())
}

/// The number after the `N` of a block, and its digits; nothing if the block does not begin with it.
fn number_of(program: &Program, block: &Block) -> Option<(u32, Span)> {
    let number = block.number?;
    let text = program.slice(block.span);
    let rest = text.trim_start_matches([' ', '\t', '/', 'N', 'n']);
    let start = block.span.start + (text.len() - rest.len());
    let length = rest.bytes().take_while(u8::is_ascii_digit).count();
    // Something else than blanks may be before it.
    (length > 0).then(|| (number, Span::new(start, start + length)))
}

/// Hands over the places of the numbers of a block; of a definition whose lines are all numbered, several. What begins
/// a line of a definition that cannot be read whole may be anything.
fn each_number(program: &Program, block: &Block, mut take: impl FnMut(Span)) {
    let of_lines = matches!(&block.kind, BlockKind::CycleDef(cycle) if cycle.errors.is_empty());
    let mut at = block.span.start;
    for line in program.slice(block.span).split_inclusive(['\n', '\r']) {
        let first = at == block.span.start;
        let counted = if first { block.number.is_some() } else { of_lines };
        if counted {
            let digits = line.trim_start_matches([' ', '\t', '/']);
            let start = at + (line.len() - digits.len());
            let length = digits.bytes().take_while(u8::is_ascii_digit).count();
            // In a definition that goes on, `331=+0` is a torn parameter and no number of a line.
            let after = digits.as_bytes().get(length);
            if length > 0
                && (first || after.is_none_or(|byte| byte.is_ascii_whitespace() || byte.is_ascii_alphabetic()))
            {
                take(Span::new(start, start + length));
            }
        }
        if !of_lines {
            return;
        }
        at += line.len();
    }
}

/// Collects what has to change in a block.
struct Writer<'p> {
    program: &'p Program,
    edits: Vec<Edit>,
}

impl Writer<'_> {
    /// Hands over what was collected, in the order of the text.
    fn hand_over(&mut self, take: &mut Take<'_>) -> ControlFlow<()> {
        self.edits.sort_by_key(|edit| edit.span);
        self.edits.drain(..).try_for_each(take)
    }

    fn put(&mut self, span: Span, text: &str) {
        if self.program.slice(span) != text {
            self.edits.push(Edit { span, text: text.to_owned() });
        }
    }

    /// Replaces a block number where there is one.
    fn number(&mut self, span: Span, number: u32) {
        let written = self.program.slice(span);
        let same = !(written.len() > 1 && written.starts_with('0')) && written.parse() == Ok(number);
        if !same {
            self.put(span, &number.to_string());
        }
    }

    /// Puts parameters, each on its own line, and their comments below each other.
    fn columns(&mut self, block: &Block, parameters: &[Parameter]) {
        let program = self.program;
        let width = |span: Span| program.slice(span).chars().count();
        let widest = parameters.iter().map(|parameter| width(parameter.span)).max().unwrap_or(0).max(NARROWEST);
        for parameter in parameters {
            let text = program.source().text();
            let before = text.get(block.span.start..parameter.span.start).unwrap_or_default();
            let bare = before.trim_end_matches([' ', '\t']);
            let start = parameter.span.start - (before.len() - bare.len());
            if bare.ends_with(['\n', '\r']) {
                self.put(Span::new(start, parameter.span.start), INDENT);
            }
            let after = text.get(parameter.span.end..block.span.end).unwrap_or_default();
            let gap = after.len() - after.trim_start_matches([' ', '\t']).len();
            if after.get(gap..).is_some_and(|rest| rest.starts_with(';')) {
                let blanks = " ".repeat(widest - width(parameter.span) + 1);
                self.put(Span::new(parameter.span.end, parameter.span.end + gap), &blanks);
            }
        }
    }

    /// Gives coordinates without a sign their plus.
    fn signs(&mut self, coords: &[Coord]) {
        for coord in coords {
            let value = self.program.slice(coord.value.span);
            if value.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | 'Q' | 'q')) {
                let at = coord.value.span.start;
                self.edits.push(Edit { span: Span::new(at, at), text: "+".to_owned() });
            }
        }
    }
}
