//! A turning cycle that is called with an insert that cannot cut where the cycle goes: by TO of the table of turning tools
//! its tip points away from the part, or away from the feed.
//!
//! Only where the table is named (`--table`, `tables` in `ciklo.toml`) and the definition says where its contour begins and
//! ends. A tool that the program turns round, or may, is passed over. Reported once for a tool call.
use std::collections::HashSet;
use std::sync::Arc;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::base::expr::{Env, EvalError, QRef, Value};
use crate::check::cycle::{Effect, Turns};
use crate::check::program::number;
use crate::check::tools::named;
use crate::check::{Defined, Facts, Loaded, Pending, Rule};
use crate::program::syntax::BlockKind;
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "insert-points-away", severity: Severity::Warning, run };

/// The meaning of the parameter that turns the tool round; 0 does not.
const REVERSED: &str = "tool-reversal";
/// Where the tip is from the centre of the nose, by TO from 1 to 9: the signs of X and Z.
const TIPS: [[f64; 2]; 9] =
    [[-1.0, -1.0], [-1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [1.0, -1.0], [0.0, -1.0], [0.0, 0.0]];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(project) = facts.project else { return };
    if facts.definitions.iter().any(|own| may_reverse(facts, own)) {
        return;
    }
    let mut reported = HashSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let Some(cycle) = own.related_cycle().filter(|cycle| cycle.file.group == Group::Turning) else { continue };
        let Some(BlockKind::ToolCall(tool)) = facts.program.blocks().get(block as usize).map(|own| &own.kind) else {
            continue;
        };
        let Some(name) = tool.tool.and_then(|tool| named(facts, tool)) else { continue };
        let Some(orientation) = project.turning_value(name, "TO") else { continue };
        let tip = (1..=9).zip(TIPS).find(|(number, _)| f64::from(*number) == orientation);
        let (Some((_, tip)), Some(turns)) = (tip, Turns::of(cycle)) else { continue };
        let Some(way) = turns.way(&Numbers::of(facts, own)) else { continue };
        let is_away = way.iter().zip(tip).any(|(way, tip)| way * tip < 0.0);
        if is_away && reported.insert(block) {
            let finding = rule.at(facts, call.span).arg("cycle", own.key.to_string());
            found.push(finding.arg("orientation", Arg::Number(orientation)));
        }
    }
}

/// Whether a definition turns the tool round, or may do so.
fn may_reverse(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    if !own.related_cycle().is_some_and(|cycle| Effect::of_cycle(cycle).aligns()) {
        return false;
    }
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    read.item(REVERSED).is_none_or(|item| number(item) != Some(0.0))
}

/// The numbers of a definition.
struct Numbers(Vec<(QRef, f64)>);

impl Numbers {
    fn of(facts: &Facts<'_>, own: &Defined<'_>) -> Self {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let numbers = read.items.iter().filter_map(|item| Some((item.param?.q?, number(item)?)));
        Self(numbers.collect())
    }
}

impl Env for Numbers {
    fn slot(&self, _: usize) -> &Value {
        // No name has a slot here, so nothing asks for one.
        const NONE: &Value = &Value::Number(f64::NAN);
        NONE
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        let found = self.0.iter().find(|(own, _)| *own == q);
        found.map(|(_, number)| *number).ok_or(EvalError::Undefined(q))
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        Err(EvalError::Undefined(q))
    }
}
