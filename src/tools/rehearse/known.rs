//! What the blocks of a program say of where the tool is.
use super::watcher::Watcher;
use crate::engine::geometry::Axis;
use crate::program::syntax::{self, Block, BlockKind, CallForm};
use crate::spec::{CycleKey, Group};
use glam::DVec3;

/// So many blocks in a row may show nothing.
const SEVERAL: usize = 64;

impl Watcher<'_> {
    /// The line from which another program is called: the next block, if that does, else the last one that has moved.
    pub(super) fn calling_line(&self) -> usize {
        let silent = |block: &Block| {
            !matches!(block.kind, BlockKind::CallPgm(_) | BlockKind::Motion(_) | BlockKind::CyclCall(_))
        };
        let mut next = self.blocks.range(self.line..).skip(1).map(|(_, block)| *block).skip_while(|own| silent(own));
        next.next().filter(|own| matches!(own.kind, BlockKind::CallPgm(_))).map_or(self.line, |own| own.line)
    }

    /// Blocks up to a line that have shown nothing name where the tool already is.
    pub(super) fn pass_over(&mut self, to: usize) {
        if to <= self.line {
            return;
        }
        let blocks: Vec<&Block> = self.blocks.range(self.line + 1..=to).map(|(_, block)| *block).collect();
        let elsewhere = |block: &&Block| {
            matches!(
                block.kind,
                BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::FnJump(_) | BlockKind::ToolCall(_)
            )
        };
        if blocks.len() > SEVERAL || blocks.iter().any(elsewhere) {
            return;
        }
        for block in blocks.into_iter().filter(|block| !block.skip) {
            if let BlockKind::Motion(element) = &block.kind {
                let words = element.words();
                let of_machine = words.functions.iter().any(|own| matches!(own.number, 91 | 92));
                let tool = self.plane.tool;
                for (known, axis) in self.known.iter_mut().zip([self.plane.main, self.plane.secondary, tool]) {
                    let coord = words.coord(letter(axis));
                    *known |= names(&words, axis, tool);
                    *known &= coord.is_none() || !of_machine;
                }
            }
        }
    }

    /// Whether the blocks since the last tool call may say where the tool is in the plane: a movement to where it
    /// happens to be is none, and what was done elsewhere in the text is not looked at.
    pub(super) fn is_placed(&self) -> bool {
        if self.line <= self.called {
            return true;
        }
        let names = [self.plane.main, self.plane.secondary].map(letter);
        let mut named = [false; 2];
        for block in self.blocks.range(self.called..=self.line).map(|(_, block)| block) {
            match &block.kind {
                BlockKind::Motion(element) => {
                    let words = element.words();
                    let polar = [syntax::Axis::Pr, syntax::Axis::Pa].iter().any(|own| words.coord(*own).is_some());
                    for (named, axis) in named.iter_mut().zip(names) {
                        *named |= polar || words.coord(axis).is_some();
                    }
                }
                BlockKind::CallLbl(_) | BlockKind::CallPgm(_) | BlockKind::CyclCall(_) | BlockKind::Lbl(_) => {
                    return true;
                }
                _ => {}
            }
        }
        named == [true; 2]
    }

    /// Whether a movement belongs to a pattern, which goes to each of its places in both axes.
    pub(super) fn is_at_pattern(&self, key: Option<CycleKey>, line: usize) -> bool {
        let pattern = key.and_then(|key| self.cycle(key)).is_some_and(|own| own.file.group == Group::Patterns);
        let called = |block: &&Block| match &block.kind {
            BlockKind::CyclCall(call) => matches!(call.form, CallForm::Pattern),
            _ => false,
        };
        pattern || self.blocks.get(&line).is_some_and(called)
    }

    /// What a movement says of where the tool is: coordinates that it changes, or that its block names.
    pub(super) fn learn(&mut self, from: DVec3, block: Option<&Block>) {
        let words = block.and_then(|block| match &block.kind {
            BlockKind::Motion(element) => Some(element.words()),
            _ => None,
        });
        for (index, axis) in [self.plane.main, self.plane.secondary, self.plane.tool].into_iter().enumerate() {
            let named = words.as_ref().is_some_and(|words| names(words, axis, self.plane.tool));
            let axis = letter(axis);
            let moved = (from.to_array()[index] - self.at.to_array()[index]).abs() > 1e-9;
            self.known[index] |= named || moved;
            // Where a position in machine coordinates is depends on the machine.
            let of_machine = |words: &syntax::Motion| words.functions.iter().any(|own| matches!(own.number, 91 | 92));
            self.known[index] &= !words.as_ref().is_some_and(|own| own.coord(axis).is_some() && of_machine(own));
        }
    }
}

/// Whether a movement names where it leads along an axis: by its coordinate, or in the plane by polar ones.
fn names(words: &syntax::Motion, axis: Axis, tool: Axis) -> bool {
    let absolute = |axis: syntax::Axis| words.coord(axis).is_some_and(|coord| !coord.incremental);
    let polar = words.path == syntax::Path::Lp && absolute(syntax::Axis::Pr) && words.coord(syntax::Axis::Pa).is_some();
    absolute(letter(axis)) || axis != tool && polar
}

/// An axis as programs write it.
const fn letter(axis: Axis) -> syntax::Axis {
    match axis {
        Axis::X => syntax::Axis::X,
        Axis::Y => syntax::Axis::Y,
        Axis::Z => syntax::Axis::Z,
    }
}
