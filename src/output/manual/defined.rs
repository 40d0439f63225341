//! Which cycles a worked program defines.
use std::collections::BTreeSet;

use crate::base::diag::Source;
use crate::program::syntax::{self, BlockKind, CycleKeyword};
use crate::spec::{CycleKey, Keyword, Worked};

/// The cycles that a program defines.
pub(super) fn cycles(worked: &Worked) -> BTreeSet<CycleKey> {
    let program = syntax::parse(&Source::new("program", worked.text().to_owned()));
    let key = |keyword: CycleKeyword, number| match keyword {
        CycleKeyword::CyclDef => CycleKey::new(Keyword::CyclDef, number),
        CycleKeyword::TchProbe => CycleKey::new(Keyword::TchProbe, number),
    };
    let defined = program.blocks().iter().filter_map(|block| match &block.kind {
        BlockKind::CycleDef(cycle) => Some(key(cycle.keyword, cycle.number)),
        BlockKind::OldCycleLine(line) => Some(key(line.keyword, line.number)),
        _ => None,
    });
    defined.collect()
}
