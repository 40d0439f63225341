//! A free contour that cannot be calculated: with less known of its elements than they leave open, polar data without a
//! pole, or an element directly behind a label.
//!
//! A line leaves two things open, a tangential one one, an arc three, a tangential one two. Every word counts as one thing
//! that is known, so what is told is certain; counted is to the end of the contour from its beginning and from each
//! element whose end is written.
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{Axis, Block, BlockKind, Motion, Path, StatementKind};

pub(super) const RULE: Rule = Rule { code: "free-contour-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let mut done = 0;
    for (first, block) in facts.shaped() {
        if first < done || open(block).is_none() {
            continue;
        }
        let before = blocks.get(..first).and_then(|before| before.iter().rev().find(|block| acts(block)));
        if before.is_some_and(|before| matches!(before.kind, BlockKind::Lbl(_))) {
            found.push(rule.at(facts, facts.content(block)).arg("what", "label"));
        }
        let mut balance = Balance::default();
        let mut last = block;
        done = first;
        for block in blocks.get(first..).unwrap_or_default() {
            match &block.kind {
                BlockKind::Motion(motion) => match open(block) {
                    Some(open) => {
                        let words = motion.words();
                        balance.add(open, known(facts, &words), ends_known(&words));
                        last = block;
                        let pole = facts.run.before(done).map(|modal| modal.is(Aspect::Pole));
                        if pole == Some(Tri::No) && is_polar(facts, &words) {
                            found.push(rule.at(facts, facts.content(block)).arg("what", "pole"));
                        }
                    }
                    None if motion.path().is_corner() || motion.path() == Path::Fpol => {}
                    None => break,
                },
                BlockKind::Statement(own) if own.kind == StatementKind::Fselect => {}
                BlockKind::Functions(_) => {}
                _ if !acts(block) => {}
                _ => break,
            }
            done += 1;
        }
        if balance.lacks() {
            found.push(rule.at(facts, facts.content(last)).arg("what", "open"));
        }
    }
}

fn acts(block: &Block) -> bool {
    !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

/// How much an element of a free contour leaves open; nothing of other blocks.
fn open(block: &Block) -> Option<i32> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    match motion.path() {
        Path::Fl | Path::Fct => Some(2),
        Path::Flt => Some(1),
        Path::Fc => Some(3),
        _ => None,
    }
}

/// What is open and what is known since the beginning, and since the last elements whose end is written.
#[derive(Default)]
struct Balance {
    open: Vec<i32>,
}

impl Balance {
    fn add(&mut self, open: i32, known: i32, ends: bool) {
        if self.open.is_empty() {
            self.open.push(0);
        }
        self.open.iter_mut().for_each(|own| *own += open - known);
        if ends {
            self.open.push(0);
        }
    }

    fn lacks(&self) -> bool {
        self.open.iter().any(|own| *own > 0)
    }
}

fn name<'f>(facts: &'f Facts<'_>, word: &crate::syntax::NamedWord) -> &'f str {
    facts.text(word.name).trim()
}

/// How many things are known of an element, counted high.
fn known(facts: &Facts<'_>, motion: &Motion) -> i32 {
    let mut known = motion.coords.len() + usize::from(motion.radius.is_some());
    for word in &motion.words {
        known += match name(facts, word).to_ascii_uppercase().as_str() {
            // A contour that is closed ends where it began, in the direction in which it began.
            "CLSD" => 3,
            // The point from which D is a distance, and points on the element, are pairs.
            "PDX" | "PDY" | "PDZ" | "PDPR" | "PDPA" | "P1Y" | "P2Y" | "P3Y" => 0,
            _ => 1,
        };
    }
    i32::try_from(known).unwrap_or(i32::MAX)
}

/// Whether both coordinates of the end are written.
fn ends_known(motion: &Motion) -> bool {
    let main = |axis: Axis| matches!(axis, Axis::X | Axis::Y | Axis::Z);
    motion.coords.iter().filter(|coord| main(coord.axis) && !coord.incremental).count() == 2
}

fn is_polar(facts: &Facts<'_>, motion: &Motion) -> bool {
    let named = ["CCPR", "CCPA", "PDPR", "PDPA"];
    motion.coords.iter().any(|coord| matches!(coord.axis, Axis::Pr | Axis::Pa))
        || motion.words.iter().any(|word| named.iter().any(|own| own.eq_ignore_ascii_case(name(facts, word))))
}
