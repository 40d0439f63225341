//! A datum table that is selected directly after the datum shift to one of the rows of a table.
//!
//! SEL TABLE comes before the shift that takes its row from it (TNC 640, 001: 6373). Only reported where no movement,
//! call or label is between the two, and where the program has selected no table before.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::program::with_meaning;
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::{BlockKind, CycleKeyword};

pub(super) const RULE: Rule = Rule { code: "datum-table-late", severity: Severity::Warning, run };

/// The meaning of the field that names a row.
const ROW: &str = "datum-row";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let selects = |kind: &BlockKind| match kind {
        BlockKind::Sel(own) => facts.text(own.what).eq_ignore_ascii_case("TABLE"),
        _ => false,
    };
    // After the first one another table may be selected for the shifts to come.
    let Some((index, block)) = facts.marked().find(|(_, block)| selects(&block.kind)) else { return };
    for (at, before) in facts.program.blocks().get(..index).unwrap_or_default().iter().enumerate().rev() {
        match &before.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => {}
            BlockKind::OldCycleLine(line) if line.keyword == CycleKeyword::CyclDef => {}
            BlockKind::CycleDef(_) => {}
            _ => break,
        }
        if let Some(definition) = facts.definition_at(at).filter(|own| names_row(facts, own)) {
            let place = Place::new(facts.program.source(), definition.view.head);
            found.push(rule.at(facts, facts.content(block)).related("other-place", place));
            return;
        }
    }
}

/// Whether a definition takes its values from a row.
fn names_row(facts: &Facts<'_>, definition: &Defined<'_>) -> bool {
    let takes = definition.cycle().is_some_and(|cycle| with_meaning(cycle, ROW).is_some());
    takes && facts.read(&definition.as_related_cycle()).item(ROW).is_some_and(|item| item.value.is_some())
}
