//! Where a run is: the block, the calls that led there, the repeats under way, and the limits.
//!
//! Invariant: every way back (jump, repeat, call) is counted, so a run always ends.
use std::sync::Arc;

use crate::engine::flow::code::Prepared;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::run::{Done, Limits};

/// What a call returns from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::engine) enum Call {
    /// The subprogram that begins at this block.
    Subprogram(usize),
    /// A whole program.
    Program,
}

/// A call under way: where it was made and what was called.
#[derive(Clone, Copy, Debug)]
struct Frame {
    program: usize,
    block: usize,
    call: Call,
}

/// Where a run is.
pub(in crate::engine) struct Flow {
    /// The program being executed.
    pub(in crate::engine) program: usize,
    /// The block being executed.
    pub(in crate::engine) block: usize,
    /// The block after it.
    pub(in crate::engine) next: usize,
    frames: Vec<Frame>,
    /// By program and block: how many repeats are left.
    repeats: Vec<Vec<Option<u32>>>,
    blocks: u64,
    jumps: u64,
}

/// How programs are called by name: the file name without folder and extension `.H`, in capitals.
pub fn program_key(name: &str) -> String {
    let last = name.rsplit(['\\', '/', ':']).next().unwrap_or_default().to_ascii_uppercase();
    last.strip_suffix(".H").map_or_else(|| last.clone(), str::to_owned)
}

impl Flow {
    pub(in crate::engine) fn new(program: &Prepared<'_>) -> Self {
        let mut flow =
            Self { program: 0, block: 0, next: 0, frames: Vec::new(), repeats: Vec::new(), blocks: 0, jumps: 0 };
        flow.add(program);
        flow
    }

    /// Takes in another program, which is numbered next.
    pub(in crate::engine) fn add(&mut self, program: &Prepared<'_>) {
        self.repeats.push(vec![None; program.program.blocks().len()]);
    }

    /// Goes on to the next block.
    pub(in crate::engine) fn advance(&mut self, limits: &Limits) -> Done {
        self.block = self.next;
        self.next = self.block + 1;
        self.blocks += 1;
        if self.blocks > limits.blocks {
            return Err(Fault::new(Class::Limit, "block-limit").arg("limit", limits.blocks as f64).into());
        }
        Ok(())
    }

    /// Goes to a block of the same program.
    pub(in crate::engine) fn jump(&mut self, block: usize, limits: &Limits) -> Done {
        self.jumps += 1;
        if self.jumps > limits.jumps {
            return Err(Fault::new(Class::Limit, "jump-limit").arg("limit", limits.jumps as f64).into());
        }
        self.next = block;
        Ok(())
    }

    /// Repeats the part from a label to here `times` times.
    pub(in crate::engine) fn repeat(&mut self, label: usize, times: u32, limits: &Limits) -> Done {
        let Some(left) = self.repeats.get_mut(self.program).and_then(|blocks| blocks.get_mut(self.block)) else {
            return Ok(());
        };
        let remaining = left.unwrap_or(times);
        if remaining == 0 {
            *left = None;
            return Ok(());
        }
        *left = Some(remaining - 1);
        self.jump(label, limits)
    }

    /// Calls a subprogram or program.
    pub(in crate::engine) fn call(&mut self, program: usize, block: usize, call: Call, limits: &Limits) -> Done {
        let same = |frame: &Frame| match (frame.call, call) {
            (Call::Subprogram(a), Call::Subprogram(b)) => a == b && frame.program == program,
            _ => false,
        };
        let running = call == Call::Program
            && (self.program == program || self.frames.iter().any(|frame| frame.program == program));
        if running || self.frames.iter().any(same) {
            return Err(Fault::program("recursive-call").into());
        }
        if self.frames.len() >= limits.depth {
            return Err(Fault::new(Class::Limit, "call-depth-limit").arg("limit", limits.depth as f64).into());
        }
        self.frames.push(Frame { program: self.program, block: self.block, call });
        self.program = program;
        self.jump(block, limits)
    }

    /// Returns from the subprogram; nothing happens where none was called.
    pub(in crate::engine) fn return_from_subprogram(&mut self) {
        if let Some(Frame { call: Call::Subprogram(_), .. }) = self.frames.last() {
            self.pop();
        }
    }

    /// Returns from the program, with all its subprograms. Whether there was a caller.
    pub(in crate::engine) fn return_from_program(&mut self) -> bool {
        while let Some(frame) = self.frames.last().copied() {
            self.pop();
            if frame.call == Call::Program {
                return true;
            }
        }
        false
    }

    /// How many calls are under way.
    pub(in crate::engine) fn depth(&self) -> usize {
        self.frames.len()
    }

    fn pop(&mut self) {
        if let Some(frame) = self.frames.pop() {
            self.program = frame.program;
            self.block = frame.block;
            self.next = frame.block + 1;
        }
    }

    /// Where the calls under way were made, the innermost first.
    pub(in crate::engine) fn calls(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.frames.iter().rev().map(|frame| (frame.program, frame.block))
    }

    /// The program's name for events.
    pub(in crate::engine) fn program_name(&self, programs: &[Prepared<'_>]) -> Arc<str> {
        programs.get(self.program).map_or("", |prepared| prepared.program.source().name()).into()
    }
}
