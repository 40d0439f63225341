//! A site that is ready to be written: what every page of it is made from.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use minijinja::Environment;

use super::edition::Edition;
use super::escape::escape;
use crate::base::diag::Diagnostic;
use crate::check::LabelBook;
use crate::language::locale::{Language, Locales};
use crate::output::figure::{self, Figure};
use crate::spec::{Catalogue, Cycle, CycleKey, OnControl, Worked};
use crate::tools::conform::World;

/// A cycle in a language on at least two controls.
pub(super) struct Comparison {
    /// The path of its page.
    pub(super) path: String,
    pub(super) key: CycleKey,
    /// The editions of the language that have the cycle.
    pub(super) editions: Vec<usize>,
}

/// The figures of the cycles of each control: those of a cycle are run when a page first shows them.
#[derive(Default)]
pub(super) struct Figures<'a> {
    made: BTreeMap<(&'a str, CycleKey), OnceLock<Vec<Figure<'a>>>>,
    /// Those of worked programs, by control and name.
    of_programs: BTreeMap<(&'a str, &'a str), OnceLock<Vec<Figure<'a>>>>,
    files: &'a [(String, String)],
}

impl<'a> Figures<'a> {
    pub(super) fn new(controls: impl Iterator<Item = &'a OnControl>, files: &'a [(String, String)]) -> Self {
        let (mut made, mut of_programs) = (BTreeMap::new(), BTreeMap::new());
        for on in controls {
            made.extend(on.cycles.keys().map(|key| ((on.id(), *key), OnceLock::new())));
            of_programs.extend(on.worked.iter().map(|worked| ((on.id(), worked.name()), OnceLock::new())));
        }
        Self { made, of_programs, files }
    }

    /// A data file.
    #[cfg(feature = "pdf")]
    pub(super) fn file(&self, path: &str) -> Option<&'a str> {
        self.files.iter().find(|(own, _)| own == path).map(|(_, text)| text.as_str())
    }

    /// The figures of a cycle; none that is wrong, which the linter says.
    pub(super) fn of(&self, site: &Site<'a>, on: &'a OnControl, cycle: &'a Cycle) -> &[Figure<'a>] {
        let Some(made) = self.made.get(&(on.id(), cycle.key)) else { return &[] };
        let world = World { catalogue: site.catalogue, locales: site.locales, files: self.files };
        made.get_or_init(|| figure::prepare(&world, on, cycle).0)
    }
}

impl<'a> Figures<'a> {
    /// The pictures of a worked program, in the same way.
    pub(super) fn of_program(&self, site: &Site<'a>, on: &'a OnControl, worked: &'a Worked) -> &[Figure<'a>] {
        let Some(made) = self.of_programs.get(&(on.id(), worked.name())) else { return &[] };
        let world = World { catalogue: site.catalogue, locales: site.locales, files: self.files };
        made.get_or_init(|| figure::prepare_worked(&world, on, worked).0)
    }
}

/// A site that is ready to be written.
pub struct Site<'a> {
    pub(super) editions: Vec<Edition<'a>>,
    pub(super) comparisons: Vec<Comparison>,
    pub(super) source: Option<&'a Language>,
    pub(super) catalogue: &'a Catalogue,
    pub(super) locales: &'a Locales,
    /// The labels of each control, to write its printed lines in other languages.
    pub(super) labels: BTreeMap<&'a str, LabelBook<'a>>,
    pub(super) templates: Environment<'a>,
    /// A template that has no end, once a page has shown it: the other pages do not try it again.
    pub(super) endless: OnceLock<(String, Diagnostic)>,
    /// The address of the site, which ends with `/`.
    pub(super) base_url: Option<String>,
    pub(super) assets: Vec<(&'a str, &'a str)>,
    pub(super) figures: Figures<'a>,
    /// Whether its pages are those of books.
    pub(super) is_book: bool,
    /// Whether texts may be missing.
    pub(super) is_draft: bool,
    /// Whether a server shows it to those who work on it.
    pub(super) is_served: bool,
}

impl Site<'_> {
    /// Has every page say that the texts are not complete.
    pub const fn mark_as_draft(&mut self) {
        self.is_draft = true;
    }

    /// The address of a page, where that of the site is known.
    pub(super) fn address(&self, path: &str) -> Option<String> {
        self.base_url.as_ref().map(|base| format!("{base}{path}"))
    }

    /// The list of all pages for search engines.
    pub(super) fn sitemap(&self, pages: &BTreeSet<String>) -> Option<String> {
        let base = self.base_url.as_ref()?;
        let mut xml = String::from(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n",
        );
        for page in pages {
            xml.push_str("<url><loc>");
            escape(base, &mut xml);
            escape(page, &mut xml);
            xml.push_str("</loc></url>\n");
        }
        xml.push_str("</urlset>\n");
        Some(xml)
    }

    /// A page by its template.
    pub(super) fn render(&self, template: &str, view: minijinja::Value) -> Result<String, Vec<Diagnostic>> {
        if let Some((_, fault)) = self.endless.get().filter(|(own, _)| own == template) {
            return Err(vec![fault.clone()]);
        }
        let rendered = self.templates.get_template(template).and_then(|template| template.render(view));
        rendered.map_err(|error| {
            let fault = template_fault(template, &error);
            if error.kind() == minijinja::ErrorKind::OutOfFuel {
                let _ = self.endless.set((template.to_owned(), fault.clone()));
            }
            vec![fault]
        })
    }
}

pub(super) fn template_fault(name: &str, error: &minijinja::Error) -> Diagnostic {
    let name = error.name().unwrap_or(name);
    let diagnostic = Diagnostic::global("manual-template").arg("template", name).arg("line", error.line().unwrap_or(0));
    diagnostic.arg("reason", error.to_string())
}
