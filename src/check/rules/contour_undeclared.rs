//! A contour formula that reads a contour which nothing names before it, or a contour that is declared twice.
//!
//! `DECLARE CONTOUR` and formulas name contours. Programs with labels may come to a formula another way than the text
//! goes: there only what is named nowhere is reported.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, Program, StatementKind};

pub(super) const RULE: Rule = Rule { code: "contour-undeclared", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let program = facts.program;
    let blocks: Vec<&Block> = facts.marked().map(|(_, block)| block).collect();
    if !blocks.iter().any(|block| names(program, block).is_some()) {
        return;
    }
    // What another program names is not known.
    let elsewhere = |block: &&Block| match &block.kind {
        BlockKind::CallPgm(_) | BlockKind::Unknown(_) => true,
        BlockKind::Statement(statement) => statement.kind == StatementKind::CallSelected,
        _ => false,
    };
    if blocks.iter().any(elsewhere) {
        return;
    }
    let straight = !blocks.iter().any(|block| matches!(block.kind, BlockKind::Lbl(_)));
    let mut named: BTreeSet<u32> = BTreeSet::new();
    if !straight {
        named.extend(blocks.iter().filter_map(|block| names(program, block)));
    }
    for block in &blocks {
        if let BlockKind::ContourFormula(formula) = &block.kind {
            for (number, span) in formula.reads.iter().filter(|(number, _)| !named.contains(number)) {
                found.push(rule.at(facts, *span).arg("what", "nothing").arg("contour", format!("QC{number}")));
            }
        }
        let own = names(program, block);
        if let Some(number) = own.filter(|_| matches!(block.kind, BlockKind::Statement(_)))
            && straight
            && named.contains(&number)
        {
            let finding = rule.at(facts, facts.content(block)).arg("what", "twice");
            let finding = finding.arg("contour", format!("QC{number}"));
            found.push(Diagnostic { severity: Severity::Warning, ..finding });
        }
        named.extend(own);
    }
}

/// The contour that a block names.
fn names(program: &Program, block: &Block) -> Option<u32> {
    match &block.kind {
        BlockKind::ContourFormula(formula) => Some(formula.target),
        BlockKind::Statement(statement) if statement.kind == StatementKind::DeclareContour => {
            let head = statement.head.end;
            let rest = program.source().text().get(head..program.content(block).end)?;
            let digits = rest.trim_start().get(2..)?.trim_start();
            let length = digits.bytes().take_while(u8::is_ascii_digit).count();
            digits.get(..length)?.parse().ok()
        }
        _ => None,
    }
}
