//! What a conditional jump says of a measurement: with which parts or tools it is taken, and what its branch is for by the
//! words of its label and of the comments there.
//!
//! Invariant: an outcome is taken or left out only where that is certain, and words that leave a doubt say nothing.
use super::cycle::probes_around;
use super::program::{is_silent, number};
use super::{Defined, Definition, Facts};
use crate::base::expr::QRef;
use crate::program::syntax::{Amount, Block, BlockKind, FnJump, Relation, StatementKind};
use crate::spec::Cycle;

/// The meanings of results that say how a measurement went.
const TOOL: &str = "tool-status";
const MARKERS: [(&str, usize); 3] = [("status-good", 0), ("status-rework", 1), ("status-scrap", 2)];
/// The sizes that are measured, and the meanings of their limits.
const SIZES: [(&str, &[[&str; 2]]); 4] = [
    (
        "diameter",
        &[["hole-greatest-diameter", "hole-least-diameter"], ["stud-greatest-diameter", "stud-least-diameter"]],
    ),
    ("measured-length", &[["greatest-dimension", "least-dimension"]]),
    ("side-main", &[["first-side-greatest-length", "first-side-least-length"]]),
    ("side-minor", &[["second-side-greatest-length", "second-side-least-length"]]),
];
const ACTUAL: &str = "-actual";
const DEVIATION: &str = "-deviation";
/// The words in the names of cycles that measure something which gets narrower by machining.
const AROUND: &str = "ridge";

/// With which parts or tools a jump is taken: good ones, those to be reworked or worn, those that are lost; nothing where
/// that is not certain, or only for some of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taken {
    /// The result that is compared.
    pub(super) q: QRef,
    /// The first block of the measurement.
    pub(super) measured: usize,
    /// Whether it is a tool that was measured.
    pub(super) tool: bool,
    /// Good, to be reworked, lost.
    pub(super) outcomes: [Option<bool>; 3],
}

/// What a branch is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// All is well.
    Good,
    /// The part is to be reworked, the tool is worn.
    Rework,
    /// The part is scrap, the tool is broken.
    Lost,
    /// A fault of any kind.
    Fault,
}

/// What a jump in a block says of the measurement before it.
pub(super) fn taken(facts: &Facts<'_>, at: usize, jump: &FnJump) -> Option<Taken> {
    let (q, relation, value) = match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, Amount::Number(value)) => (q, jump.relation, value),
        (Amount::Number(value), Amount::Q { q, negative: false }) => (q, turned(jump.relation)?, value),
        _ => return None,
    };
    let (own, cycle) = measurement(facts, at, q)?;
    let meaning = cycle.file.results.iter().find(|result| result.q == Some(q))?.is.as_str();
    let measured = own.view.first;
    if meaning == TOOL {
        let outcomes = [0.0, 1.0, 2.0].map(|state| relation.holds(state, value));
        return Some(Taken { q, measured, tool: true, outcomes });
    }
    if let Some((_, marked)) = MARKERS.iter().find(|(own, _)| *own == meaning) {
        let outcome = |at: usize| relation.holds(if at == *marked { 1.0 } else { 0.0 }, value);
        return Some(Taken { q, measured, tool: false, outcomes: [outcome(0), outcome(1), outcome(2)] });
    }
    let related = own.as_related_cycle();
    let band = band(&facts.read(&related), meaning, q, cycle)?;
    let around = probes_around(cycle) || cycle.file.name.as_str().contains(AROUND);
    let outcomes = of_range(relation, value, band, around)?;
    Some(Taken { q, measured, tool: false, outcomes })
}

/// The last definition before a block that gives a result.
pub(super) fn measurement<'f, 'a>(facts: &'f Facts<'a>, at: usize, q: QRef) -> Option<(&'f Defined<'a>, &'a Cycle)> {
    /// So many definitions are looked back through.
    const BACK: usize = 32;
    let end = facts.definitions.partition_point(|own| own.view.first < at);
    facts.definitions.get(..end)?.iter().rev().take(BACK).find_map(|own| {
        let cycle = own.related_cycle()?;
        cycle.file.results.iter().any(|result| result.q == Some(q)).then_some((own, cycle))
    })
}

/// A relation with its sides exchanged.
const fn turned(relation: Relation) -> Option<Relation> {
    match relation {
        Relation::Equal | Relation::NotEqual => Some(relation),
        Relation::Greater => Some(Relation::Less),
        Relation::Less => Some(Relation::Greater),
        _ => None,
    }
}

/// The values of a measured size or deviation with which a part is good: the least and the greatest one.
fn band(read: &Definition<'_>, meaning: &str, q: QRef, cycle: &Cycle) -> Option<[f64; 2]> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let size = meaning.strip_suffix(ACTUAL).or_else(|| meaning.strip_suffix(DEVIATION))?;
    let (_, limits) = SIZES.iter().find(|(own, _)| *own == size)?;
    let [greatest, least] = limits.iter().find_map(|[greatest, least]| Some([value(greatest)?, value(least)?]))?;
    if least <= 0.0 || greatest <= least {
        return None;
    }
    if meaning.ends_with(ACTUAL) {
        return Some([least, greatest]);
    }
    let of = cycle.file.results.iter().find(|result| result.q == Some(q))?.of?;
    let nominal = read.items.iter().find(|item| item.param.is_some_and(|own| own.q == Some(of))).and_then(number)?;
    Some([least - nominal, greatest - nominal])
}

/// With which parts a comparison of a size holds, whose good values lie between two limits.
fn of_range(relation: Relation, value: f64, [least, greatest]: [f64; 2], around: bool) -> Option<[Option<bool>; 3]> {
    // Whether all, none or some of the good values are on the side of a limit.
    let of = |all: bool, none: bool| match (all, none) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    };
    let (good, below, above) = match relation {
        Relation::Less => (of(value >= greatest, value <= least), true, value > greatest),
        Relation::Greater => (of(value <= least, value >= greatest), value < least, true),
        _ => return None,
    };
    // A stud that is too small is lost, and so is a hole that is too large.
    let (rework, lost) = if around { (above, below) } else { (below, above) };
    Some([good, Some(rework), Some(lost)])
}

/// What a branch is for, by its label and the comments at its beginning.
pub(super) fn purpose(facts: &Facts<'_>, label: usize) -> Option<Purpose> {
    /// So many blocks of the branch are read.
    const FIRST: usize = 6;
    let blocks = facts.program.blocks().get(label..)?;
    let name = blocks.first().filter(|block| matches!(block.kind, BlockKind::Lbl(_)))?;
    let own = of_words(facts.text(facts.content(name)));
    own.or_else(|| {
        let begins = |block: &&Block| !matches!(block.kind, BlockKind::Lbl(_) | BlockKind::FnJump(_));
        let branch = blocks.iter().skip(1).take(FIRST).take_while(begins);
        // What comes after a comment and something else belongs to something else.
        let end = |block: &&Block| is_silent(block) || matches!(block.kind, BlockKind::Motion(_)) || halts(block);
        branch.take_while(end).find_map(|block| {
            of_words(facts.text(if is_silent(block) { facts.content(block) } else { block.comment()? }))
        })
    })
}

/// What words say of a branch; nothing if they say several things.
fn of_words(words: &str) -> Option<Purpose> {
    const GOOD: [&str; 7] = ["OK", "GOOD", "GUT", "BUONO", "DOBRO", "KUNNOSSA", "INTOL"];
    const REWORK: [&str; 7] = ["REWORK", "NACHARB", "RILAVOR", "RETRABALH", "WORN", "JALKITYO", "PONOVNA"];
    const LOST: [&str; 10] =
        ["SCRAP", "REJECT", "AUSSCHUSS", "SCARTO", "SUCATA", "IZMET", "HYLKY", "BROKEN", "BREAKAGE", "BRUCH"];
    const FAULT: [&str; 9] = ["ERROR", "FAULT", "FEHLER", "ALARM", "NOK", "BAD", "ERRORE", "VIRHE", "NAPAKA"];
    // What comes when something is over, or to find it out, is none of it.
    const NOT: [&str; 8] = ["NOT", "NO", "NON", "NICHT", "KEIN", "EI", "NE", "WITHOUT"];
    const BESIDE: [&str; 16] = [
        "END", "ENDE", "SKIP", "AFTER", "DONE", "FINE", "DOPO", "LOPPU", "KONEC", "FIM", "CONTINUE", "WEITER", "NEXT",
        "CHECK", "TEST", "OR",
    ];
    let words = words.to_ascii_uppercase();
    let parts = || words.split(|sign: char| !sign.is_alphanumeric()).filter(|part| !part.is_empty());
    if parts().any(|part| NOT.contains(&part) || BESIDE.contains(&part)) {
        return None;
    }
    let begins = |all: &[&str]| parts().any(|part| all.iter().any(|own| part.starts_with(own)));
    let (good, rework) = (parts().any(|part| GOOD.contains(&part)), begins(&REWORK));
    let (lost, fault) = (begins(&LOST), parts().any(|part| FAULT.contains(&part)));
    match (good, rework, lost) {
        (true, false, false) if !fault => Some(Purpose::Good),
        (false, true, false) => Some(Purpose::Rework),
        (false, false, true) => Some(Purpose::Lost),
        (false, true, true) => Some(Purpose::Fault),
        (false, false, false) if fault => Some(Purpose::Fault),
        _ => None,
    }
}

/// Whether a branch begins with a stop for the operator, be it after movements.
pub(super) fn begins_with_stop(facts: &Facts<'_>, label: usize) -> bool {
    let blocks = facts.program.blocks().get(label + 1..).unwrap_or_default();
    let moves = |block: &&Block| is_silent(block) || matches!(block.kind, BlockKind::Motion(_)) && !halts(block);
    blocks.iter().find(|block| !moves(block)).is_some_and(halts)
}

/// Whether a block stops for the operator.
pub(super) fn halts(block: &Block) -> bool {
    let mut stops = matches!(&block.kind, BlockKind::Stop(_));
    stops |= matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Fn(14));
    super::program::each_function(block, |number| stops |= number == 0);
    stops
}
