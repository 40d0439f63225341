//! What is worth knowing about the machining of a part.
//!
//! Invariant: the report does not grow with the number of moves.
use serde_json::{Map, Value, json};

use crate::engine::region::section::{Cell, Side};
use crate::engine::report::event::{At, FindingKind};

/// The version of the JSON form.
pub(super) const FORMAT: &str = "ciklo-stock/1";
/// Findings that are kept one by one; further ones are counted.
const KEPT: usize = 100;

/// Something that was found at a place of the program; repetitions there are counted.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What.
    pub kind: FindingKind,
    /// The physical line of the program, from 1.
    pub line: usize,
    /// The file name of the program.
    pub program: std::sync::Arc<str>,
    /// The greatest amount there.
    pub amount: f64,
    /// How many moves.
    pub count: u64,
}

/// The greatest of something and where it was.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Greatest {
    /// The value.
    pub value: f64,
    /// The physical line of the program; 0 if there was nothing.
    pub line: usize,
}

impl Greatest {
    pub(super) fn note(&mut self, value: f64, line: usize) {
        if value > self.value {
            *self = Self { value, line };
        }
    }
}

/// The report. Lengths mm, volumes mm³, times seconds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Time at feed.
    pub time_feed: f64,
    /// Time at rapid traverse.
    pub time_rapid: f64,
    /// Time of dwells.
    pub time_dwell: f64,
    /// Way at feed.
    pub length_feed: f64,
    /// Way at rapid traverse.
    pub length_rapid: f64,
    /// Way of the moves at feed that cut.
    pub length_cut: f64,
    /// Moves.
    pub moves: u64,
    /// Moves at feed that cut.
    pub cuts: u64,
    /// Volume of the blank.
    pub blank: f64,
    /// Volume taken away.
    pub removed: f64,
    /// The greatest height that a piece of a move took away from a column.
    pub depth: Greatest,
    /// The greatest width that was cut across the path.
    pub width: Greatest,
    /// The greatest volume in a minute, mm³/min.
    pub rate: Greatest,
    /// What was found, in the order of the program's execution.
    pub findings: Vec<Finding>,
    /// Findings that were not kept.
    pub more: u64,
    /// The half section of what was turned, if something was: its cells in the order of the rotary axis.
    pub turned: Option<Vec<Cell>>,
}

impl Report {
    pub(super) fn find(&mut self, kind: FindingKind, at: &Place, amount: f64) {
        let same = |known: &&mut Finding| known.kind == kind && known.line == at.line && known.program == at.program;
        if let Some(known) = self.findings.iter_mut().find(same) {
            known.amount = known.amount.max(amount);
            known.count += 1;
        } else if self.findings.len() < KEPT {
            let program = at.program.clone();
            self.findings.push(Finding { kind, line: at.line, program, amount, count: 1 });
        } else {
            self.more += 1;
        }
    }

    /// A report in which there is something of everything.
    pub fn example() -> Self {
        let finding = |kind| Finding { kind, line: 1, program: "PART.H".into(), amount: 0.0, count: 1 };
        Self { findings: FindingKind::ALL.into_iter().map(finding).collect(), ..Self::default() }
    }

    /// The report as JSON (`docs/stock.md`).
    pub fn to_json(&self) -> Value {
        let greatest = |greatest: &Greatest| {
            let line = (greatest.line > 0).then_some(greatest.line);
            json!({"value": greatest.value, "line": line})
        };
        let findings = self.findings.iter().map(|finding| {
            let mut entry = Map::new();
            entry.insert("finding".into(), finding.kind.as_str().into());
            entry.insert("program".into(), (&*finding.program).into());
            entry.insert("line".into(), finding.line.into());
            entry.insert("amount".into(), finding.amount.into());
            entry.insert("count".into(), finding.count.into());
            Value::Object(entry)
        });
        let mut whole = json!({
            "format": FORMAT,
            "time": {"feed": self.time_feed, "rapid": self.time_rapid, "dwell": self.time_dwell},
            "length": {"feed": self.length_feed, "rapid": self.length_rapid, "cut": self.length_cut},
            "moves": self.moves,
            "cuts": self.cuts,
            "volume": {"blank": self.blank, "removed": self.removed},
            "greatest": {
                "depth": greatest(&self.depth),
                "width": greatest(&self.width),
                "rate": greatest(&self.rate),
            },
            "findings": findings.collect::<Vec<_>>(),
            "more": self.more,
        });
        if let (Some(cells), Value::Object(members)) = (&self.turned, &mut whole) {
            members.insert("turned".into(), cells.iter().map(cell).collect());
        }
        whole
    }
}

/// A cell of a half section as JSON.
fn cell(cell: &Cell) -> Value {
    let side = |side: &Side| {
        let circle = side.circle.map(|(centre, upper)| json!({"z": centre.x, "radius": centre.y, "upper": upper}));
        json!({"radius": side.ends, "centre": circle})
    };
    let [inner, outer] = &cell.sides();
    json!({"z": cell.range(), "inner": side(inner), "outer": side(outer)})
}

/// Where in a program something belongs.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub line: usize,
    pub program: std::sync::Arc<str>,
}

impl Place {
    pub(super) fn of(at: &At) -> Self {
        Self { line: at.line, program: at.program.clone() }
    }
}
