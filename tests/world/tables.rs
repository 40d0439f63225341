//! Tables in the controls' file format: what is read, what is written, what is refused.
use ciklo::diag::Source;
use ciklo::engine::table::{Cell, Table, TableError, TableKind};
use proptest::prelude::*;

const PRESETS: &str = "\
BEGIN PRESET .PR MM\r
NO  DOC        X          Y          SPC\r
0   SÄÄTÖ      +1.5       -20,25     -\r
7   PÖYTÄ B    100\r
[END]\r
";

fn presets() -> Table {
    Table::parse(TableKind::Preset, &Source::new("TNC:\\table\\PRESET.PR", PRESETS)).expect("a sound table")
}

#[test]
fn reads_numbers_and_text_by_row_and_column() {
    let table = presets();
    assert_eq!(table.rows().collect::<Vec<_>>(), [0.0, 7.0]);
    assert_eq!(table.number(0.0, "X"), Ok(Some(1.5)));
    assert_eq!(table.number(0.0, "Y"), Ok(Some(-20.25)));
    assert_eq!(table.get(0.0, "SPC"), Ok(Cell::Empty));
    assert_eq!(table.get(7.0, "SPC"), Ok(Cell::Empty));
    assert_eq!(table.text(7.0, "DOC"), Ok("PÖYTÄ B"));
    assert_eq!(table.find("DOC", "PÖYTÄ B"), Ok(Some(7.0)));
    assert!(table.is_named("preset.pr"));
}

#[test]
fn an_untouched_table_gives_back_its_text() {
    assert_eq!(presets().to_text(), PRESETS);
}

#[test]
fn a_change_touches_its_cell_only() {
    let mut table = presets();
    table.set(0.0, "X", &Cell::Number(-2.125)).expect("room");
    table.set(7.0, "SPC", &Cell::Number(30.0)).expect("room");
    let expected = PRESETS.replace("+1.5  ", "-2.125").replace("100\r", "100                   30\r");
    assert_eq!(table.to_text(), expected);
    assert_eq!(table.number(0.0, "X"), Ok(Some(-2.125)));
}

#[test]
fn a_table_is_laid_out_in_its_columns() {
    let laid_out = |text: &str| {
        let table = Table::parse(TableKind::Preset, &Source::new("PRESET.PR", text)).expect("a sound table");
        table.laid_out()
    };
    let crooked = PRESETS.replace("+1.5       -20,25", "  +1.5         -20,25").replace("    100", "      100   ");
    let crooked = crooked.replace("  +1.5         -20,25     -", "  +1.5      -20,25      -  ");
    assert_ne!(crooked, PRESETS);
    assert_eq!(laid_out(&crooked), PRESETS);
    assert_eq!(laid_out(PRESETS), PRESETS);
}

#[test]
fn rows_are_added_in_order() {
    let mut table = presets();
    table.add_row(3.0).expect("room");
    table.add_row(9.0).expect("room");
    table.set(3.0, "Y", &Cell::Number(0.5)).expect("room");
    let rows = "0   SÄÄTÖ      +1.5       -20,25     -\r\n3                         0.5\r\n7   PÖYTÄ B    100\r\n9\r\n[END]\r\n";
    assert!(table.to_text().ends_with(rows), "{}", table.to_text());
    let again = Table::parse(TableKind::Preset, &Source::new("PRESET.PR", table.to_text())).expect("a sound table");
    assert_eq!(again.rows().collect::<Vec<_>>(), [0.0, 3.0, 7.0, 9.0]);
}

#[test]
fn refusals_are_values() {
    let mut table = presets();
    let file = "TNC:\\table\\PRESET.PR".to_owned();
    assert_eq!(table.number(5.0, "X"), Err(TableError::NoRow { file: file.clone(), row: 5.0 }));
    assert_eq!(table.number(0.0, "Q"), Err(TableError::NoColumn { file, column: "Q".to_owned() }));
    let long = Cell::Text("TWELVE CHARS".to_owned());
    assert_eq!(table.set(0.0, "DOC", &long).map_err(|e| e.code()), Err("table-too-wide"));
    assert_eq!(table.set(0.0, "NO", &Cell::Number(1.0)).map_err(|e| e.code()), Err("table-key-column"));
    assert_eq!(table.set(0.0, "X", &long).map_err(|e| e.code()), Err("table-text-in-numbers"));
    assert_eq!(table.set(0.0, "X", &Cell::Number(1e30)).map_err(|e| e.code()), Err("table-too-wide"));
    assert_eq!(table.set(0.0, "X", &Cell::Number(f64::NAN)).map_err(|e| e.code()), Err("table-too-wide"));
    assert_eq!(table.to_text(), PRESETS);
}

#[test]
fn mistakes_are_told_together_with_their_places() {
    let text = "BEGIN TOOL.T MM\nT   NAME   R\n1   MILL   5\nX   DRILL  3\n1   AGAIN  5,0,1\n";
    let found = Table::parse(TableKind::Tool, &Source::new("TOOL.T", text)).expect_err("mistakes");
    let found: Vec<_> = found
        .iter()
        .map(|d| (d.code, d.place.as_ref().map(|p| (p.start().line, p.start().column)).unwrap_or_default()))
        .collect();
    let expected = [
        ("table-no-end", (6, 1)),
        ("table-no-row-number", (4, 1)),
        ("table-duplicate-row", (5, 1)),
        ("table-bad-number", (5, 12)),
    ];
    assert_eq!(found, expected);
    let codes = |text: &str| {
        let found = Table::parse(TableKind::Datum, &Source::new("X.D", text)).expect_err("mistakes");
        found.iter().map(|d| d.code).collect::<Vec<_>>()
    };
    assert_eq!(codes(""), ["table-no-header", "table-no-heading"]);
    assert_eq!(codes("BEGIN X.D MM\nA B C\n[END]"), ["table-no-heading"]);
}

#[test]
fn inches_are_converted() {
    let text = "BEGIN X.D INCH\nD  X        C\n1  0.5      90\n[END]\n";
    let mut table = Table::parse(TableKind::Datum, &Source::new("X.D", text)).expect("a sound table");
    // 0.5 inch are 12.7 mm; 6.35 mm are 0.25 inch.
    assert_eq!(table.number(1.0, "X"), Ok(Some(12.7)));
    assert_eq!(table.number(1.0, "C"), Ok(Some(90.0)));
    table.set(1.0, "X", &Cell::Number(6.35)).expect("room");
    assert_eq!(table.text(1.0, "X"), Ok("0.25"));
}

#[test]
fn printed_variants_of_a_name_mean_one_column() {
    // 000:6935 prints R-OFFS, 001:14911 R_OFFS and 001:14920 TT:R_OFFS.
    let mut table = Table::new(TableKind::Tool, "TOOL.T");
    table.add_row(12.0).expect("room");
    table.set(12.0, "R_OFFS", &Cell::Number(4.0)).expect("room");
    assert_eq!(table.number(12.0, "R-OFFS"), Ok(Some(4.0)));
    assert_eq!(table.number(12.0, "TT:R_OFFS"), Ok(Some(4.0)));
}

#[test]
fn standard_tables_are_read_back() {
    for kind in TableKind::ALL {
        let mut table = Table::new(kind, kind.file_name());
        table.add_row(1.0).expect("room");
        let again = Table::parse(kind, &Source::new(kind.file_name(), table.to_text())).expect("a sound table");
        let columns: Vec<_> = kind.columns().iter().map(|column| column.name).collect();
        assert_eq!(again.columns().collect::<Vec<_>>(), columns);
        assert_eq!(TableKind::of_file(kind.file_name()), Some(kind));
        assert_eq!(TableKind::by_word(kind.as_str()), Some(kind));
    }
}

proptest! {
    #[test]
    fn numbers_come_back_as_printed(x in -99_999.999_f64..99_999.999, row in 0_u16..9999) {
        let mut table = Table::new(TableKind::Preset, "PRESET.PR");
        table.add_row(f64::from(row)).expect("room");
        table.set(f64::from(row), "Z", &Cell::Number(x)).expect("room");
        let again = Table::parse(TableKind::Preset, &Source::new("PRESET.PR", table.to_text())).expect("a sound table");
        let read = again.number(f64::from(row), "Z").expect("a cell").expect("a number");
        prop_assert!((read - x).abs() <= 0.6e-9);
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC*|(BEGIN|\\[END\\]|NO|X|\n|\r\n| |[0-9.,+-]|ä){0,60}") {
        if let Ok(table) = Table::parse(TableKind::Preset, &Source::new("PRESET.PR", text.clone())) {
            prop_assert_eq!(table.to_text(), text);
        }
    }
}

#[test]
fn the_documented_columns_are_the_standard_ones() {
    let page = include_str!("../../docs/tables.md");
    for kind in TableKind::ALL {
        let name = if kind == TableKind::Probe { "touch probe" } else { kind.as_str() };
        let row = page.lines().find(|line| line.starts_with(&format!("| {name} |")));
        let cell = row.and_then(|row| row.split('|').nth(3)).expect("a row of the kind");
        // Widths stand in brackets behind the columns that have them.
        let mut documented = Vec::new();
        for group in cell.split(')') {
            let Some((names, width)) = group.rsplit_once('(') else { continue };
            let width: usize = width.trim_end_matches(" each").parse().expect("a width");
            documented
                .extend(names.split(',').map(str::trim).filter(|name| !name.is_empty()).map(|name| (name, width)));
        }
        let standard: Vec<_> = kind.columns().iter().map(|column| (column.name, column.width)).collect();
        assert_eq!(documented, standard);
    }
}
