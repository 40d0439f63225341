//! The places of patterns: those that a cycle for patterns reaches, and those of PATTERN DEF.
//!
//! Invariant: all places or nothing; a value that is not certain makes the pattern unknown.
use crate::base::expr::{cosd, sind};
use crate::check::Facts;
use crate::check::program::{Definition, number};
use crate::program::syntax::{NamedWord, PatternDef, PatternItem, ValueKind};

/// So many places of a pattern are looked at.
const MANY: f64 = 4096.0;

/// The places at which a cycle for patterns calls the cycle before it.
pub(super) fn of_cycle(read: &Definition<'_>) -> Option<Vec<[f64; 2]>> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    if let Some(diameter) = value("pitch-circle-diameter") {
        let centre = [value("pitch-circle-centre-main")?, value("pitch-circle-centre-minor")?];
        let (start, count) = (value("pattern-starting-angle")?, count(value("number-of-operations")?)?);
        let step = match value("pattern-stepping-angle")? {
            0.0 => stepping(value("pattern-stopping-angle")? - start, count),
            step => step,
        };
        return Some(circle(centre, diameter, start, step, count));
    }
    let start = [value("starting-point-main")?, value("starting-point-minor")?];
    let spacing = [value("pattern-spacing-main")?, value("pattern-spacing-minor")?];
    let counts = [count(value("number-of-columns")?)?, count(value("number-of-lines")?)?];
    Some(grid(start, spacing, counts, value("angle-of-rotation")?, false))
}

/// The places of PATTERN DEF.
pub(super) fn of_pattern(facts: &Facts<'_>, pattern: &PatternDef) -> Option<Vec<[f64; 2]>> {
    let mut places = Vec::new();
    for item in &pattern.items {
        places.extend(of_item(facts, item)?);
    }
    Some(places)
}

fn of_item(facts: &Facts<'_>, item: &PatternItem) -> Option<Vec<[f64; 2]>> {
    let word = |name: &str| {
        let named = |own: &&NamedWord| facts.text(own.name).trim().eq_ignore_ascii_case(name);
        item.words.iter().find(named)
    };
    let value = |name: &str| match word(name)?.value.kind {
        ValueKind::Number(number) => Some(number),
        ValueKind::Q { negative, .. } => facts.known_at(word(name)?.value.span, negative),
        _ => None,
    };
    // What is not written is 0.
    let turn = |name: &str| if word(name).is_some() { value(name) } else { Some(0.0) };
    let start = [value("X")?, value("Y")?];
    let name = facts.text(item.name).trim_end_matches(|c: char| c.is_ascii_digit()).to_ascii_uppercase();
    match name.as_str() {
        "POS" => Some(vec![start]),
        "ROW" => Some(grid(start, [value("D")?, 0.0], [count(value("NUM")?)?, 1], turn("ROT")?, false)),
        "PAT" | "FRAME" => {
            if turn("ROTX")? != 0.0 || turn("ROTY")? != 0.0 {
                return None;
            }
            let counts = [count(value("NUMX")?)?, count(value("NUMY")?)?];
            Some(grid(start, [value("DX")?, value("DY")?], counts, turn("ROT")?, name == "FRAME"))
        }
        "CIRC" => {
            let count = count(value("NUM")?)?;
            Some(circle(start, value("D")?, turn("START")?, stepping(360.0, count), count))
        }
        "PITCHCIRC" => {
            let (from, count) = (turn("START")?, count(value("NUM")?)?);
            let step = match (word("STEP"), word("END")) {
                (Some(_), _) => value("STEP")?,
                (None, Some(_)) => stepping(value("END")? - from, count),
                (None, None) => return None,
            };
            Some(circle(start, value("D")?, from, step, count))
        }
        _ => None,
    }
}

fn count(number: f64) -> Option<u16> {
    let whole = (1.0..=MANY).contains(&number) && number.fract() == 0.0;
    whole.then_some(number as u16)
}

/// The angle between neighbours on an arc; a full circle does not reach its first place twice.
fn stepping(span: f64, count: u16) -> f64 {
    let gaps = if span.abs() == 360.0 { count } else { count.saturating_sub(1).max(1) };
    span / f64::from(gaps)
}

fn circle(centre: [f64; 2], diameter: f64, start: f64, step: f64, count: u16) -> Vec<[f64; 2]> {
    let place = |at: u16| {
        let angle = start + step * f64::from(at);
        [centre[0] + diameter / 2.0 * cosd(angle), centre[1] + diameter / 2.0 * sind(angle)]
    };
    (0..count).map(place).collect()
}

/// The places of columns and lines, all turned about the first one; of a frame only those at its border.
fn grid(start: [f64; 2], spacing: [f64; 2], counts: [u16; 2], angle: f64, frame: bool) -> Vec<[f64; 2]> {
    let at_border = |at: u16, count: u16| at == 0 || at + 1 == count;
    let all = (0..counts[1]).flat_map(|line| (0..counts[0]).map(move |column| (column, line)));
    let wanted = all
        .filter(|(column, line)| !frame || at_border(*column, counts[0]) || at_border(*line, counts[1]))
        .take(MANY as usize);
    let (cosine, sine) = (cosd(angle), sind(angle));
    let place = |(column, line): (u16, u16)| {
        let (x, y) = (spacing[0] * f64::from(column), spacing[1] * f64::from(line));
        [start[0] + x * cosine - y * sine, start[1] + x * sine + y * cosine]
    };
    wanted.map(place).collect()
}
