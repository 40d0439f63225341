//! What is known of the tool that a call of a cycle finds in the spindle: what the program's own TOOL DEF says of it,
//! or the tool table where it is named, with the oversize of its tool call.
//!
//! Invariant: a tool that a parameter chooses, or that is defined in several ways, is not known.
use std::collections::HashMap;

use super::flow::ToolKey;
use super::toolwords::ToolKind;
use super::{Facts, Loaded, ToolName};
use crate::program::syntax::{Amount, Block, BlockKind, Operand, ToolRef};
use crate::spec::MM_PER_INCH;

/// A tool, in the unit of the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tool {
    /// Its radius.
    pub(super) radius: f64,
    /// The greatest angle at which it plunges, where the table says it.
    pub(super) angle: Option<f64>,
    /// The length of its cutting edges, where the table says it.
    pub(super) cutting_length: Option<f64>,
    /// Its thread pitch, where the table says it.
    pub(super) pitch: Option<f64>,
    /// The spindle speed of its call, unless the program changes speeds without calling a tool.
    pub(super) speed: Option<f64>,
}

/// The tools of a program.
#[derive(Debug, Default)]
pub(super) struct Tools {
    /// By the block of their call.
    calls: HashMap<u32, Option<Tool>>,
}

impl Tools {
    /// The tools that are called and known; nothing where none is.
    pub(super) fn of(facts: &Facts<'_>) -> Option<Self> {
        let radii = defined(facts);
        let listed = facts.project.filter(|project| project.knows_tools());
        if radii.is_empty() && listed.is_none() {
            return None;
        }
        let mut tools = Self::default();
        let changes = |block: &Block| matches!(&block.kind, BlockKind::ToolCall(call) if call.tool.is_none());
        let changed = facts.marked().any(|(_, block)| changes(block));
        for (index, block) in facts.marked() {
            let BlockKind::ToolCall(call) = &block.kind else { continue };
            let Some(name) = call.tool.and_then(|tool| named(facts, tool)) else { continue };
            let value = |column: &str| {
                let unit = if facts.inch && column != "ANGLE" { MM_PER_INCH } else { 1.0 };
                listed?.tool_value(name, column).map(|value| value / unit)
            };
            let radius = match radii.get(&name.key()) {
                Some(radius) => *radius,
                None => value("R").map(|radius| radius + value("DR").unwrap_or(0.0)),
            };
            let tool = radius.zip(oversize(call.dr.as_ref()));
            let tool = tool.map(|(radius, oversize)| Tool {
                radius: radius + oversize,
                angle: value("ANGLE"),
                cutting_length: value("LCUTS"),
                pitch: pitch_of_tool(facts, name),
                speed: call.speed.and_then(|speed| facts.number(&speed)).filter(|_| !changed),
            });
            if let Ok(index) = u32::try_from(index) {
                tools.calls.insert(index, tool.filter(|tool| tool.radius > 0.0));
            }
        }
        Some(tools)
    }

    /// The tool that is in the spindle.
    pub(super) fn get(&self, loaded: Loaded) -> Option<Tool> {
        match loaded {
            Loaded::By(block) => *self.calls.get(&block)?,
            Loaded::None | Loaded::Unknown => None,
        }
    }
}

/// What a tool is that a block calls: its name in the table or the program, or the comment beside it says so.
pub(super) fn kind_of_call(facts: &Facts<'_>, block: usize) -> Option<ToolKind> {
    let block = facts.program.blocks().get(block)?;
    let BlockKind::ToolCall(call) = &block.kind else { return None };
    let name = named(facts, call.tool?)?;
    let listed = facts.project.and_then(|project| project.tool_word(name, "NAME")).and_then(ToolKind::named);
    let own = match name {
        ToolName::Name(name) => ToolKind::named(name),
        ToolName::Number(_) => None,
    };
    listed.or(own).or_else(|| ToolKind::named(facts.text(block.comment()?)))
}

/// The pitch in the table, in the unit of the program. The column is not converted: what is finer than any thread in
/// millimetres is in inches.
fn pitch(facts: &Facts<'_>, listed: f64) -> Option<f64> {
    const FINEST: f64 = 0.2;
    let inches = listed < FINEST;
    let unit = match (inches, facts.inch) {
        (true, false) => 1.0 / MM_PER_INCH,
        (false, true) => MM_PER_INCH,
        _ => 1.0,
    };
    Some(listed / unit).filter(|_| listed > 0.0)
}

/// The coarse pitches of metric threads by their diameters, mm (ISO 261).
pub const COARSE: [(f64, f64); 15] = [
    (3.0, 0.5),
    (4.0, 0.7),
    (5.0, 0.8),
    (6.0, 1.0),
    (8.0, 1.25),
    (10.0, 1.5),
    (12.0, 1.75),
    (14.0, 2.0),
    (16.0, 2.0),
    (18.0, 2.5),
    (20.0, 2.5),
    (22.0, 2.5),
    (24.0, 3.0),
    (27.0, 3.0),
    (30.0, 3.5),
];

/// The pitch that a name or a remark gives a tap or thread mill, mm: `M8x1.25`, `TAP_M8`, `THREADMILL_P1.5`.
fn pitch_of(words: &str) -> Option<f64> {
    let words = words.to_ascii_uppercase();
    let taps = words.contains("TAP");
    let mut parts = words.split(|sign: char| !(sign.is_ascii_alphanumeric() || sign == '.'));
    parts.find_map(|part| {
        if let Some(rest) = part.strip_prefix('M') {
            return match rest.split_once('X') {
                Some((diameter, pitch)) => diameter.parse::<f64>().ok().and(pitch.parse().ok()),
                None if taps => {
                    let diameter: f64 = rest.parse().ok()?;
                    COARSE.iter().find(|(own, _)| *own == diameter).map(|(_, pitch)| *pitch)
                }
                None => None,
            };
        }
        part.strip_prefix('P').filter(|_| words.contains("THREAD"))?.parse().ok()
    })
}

/// The radii of tools that the program defines; nothing of those that it defines in several ways.
fn defined<'a>(facts: &Facts<'a>) -> HashMap<ToolKey<'a>, Option<f64>> {
    let mut radii = HashMap::new();
    for (_, block) in facts.marked() {
        let BlockKind::ToolDef(own) = &block.kind else { continue };
        let (Some(name), Some(radius)) = (named(facts, own.tool), own.radius) else { continue };
        let radius = match radius.amount {
            Amount::Number(number) => Some(number),
            Amount::Q { .. } | Amount::Text(_) => None,
        };
        let before = radii.entry(name.key()).or_insert(radius);
        *before = before.filter(|before| radius == Some(*before));
    }
    radii
}

/// The pitch of the tool that is in the spindle, by the column PITCH of the table, its name or its remark: in the unit of the program.
pub(super) fn pitch_of_loaded(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    let Loaded::By(block) = loaded else { return None };
    let BlockKind::ToolCall(call) = &facts.program.blocks().get(block as usize)?.kind else { return None };
    pitch_of_tool(facts, named(facts, call.tool?)?)
}

/// The pitch of a tool by the column PITCH of the table, its name or its remark.
fn pitch_of_tool(facts: &Facts<'_>, name: ToolName<'_>) -> Option<f64> {
    let listed = facts.project.filter(|project| project.knows_tools())?;
    let own = listed.tool_value(name, "PITCH").and_then(|own| pitch(facts, own));
    let by_words = || ["NAME", "DOC"].into_iter().find_map(|column| listed.tool_word(name, column).and_then(pitch_of));
    own.or_else(|| by_words().map(|pitch| if facts.inch { pitch / MM_PER_INCH } else { pitch }))
}

/// A tool as a table knows it; nothing if a parameter chooses it.
pub(super) fn named<'a>(facts: &Facts<'a>, tool: ToolRef) -> Option<ToolName<'a>> {
    match tool {
        ToolRef::Number(operand) => match operand.amount {
            Amount::Number(number) => Some(ToolName::Number(number)),
            Amount::Q { .. } | Amount::Text(_) => None,
        },
        ToolRef::Name(name) => Some(ToolName::Name(facts.text(name).trim())),
    }
}

fn oversize(written: Option<&Operand>) -> Option<f64> {
    match written.map_or(Amount::Number(0.0), |own| own.amount) {
        Amount::Number(number) => Some(number),
        Amount::Q { .. } | Amount::Text(_) => None,
    }
}
