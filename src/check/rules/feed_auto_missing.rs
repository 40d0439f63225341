//! FAUTO, in a movement or a cycle, where the tool call before it has no feed or F0.
//!
//! Only in programs whose order is that of the run; of a tool call that changes the speed alone nothing is asked.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::syntax::{Amount, Block, BlockKind, CycleForm, FeedKind, ValueKind};

pub(super) const RULE: Rule = Rule { code: "feed-auto-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.jumps || facts.flow.programs || !facts.begins() {
        return;
    }
    let text = facts.program.source().text().as_bytes();
    if memchr::memmem::find(text, b"AUTO").is_none() {
        return;
    }
    // Whether the last tool call has a feed; nothing before the first one.
    let mut fed: Option<bool> = None;
    let mut cycles = facts.definitions.iter().peekable();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let BlockKind::ToolCall(call) = &block.kind {
            match call.feed.as_ref().map(|feed| feed.kind) {
                Some(FeedKind::Value(feed)) => fed = Some(feed.amount != Amount::Number(0.0)),
                Some(_) => fed = Some(true),
                None if call.tool.is_some() => fed = Some(false),
                None => {}
            }
        }
        while cycles.next_if(|own| own.view.first < index).is_some() {}
        let auto = match cycles.next_if(|own| own.view.first == index) {
            Some(own) => match &own.view.form {
                CycleForm::Parameters(written) => written.parameters.iter().find_map(|own| {
                    let word = own.value.kind == ValueKind::Word;
                    let auto =
                        facts.text(own.value.span).trim_start_matches(['F', 'f']).trim().eq_ignore_ascii_case("AUTO");
                    (word && auto).then_some(own.value.span)
                }),
                CycleForm::Lines(_) => None,
            },
            None => motion(block),
        };
        if let Some(span) = auto.filter(|_| fed == Some(false)) {
            found.push(rule.at(facts, span));
            return;
        }
    }
}

fn motion(block: &Block) -> Option<Span> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    if !motion.outline().has_feed() {
        return None;
    }
    motion.words().feed.filter(|feed| feed.kind == FeedKind::Auto).map(|feed| feed.span)
}
