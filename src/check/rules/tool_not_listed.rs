//! A tool call, or a cycle that names a tool by its number or name, of a tool that the tool table lacks.
//!
//! Only where the table is named (`--table`, `tables` in `ciklo.toml`). Tool 0, tools that parameters choose and those
//! that TOOL DEF defines are passed over; each tool is reported once. A name that is put together of texts is known where
//! the blocks before the call give it, without labels and jumps between.
use std::collections::{BTreeMap, BTreeSet, HashSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Expr, Node, Op, QKind, QRef};
use crate::check::program::{is_silent, with_meaning};
use crate::check::{Defined, Facts, Project, Rule, ToolName};
use crate::program::syntax::{Amount, BlockKind, ToolRef, ValueKind};

pub(super) const RULE: Rule = Rule { code: "tool-not-listed", severity: Severity::Warning, run };

/// The meanings of values that name a tool.
const TOOLS: [&str; 2] = ["rough-out-tool", "coarse-roughing-tool"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(project) = facts.project else { return };
    let mut passed = HashSet::new();
    composed(rule, facts, project, found);
    for block in facts.program.blocks() {
        let (tool, defined) = match &block.kind {
            BlockKind::ToolCall(call) => (call.tool, false),
            BlockKind::ToolDef(def) => (Some(def.tool), def.length.is_some() || def.radius.is_some()),
            _ => continue,
        };
        let name = match tool {
            Some(ToolRef::Number(operand)) => match operand.amount {
                Amount::Number(number) if number > 0.0 => ToolName::Number(number),
                _ => continue,
            },
            Some(ToolRef::Name(name)) => ToolName::Name(facts.text(name).trim()),
            None => continue,
        };
        if passed.insert(name.key()) && !defined && project.has_tool(name) == Some(false) {
            let shown = match name {
                ToolName::Number(number) => number.to_string(),
                ToolName::Name(name) => format!("\"{name}\""),
            };
            found.push(rule.at(facts, facts.content(block)).arg("tool", shown));
        }
    }
    for definition in facts.definitions.iter().filter(|own| names_tool(own)) {
        let related = definition.as_related_cycle();
        for item in facts.read(&related).items {
            if item.param.is_none_or(|param| !TOOLS.contains(&param.is.as_str())) {
                continue;
            }
            let name = match item.value.map(|value| value.kind) {
                Some(ValueKind::Number(number)) if number > 0.0 => ToolName::Number(number),
                Some(ValueKind::Text(name)) => ToolName::Name(facts.text(name).trim()),
                _ => continue,
            };
            if passed.insert(name.key()) && project.has_tool(name) == Some(false) {
                found.push(rule.at(facts, item.value_span).arg("tool", item.printed.as_ref()));
            }
        }
    }
}

/// The tools whose names are put together of texts.
fn composed(rule: &Rule, facts: &Facts<'_>, project: &dyn Project, found: &mut Vec<Diagnostic>) {
    let mut texts: BTreeMap<QRef, String> = BTreeMap::new();
    let mut told = BTreeSet::new();
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Formula(own) if own.target.kind == QKind::Qs => {
                match joined(&texts, &own.expr, DEEP).filter(|own| own.len() <= LONGEST && !block.skip) {
                    Some(text) => drop(texts.insert(own.target, text)),
                    None => drop(texts.remove(&own.target)),
                }
            }
            BlockKind::TextFormula(own) => drop(texts.remove(&own.target)),
            BlockKind::ToolCall(call) => {
                let Some(ToolRef::Number(operand)) = call.tool else { continue };
                let Amount::Q { q, .. } = operand.amount else { continue };
                let Some(text) = texts.get(&q) else { continue };
                let name = text.trim();
                if project.has_tool(ToolName::Name(name)) == Some(false) && told.insert(name.to_owned()) {
                    found.push(rule.at(facts, facts.content(block)).arg("tool", format!("\"{name}\"")));
                }
            }
            BlockKind::Motion(_) | BlockKind::Functions(_) | BlockKind::CycleDef(_) | BlockKind::CyclCall(_) => {}
            BlockKind::FnAssign(_) | BlockKind::Formula(_) | BlockKind::OldCycleLine(_) => {}
            BlockKind::BeginPgm(_) | BlockKind::BlkForm(_) | BlockKind::ToolDef(_) => {}
            _ if is_silent(block) => {}
            _ => texts.clear(),
        }
    }
}

/// So many texts are joined, and so long a name may become.
const DEEP: usize = 16;
const LONGEST: usize = 1 << 8;

/// The text that a formula joins of others.
fn joined(texts: &BTreeMap<QRef, String>, expr: &Expr, deep: usize) -> Option<String> {
    let deep = deep.checked_sub(1)?;
    match &expr.node {
        Node::Text(text) => Some(text.clone()),
        Node::Q(q) => texts.get(q).cloned(),
        Node::Binary(Op::Join, left, right) => Some(joined(texts, left, deep)? + &joined(texts, right, deep)?),
        _ => None,
    }
}

/// Whether a cycle names a tool.
fn names_tool(own: &Defined<'_>) -> bool {
    own.related_cycle().is_some_and(|cycle| TOOLS.iter().any(|meaning| with_meaning(cycle, meaning).is_some()))
}
