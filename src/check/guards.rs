//! The guards of specifications, evaluated with what a program writes.
//!
//! Names are replaced by the formulas that they stand for until only numbers and Q parameters are
//! left. Invariant: a guard that needs anything else (a parameter that is not certain, the tool, the machine)
//! says nothing; of the state of the control it hears what is certain.
use std::sync::{Arc, OnceLock};

use super::tools::Tool;
use super::values::number;
use super::{Aspect, Defined, Definition, Facts, Modal};
use crate::base::expr::{
    Code, Env, EvalError, Expr, Func, Node, OnlyParameters, Op, QRef, Resolve, Type, Value, compile,
};
use crate::program::syntax::ValueKind;
use crate::spec::{Cycle, Doubt, Entries, Formula, Guard, OnControl, Outcome, Param};

/// How deep names may stand for names; longer chains are circles, which the checks of the
/// specifications report.
const MAX_DEPTH: usize = 16;

/// A guard with its condition in terms of Q parameters, as far as that goes.
pub(super) struct Ready {
    /// Its code, if it has one.
    pub(super) code: Option<String>,
    /// What then.
    pub(super) then: Option<Outcome>,
    /// What its condition says in other words: one of these holds. Of a doubt only the parameter where it is told.
    pub(super) ways: Vec<Way>,
    /// Its condition.
    condition: Expr,
    /// The condition compiled; nothing if it needs more than parameters.
    compiled: Option<Code>,
    /// Whether it asks for the state of the control.
    asks_state: bool,
    /// Whether it asks for the tool.
    pub(super) asks_tool: bool,
}

/// One of several ways in which a condition holds.
pub(super) struct Way {
    /// Nothing if it needs more than parameters, or if there is no other way.
    compiled: Option<Code>,
    /// The expressions that it compares, by how much they are to blame: the left side of the last condition first.
    sides: Vec<Expr>,
}

impl Way {
    /// One that is told at a parameter.
    fn about(about: QRef, condition: &Expr) -> Self {
        Self { compiled: None, sides: vec![Expr { node: Node::Q(about), span: condition.span }] }
    }

    /// Whether a side is a product, of which the sign is asked: depths have the same one, and it is negative.
    pub(super) fn is_product(&self, side: usize) -> bool {
        self.sides.get(side).is_some_and(|side| matches!(side.node, Node::Binary(Op::Mul, _, _)))
    }

    /// The parameters that it reads, in the order of its sides: of a choice only the side that is taken.
    pub(super) fn reads(&self, written: &Written) -> Vec<Vec<QRef>> {
        self.sides.iter().map(|side| taken(side, written).q_refs()).collect()
    }
}

/// An expression with what is chosen in the place of each choice whose condition is known.
fn taken(expr: &Expr, written: &Written) -> Expr {
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
    /// The way in which it holds, as far as that can be said.
    pub(super) fn way(&self, written: &Written) -> Option<&Way> {
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
pub(super) fn of(on: &OnControl, cycle: &Cycle) -> Vec<Ready> {
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
fn replaced(expr: &Expr, names: &dyn Fn(&[String]) -> Option<Expr>, depth: usize) -> Expr {
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

/// The values that a definition writes as numbers or texts, and the state of the control as far as it is certain.
#[derive(Default)]
pub(super) struct Written {
    pub(super) numbers: Vec<(QRef, f64)>,
    pub(super) texts: Vec<(QRef, Arc<str>)>,
    /// The state before the definition, of which guards ask what [`STATES`] names.
    modal: Option<Modal>,
    /// What [`TOOL`] names, as far as it is known.
    tool: [Option<Value>; 2],
}

/// What guards may ask about the state of the control, besides the parameters. The machine builder may have other ways
/// into turning mode, and that a tool is missing is told by itself.
const STATES: [(&str, Aspect); 9] = [
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
const TOOL: [&str; 2] = ["radius", "angle"];

impl Written {
    /// The same with the tool that a call finds.
    pub(super) fn with(mut self, tool: Tool) -> Self {
        self.tool = [Some(tool.radius), tool.angle].map(|own| own.map(Value::Number));
        self
    }

    /// The values that are known: those written as numbers or texts, and those that this control lacks.
    pub(super) fn of(facts: &Facts<'_>, definition: &Definition<'_>, cycle: &Cycle) -> Self {
        let modal = facts.run.before(definition.view.first);
        let mut numbers = Vec::with_capacity(cycle.lacking.len() + definition.items.len());
        numbers.extend_from_slice(&cycle.lacking);
        let mut known = Self { numbers, texts: Vec::new(), modal, tool: [None, None] };
        for item in &definition.items {
            let (Some(q), Some(value)) = (item.param.and_then(read_as), item.value) else { continue };
            // Of what is written several times the first one is read.
            match value.kind {
                ValueKind::Number(_) | ValueKind::Q { .. } if definition.in_order || known.number(q).is_err() => {
                    known.numbers.extend(number(item).map(|number| (q, number)));
                }
                ValueKind::Text(inside) if definition.in_order || known.text(q).is_err() => {
                    known.texts.push((q, facts.text(inside).into()));
                }
                _ => {}
            }
        }
        if definition.kept.is_some_and(|kept| kept.deed(cycle).recalls()) {
            known.numbers.extend_from_slice(facts.shared.before(facts, definition));
        }
        known
    }

    /// The number that is written for a parameter.
    pub(super) fn number_of(&self, param: &Param) -> Option<f64> {
        self.number(read_as(param)?).ok()
    }

    /// Whether a parameter acts; nothing if that cannot be said.
    pub(super) fn acts(&self, cycle: &Cycle, param: &Param) -> Option<bool> {
        let Some(name) = &param.effective else { return Some(true) };
        let names = |path: &[String]| match path {
            [name] => cycle.file.lets.get(name).map(|formula| formula.expr.clone()),
            _ => None,
        };
        let condition = cycle.file.conditions.get(name.as_str())?;
        compile(&replaced(&condition.expr, &names, 0), &OnlyParameters).ok()?.truth(self).ok()
    }

    /// Whether something of the state is so, by its place in [`STATES`]; nothing if that is not certain.
    fn state(&self, at: usize) -> Option<bool> {
        let (_, aspect) = STATES.get(at)?;
        self.modal?.is(*aspect).known()
    }

    /// What is known of the tool, by the place of its name.
    fn of_tool(&self, at: usize) -> Option<&Value> {
        self.tool.get(at.checked_sub(STATES.len())?)?.as_ref()
    }

    /// Whether a guard's condition holds; nothing if that cannot be said.
    pub(super) fn holds(&self, ready: &Ready) -> Option<bool> {
        if let Some(code) = &ready.compiled {
            return code.truth(self).ok();
        }
        if !ready.asks_state && !ready.asks_tool {
            return None;
        }
        compile(&ready.condition, &WithState(self)).ok()?.truth(self).ok()
    }
}

/// The data that cycles share, read when a guard first asks for them: the first block of each definition that keeps
/// such, and its numbers.
#[derive(Default)]
pub(super) struct SharedData(OnceLock<Vec<(usize, Vec<(QRef, f64)>)>>);

impl SharedData {
    /// The numbers of the data that a cycle works with, from the definition before it that keeps such.
    fn before(&self, facts: &Facts<'_>, definition: &Definition<'_>) -> &[(QRef, f64)] {
        let all = self.0.get_or_init(|| {
            let keeps =
                |own: &&Defined<'_>| own.cycle().zip(own.kept).is_some_and(|(cycle, kept)| kept.deed(cycle).keeps());
            facts.definitions.iter().filter(keeps).map(|own| (own.view.first, numbers(&facts.read(own)))).collect()
        });
        let behind = all.partition_point(|(first, _)| *first < definition.view.first);
        behind.checked_sub(1).and_then(|at| all.get(at)).map_or(&[], |(_, numbers)| numbers)
    }
}

/// The first number of each parameter of a definition.
fn numbers(definition: &Definition<'_>) -> Vec<(QRef, f64)> {
    let mut numbers: Vec<(QRef, f64)> = Vec::new();
    for (q, number) in definition.items.iter().filter_map(|item| Some((item.param?.q?, number(item)?))) {
        if definition.in_order || !numbers.iter().any(|(own, _)| *own == q) {
            numbers.push((q, number));
        }
    }
    numbers
}

/// The Q parameter under which the guards read a parameter or field.
pub(super) fn read_as(param: &Param) -> Option<QRef> {
    param.q.or_else(|| param.field.as_ref().and_then(|field| field.stands_for))
}

/// What is followed through the run under the name of a state; turning can be certain,
/// and that the control mills cannot.
pub(super) fn aspect_of(name: &str) -> Option<Aspect> {
    let turning = ("turning", Aspect::Turning);
    STATES.iter().chain([&turning]).find(|(own, _)| *own == name).map(|(_, aspect)| *aspect)
}

/// Which state a name asks for.
fn state(path: &[String]) -> Option<usize> {
    let [first, second] = path else { return None };
    STATES.iter().position(|(word, _)| first == "active" && word == second)
}

/// What of the tool a name asks for, by its place behind that of the states.
fn tool(path: &[String]) -> Option<usize> {
    let [first, second] = path else { return None };
    let at = TOOL.iter().position(|word| first == "tool" && word == second)?;
    Some(STATES.len() + at)
}

/// The slot of machine data that switch guards off.
const OFF: usize = STATES.len() + TOOL.len();

/// Names of what is certain about the state.
struct WithState<'w>(&'w Written);

impl Resolve for WithState<'_> {
    fn name(&self, path: &[String]) -> Option<(usize, Type)> {
        // What switches a guard off is off, as machines come.
        if let [first, datum] = path
            && first == "machine"
            && datum.starts_with("suppress_")
        {
            return Some((OFF, Type::Number));
        }
        if let Some(at) = tool(path) {
            return self.0.of_tool(at).map(|_| (at, Type::Number));
        }
        let at = state(path)?;
        self.0.state(at).map(|_| (at, Type::Bool))
    }
}

impl Env for Written {
    fn slot(&self, slot: usize) -> &Value {
        // Only names of what is known have a slot.
        const NONE: &Value = &Value::Number(f64::NAN);
        if slot == OFF {
            return &Value::Number(0.0);
        }
        if let Some(value) = self.of_tool(slot) {
            return value;
        }
        match self.state(slot) {
            Some(true) => &Value::Bool(true),
            Some(false) => &Value::Bool(false),
            None => NONE,
        }
    }

    fn number(&self, q: QRef) -> Result<f64, EvalError> {
        let found = self.numbers.iter().find(|(own, _)| *own == q);
        found.map(|(_, value)| *value).ok_or(EvalError::Undefined(q))
    }

    fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
        let found = self.texts.iter().find(|(own, _)| *own == q);
        found.map(|(_, text)| Arc::clone(text)).ok_or(EvalError::Undefined(q))
    }
}
