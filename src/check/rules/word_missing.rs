//! A word without which a block means nothing: an approach without its length or angle, an arc of a free contour
//! without DR, a pattern without a coordinate or number, FN 16 without its target,
//! a text function without what it reads, a cycle for the working plane without one of its three angles.
//!
//! An approach or departure without its length, angle or radius is refused: an error; so is a chamfer without a length.
//! A block of DIN/ISO that has no equivalent because something is missing in it is reported with `iso-incomplete`.
use std::collections::BTreeSet;

use super::plane_not_positioned::{angles, is_tilt, tilts};
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::words::{self, Words};
use crate::check::{Facts, Rule};
use crate::program::syntax::{
    Approach, Axis, Block, BlockKind, CallForm, Element, NamedWord, Path, PatternDef, Statement, StatementKind,
    ValueKind,
};

pub(super) const RULE: Rule = Rule { code: "word-missing", severity: Severity::Warning, run };

/// The forms of a pattern with the words of which none can be left out.
const PATTERNS: [(&str, &[&str]); 6] = [
    ("POS", &["X", "Y", "Z"]),
    ("ROW", &["X", "Y", "D", "NUM", "Z"]),
    ("PAT", &["X", "Y", "DX", "DY", "NUMX", "NUMY", "Z"]),
    ("FRAME", &["X", "Y", "DX", "DY", "NUMX", "NUMY", "Z"]),
    ("CIRC", &["X", "Y", "D", "NUM", "Z"]),
    ("PITCHCIRC", &["X", "Y", "D", "STEP", "NUM", "Z"]),
];
fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.shaped() {
        if let BlockKind::Motion(motion) = &block.kind
            && let Some(word) = element(facts, block, motion)
        {
            let refused = matches!(motion.path(), Path::Appr(_) | Path::Dep(_) | Path::Chf);
            let severity = if refused { Severity::Error } else { rule.severity };
            found.push(Diagnostic { severity, ..rule.at(facts, facts.content(block)).arg("word", word) });
        }
    }
    let mut report = |span: Span, word: &str| found.push(rule.at(facts, span).arg("word", word));
    for (_, block) in facts.marked() {
        if let BlockKind::Motion(motion) = &block.kind
            && motion.outline().has_odd_coords()
            && matches!(motion.path(), Path::Cr | Path::Ct)
            && !motion.outline().has_coords()
        {
            report(facts.content(block), "X, Y");
        }
    }
    // Angles that are not written stay as they were (TNC 640, 001: 6729).
    for own in facts.definitions.iter().filter(|own| tilts(own)) {
        let written: Vec<&str> = angles(facts, own).map(|(name, _)| name).collect();
        let missing: Vec<&str> = ["A", "B", "C"].into_iter().filter(|name| !written.contains(name)).collect();
        if !written.is_empty() && !missing.is_empty() && is_tilt(facts, own) {
            report(own.view.head, &missing.join(", "));
        }
    }
    let functions = words::functions(facts);
    let mut endings: Vec<Words<'_>> = Vec::new();
    for (index, block) in facts.marked() {
        match &block.kind {
            // In columns the name is on the next line, which is no block.
            BlockKind::Statement(own)
                if own.kind == StatementKind::DeclareContour
                    && own.words.is_empty()
                    && facts.program.blocks().get(index + 1).is_some_and(Block::is_unread) => {}
            BlockKind::PatternDef(own) => {
                for (span, word) in patterns(facts, own) {
                    report(span, word);
                }
            }
            BlockKind::Statement(own) => {
                if let Some(word) = statement(facts, own, facts.content(block)) {
                    report(facts.content(block), word);
                } else if own.kind != StatementKind::Plane {
                    lacking(facts, block, &mut report);
                }
            }
            BlockKind::CyclCall(own) => {
                if let CallForm::Position(coords) = &own.form {
                    let axes = [Axis::X, Axis::Y, Axis::Z];
                    if let Some(axis) = axes.iter().find(|axis| !coords.iter().any(|own| own.axis == **axis)) {
                        report(facts.content(block), axis.name());
                    }
                }
            }
            BlockKind::TextFormula(_) => lacking(facts, block, &mut report),
            _ if words::has_function(block, &functions) => {
                lacking(facts, block, &mut report);
                endings.extend(words::of(facts, block).into_iter().filter(Words::is_begun_by_some));
            }
            _ => {}
        }
    }
    // What other programs began may be ended here.
    if !facts.begins() || facts.flow.programs || facts.flow.unread.any() {
        return;
    }
    let begun: BTreeSet<_> = endings.iter().filter(|own| own.begins()).map(Words::name).collect();
    for ending in &endings {
        if let Some(word) = ending.beginning().filter(|_| !begun.contains(&ending.name())) {
            report(ending.span(), &word);
        }
    }
}

/// The words that the file of the language asks for.
fn lacking(facts: &Facts<'_>, block: &Block, report: &mut impl FnMut(Span, &str)) {
    for words in words::of(facts, block) {
        if let Some(word) = words.lacking() {
            report(words.span(), &word);
        }
    }
}

/// Whether one of the words has the name, written as it is in programs.
fn has(facts: &Facts<'_>, words: &[NamedWord], name: &str) -> bool {
    words.iter().any(|word| facts.text(word.name).trim().eq_ignore_ascii_case(name))
}

fn element(facts: &Facts<'_>, block: &Block, motion: &Element) -> Option<&'static str> {
    let approach = match motion.path() {
        // Long programs have millions of them.
        Path::Ln => {
            let text = facts.text(block.span).as_bytes();
            let of = |letter: u8, axis: u8| {
                memchr::memchr_iter(axis, text).any(|at| text.get(at.wrapping_sub(1)) == Some(&letter))
            };
            // Most of them have the whole normal and nothing else, or the whole direction of the tool.
            let [normal, tool] = [b'N', b'T'].map(|letter| [b'X', b'Y', b'Z'].map(|axis| of(letter, axis)));
            if [normal, tool].iter().all(|own| *own == [true; 3] || *own == [false; 3]) && (normal[0] || tool[0]) {
                return None;
            }
            return vector(facts, &motion.words().words);
        }
        Path::Fc | Path::Fct => return motion.words().counter_clockwise.is_none().then_some("DR"),
        Path::Chf => return motion.words().radius.is_none().then_some("CHF"),
        Path::Appr(form) | Path::Dep(form) => form,
        _ => return None,
    };
    let words = motion.words();
    let polar = words.coords.is_empty() && !motion.outline().has_coords();
    match approach {
        Approach::Plt | Approach::Pln | Approach::Pct | Approach::Plct if polar => return Some("PR, PA"),
        Approach::Lct => return polar.then_some("X, Y").or_else(|| words.radius.is_none().then_some("R")),
        _ if polar && matches!(motion.path(), Path::Appr(_)) => return Some("X, Y"),
        _ => {}
    }
    let lacks = |name: &str| !has(facts, &words.words, name);
    match approach {
        Approach::Lt | Approach::Ln | Approach::Plt | Approach::Pln if lacks("LEN") => Some("LEN"),
        Approach::Ct | Approach::Pct if lacks("CCA") => Some("CCA"),
        form if form.has_arc() && words.radius.is_none() => Some("R"),
        _ => None,
    }
}

/// What a line with a surface normal lacks: all of it, or a component of a vector of which others are there.
fn vector(facts: &Facts<'_>, words: &[NamedWord]) -> Option<&'static str> {
    const NORMAL: [&str; 3] = ["NX", "NY", "NZ"];
    const TOOL: [&str; 3] = ["TX", "TY", "TZ"];
    if !NORMAL.iter().chain(&TOOL).any(|name| has(facts, words, name)) {
        return Some("NX, NY, NZ");
    }
    let partly = |names: &[&'static str; 3]| {
        let begun = names.iter().any(|name| has(facts, words, name));
        names.iter().copied().find(|name| begun && !has(facts, words, name))
    };
    partly(&NORMAL).or_else(|| partly(&TOOL))
}

fn patterns<'f>(facts: &'f Facts<'_>, own: &'f PatternDef) -> impl Iterator<Item = (Span, &'static str)> + 'f {
    own.items.iter().filter_map(|item| {
        let name = facts.text(item.name).trim().trim_end_matches(|c: char| c.is_ascii_digit());
        let (_, needed) = PATTERNS.iter().find(|(own, _)| own.eq_ignore_ascii_case(name))?;
        let names = || item.words.iter().map(|word| facts.text(word.name).trim());
        let is = |own: &str, name: &str| {
            own.eq_ignore_ascii_case(name)
                || own.strip_prefix(['I', 'i']).is_some_and(|own| own.eq_ignore_ascii_case(name))
        };
        let lacking = needed.iter().find(|name| !names().any(|own| is(own, name)))?;
        Some((item.name, *lacking))
    })
}

fn statement(facts: &Facts<'_>, own: &Statement, content: Span) -> Option<&'static str> {
    let first = || own.words.first().map(|word| facts.text(word.span)).unwrap_or_default();
    match own.kind {
        StatementKind::Fn(16) => {
            let text = first();
            let aimed = text.rsplit_once('/').is_some_and(|(_, target)| !target.trim().is_empty());
            (own.words.len() == 1 && !aimed && !text.is_empty()).then_some("/ …")
        }
        StatementKind::Fn(18) if !facts.text(content).contains('=') => Some("="),
        // What is read goes into a parameter, of which only the number is there.
        StatementKind::Fn(18) => {
            let target = own.words.first().filter(|word| facts.text(word.name).trim().is_empty())?;
            matches!(target.value.kind, ValueKind::Number(_)).then_some("Q")
        }
        StatementKind::Trans => {
            let axis = own.words.len() == 1 && first().trim().eq_ignore_ascii_case("AXIS");
            axis.then_some("X, Y, Z")
        }
        _ => None,
    }
}
