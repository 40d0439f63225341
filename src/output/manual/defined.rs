//! Which cycles a worked program is about.
use std::collections::BTreeSet;

use crate::base::diag::Source;
use crate::program::syntax::{self, BlockKind, CycleKeyword};
use crate::spec::{CycleKey, Keyword, Worked};

/// The cycle that a program is about, and those that it and the programs that it calls define.
pub(super) fn cycles(worked: &Worked) -> BTreeSet<CycleKey> {
    let texts = std::iter::once(worked.text()).chain(worked.called().map(|(_, text)| text));
    let programs: Vec<_> = texts.map(|text| syntax::parse(&Source::new("program", text))).collect();
    let key = |keyword: CycleKeyword, number| match keyword {
        CycleKeyword::CyclDef => CycleKey::new(Keyword::CyclDef, number),
        CycleKeyword::TchProbe => CycleKey::new(Keyword::TchProbe, number),
    };
    let defined = programs.iter().flat_map(|program| program.blocks()).filter_map(|block| match &block.kind {
        BlockKind::CycleDef(cycle) => Some(key(cycle.keyword, cycle.number)),
        BlockKind::OldCycleLine(line) => Some(key(line.keyword, line.number)),
        _ => None,
    });
    defined.chain([worked.key]).collect()
}
