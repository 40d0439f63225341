//! The guards of one cycle, made ready once to be evaluated with values.
//!
//! Names are replaced by the formulas that they stand for until only numbers and Q parameters are
//! left. Invariant: a guard that needs anything else (a parameter that is not certain, the tool, the machine)
//! says nothing; of the state of the control it hears what is certain.
use super::aspect::Aspect;
use crate::base::expr::{Code, Env, Expr, Func, Node, OnlyParameters, Op, QRef, compile};
use crate::spec::{Cycle, Doubt, Entries, Formula, Guard, OnControl, Outcome, Param};

/// How deep names may stand for names; longer chains are circles, which the checks of the
/// specifications report.
const MAX_DEPTH: usize = 16;

/// A guard with its condition in terms of Q parameters, as far as that goes.
pub(in crate::check) struct Ready {
    /// Its code, if it has one.
    pub(in crate::check) code: Option<String>,
    /// What then.
    pub(in crate::check) then: Option<Outcome>,
    /// What its condition says in other words: one of these holds. Of a doubt only the parameter where it is reported.
    pub(in crate::check) ways: Vec<Way>,
    /// Its condition.
    pub(in crate::check) condition: Expr,
    /// The condition compiled; nothing if it needs more than parameters.
    pub(in crate::check) compiled: Option<Code>,
    /// Whether it asks for the state of the control.
    pub(in crate::check) asks_state: bool,
    /// Whether it asks for the tool.
    pub(in crate::check) asks_tool: bool,
}

/// One of several ways in which a condition holds.
pub(in crate::check) struct Way {
    /// Nothing if it needs more than parameters, or if there is no other way.
    compiled: Option<Code>,
    /// The expressions that it compares, by how much they are to blame: the left side of the last condition first.
    sides: Vec<Expr>,
}

impl Way {
    /// One that is reported at a parameter.
    fn about(about: QRef, condition: &Expr) -> Self {
        Self { compiled: None, sides: vec![Expr { node: Node::Q(about), span: condition.span }] }
    }

    /// Whether a side is a product, of which the sign is asked: depths have the same one, and it is negative.
    pub(in crate::check) fn is_product(&self, side: usize) -> bool {
        self.sides.get(side).is_some_and(|side| matches!(side.node, Node::Binary(Op::Mul, _, _)))
    }

    /// The parameters that it reads, in the order of its sides: of a choice only the side that is taken.
    pub(in crate::check) fn reads(&self, written: &impl Env) -> Vec<Vec<QRef>> {
        self.sides.iter().map(|side| taken(side, written).q_refs()).collect()
    }
}

/// An expression with what is chosen in the place of each choice whose condition is known.
fn taken(expr: &Expr, written: &impl Env) -> Expr {
    let node = match &expr.node {
        Node::Call(Func::If, args) => {
            if let [condition, then, otherwise] = args.as_slice()
                && let Some(truth) = compile(condition, &OnlyParameters).ok().and_then(|code| code.truth(written).ok())
            {
                return taken(if truth { then } else { otherwise }, written);
            }
            expr.node.clone()
        }
        Node::Unary(op, inner) => Node::Unary(*op, Box::new(taken(inner, written))),
        Node::Binary(op, left, right) => {
            Node::Binary(*op, Box::new(taken(left, written)), Box::new(taken(right, written)))
        }
        plain => plain.clone(),
    };
    Expr { node, span: expr.span }
}

fn ways(condition: &Expr) -> Vec<Way> {
    let mut parts = Vec::new();
    split(condition, Op::Or, &mut parts);
    let way = |part: &&Expr| {
        let mut conditions = Vec::new();
        split(part, Op::And, &mut conditions);
        let sides = conditions.iter().rev().flat_map(|own| match &own.node {
            Node::Binary(_, left, right) => vec![left.as_ref().clone(), right.as_ref().clone()],
            _ => vec![(*own).clone()],
        });
        let sides = sides.collect();
        Way { compiled: compile(part, &OnlyParameters).ok(), sides }
    };
    parts.iter().map(way).collect()
}

/// The parts of an expression between operators of a kind.
fn split<'e>(expr: &'e Expr, op: Op, parts: &mut Vec<&'e Expr>) {
    match &expr.node {
        Node::Binary(own, left, right) if *own == op => {
            split(left, op, parts);
            split(right, op, parts);
        }
        _ => parts.push(expr),
    }
}

impl Ready {
    /// The way in which it holds, as far as that is known.
    pub(in crate::check) fn way(&self, written: &impl Env) -> Option<&Way> {
        let holds = |way: &&Way| way.compiled.as_ref().is_some_and(|code| code.truth(written) == Ok(true));
        self.ways.iter().find(holds).or(self.ways.first())
    }

    /// A relation of values that no control looks at.
    fn doubt(doubt: &Doubt, condition: Expr) -> Self {
        Self {
            code: Some(doubt.code.as_str().to_owned()),
            then: Some(Outcome::Warn),
            ways: vec![Way::about(doubt.about, &condition)],
            compiled: compile(&condition, &OnlyParameters).ok(),
            asks_state: asks(&condition, state),
            asks_tool: asks(&condition, tool),
            condition,
        }
    }

    fn new(guard: &Guard, condition: Expr) -> Self {
        let compiled = compile(&condition, &OnlyParameters).ok();
        let (asks_state, asks_tool) = (asks(&condition, state), asks(&condition, tool));
        let code = guard.code.as_ref().map(|code| code.as_str().to_owned());
        let ways = guard.about.map_or_else(|| ways(&condition), |about| vec![Way::about(about, &condition)]);
        Self { code, then: guard.then, ways, condition, compiled, asks_state, asks_tool }
    }
}

/// Whether an expression has a name that something knows.
fn asks(condition: &Expr, knows: fn(&[String]) -> Option<usize>) -> bool {
    let mut found = false;
    condition.walk(&mut |expr| found |= matches!(&expr.node, Node::Name(path) if knows(path).is_some()));
    found
}

/// The guards of a cycle, those of fragments included, and what is hardly meant.
pub(in crate::check) fn guards_of(on: &OnControl, cycle: &Cycle) -> Vec<Ready> {
    let names = |path: &[String]| match path {
        [name] => cycle.file.lets.get(name).map(|formula| formula.expr.clone()),
        _ => None,
    };
    let mut found = Vec::new();
    collect(on, &cycle.file.guards, &names, 0, &mut found);
    found.extend(cycle.file.doubts.iter().map(|own| Ready::doubt(own, replaced(&own.when.expr, &names, 0))));
    found
}

fn collect(
    on: &OnControl,
    guards: &[Guard],
    names: &dyn Fn(&[String]) -> Option<Expr>,
    depth: usize,
    found: &mut Vec<Ready>,
) {
    for guard in guards {
        if let Some(when) = &guard.when {
            found.push(Ready::new(guard, replaced(&when.expr, names, 0)));
        }
        let fragment = guard.r#use.as_ref().and_then(|name| on.fragments.get(name.as_str()));
        if let Some(fragment) = fragment.filter(|_| depth < MAX_DEPTH) {
            let given = arguments(&guard.with, names);
            let inside = |path: &[String]| match path {
                [name] => given
                    .iter()
                    .find(|(own, _)| own == name)
                    .map(|(_, expr)| expr.clone())
                    .or_else(|| fragment.lets.get(name).map(|formula| formula.expr.clone())),
                _ => None,
            };
            collect(on, &fragment.guards, &inside, depth + 1, found);
        }
    }
}

fn arguments(with: &Entries<Formula>, names: &dyn Fn(&[String]) -> Option<Expr>) -> Vec<(String, Expr)> {
    with.0.iter().map(|(name, formula)| (name.as_str().to_owned(), replaced(&formula.expr, names, 0))).collect()
}

/// The expression with known names replaced.
pub(in crate::check) fn replaced(expr: &Expr, names: &dyn Fn(&[String]) -> Option<Expr>, depth: usize) -> Expr {
    if depth > MAX_DEPTH {
        return expr.clone();
    }
    let again = |inner: &Expr| replaced(inner, names, depth + 1);
    let node = match &expr.node {
        Node::Name(path) => return names(path).map_or_else(|| expr.clone(), |known| again(&known)),
        Node::Unary(op, inner) => Node::Unary(*op, Box::new(again(inner))),
        Node::Binary(op, left, right) => Node::Binary(*op, Box::new(again(left)), Box::new(again(right))),
        Node::Call(func, args) => Node::Call(*func, args.iter().map(again).collect()),
        plain => plain.clone(),
    };
    Expr { node, span: expr.span }
}

/// What guards may ask about the state of the control, besides the parameters. The machine builder may have other ways
/// into turning mode, and that a tool is missing is reported by a rule of its own.
pub(in crate::check) const STATES: [(&str, Aspect); 9] = [
    ("mirror", Aspect::Mirroring),
    ("scaling", Aspect::Scaling),
    ("axis_scaling", Aspect::AxisScaling),
    ("rotation", Aspect::Rotation),
    ("datum_shift", Aspect::DatumShift),
    ("tilting", Aspect::Tilting),
    ("basic_rotation", Aspect::BasicRotation),
    ("tcpm", Aspect::Tcpm),
    ("other_axis", Aspect::OtherAxis),
];

/// What guards may ask about the tool.
pub(in crate::check) const TOOL: [&str; 5] = ["radius", "angle", "lcuts", "pitch", "speed"];

/// The Q parameter under which the guards read a parameter or field.
pub(in crate::check) fn read_as(param: &Param) -> Option<QRef> {
    param.q.or_else(|| param.field.as_ref().and_then(|field| field.stands_for))
}

/// What is followed through the run under the name of a state; turning can be certain,
/// and that the control mills cannot.
pub(in crate::check) fn aspect_of(name: &str) -> Option<Aspect> {
    let turning = ("turning", Aspect::Turning);
    STATES.iter().chain([&turning]).find(|(own, _)| *own == name).map(|(_, aspect)| *aspect)
}

/// Which state a name asks for.
pub(in crate::check) fn state(path: &[String]) -> Option<usize> {
    let [first, second] = path else { return None };
    STATES.iter().position(|(word, _)| first == "active" && word == second)
}

/// What of the tool a name asks for, by its place after that of the states.
pub(in crate::check) fn tool(path: &[String]) -> Option<usize> {
    let [first, second] = path else { return None };
    let at = TOOL.iter().position(|word| first == "tool" && word == second)?;
    Some(STATES.len() + at)
}

/// The slot of machine data that switch guards off.
pub(in crate::check) const OFF: usize = STATES.len() + TOOL.len();
