//! The parameters of a cycle definition in little room: long programs have millions of them.
//!
//! Invariant: what is given back is what was put in.
use super::terms::{Parameter, Value, ValueKind};
use crate::base::diag::Span;
use crate::base::expr::{QKind, QRef};

/// Parameters in the order written.
#[derive(Clone, Debug, Default)]
pub struct Parameters(List);

#[derive(Clone, Debug)]
enum List {
    /// With places that count from a byte of the text.
    Packed(usize, Box<[Packed]>),
    /// As they are: one of them is too long, or written in a way that the packed form cannot say.
    Plain(Box<[Parameter]>),
}

impl Default for List {
    fn default() -> Self {
        Self::Packed(0, Box::default())
    }
}

#[derive(Clone, Copy, Debug)]
struct Packed {
    start: u32,
    /// The number, or the parameter that is the value.
    content: [u32; 2],
    q: u16,
    /// Bytes between the name and the value, of the value, between it and the label, and of the label: none for none.
    value_length: u16,
    label_gap: u16,
    label_length: u16,
    value_gap: u8,
    q_length: u8,
    q_kind: QKind,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Number,
    Q,
    MinusQ,
    Word,
    Text,
    Plus,
    Minus,
    Missing,
}

impl Packed {
    /// The parameter in little room; nothing if it would not be the same again.
    fn of(base: usize, own: &Parameter) -> Option<Self> {
        fn between<T: TryFrom<usize>>(from: usize, to: usize) -> Option<T> {
            T::try_from(to.checked_sub(from)?).ok()
        }
        let bits = |bits: u64| [bits as u32, (bits >> 32) as u32];
        let (kind, content) = match own.value.kind {
            ValueKind::Number(number) => (Kind::Number, bits(number.to_bits())),
            ValueKind::Q { negative, q } => {
                (if negative { Kind::MinusQ } else { Kind::Q }, [u32::from(q.number), q.kind as u32])
            }
            ValueKind::Word => (Kind::Word, [0, 0]),
            ValueKind::Text(inside) if inside == inner(own.value.span) => (Kind::Text, [0, 0]),
            ValueKind::Text(_) => return None,
            ValueKind::Sign(minus) => (if minus { Kind::Minus } else { Kind::Plus }, [0, 0]),
            ValueKind::Missing => (Kind::Missing, [0, 0]),
        };
        let (value, label) = (own.value.span, own.label);
        let as_usual = own.q_span.start == own.span.start
            && own.span.end == end_of(own.q_span, value)
            && label.is_none_or(|label| label.start < label.end);
        Some(Self {
            start: between(base, own.span.start).filter(|_| as_usual)?,
            content,
            q: own.q.number,
            value_length: between(value.start, value.end)?,
            label_gap: label.map_or(Some(0), |label| between(value.end, label.start))?,
            label_length: label.map_or(Some(0), |label| between(label.start, label.end))?,
            value_gap: between(own.q_span.end, value.start)?,
            q_length: between(own.q_span.start, own.q_span.end)?,
            q_kind: own.q.kind,
            kind,
        })
    }

    const fn q(&self) -> QRef {
        QRef { kind: self.q_kind, number: self.q }
    }

    /// The place of the name, and that of the value.
    fn places(&self, base: usize) -> (Span, Span) {
        let start = base + self.start as usize;
        let q = Span::new(start, start + usize::from(self.q_length));
        let from = q.end + usize::from(self.value_gap);
        (q, Span::new(from, from + usize::from(self.value_length)))
    }

    /// The value, which has a place.
    fn value(&self, value: Span) -> ValueKind {
        let [low, high] = self.content;
        match self.kind {
            Kind::Number => ValueKind::Number(f64::from_bits(u64::from(low) | (u64::from(high) << 32))),
            Kind::Q => ValueKind::Q { negative: false, q: q_of(low, high) },
            Kind::MinusQ => ValueKind::Q { negative: true, q: q_of(low, high) },
            Kind::Word => ValueKind::Word,
            Kind::Text => ValueKind::Text(inner(value)),
            Kind::Plus => ValueKind::Sign(false),
            Kind::Minus => ValueKind::Sign(true),
            Kind::Missing => ValueKind::Missing,
        }
    }

    fn unpacked(&self, base: usize) -> Parameter {
        let (q_span, value) = self.places(base);
        let label = value.end + usize::from(self.label_gap);
        Parameter {
            span: Span::new(q_span.start, end_of(q_span, value)),
            q: self.q(),
            q_span,
            value: Value { span: value, kind: self.value(value) },
            label: (self.label_length > 0).then(|| Span::new(label, label + usize::from(self.label_length))),
        }
    }
}

/// Where a parameter ends: with its value, or with the `=` after its name.
fn end_of(q: Span, value: Span) -> usize {
    value.end.max(q.end + 1)
}

/// The place of a text without its quotation marks.
const fn inner(span: Span) -> Span {
    Span::new(span.start + 1, span.end.saturating_sub(1))
}

fn q_of(number: u32, kind: u32) -> QRef {
    let kind = [QKind::Q, QKind::Ql, QKind::Qr, QKind::Qs].into_iter().find(|own| *own as u32 == kind);
    QRef { kind: kind.unwrap_or(QKind::Q), number: u16::try_from(number).unwrap_or_default() }
}

impl From<&[Parameter]> for Parameters {
    fn from(list: &[Parameter]) -> Self {
        let base = list.first().map_or(0, |own| own.span.start);
        let mut packed = Vec::with_capacity(list.len());
        for own in list {
            match Packed::of(base, own) {
                Some(own) => packed.push(own),
                None => return Self(List::Plain(list.into())),
            }
        }
        Self(List::Packed(base, packed.into_boxed_slice()))
    }
}

impl Parameters {
    /// How many there are.
    pub const fn len(&self) -> usize {
        match &self.0 {
            List::Packed(_, list) => list.len(),
            List::Plain(list) => list.len(),
        }
    }

    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The parameter at a place.
    pub fn get(&self, at: usize) -> Option<Parameter> {
        match &self.0 {
            List::Packed(base, list) => list.get(at).map(|own| own.unpacked(*base)),
            List::Plain(list) => list.get(at).copied(),
        }
    }

    /// What is written for each, in the order written; the places in texts count from the first parameter.
    pub(crate) fn each_value(&self, mut each: impl FnMut(QRef, ValueKind)) {
        match &self.0 {
            List::Packed(_, list) => {
                for own in list {
                    each(own.q(), own.value(own.places(0).1));
                }
            }
            List::Plain(list) => list.iter().for_each(|own| each(own.q, own.value.kind)),
        }
    }

    /// All of them, in the order written.
    pub fn iter(&self) -> Iter<'_> {
        Iter { list: self, rest: 0..self.len() }
    }

    /// All of them as other blocks have them.
    pub fn to_vec(&self) -> Vec<Parameter> {
        self.iter().collect()
    }
}

/// Parameters one after the other.
#[derive(Clone, Debug)]
pub struct Iter<'p> {
    list: &'p Parameters,
    rest: std::ops::Range<usize>,
}

impl Iterator for Iter<'_> {
    type Item = Parameter;

    fn next(&mut self) -> Option<Parameter> {
        self.list.get(self.rest.next()?)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.rest.size_hint()
    }
}

impl DoubleEndedIterator for Iter<'_> {
    fn next_back(&mut self) -> Option<Parameter> {
        self.list.get(self.rest.next_back()?)
    }
}

impl ExactSizeIterator for Iter<'_> {}

impl<'p> IntoIterator for &'p Parameters {
    type Item = Parameter;
    type IntoIter = Iter<'p>;

    fn into_iter(self) -> Iter<'p> {
        self.iter()
    }
}
