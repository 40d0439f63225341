//! Presets of a scene in which none is known.
//!
//! Invariant: whatever row a program activates first is that of the blank.
/// The row that is active before a program activates one: hardly any names it.
pub const UNNAMED_PRESET: u8 = 99;

/// What a scene says of presets that are not known: whatever row is activated first is that of the blank.
pub fn any_preset() -> String {
    let rows: Vec<String> = (0..=99).map(|row| format!("{{NO: {row}}}")).collect();
    format!("presets: {{active: {UNNAMED_PRESET}, rows: [{}]}}\n", rows.join(", "))
}
