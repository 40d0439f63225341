//! The layout of programs: block numbers, columns of cycle definitions, signs of coordinates.
//!
//! Invariant: what a control reads stays the same (`compare` says so); a program that is laid out already is
//! left as it is; nothing knows what a number or label means.
use crate::diag::{Edit, Span};
use crate::syntax::{Block, BlockKind, CallForm, Coord, Dialect, Parameter, Program};

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
    if program.dialect() == Dialect::Iso {
        return iso(program);
    }
    let mut edits = Vec::new();
    let mut next: Option<u32> = None;
    for block in program.blocks() {
        for digits in numbers(program, block) {
            // The first number of the program stays.
            let number = next.or_else(|| program.slice(digits).parse().ok()).unwrap_or(0);
            put(program, digits, &number.to_string(), &mut edits);
            next = Some(number.saturating_add(1));
        }
        match &block.kind {
            BlockKind::CycleDef(cycle) if cycle.errors.is_empty() => {
                columns(program, block, &cycle.parameters.to_vec(), &mut edits)
            }
            BlockKind::Motion(motion) => signs(program, &motion.coords, &mut edits),
            BlockKind::BlkForm(form) => signs(program, &form.coords, &mut edits),
            BlockKind::CyclCall(call) => {
                if let CallForm::Position(coords) = &call.form {
                    signs(program, coords, &mut edits);
                }
            }
            _ => {}
        }
    }
    edits.sort_by_key(|edit| edit.span);
    edits
}

/// The numbers of a DIN/ISO program, each as far behind the one before it as the second is behind the first, and the
/// columns of its cycles. The last block keeps its number.
fn iso(program: &Program) -> Vec<Edit> {
    let mut edits = Vec::new();
    let numbered: Vec<(u32, Span)> = program.blocks().iter().filter_map(|block| number_of(program, block)).collect();
    let step = match numbered.as_slice() {
        [first, second, ..] if second.0 > first.0 && second.0 < LAST_NUMBER => second.0 - first.0,
        _ => ISO_STEP,
    };
    let mut next = numbered.first().map_or(0, |(number, _)| *number);
    for (number, digits) in numbered {
        if number < LAST_NUMBER {
            put(program, digits, &next.to_string(), &mut edits);
            next = next.saturating_add(step).min(LAST_NUMBER - 1);
        }
    }
    for block in program.blocks() {
        if let BlockKind::Iso(own) = &block.kind
            && own.errors.is_empty()
        {
            columns(program, block, &own.parameters, &mut edits);
        }
    }
    edits.sort_by_key(|edit| edit.span);
    edits
}

/// The number behind the `N` of a block, and its digits.
fn number_of(program: &Program, block: &Block) -> Option<(u32, Span)> {
    let number = block.number?;
    let text = program.slice(block.span);
    let rest = text.trim_start_matches([' ', '\t', '/', 'N', 'n']);
    let start = block.span.start + (text.len() - rest.len());
    let length = rest.bytes().take_while(u8::is_ascii_digit).count();
    Some((number, Span::new(start, start + length)))
}

fn put(program: &Program, span: Span, text: &str, edits: &mut Vec<Edit>) {
    if program.slice(span) != text {
        edits.push(Edit { span, text: text.to_owned() });
    }
}

/// The places of the numbers of a block; of a definition whose lines are all numbered, several.
fn numbers(program: &Program, block: &Block) -> Vec<Span> {
    let mut found = Vec::new();
    let mut at = block.span.start;
    for line in program.slice(block.span).split_inclusive(['\n', '\r']) {
        let first = at == block.span.start;
        let counted = if first { block.number.is_some() } else { matches!(block.kind, BlockKind::CycleDef(_)) };
        let digits = line.trim_start_matches([' ', '\t', '/']);
        let start = at + (line.len() - digits.len());
        let length = digits.bytes().take_while(u8::is_ascii_digit).count();
        if counted && length > 0 {
            found.push(Span::new(start, start + length));
        }
        at += line.len();
    }
    found
}

/// Puts parameters, each on its own line, and their comments below each other.
fn columns(program: &Program, block: &Block, parameters: &[Parameter], edits: &mut Vec<Edit>) {
    let width = |span: Span| program.slice(span).chars().count();
    let widest = parameters.iter().map(|parameter| width(parameter.span)).max().unwrap_or(0).max(NARROWEST);
    for parameter in parameters {
        let text = program.source().text();
        let before = text.get(block.span.start..parameter.span.start).unwrap_or_default();
        let blanks = before.len() - before.trim_end_matches([' ', '\t']).len();
        let start = parameter.span.start - blanks;
        if before.trim_end_matches([' ', '\t']).ends_with(['\n', '\r']) {
            put(program, Span::new(start, parameter.span.start), INDENT, edits);
        }
        let behind = text.get(parameter.span.end..block.span.end).unwrap_or_default();
        let gap = behind.len() - behind.trim_start_matches([' ', '\t']).len();
        if behind.get(gap..).is_some_and(|rest| rest.starts_with(';')) {
            let blanks = " ".repeat(widest - width(parameter.span) + 1);
            put(program, Span::new(parameter.span.end, parameter.span.end + gap), &blanks, edits);
        }
    }
}

/// Gives coordinates without a sign their plus.
fn signs(program: &Program, coords: &[Coord], edits: &mut Vec<Edit>) {
    for coord in coords {
        let value = program.slice(coord.value.span);
        if value.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | 'Q' | 'q')) {
            let at = coord.value.span.start;
            edits.push(Edit { span: Span::new(at, at), text: "+".to_owned() });
        }
    }
}
