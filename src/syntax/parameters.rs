//! The parameters of a cycle definition in little room: long programs have millions of them.
//!
//! Invariant: what is given back is what was put in.
use super::tree::{Parameter, Value, ValueKind};
use crate::diag::Span;
use crate::expr::QRef;

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
    end: u32,
    value: [u32; 2],
    /// Empty for none.
    label: [u32; 2],
    /// The number, or the parameter that is the value.
    content: [u32; 2],
    q: QRef,
    q_length: u8,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Number,
    Q(bool),
    Word,
    Text,
    Sign(bool),
    Missing,
}

impl Packed {
    fn of(base: usize, own: &Parameter) -> Option<Self> {
        let at = |place: usize| u32::try_from(place.checked_sub(base)?).ok();
        let span = |span: Span| Some([at(span.start)?, at(span.end)?]);
        let [start, end] = span(own.span)?;
        let bits = |bits: u64| [bits as u32, (bits >> 32) as u32];
        let (kind, content) = match own.value.kind {
            ValueKind::Number(number) => (Kind::Number, bits(number.to_bits())),
            ValueKind::Q { negative, q } => (Kind::Q(negative), [u32::from(q.number), q.kind as u32]),
            ValueKind::Word => (Kind::Word, [0, 0]),
            ValueKind::Text(inside) if inside == inner(own.value.span) => (Kind::Text, [0, 0]),
            ValueKind::Text(_) => return None,
            ValueKind::Sign(minus) => (Kind::Sign(minus), [0, 0]),
            ValueKind::Missing => (Kind::Missing, [0, 0]),
        };
        let named = own.q_span.start == own.span.start && own.label.is_none_or(|label| label.start < label.end);
        Some(Self {
            start,
            end,
            value: span(own.value.span)?,
            label: own.label.map_or(Some([0, 0]), span)?,
            content,
            q: own.q,
            q_length: u8::try_from(own.q_span.end - own.q_span.start).ok().filter(|_| named)?,
            kind,
        })
    }

    /// The value, which stands at a place.
    fn value(&self, value: Span) -> ValueKind {
        let [low, high] = self.content;
        match self.kind {
            Kind::Number => ValueKind::Number(f64::from_bits(u64::from(low) | (u64::from(high) << 32))),
            Kind::Q(negative) => ValueKind::Q { negative, q: q_of(low, high) },
            Kind::Word => ValueKind::Word,
            Kind::Text => ValueKind::Text(inner(value)),
            Kind::Sign(minus) => ValueKind::Sign(minus),
            Kind::Missing => ValueKind::Missing,
        }
    }

    fn unpacked(&self, base: usize) -> Parameter {
        let at = |place: u32| base + place as usize;
        let span = |[start, end]: [u32; 2]| Span::new(at(start), at(end));
        let value = span(self.value);
        let kind = self.value(value);
        let start = at(self.start);
        Parameter {
            span: Span::new(start, at(self.end)),
            q: self.q,
            q_span: Span::new(start, start + usize::from(self.q_length)),
            value: Value { span: value, kind },
            label: (self.label[0] < self.label[1]).then(|| span(self.label)),
        }
    }
}

/// The place of a text without its quotation marks.
const fn inner(span: Span) -> Span {
    Span::new(span.start + 1, span.end.saturating_sub(1))
}

fn q_of(number: u32, kind: u32) -> QRef {
    use crate::expr::QKind;
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
                    let [start, end] = own.value;
                    each(own.q, own.value(Span::new(start as usize, end as usize)));
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
