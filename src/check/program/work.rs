//! What the machining cycles of the first controls do, which no manual known here describes: their names say it, in
//! DIN/ISO their codes.
//!
//! Invariant: a name that leaves a doubt says nothing.
use super::definition::Defined;
use crate::program::syntax::{IsoBlock, IsoKind, Program};
use crate::spec::{Keyword, Known};

/// What such a cycle does where it is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::check) enum Work {
    /// It drills.
    Drilling,
    /// It taps with a floating tap holder: the spindle turns before.
    Tapping,
    /// It taps and turns the spindle itself.
    RigidTapping,
    /// It mills a slot, a pocket, a stud or a face.
    Milling,
}

/// The beginnings of words for what is not called at a place of its own, or only drills for such.
const OTHERS: [&str; 8] = ["CONTOUR", "KONTUR", "CONTORNO", "PROFIL", "PILOT", "VORBOHR", "PATTERN", "MUSTER"];
const TAPS: [&str; 6] = ["TAPPING", "GEWINDEBOHR", "MASCHIATUR", "ROSCADO", "KIERTEITY", "VREZOVANJ"];
const RIGID: [&str; 1] = ["RIGID"];
const DRILLS: [&str; 8] = ["PECK", "DRILL", "BOHR", "TIEFBOHR", "FORATUR", "FURA", "PORAUS", "VRTANJ"];
const MILLS: [&str; 18] = [
    "POCKET",
    "SLOT",
    "STUD",
    "MILLING",
    "TASCHE",
    "KREISTASCHE",
    "NUTEN",
    "FRAES",
    "FRÄS",
    "ZAPFEN",
    "TASCA",
    "SCANALATUR",
    "FRESATUR",
    "CAIXA",
    "RANHURA",
    "TASKU",
    "URA",
    "UTOR",
];

impl Work {
    /// What the cycle of a definition does, if no control describes it.
    pub(in crate::check) fn of(program: &Program, own: &Defined<'_>) -> Option<Self> {
        let known = own.related_cycle().is_some() || matches!(own.known, Known::Builders);
        if known || own.key.keyword != Keyword::CyclDef {
            return None;
        }
        Self::named(program.slice(own.view.name?))
    }

    /// What a block of DIN/ISO defines, if nothing else is in it.
    pub(in crate::check) fn of_iso(own: &IsoBlock) -> Option<Self> {
        let IsoKind::Cycle(code) = own.kind else { return None };
        let work = match code {
            74..=78 => Self::Milling,
            83 => Self::Drilling,
            84 => Self::Tapping,
            85 => Self::RigidTapping,
            _ => return None,
        };
        own.functions.is_empty().then_some(work)
    }

    /// What a cycle does by its name.
    pub(in crate::check) fn named(name: &str) -> Option<Self> {
        let name = name.to_uppercase();
        let words = || name.split(|sign: char| !sign.is_alphabetic()).filter(|word| !word.is_empty());
        let says = |stems: &[&str]| words().any(|word| stems.iter().any(|stem| word.starts_with(stem)));
        let whole = |own: &str| words().any(|word| word == own);
        let taps = says(&TAPS) || whole("GEW") && says(&["BOHR"]);
        match () {
            () if says(&OTHERS) => None,
            () if taps && (says(&RIGID) || whole("GS")) => Some(Self::RigidTapping),
            () if taps => Some(Self::Tapping),
            () if says(&MILLS) => Some(Self::Milling),
            () if says(&DRILLS) => Some(Self::Drilling),
            () => None,
        }
    }
}

/// Whether a cycle that no control describes mills a slot, a pocket, a stud or a face, by its name.
pub fn mills_by_name(name: &str) -> bool {
    Work::named(name) == Some(Work::Milling)
}
