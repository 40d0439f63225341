//! The values that a text is formatted with.
//!
//! Invariant: a value is text, a number or a list of text; nothing else reaches Fluent.
use std::borrow::Cow;

use fluent::FluentArgs;
use fluent::types::{FluentType, FluentValue};

use crate::base::diag::{Arg, Diagnostic};

/// The arguments of one text, by name.
#[derive(Debug, Default)]
pub struct Args<'a>(FluentArgs<'a>);

impl<'a> Args<'a> {
    /// No arguments.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same with a text, shown as it is.
    pub fn text(mut self, name: &'a str, value: impl Into<Cow<'a, str>>) -> Self {
        self.0.set(name, FluentValue::String(value.into()));
        self
    }

    /// The same with a number, shown as the language writes it.
    pub fn number(mut self, name: &'a str, value: f64) -> Self {
        self.0.set(name, FluentValue::from(value));
        self
    }

    /// The same with a list of texts, for `LIST()`.
    pub fn list<T: Into<String>>(mut self, name: &'a str, items: impl IntoIterator<Item = T>) -> Self {
        let items = items.into_iter().map(Into::into).collect();
        self.0.set(name, FluentValue::Custom(Box::new(List(items))));
        self
    }

    /// The arguments of a diagnostic.
    pub fn of(diagnostic: &'a Diagnostic) -> Self {
        diagnostic.args.iter().fold(Self::new(), |args, (name, value)| match value {
            Arg::Text(text) => args.text(name, text.as_str()),
            Arg::Number(number) => args.number(name, *number),
        })
    }

    pub(super) fn fluent(&self) -> &FluentArgs<'a> {
        &self.0
    }
}

/// A list of texts as a Fluent value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct List(pub(super) Vec<String>);

impl FluentType for List {
    fn duplicate(&self) -> Box<dyn FluentType + Send> {
        Box::new(self.clone())
    }

    fn as_string(&self, _: &intl_memoizer::IntlLangMemoizer) -> Cow<'static, str> {
        self.0.join(", ").into()
    }

    fn as_string_threadsafe(&self, _: &intl_memoizer::concurrent::IntlLangMemoizer) -> Cow<'static, str> {
        self.0.join(", ").into()
    }
}
