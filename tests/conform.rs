//! The examples of the specifications, executed: every case of every cycle on every control that has it.
use ciklo::conform::{self, Verdict, World};
use ciklo::locale::Locales;
use ciklo::spec::Catalogue;

#[test]
fn every_example_comes_out_as_it_says() {
    let files = ciklo::data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let (report, mistakes) = conform::run(&World { catalogue: &catalogue, locales: &locales, files: &files }, &[]);
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
    for cycle in &report.cycles {
        let name = format!("{} {} {}", cycle.control, cycle.keyword, cycle.number);
        if cycle.pending.is_empty() && !cycle.unexecuted.is_empty() {
            failures.push(format!("{name}: no example executes {}", cycle.unexecuted.join(", ")));
        }
        if !cycle.unprovoked.is_empty() {
            failures.push(format!("{name}: no example provokes {}", cycle.unprovoked.join(", ")));
        }
        println!(
            "{} {} {}: unexecuted {:?}, unprovoked {:?}",
            cycle.control, cycle.keyword, cycle.number, cycle.unexecuted, cycle.unprovoked
        );
    }
    assert!(failures.is_empty(), "{} of {} cases:\n{}", failures.len(), report.cases.len(), failures.join("\n"));
}
