//! The examples of the specifications, executed: every case of every cycle on every control that has it.
use std::fmt::Write as _;
use std::path::Path;

use ciklo::tools::conform::{self, Selection, Verdict, World};

#[test]
fn every_example_comes_out_as_it_says() {
    let files = ciklo::base::data::embedded();
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    let (report, mistakes) = conform::run(&World { catalogue, locales, files: &files }, &Selection::default());
    let mut failures: Vec<String> = mistakes
        .iter()
        .map(|mistake| {
            format!(
                "{} {:?} {:?}",
                mistake.code,
                mistake.place.as_ref().map(|p| (p.source.name().to_owned(), p.start().line)),
                mistake.args
            )
        })
        .collect();
    for case in &report.cases {
        let head = format!("{} {} {} {}", case.control, case.keyword, case.number, case.case);
        match &case.verdict {
            Verdict::Pass => {}
            Verdict::Fail { mismatches } => {
                for found in mismatches {
                    failures.push(format!("{head}: {} expected {} found {}", found.what, found.expected, found.found));
                }
            }
            Verdict::OutOfSubset { reason } => println!("{head}: out of subset: {reason}"),
            Verdict::Skipped { reason } => println!("{head}: skipped: {reason}"),
        }
    }
    let mut open = String::from(
        "# What no example executes or provokes yet, a line a cycle; `UPDATE=1 cargo test --test suite conform` writes it.\n",
    );
    for cycle in &report.cycles {
        let mut parts = Vec::new();
        if !cycle.unexecuted.is_empty() {
            parts.push(format!("executes {}", cycle.unexecuted.join(" ")));
        }
        if !cycle.unprovoked.is_empty() {
            parts.push(format!("provokes {}", cycle.unprovoked.join(" ")));
        }
        if !parts.is_empty() {
            let _ = writeln!(open, "{} {} {}: {}", cycle.control, cycle.keyword, cycle.number, parts.join("; "));
        }
    }
    let ledger = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/conform/open.txt");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&ledger, &open).expect("the ledger can be written");
    }
    let known = std::fs::read_to_string(&ledger).unwrap_or_default();
    if known != open {
        failures.push(format!("tests/conform/open.txt is not up to date; now it would be\n{open}"));
    }
    assert!(failures.is_empty(), "{} of {} cases:\n{}", failures.len(), report.cases.len(), failures.join("\n"));
}
