//! Where the messages of a language are in its files, so that only those that are asked for have to be parsed.
//!
//! A message is found by the number that its identifier makes, without variants: a record of 16 bytes is that number,
//! the file, the first byte and the length, each in four bytes, the lowest first. Records are sorted by number, file
//! and place. Invariant: a message is all from a line that begins with its identifier up to the next line that begins
//! another entry or a comment.
use std::ops::Range;

const RECORD: usize = 16;

/// Where a message is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    /// The index of the file.
    pub(crate) file: usize,
    /// The stretch of it.
    pub(crate) span: Range<usize>,
}

/// The records of files, given by their indices.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn write<'t>(files: impl Iterator<Item = (usize, &'t str)>) -> Vec<u8> {
    let mut records: Vec<[u32; 4]> = Vec::new();
    let narrow = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
    for (file, text) in files {
        for span in messages(text) {
            let number = number(base(identifier(&text[span.clone()])));
            records.push([number, narrow(file), narrow(span.start), narrow(span.len())]);
        }
    }
    records.sort_unstable();
    records.iter().flatten().flat_map(|part| part.to_le_bytes()).collect()
}

/// The messages and terms of a file.
pub(crate) fn messages(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let (mut at, mut open) = (0, false);
    for line in text.split_inclusive('\n') {
        match line.as_bytes().first() {
            Some(b'a'..=b'z' | b'A'..=b'Z' | b'-') => {
                found.push(at..at);
                open = true;
            }
            Some(b'#') => open = false,
            _ => {}
        }
        at += line.len();
        if let (Some(last), true) = (found.last_mut(), open) {
            last.end = at;
        }
    }
    found
}

/// The identifier that a message begins with; that of a term has its hyphen.
pub(crate) fn identifier(message: &str) -> &str {
    let end = message.find(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_'));
    &message[..end.unwrap_or(message.len())]
}

/// An identifier without its variant.
pub(crate) fn base(identifier: &str) -> &str {
    identifier.split_once("__").map_or(identifier, |(base, _)| base)
}

fn number(id: &str) -> u32 {
    id.bytes().fold(0x811c_9dc5, |number: u32, byte| (number ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

fn record(records: &[u8], at: usize) -> Option<[u32; 4]> {
    let own = records.get(at * RECORD..(at + 1) * RECORD)?;
    let part = |from: usize| Some(u32::from_le_bytes(own.get(from..from + 4)?.try_into().ok()?));
    Some([part(0)?, part(4)?, part(8)?, part(12)?])
}

/// How many messages there are, each variant counted.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn len(records: &[u8]) -> usize {
    records.len() / RECORD
}

/// The place of each message, in the order of the records.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn at(records: &[u8], at: usize) -> Option<Found> {
    let [_, file, start, length] = record(records, at)?;
    let start = start as usize;
    Some(Found { file: file as usize, span: start..start + length as usize })
}

/// Whether two neighbouring records have the same number.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn alike(records: &[u8], one: usize, other: usize) -> bool {
    matches!((record(records, one), record(records, other)), (Some([a, ..]), Some([b, ..])) if a == b)
}

/// The records that may be those of an identifier without its variant: others may have the same number.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn find(records: &[u8], id: &str) -> Range<usize> {
    let wanted = number(id);
    let first = |least: u32| {
        let (mut low, mut high) = (0, len(records));
        while low < high {
            let middle = low + (high - low) / 2;
            if record(records, middle).is_some_and(|[own, ..]| own < least) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    };
    let from = first(wanted);
    from..wanted.checked_add(1).map_or(len(records), first)
}
