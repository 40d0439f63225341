//! The content of one block: which kind it is, and the kinds that are neither motions nor cycles.
use super::cursor::{Cursor, Read, Word};
use super::element::Checker;
use super::flow::{CallLbl, FnAssign, FnJump, FnOp, Formula, Label, LabelRef, Relation};
use super::path::{Approach, Path};
use super::statement::Selection;
use super::statement::TextFormula;
use super::terms::{Amount, Axis, Compensation, Frame, Operand, SyntaxError};
use super::tree::BlockKind;
use super::{cycle, motion, statements, texts};
use crate::base::diag::Span;
use crate::base::expr::{self, QKind, QRef};

/// Reads the content of a block (without number and comment).
pub(super) fn content(cursor: &mut Cursor<'_>, checker: &mut Checker<'_>) -> Read<BlockKind> {
    cursor.blanks();
    if cursor.byte() == b'*' {
        cursor.at += 1;
        cursor.opt_mark(b'-');
        return Ok(BlockKind::Structure(cursor.rest()));
    }
    let start = *cursor;
    let word = cursor.peek_word();
    cursor.at = word.span.end;
    match word.as_bytes() {
        b"BEGIN" => frame(cursor).map(|frame| BlockKind::BeginPgm(Box::new(frame))),
        b"END" => {
            frame(cursor).or_else(|error| bare_end(&start, error)).map(|frame| BlockKind::EndPgm(Box::new(frame)))
        }
        b"M" => {
            *cursor = start;
            motion::functions(cursor).map(BlockKind::Functions)
        }
        b"LBL" => label_block(cursor),
        b"CALL" => call(cursor, word),
        b"CYCL" | b"CYCLE" | b"TCH" | b"GLOBAL" => {
            *cursor = start;
            cycle_block(cursor)
        }
        b"FN" => function(cursor, word),
        b"IF" => jump(cursor, None),
        b"STOP" => motion::stop(cursor).map(BlockKind::Stop),
        b"SEL" => select(cursor),
        b"BLK" => blank(cursor, word),
        b"TOOL" => tool(cursor),
        b"DECLARE" => declare(cursor, word),
        b"Q" | b"QL" | b"QR" | b"QS" => {
            *cursor = start;
            assignment(cursor)
        }
        b"QC" => {
            *cursor = start;
            texts::contour_formula(cursor)
        }
        b"APPR" => approach(cursor).and_then(|form| element(cursor, Path::Appr(form), checker)),
        b"DEP" => approach(cursor).and_then(|form| element(cursor, Path::Dep(form), checker)),
        name => match Path::by_name(name) {
            Some(Path::L) => {
                let after = *cursor;
                element(cursor, Path::L, checker).or_else(|error| {
                    *cursor = after;
                    older_along_axis(cursor, checker).ok_or(error)
                })
            }
            Some(path) => element(cursor, path, checker),
            None => match closed_up(&word) {
                Some((path, length)) if cursor.starts_value() => {
                    cursor.at = start.at + length;
                    element(cursor, path, checker)
                }
                _ => statements::opt_statement(cursor, name, start.at).unwrap_or_else(|| {
                    *cursor = start;
                    if let Some(block) = along_axis(cursor, checker) {
                        return Ok(block);
                    }
                    *cursor = start;
                    Err(SyntaxError { code: "syntax-unknown-block", ..cursor.expected("block") })
                }),
            },
        },
    }
}

/// A path with the axis of its first coordinate directly after it, as in `LX+10`; the path and its length.
fn closed_up(word: &Word) -> Option<(Path, usize)> {
    let name = word.as_bytes();
    (1..name.len()).rev().find_map(|length| {
        let (path, axis) = name.split_at(length);
        let axis = axis.strip_prefix(b"I").filter(|axis| !axis.is_empty()).unwrap_or(axis);
        Axis::by_name(axis).and_then(|_| Path::by_name(path)).map(|path| (path, length))
    })
}

/// A block that positions one axis: `X+40 R+ F100`.
fn along_axis(cursor: &mut Cursor<'_>, checker: &mut Checker<'_>) -> Option<BlockKind> {
    let start = cursor.at;
    let element = checker.element(cursor, Path::Axis).ok()?;
    let [coord] = checker.words().coords.as_slice() else { return None };
    let begins = coord.span.start == start;
    (begins && !matches!(coord.axis, Axis::Pr | Axis::Pa)).then_some(BlockKind::Motion(element))
}

/// The same as the oldest controls and their posts write it: `L X+40 R+ F100`.
fn older_along_axis(cursor: &mut Cursor<'_>, checker: &mut Checker<'_>) -> Option<BlockKind> {
    let element = checker.element(cursor, Path::Axis).ok()?;
    let words = checker.words();
    let [coord] = words.coords.as_slice() else { return None };
    let along = matches!(words.compensation, Some(Compensation::Longer | Compensation::Shorter));
    (along && !matches!(coord.axis, Axis::Pr | Axis::Pa)).then_some(BlockKind::Motion(element))
}

fn element(cursor: &mut Cursor<'_>, path: Path, checker: &mut Checker<'_>) -> Read<BlockKind> {
    checker.element(cursor, path).map(BlockKind::Motion)
}

fn approach(cursor: &mut Cursor<'_>) -> Read<Approach> {
    cursor.blanks();
    let word = cursor.peek_word();
    let form = Approach::by_name(word.as_bytes()).ok_or_else(|| cursor.expected("approach"))?;
    cursor.at = word.span.end;
    Ok(form)
}

fn frame(cursor: &mut Cursor<'_>) -> Read<Frame> {
    cursor.keyword("PGM")?;
    let rest = cursor.rest();
    let text = cursor.text.get(rest.start..rest.end).unwrap_or_default();
    let inch = [("MM", false), ("INCH", true), ("IN", true)].into_iter().find_map(|(unit, inch)| {
        let at = text.len().checked_sub(unit.len())?;
        let found = text.get(at..)?.eq_ignore_ascii_case(unit);
        let name = text.get(..at)?;
        (found && (name.is_empty() || name.ends_with(char::is_whitespace))).then(|| (name.trim_end().len(), inch))
    });
    match inch {
        Some((length, inch)) => Ok(Frame { name: Span::new(rest.start, rest.start + length), inch }),
        None => Err(SyntaxError {
            code: "syntax-unexpected",
            span: last_word(text, rest.start, rest.end),
            expected: "unit",
        }),
    }
}

/// `END PGM` without a unit, perhaps without a name.
fn bare_end(start: &Cursor<'_>, error: SyntaxError) -> Read<Frame> {
    let mut cursor = *start;
    if !(cursor.opt_keyword(b"END") && cursor.opt_keyword(b"PGM")) {
        return Err(error);
    }
    cursor.blanks();
    let name = cursor.rest();
    let words = cursor.text.get(name.start..name.end).unwrap_or_default();
    if words.contains(char::is_whitespace) { Err(error) } else { Ok(Frame { name, inch: false }) }
}

fn last_word(text: &str, start: usize, end: usize) -> Span {
    let at = text.rfind(char::is_whitespace).map_or(0, |at| at + 1);
    let at = (at..text.len()).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len());
    Span::new(start + at, end)
}

/// A label: number, name in quotation marks, or a parameter; where it is set, one that holds a name.
fn label(cursor: &mut Cursor<'_>, called: bool) -> Read<LabelRef> {
    cursor.blanks();
    let start = cursor.at;
    let target = if let Some(name) = cursor.opt_text()? {
        Label::Name(name)
    } else if let Some(q) = ahead_q(cursor, called) {
        Label::Q(q)
    } else {
        let number = cursor.opt_whole().and_then(|number| u16::try_from(number).ok());
        Label::Number(number.ok_or_else(|| cursor.expected("label"))?)
    };
    Ok(LabelRef { span: Span::new(start, cursor.at), target })
}

fn ahead_q(cursor: &mut Cursor<'_>, called: bool) -> Option<QRef> {
    let mut ahead = *cursor;
    let q = ahead.opt_q().filter(|q| called || q.kind == QKind::Qs)?;
    *cursor = ahead;
    Some(q)
}

fn label_block(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    let label = label(cursor, false)?;
    cursor.finish()?;
    Ok(BlockKind::Lbl(Box::new(label)))
}

fn call(cursor: &mut Cursor<'_>, word: Word) -> Read<BlockKind> {
    if cursor.opt_keyword(b"LBL") {
        let label = label(cursor, true)?;
        let repeat = opt_repeat(cursor)?;
        cursor.finish()?;
        return Ok(BlockKind::CallLbl(Box::new(CallLbl { label, repeat })));
    }
    if cursor.opt_keyword(b"PGM") {
        return name(cursor).map(BlockKind::CallPgm);
    }
    if cursor.opt_keyword(b"SELECTED") {
        return statements::selected(cursor, word.span.start);
    }
    cursor.blanks();
    Err(cursor.expected("call"))
}

/// `REP 6` or `REP 6/6`: the repetitions, and after the bar those that are left.
fn opt_repeat(cursor: &mut Cursor<'_>) -> Read<Option<Operand>> {
    cursor.blanks();
    let word = cursor.peek_name();
    if !word.is(b"REP") {
        return Ok(None);
    }
    cursor.at = word.span.end;
    // Older controls print the word also where nothing is repeated.
    if cursor.done() {
        return Ok(None);
    }
    let count = cursor.operand()?;
    if cursor.opt_mark(b'/') {
        cursor.operand()?;
    }
    Ok(Some(count))
}

/// A name with or without quotation marks, up to the end.
fn name(cursor: &mut Cursor<'_>) -> Read<Span> {
    if let Some(name) = cursor.opt_text()? {
        cursor.finish()?;
        return Ok(name);
    }
    if cursor.done() {
        return Err(cursor.expected("name"));
    }
    if let Some(tab) = cursor.text.get(cursor.at..cursor.end).and_then(|rest| rest.find('\t')) {
        cursor.at += tab + 1;
        cursor.blanks();
        return Err(cursor.expected("end"));
    }
    Ok(cursor.rest())
}

fn select(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    cursor.blanks();
    let what = cursor.peek_word();
    match what.as_bytes() {
        b"TABLE" | b"PATTERN" | b"CONTOUR" | b"PGM" | b"CYCLE" | b"CORR" => {
            cursor.at = what.span.end;
            if what.is(b"CORR") {
                if !(cursor.opt_mark(b'-') && cursor.opt_keyword(b"TABLE")) {
                    return Err(cursor.expected("selection"));
                }
                let _ = cursor.opt_keyword(b"TCS") || cursor.opt_keyword(b"WPL");
            }
            Ok(BlockKind::Sel(Box::new(Selection { what: what.span, name: name(cursor)? })))
        }
        _ => Err(cursor.expected("selection")),
    }
}

fn blank(cursor: &mut Cursor<'_>, word: Word) -> Read<BlockKind> {
    cursor.keyword("FORM")?;
    Ok(match motion::opt_blk_form(cursor)? {
        Some(form) => BlockKind::BlkForm(Box::new(form)),
        None => statements::shape(cursor, word.span.start)?,
    })
}

fn tool(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    if cursor.opt_keyword(b"DEF") {
        return motion::tool_def(cursor).map(|def| BlockKind::ToolDef(Box::new(def)));
    }
    cursor.keyword("CALL")?;
    motion::tool_call(cursor).map(|call| BlockKind::ToolCall(Box::new(call)))
}

/// A cycle's call or definition, or `GLOBAL DEF`.
fn cycle_block(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    let start = *cursor;
    if cycle::opt_cycl(cursor) && cursor.opt_keyword(b"CALL") {
        return motion::cycl_call(cursor, start.at).map(|call| BlockKind::CyclCall(Box::new(call)));
    }
    *cursor = start;
    cycle::head(cursor)
}

fn declare(cursor: &mut Cursor<'_>, word: Word) -> Read<BlockKind> {
    if cursor.opt_keyword(b"STRING") {
        cursor.blanks();
        let start = *cursor;
        return match cursor.opt_q() {
            Some(QRef { kind: QKind::Qs, .. }) => {
                *cursor = start;
                assignment(cursor)
            }
            _ => Err(start.expected("text-parameter")),
        };
    }
    cursor.keyword("CONTOUR")?;
    statements::declare_contour(cursor, word.span.start)
}

/// A parameter that can be set, with its place and the `=` after it.
fn target(cursor: &mut Cursor<'_>) -> Read<(QRef, Span)> {
    cursor.blanks();
    let start = cursor.at;
    let Some(q) = cursor.opt_q() else { return Err(cursor.expected("parameter")) };
    let span = Span::new(start, cursor.at);
    if !cursor.opt_mark(b'=') {
        return Err(cursor.expected("="));
    }
    Ok((q, span))
}

fn assignment(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    if let Some(undefined) = statements::opt_undefined(cursor, cursor.at) {
        return Ok(undefined);
    }
    let (target, target_span) = target(cursor)?;
    let text = cursor.rest();
    let written = cursor.text.get(text.start..text.end).unwrap_or_default();
    let unjoined = without_joints(written);
    let written = unjoined.as_deref().unwrap_or(written);
    let wrong = |error: expr::ExprError| SyntaxError {
        code: "syntax-formula",
        span: Span::new(text.start + error.span.start, text.start + error.span.end),
        expected: error.expected,
    };
    let error = match expr::parse_formula(written) {
        Ok(expr) => return Ok(BlockKind::Formula(Box::new(Formula { target, target_span, expr, text }))),
        Err(error) => wrong(error),
    };
    match texts::opt_calls(cursor, text, written)? {
        Some((operands, calls)) => {
            expr::parse_formula(&operands).map_err(wrong)?;
            Ok(BlockKind::TextFormula(Box::new(TextFormula { target, target_span, text, calls })))
        }
        None => Err(error),
    }
}

/// A formula of several lines with blanks for the joints, so that its places stay; nothing if it has none.
fn without_joints(written: &str) -> Option<String> {
    if !written.contains(['\n', '\r']) {
        return None;
    }
    let mut text = String::with_capacity(written.len());
    let mut cursor = Cursor::new(written, Span::new(0, written.len()));
    while cursor.at < cursor.end {
        let from = cursor.at;
        cursor.blanks();
        text.extend(std::iter::repeat_n(' ', cursor.at - from));
        let rest = written.get(cursor.at..).unwrap_or_default();
        let next = rest.find([' ', '\t', '~', ';', '\r', '\n']).unwrap_or(rest.len());
        let next = if cursor.at == from { next.max(rest.chars().next().map_or(0, char::len_utf8)) } else { next };
        text.push_str(rest.get(..next).unwrap_or_default());
        cursor.at += next;
    }
    Some(text)
}

fn function(cursor: &mut Cursor<'_>, word: Word) -> Read<BlockKind> {
    cursor.blanks();
    let at = *cursor;
    let Some(number) = cursor.opt_whole() else { return Err(at.expected("number")) };
    cursor.opt_mark(b':');
    if number == 0
        && let Some(undefined) = statements::opt_undefined(cursor, word.span.start)
    {
        return Ok(undefined);
    }
    let op = match number {
        0 => FnOp::Set,
        1 => FnOp::Add,
        2 => FnOp::Sub,
        3 => FnOp::Mul,
        4 => FnOp::Div,
        5 => FnOp::Sqrt,
        6 => FnOp::Sin,
        7 => FnOp::Cos,
        8 => FnOp::Len,
        9..=12 => {
            cursor.keyword("IF")?;
            return jump(cursor, Some(number));
        }
        13 => FnOp::Ang,
        14..=39 => return statements::fn_block(cursor, number, word.span.start),
        _ => return Err(at.expected("number")),
    };
    calculation(cursor, op).map(|assign| BlockKind::FnAssign(Box::new(assign)))
}

fn calculation(cursor: &mut Cursor<'_>, op: FnOp) -> Read<FnAssign> {
    let (target, target_span) = target(cursor)?;
    let prefix = match op {
        FnOp::Sqrt => Some("SQRT"),
        FnOp::Sin => Some("SIN"),
        FnOp::Cos => Some("COS"),
        _ => None,
    };
    if let Some(prefix) = prefix {
        cursor.keyword(prefix)?;
    }
    let a = cursor.operand()?;
    let b = match op {
        FnOp::Set | FnOp::Sqrt | FnOp::Sin | FnOp::Cos => None,
        _ => {
            operator(cursor, op)?;
            Some(cursor.operand()?)
        }
    };
    cursor.finish()?;
    Ok(FnAssign { target, target_span, op, a, b })
}

fn operator(cursor: &mut Cursor<'_>, op: FnOp) -> Read<()> {
    let (mark, word, name) = match op {
        FnOp::Add => (Some(b'+'), None, "+"),
        FnOp::Sub => (Some(b'-'), None, "-"),
        FnOp::Mul => (Some(b'*'), None, "*"),
        FnOp::Div => (Some(b'/'), Some("DIV"), "DIV"),
        FnOp::Len => (None, Some("LEN"), "LEN"),
        _ => (None, Some("ANG"), "ANG"),
    };
    let hit = mark.is_some_and(|mark| cursor.opt_mark(mark))
        || word.is_some_and(|word: &str| cursor.opt_keyword(word.as_bytes()));
    if hit { Ok(()) } else { Err(cursor.expected(name)) }
}

/// A number, a parameter of any kind or a text.
fn compared(cursor: &mut Cursor<'_>) -> Read<Operand> {
    if let Some(text) = cursor.opt_text()? {
        let span = Span::new(text.start - 1, text.end + 1);
        return Ok(Operand { span, amount: Amount::Text(text) });
    }
    cursor.opt_operand().ok_or_else(|| cursor.expected("value"))
}

/// `IF a EQU b GOTO LBL x`, the `IF` being read; `number` is that of the FN, if one is written.
fn jump(cursor: &mut Cursor<'_>, number: Option<u32>) -> Read<BlockKind> {
    let a = compared(cursor)?;
    cursor.blanks();
    let word = cursor.peek_word();
    if word.is(b"IS") && number.is_none_or(|number| number == 9) {
        cursor.at = word.span.end;
        return definedness(cursor, a);
    }
    let (relation, its_number) = match word.as_bytes() {
        b"EQU" => (Relation::Equal, 9),
        b"NE" => (Relation::NotEqual, 10),
        b"GT" => (Relation::Greater, 11),
        b"LT" => (Relation::Less, 12),
        _ => return Err(cursor.expected("relation")),
    };
    if number.is_some_and(|number| number != its_number) {
        return Err(cursor.expected("relation-of-number"));
    }
    cursor.at = word.span.end;
    let b = compared(cursor)?;
    cursor.keyword("GOTO")?;
    cursor.keyword("LBL")?;
    let label = label(cursor, true)?;
    cursor.finish()?;
    Ok(BlockKind::FnJump(Box::new(FnJump { relation, a, b, label })))
}

/// `IS UNDEFINED GOTO LBL x`, the `IS` being read.
fn definedness(cursor: &mut Cursor<'_>, a: Operand) -> Read<BlockKind> {
    let relation = if cursor.opt_keyword(b"UNDEFINED") {
        Relation::Undefined
    } else {
        cursor.keyword("DEFINED")?;
        Relation::Defined
    };
    let b = Operand { span: Span::new(cursor.at, cursor.at), amount: Amount::Number(0.0) };
    cursor.keyword("GOTO")?;
    cursor.keyword("LBL")?;
    let label = label(cursor, true)?;
    cursor.finish()?;
    Ok(BlockKind::FnJump(Box::new(FnJump { relation, a, b, label })))
}
