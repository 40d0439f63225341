//! Any text is a table or an error; a table comes back as it was, and a changed cell is read back.
#![no_main]
use ciklo::base::diag::Source;
use ciklo::program::table::{Cell, Table, TableKind};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    for kind in [TableKind::Tool, TableKind::Probe, TableKind::Preset, TableKind::Datum, TableKind::Points] {
        let Ok(mut table) = Table::parse(kind, &Source::new("FUZZ.T", text)) else { continue };
        assert_eq!(table.to_text(), text);
        let rows: Vec<f64> = table.rows().collect();
        let columns: Vec<String> = table.columns().map(str::to_owned).collect();
        for row in rows.into_iter().take(3) {
            for column in columns.iter().take(3) {
                if table.set(row, column, &Cell::Number(1.5)).is_ok() {
                    assert!(table.get(row, column).is_ok());
                }
            }
        }
    }
});
