//! Which way a turning cycle goes that says where its contour begins and ends, read off its specification.
//!
//! Invariant: a cycle whose contour is elsewhere, or begins where the tool is, is not known.
use super::effect::actions;
use crate::base::expr::{Code, Env, OnlyParameters, compile};
use crate::spec::{Action, Argument, Cycle, Verb};

/// A turning cycle from a point to another one.
#[derive(Debug)]
pub(in crate::check) struct Turns {
    /// Whether it recesses across the rotary axis; nothing of one that does not recess.
    radial: Option<Code>,
    /// Diameter and coordinate on the rotary axis where the contour begins, and the same where it ends.
    ends: [Code; 4],
}

/// Where the insert goes: the signs of the changes of diameter and of the coordinate on the rotary axis; 0 where either
/// sign will do.
pub(in crate::check) type Way = [f64; 2];

impl Turns {
    /// What a cycle turns first.
    pub(in crate::check) fn of(cycle: &Cycle) -> Option<Self> {
        let mut verbs = Vec::new();
        cycle.file.run.iter().for_each(|item| actions(item, &mut verbs));
        verbs.into_iter().find_map(Self::of_action)
    }

    fn of_action(action: &Action) -> Option<Self> {
        let (Verb::Strategy, Argument::One(strategy)) = (action.verb, &action.argument) else { return None };
        let of = |name: &str| {
            let formula = action.with.0.iter().find(|(own, _)| own.as_str() == name);
            formula.and_then(|(_, formula)| compile(&formula.expr, &OnlyParameters).ok())
        };
        let radial = match strategy.as_str() {
            "turn-shoulder" => None,
            "groove" => Some(of("radial")?),
            _ => return None,
        };
        Some(Self { radial, ends: [of("start_diameter")?, of("start_z")?, of("end_diameter")?, of("end_z")?] })
    }

    /// Where the insert goes with some values; nothing where they are not known, or do not say it.
    pub(in crate::check) fn way(&self, values: &impl Env) -> Option<Way> {
        let at = |code: &Code| code.number(values).ok();
        let [from_diameter, from_z, to_diameter, to_z] = &self.ends;
        let (across, along) = (at(to_diameter)? - at(from_diameter)?, at(to_z)? - at(from_z)?);
        let sign = |change: f64| if change == 0.0 { 0.0 } else { change.signum() };
        Some(match &self.radial {
            None => [sign(across), sign(along)],
            Some(radial) if at(radial)? != 0.0 => [sign(across), 0.0],
            Some(_) => [0.0, sign(along)],
        })
    }
}
