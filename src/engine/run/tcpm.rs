//! Holding the tool tip on the workpiece while rotary axes turn: `M128` and `M129`,
//! `FUNCTION TCPM` and `FUNCTION RESET TCPM`.
//!
//! Invariant: while it is held, the system is part of the workpiece and the control reckons with how the tool is; a
//! word that asks for more is a fault, never ignored.
use std::collections::BTreeSet;

use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Block, Statement, ValueKind};

/// What `FUNCTION TCPM` may ask for: the feed is that of the tip, coordinates of rotary axes are positions,
/// and these turn evenly.
const HOLDS: [&str; 7] = ["F", "TCP", "AXIS", "POS", "PATHCTRL", "REFPNT", "TIP-TIP"];

/// What `FUNCTION RESET` ends that moves nothing.
const RESETS: [&str; 7] = ["FEED", "S", "S-PULSE", "COUNT", "PARAXCOMP", "LIFTOFF", "AFC"];

impl Run<'_, '_> {
    /// `FUNCTION` blocks, but for those that switch the mode.
    pub(super) fn function(&mut self, block: &Block, statement: &Statement) -> Done {
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
            "TURNDATA" | "TURNDATABLANK" => self.turning_data(statement),
            // How the feed is kept, and what is displayed: the tool goes the same way.
            "FEED" | "COUNT" | "LIFTOFF" | "AFC" => {
                self.report_function(block);
                Ok(())
            }
            "PARAXCOMP" => {
                self.compensate_parallel(statement)?;
                self.report_function(block);
                Ok(())
            }
            "PARAXMODE" if !statement.words.is_empty() => {
                self.choose_axes(statement)?;
                self.report_function(block);
                Ok(())
            }
            "DWELL" => self.dwell(statement),
            _ if head.replace(' ', "").starts_with("FUNCTIONS-PULSE") => {
                self.report_function(block);
                Ok(())
            }
            "RESET" if words.clone().all(|(name, _)| name == "TCPM") => self.drives.hold_tip(false),
            "RESET" if words.next().is_some_and(|(name, _)| RESETS.contains(&name.as_str())) => {
                if statement.words.iter().any(|word| self.slice(word.name).trim().eq_ignore_ascii_case("PARAXCOMP")) {
                    self.drives.world.parallels.compensate(BTreeSet::new());
                }
                self.report_function(block);
                Ok(())
            }
            _ => {
                let first = statement.words.first().map_or("", |word| self.slice(word.name)).trim();
                let words = head.split_ascii_whitespace().chain(first.split_ascii_whitespace());
                let word = words.collect::<Vec<_>>().join(" ");
                Err(Fault::unsupported("unsupported-block").arg("word", word).into())
            }
        }
    }

    /// `FUNCTION DWELL TIME2`, in seconds, and `FUNCTION DWELL REV5`, in turns of the spindle.
    fn dwell(&mut self, statement: &Statement) -> Done {
        for word in &statement.words {
            let value = || self.number_of(&word.value);
            let seconds = match self.slice(word.name).to_ascii_uppercase().as_str() {
                "TIME" => value()?,
                "REV" => {
                    let speed = self.drives.switched.spindle.speed;
                    if speed <= 0.0 {
                        return Err(Fault::unsupported("unsupported-block").arg("word", "FUNCTION DWELL REV").into());
                    }
                    value()? * 60.0 / speed
                }
                _ => continue,
            };
            self.drives.report.report(EventKind::Dwell(seconds));
            return Ok(());
        }
        Err(Fault::program("value-missing").into())
    }
}
