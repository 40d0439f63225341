//! Formulas with functions on texts, and what the control knows of itself (`FN 18: SYSREAD`).
//!
//! Invariant: a function or a system datum that is not listed here is a fault, never ignored or guessed. What they mean
//! is common knowledge of the trade, see `docs/events.md`: the manuals of the cycles do not describe them.
use std::sync::Arc;

use crate::base::expr::{Env, EvalError, QKind, QRef, Value, compile, parse_formula};
use crate::engine::flow::state::Run;
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::TableKind;
use crate::program::syntax::{NamedWord, TextCall, TextFormula, ValueKind};
use crate::spec::Transformation;

/// Parameters from this number on stand for the results of functions while their formula is calculated: no program has
/// so many.
const RESULTS: u16 = 60_000;

/// Q parameters, and the results of functions.
struct Operands<'p> {
    params: &'p crate::engine::params::Params,
    results: Vec<Content>,
}

static NOTHING: Value = Value::Bool(false);

impl Operands<'_> {
    fn result(&self, q: QRef) -> Option<&Content> {
        self.results.get(usize::from(q.number.checked_sub(RESULTS)?))
    }
}

impl Env for Operands<'_> {
    fn slot(&self, _: usize) -> &Value {
        &NOTHING
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        match self.result(q) {
            Some(Content::Number(number)) => Ok(*number),
            Some(Content::Text(_)) => Err(EvalError::Kind),
            None => self.params.number(q),
        }
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        match self.result(q) {
            Some(Content::Text(text)) => Ok(Arc::clone(text)),
            Some(Content::Number(_)) => Err(EvalError::Kind),
            None => self.params.text(q),
        }
    }
}

fn missing() -> Fault {
    Fault::program("value-missing")
}

/// A place or length in characters.
fn characters(number: f64) -> Result<usize, Fault> {
    let whole = (0.0..=f64::from(u16::MAX)).contains(&number) && number.fract() == 0.0;
    if whole { Ok(number as usize) } else { Err(Fault::program("parameter-out-of-range").arg("value", number)) }
}

impl Run<'_, '_> {
    /// `QS1 = SUBSTR( SRC_QS2 BEG0 LEN4 ) || "mm"`.
    pub(super) fn text_formula(&mut self, formula: &TextFormula) -> Done {
        let mut written = self.slice(formula.text).to_owned();
        let mut results = Vec::with_capacity(formula.calls.len());
        for call in &formula.calls {
            results.push(self.text_function(call)?);
        }
        // From the back, so that the places before stay.
        for (index, call) in formula.calls.iter().enumerate().rev() {
            let last = call.words.last().map_or(call.name.end, |word| word.span.end);
            let after = |place: usize| place.saturating_sub(formula.text.start);
            let close = written.get(after(last)..).and_then(|rest| rest.find(')')).ok_or_else(missing)?;
            let letters = if matches!(results.get(index), Some(Content::Text(_))) { "QS" } else { "Q" };
            let operand = format!("{letters}{}", usize::from(RESULTS) + index);
            written.replace_range(after(call.name.start)..=after(last) + close, &operand);
        }
        let expr = parse_formula(&written.replace(['\r', '\n', '~'], " ")).map_err(|_| EvalError::Kind)?;
        let code = compile(&expr, &crate::base::expr::OnlyParameters).map_err(|_| EvalError::Kind)?;
        let value = match (formula.target.kind, code.eval(&Operands { params: &self.params, results })?) {
            (QKind::Qs, Value::Text(text)) => Content::Text(text),
            (QKind::Q | QKind::Ql | QKind::Qr, Value::Number(number)) => Content::Number(number),
            _ => return Err(EvalError::Kind.into()),
        };
        Ok(self.set(formula.target, value)?)
    }

    fn word_in<'w>(&self, words: &'w [NamedWord], name: &str) -> Option<&'w NamedWord> {
        words.iter().find(|word| self.slice(word.name).eq_ignore_ascii_case(name))
    }

    fn number_in(&self, words: &[NamedWord], name: &str) -> Result<f64, Fault> {
        self.number_of(&self.word_in(words, name).ok_or_else(missing)?.value)
    }

    fn text_in(&self, words: &[NamedWord], name: &str) -> Result<Arc<str>, Fault> {
        match self.word_in(words, name).ok_or_else(missing)?.value.kind {
            ValueKind::Q { q, .. } if q.kind == QKind::Qs => Ok(self.params.text(q)?),
            ValueKind::Text(span) => Ok(self.slice(span).into()),
            _ => Err(Fault::program("text-or-number")),
        }
    }

    fn text_function(&self, call: &TextCall) -> Result<Content, Fault> {
        let (name, words) = (self.slice(call.name).to_ascii_uppercase(), &call.words[..]);
        let text = |text: String| Ok(Content::Text(text.into()));
        match name.as_str() {
            "TOCHAR" => {
                let number = self.number_in(words, "DAT")?;
                match self.word_in(words, "DECIMALS") {
                    Some(word) => text(format!("{number:.*}", characters(self.number_of(&word.value)?)?.min(8))),
                    None => text(number.to_string()),
                }
            }
            "SUBSTR" => {
                let (from, length) =
                    (characters(self.number_in(words, "BEG")?)?, characters(self.number_in(words, "LEN")?)?);
                text(self.text_in(words, "SRC_")?.chars().skip(from).take(length).collect())
            }
            "TOUPPER" => text(self.text_in(words, "SRC_")?.to_uppercase()),
            "TOLOWER" => text(self.text_in(words, "SRC_")?.to_lowercase()),
            "TONUMB" => {
                let source = self.text_in(words, "SRC_")?;
                let number = source.trim().replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite());
                number.map(Content::Number).ok_or_else(|| Fault::program("text-or-number"))
            }
            "INSTR" => {
                let (source, wanted) = (self.text_in(words, "SRC_")?, self.text_in(words, "SEA_")?);
                let from = characters(self.word_in(words, "BEG").map_or(Ok(0.0), |word| self.number_of(&word.value))?)?;
                let characters: Vec<char> = source.chars().collect();
                let wanted: Vec<char> = wanted.chars().collect();
                let found = (from..characters.len())
                    .find(|at| characters.get(*at..).is_some_and(|rest| rest.starts_with(&wanted)));
                // A text that is not there: the length of the one that was searched.
                Ok(Content::Number(found.unwrap_or(characters.len()) as f64))
            }
            // A text without a value has the length -1.
            "STRLEN" => Ok(Content::Number(match self.text_in(words, "SRC_") {
                Ok(source) => source.chars().count() as f64,
                Err(fault) if fault.code == "parameter-undefined" => -1.0,
                Err(fault) => return Err(fault),
            })),
            "STRCOMP" => {
                let order = self.text_in(words, "SRC_")?.cmp(&self.text_in(words, "SEA_")?);
                Ok(Content::Number(f64::from(order as i8)))
            }
            "SYSREAD" => {
                let index = self.word_in(words, "IDX").map_or(Ok(0.0), |word| self.number_of(&word.value))?;
                self.system_datum(self.number_in(words, "ID")?, self.number_in(words, "NR")?, index)
                    .map(Content::Number)
            }
            "SYSSTR" => {
                let (id, number) = (self.number_in(words, "ID")?, self.number_in(words, "NR")?);
                self.time_text(id, number).map(|text| Content::Text(text.into()))
            }
            _ => Err(Fault::unsupported("unsupported-block").arg("word", name)),
        }
    }

    /// Date and time in the forms of `SYSSTR( ID10321 )`.
    fn time_text(&self, id: f64, number: f64) -> Result<String, Fault> {
        let now = self.drives.world.scene.clock;
        let (year, month, day) = (now.year, now.month, now.day);
        let (hour, minute, second) = (now.hour, now.minute, now.second);
        let short = year % 100;
        Ok(match (id as i64, number as i64) {
            (10321, 0) => format!("{day:02}.{month:02}.{year:04} {hour:02}:{minute:02}:{second:02}"),
            (10321, 1) => format!("{day}.{month:02}.{year:04} {hour}:{minute:02}:{second:02}"),
            (10321, 2) => format!("{day}.{month:02}.{year:04} {hour}:{minute:02}"),
            (10321, 3) => format!("{day}.{month:02}.{short:02} {hour}:{minute:02}"),
            (10321, 4) => format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}"),
            (10321, 5) => format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}"),
            (10321, 6) => format!("{year:04}-{month:02}-{day:02} {hour}:{minute:02}"),
            (10321, 7) => format!("{short:02}-{month:02}-{day:02} {hour}:{minute:02}"),
            (10321, 8) => format!("{day:02}.{month:02}.{year:04}"),
            (10321, 9) => format!("{day}.{month:02}.{year:04}"),
            (10321, 10) => format!("{day}.{month:02}.{short:02}"),
            (10321, 11) => format!("{year:04}-{month:02}-{day:02}"),
            (10321, 12) => format!("{short:02}-{month:02}-{day:02}"),
            (10321, 13) => format!("{hour:02}:{minute:02}:{second:02}"),
            (10321, 14) => format!("{hour}:{minute:02}:{second:02}"),
            (10321, 15) => format!("{hour}:{minute:02}"),
            _ => {
                let word = format!("SYSSTR ID{id} NR{number}");
                return Err(Fault::unsupported("unsupported-block").arg("word", word));
            }
        })
    }

    /// `FN 18: SYSREAD Q1 = ID270 NR1 IDX3`.
    pub(super) fn read_system(&mut self, words: &[NamedWord]) -> Done {
        let target = words.iter().find_map(|word| match word.value.kind {
            ValueKind::Q { q, .. } if self.slice(word.name).trim().is_empty() => Some(q),
            _ => None,
        });
        let target = target.ok_or_else(missing)?;
        let index = self.word_in(words, "IDX").map_or(Ok(0.0), |word| self.number_of(&word.value))?;
        let value = self.system_datum(self.number_in(words, "ID")?, self.number_in(words, "NR")?, index)?;
        Ok(self.set(target, Content::Number(value))?)
    }

    /// What the control knows of itself, in the unit of the program.
    fn system_datum(&self, id: f64, number: f64, index: f64) -> Result<f64, Fault> {
        let unknown = || {
            let word = format!("SYSREAD ID{id} NR{number} IDX{index}");
            Fault::unsupported("unsupported-block").arg("word", word)
        };
        let world = &self.drives.world;
        let (system, unit) = (&world.system, self.drives.unit());
        // The axes are counted X, Y, Z, A, B, C.
        let linear = |values: glam::DVec3| Axis::ALL.get((index - 1.0) as usize).map(|axis| axis.of(values) / unit);
        let rotary = |values: glam::DVec3| RotaryAxis::ALL.get((index - 4.0) as usize).map(|axis| axis.of(values));
        let by_axis = |lengths: glam::DVec3, angles: glam::DVec3| match index {
            index if (1.0..=3.0).contains(&index) => linear(lengths),
            index if (4.0..=6.0).contains(&index) => rotary(angles),
            _ => None,
        };
        let truth = |holds: bool| Some(f64::from(u8::from(holds)));
        let tool_axis = match system.plane.tool.letter() {
            'X' => 0.0,
            'Y' => 1.0,
            _ => 2.0,
        };
        // All groups have numbers that are multiples of ten.
        let group = if id % 10.0 == 0.0 { (id / 10.0) as i64 } else { 0 };
        let found = match (group, number as i64) {
            (2, 1) => Some(world.tool().map_or(0.0, |tool| tool.number)),
            (2, 3) | (6, 2) => Some(tool_axis),
            (2, 4) | (6, 3) => Some(self.drives.switched.spindle.speed),
            (2, 5) => Some(match self.drives.switched.spindle.direction {
                1 => 0.0,
                -1 => 1.0,
                _ => 2.0,
            }),
            (2, 8) => truth(self.drives.switched.coolant),
            (2, 9) => self.modal.feed.map(|feed| feed / unit),
            (6, 1) => Some(world.tool().map_or(0.0, |tool| tool.number)),
            (5, number) => return self.tool_datum(number, index)?.ok_or_else(unknown),
            (20, 1) => world.tool().map(|tool| tool.radius / unit),
            (20, 2) => world.tool().map(|tool| tool.length / unit),
            (20, 3) => world.tool().map(|tool| tool.corner / unit),
            (21, 2) => Some(system.rotation()),
            (21, 3) => {
                let (linear, rotary) = system.mirror();
                let bit = |value: f64, weight: f64| if value < 0.0 { weight } else { 0.0 };
                let of = |signs: glam::DVec3, least: f64| {
                    bit(signs.x, least) + bit(signs.y, 2.0 * least) + bit(signs.z, 4.0 * least)
                };
                Some(of(linear, 1.0) + of(rotary, 8.0))
            }
            (21, 4) => {
                let (factor, by_axis) = system.scaling();
                let factors = by_axis.map_or(glam::DVec3::ONE, |(factors, _)| factors);
                Axis::ALL.get((index - 1.0) as usize).map(|axis| factor * axis.of(factors))
            }
            (21, 5) => {
                system.tilt().map_or(Some(0.0), |tilt| Axis::ALL.get((index - 1.0) as usize).map(|axis| axis.of(tilt)))
            }
            (21, 6) => truth(system.has(Transformation::Tilting)),
            (22, 2) => by_axis(system.datum(), system.angle_shift),
            (24, 1) => by_axis(world.machine, world.angles),
            (27, 1) => by_axis(world.here, world.program_angles()),
            (53, 1) => Some(system.reported().preset),
            _ => None,
        };
        found.ok_or_else(unknown)
    }

    /// A column of the tool table; of the tool in the spindle where the row is 0.
    fn tool_datum(&self, number: i64, row: f64) -> Result<Option<f64>, Fault> {
        const COLUMNS: [(i64, &str, bool); 16] = [
            (1, "L", true),
            (2, "R", true),
            (3, "R2", true),
            (4, "DL", true),
            (5, "DR", true),
            (6, "DR2", true),
            (8, "RT", false),
            (13, "LCUTS", true),
            (14, "ANGLE", false),
            (15, "CUT", false),
            (16, "LTOL", true),
            (17, "RTOL", true),
            (19, "R-OFFS", true),
            (20, "L-OFFS", true),
            (21, "LBREAK", true),
            (22, "RBREAK", true),
        ];
        let Some((_, column, is_length)) = COLUMNS.iter().find(|(own, ..)| *own == number) else { return Ok(None) };
        let row = if row > 0.0 { row } else { self.drives.world.tool().map_or(0.0, |tool| tool.number) };
        let value = self.drives.world.table(TableKind::Tool)?.number(row, column)?.unwrap_or_default();
        Ok(Some(if *is_length { value / self.drives.unit() } else { value }))
    }
}
