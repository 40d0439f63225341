//! A table that a program selects and that is not in its folder.
//!
//! Only where the folder has other tables of that kind: otherwise tables are kept elsewhere. It is a warning where that
//! folder was checked as a whole, a note where single files were. Silent where the name has a folder or is a parameter.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "selected-table-missing", severity: Severity::Warning, run };

/// What is selected there is a table.
const TABLES: [&str; 2] = ["PATTERN", "TABLE"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(project) = facts.project else { return };
    for (_, block) in facts.marked() {
        let BlockKind::Sel(own) = &block.kind else { continue };
        if !TABLES.iter().any(|table| facts.text(own.what).eq_ignore_ascii_case(table)) {
            continue;
        }
        let name = facts.text(own.name).trim().trim_matches('"').trim();
        if let Some(severity) = project.lacks_file(name) {
            found.push(Diagnostic { severity, ..rule.at(facts, own.name).arg("name", name) });
        }
    }
}
