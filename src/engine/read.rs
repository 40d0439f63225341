//! Reads the data of worlds (scenes, machines) from YAML trees with places.
//!
//! Invariant: every mistake is reported at its place and reading goes on, so one run shows all of them; a
//! key that no one asked for is a mistake.
use crate::base::diag::{Arg, Diagnostic, Place, Source};
use crate::engine::geometry::Axis;
use crate::spec::{Key, Kind, Node};
use glam::DVec3;
use std::sync::Arc;

/// Reads the nodes of one source.
pub(in crate::engine) struct Reader<'r> {
    /// Where the nodes come from.
    pub(in crate::engine) source: &'r Arc<Source>,
    /// The mistakes so far.
    pub(in crate::engine) found: Vec<Diagnostic>,
    /// mm in the unit of lengths.
    pub(in crate::engine) scale: f64,
}

impl<'r> Reader<'r> {
    pub(in crate::engine) fn new(source: &'r Arc<Source>) -> Self {
        Self { source, found: Vec::new(), scale: 1.0 }
    }

    pub(in crate::engine) fn report(&mut self, code: &'static str, node: &Node, args: Vec<(&'static str, Arg)>) {
        let place = Place::new(self.source, node.span);
        self.found.push(Diagnostic { args, ..Diagnostic::error(code, place) });
    }

    /// Reports that something else was expected; `expected` is a word of the message's selector.
    pub(in crate::engine) fn expected(&mut self, node: &Node, expected: &'static str) {
        let shown = node.shown(self.source);
        self.report("scene-expected", node, vec![("expected", expected.into()), ("found", shown.into())]);
    }

    /// The entries of a mapping.
    pub(in crate::engine) fn entries<'n>(&mut self, node: &'n Node) -> &'n [(Key, Node)] {
        if let Kind::Map(entries) = &node.kind {
            return entries;
        }
        self.expected(node, "mapping");
        &[]
    }

    /// The items of a list.
    pub(in crate::engine) fn items<'n>(&mut self, node: &'n Node) -> &'n [Node] {
        if let Kind::List(items) = &node.kind {
            return items;
        }
        self.expected(node, "list");
        &[]
    }

    pub(in crate::engine) fn unknown_key(&mut self, key: &Key, known: &[&str]) {
        let place = Place::new(self.source, key.span);
        let args = vec![("key", Arg::from(&*key.text)), ("known", known.join(", ").into())];
        self.found.push(Diagnostic { args, ..Diagnostic::error("scene-unknown-key", place) });
    }

    /// Reports the keys of a mapping that are not known. Whether it is a mapping at all.
    pub(in crate::engine) fn only_keys(&mut self, node: &Node, known: &[&str]) -> bool {
        for (key, _) in self.entries(node) {
            if !known.contains(&&*key.text) {
                self.unknown_key(key, known);
            }
        }
        matches!(node.kind, Kind::Map(_))
    }

    /// The value of a key that must be there.
    pub(in crate::engine) fn need<'n>(&mut self, node: &'n Node, key: &'static str) -> Option<&'n Node> {
        let value = node.get(key);
        if value.is_none() && matches!(node.kind, Kind::Map(_)) {
            let text = self.source.text().get(node.span.start..node.span.end).unwrap_or_default();
            // A missing key is shown on the first line of its mapping only.
            let end = node.span.start + text.find(['\r', '\n']).unwrap_or(text.len());
            let place = Place::new(self.source, node.span.start..end);
            self.found.push(Diagnostic::error("scene-missing-key", place).arg("key", key));
        }
        value
    }

    /// A finite number.
    pub(in crate::engine) fn number(&mut self, node: &Node) -> Option<f64> {
        let number = node.text().and_then(|text| text.trim().parse::<f64>().ok()).filter(|number| number.is_finite());
        if number.is_none() {
            self.expected(node, "number");
        }
        number
    }

    /// A length, converted to mm.
    pub(in crate::engine) fn length(&mut self, node: &Node) -> Option<f64> {
        let scale = self.scale;
        self.number(node).map(|number| number * scale)
    }

    /// A length above zero, converted to mm.
    pub(in crate::engine) fn positive(&mut self, node: &Node) -> Option<f64> {
        let length = self.length(node)?;
        if length > 0.0 {
            return Some(length);
        }
        self.report("scene-not-positive", node, vec![("found", (length / self.scale).into())]);
        None
    }

    /// A text.
    pub(in crate::engine) fn text<'n>(&mut self, node: &'n Node) -> Option<&'n str> {
        if node.text().is_none() {
            self.expected(node, "text");
        }
        node.text()
    }

    /// The letter of a linear axis.
    pub(in crate::engine) fn axis(&mut self, node: &Node) -> Option<Axis> {
        let mut letters = node.text().unwrap_or_default().chars();
        let axis = letters.next().and_then(Axis::from_letter).filter(|_| letters.next().is_none());
        if axis.is_none() {
            self.expected(node, "axis");
        }
        axis
    }

    /// Three lengths: a list, or a mapping by axis letter in which a missing axis is 0.
    pub(in crate::engine) fn vector(&mut self, node: &Node) -> Option<DVec3> {
        let scale = self.scale;
        self.triple(node, ["X", "Y", "Z"]).map(|v| v * scale)
    }

    /// Three angles in degrees about X, Y, Z: a list, or a mapping by A, B, C.
    pub(in crate::engine) fn angles(&mut self, node: &Node) -> Option<DVec3> {
        self.triple(node, ["A", "B", "C"])
    }

    /// A position by axis letter, or its linear coordinates as a list: lengths, and angles of rotary axes. A missing
    /// axis is 0.
    pub(in crate::engine) fn position(&mut self, node: &Node) -> Option<(DVec3, DVec3)> {
        if !matches!(node.kind, Kind::Map(_)) {
            return Some((self.vector(node)?, DVec3::ZERO));
        }
        self.only_keys(node, &["X", "Y", "Z", "A", "B", "C"]);
        let mut three = |letters: [&'static str; 3]| {
            let [x, y, z] = letters.map(|letter| node.get(letter).map_or(Some(0.0), |value| self.number(value)));
            Some(DVec3::new(x?, y?, z?))
        };
        let (linear, angles) = (three(["X", "Y", "Z"]), three(["A", "B", "C"]));
        Some((linear? * self.scale, angles?))
    }

    fn triple(&mut self, node: &Node, letters: [&'static str; 3]) -> Option<DVec3> {
        let [x, y, z] = match &node.kind {
            Kind::Map(_) => {
                self.only_keys(node, &letters);
                letters.map(|letter| node.get(letter))
            }
            Kind::List(items) => match items.as_slice() {
                [x, y, z] => [x, y, z].map(Some),
                _ => {
                    self.expected(node, "three-numbers");
                    return None;
                }
            },
            Kind::Scalar(..) => {
                self.expected(node, "three-numbers");
                return None;
            }
        }
        .map(|node| node.map_or(Some(0.0), |node| self.number(node)));
        Some(DVec3::new(x?, y?, z?))
    }
}
