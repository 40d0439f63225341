//! A text of a parameter that is empty, or that has a character which the parameter does not take.
//!
//! `%` and `\\` are doubled, or before the letter of a sign that is not printed or of a variable. Letters of all
//! languages are passed over.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Rule};
use crate::program::syntax::ValueKind;
use crate::spec::ParameterKind;

pub(super) const RULE: Rule = Rule { code: "text-wrong", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let has = |kind| definition.has_kind(kind);
    if !has(ParameterKind::Text) && !has(ParameterKind::NumberOrName) {
        return;
    }
    for item in &definition.items {
        let (Some(ValueKind::Text(inside)), Some(param)) = (item.value.map(|value| value.kind), item.param) else {
            continue;
        };
        let text = facts.text(inside);
        let finding = || rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
        if text.trim().is_empty() {
            found.push(finding().arg("what", "empty").arg("found", ""));
            continue;
        }
        let Some(characters) = &param.characters else { continue };
        let mut rest = text.chars();
        while let Some(own) = rest.next() {
            let special = matches!(own, '%' | '\\');
            let right = own.is_alphanumeric() || own == ' ' || characters.contains(own);
            // The second half of the pair belongs to it.
            let paired = !special || rest.next().is_some_and(|next| next == own || next.is_ascii_alphabetic());
            if !right || !paired {
                let what = if right { "alone" } else { "character" };
                found.push(finding().arg("what", what).arg("found", own.to_string()));
                break;
            }
        }
    }
}
