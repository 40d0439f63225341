//! What a case expects and what came out, in the notation of the cases themselves.
//!
//! Invariant: what was not given is left out, so that nothing of the inside of this program is ever shown: no name of a
//! type, no number that is none.
use super::expect::{Action, verb};
use crate::base::diag::Arg;
use crate::engine::geometry::Axis;
use crate::engine::run::{EventKind, Fault, MoveKind, OnDiameter};

/// The word for a value, a list or a movement that is missing.
const NOTHING: &str = "nothing";

/// What reports say in words besides the notation of the cases, with the ends of the ids of its texts
/// (`cli-conform-word-…`). After one that ends with a blank there is more, which is the same in all languages.
pub const WORDS: [(&str, &str); 13] = [
    (NOTHING, "nothing"),
    ("a sound case", "sound-case"),
    ("provoked", "provoked"),
    ("not provoked", "not-provoked"),
    ("executed", "executed"),
    ("not executed", "not-executed"),
    ("a global parameter", "global"),
    ("a local one", "local"),
    ("an answer", "answer"),
    ("an answer of the protocol", "protocol"),
    ("none within the time limit", "time-limit"),
    ("a line without an end, in bytes: ", "endless"),
    ("it ended: ", "ended"),
];

/// The word for what is missing.
pub(super) fn nothing() -> String {
    NOTHING.to_owned()
}

/// A number; the word for what is missing if it is none.
pub(super) fn number(value: f64) -> String {
    if value.is_nan() { nothing() } else { value.to_string() }
}

/// Codes or words in a row.
pub(super) fn list(items: &[impl AsRef<str>]) -> String {
    let items: Vec<&str> = items.iter().map(AsRef::as_ref).collect();
    if items.is_empty() { nothing() } else { items.join(", ") }
}

/// Movements, a line each.
pub(super) fn lines(items: &[String]) -> String {
    if items.is_empty() { nothing() } else { items.join("\n") }
}

/// The code of a fault and what decided.
pub(super) fn fault(fault: &Fault) -> String {
    let value = |value: &Arg| match value {
        Arg::Text(text) => text.clone(),
        Arg::Number(value) => number(*value),
    };
    let args: Vec<String> = fault.args.iter().map(|(name, of)| format!("{name} {}", value(of))).collect();
    if args.is_empty() { fault.code.to_string() } else { format!("{} ({})", fault.code, args.join(", ")) }
}

/// A movement or pause that a case expects.
pub(super) fn action(action: &Action) -> String {
    let coords = action.coords.iter().map(|(axis, value)| (axis.letter(), *value));
    written(&action.verb, coords, action.amount, action.feed)
}

/// A movement or pause of an engine.
pub(super) fn event(kind: &EventKind) -> String {
    let word = verb(kind).unwrap_or_else(|| kind.name());
    let linear = |point: glam::DVec3| Axis::ALL.map(|axis| (axis.letter(), axis.of(point)));
    match kind {
        EventKind::Move { kind: MoveKind::Rapid, to, turned, .. } => {
            written(word, linear(OnDiameter::programmed(*turned, *to)), None, None)
        }
        EventKind::Move { kind: MoveKind::Arc { angle, .. }, to, feed, turned, .. } => {
            written(word, linear(OnDiameter::programmed(*turned, *to)), Some(*angle), Some(*feed))
        }
        EventKind::Move { to, feed, turned, .. } => {
            written(word, linear(OnDiameter::programmed(*turned, *to)), None, Some(*feed))
        }
        EventKind::Turn { axes, feed, rapid, .. } => {
            let ends = axes.iter().map(|turned| (turned.axis.letter(), turned.to));
            written(word, ends, None, (!rapid).then_some(*feed))
        }
        EventKind::Dwell(seconds) => written(word, [], Some(*seconds), None),
        EventKind::Probe(probing) => {
            let touched = probing.contact.map_or(glam::DVec3::NAN, |(touched, _)| touched);
            written(word, linear(touched), None, None)
        }
        _ => word.to_owned(),
    }
}

fn written(
    verb: &str,
    coords: impl IntoIterator<Item = (char, f64)>,
    amount: Option<f64>,
    feed: Option<f64>,
) -> String {
    let (amount, feed) = (amount.filter(|value| !value.is_nan()), feed.filter(|value| !value.is_nan()));
    if verb == "dwell" {
        return format!("{{dwell: {}}}", amount.map_or_else(nothing, number));
    }
    let coords = coords.into_iter().filter(|(_, value)| !value.is_nan());
    let coords: Vec<String> = coords.map(|(letter, value)| format!("{letter}: {value}")).collect();
    let angle = amount.map(|angle| format!(", angle: {angle}")).unwrap_or_default();
    let at = feed.map(|feed| format!(", at: {feed}")).unwrap_or_default();
    format!("{{{verb}: {{{}}}{angle}{at}}}", coords.join(", "))
}
