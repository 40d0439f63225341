//! Blocks in one spelling.
//!
//! Invariant: two blocks with the same spelling are read alike by a control. A block whose words may be
//! names keeps them as they are; only white space between them is made one.
use std::collections::BTreeMap;

use crate::check::{Against, Facts};
use crate::diag::Span;
use crate::syntax::{
    Block, BlockKind, CycleDef, Motion, NamedWord, OldCycleLine, Path, Program, Statement as Worded, ToolCall, ToolRef,
    Value, ValueKind,
};

/// Kinds of blocks whose words are all known: no name stands in them outside of quotation marks.
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
    /// Where the block stands in its program.
    pub span: Span,
    /// Its first physical line, from 1.
    pub line: usize,
    /// How many physical lines it has.
    pub lines: usize,
}

/// The statements of a program, in order. Comments, structure blocks and blank lines are none.
pub fn statements(program: &Program, against: &Against<'_>) -> Vec<Statement> {
    let facts = Facts::of(program, against);
    let described = facts.readings().flat_map(|definition| definition.items);
    let fields = described.filter_map(|item| Some((item.label?.start, item.index?))).collect();
    let speaks =
        |block: &&Block| !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
    let write = |block: &Block| {
        let text = format!("{}{}", if block.skip { "/ " } else { "" }, spelled(program, block, &fields));
        Statement { text, span: block.span, line: block.line, lines: block.lines }
    };
    program.blocks().iter().filter(speaks).map(write).collect()
}

fn spelled(program: &Program, block: &Block, fields: &BTreeMap<usize, usize>) -> String {
    match &block.kind {
        BlockKind::CycleDef(cycle) if cycle.errors.is_empty() => definition(program, cycle),
        BlockKind::OldCycleLine(line) => old_line(program, line, fields),
        BlockKind::Motion(own) => motion(program, own),
        BlockKind::ToolCall(call) => tool_call(program, call),
        BlockKind::CallLbl(call) => {
            let times =
                call.repeat.map_or(String::new(), |times| format!(" REP {}", tokens(program.slice(times.span))));
            format!("CALL LBL {}{times}", tokens(program.slice(call.label.span)))
        }
        BlockKind::Statement(own) => statement(program, own),
        // What Klartext has no equivalent of stands in a comment.
        BlockKind::Iso(_) => closed_up(program.slice(block.comment().unwrap_or(block.span))),
        kind => {
            let content = content(program, block);
            let first: String = content.chars().take_while(char::is_ascii_alphabetic).collect();
            let plain = PLAIN.contains(&kind.name()) || NAMELESS.contains(&first.to_ascii_uppercase().as_str());
            if plain { tokens(&content) } else { closed_up(&content) }
        }
    }
}

/// The words of a contour element in one order; a control reads them in any.
fn motion(program: &Program, motion: &Motion) -> String {
    let mut parts = vec![motion.path.name().to_ascii_uppercase()];
    if let Path::Appr(form) | Path::Dep(form) = motion.path {
        parts.push(format!("{form:?}"));
    }
    parts.extend(motion.coords.iter().map(|coord| tokens(program.slice(coord.span))));
    parts.extend(motion.radius.map(|radius| format!("R {}", tokens(program.slice(radius.span)))));
    parts.extend(motion.words.iter().map(|word| named(program, word)));
    parts.extend(motion.counter_clockwise.map(|counter| if counter { "DR +" } else { "DR -" }.to_owned()));
    parts.extend(motion.compensation.map(|own| format!("{own:?}").to_ascii_uppercase()));
    parts.extend(motion.feed.map(|feed| tokens(program.slice(feed.span))));
    parts.extend(motion.functions.iter().map(|function| tokens(program.slice(function.span))));
    parts.join(" ")
}

fn tool_call(program: &Program, call: &ToolCall) -> String {
    let mut parts = vec!["TOOL CALL".to_owned()];
    parts.extend(call.tool.map(|tool| match tool {
        ToolRef::Number(number) => tokens(program.slice(number.span)),
        ToolRef::Name(name) => format!("\"{}\"", program.slice(name)),
    }));
    parts.extend(call.axis.map(|axis| axis.name().to_owned()));
    parts.extend(call.feed.map(|feed| tokens(program.slice(feed.span))));
    let words = [("S", call.speed), ("VC", call.cutting_speed), ("DL", call.dl), ("DR", call.dr), ("DR2", call.dr2)];
    for (name, value) in words {
        parts.extend(value.map(|value| format!("{name} {}", tokens(program.slice(value.span)))));
    }
    parts.join(" ")
}

fn statement(program: &Program, own: &Worded) -> String {
    let words = own.words.iter().map(|word| format!(" {}", named(program, word)));
    tokens(program.slice(own.head)) + &words.collect::<String>()
}

fn named(program: &Program, word: &NamedWord) -> String {
    let name = closed_up(program.slice(word.name)).to_ascii_uppercase();
    format!("{name} {}", value(program, &word.value))
}

fn definition(program: &Program, cycle: &CycleDef) -> String {
    let mut text = format!("{} {}", cycle.keyword.as_str(), cycle.number);
    for parameter in &cycle.parameters {
        text.push_str(&format!(" {}={}", parameter.q, value(program, &parameter.value)));
    }
    text
}

/// A line of the old form; a printed word that is a label gives way to the number of its field.
fn old_line(program: &Program, line: &OldCycleLine, fields: &BTreeMap<usize, usize>) -> String {
    let mut text = format!("{} {}.{}", line.keyword.as_str(), line.number, line.line);
    for word in &line.words {
        let name = match fields.get(&word.name.start).filter(|_| word.name.start < word.name.end) {
            Some(field) => format!("[{field}] "),
            None => closed_up(program.slice(word.name)).to_ascii_uppercase(),
        };
        text.push_str(&format!(" {name}{}", value(program, &word.value)));
    }
    text
}

fn value(program: &Program, value: &Value) -> String {
    let printed = program.slice(value.span);
    match value.kind {
        ValueKind::Number(_) | ValueKind::Q { .. } | ValueKind::Sign(_) => tokens(printed),
        ValueKind::Word => match tokens(printed).as_str() {
            "AUTO" => "FAUTO".to_owned(),
            "MAX" => "FMAX".to_owned(),
            word if word.starts_with('F') => word.to_owned(),
            // A list of labels: `1 /2 /3` is `1/2/3`.
            list if list.starts_with(|c: char| c.is_ascii_digit()) && printed.contains('/') => list.replace(' ', ""),
            _ => closed_up(printed),
        },
        ValueKind::Text(_) | ValueKind::Missing => closed_up(printed),
    }
}

/// The text of a block without skip mark, number, comments and continuation, its lines joined by blanks.
fn content(program: &Program, block: &Block) -> String {
    let remark = program.remark(block).map_or(block.span.end, |remark| remark.start);
    let mut out = String::new();
    let text = program.slice(Span::new(block.span.start, remark.max(block.span.start)));
    for (line, first) in text.split(['\n', '\r']).zip(std::iter::once(true).chain(std::iter::repeat(false))) {
        let mut rest = line.trim();
        if first {
            rest = rest.trim_start_matches('/').trim_start();
            if block.number.is_some() {
                rest =
                    rest.trim_start_matches(['N', 'n']).trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
            }
            rest = rest.trim_start_matches('/');
        }
        let rest = without_comment(rest).trim_end();
        let rest = rest.strip_suffix('~').unwrap_or(rest);
        out.push_str(rest.trim());
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
    out
}

/// The text in words, numbers and signs with a blank between any two: words in capitals, numbers without
/// signs and zeros that say nothing.
fn tokens(text: &str) -> String {
    let mut all: Vec<String> = Vec::new();
    let mut rest = text;
    while let Some(sign) = rest.chars().next() {
        let length = match sign {
            '"' => rest[1..].find('"').map_or(rest.len(), |at| at + 2),
            c if c.is_ascii_digit() || is_point(rest) => number_length(rest),
            c if c.is_alphabetic() || c == '_' => word_length(rest),
            c => c.len_utf8(),
        };
        let (token, behind) = rest.split_at(length.max(1));
        rest = behind;
        if sign.is_whitespace() {
            continue;
        }
        let number = sign.is_ascii_digit() || (matches!(sign, '.' | ',') && token.len() > 1);
        push(
            &mut all,
            if number {
                canonical(token)
            } else if sign == '"' {
                token.to_owned()
            } else {
                token.to_uppercase()
            },
        );
    }
    all.join(" ")
}

fn is_point(text: &str) -> bool {
    let bytes = text.as_bytes();
    matches!(bytes.first(), Some(b'.' | b',')) && bytes.get(1).is_some_and(u8::is_ascii_digit)
}

/// A word goes as far as its letters, but a parameter behind an axis is a word of its own: `XQ1`.
fn word_length(text: &str) -> usize {
    let end = text.find(|c: char| !(c.is_alphabetic() || c == '_')).unwrap_or(text.len());
    let (word, behind) = text.split_at(end);
    if !behind.starts_with(|c: char| c.is_ascii_digit()) {
        return end;
    }
    let before = |name: &&str| {
        let at = end.checked_sub(name.len())?;
        word.get(at..).filter(|own| own.eq_ignore_ascii_case(name)).map(|_| at)
    };
    ["QL", "QR", "QS", "Q"].iter().find_map(|name| before(name)).filter(|at| *at > 0).unwrap_or(end)
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

/// `007.50` as `7.5`, `,5` as `0.5`, `5.` as `5`.
fn canonical(number: &str) -> String {
    let (whole, fraction) = number.split_once(['.', ',']).unwrap_or((number, ""));
    let (whole, fraction) = (whole.trim_start_matches('0'), fraction.trim_end_matches('0'));
    let whole = if whole.is_empty() { "0" } else { whole };
    if fraction.is_empty() { whole.to_owned() } else { format!("{whole}.{fraction}") }
}

/// Adds a token. A plus is left out where it is the sign of what follows, and `F MAX` is `FMAX`.
fn push(all: &mut Vec<String>, token: String) {
    let is_value = |token: &str| token.starts_with(|c: char| c.is_ascii_digit()) || token.starts_with('Q');
    let operand =
        |token: &str| token.starts_with(|c: char| c.is_ascii_digit() || c == '"') || matches!(token, ")" | "PI");
    let plus = all.last().is_some_and(|last| last == "+");
    let unary = plus && !all.len().checked_sub(2).and_then(|at| all.get(at)).is_some_and(|before| operand(before));
    if unary && (is_value(&token) || token == "-") {
        all.pop();
    }
    if all.last().is_some_and(|last| last == "F") && matches!(token.as_str(), "MAX" | "AUTO") {
        all.pop();
        all.push(format!("F{token}"));
        return;
    }
    all.push(token);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_one_spelling() {
        for (written, same) in [
            ("L X+10.000 Y-0,50 F MAX M03", "L X10 Y-.5 FMAX M3"),
            ("Q1 = + 5.", "q1 =5"),
            ("Q1 = Q2 + 5", "Q1=Q2+5.0"),
            ("Q1 = Q2 + +5", "Q1 = Q2 + 5"),
            ("L X+Q1", "L XQ1"),
            ("FN 0: Q1 = +-5", "FN 0: Q1 = -5"),
            ("C X+1 DR+ R0", "C X1 DR+  R0"),
        ] {
            assert_eq!(tokens(written), tokens(same), "{written}");
        }
    }

    #[test]
    fn what_means_something_stays() {
        for (one, other) in [
            ("L X+10", "L X-10"),
            ("L X+1", "L X+10"),
            ("L X1 0", "L X10"),
            ("C DR+", "C DR-"),
            ("Q1 = Q2 + 3", "Q1 = Q2 - 3"),
            ("Q1 = Q2 + 3", "Q1 = Q23"),
            ("Q1 = Q2 + Q3", "Q1 = Q2 Q3"),
            ("Q1 = PI + 3", "Q1 = PI 3"),
            ("Q1 = ( 1 + 2 ) + 3", "Q1 = ( 1 + 2 ) 3"),
            ("QS1 = \"a  b\"", "QS1 = \"a b\""),
            ("QS1 = \"a\"", "QS1 = \"A\""),
            ("LBL \"01\"", "LBL \"1\""),
        ] {
            assert_ne!(tokens(one), tokens(other), "{one}");
        }
    }

    #[test]
    fn names_keep_their_letters() {
        assert_eq!(closed_up("CALL  PGM TNC:\\A\\01.H "), "CALL PGM TNC:\\A\\01.H");
        assert_ne!(closed_up("CALL PGM 01"), closed_up("CALL PGM 1"));
        assert_eq!(closed_up("A \"B  C\"   D"), "A \"B  C\" D");
    }
}
