//! Any text is told in Klartext, and any Klartext in DIN/ISO, block by block: what is said stands inside of the file,
//! and what both languages have comes back as the same text.
#![no_main]
use std::sync::OnceLock;

use ciklo::base::data;
use ciklo::base::diag::Source;
use ciklo::program::iso::{Codes, to_iso, to_klartext};
use ciklo::spec::Catalogue;
use ciklo::program::syntax::parse;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    static CATALOGUE: OnceLock<Catalogue> = OnceLock::new();
    static CODES: OnceLock<Codes<'static>> = OnceLock::new();
    let codes = CODES.get_or_init(|| Codes::new(CATALOGUE.get_or_init(|| Catalogue::load(&data::embedded()).0)));
    let inside = |text: &str, start: usize, end: usize| assert!(text.get(start..end).is_some(), "{start} to {end}");

    let lowered = to_klartext(&parse(&Source::new("fuzz.i", text)), codes, None);
    for block in lowered.program.blocks() {
        let home = lowered.home(block.span);
        inside(text, home.start, home.end);
    }
    for finding in &lowered.diagnostics {
        let span = finding.place.as_ref().expect("a place").span;
        inside(text, span.start, span.end);
    }

    let program = parse(&Source::new("fuzz.h", text));
    let raised = to_iso(&program, codes);
    for finding in &raised.diagnostics {
        let span = finding.place.as_ref().expect("a place").span;
        inside(text, span.start, span.end);
    }
    // What was written in full is read in full, and is the same text from then on: the first way back may name what was
    // known from elsewhere, as the tool axis.
    let round = |text: &str| {
        let back = to_klartext(&parse(&Source::new("fuzz.i", text)), codes, None);
        back.diagnostics.is_empty().then(|| to_iso(&back.program, codes).text)
    };
    if raised.diagnostics.is_empty()
        && program.diagnostics().is_empty()
        && program.blocks().len() > 2
        && let Some(once) = round(&raised.text)
    {
        assert_eq!(round(&once).as_ref(), Some(&once));
    }
});
