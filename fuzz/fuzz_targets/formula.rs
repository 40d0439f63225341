//! Any text is a formula or an error at a place inside of it; a formula has a value or an error.
#![no_main]
use std::sync::Arc;

use ciklo::base::expr::{Dialect, Env, EvalError, QRef, Resolve, Type, Value, compile, parse, parse_formula};
use libfuzzer_sys::fuzz_target;

/// Parameters have their number as value.
struct Numbers;

impl Resolve for Numbers {
    fn name(&self, _: &[String]) -> Option<(usize, Type)> {
        None
    }
}

impl Env for Numbers {
    fn slot(&self, _: usize) -> &Value {
        const NONE: &Value = &Value::Number(f64::NAN);
        NONE
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        if q.number == 0 { Err(EvalError::Undefined(q)) } else { Ok(f64::from(q.number) - 500.0) }
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        Ok(q.to_string().into())
    }
}

fuzz_target!(|text: &str| {
    for read in [parse_formula(text), parse(text, Dialect::Spec)] {
        match read {
            Ok(expr) => {
                if let Ok(code) = compile(&expr, &Numbers) {
                    let _ = code.eval(&Numbers);
                }
            }
            Err(error) => assert!(error.span.start <= error.span.end && error.span.end <= text.len()),
        }
    }
});
