//! The one way of a run that nothing leaves open: what loops that count leave after is known on it.
//!
//! Invariant: it ends where a decision is not certain, and after so many blocks.
use std::collections::{BTreeMap, HashMap};

use super::graph::{End, Graph, Way};
use super::state::{Known, State};
use super::step::{Steps, value};
use crate::check::program::reads;
use crate::program::syntax::BlockKind;

/// How many blocks it goes beyond four times those of the program.
const PATIENCE: usize = 20_000;

/// So many passes are distinguished; of more the last one stands for those after.
const PASSES: usize = 16;

/// The numbers with which a value is read, pass by pass: there is one at least.
#[derive(Debug)]
pub(super) struct Passes(Vec<Option<f64>>);

impl Passes {
    /// The number, if it is known and the same each time.
    pub(super) fn only(&self) -> Option<f64> {
        let first = *self.0.first()?;
        first.filter(|_| self.0.iter().all(|own| *own == first))
    }

    /// The numbers, if all are known and not all are the same.
    pub(super) fn several(self) -> Option<Vec<f64>> {
        if self.only().is_some() { None } else { self.0.into_iter().collect() }
    }

    fn add(&mut self, number: Option<f64>) {
        if self.0.len() < PASSES {
            self.0.push(number);
        } else if let Some(last) = self.0.last_mut() {
            *last = number;
        }
    }
}

/// The numbers that blocks read, by the place of the value.
pub(super) fn numbers(steps: &Steps<'_, '_>, graph: &Graph, mut state: State) -> BTreeMap<usize, Passes> {
    let mut found: BTreeMap<usize, Passes> = BTreeMap::new();
    // Without a loop or a jump all of that is known.
    if !graph.uses.iter().any(|own| matches!(own.way, Way::Repeat | Way::Jump)) {
        return found;
    }
    let blocks = steps.program.blocks();
    let (mut read, mut back) = (Vec::new(), Vec::new());
    let mut repeats: HashMap<usize, f64> = HashMap::new();
    let mut patience = blocks.len().saturating_mul(4).saturating_add(PATIENCE);
    let mut index = 0;
    while let Some(block) = blocks.get(index).filter(|block| !block.skip && patience > 0) {
        patience -= 1;
        read.clear();
        reads(block, &mut read);
        for (q, span) in &read {
            let number = match state.get(*q) {
                Known::Number(number) => Some(number),
                Known::Unset | Known::Unknown => None,
            };
            found.entry(span.start).or_insert_with(|| Passes(Vec::with_capacity(1))).add(number);
        }
        let here = index;
        index += 1;
        let at = match graph.end(here, block) {
            End::Next => {
                steps.step(here, block, &mut state);
                continue;
            }
            End::Stop => break,
            End::Return => {
                index = back.pop().unwrap_or(index);
                continue;
            }
            End::Use(at) => at,
        };
        let Some(own) = graph.uses.get(at) else { break };
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        let follows = match &block.kind {
            BlockKind::CallLbl(call) => match call.repeat.as_ref().map(|repeat| value(repeat, &state)) {
                None => {
                    back.push(index);
                    true
                }
                Some(Known::Number(times)) => {
                    let left = repeats.entry(here).or_insert(times);
                    let again = *left >= 1.0;
                    *left -= 1.0;
                    if !again {
                        repeats.remove(&here);
                    }
                    again
                }
                Some(_) => break,
            },
            BlockKind::FnJump(jump) => match (value(&jump.a, &state), value(&jump.b, &state)) {
                (Known::Number(a), Known::Number(b)) => match jump.relation.holds(a, b) {
                    Some(holds) => holds,
                    None => break,
                },
                _ => break,
            },
            _ => break,
        };
        if follows {
            let Some(target) = target else { break };
            index = target;
        }
    }
    found
}
