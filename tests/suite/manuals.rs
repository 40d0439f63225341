//! The NC code that the five manuals print: every block is understood, every misprint is found and explained, and the
//! checker says nothing that is not explained.
//!
//! `tests/manuals/00N.txt` are the blocks with the lines where they stand, `misprints.txt` those that no control would
//! read, `findings.txt` what the checker finds although the block can be read.
use std::collections::{BTreeMap, BTreeSet};

use ciklo::base::diag::Source;
use ciklo::check::{Against, LabelBook, check};
use ciklo::language::locale::Locales;
use ciklo::program::syntax::{json, parse};
use ciklo::spec::Catalogue;

const MANUALS: [(&str, &str); 5] = [
    ("000", include_str!("../manuals/000.txt")),
    ("001", include_str!("../manuals/001.txt")),
    ("002", include_str!("../manuals/002.txt")),
    ("003", include_str!("../manuals/003.txt")),
    ("004", include_str!("../manuals/004.txt")),
];

/// What is true of excerpts because they are excerpts: examples that follow each other, programs without their ends.
const OF_EXCERPTS: [&str; 5] =
    ["block-numbers", "begin-end-mismatch", "label-duplicate", "program-begin-missing", "program-end-missing"];

/// Blocks that stand together in a manual.
struct Fragment {
    control: String,
    /// Definitions are shortened with dots.
    abridged: bool,
    /// The line of the manual and what stands there.
    lines: Vec<(String, String)>,
}

impl Fragment {
    fn text(&self) -> String {
        self.lines.iter().map(|(_, text)| format!("{text}\n")).collect()
    }
}

fn fragments() -> Vec<Fragment> {
    let mut all: Vec<Fragment> = Vec::new();
    for (manual, text) in MANUALS {
        let control = text.split("control: ").nth(1).and_then(|rest| rest.split(['.', ' ']).next()).expect("a control");
        for line in text.lines().filter(|line| !line.starts_with(';')) {
            if let Some(head) = line.strip_prefix("== ") {
                let abridged = head.ends_with(" abridged");
                all.push(Fragment { control: control.to_owned(), abridged, lines: Vec::new() });
            } else {
                let (at, block) = line.split_once('\t').expect("a line and a block");
                let fragment = all.last_mut().expect("a fragment");
                fragment.lines.push((format!("{manual}:{at}"), block.to_owned()));
            }
        }
    }
    all
}

/// Place and printed text → text as meant.
fn misprints() -> BTreeMap<(String, String), String> {
    let text = include_str!("../manuals/misprints.txt");
    let entries = text.lines().filter(|line| !line.starts_with(';'));
    let entry = |line: &str| {
        let (at, rest) = line.split_once(" | ").expect("a place");
        let (texts, why) = rest.rsplit_once(" | ").expect("a reason");
        assert!(why.len() > 5, "{line}");
        // A formula of contours has bars of its own: of the places to divide the middle one is meant.
        let bars: Vec<usize> = texts.match_indices(" | ").map(|(at, _)| at).collect();
        let middle = *bars.iter().min_by_key(|at| at.abs_diff(texts.len() / 2)).expect("two texts");
        ((at.to_owned(), texts[..middle].to_owned()), texts[middle + 3..].to_owned())
    };
    entries.map(entry).collect()
}

fn findings() -> BTreeSet<(String, String)> {
    let text = include_str!("../manuals/findings.txt");
    let entry = |line: &str| {
        let (head, why) = line.split_once(" | ").expect("a reason");
        assert!(why.len() > 5, "{line}");
        let (at, code) = head.split_once(' ').expect("a code");
        (at.to_owned(), code.to_owned())
    };
    text.lines().filter(|line| !line.starts_with(';')).map(entry).collect()
}

/// The fragments with their misprints put right.
fn mended() -> Vec<Fragment> {
    let misprints = misprints();
    let mut all = fragments();
    for line in all.iter_mut().flat_map(|fragment| &mut fragment.lines) {
        if let Some(meant) = misprints.get(&(line.0.clone(), line.1.clone())) {
            line.1.clone_from(meant);
        }
    }
    all
}

#[test]
fn every_printed_block_is_understood() {
    let mut blocks = 0;
    for fragment in mended() {
        let text = fragment.text();
        let program = parse(&Source::new("printed.h", text.as_str()));
        assert_eq!(program.text(), text);
        blocks += program.blocks().len();
        let unknown: Vec<_> =
            json::document(&program).unknown.iter().map(|it| (&fragment.lines[it.line - 1].0, it.text)).collect();
        assert_eq!(unknown, []);
    }
    assert!(blocks > 1300, "only {blocks} blocks were read");
}

struct Data {
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    fn new() -> Self {
        Self { catalogue: &crate::built::built().catalogue, locales: &crate::built::built().locales }
    }

    /// The places and codes of what is found in the fragments.
    fn check(&self, fragments: &[Fragment]) -> BTreeSet<(String, String)> {
        let mut found = BTreeSet::new();
        for (control, on) in ["tnc640", "tnc320", "itnc530", "tnc426-430"].map(|name| (name, self.catalogue.on(name))) {
            let on = on.expect("the control");
            let labels = LabelBook::new(on, self.locales);
            let against = Against {
                catalogue: self.catalogue,
                on,
                labels: &labels,
                language: None,
                software: None,
                readers: &[],
            };
            for fragment in fragments.iter().filter(|it| it.control == control && !it.abridged) {
                let program = parse(&Source::new("printed.h", fragment.text()));
                for finding in check(&program, &against).iter().filter(|it| !OF_EXCERPTS.contains(&it.code)) {
                    let line = finding.place.as_ref().expect("a place").start().line;
                    found.insert((fragment.lines[line - 1].0.clone(), finding.code.to_owned()));
                }
            }
        }
        found
    }
}

#[test]
fn what_the_checker_finds_is_explained() {
    let found = Data::new().check(&mended());
    assert_eq!(found, findings());
}

#[test]
fn every_misprint_is_found() {
    let data = Data::new();
    let printed = fragments();
    let misprints = misprints();
    let written: BTreeSet<_> = printed.iter().flat_map(|it| it.lines.iter().cloned()).collect();
    let found: BTreeSet<String> = data.check(&printed).into_iter().map(|(at, _)| at).collect();
    let of = |at: &str| printed.iter().find(|it| it.lines.iter().any(|(own, _)| own == at)).expect("its fragment");
    for (at, text) in misprints.keys() {
        assert!(written.contains(&(at.clone(), text.clone())), "{at} does not print {text}");
        // The line itself, or the definition that it belongs to.
        let fragment = of(at);
        let found =
            fragment.abridged || found.contains(at) || fragment.lines.iter().any(|(own, _)| found.contains(own));
        assert!(found, "nothing is said of {at}: {text}");
    }
}
