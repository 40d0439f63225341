//! What logs say of the kinematics: the memories, and what was measured of the rotary axes.
//!
//! Invariant: values only; layout is in templates and words in locale files.
use serde_json::{Value, json};

use crate::engine::machine::{AxisReport, Machine, MemoryReport};
use crate::engine::world::state::World;

/// The values for templates.
pub(super) fn context(world: &World<'_>) -> minijinja::Value {
    let survey = world.survey.as_deref();
    let axes: Vec<Value> = survey.map_or_else(Vec::new, |survey| survey.reports.iter().map(axis).collect());
    let value = json!({
        "name": world.kinematics().name,
        "sphere": survey.map(|survey| survey.radius),
        "axes": axes,
        "memory": world.memory_report.as_deref().map(memory),
        "base": world.kinematics().base.to_array(),
    });
    minijinja::Value::from(minijinja::value::Serde(value))
}

fn axis(report: &AxisReport) -> Value {
    json!({
        "axis": report.plan.axis.letter().to_string(),
        "start": report.plan.start,
        "end": report.plan.end,
        "incidence": report.plan.incidence,
        "points": report.plan.points,
        "scatter": report.scatter,
        "optimized": report.optimized,
        "greatest": report.greatest,
        "askew": report.askew,
        "backlash": report.backlash,
        "positioning": report.positioning,
        "circle": report.circle,
        "correction": report.correction.to_array(),
        "rating": report.rating,
        "uncertainty": report.uncertainty,
    })
}

fn memory(report: &MemoryReport) -> Value {
    let memories: Vec<Value> =
        report.memories.iter().map(|(name, saved)| json!({"name": name, "saved": saved})).collect();
    json!({
        "name": report.name,
        "before": report.before.as_ref().map(machine),
        "after": report.after.as_ref().map(machine),
        "memories": memories,
    })
}

/// The rotary axes and transformations of some kinematics.
fn machine(machine: &Machine) -> Value {
    let axes: Vec<Value> = machine
        .rotary
        .iter()
        .map(|axis| {
            let letter = axis.axis.letter().to_string();
            json!({"axis": letter, "centre": axis.centre.to_array(), "askew": axis.askew.to_array()})
        })
        .collect();
    json!({"axes": axes, "pivot": machine.pivot, "base": machine.base.to_array()})
}
