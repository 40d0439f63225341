//! `FUNCTION TURNDATA`: how fast the workpiece turns.
//!
//! Invariant: a word that is not executed is a fault, never ignored.
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Statement, ValueKind};

impl Run<'_, '_> {
    /// `FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX:2000`, `FUNCTION TURNDATA SPIN VCONST:OFF S500` and
    /// `FUNCTION TURNDATA BLANK OFF`.
    pub(super) fn turning_data(&mut self, statement: &Statement) -> Done {
        let refused = |word: &str| Fault::unsupported("unsupported-block").arg("word", format!("TURNDATA {word}"));
        let mut words = statement.words.iter();
        let first = words.next().map_or("", |word| self.slice(word.name)).trim().to_ascii_uppercase();
        if first == "BLANK" {
            // How the control changes cycles to suit a blank is not described (TNC 640 manual, lines 7328-7340).
            let named = statement.words.iter().flat_map(|word| [self.slice(word.name), self.slice(word.value.span)]);
            let is_off = named.into_iter().any(|text| text.trim().eq_ignore_ascii_case("OFF"));
            return if is_off { Ok(()) } else { Err(Fault::unsupported("blank-form-update").into()) };
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
}
