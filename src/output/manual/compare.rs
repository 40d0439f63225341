//! A cycle on all controls that describe it, side by side.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::cycle::Maker;
use super::edition::{Edition, OVERVIEW, file_of};
use super::links::{Linker, Shown};
use super::page::css_string;
use super::site::{Comparison, Site};
use super::view::{ColumnView, ComparedView, ComparisonView, PageView, ParameterView, SwitchView, TrailView};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::CycleKey;

/// The folder of the comparisons.
const FOLDER: &str = "compare";

/// All comparisons that the editions allow, in their order.
pub(super) fn all(editions: &[Edition]) -> Vec<Comparison> {
    let mut all: Vec<Comparison> = Vec::new();
    for (at, edition) in editions.iter().enumerate() {
        for entry in &edition.entries {
            let key = entry.cycle.key;
            let path = path(edition.language.tag(), key);
            match all.iter_mut().find(|known| known.path == path) {
                Some(known) => known.editions.push(at),
                None => all.push(Comparison { path, key, editions: vec![at] }),
            }
        }
    }
    all.retain(|comparison| comparison.editions.len() > 1);
    all
}

fn path(language: &str, key: CycleKey) -> String {
    format!("{FOLDER}/{language}/{}", file_of(key))
}

impl Site<'_> {
    /// The link from a page of the edition to the comparison of a cycle.
    pub(super) fn comparison(&self, edition: &Edition, key: CycleKey) -> Option<String> {
        let path = path(edition.language.tag(), key);
        self.comparisons.iter().any(|known| known.path == path).then(|| format!("../../{path}"))
    }
}

pub(super) fn page<'a>(site: &Site<'a>, comparison: &Comparison) -> Result<String, Vec<Diagnostic>> {
    let editions: Vec<&Edition<'a>> = comparison.editions.iter().filter_map(|at| site.editions.get(*at)).collect();
    let Some(first) = editions.first() else { return Ok(String::new()) };
    let name = first.entry(comparison.key).map(|entry| entry.name.clone()).unwrap_or_default();
    let mut columns = Vec::new();
    let mut rows: Vec<ComparedView> = Vec::new();
    let mut faults = Vec::new();
    for (at, edition) in editions.iter().enumerate() {
        let Some(entry) = edition.entry(comparison.key) else { continue };
        let vocabulary = Vocabulary::of(edition.on, entry.cycle, edition.language);
        let text = CycleText::new(edition.on, entry.cycle, edition.language, &vocabulary);
        let linker = Linker::new(edition, None, Shown::Apart);
        let maker = Maker { text: &text, edition, site, linker: &linker };
        let iso = &entry.cycle.iso;
        columns.push(ColumnView {
            control: edition.on.control.title.clone(),
            href: format!("../../{}", edition.path(&entry.file)),
            nc_name: text.nc_name().into_owned(),
            iso: iso.clone(),
            options: entry.cycle.described.options.iter().map(|number| maker.option(*number)).collect(),
        });
        let mut before = None;
        for param in &entry.cycle.params {
            let view = maker.parameter(param);
            before = Some(place(&mut rows, view, (at, editions.len()), before));
        }
        faults.extend(text.faults());
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    for row in &mut rows {
        row.differs = differences(&row.cells);
    }
    let key = comparison.key.to_string();
    let args = Args::new().text("name", name.as_str()).text("key", key.as_str());
    let title = first.text("page-comparison-title", &args)?.into_owned();
    let view = ComparisonView { key, name, columns, rows };
    let context = context! {
        page => Value::from(Serde(&frame(site, first, comparison, title)?)),
        words => first.words.clone(),
        comparison => Value::from(Serde(&view)),
    };
    site.render("compare.html", context)
}

/// Puts a parameter into its row, or into a new one after the row of the parameter before it.
fn place(rows: &mut Vec<ComparedView>, view: ParameterView, (at, of): (usize, usize), before: Option<usize>) -> usize {
    let row = rows.iter().position(|row| row.q == view.id).unwrap_or_else(|| {
        let row = before.map_or(0, |before| before + 1);
        rows.insert(
            row,
            ComparedView { q: view.id.clone(), differs: Vec::new(), cells: (0..of).map(|_| None).collect() },
        );
        row
    });
    if let Some(cell) = rows[row].cells.get_mut(at) {
        *cell = Some(view);
    }
    row
}

/// In what parameters of the controls differ in effect. What one manual does not print is no difference, and neither are
/// examples.
fn differences(cells: &[Option<ParameterView>]) -> Vec<&'static str> {
    let there: Vec<&ParameterView> = cells.iter().flatten().collect();
    let differ = |own: &dyn Fn(&ParameterView, &ParameterView) -> bool| {
        there.iter().enumerate().any(|(at, one)| there[..at].iter().any(|other| own(one, other)))
    };
    let range = |one: &ParameterView, other: &ParameterView| {
        one.range.as_ref().zip(other.range.as_ref()).is_some_and(|(one, other)| one != other)
    };
    let found = [
        ("presence", there.len() < cells.len()),
        ("reference", differ(&|one, other| one.reference != other.reference)),
        ("range", differ(&range)),
        ("words", differ(&|one, other| one.words != other.words)),
        ("choices", differ(&|one, other| one.choices != other.choices)),
        ("condition", differ(&|one, other| one.effective.is_some() != other.effective.is_some())),
    ];
    found.into_iter().filter(|(_, differs)| *differs).map(|(name, _)| name).collect()
}

fn frame(site: &Site, edition: &Edition, comparison: &Comparison, title: String) -> Result<PageView, Vec<Diagnostic>> {
    let others = site.comparisons.iter().filter(|other| other.key == comparison.key);
    let languages = others.filter_map(|other| {
        let own = site.editions.get(*other.editions.first()?)?;
        Some(SwitchView {
            href: format!("../../{}", other.path),
            lang: own.language.tag().to_owned(),
            name: own.language_name.clone(),
            current: other.path == comparison.path,
            overview: false,
        })
    });
    let home = format!("../../{}", edition.path(""));
    let step = |href: Option<String>, text: String| TrailView { href, text };
    let own = edition.entry(comparison.key).map(|entry| (format!("{home}{}", entry.file), entry.cycle.key.to_string()));
    let mut trail = vec![step(Some(format!("{home}{OVERVIEW}")), edition.on.control.title.clone())];
    trail.extend(own.map(|(href, key)| step(Some(href), key)));
    trail.push(step(None, edition.text("site-compare", &Args::new())?.into_owned()));
    let controls = site.editions.iter().filter(|other| other.language.tag() == edition.language.tag());
    let controls = controls.map(|other| {
        let file = other.entry(comparison.key).map(|entry| entry.file.as_str());
        SwitchView {
            href: format!("../../{}", other.path(file.unwrap_or(OVERVIEW))),
            lang: other.language.tag().to_owned(),
            name: other.on.control.title.clone(),
            current: false,
            overview: file.is_none(),
        }
    });
    let imprint = site.imprint(edition)?.split_off(1);
    let compared: Vec<&str> =
        comparison.editions.iter().map(|at| site.editions[*at].on.control.title.as_str()).collect();
    Ok(PageView {
        book: false,
        draft: site.is_draft,
        lang: edition.language.tag().to_owned(),
        sheet: Some((css_string(&title), css_string(&imprint.join(" \u{b7} ")))),
        imprint,
        trail,
        title,
        root: "../../".to_owned(),
        canonical: site.address(&comparison.path),
        control: compared.join(", "),
        home,
        languages: languages.collect(),
        controls: controls.collect(),
        previous: None,
        next: None,
    })
}
