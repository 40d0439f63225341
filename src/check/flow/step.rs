//! What a block does to the state.
//!
//! Invariant: what is not known for certain to stay as it is, is forgotten.
use std::sync::Arc;

use super::effect::Effect;
use super::state::{Aspect, Known, Pending, State, Tri};
use crate::expr::{Code, Env, EvalError, Expr, QKind, QRef, Resolve, Type, Value, compile};
use crate::syntax::{
    Amount, Block, BlockKind, CallForm, Compensation, Feed, FeedKind, FnAssign, FnOp, MFunction, Motion, Operand, Path,
    Program, Statement, StatementKind, ValueKind,
};

/// What stepping needs besides the state.
pub(super) struct Steps<'a> {
    pub(super) program: &'a Program,
    /// What the definitions do, in the order of their first blocks.
    pub(super) effects: Vec<(usize, Effect)>,
}

impl Steps<'_> {
    /// The state behind the M functions at the start of a block, where its call happens.
    pub(super) fn at_call(&self, block: &Block, state: &State) -> State {
        let mut state = state.clone();
        match &block.kind {
            BlockKind::Motion(motion) => {
                self.motion(motion, &mut state);
                start(&motion.functions, &mut state);
            }
            BlockKind::Functions(list) | BlockKind::Stop(list) => start(list, &mut state),
            BlockKind::CyclCall(call) => start(&call.functions, &mut state),
            _ => {}
        }
        state
    }

    /// Carries the state over a block; what may be skipped may also not happen.
    pub(super) fn step(&self, index: usize, block: &Block, state: &mut State) {
        let skipped = block.skip.then(|| state.clone());
        self.act(index, block, state);
        if let Some(skipped) = skipped {
            *state = state.join(&skipped);
        }
    }

    fn act(&self, index: usize, block: &Block, state: &mut State) {
        match &block.kind {
            BlockKind::Motion(motion) => {
                self.motion(motion, state);
                functions(&motion.functions, state);
            }
            BlockKind::Functions(list) | BlockKind::Stop(list) => functions(list, state),
            BlockKind::ToolCall(call) => {
                if call.tool.is_some() {
                    let named = if call.axis.is_some() { Tri::Yes } else { Tri::Unknown };
                    state.modal.set(Aspect::Tool, named);
                    // Whether the change stops the spindle is the machine builder's affair.
                    if state.modal.is(Aspect::Spindle) != Tri::No {
                        state.modal.set(Aspect::Spindle, Tri::Unknown);
                    }
                } else if call.axis.is_some() {
                    state.modal.set(Aspect::Tool, Tri::Yes);
                }
                if call.speed.is_some() || call.cutting_speed.is_some() {
                    state.modal.set(Aspect::Speed, Tri::Yes);
                }
                feed(call.feed.as_ref(), state);
            }
            BlockKind::CyclCall(call) => {
                functions(&call.functions, state);
                feed(call.feed.as_ref(), state);
                called(state);
                if let CallForm::Position(_) = call.form {
                    state.modal.set(Aspect::Feed, Tri::Unknown);
                }
            }
            BlockKind::FnAssign(assign) => state.set(assign.target, assigned(assign, state)),
            BlockKind::Formula(formula) => {
                let value = self.formula(&formula.expr, state);
                state.set(formula.target, value);
            }
            BlockKind::TextFormula(formula) => state.set(formula.target, Known::Unknown),
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
                if let Ok(at) = self.effects.binary_search_by_key(&index, |(first, _)| *first)
                    && let Some((_, effect)) = self.effects.get(at)
                {
                    effect.apply(at, state);
                }
            }
            BlockKind::GlobalDef(definition) => {
                for parameter in &definition.parameters {
                    state.set(parameter.q, Known::Unknown);
                }
            }
            BlockKind::PatternDef(_) => state.modal.set(Aspect::Pattern, Tri::Yes),
            BlockKind::ContourFormula(_) => state.modal.set(Aspect::Contour, Tri::Yes),
            BlockKind::Sel(_) => {
                state.modal.set(Aspect::Pattern, Tri::Unknown);
                state.modal.set(Aspect::Contour, Tri::Unknown);
            }
            BlockKind::Statement(statement) => self.statement(statement, state),
            BlockKind::CallPgm(_) | BlockKind::Unknown(_) | BlockKind::Iso(_) => state.forget(),
            _ => {}
        }
    }

    fn motion(&self, motion: &Motion, state: &mut State) {
        match motion.compensation {
            Some(Compensation::R0) => state.modal.set(Aspect::Compensation, Tri::No),
            Some(_) => state.modal.set(Aspect::Compensation, Tri::Yes),
            None => {}
        }
        match motion.path {
            Path::Cc | Path::Fpol => state.modal.set(Aspect::Pole, Tri::Yes),
            Path::Dep(_) => state.modal.set(Aspect::Compensation, Tri::No),
            _ => {}
        }
        feed(motion.feed.as_ref(), state);
    }

    fn statement(&self, statement: &Statement, state: &mut State) {
        // Parameters that it names may be what it writes to.
        for word in &statement.words {
            if let ValueKind::Q { q, .. } = word.value.kind {
                state.set(q, Known::Unknown);
            }
        }
        let word = |at: usize| self.word(statement, at);
        match statement.kind {
            StatementKind::CallSelected => state.forget(),
            StatementKind::ContourDef | StatementKind::DeclareContour => {
                state.modal.set(Aspect::Contour, Tri::Yes);
            }
            StatementKind::Plane => {
                state.modal.set(Aspect::Tilting, if word(1) == "RESET" { Tri::No } else { Tri::Yes });
                state.modal.set(Aspect::Feed, Tri::Unknown);
            }
            StatementKind::Trans => {
                for aspect in [Aspect::DatumShift, Aspect::Mirroring, Aspect::Rotation, Aspect::Scaling] {
                    state.modal.set(aspect, Tri::Unknown);
                }
            }
            StatementKind::Function
                if word(0) == "FUNCTION" && matches!(word(1), "TCPM" | "RESET" | "DWELL" | "FEED") =>
            {
                state.modal.set(Aspect::Feed, Tri::Unknown);
            }
            StatementKind::Function => {
                let (modal, parameters) = (State::unknown().modal, state.clone());
                *state = parameters;
                state.modal = modal;
            }
            // Functions whose words are not told apart may write any parameter.
            StatementKind::Sql => state.forget_parameters(),
            _ => {}
        }
    }

    /// A word of what names a statement, in capitals if it is one that matters.
    fn word(&self, statement: &Statement, at: usize) -> &'static str {
        const WORDS: [&str; 6] = ["FUNCTION", "TCPM", "RESET", "DWELL", "FEED", "MODE"];
        let head = self.program.slice(statement.head).split_ascii_whitespace();
        let words = head.chain(statement.words.iter().map(|word| self.program.slice(word.span)));
        let found = words.into_iter().nth(at).unwrap_or_default();
        WORDS.into_iter().find(|word| word.eq_ignore_ascii_case(found)).unwrap_or_default()
    }

    fn formula(&self, expr: &Expr, state: &State) -> Known {
        let Ok(code) = compile(expr, &OnlyParameters) else { return Known::Unknown };
        number(&code, state)
    }
}

fn number(code: &Code, state: &State) -> Known {
    match code.number(&Values(state)) {
        Ok(number) if number.is_finite() => Known::Number(number),
        _ => Known::Unknown,
    }
}

fn feed(feed: Option<&Feed>, state: &mut State) {
    match feed.map(|feed| feed.kind) {
        None | Some(FeedKind::Max) => {}
        Some(_) => state.modal.set(Aspect::Feed, Tri::Yes),
    }
}

/// What a cycle leaves behind: its feed may stay.
fn called(state: &mut State) {
    state.modal.set(Aspect::Feed, Tri::Unknown);
}

/// M functions that act at the start of their block.
fn start(list: &[MFunction], state: &mut State) {
    for function in list {
        if matches!(function.number, 3 | 4 | 13 | 14) {
            state.modal.set(Aspect::Spindle, Tri::Yes);
        }
    }
}

fn functions(list: &[MFunction], state: &mut State) {
    start(list, state);
    for function in list {
        match function.number {
            0 | 2 | 5 | 6 | 30 => state.modal.set(Aspect::Spindle, Tri::No),
            89 | 99 => called(state),
            1 | 3 | 4 | 8 | 9 | 13 | 14 | 90..=199 => {}
            // What else an M function does is the machine builder's affair.
            _ => state.modal.set(Aspect::Spindle, Tri::Unknown),
        }
    }
}

/// The value of an operand.
pub(super) fn value(operand: &Operand, state: &State) -> Known {
    match operand.amount {
        Amount::Number(number) => Known::Number(number),
        Amount::Q { negative, q } => match state.get(q) {
            Known::Number(number) => Known::Number(if negative { -number } else { number }),
            _ => Known::Unknown,
        },
    }
}

fn assigned(assign: &FnAssign, state: &State) -> Known {
    if assign.target.kind == QKind::Qs {
        return Known::Unknown;
    }
    let of = |operand: &Operand| match value(operand, state) {
        Known::Number(number) => Some(number),
        _ => None,
    };
    let (Some(a), b) = (of(&assign.a), assign.b.as_ref().map(of)) else { return Known::Unknown };
    let result = match (assign.op, b) {
        (FnOp::Set, _) => a,
        (FnOp::Add, Some(Some(b))) => a + b,
        (FnOp::Sub, Some(Some(b))) => a - b,
        (FnOp::Mul, Some(Some(b))) => a * b,
        (FnOp::Div, Some(Some(b))) => a / b,
        (FnOp::Sqrt, _) => libm::sqrt(a),
        _ => return Known::Unknown,
    };
    if result.is_finite() { Known::Number(result) } else { Known::Unknown }
}

struct OnlyParameters;

impl Resolve for OnlyParameters {
    fn name(&self, _: &[String]) -> Option<(usize, Type)> {
        None
    }
}

struct Values<'s>(&'s State);

impl Env for Values<'_> {
    fn slot(&self, _: usize) -> &Value {
        // No name has a slot here, so nothing asks for one.
        const NONE: &Value = &Value::Number(f64::NAN);
        NONE
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        match self.0.get(q) {
            Known::Number(number) => Ok(number),
            _ => Err(EvalError::Undefined(q)),
        }
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        Err(EvalError::Undefined(q))
    }
}

/// Which definition a call means, for those who ask the state.
pub(super) fn pend(index: usize, state: &mut State) {
    state.modal.pending = u32::try_from(index).map_or(Pending::Unknown, Pending::Definition);
}
