//! A row of the preset table, or of a selected datum table, that probing cycles write and the program does not use as it was meant: written again at
//! another place before anything has activated it, or never activated although the program goes on to machine. Also a preset that is
//! activated again for another clamping, and a row that is written to the datum table and activated as a preset.
//!
//! Only in programs that neither jump nor call others, and of rows that are certain. TNC 640, 001: 11216-11232: a preset
//! that is written to a row other than 0 is activated by the cycle for presets.
use crate::base::diag::{Arg, Diagnostic, Place, Severity, Span};
use crate::check::cycle::removes_material;
use crate::check::program::words::has_function;
use crate::check::program::{number, with_meaning};
use crate::check::{Aspect, Defined, Definition, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Block, BlockKind, Compensates};
use crate::spec::Cycle;

pub(super) const RULE: Rule = Rule { code: "preset-row-wrong", severity: Severity::Warning, run };

/// The meanings of the row that a cycle writes, of where it writes it, and of the row that is activated.
const ROW: &str = "datum-row-number";
const TRANSFER: &str = "measured-value-transfer";
const PRESET: &str = "preset-number";
/// The meanings of the row of a datum table that is activated, and of the value that probing gives a datum.
const DATUM: &str = "datum-row";
const NEW: &str = "new-datum-main";
/// The meaning of the axis that a cycle probes.
const AXIS: &str = "measuring-axis";
/// That value of the transfer is the preset table.
const TO_PRESETS: f64 = 1.0;
/// That one is the active datum table.
const TO_DATUMS: f64 = 0.0;
/// How far apart two places are that are not the same one, mm or inch.
const APART: f64 = 1.0;

/// A row that is written.
struct Written {
    block: usize,
    row: f64,
    span: Span,
    cycle: String,
    /// Where is probed.
    places: Vec<f64>,
    /// In which axis, of cycles that probe one.
    axis: Option<f64>,
    /// What is known of the transformations that move coordinates.
    moved: Vec<Tri>,
}

/// A row that is activated.
struct Activated {
    block: usize,
    row: f64,
    span: Span,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || facts.flow.unread.any() {
        return;
    }
    clamped_again(rule, facts, found);
    // What comes before the first label and the first jump is carried out in the order of the text.
    let straight = if facts.flow.jumps { first_turn(facts) } else { usize::MAX };
    let (mut written, mut activated): (Vec<Written>, Vec<Activated>) = (Vec::new(), Vec::new());
    let names_row = |own: &&Defined<'_>| {
        let named = |cycle: &Cycle| cycle.params.iter().any(|param| matches!(param.is.as_str(), ROW | PRESET));
        own.related_cycle().is_some_and(named)
    };
    for definition in facts.definitions.iter().filter(names_row) {
        let related = definition.as_related_cycle();
        let definition = facts.read(&related);
        let block = definition.view.first;
        if block > straight {
            return;
        }
        if let Some(item) = definition.item(PRESET) {
            let Some(row) = number(item) else { return };
            activated.push(Activated { block, row, span: item.value_span });
        }
        written.extend(writes(facts, &definition));
    }
    if !facts.flow.jumps {
        datums(rule, facts, found);
        other_table(rule, facts, &activated, found);
    }
    for (at, own) in written.iter().enumerate() {
        let active = |before: usize, row: f64| activated.iter().any(|other| other.row == row && other.block > before);
        let again = written.iter().take(at).rev().find(|before| {
            let between =
                activated.iter().any(|other| other.row == own.row && (before.block..own.block).contains(&other.block));
            before.cycle == own.cycle && before.row == own.row && !between && elsewhere(before, own)
        });
        if let Some(before) = again {
            let finding = rule.at(facts, own.span).arg("what", "again").arg("row", Arg::Number(own.row));
            let finding = finding.arg("other", 0);
            found.push(finding.related("preset-written-here", Place::new(facts.program.source(), before.span)));
        }
        let last = !written.iter().skip(at + 1).any(|later| later.row == own.row);
        // What is activated in its place was not written here.
        let after = activated.iter().find(|other| other.block > own.block);
        // What was active before may be active again at the end.
        let new = |other: &Activated| {
            let known = activated.iter().any(|before| before.row == other.row && before.block < own.block);
            !known && activated.iter().any(|before| before.row == own.row && before.block < own.block)
        };
        if !last || active(own.block, own.row) || !(machines(facts, own.block) || after.is_some_and(new)) {
            continue;
        }
        match after.filter(|other| !written.iter().any(|written| written.row == other.row)) {
            Some(other) => {
                let finding = rule.at(facts, other.span).arg("what", "other").arg("row", Arg::Number(own.row));
                let finding = finding.arg("other", Arg::Number(other.row));
                found.push(finding.related("preset-written-here", Place::new(facts.program.source(), own.span)));
            }
            None if after.is_none() || !activated.iter().any(|other| other.row == own.row) => {
                let finding = rule.at(facts, own.span).arg("what", "unused").arg("row", Arg::Number(own.row));
                found.push(finding.arg("other", 0));
            }
            None => {}
        }
    }
}

/// A preset that is activated a second time after the program has stopped for the operator, though no other one was active in
/// between and nothing has written it: the next clamping has the preset of the one before.
fn clamped_again(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let has = |own: &Defined<'_>, meaning: &str| {
        own.related_cycle().is_some_and(|cycle| with_meaning(cycle, meaning).is_some())
    };
    let mut activated = Vec::new();
    for own in facts.definitions.iter().filter(|own| has(own, PRESET)) {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((row, span)) = read.item(PRESET).and_then(|item| Some((number(item)?, item.value_span))) else {
            return;
        };
        activated.push((own.view.first, row, span));
    }
    let [(first, row, _), (second, again, span)] = activated.as_slice() else { return };
    if row != again || facts.definitions.iter().any(|own| own.view.first > *first && has(own, ROW)) {
        return;
    }
    let (mut stops, mut called) = (false, false);
    for (_, block) in facts.marked().filter(|(index, _)| (*first..*second).contains(index)) {
        match &block.kind {
            BlockKind::Lbl(_) | BlockKind::FnJump(_) => return,
            BlockKind::Stop(_) => stops = true,
            BlockKind::ToolCall(_) => {
                called = true;
                stops = false;
            }
            _ => stops |= has_function(block, &[0]),
        }
    }
    if stops && called && machines(facts, *second) {
        found.push(rule.at(facts, *span).arg("what", "same").arg("row", Arg::Number(*row)).arg("other", 0));
    }
}

/// The first label or jump of a program.
fn first_turn(facts: &Facts<'_>) -> usize {
    let turns = |block: &Block| matches!(block.kind, BlockKind::FnJump(_) | BlockKind::Lbl(_) | BlockKind::CallLbl(_));
    facts.marked().find(|(_, block)| turns(block)).map_or(usize::MAX, |(index, _)| index)
}

/// The rows of a selected datum table that are probed and never activated, of controls whose cycles have no choice
/// between the tables, where a tool machines after that.
fn datums(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let selects = |block: &Block| matches!(&block.kind, BlockKind::Sel(own) if facts.text(own.what).eq_ignore_ascii_case("TABLE"));
    if !facts.marked().any(|(_, block)| selects(block)) {
        return;
    }
    let (mut written, mut activated) = (Vec::new(), Vec::new());
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle() else { return };
        let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
        if has(DATUM) {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let Some(item) = read.item(DATUM) else { continue };
            let Some(row) = number(item) else { return };
            activated.push((own.view.first, row));
        } else if has(ROW) && !has(TRANSFER) && has(NEW) {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let Some((row, span)) = read.item(ROW).and_then(|item| Some((number(item)?, item.value_span))) else {
                continue;
            };
            written.push((own.view.first, row, span));
        }
    }
    for (block, row, span) in written.into_iter().filter(|(_, row, _)| *row > 0.0) {
        let active = activated.iter().any(|(at, own)| *own == row && *at > block);
        // Patterns call what this control does not describe.
        let mills = facts
            .definitions
            .iter()
            .any(|own| own.view.first > block && own.related_cycle().is_some_and(removes_material));
        if !active && (mills || machines(facts, block)) {
            found.push(rule.at(facts, span).arg("what", "datum").arg("row", Arg::Number(row)).arg("other", 0));
        }
    }
}

/// A row that is written to the datum table, and activated as a row of the preset table though nothing has written that
/// one: one of the two tables is wrong.
fn other_table(rule: &Rule, facts: &Facts<'_>, activated: &[Activated], found: &mut Vec<Diagnostic>) {
    let has = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, ROW).is_some());
    let mut written: Vec<(usize, f64, f64, Span)> = Vec::new();
    for own in facts.definitions.iter().filter(has) {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let (Some(row), Some(transfer)) = (read.item(ROW), read.item(TRANSFER)) else { continue };
        let (Some(row), Some(to)) = (number(row), number(transfer)) else { return };
        written.push((own.view.first, row, to, transfer.value_span));
    }
    // A row of the datum table that the program names.
    let datum = |row: f64| {
        facts.definitions.iter().any(|own| {
            let related = own.as_related_cycle();
            own.related_cycle().is_some_and(|cycle| with_meaning(cycle, DATUM).is_some())
                && facts.read(&related).item(DATUM).is_some_and(|item| number(item).is_none_or(|own| own == row))
        })
    };
    for (block, row, _, span) in written.iter().filter(|(_, row, to, _)| *to == TO_DATUMS && *row > 0.0) {
        let to_presets = written.iter().any(|(_, own, to, _)| own == row && *to == TO_PRESETS);
        let known = activated.iter().any(|own| own.row == *row && own.block < *block);
        let after = activated.iter().any(|own| own.row == *row && own.block > *block);
        if after && !known && !to_presets && !datum(*row) {
            let finding = rule.at(facts, *span).arg("what", "table").arg("row", Arg::Number(*row));
            found.push(finding.arg("other", 0));
        }
    }
}

/// The row of the preset table that a definition writes.
fn writes(facts: &Facts<'_>, definition: &Definition<'_>) -> Option<Written> {
    let row = definition.item(ROW)?;
    let to_presets = definition.item(TRANSFER).and_then(number) == Some(TO_PRESETS);
    let (block, span) = (definition.view.first, row.value_span);
    let row = number(row).filter(|row| to_presets && *row > 0.0)?;
    let is_place = |meaning: &str| meaning.starts_with("probing-centre-") || meaning.contains("-point-m");
    let places = definition.items.iter().filter(|item| item.param.is_some_and(|own| is_place(own.is.as_str())));
    let places: Option<Vec<f64>> = places.map(number).collect();
    let axis = definition.item(AXIS).and_then(number);
    let modal = facts.run.before(block);
    let moving = [Aspect::DatumShift, Aspect::Rotation, Aspect::Mirroring, Aspect::Tilting];
    let moved = moving.iter().filter_map(|aspect| Some(modal?.is(*aspect))).collect();
    Some(Written { block, row, span, cycle: definition.key.to_string(), places: places?, axis, moved })
}

/// Whether the same is probed at another place.
fn elsewhere(one: &Written, other: &Written) -> bool {
    let apart = one.places.iter().zip(&other.places).any(|(one, other)| (one - other).abs() > APART);
    let alike = one.moved == other.moved && !one.moved.contains(&Tri::Yes);
    alike && one.axis == other.axis && one.places.len() == other.places.len() && apart
}

/// Whether a tool machines after a block.
fn machines(facts: &Facts<'_>, block: usize) -> bool {
    let calls = facts.run.calls.iter().filter(|call| call.block > block).any(|call| match call.modal.pending {
        Pending::Definition(index) => {
            let own = facts.definitions.get(index as usize).and_then(Defined::related_cycle);
            own.is_some_and(removes_material)
        }
        Pending::None | Pending::Unknown => false,
    });
    calls
        || facts.shaped().any(|(index, own)| match &own.kind {
            BlockKind::Motion(motion) => index > block && motion.outline().compensates() == Compensates::Beside,
            _ => false,
        })
}
