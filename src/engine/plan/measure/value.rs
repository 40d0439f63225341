//! What a formula measures, by what is in it.
use super::{ANGLE, COORDINATE, DISTANCE, FEED, LENGTH, Measure, NUMBER, Reader, Unit, plain, unit};
use crate::base::diag::Place;
use crate::base::expr::{Expr, Func, Node, Op};
use crate::spec::{Quantity, Reference};

/// Whether it is a number that is written there, and not 0.
fn is_literal(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number(value) => *value != 0.0,
        Node::Unary(_, inner) => is_literal(inner),
        _ => false,
    }
}

/// Whether it is a sign that is written there.
fn is_sign(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number(value) => value.abs() == 1.0,
        Node::Unary(_, inner) => is_sign(inner),
        _ => false,
    }
}

/// Whether two formulas say the same, wherever they are.
fn is_same(one: &Expr, other: &Expr) -> bool {
    let all = |some: &[Expr], others: &[Expr]| {
        some.len() == others.len() && some.iter().zip(others).all(|(one, other)| is_same(one, other))
    };
    match (&one.node, &other.node) {
        (Node::Unary(op, a), Node::Unary(same, b)) => op == same && is_same(a, b),
        (Node::Binary(op, a, b), Node::Binary(same, c, d)) => op == same && is_same(a, c) && is_same(b, d),
        (Node::Call(func, some), Node::Call(same, others)) => func == same && all(some, others),
        (one, other) => one == other,
    }
}

/// Whether there is nothing to choose from or to compare: both branches, or both sides, are the same.
fn is_pointless(expr: &Expr) -> bool {
    match &expr.node {
        Node::Binary(op, one, other) => {
            let of_two = !matches!(op, Op::Add | Op::Mul);
            of_two && is_same(one, other)
        }
        Node::Call(Func::If, arguments) => matches!(arguments.as_slice(), [_, one, other] if is_same(one, other)),
        Node::Call(Func::Min | Func::Max, arguments) => {
            matches!(arguments.as_slice(), [one, other] if is_same(one, other))
        }
        _ => false,
    }
}

/// Whether a formula is divided by 2.
fn is_two(expr: &Expr) -> bool {
    matches!(expr.node, Node::Number(value) if value == 2.0)
}

/// The unit of a product or, with a sign of -1, of a quotient. A factor of which nothing is known has no unit; of a
/// number times a direction nothing is known.
fn product(one: Option<Unit>, two: Option<Unit>, sign: i8) -> Option<Unit> {
    match (one, two) {
        (None, None | Some([0, 0, 0])) | (Some([0, 0, 0]), None) => None,
        _ => {
            let (one, two) = (one.unwrap_or_default(), two.unwrap_or_default());
            Some(std::array::from_fn(|n| one[n].saturating_add(two[n].saturating_mul(sign))))
        }
    }
}

impl Reader<'_> {
    fn name(&self, path: &[String]) -> Measure {
        let name = path.join(".");
        if let Some(measure) = self.names.get(&name) {
            return *measure;
        }
        // A coordinate of a point measures what the point does.
        if let [head @ .., "main" | "minor" | "tool"] = path.iter().map(String::as_str).collect::<Vec<_>>().as_slice()
            && let Some(point) = self.names.get(&head.join("."))
        {
            return *point;
        }
        let field = |n: usize| path.get(n).map(String::as_str);
        match (field(0), field(1)) {
            (Some("here" | "start"), Some("main" | "minor" | "tool")) => COORDINATE,
            (Some("here" | "start" | "machine_point" | "machine_length"), _) => LENGTH,
            (Some("tool"), Some("radius" | "length" | "lcuts" | "pitch" | "corner_radius")) => DISTANCE,
            (Some("tool"), Some("speed")) => plain(unit(Quantity::Speed)),
            (Some("probe"), Some("set_up" | "dist" | "ball_radius")) => DISTANCE,
            (Some("probe"), Some("offset")) => LENGTH,
            (Some("probe"), Some("feed" | "fmax")) => FEED,
            (Some("probe" | "tool"), Some("angle")) | (Some("axis"), _) => ANGLE,
            (Some("tool"), Some("number")) => NUMBER,
            _ => Measure::default(),
        }
    }

    pub(super) fn value(&mut self, expr: &Expr, place: &Place) -> Measure {
        if is_pointless(expr) {
            self.report(place, expr, "same-operands");
        }
        match &expr.node {
            Node::Number(_) | Node::Text(_) => Measure::default(),
            Node::Q(q) => self.q(*q),
            Node::Name(path) => self.name(path),
            Node::Unary(_, inner) => {
                let inner = self.value(inner, place);
                opposite(inner)
            }
            Node::Binary(Op::Div, left, right) if is_two(right) => self.mean(left, place),
            Node::Binary(op, left, right) => {
                let (one, two) = (self.value(left, place), self.value(right, place));
                let compared = matches!(op, Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge);
                if compared {
                    // A length is compared with lengths: a number would have a unit that no one has said.
                    for (measure, other) in [(one, right), (two, left)] {
                        if measure.unit.is_some_and(|[length, ..]| length != 0) && is_literal(other) {
                            self.report(place, expr, "bare-number");
                        }
                    }
                }
                self.binary(*op, one, two, expr, place)
            }
            // One sign or the other is a number, as a sign that is asked for is.
            Node::Call(Func::If, arguments) if arguments.get(1..).is_some_and(|signs| signs.iter().all(is_sign)) => {
                for argument in arguments {
                    self.value(argument, place);
                }
                NUMBER
            }
            Node::Call(Func::Sgn | Func::Abs, arguments) if arguments.iter().any(|one| self.is_never_negative(one)) => {
                self.report(place, expr, "never-negative");
                Measure::default()
            }
            Node::Call(func, arguments) => {
                let measures: Vec<Measure> = arguments.iter().map(|argument| self.value(argument, place)).collect();
                self.call(*func, &measures, expr, place)
            }
        }
    }

    /// Whether it is a parameter whose range begins at 0 or above: its sign and its absolute value say nothing.
    fn is_never_negative(&self, expr: &Expr) -> bool {
        let Node::Q(q) = expr.node else { return false };
        self.cycle.param(q).and_then(|param| param.min).is_some_and(|min| min >= 0.0)
    }

    /// Whether two values can be added, compared or chosen from.
    fn alike(&mut self, one: Measure, two: Measure, expr: &Expr, place: &Place) -> bool {
        let differ = matches!((one.unit, two.unit), (Some(a), Some(b)) if a != b);
        if differ {
            self.report(place, expr, "different-quantities");
        }
        !differ
    }

    /// Half of a value; half of the sum of two coordinates is the coordinate between them.
    fn mean(&mut self, sum: &Expr, place: &Place) -> Measure {
        if let Node::Binary(Op::Add, left, right) = &sum.node {
            let (one, two) = (self.value(left, place), self.value(right, place));
            if one.reference == Some(Reference::Absolute) && two.reference == Some(Reference::Absolute) {
                return if self.alike(one, two, sum, place) { one } else { Measure::default() };
            }
            let sum = self.binary(Op::Add, one, two, sum, place);
            return halved(sum);
        }
        let value = self.value(sum, place);
        halved(value)
    }

    fn binary(&mut self, op: Op, one: Measure, two: Measure, expr: &Expr, place: &Place) -> Measure {
        use Reference::{Absolute, Incremental};
        match op {
            Op::Add | Op::Sub => {
                if !self.alike(one, two, expr, place) {
                    return Measure::default();
                }
                let reference = match (op, one.reference, two.reference) {
                    (Op::Add, Some(Absolute), Some(Absolute)) => {
                        self.report(place, expr, "coordinates-added");
                        None
                    }
                    (Op::Sub, Some(Absolute), Some(Absolute)) => Some(Incremental),
                    (Op::Add, _, Some(Absolute)) | (_, Some(Absolute), _) => Some(Absolute),
                    (_, Some(Incremental), Some(Incremental)) => Some(Incremental),
                    _ => None,
                };
                Measure { unit: one.unit.or(two.unit), reference }
            }
            Op::Mul | Op::Div => {
                let unit = product(one.unit, two.unit, if op == Op::Mul { 1 } else { -1 });
                // A part or a multiple of a distance is a distance.
                let number = |measure: Measure| measure.unit.is_none_or(|unit| unit == [0; 3]);
                let reference = match (number(one), number(two)) {
                    (false, true) => one.reference,
                    (true, false) if op == Op::Mul => two.reference,
                    _ => None,
                };
                Measure { unit, reference: reference.filter(|reference| *reference == Incremental) }
            }
            Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge => {
                self.alike(one, two, expr, place);
                Measure::default()
            }
            _ => Measure::default(),
        }
    }

    fn wants(&mut self, measure: Measure, wanted: Quantity, expr: &Expr, place: &Place) {
        self.demand(expr, place, measure, wanted);
    }

    fn call(&mut self, func: Func, measures: &[Measure], expr: &Expr, place: &Place) -> Measure {
        match (func, measures) {
            (Func::Abs, [one]) => {
                // How far a coordinate is from the datum says nothing about the part.
                if one.reference == Some(Reference::Absolute) {
                    self.report(place, expr, "coordinate-as-distance");
                }
                Measure { reference: None, ..*one }
            }
            (Func::Neg, [one]) => opposite(*one),
            (Func::Sgn, _) => NUMBER,
            (Func::Sin | Func::Cos | Func::Tan, [one]) => {
                self.wants(*one, Quantity::Angle, expr, place);
                NUMBER
            }
            (Func::Asin | Func::Acos | Func::Atan, [one]) => {
                self.wants(*one, Quantity::Number, expr, place);
                ANGLE
            }
            (Func::Angle, [one, two]) => {
                self.alike(*one, *two, expr, place);
                ANGLE
            }
            (Func::If, [_, one, two]) => self.either(*one, *two, expr, place),
            (Func::Min | Func::Max, [first, others @ ..]) => {
                others.iter().fold(*first, |one, two| self.either(one, *two, expr, place))
            }
            (Func::Point, [main, minor, tool]) => {
                if !self.alike(*main, *minor, expr, place) || !self.alike(*main, *tool, expr, place) {
                    return Measure::default();
                }
                self.alike(*minor, *tool, expr, place);
                let has = |reference| [main, minor, tool].into_iter().any(|one| one.reference == Some(reference));
                if has(Reference::Absolute) && has(Reference::Incremental) {
                    self.report(place, expr, "distance-as-coordinate");
                }
                // What has no unit is a direction, which may be added to a position.
                let mut units = [main, minor, tool].into_iter().filter_map(|measure| measure.unit);
                units.find(|unit| *unit != [0; 3]).map_or_else(Measure::default, plain)
            }
            (Func::Polar, [centre, radius, angle]) => {
                self.wants(*angle, Quantity::Angle, expr, place);
                if !self.alike(*centre, *radius, expr, place) {
                    return Measure::default();
                }
                // About nothing in particular it is a direction.
                centre.unit.or(radius.unit).map_or_else(Measure::default, plain)
            }
            (Func::Dist, [one, two]) => {
                self.alike(*one, *two, expr, place);
                LENGTH
            }
            (Func::Length, _) => LENGTH,
            (Func::Sqrt, [one]) => {
                let even = one.unit.filter(|unit| unit.iter().all(|exponent| exponent % 2 == 0));
                even.map_or_else(Measure::default, |unit| plain(unit.map(|exponent| exponent / 2)))
            }
            (Func::Sq, [one]) => Measure { unit: product(one.unit, one.unit, 1), reference: None },
            (Func::Dot, [one, two]) => Measure { unit: product(one.unit, two.unit, 1), reference: None },
            (Func::Int | Func::Frac, [one]) => Measure { reference: None, ..*one },
            _ => Measure::default(),
        }
    }

    /// One of two values.
    fn either(&mut self, one: Measure, two: Measure, expr: &Expr, place: &Place) -> Measure {
        if !self.alike(one, two, expr, place) {
            return Measure::default();
        }
        if one.reference.is_some() && two.reference.is_some() && one.reference != two.reference {
            self.report(place, expr, "coordinate-as-distance");
        }
        let reference = if one.reference == two.reference { one.reference } else { None };
        Measure { unit: one.unit.or(two.unit), reference }
    }
}

/// What a value with the other sign measures: a coordinate is none any more.
fn opposite(one: Measure) -> Measure {
    Measure { reference: one.reference.filter(|reference| *reference == Reference::Incremental), ..one }
}

/// Half of a distance is a distance, half of a coordinate nothing in particular.
fn halved(one: Measure) -> Measure {
    opposite(one)
}
