//! The cycles of a program that no control describes: an execution passes over them.
use crate::check::mills_by_name;
use crate::program::fields::key;
use crate::program::syntax::Program;
use crate::spec::{Catalogue, Keyword, OnControl};

/// Whether all cycles of a program that no control describes mill pockets and the like, by their names.
pub(super) fn only_mills(program: &Program, on: &OnControl, catalogue: &Catalogue) -> bool {
    let mut mills = true;
    program.each_cycle(|view| {
        let own = key(view.keyword, view.number);
        if own.keyword == Keyword::CyclDef && !on.cycles.contains_key(&own) && catalogue.describing(own).is_none() {
            mills &= view.name.is_some_and(|name| mills_by_name(program.slice(name)));
        }
    });
    mills
}
