//! Cycle definitions of both forms as one thing each.
//!
//! Invariant: a view borrows from the blocks and adds no knowledge but which lines belong together.
use super::definition::{CycleDef, CycleKeyword, OldCycleLine};
use super::tree::{Block, BlockKind};
use crate::base::diag::Span;

/// A cycle definition.
#[derive(Clone, Debug)]
pub struct CycleView<'p> {
    /// The family.
    pub keyword: CycleKeyword,
    /// The number in the family.
    pub number: u32,
    /// The printed name.
    pub name: Option<Span>,
    /// Keyword and number of its first line.
    pub head: Span,
    /// The index of its first block in the program.
    pub first: usize,
    /// The index of its last block.
    pub last: usize,
    /// The physical line of its first block.
    pub line: usize,
    /// What it consists of.
    pub form: CycleForm<'p>,
}

/// The two forms of definitions.
#[derive(Clone, Debug)]
pub enum CycleForm<'p> {
    /// Q parameters, in one block.
    Parameters(&'p CycleDef),
    /// Lines `n.0`, `n.1` …, a block each, in the order written.
    Lines(Vec<&'p OldCycleLine>),
}

/// Hands over the definitions of a program, in order.
pub(super) fn each_cycle<'p>(blocks: &'p [Block], mut each: impl FnMut(CycleView<'p>)) {
    // The last one, and whether it may go on.
    let mut last: Option<CycleView<'_>> = None;
    let mut open = false;
    for (index, block) in blocks.iter().enumerate() {
        match &block.kind {
            // Nothing that could be executed is between the lines of one definition.
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Unknown(_) => {}
            BlockKind::CycleDef(cycle) => {
                open = false;
                let view = CycleView {
                    keyword: cycle.keyword,
                    number: cycle.number,
                    name: cycle.name,
                    head: cycle.head,
                    first: index,
                    last: index,
                    line: block.line,
                    form: CycleForm::Parameters(cycle),
                };
                last.replace(view).into_iter().for_each(&mut each);
            }
            BlockKind::OldCycleLine(line) => {
                if !(open && last.as_mut().is_some_and(|last| joins(last, line, index))) {
                    last.replace(start(line, index, block.line)).into_iter().for_each(&mut each);
                }
                open = true;
            }
            _ => open = false,
        }
    }
    last.into_iter().for_each(each);
}

fn start(line: &OldCycleLine, index: usize, at: usize) -> CycleView<'_> {
    // Others follow line 0.
    let mut lines = Vec::with_capacity(4);
    lines.push(line);
    CycleView {
        keyword: line.keyword,
        number: line.number,
        name: line.name,
        head: line.head,
        first: index,
        last: index,
        line: at,
        form: CycleForm::Lines(lines),
    }
}

/// Adds a line to the definition before it, if it belongs there: lines may be in any order, but
/// line 0 begins a new definition.
fn joins<'p>(view: &mut CycleView<'p>, line: &'p OldCycleLine, index: usize) -> bool {
    let CycleForm::Lines(lines) = &mut view.form else { return false };
    let same = view.keyword == line.keyword && view.number == line.number;
    if !same || line.line == 0 {
        return false;
    }
    lines.push(line);
    view.last = index;
    true
}
