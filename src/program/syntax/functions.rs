//! Functions of the language that not every control has, by the words that they are printed with.
//!
//! Invariant: here is only how a function is called, not which control has it. What every control here has, such as
//! straight lines, labels by number and M functions below 100, has no name.
use std::borrow::Cow;

use super::Program;
use super::definition::CallForm;
use super::flow::Label;
use super::path::{Approach, Path};
use super::statement::{Statement, StatementKind};
use super::terms::{FeedKind, MFunction, ToolRef};
use super::tree::{Block, BlockKind};
use crate::base::diag::Span;
use crate::base::expr::QKind;

/// M functions from here on are the controls' own; machines have the others.
const FIRST_OF_CONTROL: u16 = 100;

/// The names of the functions that a block uses, with their places; a name may come more than once.
pub fn functions(program: &Program, block: &Block) -> Vec<(String, Span)> {
    let mut found = Vec::new();
    let mut name = |name: &str, span: Span| found.push((name.to_owned(), span));
    match &block.kind {
        BlockKind::Statement(statement) => name(&statement_name(program, statement), statement.head),
        BlockKind::Sel(selection) => {
            let what = program.slice(selection.what).to_ascii_uppercase();
            name(&format!("SEL {what}"), selection.what);
        }
        BlockKind::PatternDef(definition) => name("PATTERN DEF", definition.head),
        BlockKind::GlobalDef(definition) => name("GLOBAL DEF", definition.head),
        BlockKind::ContourFormula(formula) => name("QC", formula.target_span),
        BlockKind::TextFormula(formula) => {
            for call in &formula.calls {
                name(&program.slice(call.name).to_ascii_uppercase(), call.name);
            }
        }
        BlockKind::CyclCall(call) => match call.form {
            CallForm::Plain => {}
            CallForm::Pattern => name("CYCL CALL PAT", program.content(block)),
            CallForm::Position(_) => name("CYCL CALL POS", program.content(block)),
        },
        BlockKind::Lbl(label) if matches!(label.target, Label::Name(_)) => name("LBL \"…\"", label.span),
        BlockKind::CallLbl(call) if matches!(call.label.target, Label::Name(_)) => name("LBL \"…\"", call.label.span),
        BlockKind::ToolCall(call) => {
            if let Some(ToolRef::Name(span)) = call.tool {
                name("TOOL CALL \"…\"", span);
            }
            if let Some(speed) = call.cutting_speed {
                name("TOOL CALL VC", speed.span);
            }
        }
        BlockKind::Motion(motion) => {
            if let Some(own) = path_name(motion.path()) {
                name(&own, program.content(block));
            }
            let feed = if motion.outline().has_feed() { motion.words().feed } else { None };
            match feed {
                Some(feed) if matches!(feed.kind, FeedKind::PerRevolution(_)) => name("FU", feed.span),
                Some(feed) if matches!(feed.kind, FeedKind::PerTooth(_)) => name("FZ", feed.span),
                _ => {}
            }
        }
        _ => {}
    }
    for function in m_functions(&block.kind).iter().filter(|function| function.number >= FIRST_OF_CONTROL) {
        name(&format!("M{}", function.number), function.span);
    }
    parameters(program, block, &mut name);
    found
}

fn statement_name(program: &Program, statement: &Statement) -> String {
    match statement.kind {
        StatementKind::Fn(number) => return format!("FN {number}"),
        StatementKind::SetUndefined => return "SET UNDEFINED".to_owned(),
        _ => {}
    }
    let head = program.slice(statement.head).to_ascii_uppercase();
    let mut words: Vec<&str> = head.split_whitespace().collect();
    let first = statement.words.first().map(|word| program.slice(word.span).to_ascii_uppercase());
    // What is reset is the function.
    if let (StatementKind::Function, [_, last @ "RESET"], Some(first)) = (statement.kind, words.as_mut_slice(), &first)
    {
        *last = first;
    }
    words.join(" ")
}

fn path_name(path: Path) -> Option<String> {
    let form = |approach: Approach| format!("{approach:?}").to_ascii_uppercase();
    Some(match path {
        Path::Appr(approach) => format!("APPR {}", form(approach)),
        Path::Dep(approach) => format!("DEP {}", form(approach)),
        Path::Ln | Path::Fl | Path::Flt | Path::Fc | Path::Fct | Path::Fpol | Path::Spl => {
            path.name().to_ascii_uppercase()
        }
        _ => return None,
    })
}

fn m_functions(kind: &BlockKind) -> Cow<'_, [MFunction]> {
    match kind {
        BlockKind::Motion(motion) => Cow::Owned(motion.functions()),
        BlockKind::Functions(functions) | BlockKind::Stop(functions) => Cow::Borrowed(functions),
        BlockKind::CyclCall(call) => Cow::Borrowed(&call.functions),
        _ => Cow::Borrowed(&[]),
    }
}

/// Local, permanent and text parameters, wherever they occur in a block.
fn parameters(program: &Program, block: &Block, name: &mut impl FnMut(&str, Span)) {
    match &block.kind {
        BlockKind::Unknown(_) => {}
        // The names of the parameters belong to the cycle.
        BlockKind::CycleDef(cycle) => {
            cycle.parameters.iter().for_each(|parameter| parameters_in(program, parameter.value.span, name));
        }
        BlockKind::GlobalDef(definition) => {
            definition.parameters.iter().for_each(|parameter| parameters_in(program, parameter.value.span, name));
        }
        _ => parameters_in(program, program.content(block), name),
    }
}

fn parameters_in(program: &Program, content: Span, name: &mut impl FnMut(&str, Span)) {
    let text = program.slice(content);
    let bytes = text.as_bytes();
    let (mut at, mut quoted) = (0, false);
    while let Some(&byte) = bytes.get(at) {
        quoted ^= byte == b'"';
        // A comment or a label goes to the end of its line.
        if byte == b';' && !quoted {
            at += bytes.get(at..).unwrap_or_default().iter().take_while(|b| !matches!(b, b'\n' | b'\r')).count();
            continue;
        }
        let begins = at.checked_sub(1).and_then(|before| bytes.get(before)).is_none_or(|b| !b.is_ascii_alphanumeric());
        let kind = bytes.get(at + 1).and_then(|kind| match kind.to_ascii_uppercase() {
            b'L' => Some(QKind::Ql),
            b'R' => Some(QKind::Qr),
            b'S' => Some(QKind::Qs),
            _ => None,
        });
        let numbered = bytes.get(at + 2).is_some_and(u8::is_ascii_digit);
        if let (true, b'Q' | b'q', Some(kind), true) = (begins && !quoted, byte, kind, numbered) {
            let digits = bytes.get(at + 2..).unwrap_or_default().iter().take_while(|b| b.is_ascii_digit()).count();
            let start = content.start + at;
            name(
                match kind {
                    QKind::Ql => "QL",
                    QKind::Qr => "QR",
                    _ => "QS",
                },
                Span::new(start, start + 2 + digits),
            );
        }
        at += 1;
    }
}
