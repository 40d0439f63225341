//! A formula that gives a text to a parameter for numbers or the other way round, or that calculates with texts.
//!
//! Texts are joined by `||`; TONUMB and TOCHAR turn one into the other.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::expr::{OnlyParameters, QKind, Type, TypeError, compile};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "text-for-number", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::Formula(formula) = &block.kind else { continue };
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
