//! `FUNCTION TURNDATA`: how fast the workpiece turns, and how the turning tool is corrected.
//!
//! The manuals of the cycles do not describe the correction; what it does is common knowledge of the trade
//! (`docs/events.md`).
//! Invariant: a word that is not executed is a fault, never ignored.
use crate::engine::flow::state::Run;
use crate::engine::machine::InsertCorrection;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::world::insert::Aligned;
use crate::program::syntax::{Statement, ValueKind};

impl Run<'_, '_> {
    /// `FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX:2000`, `FUNCTION TURNDATA SPIN VCONST:OFF S500`,
    /// `FUNCTION TURNDATA BLANK LBL 20` and the corrections.
    pub(super) fn turning_data(&mut self, statement: &Statement) -> Done {
        let refused = |word: &str| Fault::unsupported("unsupported-block").arg("word", format!("TURNDATA {word}"));
        let mut words = statement.words.iter();
        let first = words.next().map_or("", |word| self.slice(word.name)).trim().to_ascii_uppercase();
        let first = first.trim_end_matches(':').trim_end().to_owned();
        if let Some(system) = first.strip_prefix("CORR-") {
            return self.correct_insert(statement, system);
        }
        // It is printed without a space between the words, too (TNC 640 manual, line 7365).
        if self.slice(statement.head).trim_end().to_ascii_uppercase().ends_with("BLANK") {
            return self.describe_blank(&statement.words);
        }
        if first == "BLANK" {
            return self.describe_blank(statement.words.get(1..).unwrap_or_default());
        }
        if first != "SPIN" {
            return Err(refused(&first).into());
        }
        let mut turned = self.drives.switched.turned;
        let (mut constant, mut cutting) = (turned.cutting_speed.is_some(), turned.cutting_speed);
        for word in words {
            let name = self.slice(word.name).trim().trim_end_matches(':').to_ascii_uppercase();
            match name.as_str() {
                "VCONST" => {
                    let state = match word.value.kind {
                        ValueKind::Missing => String::new(),
                        _ => self.slice(word.value.span).trim().trim_start_matches(':').to_ascii_uppercase(),
                    };
                    constant = match state.as_str() {
                        "ON" => true,
                        "OFF" => false,
                        other => return Err(refused(&format!("SPIN VCONST {other}")).into()),
                    };
                }
                "VC" => cutting = Some(self.number_of(&word.value)?),
                "S" => turned.speed = self.number_of(&word.value)?,
                "SMAX" => turned.limit = Some(self.number_of(&word.value)?).filter(|limit| *limit > 0.0),
                other => return Err(refused(&format!("SPIN {other}")).into()),
            }
        }
        turned.cutting_speed = cutting.filter(|_| constant);
        self.drives.switched.turned = turned;
        if turned.direction != 0 {
            self.drives.turn_workpiece(turned.direction)?;
        }
        Ok(())
    }

    /// `FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1 DXL:0.05` corrects the lengths of the tool, `CORR-WPL` in the coordinate
    /// system of the workpiece; `DRS` the radius of the nose, `DCW` the cutting width. Up to the next tool call; what is
    /// not written is 0.
    fn correct_insert(&mut self, statement: &Statement, system: &str) -> Done {
        let refused = |word: &str| Fault::unsupported("unsupported-block").arg("word", format!("TURNDATA {word}"));
        let of_tool = match system {
            "TCS" => true,
            "WPL" => false,
            other => return Err(refused(&format!("CORR-{other}")).into()),
        };
        let mut correction = InsertCorrection { of_tool, ..InsertCorrection::default() };
        for (index, word) in statement.words.iter().enumerate() {
            if index == 0 {
                // The axes of the half plane, in which the lengths are.
                let plane = self.slice(word.value.span).trim_matches(|c: char| c == ':' || c.is_whitespace());
                if !plane.eq_ignore_ascii_case("Z/X") {
                    return Err(refused(&format!("CORR-{system} {plane}")).into());
                }
                continue;
            }
            let name = self.slice(word.name).trim().trim_end_matches(':').trim_end().to_ascii_uppercase();
            let value = self.number_of(&word.value)? * self.drives.unit();
            match name.as_str() {
                "DXL" => correction.lengths.x = value,
                "DZL" => correction.lengths.y = value,
                "DRS" => correction.radius = value,
                "DCW" => correction.width = value,
                other => return Err(refused(&format!("CORR-{system} {other}")).into()),
            }
        }
        let aligned = self.drives.world.aligned();
        self.drives.align(Aligned { correction, ..aligned });
        Ok(())
    }
}
