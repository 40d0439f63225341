//! What a strategy is called with and what it gives: names, types and units, written once, as a type.
//!
//! A strategy is a type whose fields are its arguments. The macro [`strategy!`](crate::engine::strategy) gives it the
//! list by which plans are compiled ([`Signature::PARAMETERS`]) and the decoding of evaluated values; `results!` does
//! the same for what it gives. Invariant: nothing outside of this file counts arguments or results by position.
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::{Type, Value};
use crate::engine::report::fault::{Class, Fault};
use crate::spec::Quantity;

/// The argument that is given by the modifier `at`: the feed of a path.
pub const AT: &str = "at";

/// An argument of a strategy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name: that of the field, and that in specifications.
    pub name: &'static str,
    /// Its type in formulas.
    pub ty: Type,
    /// What it measures; `Number` for what has no unit.
    pub quantity: Quantity,
    /// Whether it must be there.
    pub required: bool,
}

impl Parameter {
    /// Whether it is given by the modifier `at` and not by name.
    pub fn is_feed_of_path(&self) -> bool {
        self.name == AT
    }
}

/// A result of a strategy: a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// Its name.
    pub name: &'static str,
    /// What it measures; `Number` for what has no unit.
    pub quantity: Quantity,
}

/// A length or point in mm, or a feed in mm/min, whatever the unit is in which the cycle calculates: that of the program
/// for probing cycles. Lengths without it are in the unit of the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mm<T>(pub T);

/// The values of the arguments, in the order of [`Signature::PARAMETERS`]; only decoding looks at them.
pub struct Given<'v> {
    values: std::vec::Drain<'v, Option<Value>>,
    mm: f64,
}

impl<'v> Given<'v> {
    /// Values in the order of the parameters, and mm in the unit in which lengths among them are.
    pub fn new(values: &'v mut Vec<Option<Value>>, mm: f64) -> Self {
        Self { values: values.drain(..), mm }
    }

    /// The next argument.
    pub(super) fn next<A: Argument>(&mut self) -> Result<A, Fault> {
        let value = self.values.next().flatten();
        A::decode(value, self.mm).ok_or_else(wrong)
    }

    /// Whether all of them were taken.
    pub(super) fn end(&mut self) -> Result<(), Fault> {
        if self.values.next().is_none() { Ok(()) } else { Err(wrong()) }
    }
}

/// The fault of values that belong to another signature than the one by which the plan was compiled.
fn wrong() -> Fault {
    Fault::new(Class::Internal, "strategy-argument")
}

/// A type that an argument can have.
pub trait Argument: Sized {
    /// Its type in formulas.
    const TYPE: Type;
    /// Whether it must be there.
    const REQUIRED: bool = true;

    /// The argument of a value; nothing if that has another type. `mm` are the mm in a unit of the value.
    fn decode(value: Option<Value>, mm: f64) -> Option<Self>;
}

impl Argument for f64 {
    const TYPE: Type = Type::Number;

    fn decode(value: Option<Value>, _: f64) -> Option<Self> {
        match value? {
            Value::Number(number) => Some(number),
            _ => None,
        }
    }
}

/// A truth is written as a number: 0 is false.
impl Argument for bool {
    const TYPE: Type = Type::Number;

    fn decode(value: Option<Value>, mm: f64) -> Option<Self> {
        f64::decode(value, mm).map(|number| number != 0.0)
    }
}

impl Argument for DVec3 {
    const TYPE: Type = Type::Point;

    fn decode(value: Option<Value>, _: f64) -> Option<Self> {
        match value? {
            Value::Point(point) => Some(point),
            _ => None,
        }
    }
}

impl Argument for Arc<str> {
    const TYPE: Type = Type::Text;

    fn decode(value: Option<Value>, _: f64) -> Option<Self> {
        match value? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }
}

impl<A: Argument + std::ops::Mul<f64, Output = A>> Argument for Mm<A> {
    const TYPE: Type = A::TYPE;
    const REQUIRED: bool = A::REQUIRED;

    fn decode(value: Option<Value>, mm: f64) -> Option<Self> {
        A::decode(value, mm).map(|value| Self(value * mm))
    }
}

impl<A: Argument> Argument for Option<A> {
    const TYPE: Type = A::TYPE;
    const REQUIRED: bool = false;

    fn decode(value: Option<Value>, mm: f64) -> Option<Self> {
        match value {
            None => Some(None),
            value => A::decode(value, mm).map(Some),
        }
    }
}

/// A strategy with its arguments.
pub trait Signature: Sized {
    /// Its name in specifications.
    const NAME: &'static str;
    /// Its arguments in the order of their declaration, in which they are evaluated, too.
    const PARAMETERS: &'static [Parameter];

    /// The strategy with the arguments that are given.
    ///
    /// # Errors
    /// A value has not the type of its parameter: the plan was compiled by another signature.
    fn decode(given: Given<'_>) -> Result<Self, Fault>;
}

/// A type that a result can have.
pub trait Resulting: Copy {
    /// The number in the unit of the cycle; `mm` are the mm in that.
    fn number(self, mm: f64) -> f64;
}

impl Resulting for f64 {
    fn number(self, _: f64) -> f64 {
        self
    }
}

impl Resulting for Mm<f64> {
    fn number(self, mm: f64) -> f64 {
        self.0 / mm
    }
}

/// What a strategy gives.
pub trait Results {
    /// The results in the order of their declaration.
    const OUTPUTS: &'static [Output];

    /// Their numbers in that order, in the unit of the cycle; `mm` are the mm in that.
    fn numbers(&self, mm: f64) -> Vec<f64>;
}

impl Results for () {
    const OUTPUTS: &'static [Output] = &[];

    fn numbers(&self, _: f64) -> Vec<f64> {
        Vec::new()
    }
}

/// Declares a strategy: `Name = "name-in-specifications" { argument: type = Quantity, … }`.
macro_rules! strategy {
    ($(#[$doc:meta])* $name:ident = $text:literal {
        $($(#[$of:meta])* $field:ident: $ty:ty = $quantity:ident,)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name { $($(#[$of])* pub $field: $ty,)* }

        impl $crate::engine::strategy::Signature for $name {
            const NAME: &'static str = $text;
            const PARAMETERS: &'static [$crate::engine::strategy::Parameter] = &[$(
                $crate::engine::strategy::Parameter {
                    name: stringify!($field),
                    ty: <$ty as $crate::engine::strategy::Argument>::TYPE,
                    quantity: $crate::spec::Quantity::$quantity,
                    required: <$ty as $crate::engine::strategy::Argument>::REQUIRED,
                },
            )*];

            fn decode(
                mut given: $crate::engine::strategy::Given<'_>,
            ) -> Result<Self, $crate::engine::report::fault::Fault> {
                let strategy = Self { $($field: given.next()?,)* };
                given.end()?;
                Ok(strategy)
            }
        }
    };
}

/// Declares what a strategy gives: `Name { result: type = Quantity, … }`.
macro_rules! results {
    ($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $field:ident: $ty:ty = $quantity:ident,)+ }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name { $($(#[$of])* pub $field: $ty,)+ }

        impl $crate::engine::strategy::Results for $name {
            const OUTPUTS: &'static [$crate::engine::strategy::Output] = &[$(
                $crate::engine::strategy::Output {
                    name: stringify!($field),
                    quantity: $crate::spec::Quantity::$quantity,
                },
            )+];

            fn numbers(&self, mm: f64) -> Vec<f64> {
                vec![$($crate::engine::strategy::Resulting::number(self.$field, mm),)+]
            }
        }
    };
}

pub(super) use {results, strategy};
