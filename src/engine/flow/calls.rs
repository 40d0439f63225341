//! Programs, and where a run is in them: the block, the calls that led there, the repeats under way, and the limits.
//!
//! Invariant: every way back (jump, repeat, call) is counted, so a run always ends.
use std::collections::BTreeMap;
use std::sync::Arc;

use crate::base::diag::Place;
use crate::engine::flow::code::Prepared;
use crate::engine::flow::settings::{Limits, Settings};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// What a call returns from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
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

/// The programs of a run, and where it is.
pub(crate) struct Calls<'e> {
    programs: Vec<Prepared<'e>>,
    /// Programs that were called, by name.
    names: BTreeMap<String, usize>,
    /// The program being executed.
    pub(crate) program: usize,
    /// The block being executed.
    pub(crate) block: usize,
    /// The block after it.
    pub(crate) next: usize,
    frames: Vec<Frame>,
    /// A number for each call of a program under way, the outermost first.
    of_programs: Vec<u64>,
    /// How many programs were called.
    calls_of_programs: u64,
    /// By program and block: how many repeats are left.
    repeats: Vec<Vec<Option<u32>>>,
    blocks: u64,
    jumps: u64,
    /// The blocks of the first program before this one were executed or passed over.
    passed: usize,
}

/// How programs are called by name: the file name without folder and extension `.H`, in capitals.
pub fn program_key(name: &str) -> String {
    let last = name.rsplit(['\\', '/', ':']).next().unwrap_or_default().to_ascii_uppercase();
    last.strip_suffix(".H").map_or_else(|| last.clone(), str::to_owned)
}

impl<'e> Calls<'e> {
    pub(crate) fn new(program: Prepared<'e>) -> Self {
        let mut calls = Self {
            programs: Vec::new(),
            names: BTreeMap::new(),
            program: 0,
            block: 0,
            next: 0,
            frames: Vec::new(),
            of_programs: Vec::new(),
            calls_of_programs: 0,
            repeats: Vec::new(),
            blocks: 0,
            jumps: 0,
            passed: 0,
        };
        calls.add(program);
        calls
    }

    /// Whether the block is one of the first program that has not been executed before.
    pub(crate) fn is_first_time(&mut self) -> bool {
        let fresh = self.program == 0 && self.block >= self.passed;
        if fresh {
            self.passed = self.block + 1;
        }
        fresh
    }

    /// Takes in another program. Its number.
    fn add(&mut self, program: Prepared<'e>) -> usize {
        self.repeats.push(vec![None; program.program.blocks().len()]);
        self.programs.push(program);
        self.programs.len() - 1
    }

    /// The number of a program that is called, which is looked for at its first call.
    pub(crate) fn called(&mut self, key: String, settings: &Settings<'e>) -> Option<usize> {
        if let Some(known) = self.names.get(&key) {
            return Some(*known);
        }
        let given = settings.others.get(&key).copied();
        let number = self.add(Prepared::new(given.or_else(|| settings.around?.program(&key))?));
        self.names.insert(key, number);
        Some(number)
    }

    /// The program being executed.
    pub(crate) fn here(&self) -> Option<&Prepared<'e>> {
        self.programs.get(self.program)
    }

    /// The place of a block in the text of its program.
    pub(crate) fn place_of(&self, program: usize, block: usize) -> Option<Place> {
        let prepared = self.programs.get(program)?;
        let block = prepared.block(block)?;
        let text = prepared.program.slice(block.span);
        // Line ends and blanks are no part of what is shown.
        let start = block.span.start + (text.len() - text.trim_start().len());
        Some(Place::new(prepared.program.source(), start..(block.span.start + text.trim_end().len()).max(start)))
    }

    /// Goes on to the next block.
    pub(crate) fn advance(&mut self, limits: &Limits) -> Done {
        self.block = self.next;
        self.next = self.block + 1;
        self.blocks += 1;
        if self.blocks > limits.blocks {
            return Err(Fault::new(Class::Limit, "block-limit").arg("limit", limits.blocks as f64).into());
        }
        Ok(())
    }

    /// Goes to a block of the same program.
    pub(crate) fn jump(&mut self, block: usize, limits: &Limits) -> Done {
        self.jumps += 1;
        if self.jumps > limits.jumps {
            return Err(Fault::new(Class::Limit, "jump-limit").arg("limit", limits.jumps as f64).into());
        }
        self.next = block;
        Ok(())
    }

    /// Repeats the part from a label to here `times` times.
    pub(crate) fn repeat(&mut self, label: usize, times: u32, limits: &Limits) -> Done {
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
    pub(crate) fn call(&mut self, program: usize, block: usize, call: Call, limits: &Limits) -> Done {
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
        if call == Call::Program {
            self.calls_of_programs += 1;
            self.of_programs.push(self.calls_of_programs);
        }
        self.program = program;
        self.jump(block, limits)
    }

    /// Returns from the subprogram; nothing happens where none was called.
    pub(crate) fn return_from_subprogram(&mut self) {
        if let Some(Frame { call: Call::Subprogram(_), .. }) = self.frames.last() {
            self.pop();
        }
    }

    /// Returns from the program, with all its subprograms. Whether there was a caller.
    pub(crate) fn return_from_program(&mut self) -> bool {
        while let Some(frame) = self.frames.last().copied() {
            self.pop();
            if frame.call == Call::Program {
                return true;
            }
        }
        false
    }

    /// The calls of programs under way, the outermost first: each has a number of its own.
    pub(crate) fn of_programs(&self) -> &[u64] {
        &self.of_programs
    }

    /// How many calls are under way.
    pub(crate) fn depth(&self) -> usize {
        self.frames.len()
    }

    fn pop(&mut self) {
        if let Some(frame) = self.frames.pop() {
            if frame.call == Call::Program {
                self.of_programs.pop();
            }
            self.program = frame.program;
            self.block = frame.block;
            self.next = frame.block + 1;
        }
    }

    /// Where the calls under way were made, the innermost first.
    pub(crate) fn places(&self) -> impl Iterator<Item = Place> + '_ {
        self.frames.iter().rev().filter_map(|frame| self.place_of(frame.program, frame.block))
    }

    /// The program's name for events.
    pub(crate) fn program_name(&self) -> Arc<str> {
        self.here().map_or("", |prepared| prepared.program.source().name()).into()
    }
}
