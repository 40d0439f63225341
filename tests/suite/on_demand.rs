//! Embedded data are read when something asks for them: what comes out is what comes of reading all files, and what
//! nobody asks for is not read.
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ciklo::base::data;
use ciklo::base::demand::{Deferred, OnDemand};
use ciklo::base::diag::{Diagnostic, Source};
use ciklo::check::{Against, LabelBook, check};
use ciklo::language::locale::{Key, Language, Locales, Scope};
use ciklo::program::iso::{Codes, to_klartext};
use ciklo::program::syntax::{Dialect, parse};
use ciklo::spec::{Catalogue, CycleKey};

use crate::built::built;

fn on_demand() -> (Catalogue, Locales) {
    let data = data::prepared().expect("the embedded files have no mistakes");
    (Catalogue::open(data), Locales::open(data))
}

fn shown(value: &impl std::fmt::Debug) -> String {
    format!("{value:?}")
}

#[test]
fn a_catalogue_read_on_demand_is_the_whole_one() {
    let (own, whole) = (on_demand().0, &built().catalogue);
    assert!(own.controls.keys().eq(whole.controls.keys()));
    for (own, whole) in own.controls.values().zip(whole.controls.values()) {
        let id = whole.id();
        assert_eq!(shown(&own.control), shown(&whole.control), "{id}");
        assert_eq!(own.outlines, whole.outlines, "{id}");
        assert!(own.cycles.keys().eq(whole.cycles.keys()), "{id}");
        for (key, cycle) in whole.cycles.iter() {
            assert_eq!(shown(&own.cycles.get(key)), shown(&Some(cycle)), "{id} {key}");
        }
        assert_eq!(shown(&own.fragments), shown(&whole.fragments), "{id}");
        assert_eq!(shown(&own.meanings), shown(&whole.meanings), "{id}");
    }
    assert_eq!(*own.ranges, *whole.ranges);
    assert_eq!(shown(&own.errata), shown(&whole.errata));
    assert_eq!(shown(&own.topics), shown(&whole.topics));
    assert_eq!(shown(&(&own.blocks, &own.globals)), shown(&(&whole.blocks, &whole.globals)));
    assert!(own.mistakes.take().is_empty());
}

/// The texts of a language in all their scopes, with their places.
fn texts(language: &Language) -> BTreeSet<String> {
    let text = |(key, suffixes): (Key<'_>, &[Box<str>])| {
        let (cycle, control) = (suffixes.first(), suffixes.get(1));
        let scope = Scope { cycle: cycle.map(|it| &**it), control: control.or(cycle).map(|it| &**it) };
        let (text, place) = language.raw(key, scope).expect("it is there");
        format!("{key} {suffixes:?} {}:{:?} {text}", place.source.name(), place.span)
    };
    language.keys().map(text).collect()
}

#[test]
fn languages_read_on_demand_are_the_whole_ones() {
    let (own, whole) = (on_demand().1, &*built().locales);
    assert!(own.tags().eq(whole.tags()));
    for (own, whole) in own.iter().zip(whole.iter()) {
        let tag = whole.tag();
        let ids = |language: &Language| language.ids().map(str::to_owned).collect::<BTreeSet<_>>();
        assert_eq!(ids(own), ids(whole), "{tag}");
        for (own, whole) in texts(own).iter().zip(&texts(whole)) {
            assert_eq!(own, whole, "{tag}");
        }
        let topics = |language: &Language| {
            language.topics().map(|(name, source)| (name.to_owned(), source.text().to_owned())).collect::<Vec<_>>()
        };
        assert_eq!(topics(own), topics(whole), "{tag}");
        assert_eq!(own.numbers(), whole.numbers(), "{tag}");
        assert_eq!(own.unit(1.5, "mm", Default::default()), whole.unit(1.5, "mm", Default::default()), "{tag}");
    }
    for tag in whole.tags() {
        let audit = |locales: &Locales| shown(&locales.audit(tag).map(|audit| audit.diagnostics()).ok());
        assert_eq!(audit(&own), audit(whole), "{tag}");
    }
    assert!(own.mistakes().take().is_empty());
}

fn findings(text: &str, name: &str, control: &str, (catalogue, locales): (&Catalogue, &Locales)) -> Vec<Diagnostic> {
    let mut program = parse(&Source::new(name, text));
    if program.dialect() == Dialect::Iso {
        program = to_klartext(&program, &Codes::new(catalogue), None).program;
    }
    let on = catalogue.on(control).expect("a control");
    let labels = LabelBook::new(on, locales);
    let readers = [locales.source().expect("English is there")];
    check(&program, &Against { catalogue, on, labels: &labels, language: None, software: None, readers: &readers })
}

#[test]
fn the_checker_finds_the_same() {
    let mut seen = 0;
    for folder in ["tests/check", "examples"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        for entry in fs::read_dir(folder).expect("the directory") {
            let path = entry.expect("an entry").path();
            let is_program = path.extension().is_some_and(|own| own == "h" || own == "i");
            let Some(text) = fs::read_to_string(&path).ok().filter(|_| is_program) else { continue };
            let named = text.split("control:").nth(1).and_then(|rest| rest.split_whitespace().next());
            let control = named.filter(|id| built().catalogue.controls.contains_key(*id)).unwrap_or("tnc640");
            // A catalogue of its own for each, so that nothing has been read before.
            let (catalogue, locales) = on_demand();
            let name = path.display().to_string();
            let found = findings(&text, &name, control, (&catalogue, &locales));
            assert_eq!(
                shown(&found),
                shown(&findings(&text, &name, control, (&built().catalogue, &built().locales))),
                "{name}"
            );
            seen += 1;
        }
    }
    assert!(seen > 100, "only {seen} programs");
}

#[test]
fn a_check_reads_the_cycles_of_the_program_and_no_others() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/hole.h");
    let text = fs::read_to_string(path).expect("a program");
    let (catalogue, locales) = on_demand();
    findings(&text, "hole.h", "tnc640", (&catalogue, &locales));
    let program = parse(&Source::new("hole.h", text));
    let numbers: BTreeSet<u32> = program.cycles().iter().map(|view| view.number).collect();
    for id in catalogue.controls.made() {
        let on = catalogue.on(id).expect("it was read");
        let made: BTreeSet<&CycleKey> = on.cycles.made().collect();
        assert!(id != "tnc640" || made.len() == numbers.len(), "{made:?}");
        assert!(made.iter().all(|key| numbers.contains(&key.number)), "{id} {made:?}");
    }
    let names: BTreeSet<&str> = catalogue
        .on("tnc640")
        .expect("it was read")
        .outlines
        .iter()
        .filter(|(key, _)| numbers.contains(&key.number))
        .map(|(_, outline)| outline.name.as_str())
        .collect();
    for language in locales.iter() {
        for id in language.read_so_far() {
            let of_cycle = id.strip_prefix("cycle-");
            assert!(of_cycle.is_none_or(|name| names.contains(name)), "{} {id}", language.tag());
        }
        // Some thousand are there.
        assert!(language.read_so_far().len() < 300, "{}", language.read_so_far().len());
    }
}

#[test]
fn a_value_is_made_when_it_is_asked_for_and_kept() {
    let map = OnDemand::new([1, 2, 3], |key: &u32| (*key != 2).then(|| key * 10));
    assert_eq!(map.len(), 3);
    assert_eq!(map.made().count(), 0);
    assert_eq!(map.get(&3), Some(&30));
    assert_eq!(map.get(&2), None);
    assert_eq!(map.get(&4), None);
    assert_eq!(map.made().collect::<Vec<_>>(), [&2, &3]);
    assert_eq!(map.values().collect::<Vec<_>>(), [&10, &30]);
    let deferred: Deferred<String> = Deferred::new(|| "made".to_owned());
    assert_eq!(deferred.len(), 4);
}
