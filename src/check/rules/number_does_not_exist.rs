//! The number of a parameter above the greatest one of the control (1999), of a local or lasting one above 499, of an M function above 999, or of a label
//! above the greatest one of the control: there are none.
use std::borrow::Cow;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QKind;
use crate::check::program::each_function;
use crate::check::program::reads;
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Label, StatementKind};

pub(super) const RULE: Rule = Rule { code: "number-does-not-exist", severity: Severity::Error, run };

/// The greatest number of Q and QS parameters where a control has no other.
const PARAMETER: u32 = 1999;
/// The greatest number of QL and QR parameters.
const LOCAL: u32 = 499;
/// The greatest number of FN functions: D39 of DIN/ISO is no other.
const CALCULATION: u32 = 39;
/// The greatest number of M functions.
const FUNCTION: u16 = 999;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let label = facts.against.on.control.greatest_label.unwrap_or(u32::MAX);
    let parameter = facts.against.on.control.greatest_parameter.unwrap_or(PARAMETER);
    let mut read = Vec::new();
    for (_, block) in facts.marked() {
        let named = match &block.kind {
            BlockKind::Lbl(own) => Some(own.as_ref()),
            BlockKind::CallLbl(call) => Some(&call.label),
            BlockKind::FnJump(jump) => Some(&jump.label),
            _ => None,
        };
        if let Some((Label::Number(number), span)) = named.map(|own| (own.target, own.span))
            && u32::from(number) > label
        {
            let finding = rule.at(facts, span).arg("name", format!("LBL {number}"));
            found.push(finding.arg("greatest", format!("LBL {label}")));
        }
        if let BlockKind::Statement(own) = &block.kind
            && let StatementKind::Fn(number) = own.kind
            && number > CALCULATION
        {
            let finding = rule.at(facts, own.head).arg("name", format!("FN {number}"));
            found.push(finding.arg("greatest", format!("FN {CALCULATION}")));
        }
        // Most blocks with M functions are distinguished by their numbers alone.
        let mut beyond = false;
        each_function(block, |number| beyond |= number > FUNCTION);
        let functions = if beyond { facts.functions(block) } else { Cow::default() };
        for function in functions.iter().filter(|own| own.number > FUNCTION) {
            let finding = rule.at(facts, function.span).arg("name", format!("M{}", function.number));
            found.push(finding.arg("greatest", format!("M{FUNCTION}")));
        }
        let target = match &block.kind {
            BlockKind::FnAssign(assign) => Some((assign.target, assign.target_span)),
            BlockKind::Formula(formula) => Some((formula.target, formula.target_span)),
            BlockKind::TextFormula(formula) => Some((formula.target, formula.target_span)),
            _ => None,
        };
        read.clear();
        read.extend(target);
        reads(block, &mut read);
        for &(q, span) in &read {
            let (letters, greatest) = match q.kind {
                QKind::Q => ("Q", parameter),
                QKind::Qs => ("QS", PARAMETER),
                QKind::Ql => ("QL", LOCAL),
                QKind::Qr => ("QR", LOCAL),
            };
            if u32::from(q.number) > greatest {
                let finding = rule.at(facts, span).arg("name", q.to_string());
                found.push(finding.arg("greatest", format!("{letters}{greatest}")));
            }
        }
    }
}
