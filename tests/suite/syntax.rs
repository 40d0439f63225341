//! The parser on programs with all kinds of blocks, and its laws on any input.
//!
//! Programs stand in `tests/syntax/*.h` and `*.i`, the trees expected beside them in `*.tree`;
//! `UPDATE=1 cargo test --test suite syntax` writes them anew.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

use ciklo::base::diag::Source;
use ciklo::base::diag::Span;
use ciklo::program::syntax::encoding::{Charset, decode};
use ciklo::program::syntax::{Block, BlockKind, Document, Program, json, parse};
use proptest::prelude::*;

#[path = "../syntax/dump.rs"]
mod dump;

fn program(text: &str) -> Program {
    parse(&Source::new("test.h", text))
}

fn iso(text: &str) -> Program {
    parse(&Source::new("test.i", text))
}

/// The programs of both languages.
fn programs() -> Vec<PathBuf> {
    [files("h"), files("i")].concat()
}

fn read(path: &Path, text: &str) -> Program {
    if path.extension().is_some_and(|extension| extension == "i") { iso(text) } else { program(text) }
}

fn files(extension: &str) -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/syntax");
    let mut found: Vec<PathBuf> = fs::read_dir(directory)
        .expect("the directory of programs")
        .map(|entry| entry.expect("a directory entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    found.sort();
    found
}

/// Blocks cover the text one behind the other, and each begins and ends with a line.
fn assert_tiled(program: &Program) {
    let text = program.source().text();
    assert_eq!(program.text(), text);
    let (mut at, mut line) = (0, 1);
    for block in program.blocks() {
        assert_eq!(block.span.start, at);
        assert_eq!(block.line, line);
        assert_eq!(block.line, program.source().line_of(at));
        assert!(block.span.end > at && block.lines > 0);
        at = block.span.end;
        line += block.lines;
    }
    assert_eq!(at, text.len());
    let ends_open = !text.is_empty() && !text.ends_with(['\n', '\r']);
    let written = text.replace("\r\n", "\n").replace('\r', "\n").matches('\n').count() + usize::from(ends_open);
    assert_eq!(program.lines(), written);
}

#[test]
fn programs_have_the_expected_trees() {
    let mut wrong = Vec::new();
    for path in programs() {
        let bytes = fs::read(&path).expect("a program");
        let decoded = decode(&bytes);
        assert_eq!(
            decoded.encoding.encode(&decoded.text).expect("what was read").as_ref(),
            bytes,
            "{}",
            path.display()
        );
        let program = read(&path, &decoded.text);
        assert_tiled(&program);
        let tree = dump::dump(&program);
        let beside = path.with_extension("tree");
        if env::var_os("UPDATE").is_some() {
            fs::write(&beside, tree).expect("the expectation written");
        } else if fs::read_to_string(&beside).unwrap_or_default() != tree {
            wrong.push(format!("{} should be\n{tree}", beside.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_expectation_has_its_program() {
    let stems = |paths: Vec<PathBuf>| -> BTreeSet<_> { paths.iter().map(|p| p.with_extension("")).collect() };
    assert_eq!(stems(files("tree")), stems(programs()));
}

#[test]
fn the_programs_show_every_kind_of_block() {
    let mut seen = BTreeSet::new();
    for path in programs() {
        let decoded = decode(&fs::read(&path).expect("a program"));
        seen.extend(read(&path, &decoded.text).blocks().iter().map(|block| block.kind.name()));
    }
    let all = "appr axis begin-pgm blk-form c call-lbl call-pgm call-selected cc chf comment contour-def contour-formula \
               cp cr ct ctp cycl-call cycl-def declare-contour dep empty end-pgm fc fct fl flt fn fn-assign \
               fn-jump formula fpol fselect function global-def indirect iso-blend iso-cycle iso-modal l lbl ln lp m pattern-def plane \
               refused rnd sel \
               set-undefined spl sql stop string-formula structure sysread tch-probe tool-call tool-def trans \
               unknown";
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), all.split_whitespace().collect::<Vec<_>>());
}

#[test]
fn the_document_lists_cycles_and_unreadable_lines() {
    let text = "0 BEGIN PGM A MM\n1 CYCL DEF 200 DRILLING ~\n Q200=+2 ;CLEARANCE ~\n Q206=FAUTO\n2 TCH PROBE 31.0 LENGTH\n\
                3 TCH PROBE 31.1 CHECK: 0 Q5\n4 TCH PROBE 31.2 ALT.: +120\n5 CYCL DEF 7.0 DATUM\n6 CYCL DEF 7.1 #5\n\
                what\n\n\n7 END PGM A MM";
    let program = program(text);
    let document = serde_json::to_value(json::document(&program)).expect("a document");
    let parameter =
        |q: &str, value: &str, label: Option<&str>| serde_json::json!({"q": q, "value": value, "label": label});
    let expected = serde_json::json!({
        "format": "ciklo-parse/1",
        "lines": 13,
        "blocks": 10,
        "kinds": {"begin-pgm": 1, "cycl-def": 3, "empty": 1, "end-pgm": 1, "tch-probe": 3, "unknown": 1},
        "unknown": [{"line": 10, "text": "what"}],
        "cycles": [
            {"keyword": "CYCL DEF", "number": 200, "line": 2,
             "parameters": [parameter("Q200", "+2", Some("CLEARANCE")), parameter("Q206", "FAUTO", None)]},
            {"keyword": "TCH PROBE", "number": 31, "line": 5,
             "parameters": [parameter("31.1 CHECK:", "0", None), parameter("31.1", "Q5", None),
                            parameter("31.2 ALT.:", "+120", None)]},
            {"keyword": "CYCL DEF", "number": 7, "line": 8, "parameters": [parameter("7.1 #", "5", None)]},
        ],
    });
    assert_eq!(document, expected);
}

#[test]
fn the_documented_kinds_are_those_of_the_programs() {
    let page = include_str!("../../docs/parse.md");
    for path in programs() {
        let decoded = decode(&fs::read(&path).expect("a program"));
        for block in read(&path, &decoded.text).blocks() {
            assert!(page.contains(&format!("`{}`", block.kind.name())), "{} is not documented", block.kind.name());
        }
    }
}

#[test]
fn every_code_has_a_text_in_every_language() {
    let mut codes = BTreeSet::new();
    for path in files("h") {
        let decoded = decode(&fs::read(&path).expect("a program"));
        codes.extend(program(&decoded.text).diagnostics().iter().map(|finding| finding.code));
    }
    let all = [
        "syntax-dangling-continuation",
        "syntax-doubled-continuation",
        "syntax-foreign-line",
        "syntax-formula",
        "syntax-incomplete",
        "syntax-refused-block",
        "syntax-text-after-tab",
        "syntax-unclosed-text",
        "syntax-undescribed",
        "syntax-unexpected",
        "syntax-unknown-block",
    ];
    assert_eq!(codes.into_iter().collect::<Vec<_>>(), all);
    for language in ["en", "fi", "sl", "it", "pt"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("locales").join(language).join("diag-syntax.ftl");
        let texts = fs::read_to_string(path).expect("the texts of the parser");
        for code in all {
            assert!(texts.contains(&format!("\ndiag-{code} = ")), "{code} in {language}");
        }
    }
}

/// A block of more than a mebibyte is not read; one that is a little shorter is, and so is what follows either.
#[test]
fn endless_blocks_are_not_read() {
    for (words, dialect) in [("L X+1", program as fn(&str) -> Program), ("N10 G01 X+1 *", iso)] {
        let block = |count: usize| words.replace("X+1", &"X+1 ".repeat(count));
        for (count, is_read) in [(200_000, true), (300_000, false)] {
            let text = format!("{}\n{}\n", block(count).trim_end(), block(1).trim_end());
            let program = dialect(&text);
            assert_tiled(&program);
            let unknown: Vec<_> =
                program.blocks().iter().map(|block| matches!(block.kind, BlockKind::Unknown(_))).collect();
            assert_eq!(unknown, [!is_read, false], "{count} of {words}");
        }
    }
}

#[test]
fn numbers_are_those_that_rust_reads() {
    for text in ["0.1", "7.5", "99999.9999", "123456789012345678", "0.000000000000000000000012345", ".5", "5."] {
        let program = program(&format!("L X-{}", text.replace('.', ",")));
        let BlockKind::Motion(motion) = &program.blocks()[0].kind else { panic!("no motion: {text}") };
        let expected = -text.parse::<f64>().expect("a number");
        assert_eq!(motion.coords[0].value.amount, ciklo::program::syntax::Amount::Number(expected));
    }
}

#[test]
fn huge_and_hostile_texts_are_read_in_linear_time() {
    let mut texts = vec![
        "\0".repeat(1 << 20),
        "\r".repeat(1 << 20),
        "9".repeat(1 << 20),
        "Q1 = ".to_owned() + &"(".repeat(1 << 20),
    ];
    for unit in [
        "~\n",
        "Q1=2 ~\n",
        "L X+1 ~\n",
        "\"",
        "~",
        "CYCL DEF 7.1 X ",
        "X Y:",
        ";",
        "\t",
        "- + ",
        "Q",
        "A\n",
        "TCH PROBE 1\n",
        "Q2=1 ;A\n",
        "\n;\n",
    ] {
        texts.push(unit.repeat(20_000));
        texts.push("5 CYCL DEF 200 A\n".to_owned() + &unit.repeat(20_000));
        texts.push("5 CYCL DEF 7.0 ".to_owned() + &unit.repeat(20_000));
        texts.push("5 L X+1 ".to_owned() + &unit.repeat(20_000));
    }
    for unit in [
        "G200 A\n",
        "Q200=1\n",
        "(",
        ")",
        "N1",
        "G91",
        "%",
        "*",
        "%A G71\n",
        "L1,",
        "P01 X",
        "D16 ",
        "G70\n",
        "N5 G200 A ~\n",
    ] {
        texts.push(unit.repeat(20_000));
        texts.push("N5 G200 A ".to_owned() + &unit.repeat(20_000));
        texts.push("%A G71 *\nN10 G01 X+5 ".to_owned() + &unit.repeat(20_000));
    }
    for text in texts {
        assert_tiled(&program(&text));
        assert_tiled(&iso(&text));
    }
}

#[test]
fn windows_1252_refuses_what_it_cannot_write() {
    let decoded = decode(b"T\xcaTE");
    assert_eq!((decoded.text.as_str(), decoded.encoding.charset), ("TÊTE", Charset::Windows1252));
    assert_eq!(decoded.encoding.encode("KOT Č"), Err('Č'));
}

/// Code pages are told by their bytes, and every file comes back.
#[test]
fn code_pages_are_told_by_their_bytes() {
    use encoding_rs::{GBK, WINDOWS_1250, WINDOWS_1251, WINDOWS_1252};
    let line = |label: &str| format!("5 CYCL DEF 200 X\r\nQ210=0 ;{label}\r\n");
    let samples = [
        (WINDOWS_1252, Charset::Windows1252, "PROFUNDIDADE DE PASSO, POSIÇÃO, ÂNGULO, N.º"),
        (WINDOWS_1252, Charset::Windows1252, "SYVYYS, KÄÄNTÖ, TYÖKALUN ÖÄÅ"),
        (WINDOWS_1252, Charset::Windows1252, "PROFONDITÀ, VELOCITÀ, È, QUOTA Ø 12"),
        (WINDOWS_1252, Charset::Windows1252, "KOOR. OBERFLÄCHE, MÜLLER, Größe, ÄÖÜ"),
        (WINDOWS_1250, Charset::Windows1250, "ČAS ZADRŽ. ZGORAJ, POVRŠINE, ŽEP, GLOBINA"),
        (WINDOWS_1250, Charset::Windows1250, "WARTOŚĆ POSUWU, GŁĘBOKOŚĆ"),
        (WINDOWS_1251, Charset::Windows1251, "ГЛУБИНА, БЕЗОПАСНОЕ РАССТОЯНИЕ, фреза"),
        (GBK, Charset::Gbk, "\u{5B89}\u{5168}\u{95F4}\u{9699}, \u{8FDB}\u{7ED9}\u{91CF} F"),
    ];
    for (page, charset, text) in samples {
        let text = line(text);
        let (bytes, _, replaced) = page.encode(&text);
        assert!(!replaced, "{text}");
        let decoded = decode(&bytes);
        assert_eq!((decoded.encoding.charset, decoded.text.as_str()), (charset, text.as_str()));
        assert_eq!(decoded.encoding.encode(&decoded.text).as_deref(), Ok(bytes.as_ref()));
    }
    for bom in [true, false] {
        let text = line("SYVYYS \u{e4}");
        let bytes = [if bom { &b"\xEF\xBB\xBF"[..] } else { &[] }, text.as_bytes()].concat();
        let decoded = decode(&bytes);
        assert_eq!(
            (decoded.encoding.charset, decoded.encoding.bom, decoded.text.as_str()),
            (Charset::Utf8, bom, &*text)
        );
        assert_eq!(decoded.encoding.encode(&decoded.text).as_deref(), Ok(bytes.as_slice()));
    }
}

/// What transfers and old editors leave in a file is blank.
#[test]
fn nul_and_control_z_are_blanks() {
    let text = "\0\0\0\n0 BEGIN PGM A MM\0\n1 L X+1\0R0 FMAX\n\r2 M30\n3 END PGM A MM\n\x1a\0\0";
    let program = program(text);
    assert_tiled(&program);
    let kinds: Vec<_> = program.blocks().iter().map(|block| block.kind.name()).collect();
    assert_eq!(kinds, ["empty", "begin-pgm", "l", "empty", "m", "end-pgm", "empty"]);
    assert!(program.diagnostics().is_empty());
}

#[test]
fn utf_16_is_read_and_written_back() {
    let text = "0 BEGIN PGM T\u{ca}TE MM\r\n; \u{1F527}\r\n";
    let little: Vec<u8> = [0xFF, 0xFE].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let big: Vec<u8> = [0xFE, 0xFF].into_iter().chain(text.encode_utf16().flat_map(u16::to_be_bytes)).collect();
    for (bytes, charset) in [(little, Charset::Utf16Le), (big, Charset::Utf16Be)] {
        let decoded = decode(&bytes);
        assert_eq!((decoded.text.as_str(), decoded.encoding.charset), (text, charset));
        assert_eq!(decoded.encoding.encode(&decoded.text).as_deref(), Ok(bytes.as_slice()));
        // A byte too many is no UTF-16: the bytes still come back.
        let cut = &bytes[..bytes.len() - 1];
        let decoded = decode(cut);
        assert_eq!(decoded.encoding.encode(&decoded.text).as_deref(), Ok(cut));
    }
}

/// Lines such as programs have, and pieces of them.
fn pieces() -> impl Strategy<Value = String> {
    let lines = [
        "0 BEGIN PGM A MM",
        "5 CYCL DEF 200 DRILLING",
        "CYCL DEF 7.0 DATUM",
        "CYCL DEF 7.1 X+",
        "Q200=2 ;CLEARANCE",
        "QS400=\"1-1",
        "\"",
        ";",
        "~",
        " ~",
        "\n",
        "\r\n",
        "\r",
        "\t",
        " ",
        "Q1 = ",
        "+Q2 * SIN 30",
        "L X+10 R0 FMAX M99",
        "TCH PROBE ",
        "31.2 HEIGHT: +120 Q5 X-",
        "FN 9: IF +Q1 EQU 0 GOTO LBL 1",
        "/",
        "* - text",
        "12",
        "é",
        "\u{a0}",
        "#5",
        "%A G71 *",
        "N10 G01 G91 X+5 ",
        "*",
        "(",
        ")",
        "N20 G200 DRILLING ",
        "Q201=-20",
        "P01 X-",
        "D18 Q1 ",
        "D16 ",
        "L1,",
        "G98 ",
        "%:TAB: ",
        "G79:",
    ];
    proptest::collection::vec(
        prop_oneof![8 => proptest::sample::select(lines.to_vec()).prop_map(str::to_owned), 1 => ".{0,4}"],
        0..24,
    )
    .prop_map(|pieces| pieces.concat())
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    #[test]
    fn any_bytes_come_back(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let decoded = decode(&bytes);
        let parsed = program(&decoded.text);
        assert_tiled(&parsed);
        assert_tiled(&iso(&decoded.text));
        let text = parsed.text();
        prop_assert_eq!(decoded.encoding.encode(&text).expect("what was read").into_owned(), bytes);
    }

    #[test]
    fn any_text_is_tiled_and_every_place_is_inside(text in pieces()) {
        for parsed in [program(&text), iso(&text)] {
            assert_tiled(&parsed);
            for finding in parsed.diagnostics() {
                let span = finding.place.expect("a place").span;
                prop_assert!(span.start <= span.end && text.get(span.start..span.end).is_some());
            }
            for block in parsed.blocks() {
                let content = parsed.content(block);
                prop_assert!(block.span.start <= content.start && content.start <= content.end && content.end <= block.span.end);
                prop_assert!(text.get(content.start..content.end).is_some());
            }
            let unknown = json::document(&parsed).unknown;
            prop_assert_eq!(unknown.len(), parsed.errors().count());
            prop_assert!(dump::dump(&parsed).len() >= text.len() / 100);
        }
    }
}

/// The place of a `~` that is dangling or doubled is the mark itself, before a comment or behind it.
#[test]
fn a_mark_is_found_on_either_side_of_a_comment() {
    let dangling = ["~~;\u{a0}", "L X+1 ~ ;comment", "L X+1 ;comment ~", "~"].map(|text| ("dangling", text));
    let doubled = ["~~;\u{ff}", "L X+1 ~~ ;comment", "L X+1 ;comment ~~"].map(|text| ("doubled", text));
    for (kind, text) in dangling.into_iter().chain(doubled) {
        let parsed = program(text);
        let findings = parsed.diagnostics();
        let code = format!("syntax-{kind}-continuation");
        let found = findings.iter().find(|finding| finding.code == code);
        let span = found.expect("a finding").place.as_ref().expect("a place").span;
        assert_eq!(text.get(span.start..span.end), Some("~"), "{text:?}");
    }
}

/// A line torn in a good program is one unknown line, and nothing else becomes one.
#[test]
fn one_malformed_line_is_one_unknown() {
    for name in ["contour", "drilling", "probing"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/syntax/{name}.h"));
        let good = fs::read_to_string(path).expect("a program");
        let lines: Vec<&str> = good.lines().collect();
        for (index, line) in lines.iter().enumerate() {
            // What `~` joins to a torn line is torn as well, unless a cycle's parameters follow.
            if name == "contour" && line.contains('~') {
                continue;
            }
            let number = line.split(' ').next().filter(|word| word.parse::<u32>().is_ok()).unwrap_or_default();
            for number in ["", number] {
                let torn = format!("{number} § torn §");
                let mut lines = lines.clone();
                lines[index] = &torn;
                let text = lines.join("\n");
                let program = program(&text);
                let unknown: Vec<_> = json::document(&program).unknown.iter().map(|u| (u.line, u.text)).collect();
                assert_eq!(unknown, [(index + 1, torn.as_str())], "{name}, line {}", index + 1);
            }
        }
    }
}

/// What a document says of its blocks: place and line in the whole text, and what the block is.
fn told(document: &Document) -> Vec<(usize, usize, usize, String)> {
    let mut all = Vec::new();
    for piece in document.pieces() {
        let shown = shown(piece.program);
        assert_eq!(shown.len(), piece.program.blocks().len());
        let place = |block: &Block| (block.span.start + piece.start, block.line + piece.lines_before, block.lines);
        all.extend(piece.program.blocks().iter().zip(shown).map(|(block, text)| {
            let (start, line, lines) = place(block);
            (start, line, lines, text)
        }));
    }
    all
}

/// The blocks of a program as text, without their lines.
fn shown(program: &Program) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for line in dump::dump(program).lines().take_while(|line| !line.starts_with("= ")) {
        let digits = line.trim_start_matches(|c: char| c.is_ascii_digit() || c == '-');
        match digits.strip_prefix(": ") {
            Some(block) if digits.len() < line.len() => all.push(block.to_owned()),
            // What is found stands behind the blocks, with line and column.
            _ if digits.starts_with(':') => break,
            _ => all.last_mut().expect("a block").push_str(line),
        }
    }
    all
}

fn assert_as_whole(document: &Document) {
    let text = document.text();
    let whole = program(&text);
    let expected: Vec<_> =
        whole.blocks().iter().map(|it| (it.span.start, it.line, it.lines)).zip(shown(&whole)).collect();
    let expected: Vec<_> =
        expected.into_iter().map(|((start, line, lines), text)| (start, line, lines, text)).collect();
    assert_eq!(told(document), expected, "{text:?}");
    let cycles: usize = document.pieces().map(|piece| piece.program.cycles().len()).sum();
    assert_eq!(cycles, whole.cycles().len());
    let (mut findings, mut of_pieces) = (Vec::new(), Vec::new());
    for finding in whole.diagnostics() {
        findings.push((finding.place.as_ref().expect("a place").span.start, finding.code));
    }
    for piece in document.pieces() {
        for finding in piece.program.diagnostics() {
            of_pieces.push((finding.place.as_ref().expect("a place").span.start + piece.start, finding.code));
        }
    }
    assert_eq!(of_pieces, findings);
}

#[test]
fn a_document_is_edited_in_micro_seconds() {
    let lines: Vec<String> = (0..100_000).map(|n| format!("{n} L X+{}.125 Y-{}.5 R0 F500\n", n % 97, n % 31)).collect();
    let mut document = Document::new("long.h", &lines.concat());
    let middle: usize = lines.iter().take(50_000).map(String::len).sum();
    let start = std::time::Instant::now();
    let rounds = 200;
    for round in 0..rounds {
        let read =
            document.edit(Span::new(middle, middle), &format!("L Z+{round}\n")).expect("a place between characters");
        assert!(read.end - read.start < 20_000, "{read:?}");
    }
    // Debug builds are slow; what matters is that it is not the whole file.
    let each = start.elapsed() / rounds;
    assert!(each.as_micros() < 20_000, "{each:?}");
    assert_as_whole(&document);
}

#[test]
fn a_document_refuses_places_that_are_none() {
    let mut document = Document::new("a.h", "L X+1 ;\u{e9}\n");
    assert_eq!(document.edit(Span::new(8, 8), "x"), None);
    assert_eq!(document.edit(Span::new(5, 99), "x"), None);
    assert_eq!(document.edit(Span::new(5, 4), "x"), None);
    assert_eq!(document.text(), "L X+1 ;\u{e9}\n");
    assert!(document.edit(Span::new(0, 10), "").is_some());
    assert!(document.is_empty());
    assert_eq!(document.edit(Span::new(0, 0), "M30"), Some(Span::new(0, 3)));
    assert_as_whole(&document);
}

/// A program of several pieces, with and without numbers.
fn long() -> impl Strategy<Value = String> {
    let blocks = [
        "L X+10 R0 FMAX M99",
        "L X+1 ~\n  Y+2",
        "CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 X+5",
        "CYCL DEF 200 DRILLING ~\n Q200=2 ;CLEARANCE ~\n Q201=-5 ;DEPTH",
        "CYCL DEF 200 DRILLING\nQ200=2 ;CLEARANCE\nQ201=-5 ;DEPTH",
        "PATTERN DEF\nPOS1( X+10 Y+10 )\nPOS2( X+20 Y+10 )",
        "PATTERN DEF POS1( X+10",
        "Y+20 Z+0 )",
        "Q5 = 3",
        "Q5=3 ;TOP",
        "; a comment",
        "; a long comment ~\n goes on",
        "",
        "* - structure",
        "what is this",
        "FN 0: ~\n Q1 = +5",
        "M30",
    ];
    let block = (proptest::sample::select(blocks.to_vec()), any::<bool>());
    (proptest::collection::vec(block, 0..400), any::<bool>()).prop_map(|(blocks, numbers)| {
        let line = |(index, (text, own)): (usize, (&str, bool))| {
            if numbers && own { format!("{index} {text}\n") } else { format!("{text}\n") }
        };
        blocks.into_iter().enumerate().map(line).collect()
    })
}

laws! {
    #![proptest_config(crate::cases::config(200))]
    #[test]
    fn an_edited_document_is_what_the_whole_text_is(
        text in long(),
        edits in proptest::collection::vec((any::<prop::sample::Index>(), 0..60_usize, pieces()), 1..6),
    ) {
        let mut document = Document::new("test.h", &text);
        let mut expected = text;
        assert_as_whole(&document);
        for (at, length, new) in edits {
            let places: Vec<usize> = (0..=expected.len()).filter(|at| expected.is_char_boundary(*at)).collect();
            let start = at.index(places.len());
            let (start, end) = (places[start], places[(start + length).min(places.len() - 1)]);
            prop_assert!(document.edit(Span::new(start, end), &new).is_some());
            expected.replace_range(start..end, &new);
            prop_assert_eq!(document.text(), expected.as_str());
            assert_as_whole(&document);
        }
    }
}
