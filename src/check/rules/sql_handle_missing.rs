//! SQL with a handle that no query of the program has given, or that a query gave and COMMIT or ROLLBACK has ended.
//!
//! `SQL Q5 "SELECT …"` gives the handle; FETCH, UPDATE, INSERT, COMMIT and ROLLBACK name it. ROLLBACK with INDEX goes
//! on with one row. Silent in parts of programs, after calls of other programs, and where the handle is calculated;
//! an ended one is reported where nothing but the order of the text leads there.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, NamedWord, Statement, StatementKind, ValueKind};

pub(super) const RULE: Rule = Rule { code: "sql-handle-missing", severity: Severity::Warning, run };

/// What a handle is used for.
const USES: [&str; 5] = ["FETCH", "UPDATE", "INSERT", "COMMIT", "ROLLBACK"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() {
        return;
    }
    let calls = facts.flow.programs || !facts.calls.is_empty();
    let statements = || {
        facts.marked().filter_map(|(_, block)| match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::Sql => Some((block, own.as_ref())),
            _ => None,
        })
    };
    if statements().next().is_none() || facts.marked().any(|(_, block)| may_query(facts, block)) {
        return;
    }
    let given: BTreeSet<QRef> = statements().filter_map(|(_, own)| gives(own)).collect();
    let calculated = calculated(facts);
    // Whether a handle acts, as far as the text goes on without labels and jumps.
    let mut acts: BTreeMap<QRef, bool> = BTreeMap::new();
    let mut straight = !facts.flow.unread.anything;
    for (_, block) in facts.marked() {
        let own = match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::Sql => own,
            // From here on other programs may have been called.
            BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::CallPgm(_) if calls => return,
            BlockKind::Statement(own) if calls && own.kind == StatementKind::CallSelected => return,
            BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::FnJump(_) => {
                straight = false;
                acts.clear();
                continue;
            }
            _ => continue,
        };
        if let Some(q) = gives(own) {
            acts.insert(q, true);
        }
        let Some((what, q, word)) = used(facts, own) else { continue };
        if calculated.contains(&q) {
            continue;
        }
        let early = straight && !facts.flow.jumps && !acts.contains_key(&q);
        let why = match acts.get(&q) {
            _ if !given.contains(&q) || early => "missing",
            Some(false) => "ended",
            _ => "",
        };
        if !why.is_empty() {
            let finding = rule.at(facts, word.span).arg("handle", q.to_string());
            found.push(finding.arg("what", why));
        }
        let row = own.words.iter().any(|word| facts.text(word.name).trim().eq_ignore_ascii_case("INDEX"));
        if what == "COMMIT" || (what == "ROLLBACK" && !row) {
            acts.insert(q, block.skip);
        }
        if block.skip {
            acts.remove(&q);
        }
    }
}

/// Whether a block that cannot be read may be a query.
fn may_query(facts: &Facts<'_>, block: &Block) -> bool {
    let unread = match &block.kind {
        BlockKind::Unknown(_) | BlockKind::Iso(_) => true,
        BlockKind::Statement(own) => matches!(own.kind, StatementKind::Refused | StatementKind::Indirect),
        _ => false,
    };
    unread && facts.text(block.span).to_ascii_uppercase().contains("SQL")
}

/// The handle that a query gives.
fn gives(own: &Statement) -> Option<QRef> {
    match own.words.as_slice() {
        [NamedWord { value, .. }, ..] => match value.kind {
            ValueKind::Q { q, .. } => Some(q),
            _ => None,
        },
        [] => None,
    }
}

/// What a block uses a handle for, the handle and its word.
fn used<'s>(facts: &Facts<'_>, own: &'s Statement) -> Option<(&'static str, QRef, &'s NamedWord)> {
    let first = facts.text(own.words.first()?.name).trim();
    let what = USES.into_iter().find(|what| what.eq_ignore_ascii_case(first))?;
    let word = own.words.iter().find(|word| facts.text(word.name).trim().eq_ignore_ascii_case("HANDLE"))?;
    match word.value.kind {
        ValueKind::Q { q, negative: false } => Some((what, q, word)),
        _ => None,
    }
}

/// The parameters that something else than a query writes.
fn calculated(facts: &Facts<'_>) -> BTreeSet<QRef> {
    let targets = facts.marked().filter_map(|(_, block)| match &block.kind {
        BlockKind::FnAssign(own) => Some(own.target),
        BlockKind::Formula(own) => Some(own.target),
        _ => None,
    });
    targets.collect()
}
