//! Kinematics as text: machine files that are written, and the memories in which kinematics are kept.
//!
//! Invariant: what is written here is read again as the same machine, to the last bit.
use std::fmt::Write as _;

use glam::DVec3;

use super::{Carried, Machine};
use crate::engine::read::Reader;
use crate::spec::Node;

/// Any one character, one letter, one digit, any chain of characters (001:14074-14079).
const ANY: char = '?';
const LETTER: char = '$';
const DIGIT: char = '#';
const CHAIN: char = '*';

/// Kinematics that were saved.
#[derive(Clone, Debug, PartialEq)]
pub struct SavedKinematics {
    /// The name or number of the memory.
    pub name: String,
    /// When it was saved, as logs write it.
    pub saved: String,
    /// What was saved.
    pub machine: Machine,
}

/// What the log says of saving, restoring, showing and deleting.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MemoryReport {
    /// The name or number that was entered.
    pub name: String,
    /// The kinematics before; also what was saved.
    pub before: Option<Machine>,
    /// The kinematics after they were restored.
    pub after: Option<Machine>,
    /// Names and times of memories: all of them, or those that were chosen.
    pub memories: Vec<(String, String)>,
}

/// Whether a name fits a pattern with wildcards: `?` any character, `$` a letter, `#` a digit, `*` any chain.
pub fn matches(pattern: &str, name: &str) -> bool {
    let pattern: Vec<char> = pattern.chars().collect();
    // Whether the first letters of the name fit the pattern so far.
    let name: Vec<char> = name.chars().collect();
    let mut fits = vec![false; name.len() + 1];
    fits[0] = true;
    for wanted in pattern {
        let before = fits.clone();
        let mut any = false;
        for (at, fit) in fits.iter_mut().enumerate() {
            any |= before[at];
            let one = |is: fn(char) -> bool| at > 0 && before[at - 1] && is(name[at - 1]);
            *fit = match wanted {
                CHAIN => any,
                ANY => one(|_| true),
                LETTER => one(char::is_alphabetic),
                DIGIT => one(|sign| sign.is_ascii_digit()),
                letter => at > 0 && before[at - 1] && name[at - 1] == letter,
            };
        }
    }
    fits.last().copied().unwrap_or_default()
}

impl SavedKinematics {
    /// The memories as a file that a scene can hold again as `saved`.
    pub fn file(all: &[Self]) -> String {
        let mut text = String::new();
        for one in all {
            let _ = writeln!(text, "- name: {:?}\n  saved: {:?}\n  machine:", one.name, one.saved);
            for line in one.machine.to_yaml().lines() {
                let _ = writeln!(text, "    {line}");
            }
        }
        if text.is_empty() {
            text.push_str("[]\n");
        }
        text
    }

    /// Reads memories.
    pub(in crate::engine) fn read_all(list: &Node, reader: &mut Reader<'_>) -> Vec<Self> {
        let mut all = Vec::new();
        for item in reader.items(list) {
            reader.only_keys(item, &["name", "saved", "machine"]);
            let name = reader.need(item, "name").and_then(|node| reader.text(node)).map(str::to_owned);
            let saved = item.get("saved").and_then(|node| reader.text(node)).unwrap_or_default().to_owned();
            let machine = reader.need(item, "machine").and_then(|node| Machine::read(node, reader));
            if let (Some(name), Some(machine)) = (name, machine) {
                all.push(Self { name, saved, machine });
            }
        }
        all
    }
}

fn vector(v: DVec3) -> String {
    format!("[{}, {}, {}]", v.x, v.y, v.z)
}

impl Machine {
    /// The machine as a machine file.
    pub fn to_yaml(&self) -> String {
        let mut text = format!("machine: 1\nname: {:?}\nspindle: {}\naxes:\n", self.name, self.spindle.letter());
        for axis in &self.axes {
            let _ = writeln!(
                text,
                "  - {{axis: {}, min: {}, max: {}, rapid: {}, acceleration: {}}}",
                axis.axis.letter(),
                axis.min,
                axis.max,
                axis.rapid,
                axis.acceleration
            );
        }
        if !self.parallel.is_empty() {
            text.push_str("parallel:\n");
        }
        for axis in &self.parallel {
            let (letter, min, max, rapid) = (axis.letter, axis.min, axis.max, axis.rapid);
            let _ = writeln!(text, "  - {{axis: {letter}, min: {min}, max: {max}, rapid: {rapid}}}");
        }
        if !self.rotary.is_empty() {
            text.push_str("rotary:\n");
        }
        for axis in &self.rotary {
            let carries = if axis.carries == Carried::Workpiece { "workpiece" } else { "tool" };
            let sense = if axis.about.1 < 0.0 { "-" } else { "" };
            let _ = write!(
                text,
                "  - {{axis: {}, carries: {carries}, about: {sense}{}",
                axis.axis.letter(),
                axis.about.0.letter()
            );
            if let Some((min, max)) = axis.limits {
                let _ = write!(text, ", min: {min}, max: {max}");
            }
            if let Some(grid) = axis.hirth {
                let _ = write!(text, ", hirth: {grid}");
            }
            if axis.is_measured_at_motor {
                text.push_str(", encoder: motor");
            }
            let (centre, askew) = (vector(axis.centre), vector(axis.askew));
            let _ = writeln!(text, ", rapid: {}, centre: {centre}, askew: {askew}}}", axis.rapid);
        }
        let _ = writeln!(text, "pivot: {}\nbase: {}", self.pivot, vector(self.base));
        if let Some(datum) = self.second_datum {
            let _ = writeln!(text, "second_datum: {}", vector(datum));
        }
        text
    }

    /// Whether another one has the same axes in the same order: only where they turn may differ.
    pub fn is_same_description(&self, other: &Self) -> bool {
        let axes = |machine: &Self| -> Vec<_> {
            machine.rotary.iter().map(|axis| (axis.axis, axis.carries, axis.about)).collect()
        };
        self.name == other.name && axes(self) == axes(other)
    }

    /// The same machine with the mean of what several have as places and directions of their axes; of the first where
    /// there is only one.
    #[must_use]
    pub fn with_mean_of(&self, others: &[Self]) -> Self {
        let count = others.len() as f64;
        let mut mean = self.clone();
        if others.is_empty() {
            return mean;
        }
        for axis in &mut mean.rotary {
            let known = || others.iter().filter_map(|other| other.rotary(axis.axis));
            let centre = known().map(|known| known.centre).sum::<DVec3>() / count;
            let askew = known().map(|known| known.askew).sum::<DVec3>() / count;
            (axis.centre, axis.askew) = (centre, askew);
        }
        mean.base = others.iter().map(|other| other.base).sum::<DVec3>() / count;
        mean
    }
}
