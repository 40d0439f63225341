//! Codes of cycles: which cycle and which form a code is, and the other way round.
//!
//! Invariant: what is known of a code comes from the specifications and profiles of all controls; a code from 200 on
//! that none of them has is the number of a cycle, as with all others.
use std::collections::BTreeMap;

use crate::spec::{Catalogue, Cycle, CycleKey, IsoWord, Keyword, OnControl};

/// The greatest code that is not itself the number of its cycle.
const LAST_OF_ITS_OWN: u32 = 199;

/// A form of a cycle that a code stands for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coded<'c> {
    pub(super) cycle: &'c Cycle,
    /// The index of the form; nothing for cycles with Q parameters.
    pub(super) form: Option<usize>,
    /// The words of the form.
    pub(super) words: &'c [IsoWord],
}

/// Where a code is described.
#[derive(Clone, Copy, Debug)]
struct Described<'c> {
    on: &'c OnControl,
    key: CycleKey,
    form: Option<usize>,
    code: &'c str,
}

impl<'c> Described<'c> {
    fn read(self) -> Option<Coded<'c>> {
        let cycle = self.on.cycles.get(&self.key)?;
        let all = match self.form {
            None => &cycle.file.iso,
            Some(form) => &cycle.file.forms.get(form)?.iso,
        };
        let words = &all.iter().find(|iso| iso.code == self.code)?.words;
        Some(Coded { cycle, form: self.form, words })
    }
}

/// The codes of all controls.
#[derive(Debug)]
pub struct Codes<'c> {
    by_code: BTreeMap<u32, Described<'c>>,
    /// Cycles with their codes as printed.
    printed: BTreeMap<(CycleKey, Option<usize>), Described<'c>>,
    /// Families of cycles that a manual names only.
    named: BTreeMap<u32, Keyword>,
}

impl<'c> Codes<'c> {
    /// The codes that a catalogue knows.
    pub fn new(catalogue: &'c Catalogue) -> Self {
        let mut codes = Self { by_code: BTreeMap::new(), printed: BTreeMap::new(), named: BTreeMap::new() };
        for on in catalogue.controls.values() {
            for (key, outline) in &on.outlines {
                codes.named.entry(key.number).or_insert(key.keyword);
                for (form, code) in &outline.codes {
                    let described = Described { on, key: *key, form: *form, code };
                    let Some(number) = code.strip_prefix('G').and_then(|digits| digits.parse().ok()) else {
                        continue;
                    };
                    codes.by_code.entry(number).or_insert(described);
                    codes.printed.entry((*key, *form)).or_insert(described);
                }
            }
            for named in &on.control.named {
                codes.named.entry(named.number).or_insert(named.keyword);
            }
        }
        codes
    }

    /// What a code stands for.
    pub(super) fn of(&self, code: u32) -> Option<Coded<'c>> {
        self.by_code.get(&code)?.read()
    }

    /// The cycle of a code that is its number.
    pub(super) fn numbered(&self, code: u32) -> Option<CycleKey> {
        let keyword = self.named.get(&code).copied().unwrap_or(Keyword::CyclDef);
        (code > LAST_OF_ITS_OWN).then(|| CycleKey::new(keyword, code))
    }

    /// The code of a cycle with Q parameters.
    pub(super) fn code(&self, key: CycleKey) -> Option<String> {
        if let Some(described) = self.printed.get(&(key, None)) {
            return Some(described.code.to_owned());
        }
        let described = self.by_code.contains_key(&key.number);
        (self.numbered(key.number) == Some(key) && !described).then(|| format!("G{}", key.number))
    }

    /// The codes of the forms of a cycle.
    pub(super) fn forms(&self, key: CycleKey) -> impl Iterator<Item = (&'c str, Coded<'c>)> {
        self.printed
            .range((key, Some(0))..=(key, Some(usize::MAX)))
            .filter_map(|(_, described)| Some((described.code, described.read()?)))
    }
}
