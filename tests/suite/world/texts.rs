//! Every finding of the world has a text in every language, and gives it the arguments that it shows.
use ciklo::base::data::embedded;
use ciklo::base::diag::{Diagnostic, Source};
use ciklo::engine::scene::{Beside, Scene};
use ciklo::engine::solid::SolidError;
use ciklo::engine::table::{Table, TableError, TableKind};
use ciklo::language::locale::{Args, Locales, Scope};
use glam::DVec3;
use std::collections::BTreeSet;

/// Scenes that make every mistake there is.
const SCENES: &[&str] = &[
    "",
    "scene: 2\nunits: x\nclock: x\nmachine: x\nextra: 1\ntools: x\nstart: x\ndatums: {X: []}\nanswers: [[]]\n",
    "units: mm\ntools: [{T: -1}, {T: 1, L: x}, {T: 1}, {T: 2, TL: LLLLL}]\nstart: {X: 5000}\npresets: {active: 3}\n",
    "scene: 1\nprobe: {ball_radius: 0, offset: [1]}\nparts: [{solid: {union: []}}, {solid: {box: {min: [0, 0, 0], max: [0, 0, 0]}}}]\n",
    "scene: 1\nparts: [{solid: {sphere: {}, box: {}}}, {solid: {cylinder: {axis: Q, diameter: 1, from: 1, to: 1}}}]\n",
    "scene: 1\nparts: [{solid: {cylinder: {diameter: 1, from: 1, to: 1}}}]\n",
    "scene: 1\nstart: {X: 0, C: 5}\n",
    "scene: 1\nmachine: {axes: [], rotary: [{axis: Q, carries: tool, rapid: 1}, {axis: C, carries: x}, {axis: C, carries: workpiece, rapid: 0}]}\n",
];

const TABLES: &[&str] = &["", "BEGIN X.D MM\nD X\n1 x\n1 2\ny 3\n", "BEGIN X.D MM\nA B\n[END]\n"];

/// A file that no word of STL is in.
struct NoStl;

impl Beside for NoStl {
    fn size(&self, _: &str) -> Option<u64> {
        None
    }

    fn bytes(&self, _: &str) -> Result<Vec<u8>, Diagnostic> {
        Ok(b"solid\nfacet abnormal".to_vec())
    }
}

fn findings() -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let model = Source::new("x.yaml", "scene: 1\nparts: [{solid: {stl: x.stl}}]\n");
    all.extend(Scene::parse(&model, &embedded()).expect_err("a mistake"));
    all.extend(Scene::parse_beside(&model, &embedded(), Some(&NoStl)).expect_err("a mistake"));
    for text in SCENES {
        all.extend(Scene::parse(&Source::new("x.yaml", *text), &embedded()).expect_err("mistakes"));
    }
    for text in TABLES {
        all.extend(Table::parse(TableKind::Datum, &Source::new("X.D", *text)).expect_err("mistakes"));
    }
    let values = Source::new("values.t", include_str!("../../cli/tables/values.t"));
    all.extend(ciklo::program::table::check(TableKind::Tool, &values));
    let doubtful = "BEGIN X.PNT\nNR X\n2 1\n1 1\n[END]\n";
    all.extend(ciklo::program::table::check(TableKind::Points, &Source::new("X.PNT", doubtful)));
    all.extend(ciklo::program::table::check_other(&Source::new("PALLET.P", include_str!("../../cli/tables/PALLET.P"))));
    let (file, column, row) = ("X.D".to_owned(), "X".to_owned(), 1.0);
    let errors = [
        TableError::NoTable { file: file.clone() },
        TableError::NoRow { file: file.clone(), row },
        TableError::NoColumn { file: file.clone(), column: column.clone() },
        TableError::BadNumber { file: file.clone(), row, column: column.clone(), found: "x".to_owned() },
        TableError::TooWide { file: file.clone(), row, column: column.clone() },
        TableError::TextInNumbers { file: file.clone(), row, column: column.clone() },
        TableError::KeyColumn { file, row, column },
    ];
    all.extend(errors.iter().map(TableError::diagnostic));
    let point = DVec3::ZERO;
    let limits = [
        SolidError::NotFinite,
        SolidError::TooMany,
        SolidError::Edge(point),
        SolidError::Cusp(point),
        SolidError::Helix(point),
        SolidError::CutMesh,
    ];
    all.extend(limits.iter().map(|limit| Diagnostic::global(limit.code())));
    all
}

#[test]
fn every_finding_reads_in_every_language() {
    let (locales, mistakes) = Locales::load(embedded());
    assert!(mistakes.iter().all(|d| !format!("{d:?}").contains("diag-world")), "{mistakes:?}");
    let findings = findings();
    let told: BTreeSet<String> = findings.iter().map(|finding| format!("diag-{}", finding.code)).collect();
    for language in ["en", "fi", "sl", "it", "pt"] {
        let language = locales.language(language).expect("a language");
        for finding in &findings {
            let key = format!("diag-{}", finding.code);
            let text = language.text(key.as_str(), &Scope::NONE, &Args::of(finding));
            assert!(text.is_ok(), "{} {key}: {text:?}", language.tag());
        }
        let ours = |id: &&str| ["diag-scene-", "diag-solid-", "diag-table-"].iter().any(|start| id.starts_with(start));
        let known: BTreeSet<String> = language.ids().filter(ours).map(str::to_owned).collect();
        assert_eq!(known.difference(&told).collect::<Vec<_>>(), Vec::<&String>::new(), "texts that nothing provokes");
    }
}
