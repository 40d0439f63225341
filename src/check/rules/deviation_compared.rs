//! A measured deviation that is compared with a size, or a measured size that is compared with what can only be a
//! deviation: the condition never holds, or always.
//!
//! Only results of a measurement whose nominal value is known, in jumps that compare them with a number.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::cycle::probes;
use crate::check::program::number;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, FnJump, Relation};

pub(super) const RULE: Rule = Rule { code: "deviation-compared", severity: Severity::Warning, run };

/// How the meanings of measured deviations and values end, and how those of sizes begin.
const DEVIATION: &str = "-deviation";
const ACTUAL: &str = "-actual";
const SIZES: [&str; 3] = ["diameter", "side", "measured-length"];
/// No deviation is so much of the size, and no size so little of what was expected.
const LARGE: f64 = 0.5;
const SMALL: f64 = 0.05;

/// A result of the last measurement.
struct Result {
    q: QRef,
    deviates: bool,
    nominal: f64,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut results: Vec<Result> = Vec::new();
    let mut definitions = facts.definitions.iter().peekable();
    for (index, block) in facts.marked() {
        while let Some(own) = definitions.next_if(|own| own.view.first < index) {
            let Some(cycle) = own.related_cycle().filter(|cycle| probes(cycle)) else { continue };
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let value = |q: QRef| read.items.iter().find(|item| item.param.is_some_and(|own| own.q == Some(q)));
            let sizes =
                cycle.file.results.iter().filter(|own| SIZES.iter().any(|size| own.is.as_str().starts_with(size)));
            let known = sizes.filter_map(|own| {
                let meaning = own.is.as_str();
                let deviates = meaning.ends_with(DEVIATION);
                let nominal = value(own.of?).and_then(number).filter(|own| *own > 0.0)?;
                (deviates || meaning.ends_with(ACTUAL)).then_some(Result { q: own.q?, deviates, nominal })
            });
            results = known.collect();
        }
        let BlockKind::FnJump(jump) = &block.kind else { continue };
        let Some((q, limit)) = comparison(jump) else { continue };
        let Some(own) = results.iter().find(|own| own.q == q) else { continue };
        let wrong = match own.deviates {
            true => limit.abs() >= LARGE * own.nominal,
            false => limit != 0.0 && limit.abs() <= SMALL * own.nominal,
        };
        if wrong {
            let what = if own.deviates { "deviation" } else { "size" };
            let finding = rule.at(facts, facts.content(block)).arg("what", what).arg("parameter", q.to_string());
            found.push(finding.arg("value", Arg::Number(limit)).arg("other", Arg::Number(own.nominal)));
        }
    }
}

/// The parameter and the number that a jump compares by their size.
fn comparison(jump: &FnJump) -> Option<(QRef, f64)> {
    if !matches!(jump.relation, Relation::Less | Relation::Greater) {
        return None;
    }
    match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, Amount::Number(limit))
        | (Amount::Number(limit), Amount::Q { q, negative: false }) => Some((q, limit)),
        _ => None,
    }
}
