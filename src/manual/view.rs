//! What the templates see: one type a template, every value ready to be shown.
//!
//! Invariant: a field of type [`Html`] is well-formed HTML; every other text is escaped by the template.
use minijinja::Value;
use serde::Serialize;

/// HTML that a template shows as it is.
pub(super) type Html = Value;

/// What every page has.
#[derive(Serialize)]
pub(super) struct PageView {
    /// The language tag.
    pub(super) lang: String,
    /// The title of the document.
    pub(super) title: String,
    /// The way to the root of the site.
    pub(super) root: &'static str,
    /// The control; empty on the first page of the site.
    pub(super) control: String,
    /// The same page in every language.
    pub(super) languages: Vec<SwitchView>,
    /// The same page on every control that has it.
    pub(super) controls: Vec<SwitchView>,
    /// The page before.
    pub(super) previous: Option<LinkView>,
    /// The page behind.
    pub(super) next: Option<LinkView>,
}

/// The same page elsewhere.
#[derive(Serialize)]
pub(super) struct SwitchView {
    pub(super) href: String,
    /// The language of the page that it leads to.
    pub(super) lang: String,
    pub(super) name: String,
    pub(super) current: bool,
}

/// A link to a cycle, or its name where there is no page.
#[derive(Clone, Serialize)]
pub(super) struct LinkView {
    pub(super) href: Option<String>,
    pub(super) key: String,
    pub(super) number: u32,
    pub(super) name: String,
    /// The language of the name, if it is not that of the page.
    pub(super) name_lang: Option<String>,
}

/// A cycle.
#[derive(Serialize)]
pub(super) struct CycleView<'a> {
    pub(super) key: String,
    pub(super) name: &'a str,
    pub(super) nc_name: String,
    pub(super) iso: Vec<&'a str>,
    pub(super) on_call: bool,
    pub(super) options: Vec<String>,
    pub(super) group: String,
    pub(super) as_used: bool,
    pub(super) purpose: Vec<Html>,
    pub(super) run: Vec<RunView>,
    pub(super) notes: Vec<NotesView>,
    pub(super) checks: Vec<CheckView>,
    pub(super) parameters: Vec<ParameterTable>,
    pub(super) results: Vec<ResultView>,
    pub(super) tables: Vec<TableView>,
    pub(super) examples: Vec<ExampleView>,
    pub(super) see: Vec<LinkView>,
}

/// A stretch of the run below one heading, or below none.
#[derive(Serialize)]
pub(super) struct RunView {
    pub(super) title: Option<Html>,
    /// The number of its first step.
    pub(super) start: usize,
    pub(super) steps: Vec<StepView>,
}

#[derive(Serialize)]
pub(super) struct StepView {
    pub(super) number: usize,
    pub(super) text: Html,
    pub(super) bullets: Vec<Html>,
    pub(super) by_operator: bool,
}

/// All notes of a kind.
#[derive(Serialize)]
pub(super) struct NotesView {
    pub(super) kind: &'static str,
    pub(super) texts: Vec<Html>,
}

#[derive(Serialize)]
pub(super) struct CheckView {
    pub(super) outcome: &'static str,
    pub(super) text: Html,
    pub(super) switched_off: Option<String>,
}

/// The parameters of a form.
#[derive(Serialize)]
pub(super) struct ParameterTable {
    pub(super) title: Option<String>,
    pub(super) rows: Vec<ParameterView>,
}

#[derive(Serialize)]
pub(super) struct ParameterView {
    pub(super) id: String,
    pub(super) q: String,
    pub(super) label: Option<String>,
    pub(super) name: String,
    pub(super) help: Html,
    pub(super) reference: Option<&'static str>,
    pub(super) input: Option<String>,
    pub(super) words: Vec<String>,
    pub(super) choices: Vec<ChoiceView>,
    pub(super) effective: Option<Html>,
    pub(super) optional: bool,
    pub(super) example: Option<String>,
}

#[derive(Serialize)]
pub(super) struct ChoiceView {
    pub(super) value: String,
    pub(super) text: Html,
}

#[derive(Serialize)]
pub(super) struct ResultView {
    pub(super) q: String,
    pub(super) text: Html,
    pub(super) of: Option<String>,
}

#[derive(Serialize)]
pub(super) struct TableView {
    pub(super) name: String,
    pub(super) file: Option<String>,
    pub(super) columns: Vec<String>,
    pub(super) reads: bool,
}

#[derive(Serialize)]
pub(super) struct ExampleView {
    pub(super) title: Option<Html>,
    pub(super) klartext: String,
    pub(super) iso: Option<String>,
}

/// An overview.
#[derive(Serialize)]
pub(super) struct OverviewView {
    pub(super) groups: Vec<GroupView>,
    pub(super) by_number: Vec<LinkView>,
    pub(super) by_name: Vec<LinkView>,
    pub(super) named: Vec<LinkView>,
}

/// A group of cycles.
#[derive(Serialize)]
pub(super) struct GroupView {
    pub(super) id: &'static str,
    pub(super) title: String,
    pub(super) cycles: Vec<LinkView>,
}

/// The first page: a row a control, a link a language.
#[derive(Serialize)]
pub(super) struct ChoiceRow {
    pub(super) name: String,
    pub(super) links: Vec<SwitchView>,
}

/// The invitation to choose, in a language.
#[derive(Serialize)]
pub(super) struct Invitation {
    pub(super) lang: String,
    pub(super) text: String,
}
