//! A program in mm told in inches: every length and feed that it writes, divided by 25.4.
//!
//! What a word is follows from the specifications for parameters and fields, and from the list here for other words.
//! A program that calculates has lengths that only its run knows: it has no such twin here.
use ciklo::base::diag::Span;
use ciklo::program::fields::{self, first, stands_on};
use ciklo::program::syntax::{
    Amount, Axis, BlockKind, CallForm, Coord, CycleForm, Feed, FeedKind, NamedWord, Operand, Parameter, Program,
    StatementKind, ToolCall, Value, ValueKind,
};
use ciklo::spec::{Catalogue, Cycle, OnControl, Shape};

/// mm in an inch.
pub(crate) const INCH: f64 = 25.4;

/// Words of approaches, blanks, patterns and planes that are lengths.
const LENGTHS: [&str; 25] = [
    "X", "Y", "Z", "IX", "IY", "IZ", "CCX", "CCY", "CCZ", "D", "DX", "DY", "R", "L", "DI", "RI", "LEN", "DIST", "MB",
    "P1X", "P1Y", "P2X", "P2Y", "P3X", "P3Y",
];
const MORE_LENGTHS: [&str; 4] = ["P1Z", "P2Z", "P3Z", "F"];

struct Twin<'p, 'f> {
    program: &'p Program,
    /// What the next length or feed is multiplied with.
    factor: &'f mut dyn FnMut() -> f64,
    edits: Vec<(Span, String)>,
    /// Whether there is something whose unit cannot be told.
    untold: bool,
}

impl Twin<'_, '_> {
    fn number(&mut self, span: Span, value: f64) {
        let value = value * (self.factor)();
        let signed = self.program.slice(span).starts_with(['+', '-']);
        self.edits.push((span, if signed { format!("{value:+}") } else { format!("{value}") }));
    }

    fn operand(&mut self, operand: &Operand) {
        if let Amount::Number(value) = operand.amount {
            self.number(operand.span, value);
        }
    }

    fn value(&mut self, value: &Value) {
        match value.kind {
            ValueKind::Number(number) => self.number(value.span, number),
            ValueKind::Word => {
                let text = self.program.slice(value.span);
                let number = text.strip_prefix("FU").or_else(|| text.strip_prefix("FZ"));
                if let Some(number) = number.and_then(|number| number.replace(',', ".").parse::<f64>().ok()) {
                    let number = number * (self.factor)();
                    self.edits.push((value.span, format!("{}{number}", &text[..2])));
                }
            }
            _ => {}
        }
    }

    /// A tolerance as a text: `0.05-0.02`, `-0.1`.
    fn tolerance(&mut self, inside: Span) {
        let text = self.program.slice(inside);
        let Some((first, second)) = text.split_once(['+', '-']) else { return };
        let sign = text.chars().find(|c| matches!(c, '+' | '-')).unwrap_or('-');
        let Ok(second) = second.parse::<f64>() else { return };
        // Only one of the two may be there: `-0.1`.
        if first.is_empty() {
            let factor = (self.factor)();
            self.edits.push((inside, format!("{sign}{}", second * factor)));
        } else if let Ok(first) = first.parse::<f64>() {
            let factor = (self.factor)();
            self.edits.push((inside, format!("{}{sign}{}", first * factor, second * factor)));
        }
    }

    fn coords(&mut self, coords: &[Coord]) {
        for coord in coords.iter().filter(|coord| !matches!(coord.axis, Axis::A | Axis::B | Axis::C | Axis::Pa)) {
            self.operand(&coord.value);
        }
    }

    fn feed(&mut self, feed: Option<&Feed>) {
        if let Some(FeedKind::Value(value) | FeedKind::PerRevolution(value) | FeedKind::PerTooth(value)) =
            feed.map(|feed| feed.kind)
        {
            self.operand(&value);
        }
    }

    fn words(&mut self, words: &[NamedWord]) {
        for word in words {
            let name = self.program.slice(word.name).trim().to_ascii_uppercase();
            if LENGTHS.contains(&&*name) || MORE_LENGTHS.contains(&&*name) {
                self.value(&word.value);
            }
        }
    }

    fn tool_call(&mut self, call: &ToolCall) {
        [&call.dl, &call.dr, &call.dr2].into_iter().flatten().for_each(|value| self.operand(value));
        self.feed(call.feed.as_ref());
    }

    fn parameters(&mut self, parameters: &[Parameter], cycles: &[&Cycle]) {
        for parameter in parameters {
            let of = |cycle: &&Cycle| cycle.params.iter().find(|param| param.q == Some(parameter.q)).cloned();
            match (cycles.iter().find_map(of), parameter.value.kind) {
                (Some(param), _) if param.is_measured() => self.value(&parameter.value),
                // With 0 the contour is in degrees along one axis, which its words do not show.
                (Some(param), ValueKind::Number(0.0)) if param.is.as_str() == "development-dimension-type" => {
                    self.untold = true;
                }
                (_, ValueKind::Text(inside)) => self.tolerance(inside),
                _ => {}
            }
        }
    }

    fn block(&mut self, kind: &BlockKind, all: &[&Cycle]) {
        match kind {
            BlockKind::BeginPgm(frame) | BlockKind::EndPgm(frame) => {
                self.untold |= frame.inch;
            }
            BlockKind::BlkForm(form) => self.coords(&form.coords),
            BlockKind::ToolCall(call) => self.tool_call(call),
            BlockKind::ToolDef(tool) => {
                [&tool.length, &tool.radius].into_iter().flatten().for_each(|value| self.operand(value));
            }
            BlockKind::Motion(motion) => {
                self.coords(&motion.coords);
                self.feed(motion.feed.as_ref());
                motion.radius.iter().for_each(|radius| self.operand(radius));
                self.words(&motion.words);
                self.untold |= motion.functions.iter().any(|function| function.with.is_some());
            }
            BlockKind::CyclCall(call) => {
                self.feed(call.feed.as_ref());
                if let CallForm::Position(coords) = &call.form {
                    self.coords(coords);
                }
            }
            BlockKind::PatternDef(pattern) => pattern.items.iter().for_each(|item| self.words(&item.words)),
            BlockKind::GlobalDef(values) => self.parameters(&values.parameters, all),
            BlockKind::Statement(statement) => match statement.kind {
                StatementKind::BlkForm | StatementKind::Plane | StatementKind::Trans | StatementKind::Function => {
                    self.words(&statement.words);
                }
                _ => self.untold = true,
            },
            BlockKind::FnAssign(_) | BlockKind::Formula(_) | BlockKind::FnJump(_) | BlockKind::CallPgm(_) => {
                self.untold = true;
            }
            _ => {}
        }
    }

    fn fields(&mut self, cycle: &Cycle, lines: &[&ciklo::program::syntax::OldCycleLine]) {
        // The first form that reads every word.
        for form in 0..cycle.file.forms.len() {
            let before = self.edits.len();
            if self.fields_of(cycle, form, lines) {
                return;
            }
            self.edits.truncate(before);
        }
        self.untold = true;
    }

    fn fields_of(&mut self, cycle: &Cycle, form: usize, lines: &[&ciklo::program::syntax::OldCycleLine]) -> bool {
        for line in lines {
            let mut expected: Vec<_> = cycle.fields(form).filter(|(_, field)| stands_on(field, line)).collect();
            let mut words = line.words.as_slice();
            while !words.is_empty() {
                let Some((at, count)) = first(self.program, expected.iter().map(|(_, field)| *field), words) else {
                    return false;
                };
                let (param, field) = expected.drain(..=at).next_back().expect("the one found");
                let (own, rest) = words.split_at(count);
                for word in own {
                    let name = self.program.slice(word.name).trim().to_ascii_uppercase();
                    let rotary = name.trim_start_matches('I').starts_with(['A', 'B', 'C']) && name.len() < 3;
                    let axes = matches!(field.shape, Shape::Position | Shape::AxisCoordinate | Shape::Centre);
                    let factor = matches!(param.quantity, ciklo::spec::Quantity::Factor | ciklo::spec::Quantity::Angle);
                    let centre = field.shape == Shape::Centre;
                    if (axes && !rotary && (!factor || centre)) || (!axes && param.is_measured()) {
                        self.value(&word.value);
                    }
                }
                words = rest;
            }
        }
        true
    }
}

/// The same program in inches; nothing if it calculates lengths, or is in inches itself.
pub(crate) fn in_inches(program: &Program, on: &OnControl, catalogue: &Catalogue) -> Option<String> {
    let text = with_lengths(program, on, catalogue, &mut || 1.0 / INCH)?;
    let frames = text.lines().map(|line| match line.contains(" PGM ") {
        true => line.strip_suffix(" MM").map_or_else(|| line.to_owned(), |name| format!("{name} INCH")),
        false => line.to_owned(),
    });
    Some(frames.fold(String::new(), |all, line| all + &line + "\n"))
}

/// The same program with every length and feed multiplied; nothing if it calculates lengths, or is in inches.
pub(crate) fn with_lengths(
    program: &Program,
    on: &OnControl,
    catalogue: &Catalogue,
    factor: &mut dyn FnMut() -> f64,
) -> Option<String> {
    let mut twin = Twin { program, factor, edits: Vec::new(), untold: false };
    let others = catalogue.controls.values().rev().filter(|other| other.id() != on.id());
    let all: Vec<&Cycle> = std::iter::once(on).chain(others).flat_map(|on| on.cycles.values()).collect();
    program.blocks().iter().for_each(|block| twin.block(&block.kind, &all));
    for view in program.cycles() {
        let key = fields::key(view.keyword, view.number);
        let cycle = all.iter().find(|cycle| cycle.key == key);
        match (&view.form, cycle) {
            (CycleForm::Parameters(written), Some(cycle)) => twin.parameters(&written.parameters.to_vec(), &[cycle]),
            (CycleForm::Lines(lines), Some(cycle)) if cycle.is_old_style() => twin.fields(cycle, lines),
            _ => {}
        }
    }
    if twin.untold {
        return None;
    }
    let Twin { mut edits, .. } = twin;
    edits.sort_by_key(|(span, _)| span.start);
    let text = program.source().text();
    let (mut told, mut at) = (String::new(), 0);
    for (span, new) in edits {
        told.push_str(&text[at..span.start]);
        told.push_str(&new);
        at = span.end;
    }
    told.push_str(&text[at..]);
    Some(told)
}
