//! Expressions compiled to code over slots: names and types are settled once, evaluation neither
//! hashes nor allocates.
use glam::DVec3;

use super::func::{Func, of_one};
use super::parser::{Expr, Node};
use super::value::{Value, atan2d, cosd, sind};
use super::{QKind, QRef};
use crate::base::diag::Span;

/// Operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is the operator of its name")]
pub enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Pow,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    And,
    Or,
    Not,
    Join,
}

impl Op {
    /// Whether programs may not use it.
    pub const fn spec_only(self) -> bool {
        matches!(
            self,
            Self::Eq | Self::Ne | Self::Lt | Self::Le | Self::Gt | Self::Ge | Self::And | Self::Or | Self::Not
        )
    }

    const fn orders(self) -> bool {
        matches!(self, Self::Lt | Self::Le | Self::Gt | Self::Ge)
    }

    const fn calculates(self) -> bool {
        matches!(self, Self::Add | Self::Sub | Self::Mul | Self::Div | Self::Rem | Self::Pow)
    }

    const fn compares(self) -> bool {
        matches!(self, Self::Eq | Self::Ne | Self::Lt | Self::Le | Self::Gt | Self::Ge)
    }
}

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the value of its name")]
pub enum Type {
    Number,
    Bool,
    Point,
    Text,
}

/// What names stand for, asked while compiling.
pub trait Resolve {
    /// The slot and type of a name without its point field, or nothing if unknown.
    fn name(&self, path: &[String]) -> Option<(usize, Type)>;
    /// Whether the Q parameter may be read here.
    fn q(&self, q: QRef) -> bool {
        let _ = q;
        true
    }
}

/// No names: a formula of Q parameters alone, as programs write them.
#[derive(Clone, Copy, Debug)]
pub struct OnlyParameters;

impl Resolve for OnlyParameters {
    fn name(&self, _: &[String]) -> Option<(usize, Type)> {
        None
    }
}

/// Where values are, asked while evaluating.
pub trait Env {
    /// The value in a slot.
    fn slot(&self, slot: usize) -> &Value;
    /// The value of a number parameter.
    fn number(&self, q: QRef) -> Result<f64, EvalError>;
    /// The value of a text parameter.
    fn text(&self, q: QRef) -> Result<std::sync::Arc<str>, EvalError>;
}

/// Why an expression does not compile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TypeError {
    /// Nothing has that name here.
    Unknown {
        /// The name.
        name: String,
        /// Where.
        span: Span,
    },
    /// The operand has another type.
    Mismatch {
        /// The type that would fit.
        expected: Type,
        /// The type that is there.
        found: Type,
        /// Where.
        span: Span,
    },
}

/// The longest text that joining gives, bytes: far beyond what a parameter holds, and little enough that a program
/// which doubles a text in a loop ends with an error instead of all memory.
pub const LONGEST_TEXT: usize = 1 << 16;

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq)]
pub enum EvalError {
    /// A division by zero.
    DivisionByZero,
    /// An argument outside the function's domain.
    Domain(Func, f64),
    /// The result is too large to be a number.
    Overflow,
    /// A text grows longer than [`LONGEST_TEXT`].
    TextTooLong,
    /// The Q parameter has no value.
    Undefined(QRef),
    /// A text where a number is needed, or the other way round.
    Kind,
}

/// A compiled expression.
#[derive(Clone, Debug)]
pub struct Code {
    ty: Type,
    ins: Ins,
}

#[derive(Clone, Debug)]
enum Ins {
    Const(Value),
    Slot(usize),
    Q(QRef),
    Field(Box<Ins>, usize),
    Not(Box<Ins>),
    Negate(Box<Ins>),
    Binary(Op, Box<(Ins, Ins)>),
    /// Whether two numbers are the same.
    Same(Box<(Ins, Ins)>),
    Choose(Box<(Ins, Ins, Ins)>),
    Call(Func, Box<[Ins]>),
}

/// Checks types and resolves names.
pub fn compile(expr: &Expr, names: &dyn Resolve) -> Result<Code, TypeError> {
    let (ins, ty) = lower(expr, names)?;
    Ok(Code { ty, ins })
}

fn expect(found: Type, expected: Type, span: Span) -> Result<(), TypeError> {
    if found == expected { Ok(()) } else { Err(TypeError::Mismatch { expected, found, span }) }
}

fn lower(expr: &Expr, names: &dyn Resolve) -> Result<(Ins, Type), TypeError> {
    Ok(match &expr.node {
        Node::Number(n) => (Ins::Const(Value::Number(*n)), Type::Number),
        Node::Text(text) => (Ins::Const(Value::Text(text.as_str().into())), Type::Text),
        Node::Q(q) if names.q(*q) => (Ins::Q(*q), if q.kind == QKind::Qs { Type::Text } else { Type::Number }),
        Node::Q(q) => return Err(TypeError::Unknown { name: q.to_string(), span: expr.span }),
        Node::Name(path) => return lower_name(path, expr.span, names),
        Node::Unary(op, inner) => {
            let (ins, ty) = lower(inner, names)?;
            if *op == Op::Not {
                expect(ty, Type::Bool, inner.span)?;
                (Ins::Not(Box::new(ins)), Type::Bool)
            } else {
                if ty != Type::Point {
                    expect(ty, Type::Number, inner.span)?;
                }
                (Ins::Negate(Box::new(ins)), ty)
            }
        }
        Node::Binary(op, left, right) => return lower_binary(*op, left, right, names),
        Node::Call(func, args) => return lower_call(*func, args, names),
    })
}

fn lower_name(path: &[String], span: Span, names: &dyn Resolve) -> Result<(Ins, Type), TypeError> {
    if let Some((slot, ty)) = names.name(path) {
        return Ok((Ins::Slot(slot), ty));
    }
    if let Some((last, head)) = path.split_last()
        && let Some(axis) = ["main", "minor", "tool"].iter().position(|axis| axis == last)
        && let Some((slot, Type::Point)) = names.name(head)
    {
        return Ok((Ins::Field(Box::new(Ins::Slot(slot)), axis), Type::Number));
    }
    Err(TypeError::Unknown { name: path.join("."), span })
}

fn lower_binary(op: Op, left: &Expr, right: &Expr, names: &dyn Resolve) -> Result<(Ins, Type), TypeError> {
    let (a, ta) = lower(left, names)?;
    let (b, tb) = lower(right, names)?;
    let ty = match op {
        Op::And | Op::Or => {
            expect(ta, Type::Bool, left.span)?;
            expect(tb, Type::Bool, right.span)?;
            Type::Bool
        }
        Op::Join => {
            expect(ta, Type::Text, left.span)?;
            expect(tb, Type::Text, right.span)?;
            Type::Text
        }
        Op::Eq | Op::Ne => {
            expect(tb, ta, right.span)?;
            Type::Bool
        }
        op if op.compares() => {
            expect(ta, Type::Number, left.span)?;
            expect(tb, Type::Number, right.span)?;
            Type::Bool
        }
        Op::Add | Op::Sub if ta == Type::Point => {
            expect(tb, Type::Point, right.span)?;
            Type::Point
        }
        Op::Mul | Op::Div if ta == Type::Point => {
            expect(tb, Type::Number, right.span)?;
            Type::Point
        }
        _ => {
            expect(ta, Type::Number, left.span)?;
            expect(tb, Type::Number, right.span)?;
            Type::Number
        }
    };
    let sides = Box::new((a, b));
    let ins = match op {
        Op::Eq if tb == Type::Number => Ins::Same(sides),
        Op::Ne if tb == Type::Number => Ins::Not(Box::new(Ins::Same(sides))),
        _ => Ins::Binary(op, sides),
    };
    Ok((ins, ty))
}

fn lower_call(func: Func, args: &[Expr], names: &dyn Resolve) -> Result<(Ins, Type), TypeError> {
    let mut lowered = Vec::with_capacity(args.len());
    let mut types = Vec::with_capacity(args.len());
    for arg in args {
        let (ins, ty) = lower(arg, names)?;
        lowered.push(ins);
        types.push(ty);
    }
    let check = |index: usize, ty: Type| expect(types[index], ty, args[index].span);
    let ty = match func {
        Func::If => {
            check(0, Type::Bool)?;
            check(2, types[1])?;
            let ty = types[1];
            let Ok([condition, then, otherwise]) = <[Ins; 3]>::try_from(lowered) else {
                return Err(TypeError::Unknown { name: func.name().to_owned(), span: args[0].span });
            };
            return Ok((Ins::Choose(Box::new((condition, then, otherwise))), ty));
        }
        Func::Polar => {
            check(0, Type::Point)?;
            check(1, Type::Number)?;
            check(2, Type::Number)?;
            Type::Point
        }
        Func::Dist | Func::Dot => {
            check(0, Type::Point)?;
            check(1, Type::Point)?;
            Type::Number
        }
        Func::Length | Func::Unit => {
            check(0, Type::Point)?;
            if func == Func::Unit { Type::Point } else { Type::Number }
        }
        _ => {
            for index in 0..args.len() {
                check(index, Type::Number)?;
            }
            if func == Func::Point { Type::Point } else { Type::Number }
        }
    };
    Ok((Ins::Call(func, lowered.into_boxed_slice()), ty))
}

impl Code {
    /// The type of the value.
    pub const fn ty(&self) -> Type {
        self.ty
    }

    /// The value.
    pub fn eval<E: Env + ?Sized>(&self, env: &E) -> Result<Value, EvalError> {
        run(&self.ins, env)
    }

    /// The slot, if it only reads one.
    pub const fn slot(&self) -> Option<usize> {
        if let Ins::Slot(slot) = self.ins { Some(slot) } else { None }
    }

    /// The value as a number.
    pub fn number<E: Env + ?Sized>(&self, env: &E) -> Result<f64, EvalError> {
        number(&self.ins, env)
    }

    /// The value as true or false.
    pub fn truth<E: Env + ?Sized>(&self, env: &E) -> Result<bool, EvalError> {
        truth(&self.ins, env)
    }

    /// The value as a point.
    pub fn point<E: Env + ?Sized>(&self, env: &E) -> Result<DVec3, EvalError> {
        match run(&self.ins, env)? {
            Value::Point(p) => Ok(p),
            _ => Err(EvalError::Kind),
        }
    }
}

/// What gives a number, without a value around each step on the way.
fn number<E: Env + ?Sized>(ins: &Ins, env: &E) -> Result<f64, EvalError> {
    let of = |value: &Value| if let Value::Number(n) = value { Ok(*n) } else { Err(EvalError::Kind) };
    match ins {
        Ins::Const(value) => of(value),
        Ins::Slot(slot) => of(env.slot(*slot)),
        Ins::Q(q) if q.kind != QKind::Qs => env.number(*q),
        Ins::Negate(inner) => Ok(-number(inner, env)?),
        Ins::Binary(op, sides) if op.calculates() => calculated(*op, number(&sides.0, env)?, number(&sides.1, env)?),
        Ins::Call(func, args) if args.len() == 1 && func.takes_number() => of_one(*func, number(&args[0], env)?),
        Ins::Choose(parts) => number(if truth(&parts.0, env)? { &parts.1 } else { &parts.2 }, env),
        _ => of(&run(ins, env)?),
    }
}

/// The same for what is true or false.
fn truth<E: Env + ?Sized>(ins: &Ins, env: &E) -> Result<bool, EvalError> {
    match ins {
        Ins::Not(inner) => Ok(!truth(inner, env)?),
        Ins::Binary(op @ (Op::And | Op::Or), sides) => {
            let left = truth(&sides.0, env)?;
            if left == (*op == Op::Or) { Ok(left) } else { truth(&sides.1, env) }
        }
        Ins::Same(sides) => Ok(number(&sides.0, env)? == number(&sides.1, env)?),
        Ins::Binary(op, sides) if op.orders() => Ok(ordered(*op, number(&sides.0, env)?, number(&sides.1, env)?)),
        _ => match run(ins, env)? {
            Value::Bool(b) => Ok(b),
            _ => Err(EvalError::Kind),
        },
    }
}

fn run<E: Env + ?Sized>(ins: &Ins, env: &E) -> Result<Value, EvalError> {
    Ok(match ins {
        Ins::Const(value) => value.clone(),
        Ins::Slot(slot) => env.slot(*slot).clone(),
        Ins::Q(q) if q.kind == QKind::Qs => Value::Text(env.text(*q)?),
        Ins::Q(q) => Value::Number(env.number(*q)?),
        Ins::Field(inner, axis) => match run(inner, env)? {
            Value::Point(p) => Value::Number(p.to_array()[*axis]),
            _ => return Err(EvalError::Kind),
        },
        Ins::Not(_) | Ins::Same(_) | Ins::Binary(Op::And | Op::Or, _) => Value::Bool(truth(ins, env)?),
        Ins::Negate(inner) => match run(inner, env)? {
            Value::Number(n) => Value::Number(-n),
            Value::Point(p) => Value::Point(-p),
            _ => return Err(EvalError::Kind),
        },
        Ins::Binary(op, sides) => binary(*op, run(&sides.0, env)?, run(&sides.1, env)?)?,
        Ins::Choose(parts) => run(if truth(&parts.0, env)? { &parts.1 } else { &parts.2 }, env)?,
        Ins::Call(func, args) => call(*func, args, env)?,
    })
}

fn binary(op: Op, left: Value, right: Value) -> Result<Value, EvalError> {
    Ok(match (left, right) {
        (Value::Number(a), Value::Number(b)) => return arithmetic(op, a, b),
        (Value::Point(a), Value::Point(b)) => match op {
            Op::Add => Value::Point(a + b),
            Op::Sub => Value::Point(a - b),
            Op::Eq => Value::Bool(a == b),
            Op::Ne => Value::Bool(a != b),
            _ => return Err(EvalError::Kind),
        },
        (Value::Point(a), Value::Number(b)) => match op {
            Op::Mul => Value::Point(a * b),
            Op::Div if b == 0.0 => return Err(EvalError::DivisionByZero),
            Op::Div => Value::Point(a / b),
            _ => return Err(EvalError::Kind),
        },
        (Value::Text(a), Value::Text(b)) => match op {
            Op::Join if a.len() + b.len() > LONGEST_TEXT => return Err(EvalError::TextTooLong),
            Op::Join => Value::Text(format!("{a}{b}").into()),
            Op::Eq => Value::Bool(a == b),
            Op::Ne => Value::Bool(a != b),
            _ => return Err(EvalError::Kind),
        },
        (Value::Bool(a), Value::Bool(b)) => match op {
            Op::Eq => Value::Bool(a == b),
            Op::Ne => Value::Bool(a != b),
            _ => return Err(EvalError::Kind),
        },
        _ => return Err(EvalError::Kind),
    })
}

fn arithmetic(op: Op, a: f64, b: f64) -> Result<Value, EvalError> {
    match op {
        Op::Eq => Ok(Value::Bool(a == b)),
        Op::Ne => Ok(Value::Bool(a != b)),
        op if op.orders() => Ok(Value::Bool(ordered(op, a, b))),
        op => calculated(op, a, b).map(Value::Number),
    }
}

fn ordered(op: Op, a: f64, b: f64) -> bool {
    match op {
        Op::Lt => a < b,
        Op::Le => a <= b,
        Op::Gt => a > b,
        _ => a >= b,
    }
}

fn calculated(op: Op, a: f64, b: f64) -> Result<f64, EvalError> {
    let result = match op {
        Op::Add => a + b,
        Op::Sub => a - b,
        Op::Mul => a * b,
        Op::Div | Op::Rem if b == 0.0 => return Err(EvalError::DivisionByZero),
        Op::Div => a / b,
        Op::Rem => a % b,
        Op::Pow => libm::pow(a, b),
        _ => return Err(EvalError::Kind),
    };
    if result.is_finite() { Ok(result) } else { Err(EvalError::Overflow) }
}

fn finite(result: f64) -> Result<Value, EvalError> {
    if result.is_finite() { Ok(Value::Number(result)) } else { Err(EvalError::Overflow) }
}

fn call<E: Env + ?Sized>(func: Func, args: &[Ins], env: &E) -> Result<Value, EvalError> {
    match func {
        Func::Min | Func::Max => {
            let mut best = number(&args[0], env)?;
            for arg in &args[1..] {
                let next = number(arg, env)?;
                best = if func == Func::Min { best.min(next) } else { best.max(next) };
            }
            Ok(Value::Number(best))
        }
        Func::Point => {
            let point = DVec3::new(number(&args[0], env)?, number(&args[1], env)?, number(&args[2], env)?);
            Ok(Value::Point(point))
        }
        Func::Angle => Ok(Value::Number(atan2d(number(&args[1], env)?, number(&args[0], env)?))),
        Func::Polar | Func::Dist | Func::Dot | Func::Length | Func::Unit => geometry(func, args, env),
        _ => Ok(Value::Number(of_one(func, number(&args[0], env)?)?)),
    }
}

fn geometry<E: Env + ?Sized>(func: Func, args: &[Ins], env: &E) -> Result<Value, EvalError> {
    let Value::Point(first) = run(&args[0], env)? else { return Err(EvalError::Kind) };
    if func == Func::Length {
        return Ok(Value::Number(libm::sqrt(first.dot(first))));
    }
    if func == Func::Unit {
        let length = libm::sqrt(first.dot(first));
        return if length == 0.0 { Err(EvalError::Domain(func, 0.0)) } else { Ok(Value::Point(first / length)) };
    }
    if func == Func::Polar {
        let (radius, angle) = (number(&args[1], env)?, number(&args[2], env)?);
        return Ok(Value::Point(first + DVec3::new(radius * cosd(angle), radius * sind(angle), 0.0)));
    }
    let Value::Point(second) = run(&args[1], env)? else { return Err(EvalError::Kind) };
    let value = if func == Func::Dot {
        first.dot(second)
    } else {
        let between = second - first;
        libm::sqrt(between.dot(between))
    };
    finite(value)
}
