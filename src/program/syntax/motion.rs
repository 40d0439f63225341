//! Contour elements, tool blocks and the words that several blocks share: coordinates, feed, M functions.
use super::cursor::{Cursor, Read};
use super::definition::{CallForm, CyclCall};
use super::path::Path;
use super::terms::{
    Axis, BlkForm, Compensation, Coord, Feed, FeedKind, MFunction, Motion, Operand, ToolCall, ToolDef, ToolRef,
};
use super::words::{self, Takes, Vocabulary};
use crate::base::diag::Span;

/// Surface normal and tool direction.
const VECTORS: Vocabulary = &[
    ("NX", Takes::Value),
    ("NY", Takes::Value),
    ("NZ", Takes::Value),
    ("TX", Takes::Value),
    ("TY", Takes::Value),
    ("TZ", Takes::Value),
];
/// The greatest angle of rounded corners.
const TOLERANCE: Vocabulary = &[("A", Takes::Value)];
const APPROACH: Vocabulary = &[("LEN", Takes::Value), ("CCA", Takes::Value)];
/// What can be known of an element of a free contour.
const FREE: Vocabulary = &[
    ("AN", Takes::Value),
    ("IAN", Takes::Value),
    ("LEN", Takes::Value),
    ("CCA", Takes::Value),
    ("ICCA", Takes::Value),
    ("CCX", Takes::Value),
    ("CCY", Takes::Value),
    ("CCZ", Takes::Value),
    ("ICCX", Takes::Value),
    ("ICCY", Takes::Value),
    ("ICCZ", Takes::Value),
    ("CCPR", Takes::Value),
    ("CCPA", Takes::Value),
    ("ICCPR", Takes::Value),
    ("ICCPA", Takes::Value),
    ("PDX", Takes::Value),
    ("PDY", Takes::Value),
    ("PDZ", Takes::Value),
    ("PDPR", Takes::Value),
    ("PDPA", Takes::Value),
    ("D", Takes::Value),
    ("P1X", Takes::Value),
    ("P1Y", Takes::Value),
    ("P1Z", Takes::Value),
    ("P2X", Takes::Value),
    ("P2Y", Takes::Value),
    ("P2Z", Takes::Value),
    ("P3X", Takes::Value),
    ("P3Y", Takes::Value),
    ("P3Z", Takes::Value),
    ("PAR", Takes::Value),
    ("DP", Takes::Value),
    ("RX", Takes::Value),
    ("RY", Takes::Value),
    ("RZ", Takes::Value),
    ("RPR", Takes::Value),
    ("RPA", Takes::Value),
    ("RAN", Takes::Value),
    ("RCCX", Takes::Value),
    ("RCCY", Takes::Value),
    ("RCCZ", Takes::Value),
    ("RCCPR", Takes::Value),
    ("RCCPA", Takes::Value),
    ("CLSD", Takes::Sign),
];
/// The coefficients of a spline, of each axis.
const SPLINE: Vocabulary = &[
    ("K3X", Takes::Exponent),
    ("K2X", Takes::Exponent),
    ("K1X", Takes::Exponent),
    ("K3Y", Takes::Exponent),
    ("K2Y", Takes::Exponent),
    ("K1Y", Takes::Exponent),
    ("K3Z", Takes::Exponent),
    ("K2Z", Takes::Exponent),
    ("K1Z", Takes::Exponent),
    ("K3A", Takes::Exponent),
    ("K2A", Takes::Exponent),
    ("K1A", Takes::Exponent),
    ("K3B", Takes::Exponent),
    ("K2B", Takes::Exponent),
    ("K1B", Takes::Exponent),
    ("K3C", Takes::Exponent),
    ("K2C", Takes::Exponent),
    ("K1C", Takes::Exponent),
    ("K3U", Takes::Exponent),
    ("K2U", Takes::Exponent),
    ("K1U", Takes::Exponent),
    ("K3V", Takes::Exponent),
    ("K2V", Takes::Exponent),
    ("K1V", Takes::Exponent),
    ("K3W", Takes::Exponent),
    ("K2W", Takes::Exponent),
    ("K1W", Takes::Exponent),
];

/// The words that only a path of its kind has.
const fn vocabulary(path: Path) -> Option<Vocabulary> {
    match path {
        Path::Ln => Some(VECTORS),
        Path::Appr(_) | Path::Dep(_) => Some(APPROACH),
        Path::Fl | Path::Flt | Path::Fc | Path::Fct => Some(FREE),
        Path::Spl => Some(SPLINE),
        _ => None,
    }
}

/// The axis of a coordinate as controls write it, the letter and a number or a sign.
fn plain_axis(cursor: &Cursor<'_>) -> Option<Axis> {
    let (letter, next) = (cursor.byte(), cursor.byte_at(cursor.at + 1));
    let axis = if matches!(letter, b'A'..=b'C' | b'U'..=b'Z') { Axis::by_name(&[letter])? } else { return None };
    matches!(next, b'+' | b'-' | b'0'..=b'9').then_some(axis)
}

/// A coordinate, if one starts here.
fn opt_coord(cursor: &mut Cursor<'_>) -> Read<Option<Coord>> {
    cursor.blanks();
    let start = cursor.at;
    if let Some(axis) = plain_axis(cursor) {
        cursor.at += 1;
        let value = cursor.operand()?;
        return Ok(Some(Coord { span: Span::new(start, value.span.end), axis, incremental: false, value }));
    }
    // An axis that the kinematics hide is printed with `&`.
    cursor.at += usize::from(cursor.byte() == b'&');
    let word = cursor.peek_name();
    let (axis, incremental, length) = match word.as_bytes() {
        [b'I', axis @ ..] if !axis.is_empty() => (Axis::by_name(axis), true, axis.len() + 1),
        axis => (Axis::by_name(axis), false, axis.len()),
    };
    let Some(axis) = axis else {
        cursor.at = start;
        return Ok(None);
    };
    cursor.at = word.span.start + length;
    let value = cursor.operand()?;
    Ok(Some(Coord { span: Span::new(start, value.span.end), axis, incremental, value }))
}

/// A feed word, if one starts here.
fn opt_feed(cursor: &mut Cursor<'_>) -> Read<Option<Feed>> {
    cursor.blanks();
    let start = cursor.at;
    let word = cursor.peek_name();
    let kind = match word.as_bytes() {
        // Without a blank an M function may follow.
        b"FMAX" | b"FMAXM" => {
            cursor.at = start + 4;
            FeedKind::Max
        }
        b"FAUTO" => {
            cursor.at = word.span.end;
            FeedKind::Auto
        }
        b"FU" => {
            cursor.at = start + 2;
            FeedKind::PerRevolution(cursor.operand()?)
        }
        b"FZ" => {
            cursor.at = start + 2;
            FeedKind::PerTooth(cursor.operand()?)
        }
        b"F" => {
            cursor.at = start + 1;
            if cursor.opt_keyword(b"MAX") {
                FeedKind::Max
            } else if cursor.opt_keyword(b"AUTO") {
                FeedKind::Auto
            } else {
                FeedKind::Value(cursor.operand()?)
            }
        }
        _ => return Ok(None),
    };
    Ok(Some(Feed { span: Span::new(start, cursor.at), kind }))
}

/// An M function with what belongs to it, if one starts here.
pub(super) fn opt_function(cursor: &mut Cursor<'_>) -> Read<Option<MFunction>> {
    cursor.blanks();
    let start = cursor.at;
    let word = cursor.peek_name();
    if !word.is(b"M") {
        return Ok(None);
    }
    cursor.at = word.span.end;
    cursor.blanks();
    let Some(number) = cursor.opt_whole().and_then(|n| u16::try_from(n).ok()) else {
        // Older controls and their posts print the word of a block without a function, the last of the block.
        return if cursor.done() { Ok(None) } else { Err(cursor.expected("number")) };
    };
    // Posts that write a point after every number write it here too: `M3.`
    if cursor.byte() == b'.' && !cursor.byte_at(cursor.at + 1).is_ascii_digit() {
        cursor.at += 1;
    }
    let end = cursor.at;
    let with = opt_function_tail(cursor, number)?;
    if with.is_none() {
        cursor.at = end;
    }
    Ok(Some(MFunction { span: Span::new(start, cursor.at), number, with }))
}

/// What belongs to an M function: how far to retract or to look ahead, a feed, a length, axes.
fn opt_function_tail(cursor: &mut Cursor<'_>, number: u16) -> Read<Option<Span>> {
    cursor.blanks();
    let start = cursor.at;
    let word = cursor.peek_name();
    match (number, word.as_bytes()) {
        (_, b"MBMAX") => cursor.at = word.span.end,
        (_, b"MB" | b"LA") => {
            cursor.at = start + 2;
            if !cursor.opt_keyword(b"MAX") {
                cursor.operand()?;
            }
        }
        (103 | 128, _) => {
            opt_feed(cursor)?;
        }
        (112 | 124, b"T") => {
            cursor.at = start + 1;
            cursor.operand()?;
            words::opt_named(cursor, &[TOLERANCE])?;
        }
        (197, b"DIST") => {
            cursor.at = start + 4;
            cursor.operand()?;
        }
        (197, b"DL") => {
            cursor.at = start + 2;
            cursor.operand()?;
        }
        // How far the hand wheel may go, in each axis.
        (118, _) => while opt_coord(cursor)?.is_some() {},
        (94 | 138, _) => while opt_axis(cursor).is_some() {},
        _ => return Ok(None),
    }
    Ok((cursor.at > start).then(|| Span::new(start, cursor.at)))
}

/// The M functions of a programmed stop; older controls print the letter alone where there are none.
pub(super) fn stop(cursor: &mut Cursor<'_>) -> Read<Vec<MFunction>> {
    let mut ahead = *cursor;
    if ahead.opt_keyword(b"M") && ahead.done() {
        *cursor = ahead;
        return Ok(Vec::new());
    }
    functions(cursor)
}

/// The M function that retracts along the tool axis; a feed of its own may follow it.
const M_RETRACT: u16 = 140;

/// M functions up to the end of the block.
pub(super) fn functions(cursor: &mut Cursor<'_>) -> Read<Vec<MFunction>> {
    let mut found: Vec<MFunction> = Vec::new();
    while !cursor.done() {
        if let Some(last) = found.last_mut().filter(|last| last.number == M_RETRACT)
            && opt_feed(cursor)?.is_some()
        {
            last.span.end = cursor.at;
            last.with = last.with.map(|with| Span::new(with.start, cursor.at));
            continue;
        }
        match opt_function(cursor)? {
            Some(function) => found.push(function),
            None => return Err(cursor.expected("m-function")),
        }
    }
    Ok(found)
}

/// The words of a contour element, its first word being read; they are added to those of a new one.
pub(super) fn motion(cursor: &mut Cursor<'_>, motion: &mut Motion) -> Read<()> {
    if motion.path == Path::Chf {
        motion.radius = Some(cursor.operand()?);
    }
    while !cursor.done() {
        let start = cursor.at;
        // Whatever is read must pass something, or this would never end.
        if !motion_word(cursor, motion)? || cursor.at == start {
            return Err(cursor.expected("word"));
        }
    }
    Ok(())
}

/// A word as controls write most of them: a letter with its number directly after it. What it is, is the same as
/// [`motion_word`] finds, which tries everything.
fn plain_word(cursor: &mut Cursor<'_>, motion: &mut Motion) -> Read<bool> {
    let digit = cursor.byte_at(cursor.at + 1).is_ascii_digit();
    match cursor.byte() {
        b'R' if digit => radius_word(cursor, motion),
        b'M' if digit => {
            motion.functions.extend(opt_function(cursor)?);
            Ok(true)
        }
        b'F' if digit && motion.feed.is_none() && vocabulary(motion.path).is_none() => {
            let start = cursor.at;
            cursor.at += 1;
            let kind = FeedKind::Value(cursor.operand()?);
            motion.feed = Some(Feed { span: Span::new(start, cursor.at), kind });
            Ok(true)
        }
        _ => Ok(false),
    }
}

fn motion_word(cursor: &mut Cursor<'_>, motion: &mut Motion) -> Read<bool> {
    if plain_word(cursor, motion)? {
        return Ok(true);
    }
    if !motion.path.is_corner()
        && let Some(coord) = opt_coord(cursor)?
    {
        motion.coords.push(coord);
        return Ok(true);
    }
    cursor.blanks();
    let word = cursor.peek_name();
    match word.as_bytes() {
        b"R" => return radius_word(cursor, motion),
        b"RL" if motion.compensation.is_none() => motion.compensation = Some(Compensation::Rl),
        b"RR" if motion.compensation.is_none() => motion.compensation = Some(Compensation::Rr),
        b"DR" if motion.counter_clockwise.is_none() => {
            cursor.at = word.span.end;
            cursor.blanks();
            let sign = cursor.byte();
            if !matches!(sign, b'+' | b'-') {
                return Err(cursor.expected("sign"));
            }
            motion.counter_clockwise = Some(sign == b'+');
            cursor.at += 1;
            return Ok(true);
        }
        b"M" => {
            let function = opt_function(cursor)?;
            // After another one the number is missing.
            if function.is_none() && !motion.functions.is_empty() {
                return Err(cursor.expected("number"));
            }
            motion.functions.extend(function);
            return Ok(true);
        }
        _ => {
            if let Some(own) = vocabulary(motion.path)
                && let Some(word) = words::opt_named(cursor, &[own])?
            {
                motion.words.push(word);
                return Ok(true);
            }
            if word.is(b"F") && is_empty_feed(cursor) {
                cursor.at = word.span.end;
                return Ok(true);
            }
            // The second one is that of the retraction.
            let retraction = motion.functions.last_mut().filter(|last| last.number == M_RETRACT);
            if let (Some(last), true) = (retraction, motion.feed.is_some()) {
                let feed = opt_feed(cursor)?;
                last.span.end = cursor.at;
                last.with = last.with.map(|with| Span::new(with.start, cursor.at));
                return Ok(feed.is_some());
            }
            let feed = if motion.feed.is_none() { opt_feed(cursor)? } else { None };
            motion.feed = motion.feed.or(feed);
            return Ok(feed.is_some());
        }
    }
    cursor.at = word.span.end;
    Ok(true)
}

/// A feed word without a value before an M function or at the end, as older controls print it: `R F M`, `R0 F`.
fn is_empty_feed(cursor: &Cursor<'_>) -> bool {
    let mut ahead = Cursor { at: cursor.at + 1, ..*cursor };
    let apart = matches!(ahead.byte(), b' ' | b'\t');
    ahead.done() || (apart && matches!(ahead.byte(), b'M' | b'm') && !ahead.peek_word().is(b"MAX"))
}

/// `R0`, or the radius of an element that has one.
fn radius_word(cursor: &mut Cursor<'_>, motion: &mut Motion) -> Read<bool> {
    let has_radius = motion.path.has_radius() && motion.radius.is_none();
    if motion.path == Path::Axis && motion.compensation.is_none() {
        let along = match cursor.byte_at(cursor.at + 1) {
            b'+' => Some(Compensation::Longer),
            b'-' => Some(Compensation::Shorter),
            _ => None,
        };
        if along.is_some() {
            motion.compensation = along;
            cursor.at += 2;
            return Ok(true);
        }
    }
    let zero = cursor.byte_at(cursor.at + 1) == b'0';
    let more = matches!(cursor.byte_at(cursor.at + 2), b'0'..=b'9' | b'.' | b',');
    if zero && !more && motion.path != Path::Rnd && motion.compensation.is_none() {
        motion.compensation = Some(Compensation::R0);
        cursor.at += 2;
        return Ok(true);
    }
    if !has_radius {
        // A word without a value, as older controls print it: `R F MAX`.
        let empty = matches!(cursor.byte_at(cursor.at + 1), b' ' | b'\t');
        let mut ahead = Cursor { at: cursor.at + 1, ..*cursor };
        ahead.blanks();
        let goes_on = matches!(ahead.byte(), b'F' | b'f' | b'M' | b'm') && motion.compensation.is_none();
        if empty && goes_on {
            cursor.at += 1;
        }
        return Ok(empty && goes_on);
    }
    cursor.at += 1;
    motion.radius = Some(cursor.operand()?);
    Ok(true)
}

/// The words of `BLK FORM 0.1` and `0.2`, the first two being read; nothing for its other forms.
pub(super) fn opt_blk_form(cursor: &mut Cursor<'_>) -> Read<Option<BlkForm>> {
    cursor.blanks();
    if !cursor.byte().is_ascii_digit() {
        return Ok(None);
    }
    let mut ahead = *cursor;
    let part = match (ahead.opt_whole(), matches!(ahead.byte(), b'.' | b',')) {
        (Some(0), true) => {
            ahead.at += 1;
            ahead.opt_whole()
        }
        _ => None,
    };
    let part = match part {
        Some(1) => 1,
        Some(2) => 2,
        _ => return Err(cursor.expected("blk-form-part")),
    };
    *cursor = ahead;
    let axis = opt_axis(cursor);
    let mut coords = Vec::new();
    while let Some(coord) = opt_coord(cursor)? {
        coords.push(coord);
    }
    cursor.finish()?;
    Ok(Some(BlkForm { part, axis, coords }))
}

/// The letter of an axis that no value follows.
fn opt_axis(cursor: &mut Cursor<'_>) -> Option<Axis> {
    cursor.blanks();
    let word = cursor.peek_word();
    let axis = Axis::by_name(word.as_bytes()).filter(|axis| !matches!(axis, Axis::Pr | Axis::Pa))?;
    let mut after = Cursor { at: word.span.end, ..*cursor };
    after.blanks();
    if matches!(after.byte(), b'+' | b'-') || cursor.number_at(word.span.end) {
        return None;
    }
    cursor.at = word.span.end;
    Some(axis)
}

/// A tool: number, parameter or name.
fn opt_tool(cursor: &mut Cursor<'_>) -> Read<Option<ToolRef>> {
    if let Some(name) = cursor.opt_text()? {
        return Ok(Some(ToolRef::Name(name)));
    }
    Ok(cursor.opt_operand().map(ToolRef::Number))
}

/// The words of `TOOL CALL`, the first two being read.
pub(super) fn tool_call(cursor: &mut Cursor<'_>) -> Read<ToolCall> {
    let tool = opt_tool(cursor)?;
    let axis = opt_axis(cursor);
    let mut call = ToolCall { tool, axis, speed: None, cutting_speed: None, feed: None, dl: None, dr: None, dr2: None };
    while !cursor.done() {
        let word = cursor.peek_name();
        if word.is(b"S") && call.speed.is_none() && call.cutting_speed.is_none() {
            call.cutting_speed = opt_cutting_speed(cursor, word.span.end)?;
            if call.cutting_speed.is_some() {
                continue;
            }
        }
        let slot = match word.as_bytes() {
            b"S" => &mut call.speed,
            b"DL" => &mut call.dl,
            b"DR" if is_second_radius(cursor, word.span.end) => &mut call.dr2,
            b"DR" => &mut call.dr,
            _ => {
                let feed = if call.feed.is_none() { opt_feed(cursor)? } else { None };
                if feed.is_none() {
                    // `TOOL CALL 5 S1000 Z` is read as well.
                    call.axis = if call.axis.is_none() { opt_axis(cursor) } else { None };
                    if call.axis.is_none() {
                        return Err(cursor.expected("tool-word"));
                    }
                }
                call.feed = call.feed.or(feed);
                continue;
            }
        };
        if slot.is_some() {
            return Err(cursor.expected("tool-word"));
        }
        cursor.at = word.span.end + usize::from(word.is(b"DR") && is_second_radius(cursor, word.span.end));
        cursor.opt_mark(b':');
        *slot = Some(cursor.operand()?);
    }
    Ok(call)
}

/// `S( VC=120 )` or `S VC120`, `S` being read up to a byte.
fn opt_cutting_speed(cursor: &mut Cursor<'_>, at: usize) -> Read<Option<Operand>> {
    let mut ahead = Cursor { at, ..*cursor };
    let bracket = ahead.opt_mark(b'(');
    ahead.blanks();
    let word = ahead.peek_name();
    if !word.is(b"VC") {
        return Ok(None);
    }
    ahead.at += 2;
    let _ = ahead.opt_mark(b'=') || ahead.opt_mark(b':');
    let speed = ahead.operand()?;
    if bracket && !ahead.opt_mark(b')') {
        return Err(ahead.expected("closing-bracket"));
    }
    *cursor = ahead;
    Ok(Some(speed))
}

/// `DR2+0.1` and `DR2:+0.1` are another word than `DR2`, a radius oversize of 2.
fn is_second_radius(cursor: &Cursor<'_>, at: usize) -> bool {
    cursor.byte_at(at) == b'2' && matches!(cursor.byte_at(at + 1), b'+' | b'-' | b':' | b'Q' | b'q')
}

/// The words of `TOOL DEF`, the first two being read.
pub(super) fn tool_def(cursor: &mut Cursor<'_>) -> Read<ToolDef> {
    let Some(tool) = opt_tool(cursor)? else { return Err(cursor.expected("tool")) };
    let mut def = ToolDef { tool, length: None, radius: None };
    while !cursor.done() {
        let word = cursor.peek_name();
        let slot = match word.as_bytes() {
            b"L" if def.length.is_none() => &mut def.length,
            b"R" if def.radius.is_none() => &mut def.radius,
            _ => return Err(cursor.expected("tool-word")),
        };
        cursor.at = word.span.end;
        *slot = Some(cursor.operand()?);
    }
    Ok(def)
}

/// The words of `CYCL CALL`, the first two being read; they began at `start`.
pub(super) fn cycl_call(cursor: &mut Cursor<'_>, start: usize) -> Read<CyclCall> {
    let head = Span::new(start, cursor.at);
    let form = if cursor.opt_keyword(b"PAT") {
        CallForm::Pattern
    } else if cursor.opt_keyword(b"POS") {
        let mut coords = Vec::new();
        while let Some(coord) = opt_coord(cursor)? {
            coords.push(coord);
        }
        CallForm::Position(coords)
    } else {
        CallForm::Plain
    };
    let mut call = CyclCall { head, form, feed: None, functions: Vec::new() };
    while !cursor.done() {
        if let Some(function) = opt_function(cursor)? {
            call.functions.push(function);
            continue;
        }
        if cursor.done() && call.functions.is_empty() {
            break;
        }
        match opt_feed(cursor)? {
            Some(feed) if call.feed.is_none() => call.feed = Some(feed),
            _ => return Err(cursor.expected("m-function")),
        }
    }
    Ok(call)
}
