//! Definitions with Q parameters: a piece of text for each parameter, put together anew.
//!
//! Invariant: a piece keeps its bytes but for label, number and the sign that the block goes on.
use std::borrow::Cow;

use super::{Writer, printed};
use crate::base::diag::{Edit, Severity, Span};
use crate::base::expr::QRef;
use crate::check::{Definition, Item, ParamLabels};
use crate::language::label::continuation;
use crate::spec::{Cycle, Param};

/// A parameter's lines.
struct Piece<'t> {
    q: Option<QRef>,
    text: Cow<'t, str>,
}

/// How the block says that it goes on.
struct Style<'t> {
    indent: &'t str,
    mark: Option<Cow<'t, str>>,
    end: &'t str,
}

impl Writer<'_, '_> {
    pub(super) fn parameters(&mut self, definition: &Definition<'_>, own: &Cycle, other: &Cycle) {
        let Some(block) = self.program.blocks().get(definition.view.first) else { return };
        let text = self.program.slice(block.span);
        let starts: Vec<usize> =
            definition.items.iter().map(|item| line_start(text, item.span.start - block.span.start)).collect();
        if starts.windows(2).any(|pair| pair[0] >= pair[1]) || starts.first() == Some(&0) {
            self.found.push(
                self.at("convert-not-line-by-line", Severity::Error, definition.view.head)
                    .arg("cycle", definition.key.to_string()),
            );
            return;
        }
        let style = self.style(text, &starts, definition, other);
        let mut pieces = Vec::new();
        for (at, item) in definition.items.iter().enumerate() {
            let (start, end) = (starts[at], starts.get(at + 1).copied().unwrap_or(text.len()));
            let piece = text.get(start..end).unwrap_or_default();
            if let Some(piece) = self.piece(definition, own, other, item, piece, block.span.start + start) {
                pieces.push(piece);
            }
        }
        self.add(definition, own, other, &style, &mut pieces);
        arrange(own, other, &mut pieces);
        let head_end = starts.first().copied().unwrap_or(text.len());
        let head = self.head(definition, own, other, text.get(..head_end).unwrap_or_default(), block.span.start);
        let mut whole = String::with_capacity(text.len() + 64);
        let all = std::iter::once(head).chain(pieces.into_iter().map(|piece| piece.text));
        let mut all = all.peekable();
        while let Some(piece) = all.next() {
            whole.push_str(&joined(&piece, all.peek().is_some(), &style));
        }
        // The last line of a file may have no end.
        if !text.ends_with(['\n', '\r']) {
            whole.truncate(whole.trim_end_matches(['\n', '\r']).len());
        }
        if whole != text {
            self.edits.push(Edit { span: block.span, text: whole });
        }
    }

    fn style<'t>(&self, text: &'t str, starts: &[usize], definition: &Definition<'_>, other: &Cycle) -> Style<'t> {
        let first = definition.view.first;
        let head = text.get(..starts.first().copied().unwrap_or(text.len())).unwrap_or_default();
        let body = head.trim_end_matches(['\n', '\r']);
        let whole = self.program.source().text();
        let end = match head.get(body.len()..) {
            Some(end) if !end.is_empty() => end,
            _ if whole.contains("\r\n") => "\r\n",
            _ => "\n",
        };
        let bare = body.trim_end_matches([' ', '\t']).trim_end_matches('~').trim_end_matches([' ', '\t']);
        let tail = body.get(bare.len()..).unwrap_or_default();
        // As the block itself does it; else as the other control prints it.
        let own = tail.contains('~').then(|| Cow::Borrowed(tail.trim_end_matches([' ', '\t'])));
        let wanted = continuation(self.request.to.on, other).map(|mark| Cow::Owned(format!(" {mark}")));
        let line = starts.first().and_then(|start| text.get(*start..)).unwrap_or("    ");
        let indent = line.get(..line.len() - line.trim_start_matches([' ', '\t']).len()).unwrap_or("    ");
        let numbered = self.program.blocks().get(first).is_some_and(|block| block.number.is_some());
        let indent = if indent.is_empty() && numbered { "    " } else { indent };
        Style { indent, mark: own.or(wanted), end }
    }

    /// The lines of a parameter as they stay; nothing if the other control does not have it.
    fn piece<'t>(
        &mut self,
        definition: &Definition<'_>,
        own: &Cycle,
        other: &Cycle,
        item: &Item<'_>,
        text: &'t str,
        start: usize,
    ) -> Option<Piece<'t>> {
        let Some((param, q)) = item.param.zip(QRef::parse(&item.name)) else {
            return Some(Piece { q: QRef::parse(&item.name), text: Cow::Borrowed(text) });
        };
        let Some(target) = counterpart(own, other, param, q) else {
            let neutral = is_neutral(other, param, &item.printed);
            self.dropped(definition.key, &item.name, &item.printed, item.span, neutral);
            return None;
        };
        self.judge(definition.key, &item.name, &item.printed, item.value_span, param, target);
        let mut edits = Vec::new();
        let mut q = q;
        if other.written(q).is_none()
            && let Some(renamed) = target.q
        {
            let name = Span::new(item.span.start, item.span.start + item.name.len());
            let finding = self.at("convert-parameter-renamed", Severity::Note, item.span).arg("parameter", &*item.name);
            let finding = finding.arg("new", renamed.to_string()).arg("cycle", definition.key.to_string());
            self.found.push(finding.arg("control", self.request.to.on.control.title.as_str()));
            edits.push((name, renamed.to_string()));
            q = renamed;
        }
        let at = other.params.iter().position(|param| std::ptr::eq(param, target));
        if let (Some(span), Some(own_at), Some(at)) = (item.label, item.index, at)
            && let Some(label) =
                self.label(own, other, self.program.slice(span), |l| l.params.get(own_at), |l| l.params.get(at))
            && self.writable(&label, span)
        {
            edits.push((span, label));
        }
        let mut text = Cow::Borrowed(text);
        for (span, new) in edits.into_iter().rev() {
            let range = span.start.saturating_sub(start)..span.end.saturating_sub(start);
            if text.get(range.clone()).is_some() {
                text.to_mut().replace_range(range, &new);
            }
        }
        Some(Piece { q: Some(q), text })
    }

    /// The label of the other control, if what is printed is a label of the first one and the other's differs.
    fn label(
        &self,
        own: &Cycle,
        other: &Cycle,
        text: &str,
        pick_own: impl Fn(&crate::check::LanguageLabels) -> Option<&ParamLabels>,
        pick: impl Fn(&crate::check::LanguageLabels) -> Option<&ParamLabels>,
    ) -> Option<String> {
        let languages = &self.request.from.labels.cycle(own.key)?.languages;
        let spoken = languages.iter().filter(|language| pick_own(language).is_some_and(|label| label.matches(text)));
        // A label that several languages share is one of the program's language.
        let tags: Vec<&str> = spoken.map(|language| language.tag.as_str()).collect();
        let tag = tags.iter().find(|tag| **tag == self.language()).or_else(|| tags.first())?;
        let target = self.request.to.labels.cycle(other.key)?.language(tag)?;
        let label = pick(target)?;
        if label.matches(text) {
            return None;
        }
        label.label.clone()
    }

    fn head<'t>(
        &mut self,
        definition: &Definition<'_>,
        own: &Cycle,
        other: &Cycle,
        text: &'t str,
        start: usize,
    ) -> Cow<'t, str> {
        let mut text = Cow::Borrowed(text);
        let Some(span) = definition.view.name else { return text };
        let printed = self.program.slice(span);
        let name = self.label(own, other, printed, |l| Some(&l.name), |l| Some(&l.name));
        if let Some(name) = name
            && self.writable(&name, span)
        {
            let range = span.start.saturating_sub(start)..span.end.saturating_sub(start);
            if text.get(range.clone()).is_some() {
                text.to_mut().replace_range(range, &name);
            }
        }
        text
    }

    /// Adds the parameters that the first control lacks.
    fn add(
        &mut self,
        definition: &Definition<'_>,
        own: &Cycle,
        other: &Cycle,
        style: &Style<'_>,
        pieces: &mut Vec<Piece<'_>>,
    ) {
        for (at, param) in other.params.iter().enumerate() {
            let Some(q) = param.q else { continue };
            let there = own.written(q).is_some() || pieces.iter().any(|piece| piece.q == Some(q));
            if there {
                continue;
            }
            let Some(value) = param.imported.or(param.neutral) else {
                self.no_value(definition.key, &q.to_string(), definition.view.head);
                continue;
            };
            let value = printed(param, value);
            let labels = self.labels(&self.request.to, other.key);
            let label = labels.and_then(|labels| labels.params.get(at)?.label.clone()).unwrap_or_default();
            let label = if self.writable(&label, definition.view.head) { label } else { String::new() };
            let text = format!("{}{q}={value} ;{label}{}", style.indent, style.end);
            self.added(definition.key, &q.to_string(), &value, definition.view.head, param.imported.is_some());
            let before = other.params.iter().take(at).rev().filter_map(|param| param.q);
            let mut before = before.filter_map(|q| pieces.iter().rposition(|piece| piece.q == Some(q)));
            let place = before.next().map_or(0, |at| at + 1);
            pieces.insert(place, Piece { q: Some(q), text: Cow::Owned(text) });
        }
    }
}

/// The parameter of the other control: that of the same number, else one of the same meaning that the first control
/// does not have under its number.
fn counterpart<'o>(own: &Cycle, other: &'o Cycle, param: &Param, q: QRef) -> Option<&'o Param> {
    other.written(q).or_else(|| {
        let mut like = other
            .params
            .iter()
            .filter(|new| new.is.as_str() == param.is.as_str() && new.q.is_some_and(|q| own.written(q).is_none()));
        like.next().filter(|_| like.next().is_none())
    })
}

/// Whether a value does what a control without the parameter does anyway.
fn is_neutral(other: &Cycle, param: &Param, printed: &str) -> bool {
    let Ok(value) = printed.trim().parse::<f64>() else { return false };
    let lacking = other.lacking.iter().find(|(q, _)| Some(*q) == param.q).map(|(_, value)| *value);
    param.neutral.or(lacking).is_some_and(|neutral| neutral == value)
}

/// Puts the pieces in the other control's order, if the two controls have what they share in different orders.
fn arrange(own: &Cycle, other: &Cycle, pieces: &mut [Piece<'_>]) {
    let place = |q: Option<QRef>| {
        q.and_then(|q| other.params.iter().position(|param| param.q == Some(q) || param.q_of_name() == Some(q)))
    };
    let shared: Vec<usize> = own.params.iter().filter_map(|param| place(param.q)).collect();
    if shared.is_sorted() {
        return;
    }
    // What the other control does not know keeps its place after the parameter before it.
    let mut last = 0;
    let mut keyed: Vec<(usize, usize)> = Vec::with_capacity(pieces.len());
    for (at, piece) in pieces.iter().enumerate() {
        last = place(piece.q).unwrap_or(last);
        keyed.push((last, at));
    }
    keyed.sort_unstable();
    let mut texts: Vec<Option<(Option<QRef>, String)>> =
        pieces.iter().map(|piece| Some((piece.q, piece.text.to_string()))).collect();
    for (piece, (_, from)) in pieces.iter_mut().zip(keyed) {
        if let Some((q, text)) = texts.get_mut(from).and_then(Option::take) {
            piece.q = q;
            piece.text = Cow::Owned(text);
        }
    }
}

fn line_start(text: &str, at: usize) -> usize {
    text.get(..at).and_then(|before| before.rfind(['\n', '\r'])).map_or(0, |end| end + 1)
}

/// A piece with or without the sign that the block continues after its last line.
fn joined<'t>(piece: &'t str, goes_on: bool, style: &Style<'_>) -> Cow<'t, str> {
    let body = piece.trim_end_matches(['\n', '\r']);
    let end = piece.get(body.len()..).filter(|end| !end.is_empty()).unwrap_or(style.end);
    let trimmed = body.trim_end_matches([' ', '\t']);
    let marked = trimmed.ends_with('~');
    match (goes_on, marked, style.mark.as_deref()) {
        (true, true, _) | (false, false, _) | (true, false, None) if piece.len() > body.len() => Cow::Borrowed(piece),
        (true, true, _) | (false, false, _) | (true, false, None) => Cow::Owned(format!("{body}{end}")),
        (true, false, Some(mark)) => Cow::Owned(format!("{trimmed}{mark}{end}")),
        (false, true, _) => {
            let bare = trimmed.trim_end_matches('~').trim_end_matches([' ', '\t']);
            Cow::Owned(format!("{bare}{end}"))
        }
    }
}
