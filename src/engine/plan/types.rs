//! Expressions of specifications compiled with the right type, or a diagnostic at their place.
//!
//! Invariant: no value leaves here without a known type.
use std::cell::RefCell;

use super::names::{Resolver, Scope};
use super::{Calc, Compiler};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{Dialect, Type, TypeError, compile, parse};
use crate::spec::{Argument, Formula, Name};

/// The word for a type in messages.
pub(super) const fn type_word(ty: Type) -> &'static str {
    match ty {
        Type::Number => "number",
        Type::Bool => "truth",
        Type::Point => "point",
        Type::Text => "text",
    }
}

/// The type of a word in `takes`.
pub(super) fn type_of_word(word: &str) -> Option<Type> {
    Some(match word {
        "number" => Type::Number,
        "truth" => Type::Bool,
        "point" => Type::Point,
        "text" => Type::Text,
        _ => return None,
    })
}

impl Compiler<'_> {
    /// A calculation of any type.
    pub(super) fn calc(&mut self, formula: &Formula, scope: &Scope) -> Option<Calc> {
        let resolver = Resolver { names: &self.names, scope, needs: RefCell::default() };
        match compile(&formula.expr, &resolver) {
            Ok(code) => {
                let mut needs = resolver.needs.into_inner();
                needs.sort_unstable();
                needs.dedup();
                Some(Calc { code, needs: needs.into_boxed_slice(), place: formula.place.clone() })
            }
            Err(TypeError::Unknown { name, span }) => {
                self.found.push(Diagnostic::error("plan-unknown-name", formula.at(span)).arg("name", name));
                None
            }
            Err(TypeError::Mismatch { expected, found, span }) => {
                self.mismatch(formula.at(span), type_word(expected), type_word(found));
                None
            }
        }
    }

    /// A calculation of that type.
    pub(super) fn typed(&mut self, formula: &Formula, ty: Type, scope: &Scope) -> Option<Calc> {
        let calc = self.calc(formula, scope)?;
        if calc.code.ty() == ty {
            return Some(calc);
        }
        self.mismatch(formula.place.clone(), type_word(ty), type_word(calc.code.ty()));
        None
    }

    /// The condition of an action or item, if it has one. The inner option says whether it has.
    pub(super) fn when(&mut self, formula: Option<&Formula>, scope: &Scope) -> Option<Option<Calc>> {
        match formula {
            None => Some(None),
            Some(formula) => self.typed(formula, Type::Bool, scope).map(Some),
        }
    }

    /// A scalar argument read as an expression.
    pub(super) fn formula(&mut self, name: &Name) -> Option<Formula> {
        let shell = |expr| Formula { expr, text: name.text.clone(), place: name.place.clone() };
        match parse(&name.text, Dialect::Spec) {
            Ok(expr) => Some(shell(expr)),
            Err(error) => {
                let at =
                    shell(crate::base::expr::Expr { node: crate::base::expr::Node::Number(0.0), span: error.span });
                let diagnostic = Diagnostic::error("spec-expression", at.at(error.span));
                self.found.push(diagnostic.arg("expected", error.expected).arg("found", error.found));
                None
            }
        }
    }

    /// An argument that is one expression of that type.
    pub(super) fn argument(&mut self, argument: &Argument, ty: Type, scope: &Scope, place: &Place) -> Option<Calc> {
        let name = self.one(argument, type_word(ty), place)?;
        let formula = self.formula(&name)?;
        self.typed(&formula, ty, scope)
    }

    /// An argument that is a scalar.
    pub(super) fn one(&mut self, argument: &Argument, expected: &'static str, place: &Place) -> Option<Name> {
        match argument {
            Argument::One(name) => Some(name.clone()),
            Argument::Many(_) | Argument::List(_) => {
                self.wrong(place, expected);
                None
            }
        }
    }

    /// Reports an argument of the wrong form.
    pub(super) fn wrong(&mut self, place: &Place, expected: &'static str) {
        self.found.push(Diagnostic::error("plan-argument", place.clone()).arg("expected", expected));
    }

    pub(super) fn mismatch(&mut self, place: Place, expected: &'static str, found: &'static str) {
        self.found.push(Diagnostic::error("plan-type", place).arg("expected", expected).arg("found", found));
    }
}
