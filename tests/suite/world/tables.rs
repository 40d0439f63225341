//! Tables in the controls' file format: what is read, what is written, what is refused.
use ciklo::base::diag::Source;
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

/// What controls write beside names and rows: a version, comments, descriptions of the columns.
#[test]
fn files_as_controls_write_them_are_read() {
    let text = "BEGIN TOOL.T INCH Version: 'Update:150.21'\n; mine\n#STRUCTBEGIN\nNAME = \"R\"\n#STRUCTEND\n\nT    NAME  R    TL RT\n\
                ;0    x     y    z\n\n1    MILL  0.5  0  3\n5.1  DRILL 1.25 L\n#x\n[END]\nT 7\n";
    let source = Source::new("TOOL.T", text);
    let mut table = Table::parse(TableKind::Tool, &source).expect("a sound table");
    assert_eq!(table.rows().collect::<Vec<_>>(), [1.0, 5.1]);
    // 0.5 inch are 12.7 mm, 1.25 inch 31.75 mm.
    assert_eq!(table.number(1.0, "R"), Ok(Some(12.7)));
    assert_eq!(table.number(5.1, "R"), Ok(Some(31.75)));
    assert_eq!(table.to_text(), text);
    table.add_row(3.0).expect("room");
    assert_eq!(table.to_text(), text.replace("5.1  D", "3\n5.1  D"));
    let found: Vec<_> = ciklo::program::table::check(TableKind::Tool, &source).iter().map(|d| d.code).collect();
    // It has no column L, and a line behind the end.
    assert_eq!(found, ["table-doubtful", "table-unknown-column", "table-doubtful"]);
    // A description without an end leaves no names of columns.
    let open = text.replace("#STRUCTEND", "");
    let found = Table::parse(TableKind::Tool, &Source::new("TOOL.T", open)).expect_err("no names");
    assert_eq!(found[0].code, "table-no-heading");
}

#[test]
fn the_number_of_a_row_has_two_names() {
    let text = "BEGIN PRESET  .PR  MM\r\nNR   DOC   ROT   X     Y\r\n0          +0    +10   -\r\n1    VISE  +0,5  +2,5\r\n[END]\r\n";
    let table = Table::parse(TableKind::Preset, &Source::new("PRESET.PR", text)).expect("a sound table");
    assert_eq!(table.rows().collect::<Vec<_>>(), [0.0, 1.0]);
    assert_eq!(table.number(1.0, "X"), Ok(Some(2.5)));
    assert_eq!(table.number(0.0, "Y"), Ok(None));
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
        ("table-no-end", (5, 17)),
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

/// Manuals print point tables without the word BEGIN: they are doubted, not refused.
#[test]
fn a_table_without_begin_is_doubted() {
    let text = "TAB1.PNT MM\nNR      X           Y           Z\n0       +10         +10         +0\n[END]\n";
    let found = ciklo::program::table::check(TableKind::Points, &Source::new("TAB1.PNT", text));
    let told: Vec<_> = found.iter().map(|own| (own.code, own.severity)).collect();
    assert_eq!(told, [("table-no-header", ciklo::base::diag::Severity::Warning)]);
}

/// Of the mistakes that people make in tables, each is told at its line; of good tables nothing is said.
#[test]
fn broken_tables_are_told_at_their_lines() {
    let all = include_str!("../../world/broken_tables.txt");
    let mut wrong = Vec::new();
    let sections = all.split("=== ").skip(1);
    for section in sections.clone() {
        let (head, text) = section.split_once('\n').expect("a table");
        let mut words = head.split(' ');
        let name = format!("X.{}", words.next().expect("an extension"));
        let lines = words.next().expect("lines").split(',').map(|line| line.parse().expect("a line"));
        let lines: Vec<usize> = lines.collect();
        let kind = TableKind::of_file(&name).expect("a kind");
        let mut found = ciklo::program::table::check(kind, &Source::new(name, text));
        found.retain(|own| own.severity != ciklo::base::diag::Severity::Note);
        let told = |own: &ciklo::base::diag::Diagnostic| {
            own.place.as_ref().is_some_and(|place| lines.contains(&place.start().line))
        };
        let right = if lines == [0] { found.is_empty() } else { found.iter().any(told) };
        if !right {
            wrong.push(head);
        }
    }
    assert!(sections.count() > 55);
    assert_eq!(wrong, Vec::<&str>::new());
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

laws! {
    #![proptest_config(crate::cases::config(256))]

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

    /// Whatever bytes stand in the cells and around the table, they come back, and a change touches its cell only.
    #[test]
    fn any_bytes_come_back(
        kind in proptest::sample::select(TableKind::ALL.to_vec()),
        cells in proptest::collection::vec((any::<u8>(), 0_usize..40), 0..40),
        eol in proptest::sample::select(vec!["\n", "\r\n"]),
        tail in proptest::collection::vec(any::<u8>(), 0..20),
        inch in any::<bool>(),
    ) {
        let text_column = kind.columns().iter().find(|column| matches!(column.name, "NAME" | "DOC" | "TYPE" | "FADE"));
        let name = text_column.map_or("DOC", |column| column.name);
        let key = kind.columns()[0].name;
        let mut bytes = format!("BEGIN {} {}{eol}{key}    {name}{eol}", kind.file_name(), if inch { "INCH" } else { "MM" }).into_bytes();
        for (at, (byte, count)) in cells.iter().enumerate() {
            let cell = vec![if matches!(byte, b'\r' | b'\n') { b' ' } else { *byte }; *count];
            bytes.extend(format!("{at:<width$}", width = key.len() + 4).into_bytes());
            bytes.extend(cell);
            bytes.extend(eol.as_bytes());
        }
        bytes.extend(b"[END]");
        bytes.extend(&tail);
        let decoded = ciklo::program::syntax::encoding::decode(&bytes);
        if let Ok(mut table) = Table::parse(kind, &Source::new(kind.file_name(), decoded.text.as_str())) {
            let text = table.to_text();
            let again = decoded.encoding.encode(&text).expect("its own characters").to_vec();
            prop_assert_eq!(again, bytes);
            let _ = table.laid_out();
            if table.has_row(0.0) && table.set(0.0, name, &Cell::Text("A".to_owned())).is_ok() {
                let new = table.to_text();
                let others = |text: &str| text.lines().enumerate().filter(|(at, _)| *at != 2).map(|(_, line)| line.to_owned()).collect::<Vec<_>>();
                prop_assert_eq!(others(&new), others(&decoded.text));
            }
        }
    }
}

#[test]
fn the_documented_columns_are_the_standard_ones() {
    let page = include_str!("../../../docs/tables.md");
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
