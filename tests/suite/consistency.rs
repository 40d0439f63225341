//! What `consistency` and the habits of the catalogue find: facts altered in the built data, each one found, and
//! nothing found in the data as they are.
use ciklo::base::data::{self, Files};
use ciklo::base::diag::Diagnostic;
use ciklo::language::consistency;
use ciklo::language::locale::Locales;
use ciklo::spec::{self, Catalogue};

/// The file, what stands there, what is put there, and what must be found: the code and a word that the finding names.
type Alteration = (&'static str, &'static str, &'static str, &'static str, &'static str);

fn found(files: &Files) -> Vec<Diagnostic> {
    let (catalogue, mut found) = Catalogue::load(files);
    let (locales, mistakes) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    found.extend(mistakes);
    found.extend(of(&catalogue, &locales));
    found
}

fn of(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let mut found = spec::lint(catalogue);
    found.extend(ciklo::engine::plan::check(catalogue));
    found.extend(consistency::check(catalogue, locales));
    found
}

fn altered(alterations: &[Alteration]) -> Files {
    let mut files = data::embedded();
    for (name, from, to, ..) in alterations {
        let (_, text) = files.iter_mut().find(|(path, _)| path.ends_with(name)).unwrap_or_else(|| panic!("no {name}"));
        assert!(text.contains(from), "{name} does not contain {from}");
        *text = text.replacen(from, to, 1);
    }
    files
}

fn names(diagnostic: &Diagnostic, word: &str) -> bool {
    diagnostic.args.iter().any(|(_, value)| format!("{value:?}").contains(word))
}

#[test]
fn the_built_data_agree_with_themselves() {
    let codes = ["consistency-", "spec-odd-", "spec-measure", "spec-unused-parameter"];
    let data = crate::built::built();
    let found: Vec<String> = of(&data.catalogue, &data.locales)
        .iter()
        .filter(|found| codes.iter().any(|code| found.code.starts_with(code)))
        .map(|found| format!("{} {:?}", found.code, found.args))
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_altered_fact_is_found() {
    let alterations: &[Alteration] = &[
        // A number, a unit, an argument and a word of the code in one language.
        (
            "fi/drilling.ftl",
            "3000{\"\\u00A0\"}mm/min",
            "300{\"\\u00A0\"}mm/min",
            "consistency-number",
            "step-break-chip",
        ),
        ("sl/drilling.ftl", "3000{\"\\u00A0\"}mm/min", "3000{\"\\u00A0\"}mm", "consistency-unit", "step-break-chip"),
        (
            "it/drilling.ftl",
            "{ $q-dwell-at-top }",
            "{ $q-dwell-at-bottom }",
            "consistency-argument",
            "return-to-set-up",
        ),
        ("pt/measuring.ftl", "Q182=1", "Q181=1", "consistency-code", "say-hole-is-scrap"),
        // A sentence that denies what it said.
        (
            "it/machining-common.ftl",
            "il controllo non esegue",
            "il controllo esegue",
            "consistency-negation",
            "guard-depth-zero",
        ),
        // What goes on with a denial denies nothing by itself.
        (
            "pt/milling.ftl",
            "{ $q-second-set-up-clearance } de modo que a ferramenta não possa",
            "{ $q-second-set-up-clearance } de modo que a ferramenta possa",
            "consistency-negation",
            "note-second-clearance-without-collision",
        ),
        // A number in one variant of a selection.
        (
            "fi/diag-check.ftl",
            "[zero] Työkalu 0 ",
            "[zero] Työkalu 1 ",
            "consistency-number",
            "diag-tool-definition-wrong",
        ),
        // The label of another parameter of the same cycle, and texts of choices that changed places.
        (
            "it/parameters-machining.ftl",
            ".label = PROFONDITÀ\n",
            ".label = DISTANZA SICUREZZA\n",
            "consistency-label-twice",
            "DISTANZA SICUREZZA",
        ),
        // What a specification says against the names: an angle that is a length, a distance that is a coordinate.
        (
            "parameters/machining.yaml",
            "angle-of-rotation:\n    {quantity: angle",
            "angle-of-rotation:\n    {quantity: length",
            "consistency-quantity",
            "angle-of-rotation",
        ),
        (
            "parameters/machining.yaml",
            "set-up-clearance:\n    {quantity: length, reference: incremental",
            "set-up-clearance:\n    {quantity: length, reference: absolute",
            "consistency-reference",
            "set-up-clearance",
        ),
        // Habits of the catalogue: a limit, a choice, a Q number.
        (
            "parameters/probing.yaml",
            "measuring-height:\n    quantity: length\n    reference: absolute\n    ranges: [{min: -99999.9999, max: 99999.9999",
            "measuring-height:\n    quantity: length\n    reference: absolute\n    ranges: [{min: -99999.9999, max: 9999.9999",
            "spec-odd-limit",
            "measuring-height",
        ),
        (
            "drilling/205-universal-pecking.yaml",
            "{q: Q206, is: plunging-feed",
            "{q: Q207, is: plunging-feed",
            "spec-odd-q",
            "plunging-feed",
        ),
        // A value that other cycles calculate from another parameter.
        (
            "turning/861-radial-recessing.yaml",
            "left_on_diameter: \"IF(Q215 = 3, Q483, 0)\"",
            "left_on_diameter: \"IF(Q215 = 3, Q484, 0)\"",
            "spec-odd-formula",
            "left_on_diameter",
        ),
        // A number that begins with 0 is a name, which is another one without it.
        ("it/contours.ftl", "34059x-02", "34059x-2", "consistency-number", "note-engraving-since-software"),
        // A range of a word of a block that has lost its minus.
        ("cycle-specs/language.yaml", "{word: PROPR, min: -90,", "{word: PROPR, min: 90,", "spec-empty-range", "90"),
        // A formula that adds two coordinates, and a parameter of which the run knows nothing any more.
        ("drilling/200-drilling.yaml", "floor: Q203 + Q201", "floor: Q203 + Q203", "spec-measure", "CYCL DEF 200"),
        // A result with the number of a parameter, and so a number that the run sets and that is no result.
        (
            "kinematics/452-preset-compensation.yaml",
            "{q: Q142, is: scatter-measured-b}",
            "{q: Q380, is: scatter-measured-b}",
            "spec-odd-result",
            "Q142",
        ),
        // The smaller of a distance and a coordinate.
        (
            "datum/410-datum-inside-rectangle.yaml",
            "room: MIN(Q323, Q324)",
            "room: MIN(Q323, Q322)",
            "spec-measure",
            "410",
        ),
        // A choice between two values that are the same, and a sign of what is never negative.
        (
            "patterns/220-circular-pattern.yaml",
            "IF(Q204 <> 0, Q204, Q200)",
            "IF(Q204 <> 0, Q204, Q204)",
            "spec-measure",
            "same-operands",
        ),
        ("surfaces/232-face-milling.yaml", "way: SGN(Q218)", "way: SGN(Q357)", "spec-measure", "never-negative"),
        // How far a coordinate is from the datum, and a point in which a distance is beside coordinates.
        (
            "surfaces/232-face-milling.yaml",
            "IF(ABS(Q386 - Q227)",
            "IF(ABS(Q386 - Q204)",
            "spec-measure",
            "coordinate-as-distance",
        ),
        (
            "pockets/251-rectangular-pocket.yaml",
            "across * COS(Q224), Q203)",
            "across * COS(Q224), Q368)",
            "spec-measure",
            "distance-as-coordinate",
        ),
    ];
    let found = found(&altered(alterations));
    let missing: Vec<String> = alterations
        .iter()
        .filter(|(.., code, word)| !found.iter().any(|found| found.code == *code && names(found, word)))
        .map(|(file, _, to, code, word)| format!("{code} for {word}: {file} {to}"))
        .collect();
    assert!(missing.is_empty(), "not found:\n{}", missing.join("\n"));
}
