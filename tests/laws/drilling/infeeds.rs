//! Infeeds that decrease: every cycle that has them arrives at its depth or says that it never will, and never hangs.
use ciklo::engine::run::{EventKind, Status};
use ciklo::spec::{Cycle, Keyword};
use proptest::prelude::*;

use super::setup::{config, of_cycle, run};
use crate::built::{Built, built};

/// The parameter by which infeeds decrease; the infeed, the least one, the depth.
const LESS: &str = "Q212";
const INFEED: &str = "Q202";
const LEAST: &str = "Q205";
const DEPTH: &str = "Q201";

/// The cycles that have it, each with the parameters of its printed example.
fn cycles() -> Vec<(u32, Vec<(String, String)>)> {
    let Built { catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let has = |cycle: &&Cycle| {
        cycle.file.parameters.iter().any(|parameter| parameter.q.is_some_and(|q| q.to_string() == LESS))
    };
    let values = |cycle: &Cycle| {
        let value = |q: String, example: Option<&str>| (q, example.unwrap_or("0").to_owned());
        let of = |own: &ciklo::spec::Parameter| own.q.map(|q| value(q.to_string(), own.example.as_deref()));
        cycle.file.parameters.iter().filter_map(of).collect()
    };
    let cycles = on.cycles.values().filter(has).filter(|cycle| cycle.key.keyword == Keyword::CyclDef);
    cycles.map(|cycle| (cycle.key.number, values(cycle))).collect()
}

/// The status, the code of the fault, and the heights of the deepest point of each way down.
fn drilled(cycle: u32, values: &[(String, String)], given: &[(&str, f64)]) -> (Status, Option<String>, f64) {
    let mut text = format!("TOOL CALL 1 Z S1000 F200\nL Z+150 R0 FMAX M3\nCYCL DEF {cycle}\n");
    for (q, value) in values {
        let own = given.iter().find(|(name, _)| name == q).map(|(_, value)| value.to_string());
        text += &format!("{q}={}\n", own.unwrap_or_else(|| value.clone()));
    }
    text += "CYCL CALL\n";
    let (outcome, events) = run(&text, "scene: 1\ntools: [{T: 1, L: 100, R: 3}]\n");
    let height = |event: &ciklo::engine::run::Event| match &event.kind {
        EventKind::Move { to, .. } if of_cycle(event, cycle) => Some(to.z),
        _ => None,
    };
    let deepest = events.iter().filter_map(height).fold(f64::INFINITY, f64::min);
    (outcome.status, outcome.fault.map(|fault| fault.code.to_string()), deepest)
}

#[test]
fn infeeds_that_never_arrive_are_an_error() {
    let cycles = cycles();
    assert!(cycles.len() >= 2, "{cycles:?}");
    for (cycle, values) in &cycles {
        let given =
            |depth: f64| [(INFEED, 5.0), (LESS, 1.0), (LEAST, 0.0), (DEPTH, -depth), ("Q203", 0.0), ("Q379", 0.0)];
        // 5 + 4 + 3 + 2 + 1 is 15 and no more.
        let (status, code, deepest) = drilled(*cycle, values, &given(20.0));
        assert_eq!((status, code.as_deref()), (Status::Error, Some("infeeds-never-reach-depth")), "{cycle}");
        assert!(deepest > 0.0, "{cycle}: nothing is drilled before the error, but {deepest}");
        let (status, code, deepest) = drilled(*cycle, values, &given(15.0));
        assert_eq!((status, code), (Status::Done, None), "{cycle}");
        assert!((deepest + 15.0).abs() < 1e-9, "{cycle}: {deepest}");
    }
}

laws! {
    #![proptest_config(config())]

    /// Sums of infeeds, calculated here.
    #[test]
    fn infeeds_arrive_if_their_sum_does(
        which in 0..16_usize, depth in 0.5..80.0_f64, infeed in 0.5..20.0_f64, less in prop_oneof![Just(0.0), 0.01..4.0],
        least in prop_oneof![Just(0.0), 0.1..6.0],
    ) {
        let cycles = cycles();
        let (cycle, values) = &cycles[which % cycles.len()];
        let (mut sum, mut next) = (0.0, infeed);
        let arrives = loop {
            if sum >= depth - 1e-9 {
                break true;
            }
            if next <= 0.0 {
                break false;
            }
            sum += next;
            // A least infeed only holds where infeeds decrease, and makes none larger than the one before.
            next = if less > 0.0 { (next - less).max(f64::min(least, next)) } else { next };
        };
        let given = [(INFEED, infeed), (LESS, less), (LEAST, least), (DEPTH, -depth), ("Q203", 0.0), ("Q379", 0.0)];
        let (status, code, deepest) = drilled(*cycle, values, &given);
        if arrives {
            prop_assert_eq!((status, code), (Status::Done, None), "{}", cycle);
            prop_assert!((deepest + depth).abs() < 1e-9, "{}", deepest);
        } else {
            prop_assert_eq!((status, code.as_deref()), (Status::Error, Some("infeeds-never-reach-depth")), "{}", cycle);
        }
    }
}
