//! What a scene assumes where nothing is known: presets, and an operator who goes on.
//!
//! Invariant: whatever row a program activates first is that of the blank.
/// The row that is active before a program activates one: hardly any names it.
pub const UNNAMED_PRESET: u8 = 99;

/// What a scene says of presets that are not known: whatever row is activated first is that of the blank.
pub fn any_preset() -> String {
    let rows: Vec<String> = (0..=99).map(|row| format!("{{NO: {row}}}")).collect();
    format!("presets: {{active: {UNNAMED_PRESET}, rows: [{}]}}\n", rows.join(", "))
}

/// So often the operator goes on where the program stops.
const STOPS: usize = 20;

/// What a scene says of stops: the operator goes on.
pub fn goes_on() -> String {
    format!("answers: [{}]\n", vec!["{to: stop, say: continue}"; STOPS].join(", "))
}
