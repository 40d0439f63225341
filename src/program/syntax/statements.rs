//! Blocks that are a name and words after it, and pattern definitions.
use super::cursor::{Cursor, Read};
use super::statement::{PatternDef, PatternItem, Statement, StatementKind};
use super::terms::{NamedWord, Value, ValueKind};
use super::tree::BlockKind;
use super::words::{self, Takes, Vocabulary};
use crate::base::diag::Span;

use Takes::{Any, Maybe, Nothing, Sign};

const NONE: Vocabulary = &[];

/// How a block that tilts the plane moves.
const TILTING: Vocabulary = &[
    ("MOVE", Nothing),
    ("TURN", Nothing),
    ("STAY", Nothing),
    ("DIST", Takes::Value),
    ("ABST", Takes::Value),
    ("MB", Maybe),
    ("MBMAX", Nothing),
    ("MAX", Nothing),
    ("F", Maybe),
    ("FMAX", Nothing),
    ("FAUTO", Nothing),
    ("AUTO", Nothing),
    ("SEQ", Sign),
    ("SYM", Sign),
    ("TABLE ROT", Nothing),
    ("COORD ROT", Nothing),
    ("TABLE", Nothing),
    ("COORD", Nothing),
    ("ROT", Nothing),
    ("M", Takes::Value),
];
const SPATIAL: Vocabulary = &[("SPA", Takes::Value), ("SPB", Takes::Value), ("SPC", Takes::Value)];
const PROJECTED: Vocabulary =
    &[("PROPR", Takes::Value), ("PROMIN", Takes::Value), ("PROROT", Takes::Value), ("ROT", Takes::Value)];
const EULER: Vocabulary = &[("EULPR", Takes::Value), ("EULNU", Takes::Value), ("EULROT", Takes::Value)];
const VECTOR: Vocabulary = &[
    ("BX", Takes::Value),
    ("BY", Takes::Value),
    ("BZ", Takes::Value),
    ("NX", Takes::Value),
    ("NY", Takes::Value),
    ("NZ", Takes::Value),
];
const POINTS: Vocabulary = &[
    ("P1X", Takes::Value),
    ("P1Y", Takes::Value),
    ("P1Z", Takes::Value),
    ("P2X", Takes::Value),
    ("P2Y", Takes::Value),
    ("P2Z", Takes::Value),
    ("P3X", Takes::Value),
    ("P3Y", Takes::Value),
    ("P3Z", Takes::Value),
];
const AXIAL: Vocabulary = &[("A", Takes::Value), ("B", Takes::Value), ("C", Takes::Value)];

/// The axes of a shift, mirroring or position.
pub(super) const AXES: Vocabulary = &[
    ("X", Maybe),
    ("Y", Maybe),
    ("Z", Maybe),
    ("A", Maybe),
    ("B", Maybe),
    ("C", Maybe),
    ("U", Maybe),
    ("V", Maybe),
    ("W", Maybe),
    ("IX", Maybe),
    ("IY", Maybe),
    ("IZ", Maybe),
    ("IA", Maybe),
    ("IB", Maybe),
    ("IC", Maybe),
    ("IU", Maybe),
    ("IV", Maybe),
    ("IW", Maybe),
];
const TRANSFORMATION: Vocabulary = &[
    ("DATUM", Nothing),
    ("MIRROR", Nothing),
    ("ROTATION", Nothing),
    ("SCALE", Nothing),
    ("AXIS", Nothing),
    ("TABLE", Maybe),
    ("TABLINE", Takes::Value),
    ("RESET", Nothing),
    ("ROT", Takes::Value),
    ("IROT", Takes::Value),
    ("SCL", Takes::Value),
];
const SHAPE: Vocabulary = &[
    ("R", Takes::Value),
    ("D", Takes::Value),
    ("L", Takes::Value),
    ("DIST", Takes::Value),
    ("RI", Takes::Value),
    ("DI", Takes::Value),
    ("DIM_R", Nothing),
    ("DIM_D", Nothing),
    ("DIM-R", Nothing),
    ("DIM-D", Nothing),
    ("LBL", Any),
    ("FILE", Maybe),
    ("TARGET", Any),
];
const CONTOUR: Vocabulary = &[("DEPTH", Takes::Value), ("LBL", Any)];
const SQL: Vocabulary = &[
    ("BIND", Nothing),
    ("SELECT", Nothing),
    ("EXECUTE", Nothing),
    ("FETCH", Nothing),
    ("UPDATE", Nothing),
    ("INSERT", Nothing),
    ("COMMIT", Nothing),
    ("ROLLBACK", Nothing),
    ("HANDLE", Takes::Value),
    ("INDEX", Takes::Value),
    ("IGNORE UNBOUND", Nothing),
    ("UNDEFINE MISSING", Nothing),
    ("RESET UNBOUND", Nothing),
    ("IGNORE", Nothing),
    ("UNDEFINE", Nothing),
    ("RESET", Nothing),
    ("UNBOUND", Nothing),
    ("MISSING", Nothing),
];
const SYSTEM_DATUM: Vocabulary = &[("ID", Takes::Value), ("NR", Takes::Value), ("IDX", Takes::Value)];
const PATTERN: Vocabulary = &[
    ("D", Takes::Value),
    ("DX", Takes::Value),
    ("DY", Takes::Value),
    ("NUM", Takes::Value),
    ("NUMX", Takes::Value),
    ("NUMY", Takes::Value),
    ("ROT", Takes::Value),
    ("ROTX", Takes::Value),
    ("ROTY", Takes::Value),
    ("START", Takes::Value),
    ("STEP", Takes::Value),
    ("END", Takes::Value),
];

/// First words of what follows `FUNCTION`.
const FUNCTIONS: [&[u8]; 30] = [
    b"AFC",
    b"CONTACT",
    b"CORRDATA",
    b"COUNT",
    b"DCM",
    b"DRESS",
    b"DWELL",
    b"FEED",
    b"FEEDTABLE",
    b"FILE",
    b"FIXTURE",
    b"GRIND",
    b"KINEMATICS",
    b"LIFTOFF",
    b"MODE",
    b"OPMODE",
    b"PARAXCOMP",
    b"PARAXMODE",
    b"POLARKIN",
    b"PROBE",
    b"PROG",
    b"PROGRAM",
    b"RESET",
    b"S",
    b"SET",
    b"SPINDLE",
    b"TABDATA",
    b"TCPM",
    b"TURN",
    b"TURNDATA",
];

const BLANK: Vocabulary = &[("BLANK", Takes::Nothing)];
const FILE: Vocabulary = &[("FILE", Takes::Nothing)];

fn statement(kind: StatementKind, start: usize, end: usize, words: Vec<NamedWord>) -> BlockKind {
    BlockKind::Statement(Box::new(Statement { kind, head: Span::new(start, end), words }))
}

/// Blocks whose first word, read already, is one of these; nothing for other words.
pub(super) fn opt_statement(cursor: &mut Cursor<'_>, first: &[u8], start: usize) -> Option<Read<BlockKind>> {
    Some(match first {
        b"PLANE" => plane(cursor, start),
        b"FUNCTION" => function(cursor, start),
        // Recesses and undercuts of contours that are turned begin with their own word.
        b"ADP" | b"AFC" | b"FILE" | b"FIXTURE" | b"GRV" | b"MONITORING" | b"OPEN" | b"POLARKIN" | b"PRESET"
        | b"SECTION" | b"TABDATA" | b"UDC" => {
            let head = cursor.at;
            words::free(cursor).map(|words| statement(StatementKind::Function, start, head, words))
        }
        b"TURNDATA" => {
            let head = cursor.at;
            turning_data(cursor, false).map(|words| statement(StatementKind::Function, start, head, words))
        }
        b"TRANS" => transformation(cursor, start),
        b"PATTERN" => pattern(cursor, start),
        b"CONTOUR" => contour(cursor, start),
        b"SQL" => {
            let head = cursor.at;
            words::open(cursor, &[SQL]).map(|words| statement(StatementKind::Sql, start, head, words))
        }
        b"FSELECT" => fselect(cursor, start),
        b"ERROR" => refused(cursor, start),
        _ => return None,
    })
}

fn plane(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.blanks();
    let form = cursor.peek_word();
    let own = match form.as_bytes() {
        b"SPATIAL" | b"RELATIV" | b"RELATIVE" => SPATIAL,
        b"PROJECTED" => PROJECTED,
        b"EULER" => EULER,
        b"VECTOR" => VECTOR,
        b"POINTS" => POINTS,
        b"AXIAL" => AXIAL,
        b"RESET" => NONE,
        _ => return Err(cursor.expected("plane-form")),
    };
    cursor.at = form.span.end;
    // A value after the name of the form's own word: `ROT+30` is another word than the `ROT` of `TABLE ROT`.
    let words = words::closed(cursor, &[own, TILTING])?;
    Ok(statement(StatementKind::Plane, start, form.span.end, words))
}

fn function(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.blanks();
    let what = cursor.peek_word();
    if !FUNCTIONS.contains(&what.as_bytes()) && !what.as_bytes().starts_with(b"TURNDATA") {
        return Err(cursor.expected("function"));
    }
    let short = what.is(b"S");
    cursor.at = what.span.end;
    if short && !(cursor.opt_mark(b'-') && cursor.opt_keyword(b"PULSE")) {
        return Err(cursor.expected("function"));
    }
    let head = cursor.at;
    let words = match what.as_bytes() {
        b"TURNDATA" => turning_data(cursor, false)?,
        b"TURNDATABLANK" => turning_data(cursor, true)?,
        _ => words::free(cursor)?,
    };
    Ok(statement(StatementKind::Function, start, head, words))
}

/// Words of `FUNCTION TURNDATA`; the file that describes a blank may be named without quotation marks.
fn turning_data(cursor: &mut Cursor<'_>, is_blank: bool) -> Read<Vec<NamedWord>> {
    let mut found: Vec<NamedWord> = words::opt_named(cursor, &[BLANK])?.into_iter().collect();
    if is_blank || !found.is_empty() {
        found.extend(words::opt_named(cursor, &[FILE])?);
        let _ = cursor.opt_mark(b'=');
        found.extend(words::opt_file(cursor));
    }
    found.extend(words::free(cursor)?);
    Ok(found)
}

fn transformation(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.blanks();
    let what = cursor.peek_word();
    if !matches!(what.as_bytes(), b"DATUM" | b"MIRROR" | b"ROTATION" | b"SCALE") {
        return Err(cursor.expected("transformation"));
    }
    cursor.at = what.span.end;
    let words = words::closed(cursor, &[TRANSFORMATION, AXES])?;
    if words.is_empty() {
        return Err(cursor.expected("block-word"));
    }
    Ok(statement(StatementKind::Trans, start, what.span.end, words))
}

fn fselect(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    let head = cursor.at;
    let number = cursor.operand()?;
    cursor.finish()?;
    let words = vec![words::nameless(words::from_operand(number))];
    Ok(statement(StatementKind::Fselect, start, head, words))
}

/// `BLK FORM CYLINDER`, `ROTATION` or `FILE`, the first two words being read.
pub(super) fn shape(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.blanks();
    let form = cursor.peek_word();
    if !matches!(form.as_bytes(), b"CYLINDER" | b"ROTATION" | b"FILE") {
        return Err(cursor.expected("blk-form-part"));
    }
    cursor.at = form.span.end;
    let words = words::open(cursor, &[SHAPE, AXES])?;
    Ok(statement(StatementKind::BlkForm, start, form.span.end, words))
}

/// `CALL SELECTED PGM`, the first two words being read.
pub(super) fn selected(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    if !(cursor.opt_keyword(b"CYCLE") || cursor.opt_keyword(b"CONTOUR")) {
        cursor.keyword("PGM")?;
    }
    let head = cursor.at;
    cursor.finish()?;
    Ok(statement(StatementKind::CallSelected, start, head, Vec::new()))
}

/// A block in which a parameter is named by the value of another one: `Q[Q5] = 3`, `L X+Q[Q5]`.
/// Its parts are not distinguished.
pub(super) fn opt_indirect(text: &str, content: Span) -> Option<BlockKind> {
    let mut cursor = Cursor::new(text, content);
    let written = text.get(content.start..content.end)?;
    let name = |before: &str| {
        let before = before.strip_suffix(['L', 'l', 'R', 'r', 'S', 's']).unwrap_or(before);
        before.ends_with(['Q', 'q'])
    };
    // Searched from each bracket on as far as its parameter goes: blocks may have any number of brackets.
    let holds_parameter = |from: usize| {
        let mut own = Cursor::new(written, Span::new(from, written.len()));
        own.blanks();
        own.opt_q().is_some() && own.opt_mark(b']')
    };
    let mut marks = written.match_indices('[');
    let is_it =
        !written.contains('"') && marks.any(|(at, _)| written.get(..at).is_some_and(name) && holds_parameter(at + 1));
    if !is_it {
        return None;
    }
    let head = cursor.peek_word().span;
    cursor.at = head.end;
    let start = content.start;
    Some(statement(StatementKind::Indirect, start, head.end, vec![printed(&mut cursor).ok()?]))
}

/// `ERROR = L X+10 Q`: the block as it was written follows the sign.
fn refused(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    let head = cursor.at;
    if !cursor.opt_mark(b'=') {
        return Err(cursor.expected("="));
    }
    Ok(statement(StatementKind::Refused, start, head, vec![printed(cursor)?]))
}

/// `CONTOUR DEF P1 = "A.H" I2 = LBL 3 DEPTH5`.
fn contour(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.keyword("DEF")?;
    let head = cursor.at;
    let mut found = Vec::new();
    while !cursor.done() {
        let word = cursor.peek_word();
        let number = cursor.byte_at(word.span.end).is_ascii_digit();
        if matches!(word.as_bytes(), b"P" | b"I" | b"V") && number {
            cursor.at = word.span.end;
            let _ = cursor.opt_whole();
            let name = Span::new(word.span.start, cursor.at);
            cursor.opt_mark(b'=');
            let value = contour_source(cursor)?;
            found.push(NamedWord { span: Span::new(name.start, value.span.end), name, value });
        } else {
            match words::opt_named(cursor, &[CONTOUR])? {
                Some(word) => found.push(word),
                None => return Err(cursor.expected("block-word")),
            }
        }
    }
    if found.is_empty() {
        return Err(cursor.expected("block-word"));
    }
    Ok(statement(StatementKind::ContourDef, start, head, found))
}

/// A file name, a text parameter or a label.
fn contour_source(cursor: &mut Cursor<'_>) -> Read<Value> {
    cursor.blanks();
    let start = cursor.at;
    if cursor.opt_keyword(b"LBL") {
        let inner = words::opt_value(cursor)?.ok_or_else(|| cursor.expected("label"))?;
        return Ok(Value { span: Span::new(start, inner.span.end), kind: ValueKind::Word });
    }
    words::opt_value(cursor)?.ok_or_else(|| cursor.expected("name"))
}

/// `DECLARE CONTOUR QC1 = "A.H" DEPTH5`, the first two words being read.
pub(super) fn declare_contour(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    let head = cursor.at;
    let (_, name) = opt_contour_name(cursor).ok_or_else(|| cursor.expected("contour-name"))?;
    cursor.opt_mark(b'=');
    let mut found = Vec::new();
    // Listings in columns print the name of the file on the next line.
    if !cursor.done() {
        let value = contour_source(cursor)?;
        found.push(NamedWord { span: Span::new(name.start, value.span.end), name, value });
        found.extend(words::closed(cursor, &[CONTOUR])?);
    }
    Ok(statement(StatementKind::DeclareContour, start, head, found))
}

/// `QC1`, also `QC 1`.
pub(super) fn opt_contour_name(cursor: &mut Cursor<'_>) -> Option<(u32, Span)> {
    let mut ahead = *cursor;
    ahead.blanks();
    let start = ahead.at;
    let number = ahead.opt_keyword(b"QC").then(|| {
        ahead.blanks();
        ahead.opt_whole()
    })??;
    *cursor = ahead;
    Some((number, Span::new(start, ahead.at)))
}

/// `PATTERN DEF POS1( X+10 Y+20 Z+0 ) …`.
fn pattern(cursor: &mut Cursor<'_>, start: usize) -> Read<BlockKind> {
    cursor.keyword("DEF")?;
    let head = Span::new(start, cursor.at);
    let mut items = Vec::new();
    while !cursor.done() {
        let word = cursor.peek_word();
        if !matches!(word.as_bytes(), b"POS" | b"ROW" | b"PAT" | b"FRAME" | b"CIRC" | b"PITCHCIRC") {
            return Err(cursor.expected("pattern-item"));
        }
        cursor.at = word.span.end;
        cursor.opt_whole();
        let name = Span::new(word.span.start, cursor.at);
        if !cursor.opt_mark(b'(') {
            return Err(cursor.expected("("));
        }
        let mut words = Vec::new();
        while !cursor.opt_mark(b')') {
            match words::opt_named(cursor, &[PATTERN, AXES])? {
                Some(word) => words.push(word),
                None => return Err(cursor.expected("closing-bracket")),
            }
        }
        items.push(PatternItem { name, words });
    }
    Ok(BlockKind::PatternDef(Box::new(PatternDef { head, items })))
}

/// `FN 14` to `FN 38`, the number and its colon being read.
pub(super) fn fn_block(cursor: &mut Cursor<'_>, number: u32, start: usize) -> Read<BlockKind> {
    let keyword: Option<&'static str> = match number {
        14 => Some("ERROR"),
        15 => Some("PRINT"),
        17 => Some("SYSWRITE"),
        18 => Some("SYSREAD"),
        19 | 29 => Some("PLC"),
        20 => Some("WAIT"),
        23 | 24 => Some("CDATA"),
        25 => Some("PRESET"),
        26 => Some("TABOPEN"),
        27 => Some("TABWRITE"),
        28 => Some("TABREAD"),
        37 => Some("EXPORT"),
        38 => Some("SEND"),
        _ => None,
    };
    if number == 16 {
        if !(cursor.opt_keyword(b"F") && cursor.opt_mark(b'-') && cursor.opt_keyword(b"PRINT")) {
            return Err(cursor.expected("F-PRINT"));
        }
    } else if let Some(keyword) = keyword {
        // A parameter may follow without a blank: `SYSREADQ1`.
        cursor.blanks();
        let word = cursor.peek_name();
        if word.is(keyword.as_bytes()) {
            cursor.at = word.span.end;
        } else {
            cursor.keyword(keyword)?;
        }
    }
    let head = cursor.at;
    let words = match number {
        14 | 15 | 19 | 23 | 24 | 27 | 28 | 29 | 37 | 38 => words::open(cursor, &[NONE])?,
        17 | 18 => words::open(cursor, &[SYSTEM_DATUM])?,
        25 => words::open(cursor, &[AXES])?,
        // Files, and conditions of the PLC, are kept as they are printed.
        _ => vec![printed(cursor)?],
    };
    let complete = match number {
        18 => words.len() >= 2,
        30..=36 => true,
        _ => !words.is_empty(),
    };
    if complete { Ok(statement(StatementKind::Fn(number), start, head, words)) } else { Err(cursor.expected("value")) }
}

fn printed(cursor: &mut Cursor<'_>) -> Read<NamedWord> {
    if cursor.done() {
        return Err(cursor.expected("name"));
    }
    let span = cursor.rest();
    Ok(words::nameless(Value { span, kind: ValueKind::Word }))
}

/// `SET UNDEFINED` after a parameter.
pub(super) fn opt_undefined(cursor: &mut Cursor<'_>, start: usize) -> Option<BlockKind> {
    let mut ahead = *cursor;
    ahead.blanks();
    let from = ahead.at;
    let q = words::opt_value(&mut ahead).ok().flatten()?;
    if !(matches!(q.kind, ValueKind::Q { .. })
        && ahead.opt_keyword(b"SET")
        && ahead.opt_keyword(b"UNDEFINED")
        && ahead.done())
    {
        return None;
    }
    let head = if start == from { q.span.end } else { from };
    *cursor = ahead;
    Some(statement(StatementKind::SetUndefined, start, head, vec![words::nameless(q)]))
}
