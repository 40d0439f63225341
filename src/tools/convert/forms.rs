//! A cycle in its other form: lines of the old form as Q parameters, and back.
//!
//! The fields of the old form say which Q parameter they stand for. Invariant: the new definition has every value of
//! the old one, or the definition stays as it was.
use super::{Writer, printed};
use crate::base::diag::{Diagnostic, Edit, Severity, Span};
use crate::base::expr::QRef;
use crate::check::Definition;
use crate::language::label;
use crate::program::syntax::BlockKind;
use crate::spec::{Cycle, Shape};

impl Writer<'_, '_> {
    pub(super) fn other_form(&mut self, definition: &Definition<'_>, own: &Cycle, other: &Cycle) {
        let blocks = self.program.blocks().get(definition.view.first..=definition.view.last).unwrap_or_default();
        let (Some(first), Some(last)) = (blocks.first(), blocks.last()) else { return };
        let head = definition.view.head;
        let is_line = |kind: &BlockKind| matches!(kind, BlockKind::OldCycleLine(_) | BlockKind::CycleDef(_));
        let commented = own.is_old_style() && blocks.iter().any(|block| block.comment().is_some());
        if blocks.iter().any(|block| !is_line(&block.kind) || block.skip) || commented {
            let stays = self.at("convert-form-stays", Severity::Error, head).arg("cycle", definition.key.to_string());
            self.found.push(stays);
            return;
        }
        let before = self.found.len();
        let given =
            if own.is_old_style() { self.as_parameters(definition, other) } else { self.as_fields(definition, other) };
        let Given { values, without, copy } = given;
        let Ok(language) = self.request.locales.language(self.language()) else { return };
        let request = label::Request { values: &values, without: &without, form: None, number: first.number };
        let block = match label::block(self.request.to.on, other, language, &request) {
            Ok(block) => block,
            Err(faults) => {
                let place = |fault: Diagnostic| Diagnostic { place: self.at("", Severity::Error, head).place, ..fault };
                self.found.extend(faults.into_iter().map(place).collect::<Vec<_>>());
                return;
            }
        };
        if self.found.iter().skip(before).any(|found| found.severity == Severity::Error) {
            return;
        }
        let mut text = if first.number.is_some() { block } else { unnumbered(&block) };
        if let Some((q, result)) = copy {
            let number = first.number.map_or_else(String::new, |number| format!("{} ", number.saturating_add(1)));
            text.push_str(&format!("{number}FN 0: {q} = +{result}\n"));
        }
        let span = Span::new(first.span.start, last.span.end);
        let old = self.program.slice(span);
        if old.contains("\r\n") {
            text = text.replace('\n', "\r\n");
        }
        if !old.ends_with(['\n', '\r']) {
            text.truncate(text.trim_end_matches(['\n', '\r']).len());
        }
        if !self.writable(&text, head) {
            return;
        }
        let finding = self.at("convert-form", Severity::Note, head).arg("cycle", definition.key.to_string());
        self.found.push(finding.arg("new", other.key.to_string()));
        self.edits.push(Edit { span, text });
    }

    fn as_parameters(&mut self, definition: &Definition<'_>, other: &Cycle) -> Given {
        let mut given = Given::default();
        for item in &definition.items {
            let field = item.param.and_then(|param| param.field.as_ref());
            match field.and_then(|field| Some((field, field.stands_for?))) {
                // The old form names the parameter of the result; the new one always writes the same.
                Some((field, q)) if field.shape == Shape::Q => {
                    given.copy = QRef::parse(&item.printed).filter(|named| *named != q).map(|named| (named, q));
                }
                Some((_, q)) => given.values.push((q.to_string(), item.printed.to_string())),
                None => self.dropped(definition.key, &item.name, &item.printed, item.span, false),
            }
        }
        for param in &other.params {
            let Some(q) = param.q.map(|q| q.to_string()) else { continue };
            if given.values.iter().any(|(name, _)| *name == q) {
                continue;
            }
            match param.neutral {
                Some(value) => {
                    let value = printed(param, value);
                    self.added(definition.key, &q, &value, definition.view.head, false);
                    given.values.push((q, value));
                }
                None => self.no_value(definition.key, &q, definition.view.head),
            }
        }
        given
    }

    fn as_fields(&mut self, definition: &Definition<'_>, other: &Cycle) -> Given {
        let mut given = Given::default();
        let mut used = Vec::new();
        for (param, field) in other.fields(0) {
            let written =
                field.stands_for.and_then(|q| definition.items.iter().find(|item| QRef::parse(&item.name) == Some(q)));
            match (written, field.stands_for) {
                (Some(item), _) => {
                    used.push(item.name.clone());
                    given.values.push((field.id.as_str().to_owned(), item.printed.to_string()));
                }
                (None, Some(q)) if field.shape == Shape::Q => {
                    given.values.push((field.id.as_str().to_owned(), q.to_string()));
                }
                _ if field.optional => given.without.push(field.id.as_str().to_owned()),
                _ => self.no_value(definition.key, &param.label_in(other.key.number), definition.view.head),
            }
        }
        for item in definition.items.iter().filter(|item| !used.contains(&item.name)) {
            let neutral = item.param.and_then(|param| param.neutral);
            let is_neutral = item.printed.trim().parse().ok().is_some_and(|value: f64| Some(value) == neutral);
            self.dropped(definition.key, &item.name, &item.printed, item.span, is_neutral);
        }
        given
    }
}

/// What the new definition is made of.
#[derive(Default)]
struct Given {
    /// Values by `Q…` or field id.
    values: Vec<(String, String)>,
    /// Fields left out.
    without: Vec<String>,
    /// The parameter in which the program looks for the result, and that in which the new form leaves it.
    copy: Option<(QRef, QRef)>,
}

/// Blocks without their numbers.
fn unnumbered(block: &str) -> String {
    let line = |line: &str| {
        let rest = line.trim_start_matches(|c: char| c.is_ascii_digit());
        if rest.len() < line.len() { rest.trim_start().to_owned() } else { line.to_owned() }
    };
    block.lines().map(|text| line(text) + "\n").collect()
}
