//! What the machine cannot do, by the limits in `ciklo.toml`: a spindle speed, a feed, an angle of a rotary axis, a
//! helix or a travel that is too great.
//!
//! Where a workpiece is on the table is not known: of linear axes a position in machine coordinates (M91) is judged, and
//! the distance between two positions with the same preset, which is longer than the axis. That a control refuses a
//! position outside of its travel makes it an error with M91. Each axis and each word is said once a program.
use std::collections::{HashMap, HashSet};

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::blank::is_unmoved;
use crate::check::{Aspect, Facts, Machine, Modal, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Element, Feed, FeedKind, Path};

pub(super) const RULE: Rule = Rule { code: "machine-limit", severity: Severity::Warning, run };

/// The meaning of a value that names a preset.
const PRESET: &str = "preset-number";

/// What is looked at.
struct Look<'r, 'f, 'a> {
    rule: &'r Rule,
    facts: &'f Facts<'a>,
    machine: &'f Machine,
    /// A millimetre in the unit of the program.
    unit: f64,
    /// The least and the greatest position of each linear axis since the last preset.
    reached: HashMap<Axis, [f64; 2]>,
    reported: HashSet<(&'static str, &'static str)>,
    found: &'r mut Vec<Diagnostic>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(machine) = facts.project.and_then(|project| project.machine()) else { return };
    let unit = facts.millimetre();
    let mut look = Look { rule, facts, machine, unit, reached: HashMap::new(), reported: HashSet::new(), found };
    for (from, to, modal) in facts.run.stretches() {
        let Some(modal) = modal else {
            look.reached.clear();
            continue;
        };
        for (index, block) in facts.program.blocks().iter().enumerate().take(to).skip(from) {
            look.block(index, block, &modal);
        }
    }
}

impl Look<'_, '_, '_> {
    fn block(&mut self, index: usize, block: &Block, modal: &Modal) {
        match &block.kind {
            BlockKind::Motion(motion) => self.motion(motion, modal),
            BlockKind::ToolCall(call) => {
                // Another tool is longer or shorter.
                self.reached.remove(&Axis::Z);
                if let Some(speed) = call.speed {
                    let value = self.facts.number(&speed);
                    self.most("speed", "S", value, self.machine.speed, speed.span);
                }
                self.feed(call.feed.as_ref());
            }
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
                let presets = |cycle: &crate::spec::Cycle| cycle.params.iter().any(|own| own.is.as_str() == PRESET);
                let own = self.facts.definition_at(index);
                if own.is_some_and(|own| own.related_cycle().is_none_or(presets)) {
                    self.reached.clear();
                }
            }
            BlockKind::CallPgm(_) | BlockKind::CallLbl(_) | BlockKind::Unknown(_) => self.reached.clear(),
            _ => {}
        }
    }

    fn feed(&mut self, feed: Option<&Feed>) {
        let Some(FeedKind::Value(own)) = feed.map(|feed| feed.kind) else { return };
        let value = self.facts.number(&own).map(|value| value / self.unit);
        self.most("feed", "F", value, self.machine.feed, own.span);
    }

    fn motion(&mut self, motion: &Element, modal: &Modal) {
        let words = motion.words();
        if words.path == Path::Cc {
            return;
        }
        if modal.is(Aspect::PerRevolution) == Tri::No {
            self.feed(words.feed.as_ref());
        }
        let in_machine = words.functions.iter().any(|own| own.number == 91);
        let other = words.functions.iter().any(|own| matches!(own.number, 92 | 130));
        let plain = is_unmoved(modal) && modal.is(Aspect::Tcpm) == Tri::No && !other;
        if !plain && !in_machine {
            self.reached.clear();
        }
        for coord in &words.coords {
            let Some(value) = self.facts.number(&coord.value).filter(|_| !coord.incremental || coord.axis == Axis::Pa)
            else {
                continue;
            };
            if coord.axis == Axis::Pa {
                let helix = words.path == Path::Cp && coord.incremental && words.coords.len() > 1;
                self.most("helix", "IPA", Some(value.abs()).filter(|_| helix), self.machine.helix, coord.span);
                continue;
            }
            let name = coord.axis.name();
            let Some(&[low, high]) = self.machine.travel.get(name) else { continue };
            let rotary = matches!(coord.axis, Axis::A | Axis::B | Axis::C);
            let value = if rotary { value } else { value / self.unit };
            if in_machine || (rotary && plain) {
                let what = if rotary { "angle" } else { "position" };
                if value < low || high < value {
                    let limit = if value < low { low } else { high };
                    self.report(what, name, [value, limit], coord.span, in_machine);
                }
            } else if plain && !rotary {
                let reached = self.reached.entry(coord.axis).or_insert([value; 2]);
                *reached = [reached[0].min(value), reached[1].max(value)];
                let way = reached[1] - reached[0];
                if way > high - low {
                    self.report("travel", name, [way, high - low], coord.span, false);
                }
            }
        }
    }

    fn most(&mut self, what: &'static str, word: &'static str, value: Option<f64>, limit: Option<f64>, span: Span) {
        if let Some((value, limit)) = value.zip(limit).filter(|(value, limit)| value > limit) {
            self.report(what, word, [value, limit], span, false);
        }
    }

    fn report(&mut self, what: &'static str, word: &'static str, [value, limit]: [f64; 2], span: Span, refused: bool) {
        if self.reported.insert((what, word)) {
            let finding = self.rule.at(self.facts, span).arg("what", what).arg("word", word);
            let finding = finding.arg("value", Arg::Number(value)).arg("limit", Arg::Number(limit));
            let severity = if refused { Severity::Error } else { finding.severity };
            self.found.push(Diagnostic { severity, ..finding });
        }
    }
}
