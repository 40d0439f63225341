//! The number of a parameter above 1999, of a local or lasting one above 499, or of an M function above 999: there are none.
use crate::check::flow::reads;
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::expr::QKind;
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "number-does-not-exist", severity: Severity::Error, run };

/// The greatest number of Q and QS parameters.
const PARAMETER: u16 = 1999;
/// The greatest number of QL and QR parameters.
const LOCAL: u16 = 499;
/// The greatest number of M functions.
const FUNCTION: u16 = 999;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        for function in facts.functions(block).iter().filter(|own| own.number > FUNCTION) {
            let finding = rule.at(facts, function.span).arg("name", format!("M{}", function.number));
            found.push(finding.arg("greatest", format!("M{FUNCTION}")));
        }
        let (target, span) = match &block.kind {
            BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
            BlockKind::Formula(formula) => (formula.target, formula.target_span),
            BlockKind::TextFormula(formula) => (formula.target, formula.target_span),
            _ => continue,
        };
        let mut read = vec![(target, span)];
        reads(block, &mut read);
        for (q, span) in read {
            let (letters, greatest) = match q.kind {
                QKind::Q => ("Q", PARAMETER),
                QKind::Qs => ("QS", PARAMETER),
                QKind::Ql => ("QL", LOCAL),
                QKind::Qr => ("QR", LOCAL),
            };
            if q.number > greatest {
                let finding = rule.at(facts, span).arg("name", q.to_string());
                found.push(finding.arg("greatest", format!("{letters}{greatest}")));
            }
        }
    }
}
