//! Label tables: every label of a control in a language, for translation tools.
use serde::Serialize;

use crate::base::diag::Diagnostic;
use crate::language::locale::Language;
use crate::language::text::{CycleText, with_texts};
use crate::spec::OnControl;

/// A row of a label table.
#[derive(Clone, Debug, Serialize)]
pub struct LabelRow {
    /// `Q200`, or `31.2 height` for a field of the old form.
    pub q: String,
    /// The meaning in the dictionary.
    pub concept: String,
    /// The key of the cycle.
    pub cycle: String,
    /// The name of the parameter.
    pub name: String,
    /// The label; nothing for fields without a printed word.
    pub label: Option<String>,
    /// Printed variants of it.
    pub aliases: Vec<String>,
}

/// All labels of a control, by cycle, in the order of the dialogs.
///
/// # Errors
/// Every text that is missing.
pub fn table(on: &OnControl, language: &Language) -> Result<Vec<LabelRow>, Vec<Diagnostic>> {
    let mut rows = Vec::new();
    let mut faults = Vec::new();
    for cycle in on.cycles.values() {
        match with_texts(on, cycle, language, rows_of) {
            Ok(more) => rows.extend(more),
            Err(more) => faults.extend(more),
        }
    }
    if faults.is_empty() { Ok(rows) } else { Err(faults) }
}

fn rows_of(text: &CycleText) -> Vec<LabelRow> {
    let row = |param| {
        let texts = text.param(param);
        LabelRow {
            q: texts.q,
            concept: param.is.as_str().to_owned(),
            cycle: text.cycle.key.to_string(),
            name: texts.name.into_owned(),
            label: texts.label.map(std::borrow::Cow::into_owned),
            aliases: texts.label_aliases,
        }
    };
    text.cycle.params.iter().map(row).collect()
}

/// The table as CSV (RFC 4180, with a head line); aliases are separated by ` | `.
pub fn csv(rows: &[LabelRow]) -> String {
    let mut csv = String::from("q,concept,cycle,name,label,aliases\r\n");
    for row in rows {
        let aliases = row.aliases.join(" | ");
        let label = row.label.as_deref().unwrap_or_default();
        let cells = [row.q.as_str(), &row.concept, &row.cycle, &row.name, label, &aliases];
        csv.push_str(&cells.map(cell).join(","));
        csv.push_str("\r\n");
    }
    csv
}

fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
