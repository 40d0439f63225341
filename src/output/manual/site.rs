//! A site that is ready to be written: what every page of it is made from.
use std::collections::BTreeMap;

use minijinja::Environment;

use super::section::Section;
use crate::base::diag::Diagnostic;
use crate::check::LabelBook;
use crate::language::locale::Language;
use crate::spec::{Catalogue, CycleKey};

/// A cycle in a language on at least two controls.
pub(super) struct Comparison {
    /// The path of its page.
    pub(super) path: String,
    pub(super) key: CycleKey,
    /// The sections of the language that have the cycle.
    pub(super) sections: Vec<usize>,
}

/// A site that is ready to be written.
pub struct Site<'a> {
    pub(super) sections: Vec<Section<'a>>,
    pub(super) comparisons: Vec<Comparison>,
    pub(super) source: Option<&'a Language>,
    pub(super) catalogue: &'a Catalogue,
    /// The labels of each control, to write its printed lines in other languages.
    pub(super) labels: BTreeMap<&'a str, LabelBook<'a>>,
    pub(super) templates: Environment<'a>,
    pub(super) assets: Vec<(&'a str, &'a str)>,
}

impl Site<'_> {
    /// A page by its template.
    pub(super) fn render(&self, template: &str, view: minijinja::Value) -> Result<String, Vec<Diagnostic>> {
        let rendered = self.templates.get_template(template).and_then(|template| template.render(view));
        rendered.map_err(|error| vec![template_fault(template, &error)])
    }
}

pub(super) fn template_fault(name: &str, error: &minijinja::Error) -> Diagnostic {
    let name = error.name().unwrap_or(name);
    let diagnostic = Diagnostic::global("manual-template").arg("template", name).arg("line", error.line().unwrap_or(0));
    diagnostic.arg("reason", error.to_string())
}
