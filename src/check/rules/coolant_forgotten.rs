//! One tool that cuts without coolant, although all the others of the program have it.
//!
//! Only tools that hardly anybody lets cut dry: drills that go deep, taps, reamers, end mills. Where each of at least two other tools turns it on itself and it is off again when the tool is called. Probes
//! and tools that do not cut are not looked at, nor those of cycles that turn it on themselves, nor programs in which M
//! functions of the machine builder may turn it on.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::program::{each_function, number, with_meaning};
use crate::check::tools::{kind_of_call, named};
use crate::check::toolwords::ToolKind;
use crate::check::{CycleCall, Facts, Loaded, Pending, Rule, is_milling, is_reaming};
use crate::program::syntax::{Block, BlockKind, Compensates};
use crate::spec::{Cycle, Group};

pub(super) const RULE: Rule = Rule { code: "coolant-forgotten", severity: Severity::Warning, run };

/// The meaning of the M function with which a cycle turns it on itself.
const OWN_COOLANT: &str = "coolant-on-function";

/// The meaning of the depth of a hole, and how deep it is at least where nobody drills dry, mm.
const DEPTH: &str = "depth";
const DEEP: f64 = 15.0;

/// So many others have it.
const OTHERS: usize = 2;
/// The numbers of M functions from which on the machine builder says what they do.
const BUILDERS: std::ops::RangeInclusive<u16> = 20..=88;

/// What is done with a tool.
struct Part {
    call: usize,
    /// Whether it is on before it, and whether the tool turns it on.
    before: bool,
    on: bool,
    cuts: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let jumps = |(_, block): (usize, &Block)| matches!(block.kind, BlockKind::FnJump(_));
    if !facts.begins()
        || facts.flow.programs
        || facts.flow.skips
        || facts.flow.unread.any()
        || facts.marked().any(jumps)
    {
        return;
    }
    // Subprograms must leave it as it is.
    let blocks = facts.program.blocks();
    let end = blocks.iter().position(|block| facts.ends(block)).unwrap_or(blocks.len());
    let mut switched = false;
    for block in blocks.get(end + 1..).unwrap_or_default() {
        each_function(block, |number| switched |= matches!(number, 7..=9 | 13 | 14));
    }
    if switched {
        return;
    }
    let (mut parts, mut on, mut others): (Vec<Part>, bool, bool) = (Vec::new(), false, false);
    // What works through a pattern is not looked at: holes are often centred dry.
    let calls = facts.run.calls.iter().filter(|call| facts.definition_at(call.block).is_none());
    let cuts: Vec<usize> = calls.filter(|call| removes(facts, call.modal.pending)).map(|call| call.block).collect();
    let cooling: BTreeSet<usize> = facts.run.calls.iter().filter_map(|call| cools(facts, call)).collect();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let BlockKind::ToolCall(call) = &block.kind
            && call.tool.is_some()
        {
            let cools = cooling.contains(&index);
            parts.push(Part { call: index, before: on, on: on || cools, cuts: false });
        }
        each_function(block, |number| {
            match number {
                7 | 8 | 13 | 14 => on = true,
                9 => on = false,
                own => others |= BUILDERS.contains(&own) && own != 30,
            };
        });
        let Some(part) = parts.last_mut() else { continue };
        part.on |= on;
        part.cuts |= cuts.binary_search(&index).is_ok() || mills(block) || calls_a_part(block);
        if facts.ends(block) {
            break;
        }
    }
    parts.retain(|own| own.cuts);
    let without: Vec<&Part> = parts.iter().filter(|own| !own.on).collect();
    let ([only], false) = (without.as_slice(), others) else { return };
    let named = parts.iter().filter(|own| own.on && !own.before).count();
    if named < OTHERS || named + 1 != parts.len() {
        return;
    }
    if let Some(block) = facts.program.blocks().get(only.call).filter(|_| needs_it(facts, only.call)) {
        found.push(rule.at(facts, facts.content(block)));
    }
}

/// Whether a tool cuts dry by mistake: one that drills deep, taps or reams, or an end mill. Shops centre, chamfer, face
/// and bore dry.
fn needs_it(facts: &Facts<'_>, call: usize) -> bool {
    match kind(facts, call) {
        Some(ToolKind::Drill) => deepest(facts, call).is_some_and(|depth| depth >= DEEP * facts.millimetre()),
        Some(ToolKind::Tap | ToolKind::ThreadMill | ToolKind::Reamer | ToolKind::EndMill | ToolKind::Ball) => true,
        Some(_) => false,
        None => works(facts, call).any(|own| {
            let taps = own.cycle.file.group == Group::Threads && !is_milling(own.cycle);
            let drills = own.cycle.file.group == Group::Drilling
                && own.depth.is_some_and(|own| own >= DEEP * facts.millimetre());
            taps || is_reaming(own.cycle) || drills || own.cycle.file.group == Group::Pockets
        }),
    }
}

/// What kind of tool a call calls; the type and the remark in the table count, too.
fn kind(facts: &Facts<'_>, call: usize) -> Option<ToolKind> {
    let block = facts.program.blocks().get(call)?;
    let BlockKind::ToolCall(own) = &block.kind else { return None };
    let word = |column: &str| facts.project?.tool_word(named(facts, own.tool?)?, column);
    let inserts = ["NAME", "DOC"].into_iter().filter_map(word).any(|text| text.to_ascii_uppercase().contains("INSERT"));
    if inserts {
        return Some(ToolKind::FaceMill);
    }
    let by_words = kind_of_call(facts, call);
    let spot = word("TYP").and_then(ToolKind::of_type).filter(|own| by_words.is_none() || *own == ToolKind::Spot);
    spot.or(by_words).or_else(|| word("DOC").and_then(ToolKind::named))
}

/// A cycle that is called with a tool.
struct Job<'c> {
    cycle: &'c Cycle,
    depth: Option<f64>,
}

/// The cycles that are called with the tool of a call.
fn works<'f>(facts: &'f Facts<'_>, tool: usize) -> impl Iterator<Item = Job<'f>> {
    let called =
        facts.run.calls.iter().filter(move |call| matches!(call.modal.loaded, Loaded::By(own) if own as usize == tool));
    called.filter_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        let cycle = own.related_cycle()?;
        let related = own.as_related_cycle();
        let depth = facts.read(&related).item(DEPTH).and_then(number).map(f64::abs);
        Some(Job { cycle, depth })
    })
}

/// How deep a tool drills.
fn deepest(facts: &Facts<'_>, call: usize) -> Option<f64> {
    works(facts, call).filter_map(|own| own.depth).reduce(f64::max)
}

/// The tool call with whose tool a cycle works that turns the coolant on itself.
fn cools(facts: &Facts<'_>, call: &CycleCall) -> Option<usize> {
    let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { return None };
    let cycle = facts.definitions.get(index as usize)?.related_cycle()?;
    with_meaning(cycle, OWN_COOLANT).is_some().then_some(block as usize)
}

fn removes(facts: &Facts<'_>, pending: Pending) -> bool {
    match pending {
        Pending::Definition(index) => {
            facts.definitions.get(index as usize).and_then(|own| own.related_cycle()).is_some_and(removes_material)
        }
        Pending::None | Pending::Unknown => false,
    }
}

fn mills(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => motion.outline().compensates() == Compensates::Beside,
        _ => false,
    }
}

/// Whether a block calls a subprogram: where it is called, the tool works.
const fn calls_a_part(block: &Block) -> bool {
    matches!(block.kind, BlockKind::CallLbl(_))
}
