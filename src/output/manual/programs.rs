//! Worked programs: the page that shows all of a control, and those that a page of a cycle shows.
//!
//! Invariant: a program is shown as it is executed; only its names, labels and comments are those of the language.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::edition::Edition;
use super::page::{Here, link};
use super::view::{CalledView, FigureView, WorkedView};
use super::{Site, defined, highlight};
use crate::base::diag::Diagnostic;
use crate::language::locale::Args;
use crate::language::text::{CycleText, Vocabulary};
use crate::output::figure::Medium;
use crate::spec::{CycleKey, Worked};

/// The file of the worked programs.
pub(super) const PAGE: &str = "programs.html";

/// The page with all programs of a control.
pub(super) fn page<'a>(site: &Site<'a>, edition: &Edition<'a>) -> Result<String, Vec<Diagnostic>> {
    let mut views = Vec::new();
    for worked in edition.on.worked.iter() {
        let figures = figures(site, edition, worked)?;
        views.push(WorkedView { figures, ..view(site, edition, worked)? });
    }
    let args = Args::new().text("control", edition.on.control.title.as_str());
    let title = edition.text("page-programs-title", &args)?.into_owned();
    let frame = site.frame(edition, title, Here::Programs)?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        programs => Value::from(Serde(&views)),
    };
    site.render("programs.html", context)
}

/// The programs that define a cycle, without their pictures.
pub(super) fn of_cycle(site: &Site, edition: &Edition, key: CycleKey) -> Result<Vec<WorkedView>, Vec<Diagnostic>> {
    let own = edition.on.worked.iter().zip(edition.cycles_of_programs());
    let own = own.filter(|(_, cycles)| cycles.contains(&key));
    own.map(|(worked, _)| view(site, edition, worked)).collect()
}

/// The title of each program with the way to it.
pub(super) fn titles(edition: &Edition) -> Result<Vec<super::view::TopicLink>, Vec<Diagnostic>> {
    let link = |worked: &Worked| {
        let title = edition.text(&format!("program-{}", worked.name()), &Args::new())?.into_owned();
        Ok(super::view::TopicLink { href: href(worked), title })
    };
    edition.on.worked.iter().map(link).collect()
}

fn href(worked: &Worked) -> String {
    format!("{PAGE}#{}", worked.name())
}

fn view(site: &Site, edition: &Edition, worked: &Worked) -> Result<WorkedView, Vec<Diagnostic>> {
    let text = |id: String| edition.text(&id, &Args::new()).map(|text| text.into_owned());
    let mut faults = Vec::new();
    for id in worked.comments() {
        faults.extend(text(format!("comment-{id}")).err().into_iter().flatten());
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let shown = |program: &str| {
        let lines: Vec<String> = program.lines().map(str::to_owned).collect();
        let relabelled = site.relabelled(edition, &lines);
        let program = Worked::with_comments(&relabelled, &|id| text(format!("comment-{id}")).unwrap_or_default());
        Value::from_safe_string(highlight::html(&program, &|_| false))
    };
    let called = worked.called().map(|(name, text)| CalledView { name: name.to_owned(), program: shown(text) });
    let entries = defined::cycles(worked).into_iter().filter_map(|key| edition.entry(key));
    Ok(WorkedView {
        id: worked.name().to_owned(),
        href: href(worked),
        title: text(format!("program-{}", worked.name()))?,
        shows: text(format!("program-{}.shows", worked.name()))?,
        program: shown(worked.text()),
        called: called.collect(),
        cycles: entries.map(link).collect(),
        figures: Vec::new(),
    })
}

/// The pictures of a program.
fn figures<'a>(site: &Site<'a>, edition: &Edition<'a>, worked: &'a Worked) -> Result<Vec<FigureView>, Vec<Diagnostic>> {
    let Some(entry) = edition.entry(worked.key) else { return Ok(Vec::new()) };
    let vocabulary = Vocabulary::of(edition.on, entry.cycle, edition.language);
    let text = CycleText::new(edition.on, entry.cycle, edition.language, &vocabulary);
    let view = |figure: &crate::output::figure::Figure<'_>| {
        let svg = figure.svg(&text, Medium::Page);
        FigureView { svg: Value::from_safe_string(svg.text), title: svg.title, small: figure.is_of_row() }
    };
    let views = site.figures.of_program(site, edition.on, worked).iter().map(view).collect();
    let faults = text.faults();
    if faults.is_empty() { Ok(views) } else { Err(faults) }
}
