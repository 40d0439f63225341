//! The part that a case expects: what is left of the blank at some places of it.
//!
//! Invariant: columns are exact in height, so a place is judged by the column nearest to it and must not lie beside a wall.
use super::expect::Reader;
use super::report::{Mismatch, Verdict};
use super::show;
use crate::base::diag::Diagnostic;
use crate::engine::scene::Scene;
use crate::engine::stock::{Machining, Stock};
use crate::program::syntax::Program;
use crate::spec::Node;

/// How far heights may differ, mm.
const WITHIN: f64 = 1e-6;
/// The greatest size of a cell of the grid, mm.
const CELL: f64 = 0.5;

/// What is left at a place.
#[derive(Clone, Debug)]
struct Column {
    /// Main and secondary axis of the blank.
    at: [f64; 2],
    /// Stretches of material, from low to high.
    is: Vec<[f64; 2]>,
}

/// The part that a case expects.
#[derive(Clone, Debug)]
pub(super) struct Part(Vec<Column>);

impl Part {
    /// Reads a list of `{at: [X, Y], is: [[from, to], …]}`.
    pub(super) fn read(node: &Node, r: &mut Reader<'_>) -> Self {
        let columns = r.items(node).iter().filter_map(|item| {
            r.entries(item, Some(&["at", "is"]));
            let (Some(at), Some(is)) = (item.get("at"), item.get("is")) else {
                r.expected(item, "column");
                return None;
            };
            let is = r.items(is).iter().filter_map(|stretch| pair(stretch, r)).collect();
            Some(Column { at: pair(at, r)?, is })
        });
        Self(columns.collect())
    }

    /// Follows a run, from before its first event.
    ///
    /// # Errors
    /// There is no blank.
    pub(super) fn follow(program: &Program, scene: &Scene) -> Result<Machining, Diagnostic> {
        Machining::new(program, scene, Some(CELL)).map_err(|trouble| trouble.diagnostic_in(program, scene))
    }

    /// Adds to the verdict on a run that came to its end what the part differs in.
    pub(super) fn add_to(&self, verdict: &mut Verdict, machining: Machining) {
        let mut differs = match verdict {
            Verdict::Fail { mismatches } => std::mem::take(mismatches),
            Verdict::Pass => Vec::new(),
            Verdict::OutOfSubset { .. } | Verdict::Skipped { .. } => return,
        };
        self.compare(machining, &mut differs);
        if !differs.is_empty() {
            *verdict = Verdict::Fail { mismatches: differs };
        }
    }

    /// What differs, and whatever was found while it was machined.
    fn compare(&self, machining: Machining, differs: &mut Vec<Mismatch>) {
        let (stock, report) = machining.finish();
        for finding in &report.findings {
            differs.push(Mismatch::new(
                format!("part.line.{}", finding.line),
                show::nothing(),
                format!("{} {}", finding.kind.as_str(), show::number(finding.amount)),
            ));
        }
        for column in &self.0 {
            let found = nearest(&stock, column.at);
            let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs() <= WITHIN && (a[1] - b[1]).abs() <= WITHIN;
            if found.len() != column.is.len() || !found.iter().zip(&column.is).all(|(a, b)| near(a, b)) {
                let what = format!("part.{}.{}", column.at[0], column.at[1]);
                differs.push(Mismatch::new(what, shown(&column.is), shown(&found)));
            }
        }
    }
}

fn pair(node: &Node, r: &mut Reader<'_>) -> Option<[f64; 2]> {
    let [a, b] = r.items(node) else {
        r.expected(node, "pair");
        return None;
    };
    Some([r.number(a)?, r.number(b)?])
}

/// The material in the column whose middle is nearest to a place.
fn nearest(stock: &Stock, at: [f64; 2]) -> Vec<[f64; 2]> {
    let (columns, rows) = stock.size();
    let first = stock.place(0, 0);
    let index = |axis: usize, count: usize| {
        let steps = (at[axis] - first[axis]) / stock.cell()[axis];
        (steps.round().max(0.0) as usize).min(count.saturating_sub(1))
    };
    stock.column(index(0, columns), index(1, rows))
}

fn shown(stretches: &[[f64; 2]]) -> String {
    let all: Vec<String> =
        stretches.iter().map(|[from, to]| format!("{} to {}", show::number(*from), show::number(*to))).collect();
    show::list(&all)
}
