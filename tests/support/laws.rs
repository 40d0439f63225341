//! Laws over random input, written as those of `proptest!` and compiled once.
//!
//! `proptest!` compiles its runner anew for each law, which is a quarter of what the laws are to the compiler. Here the
//! runner sees one type, [`Drawn`], whatever a law draws.
use std::any::Any;
use std::fmt;

use proptest::strategy::{BoxedStrategy, Strategy};
use proptest::test_runner::{Config, TestCaseResult, TestError, TestRunner};

/// What a law has drawn.
trait Case: Any + fmt::Debug {}

impl<T: Any + fmt::Debug> Case for T {}

/// What a law has drawn, of whatever type it is.
pub(crate) struct Drawn(Box<dyn Case>);

impl fmt::Debug for Drawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Hides the type of what is drawn.
pub(crate) fn hidden<S>(strategy: S) -> BoxedStrategy<Drawn>
where
    S: Strategy<Value: 'static> + 'static,
{
    strategy.prop_map(|value| Drawn(Box::new(value))).boxed()
}

/// What gives a law the values that it draws from this strategy.
pub(crate) fn shown<S>(_: &S) -> fn(Drawn) -> S::Value
where
    S: Strategy<Value: 'static>,
{
    |Drawn(case)| {
        let case: Box<dyn Any> = case;
        *case.downcast().expect("a law gets what it draws")
    }
}

/// Tries a law; panics with the smallest case that breaks it and the names of what it draws.
pub(crate) fn hold(
    config: Config,
    names: &str,
    strategy: &BoxedStrategy<Drawn>,
    law: &dyn Fn(Drawn) -> TestCaseResult,
) {
    let mut runner = TestRunner::new(config);
    match runner.run(strategy, law) {
        Ok(()) => {}
        Err(TestError::Fail(why, case)) => {
            panic!("{why}\nthe smallest case that fails: ({names}) = {case:?}\n{runner}")
        }
        Err(TestError::Abort(why)) => panic!("{why}\n{runner}"),
    }
}

/// Laws as in `proptest!`: a configuration, and tests whose arguments are drawn from strategies.
macro_rules! laws {
    (
        #![proptest_config($config:expr)]
        $($(#[$meta:meta])* fn $name:ident($($drawn:pat_param in $strategy:expr),+ $(,)?) $body:block)*
    ) => {
        $(
            $(#[$meta])*
            fn $name() {
                let names = concat!($(stringify!($drawn), ", "),+);
                let strategy = ($($strategy,)+);
                let shown = $crate::laws::shown(&strategy);
                $crate::laws::hold($config, names, &$crate::laws::hidden(strategy), &|drawn| {
                    let ($($drawn,)+) = shown(drawn);
                    $body
                    Ok(())
                });
            }
        )*
    };
}
