//! The functions that messages may call: `NUMBER`, `UNIT` and `LIST`.
//!
//! A Fluent function cannot report why it failed, and one that fails in a selector chooses the
//! default without a word; so a fault is left on a slate of the thread, which the language reads
//! after each text. Invariant: every refusal leaves a fault there.
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use fluent::FluentArgs;
use fluent::types::{AnyEq, FluentNumber, FluentNumberOptions, FluentValue};

use super::args::List;
use super::error::Fault;
use super::number::{Digits, MOST_DIGITS, Numbers};
use super::pattern::Template;

/// The functions with the options that each of them knows.
pub(super) const FUNCTIONS: [(&str, &[&str]); 3] = [
    ("NUMBER", &["minimumFractionDigits", "maximumFractionDigits", "type"]),
    ("UNIT", &["minimumFractionDigits", "maximumFractionDigits"]),
    ("LIST", &["type"]),
];

/// The templates for a list: two items or the last joint, and the joints before it.
#[derive(Clone, Debug)]
pub(super) struct ListForm {
    pub(super) last: Template,
    pub(super) more: Template,
}

/// What the functions of one language need.
#[derive(Debug)]
pub(super) struct Forms {
    pub(super) numbers: Numbers,
    pub(super) units: HashMap<String, Template>,
    pub(super) lists: HashMap<String, ListForm>,
}

impl Forms {
    /// Those of a language before its units and lists are read.
    pub(super) fn of(tag: &str) -> Self {
        Self { numbers: Numbers::of(tag), units: HashMap::new(), lists: HashMap::new() }
    }
}

impl Default for Forms {
    fn default() -> Self {
        Self { numbers: Numbers::plain(), units: HashMap::new(), lists: HashMap::new() }
    }
}

#[derive(Default)]
struct Slate {
    forms: Option<Arc<Forms>>,
    fault: Option<Fault>,
}

thread_local! {
    static SLATE: RefCell<Slate> = RefCell::default();
}

/// Formats with a clean slate; gives the result with the fault that a function left.
pub(super) fn with_slate<T>(forms: &Arc<Forms>, format: impl FnOnce() -> T) -> (T, Option<Fault>) {
    SLATE.with_borrow_mut(|slate| *slate = Slate { forms: Some(Arc::clone(forms)), fault: None });
    let result = format();
    (result, SLATE.take().fault)
}

fn refuse<'a>(function: &'static str, reason: &'static str) -> FluentValue<'a> {
    SLATE.with_borrow_mut(|slate| {
        slate.fault.get_or_insert(Fault::FunctionFailed(function, reason));
    });
    FluentValue::Error
}

/// How Fluent shows a value that no function has turned into text.
pub(super) fn show<M>(value: &FluentValue<'_>, _: &M) -> Option<String> {
    let FluentValue::Number(number) = value else { return None };
    let forms = SLATE.with_borrow(|slate| slate.forms.clone());
    let text = forms.and_then(|forms| forms.numbers.prose(number.value, digits(&number.options)));
    Some(text.unwrap_or_else(|| {
        refuse("NUMBER", "not-finite");
        String::new()
    }))
}

fn digits(options: &FluentNumberOptions) -> Digits {
    let narrow = |count: usize| u8::try_from(count).unwrap_or(MOST_DIGITS).min(MOST_DIGITS);
    Digits {
        minimum: options.minimum_fraction_digits.map_or(0, narrow),
        maximum: options.maximum_fraction_digits.map(narrow),
    }
}

fn number<'a>(
    function: &'static str,
    value: Option<&FluentValue<'a>>,
    named: &FluentArgs,
) -> Result<FluentNumber, FluentValue<'a>> {
    let Some(FluentValue::Number(number)) = value else {
        return Err(refuse(function, "not-a-number"));
    };
    if !number.value.is_finite() {
        return Err(refuse(function, "not-finite"));
    }
    let mut number = number.clone();
    number.options.merge(named);
    // Fluent's plural rules overflow beyond 19 digits.
    for count in [&mut number.options.minimum_fraction_digits, &mut number.options.maximum_fraction_digits] {
        *count = count.map(|count| count.min(usize::from(MOST_DIGITS)));
    }
    Ok(number)
}

/// `NUMBER($x, minimumFractionDigits: …, maximumFractionDigits: …)`: a number that still selects plurals.
pub(super) fn number_function<'a>(positional: &[FluentValue<'a>], named: &FluentArgs) -> FluentValue<'a> {
    match number("NUMBER", positional.first(), named) {
        Ok(number) => FluentValue::Number(number),
        Err(refused) => refused,
    }
}

/// `UNIT($x, "mm", …)`: a number with its unit, as the message `unit-mm` has it.
pub(super) fn unit_function<'a>(forms: &Forms, positional: &[FluentValue<'a>], named: &FluentArgs) -> FluentValue<'a> {
    let number = match number("UNIT", positional.first(), named) {
        Ok(number) => number,
        Err(refused) => return refused,
    };
    let Some(FluentValue::String(name)) = positional.get(1) else {
        return refuse("UNIT", "no-unit");
    };
    let Some(template) = forms.units.get(name.as_ref()) else {
        return refuse("UNIT", "unknown-unit");
    };
    match forms.numbers.prose(number.value, digits(&number.options)) {
        Some(text) => FluentValue::String(template.fill(&[&text]).into()),
        None => refuse("UNIT", "not-finite"),
    }
}

/// `LIST($items, type: "or")`: a list as the message `list-or` has it; `and` if no type is given.
pub(super) fn list_function<'a>(forms: &Forms, positional: &[FluentValue<'a>], named: &FluentArgs) -> FluentValue<'a> {
    let items = match positional.first() {
        Some(FluentValue::Custom(custom)) => AnyEq::as_any(&**custom).downcast_ref::<List>(),
        _ => None,
    };
    let Some(List(items)) = items else {
        return refuse("LIST", "not-a-list");
    };
    let name = match named.get("type") {
        Some(FluentValue::String(name)) => name.as_ref(),
        _ => "and",
    };
    match forms.lists.get(name) {
        Some(form) => FluentValue::String(joined(form, items).into()),
        None => refuse("LIST", "unknown-type"),
    }
}

fn joined(form: &ListForm, items: &[String]) -> String {
    let Some((last, before)) = items.split_last() else { return String::new() };
    let before = before.iter().fold(String::new(), |so_far, item| match so_far.as_str() {
        "" => item.clone(),
        so_far => form.more.fill(&[so_far, item]),
    });
    if before.is_empty() { last.clone() } else { form.last.fill(&[&before, last]) }
}
