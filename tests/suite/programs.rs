//! Worked programs: a part that is not what the case says is a failure, comments are ids in their files and words on pages.
use std::path::Path;

use ciklo::base::data;
use ciklo::spec::{Catalogue, Worked};
use ciklo::tools::conform::{self, Selection, Verdict, World};

/// What differs in the program `bolt-circle` if one piece of its file is another one.
fn differs(from: &str, to: &str) -> Vec<String> {
    let mut files = data::embedded();
    let own = files.iter_mut().find(|(path, _)| path == "cycle-specs/programs/bolt-circle.yaml").expect("the program");
    assert!(own.1.contains(from), "{from}");
    own.1 = own.1.replace(from, to);
    let (catalogue, mistakes) = Catalogue::load(&files);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let locales = &*crate::built::built().locales;
    let chosen = Selection { controls: &["tnc640"], cases: &["bolt-circle"], ..Selection::default() };
    let (report, found) = conform::run(&World { catalogue: &catalogue, locales, files: &files }, &chosen);
    let [case] = report.cases.as_slice() else { panic!("one case") };
    match &case.verdict {
        Verdict::Pass => Vec::new(),
        Verdict::Fail { mismatches } => mismatches.iter().map(|one| one.what.clone()).collect(),
        other => panic!("{other:?} {found:?}"),
    }
}

#[test]
fn a_part_that_is_not_as_expected_fails() {
    assert_eq!(differs("Q244=60 ;", "Q244=60 ;"), Vec::<String>::new());
    assert_eq!(differs("- {at: [80, 50], is: []}", "- {at: [80, 50], is: [[-20, -19]]}"), ["part.80.50"]);
    // A wider circle of holes: three places have material, and the last position is another one.
    let wider = differs("Q244=60 ;", "Q244=80 ;");
    assert_eq!(wider, ["position.X", "position.Y", "part.80.50", "part.65.75.98", "part.20.50"]);
    // Rapid traverse into the blank is a difference, too: the clearance is below the surface.
    let low = differs("L Z+100 R0 FMAX M3 ;{clear-and-start-spindle}", "L X+10 Y+10 Z-1 R0 FMAX M3");
    assert!(low.iter().any(|what| what.starts_with("part.line.")), "{low:?}");
}

#[test]
fn words_stand_in_place_of_ids_of_comments() {
    let text = "0 BEGIN PGM A MM\n1 L Z+1 ;{up}\n2 CYCL DEF 9 ;{not-at-the-end} \n3 ; {no}\n";
    let shown = Worked::with_comments(text, &|id| id.to_uppercase());
    assert_eq!(shown, "0 BEGIN PGM A MM\n1 L Z+1 ; UP\n2 CYCL DEF 9 ; NOT-AT-THE-END\n3 ; {no}\n");
}

#[test]
fn every_file_of_a_program_is_one_of_some_control() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cycle-specs/programs");
    let files = std::fs::read_dir(folder).expect("the programs").count();
    let on = crate::built::built().catalogue.controls.values();
    let mut places: Vec<String> =
        on.flat_map(|on| on.worked.iter().map(|worked| worked.example.place.source.name().to_owned())).collect();
    places.sort();
    places.dedup();
    assert_eq!(places.len(), files);
}
