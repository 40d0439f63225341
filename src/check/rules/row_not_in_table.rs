//! A datum or preset of a row that its table lacks.
//!
//! Only where the table is named (`--table`, `tables` in `ciklo.toml`), or is the one that SEL TABLE names and lies beside
//! the program; of several datum tables it is the one that SEL TABLE selects before. Rows that parameters choose are only
//! looked at where their values are certain, in loops on each pass.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::number;
use crate::check::{Defined, Facts, Rows, Rule};
use crate::program::syntax::BlockKind;
use crate::spec::Param;

pub(super) const RULE: Rule = Rule { code: "row-not-in-table", severity: Severity::Warning, run };

/// The meanings of parameters that name a row which must be there.
const PRESET: &str = "preset-number";
const DATUM: &str = "datum-row";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(project) = facts.project.filter(|project| project.knows_rows()) else { return };
    let names_row = |param: &Param| matches!(param.is.as_str(), PRESET | DATUM);
    let names_rows = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.params.iter().any(names_row));
    let selected = selections(facts);
    for definition in facts.definitions.iter().filter(names_rows) {
        let related = definition.as_related_cycle();
        let definition = facts.read(&related);
        for item in &definition.items {
            let meaning = item.param.map_or("", |param| param.is.as_str());
            let rows = match meaning {
                PRESET => Rows::Presets,
                DATUM => {
                    let before = selected.partition_point(|(block, _)| *block < definition.view.first);
                    Rows::Datums(before.checked_sub(1).and_then(|at| selected.get(at)).map(|(_, name)| *name))
                }
                _ => continue,
            };
            // A loop may count rows up: each of its passes is looked at.
            let counted = || {
                facts
                    .run
                    .numbers_at(item.value_span)
                    .iter()
                    .copied()
                    .find(|row| project.has_row(rows, *row) == Some(false))
            };
            let Some(row) = number(item).or_else(counted) else { continue };
            if project.has_row(rows, row) == Some(false) {
                let table = if rows == Rows::Presets { "preset" } else { "datum" };
                found.push(rule.at(facts, item.value_span).arg("row", Arg::Number(row)).arg("table", table));
            }
        }
    }
}

/// The datum tables that are selected, with their blocks, in the order of the text.
fn selections<'a>(facts: &Facts<'a>) -> Vec<(usize, &'a str)> {
    let selections = facts.marked().filter_map(|(index, block)| match &block.kind {
        BlockKind::Sel(own) if facts.text(own.what).eq_ignore_ascii_case("TABLE") => {
            Some((index, facts.text(own.name).trim()))
        }
        _ => None,
    });
    selections.collect()
}
