//! The worst case of probing cycles, as `ciklo run --envelope` shows it (`docs/envelope.md`).
use serde::Serialize;

use super::session::{self, Session};
use super::{Failure, Outcome, execution};
use crate::engine::run::{self as engine, ENVELOPE_FORMAT, Envelope, Fault, Near, Obstacle, Touching};
use crate::language::locale::{Args, Digits, Locales, Scope, Ui};
use crate::spec::OnControl;

/// Digits of a length, a nanometre; JSON has them all.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(6) };

/// The document.
#[derive(Serialize)]
struct Document<'d> {
    format: &'static str,
    control: &'d str,
    status: &'static str,
    error: Option<&'d str>,
    cycles: &'d [Envelope],
}

/// Prints what was found. A fault of the program is reported as usual.
pub(super) fn show(
    session: &mut Session,
    on: &OnControl,
    locales: &Locales,
    result: &engine::Outcome,
    format: &str,
) -> Result<Outcome, Failure> {
    let cycles = &result.envelopes;
    let text = if format == "json" {
        let error = result.fault.as_ref().map(|fault| &*fault.code);
        let status = result.status.as_str();
        session::json(&Document { format: ENVELOPE_FORMAT, control: on.id(), status, error, cycles })?
    } else {
        cycles.iter().map(|cycle| lines(cycle, on, locales, &session.ui)).collect::<Vec<_>>().join("\n")
    };
    session.output.print(&text)?;
    if cycles.is_empty() {
        let line = session.ui.text("cli-envelope-none", &Args::new());
        session.output.remark(&line);
    }
    if let Some(diagnostic) = &result.diagnostic {
        session.output.complain(diagnostic, &session.ui);
    }
    let failed = result.fault.is_some() || cycles.iter().any(|cycle| fault_in_scene(cycle).is_some());
    Ok(if failed { Outcome::Errors } else { Outcome::Clean })
}

/// The error with which the cycle ends where the parts of the scene stop the probe.
fn fault_in_scene(cycle: &Envelope) -> Option<&Fault> {
    cycle.ends.iter().find(|end| end.touching == Touching::AsScene)?.fault.as_ref()
}

fn lines(cycle: &Envelope, on: &OnControl, locales: &Locales, ui: &Ui) -> String {
    let length = |value: f64| ui.numbers().nc(value, SHOWN).unwrap_or_default();
    let mut reported = Vec::new();
    let mut report =
        |key: &str, args: Args<'_>| reported.push(format!("  {}", ui.text(&format!("cli-envelope-{key}"), &args)));
    let axis = cycle.axis.to_string();
    if let (Some(lowest), Some(highest)) = (cycle.lowest, cycle.highest) {
        report("lowest", Args::new().text("axis", axis.as_str()).text("height", length(lowest)));
        report("highest", Args::new().text("axis", axis.as_str()).text("height", length(highest)));
    } else {
        report("still", Args::new());
    }
    if !cycle.travelled.is_empty() {
        let heights: Vec<String> = cycle.travelled.iter().map(|height| length(*height)).collect();
        report("travelled", Args::new().text("axis", axis.as_str()).text("heights", heights.join("; ")));
    }
    if let Some(path) = cycle.longest_probing {
        report("probing", Args::new().number("count", cycle.probings as f64).text("length", length(path)));
    }
    for near in &cycle.near {
        let (key, args) = nearness(near, &length);
        report(key, args);
    }
    if let Some(fault) = fault_in_scene(cycle) {
        let diagnostic = fault.diagnostic(None);
        let diagnostic = match execution::sentence(on, locales, ui, fault, cycle.key) {
            Some(sentence) => diagnostic.arg("message", sentence),
            None => diagnostic,
        };
        report("fails", Args::new().text("code", &*fault.code).text("message", ui.diagnostic(&diagnostic)));
    }
    format!("{}\n{}\n", head(cycle, on, locales, ui), reported.join("\n"))
}

/// `12  TCH PROBE 416 DATUM CIRCLE CENTER`, with the line of the program.
fn head(cycle: &Envelope, on: &OnControl, locales: &Locales, ui: &Ui) -> String {
    let described = cycle.key.and_then(|key| on.cycles.get(&key));
    let name = described.and_then(|described| {
        let scope = Scope { cycle: Some(described.name()), control: Some(on.id()) };
        let id = format!("cycle-{}", described.name());
        Some(locales.language(ui.tag()).ok()?.text(&id, &scope, &Args::new()).ok()?.into_owned())
    });
    let args =
        Args::new().number("line", cycle.line as f64).text("cycle", format!("{} {}", cycle.keyword, cycle.number));
    ui.text("cli-envelope-cycle", &args.text("name", name.unwrap_or_default()))
}

fn nearness(near: &Near, length: &dyn Fn(f64) -> String) -> (&'static str, Args<'static>) {
    let (what, number) = match near.to {
        Obstacle::Stock => ("stock", 0),
        Obstacle::Part(number) => ("part", number),
    };
    let args = Args::new().text("what", what).number("number", number as f64);
    let args = args.text("probed", if near.probed { "yes" } else { "no" });
    match (near.distance, near.tip) {
        (Some(distance), Some([x, y, z])) => {
            let args = args.text("x", length(x)).text("y", length(y)).text("z", length(z));
            if distance > 0.0 { ("near", args.text("distance", length(distance))) } else { ("touches", args) }
        }
        _ => ("near-unknown", args),
    }
}
