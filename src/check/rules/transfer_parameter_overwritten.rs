//! A parameter of a cycle that is written between the cycle's definition and a call of it.
//!
//! The call takes the new value, which may be meant; so it is no error, and only reported where it is certain which
//! cycle the next call means. The parameters Q1 to Q20 belong to the cycles that work with the contour data from the
//! definition of those data to the last call of such a cycle (TNC 640, 001: 4600).
//!
//! A parameter that the definition has passed on (`Q201=Q1`) does nothing any more when it is written between (001:
//! 1065), and one that the definition writes over is lost for the program that reads it later. A loop that goes back to
//! the call counts as a way to it. So is the result of a measurement that the next one overwrites before anything reads
//! it, where the next one's is copied twice.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::cycle::probes;
use crate::check::program::{assigned, constant, copied, is_silent, reads, stops};
use crate::check::{Aspect, Defined, Definition, Facts, Item, Pending, Rule, Tri, Use, Way};
use crate::program::syntax::{Amount, BlockKind, ValueKind};
use crate::spec::{Group, ParameterKind};

pub(super) const RULE: Rule = Rule { code: "transfer-parameter-overwritten", severity: Severity::Warning, run };

/// The last of the parameters that cycles of contours share.
const RESERVED: u16 = 20;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::FnAssign(_) | BlockKind::Formula(_))) {
        return;
    }
    results(rule, facts, found);
    // The last block that calls each definition, before the definition and after it.
    let mut calls: HashMap<u32, [usize; 2]> = HashMap::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        if let Some(definition) = facts.definitions.get(index as usize) {
            let [before, after] = calls.entry(index).or_default();
            let last = if call.block < definition.view.first { before } else { after };
            *last = call.block.max(*last);
        }
    }
    let before = found.len();
    shared(rule, facts, found);
    overwritten(rule, facts, found);
    replaced(rule, facts, found);
    let own = found.get(before..).unwrap_or_default().iter().filter_map(|own| own.place.as_ref());
    let mut reported: BTreeSet<usize> = own.map(|place| place.span.start).collect();
    let mut read: Option<(u32, Written)> = None;
    for (from, to, modal) in facts.run.stretches() {
        let Some(Pending::Definition(index)) = modal.map(|modal| modal.pending) else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        for (block, at) in facts.program.blocks().get(from..to).unwrap_or_default().iter().zip(from..) {
            let (target, span) = match &block.kind {
                BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
                BlockKind::Formula(formula) => (formula.target, formula.target_span),
                _ => continue,
            };
            // Where the definition follows, in a subprogram that has run already, it runs again before a call after it.
            let next = calls.get(&index).map_or(0, |last| last[usize::from(definition.view.first <= at)]);
            let again = || {
                let last = calls.get(&index).map_or(0, |last| last[1]);
                definition.view.last < last && goes_back(facts, definition.view.last + 1..=last, at)
            };
            let again = next <= at && target.number > RESERVED && again();
            if next <= at && !again {
                continue;
            }
            let known = read.take().filter(|(own, _)| *own == index).map(|(_, written)| written);
            let (_, written) = read.insert((index, known.unwrap_or_else(|| Written::of(facts, definition))));
            let what = match target {
                own if written.own.contains(&own) => "call",
                own if written.passed.contains(&own) && !again => "passed",
                _ => continue,
            };
            if reported.insert(span.start) {
                let finding = rule.at(facts, span).arg("parameter", target.to_string()).arg("what", what);
                found.push(finding.arg("cycle", definition.key.to_string()));
            }
        }
    }
}

/// Whether a loop leads from behind a block back to one of others before it.
fn goes_back(facts: &Facts<'_>, to: std::ops::RangeInclusive<usize>, at: usize) -> bool {
    let graph = &facts.run.graph;
    graph.uses.iter().filter(|own| matches!(own.way, Way::Jump | Way::Repeat) && own.block > at).any(|own| {
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        target.is_some_and(|target| to.contains(&target))
    })
}

/// What a definition does to parameters.
struct Written {
    /// Those that it writes.
    own: BTreeSet<QRef>,
    /// Those that it reads once for all.
    passed: BTreeSet<QRef>,
}

impl Written {
    fn of(facts: &Facts<'_>, definition: &Defined<'_>) -> Self {
        let related = definition.as_related_cycle();
        let read = facts.read(&related);
        let own = read.items.iter().filter_map(|item| item.param?.q).collect();
        let passed = |item: &Item<'_>| match (item.param?.q?, item.value?.kind) {
            (own, ValueKind::Q { q, .. }) if own.number > RESERVED => Some(q),
            _ => None,
        };
        Self { own, passed: read.items.iter().filter_map(passed).collect() }
    }
}

/// What the definition of a contour cycle, or one that fills more parameters than it names, writes over although the
/// program has written it before and reads it later.
fn overwritten(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let shared = |q: &QRef| q.kind == QKind::Q && (1..=RESERVED).contains(&q.number);
    let contours = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Contours);
    let wanted = |own: &&Defined<'_>| contours(own) || fills(own);
    let mut definitions = facts.definitions.iter().filter(wanted).peekable();
    if definitions.peek().is_none() {
        return;
    }
    // Where each was written, and where what was written is lost.
    let (mut owned, mut lost) = (BTreeMap::new(), BTreeMap::new());
    let mut read = Vec::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let Some(definition) = definitions.next_if(|own| own.view.first == index) {
            let related = definition.as_related_cycle();
            let read = facts.read(&related);
            if fills(definition) {
                for (q, over) in filled(&read) {
                    let place = owned.remove(&q).filter(|(_, given)| *given);
                    place.map(|(span, _)| lost.insert(q, (over, span, definition.key, "filled")));
                }
                continue;
            }
            for item in &read.items {
                let q = item.param.and_then(|param| param.q);
                if let Some((q, (span, _))) = q.filter(shared).and_then(|q| Some((q, owned.remove(&q)?))) {
                    let other =
                        !matches!(item.value.map(|own| own.kind), Some(ValueKind::Q { q: own, .. }) if own == q);
                    other.then(|| lost.insert(q, (span, item.span, definition.key, "lost")));
                }
            }
            continue;
        }
        let target = match &block.kind {
            BlockKind::FnAssign(assign) => Some((assign.target, assign.target_span, !is_blank(assign.a.amount))),
            BlockKind::Formula(formula) => {
                let number = facts.text(formula.text).trim().parse();
                Some((formula.target, formula.target_span, !number.is_ok_and(|own| is_blank(Amount::Number(own)))))
            }
            BlockKind::Empty | BlockKind::Comment | BlockKind::CycleDef(_) => continue,
            _ => None,
        };
        if !lost.is_empty() {
            read.clear();
            reads(block, &mut read);
            for (q, (span, over, key, what)) in read.iter().filter_map(|(q, _)| Some((q, lost.remove(q)?))) {
                let finding = rule.at(facts, span).arg("parameter", q.to_string()).arg("what", what);
                let caption = if what == "lost" { "written-over-here" } else { "other-place" };
                let over = Place::new(facts.program.source(), over);
                found.push(finding.arg("cycle", key.to_string()).related(caption, over));
            }
        }
        if let Some((q, span, given)) = target {
            lost.remove(&q);
            owned.insert(q, (span, given));
        }
    }
}

/// The results that are copied twice after one measurement, though that of the one before was never read.
fn results(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    /// What is known of a result: the definitions that gave it one after the other, and the copy of the last one.
    #[derive(Default)]
    struct Known {
        unread: bool,
        given: bool,
        copy: Option<(QRef, Span)>,
    }
    if facts.flow.programs || facts.flow.unread.any() {
        return;
    }
    let mut results: BTreeMap<QRef, Known> = BTreeMap::new();
    let mut definitions = facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(probes)).peekable();
    let mut used = Vec::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let Some(own) = definitions.next_if(|own| own.view.first == index) {
            for q in own.related_cycle().iter().flat_map(|cycle| &cycle.file.results).filter_map(|own| own.q) {
                let known = results.entry(q).or_default();
                *known = Known { unread: known.given, given: true, copy: None };
            }
            continue;
        }
        if results.is_empty() {
            continue;
        }
        // A program comes from elsewhere to a label, and reads out of sight in subprograms and reports.
        if matches!(block.kind, BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::Statement(_)) {
            results.clear();
            continue;
        }
        used.clear();
        reads(block, &mut used);
        for (q, _) in &used {
            let Some(known) = results.get_mut(q) else { continue };
            let copy = copied(block).and(assigned(block));
            match (copy, known.copy) {
                (Some((target, _)), Some((other, span))) if known.unread && target != other => {
                    let finding = rule.at(facts, span).arg("parameter", q.to_string()).arg("what", "result");
                    found.push(finding.arg("cycle", ""));
                    *known = Known::default();
                }
                (Some(copy), None) if known.unread => known.copy = Some(copy),
                _ => *known = Known::default(),
            }
        }
    }
}

/// The parameters of cycles that the program uses for its own numbers: a definition writes another number over one before
/// the program reads it.
fn replaced(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut owned, mut lost) = (BTreeMap::new(), BTreeMap::new());
    let mut definitions = facts.definitions.iter().peekable();
    let mut read = Vec::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let Some(definition) = definitions.next_if(|own| own.view.first == index) {
            for (q, number, place) in set_by(facts, definition) {
                let other = |(_, own): &(Span, Option<f64>)| own.is_some() && number.is_some() && *own != number;
                if let Some((span, _)) = owned.remove(&q).filter(other) {
                    lost.insert(q, (span, place, definition.key));
                }
            }
            continue;
        }
        let target = match &block.kind {
            _ if is_silent(block) => continue,
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => continue,
            BlockKind::FnAssign(own) => Some((own.target, own.target_span, constant(block).map(|(_, number)| number))),
            BlockKind::Formula(own) => Some((own.target, own.target_span, constant(block).map(|(_, number)| number))),
            _ if stops(block) || block.ends_subprogram() || is_led_to(facts, index) => {
                (owned, lost) = (BTreeMap::new(), BTreeMap::new());
                continue;
            }
            _ => None,
        };
        read.clear();
        if !lost.is_empty() {
            reads(block, &mut read);
        }
        for (q, (span, place, key)) in read.iter().filter_map(|(q, _)| Some((*q, lost.remove(q)?))) {
            let finding = rule.at(facts, span).arg("parameter", q.to_string()).arg("what", "lost");
            let place = Place::new(facts.program.source(), place);
            found.push(finding.arg("cycle", key.to_string()).related("written-over-here", place));
        }
        if let Some((q, span, number)) = target {
            lost.remove(&q);
            owned.insert(q, (span, number));
        }
    }
}

/// The parameters that a definition sets beyond those of contours, with their numbers and places.
fn set_by(facts: &Facts<'_>, definition: &Defined<'_>) -> Vec<(QRef, Option<f64>, Span)> {
    let related = definition.as_related_cycle();
    let read = facts.read(&related);
    let set = |item: &Item<'_>| {
        let q = item.param?.q.filter(|q| q.number > RESERVED)?;
        let number = match item.value?.kind {
            ValueKind::Number(number) => Some(number),
            _ => None,
        };
        Some((q, number, item.span))
    };
    read.items.iter().filter_map(set).collect()
}

/// Whether a block is a label to which something before it leads, or that is called: other values may come there.
fn is_led_to(facts: &Facts<'_>, index: usize) -> bool {
    let graph = &facts.run.graph;
    let leads = |own: &Use| {
        let to = own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == Some(index);
        to && (own.block < index || own.way == Way::Call)
    };
    matches!(facts.program.blocks().get(index).map(|block| &block.kind), Some(BlockKind::Lbl(_)))
        && graph.uses.iter().any(leads)
}

/// What a cycle fills from the parameter on that it names: three coordinates and how it went (001: 13702).
const FILLS: &str = "ball-centre-and-status";
const FILLED: u16 = 4;

fn fills(definition: &Defined<'_>) -> bool {
    definition.related_cycle().is_some_and(|cycle| cycle.file.results.iter().any(|own| own.is.as_str() == FILLS))
}

/// The parameters that such a definition does not name and fills, with the place of the one that it names.
fn filled(read: &Definition<'_>) -> Vec<(QRef, Span)> {
    let named = read.items.iter().find_map(|item| match item.value?.kind {
        ValueKind::Q { q, .. } if item.param?.kind == ParameterKind::QNumber => Some((q, item.span)),
        _ => None,
    });
    let Some((first, span)) = named else { return Vec::new() };
    (1..FILLED).map(|next| (QRef { number: first.number.saturating_add(next), ..first }, span)).collect()
}

/// Whether a number is one that a program writes before a measurement to see that something has come.
fn is_blank(amount: Amount) -> bool {
    matches!(amount, Amount::Number(number) if matches!(number.abs(), 0.0 | 1.0))
}

/// The parameters that the cycles of contours share, written while they are still to be called.
fn shared(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let of_contours = |own: &&Defined<'_>| {
        own.related_cycle().is_some_and(|cycle| cycle.file.contour.as_ref().is_some_and(|wanted| wanted.closed))
    };
    let mut last: Option<(usize, &Defined<'_>)> = None;
    for call in &facts.run.calls {
        if let Pending::Definition(index) = call.modal.pending
            && let Some(own) = facts.definitions.get(index as usize).filter(of_contours)
            && last.is_none_or(|(block, _)| block < call.block)
        {
            last = Some((call.block, own));
        }
    }
    let Some((last, called)) = last else { return };
    for (index, block) in facts.marked().take_while(|(index, _)| *index < last) {
        let (target, span) = match &block.kind {
            BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
            BlockKind::Formula(formula) => (formula.target, formula.target_span),
            _ => continue,
        };
        let reserved = target.kind == QKind::Q && (1..=RESERVED).contains(&target.number);
        let data = || facts.run.before(index).is_some_and(|modal| modal.is(Aspect::ContourData) == Tri::Yes);
        if reserved && data() {
            let finding = rule.at(facts, span).arg("parameter", target.to_string()).arg("what", "call");
            found.push(finding.arg("cycle", called.key.to_string()));
        }
    }
}
