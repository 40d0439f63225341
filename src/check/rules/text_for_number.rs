//! A formula that gives a text to a parameter for numbers or the other way round, or that calculates with texts.
//!
//! Texts are joined by `||`; TONUMB and TOCHAR turn one into the other.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{OnlyParameters, QKind, Type, TypeError, compile};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, TextFormula};
use crate::spec::Gives;

pub(super) const RULE: Rule = Rule { code: "text-for-number", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let formula = match &block.kind {
            BlockKind::Formula(formula) => formula,
            BlockKind::TextFormula(formula) => {
                if let Some((what, span)) = text(facts, formula) {
                    found.push(rule.at(facts, span).arg("what", what).arg("parameter", formula.target.to_string()));
                }
                continue;
            }
            _ => continue,
        };
        let target = if formula.target.kind == QKind::Qs { Type::Text } else { Type::Number };
        let (what, span) = match compile(&formula.expr, &OnlyParameters) {
            Ok(code) => match (target, code.ty()) {
                (Type::Number, Type::Text) => ("text", formula.text),
                (Type::Text, Type::Number) => ("number", formula.text),
                _ => continue,
            },
            Err(TypeError::Mismatch { expected: Type::Number, found: Type::Text, span }) => {
                ("calculation", Span::new(formula.text.start + span.start, formula.text.start + span.end))
            }
            Err(_) => continue,
        };
        found.push(rule.at(facts, span).arg("what", what).arg("parameter", formula.target.to_string()));
    }
}

/// What is wrong with a formula of functions on texts: what a lone one gives,
/// or texts that are joined, against the target.
fn text(facts: &Facts<'_>, formula: &TextFormula) -> Option<(&'static str, Span)> {
    let to_text = formula.target.kind == QKind::Qs;
    let written = facts.text(formula.text);
    if written.contains("||") {
        return (!to_text).then_some(("text", formula.text));
    }
    let [call] = formula.calls.as_slice() else { return None };
    let alone = formula.text.start == call.name.start && written.trim_end().ends_with(')');
    let name = facts.text(call.name).trim();
    let mut known = facts.against.catalogue.blocks.iter();
    let gives = known.find(|own| own.block.eq_ignore_ascii_case(name)).and_then(|own| own.gives).filter(|_| alone)?;
    match (gives, to_text) {
        (Gives::Text, false) => Some(("text", formula.text)),
        (Gives::Number, true) => Some(("number", formula.text)),
        _ => None,
    }
}
