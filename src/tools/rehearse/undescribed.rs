//! The cycles of a program that no control describes: an execution passes over them.
use crate::program::fields::key;
use crate::program::syntax::Program;
use crate::spec::{Catalogue, Keyword, OnControl};

/// The first lines of the definitions of cycles that no control describes.
pub(super) fn lines(program: &Program, on: &OnControl, catalogue: &Catalogue) -> Vec<usize> {
    let mut lines = Vec::new();
    program.each_cycle(|view| {
        let own = key(view.keyword, view.number);
        let described = on.cycles.contains_key(&own) || catalogue.describing(own).is_some();
        if !described && own.keyword == Keyword::CyclDef {
            lines.extend(program.blocks().get(view.first).map(|block| block.line));
        }
    });
    lines
}
