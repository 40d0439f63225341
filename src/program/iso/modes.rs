//! `G90` and `G91` in the order of the run: what acts where a block is reached, through calls, repeats and jumps.
//!
//! Invariant: only labels, jumps and the ends of programs are followed; where a program is too long or too tangled for
//! that, nothing is said and the order of the text counts.
use std::collections::HashMap;

use crate::base::diag::Span;
use crate::program::syntax::{Block, BlockKind, IsoBlock, IsoKind, MFunction, NamedWord, Program, ValueKind};

/// Subprograms are called this deep at most; the controls allow 8 levels (TNC 640) or less.
const DEEPEST: usize = 12;
/// Each block is followed this often at most, on average.
const MOST: usize = 24;

/// Which of `G90` and `G91` may act.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Modes {
    absolute: bool,
    incremental: bool,
}

impl Modes {
    fn add(&mut self, absolute: bool) -> bool {
        let own = if absolute { &mut self.absolute } else { &mut self.incremental };
        !std::mem::replace(own, true)
    }

    fn all(self) -> impl Iterator<Item = bool> {
        [(self.absolute, true), (self.incremental, false)].into_iter().filter_map(|(has, which)| has.then_some(which))
    }

    /// The only one that acts.
    fn only(self) -> Option<bool> {
        (self.absolute != self.incremental).then_some(self.absolute)
    }
}

/// What acts at each block.
pub(super) struct InRun {
    /// Where a block is reached with: in the run, nothing if it never is.
    reached: Vec<Modes>,
    /// As the text says, each subprogram being begun as it is called.
    written: Vec<bool>,
}

impl InRun {
    /// Whether `G90` acts when the block is reached; nothing if the order of the text has to say it.
    pub(super) fn absolute(&self, index: usize) -> Option<bool> {
        self.reached.get(index)?.only()
    }

    /// Whether `G90` acts by the text before the block.
    pub(super) fn written(&self, index: usize) -> bool {
        self.written.get(index).copied().unwrap_or(true)
    }

    /// Whether a block whose coordinates follow what acts is reached with something else than the text before it says.
    pub(super) fn differs(&self, index: usize) -> bool {
        let written = self.written.get(index).copied();
        let reached = self.reached.get(index).copied().unwrap_or_default();
        written.is_some_and(|written| reached.all().any(|mode| mode != written))
    }
}

/// Follows a program; nothing if it has no `G91` or cannot be followed.
pub(super) fn in_run(program: &Program) -> Option<InRun> {
    let steps: Vec<Step> = program.blocks().iter().map(|block| step(program, block)).collect();
    let is_incremental = |step: &Step| step.sets == Some(false);
    if !steps.iter().any(is_incremental) || !steps.iter().any(|step| matches!(step.goes, Goes::Call(_) | Goes::Jump(_)))
    {
        return None;
    }
    let mut labels = HashMap::new();
    for (index, step) in steps.iter().enumerate() {
        if let Goes::Label(name) = step.goes {
            labels.entry(name).or_insert(index);
        }
    }
    let mut walk = Walk {
        steps: &steps,
        labels,
        reached: vec![Modes::default(); steps.len()],
        left: HashMap::new(),
        budget: steps.len().saturating_mul(MOST),
    };
    walk.follow(0, true, 0)?;
    let reached = walk.reached;
    let written = written(&steps, &reached);
    Some(InRun { reached, written })
}

/// What acts at each block by the text alone.
fn written(steps: &[Step<'_>], reached: &[Modes]) -> Vec<bool> {
    let (mut absolute, mut ended) = (true, false);
    let own = |(step, reached): (&Step<'_>, &Modes)| {
        if ended && matches!(step.goes, Goes::Label(_)) {
            // Nothing goes on from the text before: a subprogram begins with what acts where it is called.
            absolute = reached.all().next().unwrap_or(absolute);
        }
        ended = matches!(step.goes, Goes::Back | Goes::End) || (ended && !matches!(step.goes, Goes::Label(_)));
        let before = absolute;
        absolute = step.sets.unwrap_or(absolute);
        before
    };
    steps.iter().zip(reached).map(own).collect()
}

/// What a block does to the way through the program.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Goes<'p> {
    On,
    /// The beginning of a label.
    Label(&'p str),
    /// The end of a subprogram.
    Back,
    /// The end of the program.
    End,
    Call(&'p str),
    /// A repeat or a conditional jump.
    Jump(&'p str),
}

struct Step<'p> {
    goes: Goes<'p>,
    /// What acts from here on.
    sets: Option<bool>,
}

fn step<'p>(program: &'p Program, block: &Block) -> Step<'p> {
    let ends = |functions: &[MFunction]| functions.iter().any(|function| matches!(function.number, 2 | 30));
    let own = match &block.kind {
        BlockKind::Iso(own) => own,
        BlockKind::EndPgm(_) => return Step { goes: Goes::End, sets: None },
        BlockKind::Functions(functions) if ends(functions) => return Step { goes: Goes::End, sets: None },
        _ => return Step { goes: Goes::On, sets: None },
    };
    let word = |name: &str| own.words.iter().find(|word| is(program, word, name));
    let name = |word: &NamedWord| label(program, word.value.span);
    let label = word("L").map(name).unwrap_or_default();
    let goes = match own.kind {
        IsoKind::Label if label == "0" => Goes::Back,
        IsoKind::Label => Goes::Label(label),
        IsoKind::CallLabel => match word(",") {
            Some(times) if times.value.kind != ValueKind::Number(0.0) => Goes::Jump(label),
            _ => Goes::Call(label),
        },
        IsoKind::Function(9..=12) => word("P03").map(name).map_or(Goes::On, Goes::Jump),
        _ if ends(&own.functions) => Goes::End,
        _ => Goes::On,
    };
    Step { goes, sets: sets(program, own) }
}

fn is(program: &Program, word: &NamedWord, name: &str) -> bool {
    program.slice(word.name).eq_ignore_ascii_case(name)
}

fn label(program: &Program, span: Span) -> &str {
    program.slice(span).trim().trim_matches('"').trim_start_matches('+')
}

/// What a block sets: the last code in it. The first corner of the blank is always absolute and leaves what acts.
fn sets(program: &Program, own: &IsoBlock) -> Option<bool> {
    let code = |word: &NamedWord| match word.value.kind {
        ValueKind::Number(number) if is(program, word, "G") => Some(number),
        _ => None,
    };
    let mut codes = own.words.iter().filter_map(code);
    let last = codes.rfind(|number| *number == 90.0 || *number == 91.0).filter(|_| own.kind != IsoKind::Blank(1));
    last.map(|number| number == 90.0)
}

struct Walk<'a> {
    steps: &'a [Step<'a>],
    labels: HashMap<&'a str, usize>,
    reached: Vec<Modes>,
    /// What a subprogram leaves in effect, by its first block and by what acts where it is called. Nothing yet while it is
    /// being followed: from a call of itself it does not come back.
    left: HashMap<(usize, bool), Modes>,
    budget: usize,
}

impl Walk<'_> {
    /// Follows the program from a block to the ends of the subprogram; what acts there. Nothing if it takes too long.
    fn follow(&mut self, start: usize, absolute: bool, depth: usize) -> Option<Modes> {
        let mut left = Modes::default();
        let mut been: HashMap<usize, Modes> = HashMap::new();
        let mut open = vec![(start, absolute)];
        while let Some((index, absolute)) = open.pop() {
            let Some(step) = self.steps.get(index) else { continue };
            if !been.entry(index).or_default().add(absolute) {
                continue;
            }
            self.budget = self.budget.checked_sub(1)?;
            self.reached.get_mut(index)?.add(absolute);
            let after = step.sets.unwrap_or(absolute);
            match step.goes {
                Goes::On | Goes::Label(_) => open.push((index + 1, after)),
                // Outside of a subprogram it does nothing.
                Goes::Back if depth == 0 => open.push((index + 1, after)),
                Goes::Back => {
                    left.add(after);
                }
                Goes::End => {}
                Goes::Jump(name) => {
                    open.push((index + 1, after));
                    open.extend(self.labels.get(name).map(|target| (*target, after)));
                }
                Goes::Call(name) => {
                    let after = self.call(name, after, depth)?;
                    open.extend(after.all().map(|mode| (index + 1, mode)));
                }
            }
        }
        Some(left)
    }

    /// What acts after a call.
    fn call(&mut self, name: &str, absolute: bool, depth: usize) -> Option<Modes> {
        let mut same = Modes::default();
        same.add(absolute);
        let Some(target) = self.labels.get(name).copied() else { return Some(same) };
        if depth >= DEEPEST {
            return None;
        }
        if let Some(left) = self.left.get(&(target, absolute)) {
            return Some(*left);
        }
        self.left.insert((target, absolute), Modes::default());
        let left = self.follow(target, absolute, depth + 1)?;
        self.left.insert((target, absolute), left);
        Some(left)
    }
}
