//! A cycle that moves before any tool call has named the tool axis.
//!
//! Said once a program. Where blocks are repeated, called or skipped, only a program without any such
//! tool call is objected to; where other programs are called or blocks are not analysed (turning has
//! no tool axis), none.
use crate::check::{Event, Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "tool-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let called = |event: &Event| *event == Event::Tool { axis: true };
    let uncertain = facts.flow.jumps && facts.events.iter().any(called);
    if facts.flow.programs || facts.flow.opaque || uncertain {
        return;
    }
    let first =
        facts.events.iter().find_map(|event| if called(event) { Some(None) } else { moves(facts, event).map(Some) });
    if let Some(Some(span)) = first {
        found.push(rule.at(facts, span));
    }
}

/// The place of a cycle that moves the tool: one that is called, or a touch-probe cycle.
fn moves(facts: &Facts<'_>, event: &Event) -> Option<Span> {
    match event {
        Event::Call { span, .. } if !facts.definitions.is_empty() => Some(*span),
        Event::Define(index) => {
            let definition = facts.definitions.get(*index)?;
            (definition.key.keyword == Keyword::TchProbe).then_some(definition.view.head)
        }
        _ => None,
    }
}
