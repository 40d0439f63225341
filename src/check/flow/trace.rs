//! The one way of a run that nothing leaves open: what loops that count leave behind is known on it.
//!
//! Invariant: it ends where a decision is not certain, and after so many blocks.
use std::collections::{BTreeMap, HashMap};

use super::graph::{End, Graph, Way, reads};
use super::state::{Known, State};
use super::step::{Steps, value};
use crate::syntax::BlockKind;

/// How many blocks it goes beyond four times those of the program.
const PATIENCE: usize = 20_000;

/// The numbers that blocks read, by the place of the value; nothing of those that are read with several.
pub(super) fn numbers(steps: &Steps<'_, '_>, graph: &Graph, mut state: State) -> BTreeMap<usize, Option<f64>> {
    let mut found = BTreeMap::new();
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
            let known = found.entry(span.start).or_insert(number);
            *known = known.filter(|known| number == Some(*known));
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
