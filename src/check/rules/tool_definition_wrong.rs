//! A tool that is defined twice with different measures, tool 0, or a tool that is called before its only definition.
//!
//! TOOL DEF without measures names the next tool and defines none. Of calls it is only reported where the order of the
//! text is that of the run.
use std::collections::{HashMap, HashSet};

use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::check::program::bits;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, ToolDef, ToolRef};

pub(super) const RULE: Rule = Rule { code: "tool-definition-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut defined: HashMap<u64, (Span, [&str; 2])> = HashMap::new();
    let mut called: HashSet<u64> = HashSet::new();
    let straight = !(facts.flow.jumps || facts.flow.programs || facts.flow.unread.any());
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::ToolCall(call) => called.extend(call.tool.as_ref().and_then(number).map(bits)),
            BlockKind::ToolDef(own) if own.length.is_some() || own.radius.is_some() => {
                let Some(tool) = number(&own.tool) else { continue };
                let (content, measures) = (facts.content(block), measures(facts, own));
                let report = |what: &str| rule.at(facts, content).arg("what", what.to_owned()).arg("tool", tool);
                if tool == 0.0 {
                    found.push(report("zero"));
                } else if let Some((first, others)) = defined.get(&bits(tool)) {
                    if *others != measures {
                        let place = Place::new(facts.program.source(), *first);
                        found.push(report("twice").related("first-place", place));
                    }
                } else if straight && called.contains(&bits(tool)) {
                    found.push(report("after-call"));
                }
                defined.entry(bits(tool)).or_insert((content, measures));
            }
            _ => {}
        }
    }
}

fn number(tool: &ToolRef) -> Option<f64> {
    match tool {
        ToolRef::Number(own) => match own.amount {
            Amount::Number(number) => Some(number),
            Amount::Q { .. } | Amount::Text(_) => None,
        },
        ToolRef::Name(_) => None,
    }
}

/// Length and radius as they are written.
fn measures<'f>(facts: &Facts<'f>, own: &ToolDef) -> [&'f str; 2] {
    [own.length, own.radius]
        .map(|measure| measure.map_or("", |measure| facts.text(measure.span).trim_start_matches('+')))
}
