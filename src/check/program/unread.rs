//! What a block that cannot be read may do, by how it begins.
//!
//! The one place that says: the word at its beginning says which kind of block it was to be, and such a block can hide
//! no more than a block of its kind does. Invariant: a block of which the kind is not certain may do anything.
use super::blocks::content;
use super::work::Work;
use crate::base::expr::{QKind, QRef};
use crate::program::syntax::{Block, BlockKind, IsoBlock, IsoKind, Program, ValueKind};

/// What a block that cannot be read may do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::check) enum Hides {
    /// A movement or M functions: position, compensation, feed, spindle, a call of the cycle.
    Movement,
    /// A tool: axis, speed, feed, the tool itself.
    Tool,
    /// An assignment to these parameters.
    Assignment(Vec<QRef>),
    /// A machining cycle of the first controls, which only acts when it is called.
    Machining,
    /// Anything.
    Anything,
}

/// What the blocks of a program that cannot be read may do together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unread {
    /// There are movements or M functions among them.
    pub movements: bool,
    /// There are tools among them.
    pub tools: bool,
    /// There are assignments among them.
    pub assignments: bool,
    /// There are some of which no one knows what they do: labels, calls, definitions.
    pub anything: bool,
}

impl Unread {
    /// Whether there is any block that cannot be read.
    pub const fn any(self) -> bool {
        self.movements || self.tools || self.assignments || self.anything
    }

    /// Whether one of them may move the tool.
    pub const fn may_move(self) -> bool {
        self.movements || self.anything
    }

    /// Whether one of them may write to a parameter.
    pub const fn may_assign(self) -> bool {
        self.assignments || self.anything
    }
}

/// The words that begin movements.
const MOVEMENTS: [&str; 18] = [
    "L", "LP", "LN", "C", "CC", "CP", "CR", "CT", "CTP", "RND", "CHF", "APPR", "DEP", "FL", "FLT", "FC", "FCT", "FPOL",
];

/// What a block that cannot be read may do.
pub(in crate::check) fn hides(program: &Program, block: &Block) -> Hides {
    match &block.kind {
        BlockKind::Iso(own) => of_iso(program, own),
        BlockKind::Statement(_) => Hides::Anything,
        _ => of_text(first_line(program, block)),
    }
}

fn of_iso(program: &Program, own: &IsoBlock) -> Hides {
    match own.kind {
        IsoKind::Path(_) | IsoKind::Centre | IsoKind::Chamfer | IsoKind::Rounding | IsoKind::Blend(_) => {
            Hides::Movement
        }
        IsoKind::ToolCall | IsoKind::ToolDef => Hides::Tool,
        IsoKind::Cycle(_) if Work::of_iso(own).is_some() => Hides::Machining,
        IsoKind::Function(0..=8 | 13) => {
            let named = own.words.iter().filter_map(|word| match word.value.kind {
                ValueKind::Q { q, .. } => Some(q),
                ValueKind::Number(number) if program.slice(word.name).eq_ignore_ascii_case("Q") => {
                    (0.0..65536.0).contains(&number).then(|| QRef::q(number as u16))
                }
                _ => None,
            });
            let named: Vec<QRef> = named.collect();
            if named.is_empty() { Hides::Anything } else { Hides::Assignment(named) }
        }
        _ => Hides::Anything,
    }
}

/// What the first line says, without the comment after it.
fn first_line<'p>(program: &'p Program, block: &Block) -> &'p str {
    program.slice(content(program, block)).split(';').next().unwrap_or_default().trim_end()
}

fn of_text(line: &str) -> Hides {
    let (word, rest) = line.split_at(line.bytes().take_while(u8::is_ascii_alphabetic).count());
    // A word that ends in anything else than a blank, a sign or a digit is another one, misspelled.
    let ends = rest.bytes().next().is_none_or(|byte| matches!(byte, b' ' | b'\t' | b'+' | b'-' | b'0'..=b'9'));
    let is = |own: &&str| own.eq_ignore_ascii_case(word);
    if !ends {
        return Hides::Anything;
    }
    if MOVEMENTS.iter().any(&is) {
        // What is misspelled after the word might be a block of its own.
        let other = ["LBL", "CALL", "DEF", "PGM", "GOTO"]
            .iter()
            .any(|own| rest.split_ascii_whitespace().any(|word| own.eq_ignore_ascii_case(word)));
        return if other { Hides::Anything } else { Hides::Movement };
    }
    if is(&"M") && rest.starts_with(|c: char| c.is_ascii_digit()) {
        return Hides::Movement;
    }
    if is(&"TOOL") {
        return Hides::Tool;
    }
    let target = match word.to_ascii_uppercase().as_str() {
        "FN" => assigned_by_function(rest),
        "Q" | "QL" | "QR" | "QS" => Some(line).filter(|line| line.contains('=')),
        _ => None,
    };
    target.and_then(parameter).map_or(Hides::Anything, |q| Hides::Assignment(vec![q]))
}

/// What follows the colon of a function that assigns.
fn assigned_by_function(rest: &str) -> Option<&str> {
    let (number, rest) = rest.split_once(':')?;
    matches!(number.trim().parse(), Ok(0_u32..=8 | 13)).then_some(rest.trim_start())
}

/// The parameter that a text begins with.
fn parameter(text: &str) -> Option<QRef> {
    let (name, rest) = text.split_at(text.bytes().take_while(u8::is_ascii_alphabetic).count());
    let kind = match name.to_ascii_uppercase().as_str() {
        "Q" => QKind::Q,
        "QL" => QKind::Ql,
        "QR" => QKind::Qr,
        "QS" => QKind::Qs,
        _ => return None,
    };
    let digits = rest.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    Some(QRef { kind, number: digits.parse().ok()? })
}

/// Whether a movement or M functions that cannot be read name M2 or M30: the program was to end there.
pub(in crate::check) fn names_end(program: &Program, block: &Block) -> bool {
    let text = first_line(program, block);
    let ends = |word: &str| ["M2", "M02", "M30"].iter().any(|own| own.eq_ignore_ascii_case(word));
    of_text(text) == Hides::Movement && text.split_ascii_whitespace().any(ends)
}
