//! A free contour that cannot be calculated: with less known of its elements than they leave open, polar data without a
//! pole, an element directly after a label, CLSD that does not begin and end a contour, an auxiliary point without its
//! distance, FSELECT without an element.
//!
//! A line leaves two things open, a tangential one one, an arc three, a tangential one two. Every word counts as one
//! thing that is known, so what is reported is certain; counted is to the end of the contour from its beginning and
//! from each element whose end is written.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Motion, Path, StatementKind};

pub(super) const RULE: Rule = Rule { code: "free-contour-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let report = |block: &Block, what: &str| rule.at(facts, facts.content(block)).arg("what", what.to_owned());
    let mut free = facts.shaped().filter(|(_, block)| open(block).is_some()).peekable();
    if free.peek().is_some() {
        found.extend(closing(facts, free.map(|(_, block)| block)).map(|(block, what)| report(block, what)));
    }
    found.extend(selections(facts).into_iter().map(|(block, what)| report(block, what)));
    for (_, block) in facts.shaped() {
        if let BlockKind::Motion(motion) = &block.kind
            && motion.path() == Path::Fpol
            && motion.words().coords.len() < 2
        {
            found.push(report(block, "fpol"));
        }
    }
    found.extend(turned(facts).into_iter().map(|block| report(block, "turn")));
    determined(rule, facts, found);
}

/// The arcs that close a contour on the circle with which it began, in the other direction.
fn turned<'f>(facts: &Facts<'f>) -> Vec<&'f Block> {
    let (mut found, mut begun) = (Vec::new(), None);
    for (_, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !matches!(motion.path(), Path::Fc | Path::Fct | Path::Fl | Path::Flt) {
            if !motion.path().is_corner() {
                begun = None;
            }
            continue;
        }
        let words = motion.words();
        let closes = words.words.iter().find(|word| name(facts, word).eq_ignore_ascii_case("CLSD"));
        let Some(closes) = closes else { continue };
        let written = |word: &str| {
            let own = words.words.iter().find(|own| name(facts, own).eq_ignore_ascii_case(word))?;
            match own.value.kind {
                crate::program::syntax::ValueKind::Number(number) => Some(number),
                _ => None,
            }
        };
        let circle = || Some(([written("CCX")?, written("CCY")?], words.counter_clockwise?));
        if facts.text(closes.span).trim_end().ends_with('+') {
            begun = circle();
        } else if let (Some((one, turns)), Some((other, back))) = (begun.take(), circle())
            && one == other
            && turns != back
        {
            found.push(block);
        }
    }
    found
}

/// What is wrong with the single elements, and with CLSD+ and CLSD-, which begin and end a closed contour.
fn closing<'f>(
    facts: &Facts<'f>,
    elements: impl Iterator<Item = &'f Block>,
) -> impl Iterator<Item = (&'f Block, &'static str)> {
    let (mut found, mut begun, mut last) = (Vec::new(), false, None);
    for block in elements {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let words = motion.words();
        let (mut distance, mut auxiliary) = (false, false);
        for word in &words.words {
            let number =
                |least: f64| matches!(word.value.kind, crate::program::syntax::ValueKind::Number(own) if own <= least);
            match name(facts, word).to_ascii_uppercase().as_str() {
                "CLSD" => {
                    let text = facts.text(word.span).trim_end();
                    let opens = text.ends_with('+');
                    if opens == begun && text.ends_with(['+', '-']) {
                        found.push((block, if opens { "again" } else { "unbegun" }));
                    }
                    begun = opens;
                }
                "LEN" if number(0.0) => found.push((block, "length")),
                "D" => distance = true,
                "PDX" | "PDY" | "PDZ" | "PDPR" | "PDPA" => auxiliary = true,
                _ => {}
            }
        }
        if distance != auxiliary {
            found.push((block, if distance { "auxiliary" } else { "distance" }));
        }
        last = Some(block);
    }
    found.extend(last.filter(|_| begun).map(|last| (last, "unclosed")));
    found.into_iter()
}

/// FSELECT that selects nothing: after no free element, or with a number that is none of a solution.
fn selections<'f>(facts: &Facts<'f>) -> Vec<(&'f Block, &'static str)> {
    let mut found = Vec::new();
    for (index, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind != StatementKind::Fselect {
            continue;
        }
        let before = facts.program.blocks().get(..index).unwrap_or_default();
        let before = before.iter().rev().find(|block| acts(block));
        let free = |block: &Block| match &block.kind {
            BlockKind::Statement(own) => own.kind == StatementKind::Fselect,
            BlockKind::Motion(motion) => open(block).is_some() || motion.path().is_corner(),
            BlockKind::Unknown(_) => true,
            _ => false,
        };
        let number = own.words.first().map(|word| word.value.kind);
        if !before.is_some_and(free) {
            found.push((block, "selected"));
        } else if matches!(number, Some(crate::program::syntax::ValueKind::Number(own)) if own < 1.0 || own.fract() != 0.0)
        {
            found.push((block, "solution"));
        }
    }
    found
}

/// Whether contours are determined, have a pole if they need one, and begin where they can.
fn determined(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    // A contour that a cycle reads is on no way of the run.
    let closed = facts.begins() && !facts.flow.programs && !facts.flow.unread.may_move();
    let nowhere = closed && !blocks.iter().any(Block::sets_pole);
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
                        if (nowhere || pole == Some(Tri::No)) && is_polar(facts, &words) {
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
    /// The greatest of what is open since each of them.
    open: i32,
}

impl Balance {
    fn add(&mut self, open: i32, known: i32, ends: bool) {
        self.open += open - known;
        if ends {
            self.open = self.open.max(0);
        }
    }

    fn lacks(&self) -> bool {
        self.open > 0
    }
}

fn name<'f>(facts: &'f Facts<'_>, word: &crate::program::syntax::NamedWord) -> &'f str {
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
