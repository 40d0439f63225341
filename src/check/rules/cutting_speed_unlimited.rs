//! A constant cutting speed without a limit of the speed, with which a tool comes to the rotary axis at a feed.
//!
//! The speed follows the diameter and has no end at the axis. Only where the blocks that follow in the text say it: a
//! straight block at a feed to X0, or a turning cycle whose contour ends there. Once for each block that switches it on. A
//! note: the machine has a greatest speed of its own, and programs of the manual have no limit either (001: 10364).
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::number;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, FeedKind, Statement, StatementKind, ValueKind};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "cutting-speed-unlimited", severity: Severity::Note, run };

/// The meaning of the diameter at which a contour ends.
const DIAMETER: &str = "contour-end-diameter";

/// What a block does to the cutting speed.
#[derive(Clone, Copy)]
enum Speed {
    /// It is constant from here on, and the speed may be limited.
    Constant { limited: bool },
    /// It is not constant any more.
    Off,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Where it was switched on. A limit stays until another one is programmed.
    let (mut open, mut limited): (Option<Span>, bool) = (None, false);
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let BlockKind::Statement(own) = &block.kind {
            match speed(facts, own) {
                Some(Speed::Constant { limited: own }) => {
                    limited |= own;
                    open = (!limited).then(|| facts.content(block));
                }
                Some(Speed::Off) => open = None,
                None => {}
            }
        } else if let Some(span) = open.filter(|_| comes_to_axis(facts, index, block)) {
            found.push(rule.at(facts, span).arg("line", block.line as f64));
            open = None;
        }
    }
}

/// The places of the blocks that switch the cutting speed, and whether it is constant from there on.
pub(super) fn switches(facts: &Facts<'_>) -> Vec<(usize, bool)> {
    let blocks = facts.program.blocks().iter().enumerate();
    let switches = blocks.filter_map(|(index, block)| match &block.kind {
        BlockKind::Statement(own) => Some((index, matches!(speed(facts, own)?, Speed::Constant { .. }))),
        _ => None,
    });
    switches.collect()
}

fn speed(facts: &Facts<'_>, own: &Statement) -> Option<Speed> {
    let head = facts.text(own.head).to_ascii_uppercase();
    if own.kind != StatementKind::Function {
        return None;
    }
    let mut words = own.words.iter().map(|word| {
        let name = facts.text(word.name).trim_end_matches([':', ' ']).to_ascii_uppercase();
        (name, word)
    });
    if head.ends_with("MODE") {
        return words.next().filter(|(name, _)| name == "MILL").map(|_| Speed::Off);
    }
    words.next().filter(|(name, _)| head.ends_with("TURNDATA") && name == "SPIN")?;
    let (mut constant, mut limited) = (None, false);
    for (name, word) in words {
        match name.as_str() {
            "VCONST" => constant = Some(facts.text(word.value.span).trim().eq_ignore_ascii_case("ON")),
            "SMAX" => limited = word.value.kind != ValueKind::Number(0.0),
            _ => {}
        }
    }
    constant.map(|on| if on { Speed::Constant { limited } } else { Speed::Off })
}

/// Whether a tool comes to the rotary axis at a feed.
fn comes_to_axis(facts: &Facts<'_>, index: usize, block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            let words = motion.words();
            let rapid = words.feed.is_some_and(|feed| matches!(feed.kind, FeedKind::Max));
            let x = words.coord(Axis::X).filter(|coord| !rapid && !coord.incremental);
            x.and_then(|coord| facts.number(&coord.value)).is_some_and(|x| x <= 0.0)
        }
        BlockKind::CycleDef(_) => facts.definition_at(index).is_some_and(|own| {
            let turns = own.cycle().is_some_and(|cycle| cycle.file.group == Group::Turning);
            turns && facts.read(own).item(DIAMETER).and_then(number).is_some_and(|end| end <= 0.0)
        }),
        _ => false,
    }
}
