//! Any bytes are a program: they come back, the blocks cover the text, and every finding has a place inside.
#![no_main]
use ciklo::base::diag::Source;
use ciklo::program::syntax::encoding::decode;
use ciklo::program::syntax::{json, parse};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let decoded = decode(bytes);
    let written = decoded.encoding.encode(&decoded.text).expect("what was read can be written");
    assert_eq!(written.as_ref(), bytes);
    let program = parse(&Source::new("fuzz.h", decoded.text.as_str()));
    assert_eq!(program.text(), decoded.text);
    let mut at = 0;
    for block in program.blocks() {
        assert!(block.span.start == at && block.span.end > at && block.lines > 0);
        at = block.span.end;
    }
    assert_eq!(at, decoded.text.len());
    for finding in program.diagnostics() {
        let span = finding.place.expect("a place").span;
        assert!(span.start <= span.end && decoded.text.get(span.start..span.end).is_some());
    }
    assert_eq!(json::document(&program).unknown.len(), program.errors().count());
});
