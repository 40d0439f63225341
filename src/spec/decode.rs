//! Trees into types: one definition gives the type, its decoding with all mistakes at their places,
//! and its JSON Schema.
//!
//! Invariant: knows the shape of data, not its meaning; meaning is checked in `lint`.
use std::sync::Arc;

use serde_json::{Map, Value, json};

use super::yaml::{Kind, Node};
use crate::base::demand::Deferred;
use crate::base::diag::{Diagnostic, Place, Source};
use crate::base::expr::{Dialect, Expr, QRef, parse};

/// Where mistakes of one file go.
pub struct Context<'c> {
    /// The file.
    pub source: &'c Arc<Source>,
    /// The mistakes so far.
    pub found: &'c mut Vec<Diagnostic>,
}

impl Context<'_> {
    /// The place of a node.
    pub fn place(&self, node: &Node) -> Place {
        Place::new(self.source, node.span)
    }

    /// Reports that something else was expected.
    pub fn expected(&mut self, node: &Node, expected: &str) {
        let shown = node.shown(self.source);
        let place = self.place(node);
        self.found.push(Diagnostic::error("spec-expected", place).arg("expected", expected).arg("found", shown));
    }

    /// Reports a key that means nothing here.
    pub fn unknown_key(&mut self, key: &super::yaml::Key, known: &[&str]) {
        let place = Place::new(self.source, key.span);
        let known = known.join(", ");
        self.found.push(Diagnostic::error("spec-unknown-key", place).arg("key", &*key.text).arg("known", known));
    }
}

/// The definitions of a JSON Schema while it is made.
pub type Definitions = Map<String, Value>;

/// What can be read from a node.
pub trait Decode: Sized {
    /// The value of the node, or nothing after a mistake was reported.
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self>;

    /// The value if the key is not there at all; nothing if the key is required.
    fn absent() -> Option<Self> {
        None
    }

    /// The JSON Schema of the value.
    fn schema(defs: &mut Definitions) -> Value;
}

impl<T: Decode> Decode for Option<T> {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        if matches!(&node.kind, Kind::Scalar(text, true) if matches!(&**text, "" | "~" | "null")) {
            return Some(None);
        }
        T::decode(node, cx).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }

    fn schema(defs: &mut Definitions) -> Value {
        json!({"anyOf": [T::schema(defs), {"type": "null"}]})
    }
}

impl<T: Decode> Decode for Vec<T> {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let Kind::List(items) = &node.kind else {
            cx.expected(node, "list");
            return None;
        };
        // Every item is read even after a mistake, so that all mistakes show in one run.
        Some(items.iter().filter_map(|item| T::decode(item, cx)).collect())
    }

    fn absent() -> Option<Self> {
        Some(Vec::new())
    }

    fn schema(defs: &mut Definitions) -> Value {
        json!({"type": "array", "items": T::schema(defs)})
    }
}

impl<T: Decode> Decode for Box<T> {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        T::decode(node, cx).map(Box::new)
    }

    fn schema(defs: &mut Definitions) -> Value {
        T::schema(defs)
    }
}

impl<T: Decode + Default> Decode for Deferred<T> {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        T::decode(node, cx).map(Self::from)
    }

    fn absent() -> Option<Self> {
        T::absent().map(Self::from)
    }

    fn schema(defs: &mut Definitions) -> Value {
        T::schema(defs)
    }
}

/// A mapping with free keys, in the order of the file.
#[derive(Clone, Debug)]
pub struct Entries<T>(pub Vec<(Name, T)>);

impl<T> Default for Entries<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T: Decode> Decode for Entries<T> {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let Kind::Map(entries) = &node.kind else {
            cx.expected(node, "mapping");
            return None;
        };
        let read = |(key, value): &(super::yaml::Key, Node)| {
            let name = Name { text: Arc::clone(&key.text), place: Place::new(cx.source, key.span) };
            T::decode(value, cx).map(|value| (name, value))
        };
        Some(Self(entries.iter().filter_map(read).collect()))
    }

    fn absent() -> Option<Self> {
        Some(Self::default())
    }

    fn schema(defs: &mut Definitions) -> Value {
        let vary = json!({"type": "array", "items": {"type": "object"}});
        json!({"type": "object", "properties": {"vary": vary}, "additionalProperties": T::schema(defs)})
    }
}

impl<T> Entries<T> {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&T> {
        self.0.iter().find(|(name, _)| name.as_str() == key).map(|(_, value)| value)
    }
}

/// A text with its place: an id, a name, a literal.
#[derive(Clone, Debug)]
pub struct Name {
    /// The text.
    pub text: Arc<str>,
    /// Its place.
    pub place: Place,
}

impl Name {
    /// The text.
    pub fn as_str(&self) -> &str {
        &self.text
    }
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Decode for Name {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        match &node.kind {
            Kind::Scalar(text, _) => Some(Self { text: Arc::clone(text), place: cx.place(node) }),
            _ => {
                cx.expected(node, "text");
                None
            }
        }
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": ["string", "number"]})
    }
}

impl Decode for String {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        Name::decode(node, cx).map(|name| name.text.as_ref().to_owned())
    }

    fn schema(defs: &mut Definitions) -> Value {
        Name::schema(defs)
    }
}

impl Decode for f64 {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let number = node.text().and_then(|text| text.parse::<f64>().ok()).filter(|n| n.is_finite());
        if number.is_none() {
            cx.expected(node, "number");
        }
        number
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "number"})
    }
}

impl Decode for u32 {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let number = node.text().and_then(|text| text.parse::<u32>().ok());
        if number.is_none() {
            cx.expected(node, "whole-number");
        }
        number
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "integer", "minimum": 0})
    }
}

impl Decode for bool {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        match &node.kind {
            Kind::Scalar(text, true) if &**text == "true" => Some(true),
            Kind::Scalar(text, true) if &**text == "false" => Some(false),
            _ => {
                cx.expected(node, "true-or-false");
                None
            }
        }
    }

    fn absent() -> Option<Self> {
        Some(false)
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "boolean"})
    }
}

impl Decode for QRef {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let q = node.text().and_then(QRef::parse);
        if q.is_none() {
            cx.expected(node, "q-parameter");
        }
        q
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "string", "pattern": "^Q[LRS]?[0-9]{1,5}$"})
    }
}

/// An expression with its place.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The expression; spans count from the start of the text.
    pub expr: Expr,
    /// As written.
    pub text: Arc<str>,
    /// Its place.
    pub place: Place,
}

impl Formula {
    /// The place of a stretch of the expression; all of it where the file breaks its lines or escapes characters.
    pub fn at(&self, span: crate::base::diag::Span) -> Place {
        let whole = self.place.span;
        let written = self.place.source.text().get(whole.start..whole.end);
        let Some(before) = written.and_then(|written| written.find(&*self.text)) else { return self.place.clone() };
        let begin = whole.start + before;
        let start = (begin + span.start).min(whole.end);
        Place::new(&self.place.source, start..(begin + span.end).clamp(start, whole.end))
    }
}

impl Decode for Formula {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let name = Name::decode(node, cx)?;
        match parse(&name.text, Dialect::Spec) {
            Ok(expr) => Some(Self { expr, text: name.text, place: name.place }),
            Err(error) => {
                let shell = Self {
                    expr: Expr { node: crate::base::expr::Node::Number(0.0), span: error.span },
                    text: name.text,
                    place: name.place,
                };
                let diagnostic = Diagnostic::error("spec-expression", shell.at(error.span));
                cx.found.push(diagnostic.arg("expected", error.expected).arg("found", error.found));
                None
            }
        }
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": ["string", "number"], "description": "an expression"})
    }
}

/// Defines a record: its type, decoding and schema.
macro_rules! record {
    ($(#[doc = $doc:literal])+ pub struct $name:ident {
        $($(#[doc = $field_doc:literal])+ $field:ident $(as $key:literal)? : $ty:ty,)*
    }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Debug)]
        pub struct $name {
            $($(#[doc = $field_doc])+ pub $field: $ty,)*
            /// Its place.
            pub place: $crate::base::diag::Place,
        }

        impl $crate::spec::decode::Decode for $name {
            fn decode(node: &$crate::spec::yaml::Node, cx: &mut $crate::spec::decode::Context<'_>) -> Option<Self> {
                let $crate::spec::yaml::Kind::Map(entries) = &node.kind else {
                    cx.expected(node, "mapping");
                    return None;
                };
                let known = [$($crate::spec::decode::key!($field $($key)?)),*];
                for (key, _) in entries {
                    if !known.contains(&&*key.text) {
                        cx.unknown_key(key, &known);
                    }
                }
                let place = cx.place(node);
                // Every field is read before the record fails, so that all mistakes show at once.
                $(let $field = {
                    let key = $crate::spec::decode::key!($field $($key)?);
                    $crate::spec::decode::field::<$ty>(node, key, cx)
                };)*
                Some(Self { $($field: $field?,)* place })
            }

            fn schema(defs: &mut $crate::spec::decode::Definitions) -> serde_json::Value {
                let name = stringify!($name);
                if !defs.contains_key(name) {
                    defs.insert(name.to_owned(), serde_json::Value::Null);
                    let mut properties = serde_json::Map::new();
                    let mut required: Vec<&str> = Vec::new();
                    $({
                        let key = $crate::spec::decode::key!($field $($key)?);
                        let mut schema = <$ty as $crate::spec::decode::Decode>::schema(defs);
                        let text = concat!($($field_doc),+).trim();
                        if let Some(object) = schema.as_object_mut() {
                            object.insert("description".to_owned(), text.into());
                        }
                        properties.insert(key.to_owned(), schema);
                        if <$ty as $crate::spec::decode::Decode>::absent().is_none() {
                            required.push(key);
                        }
                    })*
                    $crate::spec::decode::filters(&mut properties);
                    let schema = serde_json::json!({
                        "type": "object", "description": concat!($($doc),+).trim(), "properties": properties,
                        "required": required, "additionalProperties": false,
                    });
                    defs.insert(name.to_owned(), schema);
                }
                serde_json::json!({"$ref": format!("#/$defs/{name}")})
            }
        }
    };
}
pub(crate) use record;

macro_rules! key {
    ($field:ident) => {
        stringify!($field)
    };
    ($field:ident $key:literal) => {
        $key
    };
}
pub(crate) use key;

/// Reads one field of a record.
pub(super) fn field<T: Decode>(node: &Node, key: &str, cx: &mut Context<'_>) -> Option<T> {
    if let Some(value) = node.get(key) {
        return T::decode(value, cx);
    }
    let absent = T::absent();
    if absent.is_none() {
        let place = Place::new(cx.source, node.span.start..first_line_end(cx.source, node));
        cx.found.push(Diagnostic::error("spec-missing-key", place).arg("key", key));
    }
    absent
}

/// A missing key is shown on the first line of its mapping only.
fn first_line_end(source: &Source, node: &Node) -> usize {
    let text = source.text().get(node.span.start..node.span.end).unwrap_or_default();
    node.span.start + text.find('\n').unwrap_or(text.len())
}

/// Adds the filters and overrides that any item of a list may carry.
pub(super) fn filters(properties: &mut Map<String, Value>) {
    let list = json!({"type": "array", "items": {"type": "string"}, "minItems": 1});
    properties.insert("only".to_owned(), list.clone());
    properties.insert("except".to_owned(), list);
    properties.insert("vary".to_owned(), json!({"type": "array", "items": {"type": "object"}}));
}

/// Defines an enumeration of words: its type, decoding and schema.
macro_rules! words {
    ($(#[doc = $doc:literal])+ pub enum $name:ident {
        $($(#[doc = $word_doc:literal])+ $variant:ident = $word:literal,)+
    }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name { $($(#[doc = $word_doc])+ $variant,)+ }

        impl $name {
            /// All of them, in order.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The word in files.
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $word),+ }
            }

            /// The one of that word.
            pub fn by_word(word: &str) -> Option<Self> {
                match word { $($word => Some(Self::$variant),)+ _ => None }
            }
        }

        impl $crate::spec::decode::Decode for $name {
            fn decode(node: &$crate::spec::yaml::Node, cx: &mut $crate::spec::decode::Context<'_>) -> Option<Self> {
                let value = node.text().and_then(Self::by_word);
                if value.is_none() {
                    cx.expected(node, [$($word),+].join(", ").as_str());
                }
                value
            }

            fn schema(_: &mut $crate::spec::decode::Definitions) -> serde_json::Value {
                serde_json::json!({"enum": [$($word),+]})
            }
        }
    };
}
pub(crate) use words;
