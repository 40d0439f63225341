//! The functions of expressions: their names and arguments, and the values of those that take one number.
use super::code::EvalError;
use super::value::{atand, cosd, sind, tand};

macro_rules! functions {
    ($($(#[$doc:meta])* $variant:ident $name:literal $least:literal..=$most:literal $spec:literal,)+) => {
        /// The functions. Angles are in degrees.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Func { $($(#[$doc])* $variant),+ }

        impl Func {
            /// The function of an upper-case name.
            pub fn by_name(name: &str) -> Option<Self> {
                match name { $($name => Some(Self::$variant),)+ _ => None }
            }
            /// The upper-case name.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }
            /// The least and the greatest number of arguments.
            pub const fn arity(self) -> (usize, usize) {
                match self { $(Self::$variant => ($least, $most)),+ }
            }
            /// Whether programs may not use it.
            pub const fn spec_only(self) -> bool {
                match self { $(Self::$variant => $spec),+ }
            }
        }
    };
}

functions! {
    /// Square root.
    Sqrt "SQRT" 1..=1 false,
    /// Square.
    Sq "SQ" 1..=1 false,
    /// Sine.
    Sin "SIN" 1..=1 false,
    /// Cosine.
    Cos "COS" 1..=1 false,
    /// Tangent.
    Tan "TAN" 1..=1 false,
    /// Arc sine.
    Asin "ASIN" 1..=1 false,
    /// Arc cosine.
    Acos "ACOS" 1..=1 false,
    /// Arc tangent.
    Atan "ATAN" 1..=1 false,
    /// e to the power.
    Exp "EXP" 1..=1 false,
    /// Natural logarithm.
    Ln "LN" 1..=1 false,
    /// Decimal logarithm.
    Log "LOG" 1..=1 false,
    /// The whole part.
    Int "INT" 1..=1 false,
    /// The amount.
    Abs "ABS" 1..=1 false,
    /// The part after the decimal point.
    Frac "FRAC" 1..=1 false,
    /// The opposite.
    Neg "NEG" 1..=1 false,
    /// The sign: -1, 0 or 1.
    Sgn "SGN" 1..=1 false,
    /// `IF(condition, then, otherwise)`.
    If "IF" 3..=3 true,
    /// The least.
    Min "MIN" 2..=4 true,
    /// The greatest.
    Max "MAX" 2..=4 true,
    /// `POINT(main, minor, tool)`.
    Point "POINT" 3..=3 true,
    /// `POLAR(centre, radius, angle)`: in the working plane, at the centre's height.
    Polar "POLAR" 3..=3 true,
    /// Distance of two points.
    Dist "DIST" 2..=2 true,
    /// Length of a vector.
    Length "LENGTH" 1..=1 true,
    /// A vector of length 1 in the same direction.
    Unit "UNIT" 1..=1 true,
    /// Scalar product.
    Dot "DOT" 2..=2 true,
    /// `ANGLE(main, minor)`: direction of a vector in the working plane.
    Angle "ANGLE" 2..=2 true,
}

impl Func {
    /// Whether its one argument is a number.
    pub(super) const fn takes_number(self) -> bool {
        self.arity().1 == 1 && !matches!(self, Self::Length | Self::Unit)
    }
}

/// The value of a function of one number.
pub(super) fn of_one(func: Func, x: f64) -> Result<f64, EvalError> {
    let domain = |ok: bool| if ok { Ok(()) } else { Err(EvalError::Domain(func, x)) };
    let value = match func {
        Func::Sqrt => {
            domain(x >= 0.0)?;
            libm::sqrt(x)
        }
        Func::Sq => x * x,
        Func::Sin => sind(x),
        Func::Cos => cosd(x),
        Func::Tan => {
            domain(cosd(x) != 0.0)?;
            tand(x)
        }
        Func::Asin => {
            domain((-1.0..=1.0).contains(&x))?;
            libm::asin(x).to_degrees()
        }
        Func::Acos => {
            domain((-1.0..=1.0).contains(&x))?;
            libm::acos(x).to_degrees()
        }
        Func::Atan => atand(x),
        Func::Exp => libm::exp(x),
        Func::Ln => {
            domain(x > 0.0)?;
            libm::log(x)
        }
        Func::Log => {
            domain(x > 0.0)?;
            libm::log10(x)
        }
        Func::Int => libm::trunc(x),
        Func::Abs => x.abs(),
        Func::Frac => x - libm::trunc(x),
        Func::Neg => -x,
        Func::Sgn => {
            if x == 0.0 {
                0.0
            } else {
                x.signum()
            }
        }
        _ => return Err(EvalError::Kind),
    };
    if value.is_finite() { Ok(value) } else { Err(EvalError::Overflow) }
}
