//! Text as HTML and XML show it.
//!
//! Invariant: every character is shown, and none of them is taken for a mark.

/// Appends the text with the characters replaced that mean something in HTML.
pub(super) fn escape(text: &str, out: &mut String) {
    let mut rest = text;
    // All of them are one byte, and no part of another character has such a byte.
    while let Some(at) = rest.bytes().position(|byte| matches!(byte, b'&' | b'<' | b'>' | b'"')) {
        let (before, after) = rest.split_at(at);
        out.push_str(before);
        out.push_str(match after.as_bytes().first() {
            Some(b'&') => "&amp;",
            Some(b'<') => "&lt;",
            Some(b'>') => "&gt;",
            _ => "&quot;",
        });
        rest = &after[1..];
    }
    out.push_str(rest);
}
