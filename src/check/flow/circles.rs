//! Which parts of a program call each other in a circle.
//!
//! Invariant: each call is looked at once, however deep calls are nested.

/// For each of some nodes the number of the group of those that lead to each other, by what each leads to. Groups are
/// numbered so that one leads only to itself and to lower ones.
pub fn circles(inner: &[Vec<usize>]) -> Vec<usize> {
    const NEW: usize = usize::MAX;
    // When each node was come to, the earliest open one that it leads back to, and its group.
    let (mut came, mut back, mut group) = (vec![NEW; inner.len()], vec![NEW; inner.len()], vec![NEW; inner.len()]);
    let (mut open, mut way, mut time, mut groups) = (Vec::new(), Vec::new(), 0, 0);
    for start in 0..inner.len() {
        if came[start] != NEW {
            continue;
        }
        way.push((start, 0));
        while let Some((node, next)) = way.pop() {
            if next == 0 {
                (came[node], back[node]) = (time, time);
                time += 1;
                open.push(node);
            }
            let Some(to) = inner[node].get(next).copied() else {
                if back[node] == came[node] {
                    while let Some(own) = open.pop() {
                        group[own] = groups;
                        if own == node {
                            break;
                        }
                    }
                    groups += 1;
                }
                if let Some((before, _)) = way.last() {
                    back[*before] = back[*before].min(back[node]);
                }
                continue;
            };
            way.push((node, next + 1));
            if came[to] == NEW {
                way.push((to, 0));
            } else if group[to] == NEW {
                back[node] = back[node].min(came[to]);
            }
        }
    }
    group
}
