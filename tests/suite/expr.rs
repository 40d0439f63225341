//! Expressions: a table of texts and values, and laws.
use std::sync::Arc;

use ciklo::base::expr::{
    Code, Dialect, Env, EvalError, QKind, QRef, Resolve, Type, TypeError, Value, compile, cosd, parse, sind,
};
use glam::DVec3;
use proptest::prelude::*;

struct World {
    slots: Vec<Value>,
}

impl World {
    fn new() -> Self {
        Self { slots: vec![Value::Number(-12.0), Value::Point(DVec3::new(3.0, 4.0, 12.0))] }
    }
}

impl Resolve for World {
    fn name(&self, path: &[String]) -> Option<(usize, Type)> {
        match path.join(".").as_str() {
            "cut.to" => Some((0, Type::Number)),
            "p" => Some((1, Type::Point)),
            _ => None,
        }
    }
}

impl Env for World {
    fn slot(&self, slot: usize) -> &Value {
        &self.slots[slot]
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        match (q.kind, q.number) {
            (QKind::Q, 1) => Ok(5.0),
            (QKind::Q, 2) => Ok(-3.0),
            (QKind::Q, 3) => Ok(0.5),
            _ => Err(EvalError::Undefined(q)),
        }
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        if q == (QRef { kind: QKind::Qs, number: 1 }) { Ok("abc".into()) } else { Err(EvalError::Undefined(q)) }
    }
}

fn show(text: &str, dialect: Dialect) -> String {
    let expr = match parse(text, dialect) {
        Ok(expr) => expr,
        Err(error) => return error.expected.to_owned(),
    };
    let code: Code = match compile(&expr, &World::new()) {
        Ok(code) => code,
        Err(TypeError::Unknown { .. }) => return "unknown".to_owned(),
        Err(TypeError::Mismatch { .. }) => return "mismatch".to_owned(),
    };
    match code.eval(&World::new()) {
        Ok(Value::Number(n)) => n.to_string(),
        Ok(Value::Bool(b)) => b.to_string(),
        Ok(Value::Text(t)) => format!("{t:?}"),
        Ok(Value::Point(p)) => format!("({}, {}, {})", p.x, p.y, p.z),
        Err(EvalError::DivisionByZero) => "division-by-zero".to_owned(),
        Err(EvalError::Domain(..)) => "domain".to_owned(),
        Err(EvalError::Overflow) => "overflow".to_owned(),
        Err(EvalError::Undefined(_)) => "undefined".to_owned(),
        Err(EvalError::Kind) => "kind".to_owned(),
        Err(EvalError::TextTooLong) => "too-long".to_owned(),
    }
}

/// Equal as text, or as numbers but for the last bits that a degree conversion costs.
fn agrees(said: &str, expected: &str) -> bool {
    match (said.parse::<f64>(), expected.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 4.0 * f64::EPSILON * b.abs().max(1.0),
        _ => said == expected,
    }
}

#[test]
fn the_table_of_expressions_holds() {
    let mut failures = Vec::new();
    let table = include_str!("../expr/cases.txt");
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        let (dialect, rest) = line.split_once('|').expect("a dialect");
        let (text, expected) = rest.rsplit_once('|').expect("an expectation");
        let expected = expected.split('#').next().unwrap_or_default().trim();
        let dialect = if dialect.trim() == "spec" { Dialect::Spec } else { Dialect::Program };
        let said = show(text.trim(), dialect);
        if !agrees(&said, expected) {
            failures.push(format!("{line}: {said}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Its tree would be as deep as the chain is long.
#[test]
fn a_long_chain_is_refused_and_not_followed() {
    let chain = format!("1{}", "+1".repeat(1_000_000));
    for dialect in [Dialect::Spec, Dialect::Program] {
        assert_eq!(parse(&chain, dialect).expect_err("it is too long").expected, "less-nesting");
    }
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    #[test]
    fn no_text_makes_the_parser_panic(text in "\\PC{0,80}") {
        let _ = parse(&text, Dialect::Program);
        let _ = parse(&text, Dialect::Spec);
    }

    #[test]
    fn deep_nesting_is_refused_and_not_followed(depth in 100_usize..5_000, open in prop::sample::select(vec!["(", "-", "SIN ", "+"])) {
        let text = format!("{}1", open.repeat(depth));
        prop_assert!(parse(&text, Dialect::Program).is_err());
    }

    #[test]
    fn sine_and_cosine_lie_on_the_circle(angle in -1e6_f64..1e6) {
        let (s, c) = (sind(angle), cosd(angle));
        prop_assert!((s * s + c * c - 1.0).abs() < 1e-14);
        prop_assert!((sind(-angle) + s).abs() < 1e-15);
    }

    #[test]
    fn a_printed_number_reads_as_itself(number in -99_999.999_9_f64..99_999.999_9) {
        let text = format!("{number:.4}");
        prop_assert_eq!(show(&text, Dialect::Program).parse::<f64>().ok(), text.parse::<f64>().ok());
    }
}
