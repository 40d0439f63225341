//! What the rules about values share: why a parameter refuses what is written.
//!
//! Parameters whose value is another parameter are never refused: it is known when the program runs.
use crate::check::{Facts, Item};
use crate::spec::{Param, ParameterKind, Quantity, Refusal, refusal};
use crate::syntax::ValueKind;

/// Why a value is refused.
pub(super) fn refused(facts: &Facts<'_>, param: &Param, item: &Item<'_>) -> Option<Refusal> {
    let takes_text = matches!(param.kind, ParameterKind::Text | ParameterKind::NumberOrName);
    match item.value.map(|value| value.kind) {
        Some(ValueKind::Missing) => return Some(Refusal::Kind),
        Some(ValueKind::Q { q, .. }) if q.kind == crate::expr::QKind::Qs => {
            return (!takes_text).then_some(Refusal::Kind);
        }
        Some(ValueKind::Q { .. }) => return None,
        _ => {}
    }
    let refusal = refusal(param, &single_signed(&item.printed))?;
    // The manuals print ranges in mm.
    let length = facts.inch && matches!(param.quantity, Quantity::Length | Quantity::Feed);
    let ranged = matches!(refusal, Refusal::Below(_) | Refusal::Above(_));
    (!(length && ranged)).then_some(refusal)
}

/// Two signs stand for their product, as the control reads them.
fn single_signed(printed: &str) -> String {
    [("+-", "-"), ("-+", "-"), ("--", "+"), ("++", "+")]
        .iter()
        .fold(printed.to_owned(), |text, (two, one)| text.replace(two, one))
}

/// Runs through all values and the reasons to refuse them.
pub(super) fn each_refused<'f, 'a>(
    facts: &'f Facts<'a>,
    mut tell: impl FnMut(&'f Item<'a>, &'a Param, Refusal, String),
) {
    for (definition, _) in facts.described() {
        for item in &definition.items {
            let Some(param) = item.param else { continue };
            if let Some(refusal) = refused(facts, param, item) {
                tell(item, param, refusal, definition.key.to_string());
            }
        }
    }
}
