//! Holding the tool tip on the workpiece while rotary axes turn: `M128` and `M129`,
//! `FUNCTION TCPM` and `FUNCTION RESET TCPM`.
//!
//! Invariant: while it is held, the system is part of the workpiece and the control reckons with how the tool is; a
//! word that asks for more is a fault, never ignored.
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Statement, ValueKind};

/// What `FUNCTION TCPM` may ask for: the feed is that of the tip, coordinates of rotary axes are positions,
/// and these turn evenly.
const HOLDS: [&str; 7] = ["F", "TCP", "AXIS", "POS", "PATHCTRL", "REFPNT", "TIP-TIP"];

impl Run<'_, '_> {
    /// `FUNCTION` blocks, but for those that switch the mode.
    pub(super) fn function(&mut self, statement: &Statement) -> Done {
        let head = self.slice(statement.head).to_ascii_uppercase();
        let what = head.split_ascii_whitespace().nth(1).unwrap_or_default();
        let mut words =
            statement.words.iter().map(|word| (self.slice(word.name).to_ascii_uppercase(), word.value.kind));
        match what {
            "TCPM" => {
                let known = |(name, value): &(String, ValueKind)| {
                    HOLDS.contains(&name.as_str()) && (*value == ValueKind::Missing || name == "F")
                };
                if let Some((word, _)) = words.find(|word| !known(word)) {
                    let word = format!("FUNCTION TCPM {word}");
                    return Err(Fault::unsupported("unsupported-block").arg("word", word).into());
                }
                self.drives.hold_tip(true)
            }
            "RESET" if words.all(|(name, _)| name == "TCPM") => self.drives.hold_tip(false),
            _ => Err(self.not_executed(statement.head).into()),
        }
    }
}
