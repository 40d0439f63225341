//! Types of what the templates see, every value ready to be shown.
//!
//! Invariant: a field of type [`Html`] is well-formed HTML; every other text is escaped by the template.
use minijinja::Value;
use serde::Serialize;

/// HTML that a template shows as it is.
pub(super) type Html = Value;

/// What every page has.
#[derive(Serialize)]
pub(super) struct PageView {
    /// Whether it is a page of a book, and not of the site.
    pub(super) book: bool,
    /// Whether texts may be missing, which every page says.
    pub(super) draft: bool,
    /// The language tag.
    pub(super) lang: String,
    /// The title of the document.
    pub(super) title: String,
    /// The way to the root of the site.
    pub(super) root: String,
    /// Its address, where that of the site is known.
    pub(super) canonical: Option<String>,
    /// The control; empty on the first page of the site.
    pub(super) control: String,
    /// The control with its software and the date of the data, for the foot of the page.
    pub(super) imprint: Vec<String>,
    /// What each printed sheet says, as two strings of CSS: the page, and the imprint.
    pub(super) sheet: Option<(Html, Html)>,
    /// Where the page is: the control, the group, the page itself.
    pub(super) trail: Vec<TrailView>,
    /// The way to the overviews of the edition; its own directory for most pages.
    pub(super) home: String,
    /// The same page in every language.
    pub(super) languages: Vec<SwitchView>,
    /// The same page on every control, or the overview of those that do not have it.
    pub(super) controls: Vec<SwitchView>,
    /// The page before.
    pub(super) previous: Option<LinkView>,
    /// The next page.
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
    /// It leads to the overview, as there is no such page.
    pub(super) overview: bool,
}

/// A step on the way from the control to a page.
#[derive(Serialize)]
pub(super) struct TrailView {
    /// Nothing for the page itself.
    pub(super) href: Option<String>,
    pub(super) text: String,
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
    /// The cycles of its group.
    pub(super) siblings: Vec<LinkView>,
    pub(super) purpose: Vec<Html>,
    pub(super) figures: FiguresView,
    pub(super) run: Vec<RunView>,
    pub(super) notes: Vec<NoteSectionView>,
    /// Notes that hold for many cycles, on the page that says them once.
    pub(super) general: Vec<TopicLink>,
    /// Pages of prose about what surrounds it.
    pub(super) topics: Vec<TopicLink>,
    pub(super) checks: Vec<CheckView>,
    pub(super) parameters: Vec<ParameterTable>,
    pub(super) results: Vec<ResultView>,
    pub(super) tables: Vec<TableView>,
    pub(super) examples: Vec<ExampleView>,
    /// Whole programs that define it.
    pub(super) programs: Vec<WorkedView>,
    pub(super) see: Vec<LinkView>,
    /// The page that compares the controls that have the cycle.
    pub(super) comparison: Option<String>,
}

/// The figures of a cycle.
#[derive(Serialize)]
pub(super) struct FiguresView {
    pub(super) list: Vec<FigureView>,
    /// The class of each dimension with the id of the row of its parameter.
    pub(super) pairs: Vec<(String, String)>,
}

#[derive(Serialize)]
pub(super) struct FigureView {
    pub(super) svg: Html,
    pub(super) title: String,
    /// Whether it stands in a row with others.
    pub(super) small: bool,
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

/// The notes of a section.
#[derive(Serialize)]
pub(super) struct NoteSectionView {
    pub(super) id: &'static str,
    pub(super) title: String,
    pub(super) kinds: Vec<NotesView>,
}

/// A theme of the notes for many cycles.
#[derive(Serialize)]
pub(super) struct ThemeView {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) topic: Option<TopicLink>,
    pub(super) notes: Vec<ThemeNoteView>,
}

/// A note with the cycles that it holds for.
#[derive(Serialize)]
pub(super) struct ThemeNoteView {
    pub(super) kind: &'static str,
    pub(super) text: Html,
    pub(super) cycles: Vec<LinkView>,
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

#[derive(PartialEq, Serialize)]
pub(super) struct ParameterView {
    pub(super) id: String,
    pub(super) q: String,
    pub(super) label: Option<String>,
    pub(super) name: String,
    pub(super) help: Html,
    pub(super) reference: Option<&'static str>,
    /// What may be entered: values, a range, words.
    pub(super) input: Vec<String>,
    /// The printed range alone.
    pub(super) range: Option<String>,
    /// Words that may be entered.
    pub(super) words: Vec<String>,
    pub(super) unit: Option<String>,
    pub(super) choices: Vec<ChoiceView>,
    pub(super) effective: Option<Html>,
    pub(super) optional: bool,
    pub(super) example: Option<String>,
}

#[derive(PartialEq, Serialize)]
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
    /// The page that explains it.
    pub(super) href: Option<String>,
    pub(super) name: String,
    pub(super) file: Option<String>,
    pub(super) columns: Vec<String>,
    pub(super) reads: bool,
}

#[derive(Serialize)]
pub(super) struct ExampleView {
    pub(super) title: Option<Html>,
    pub(super) klartext: Html,
    pub(super) iso: Option<Html>,
}

/// A program that a worked program calls.
#[derive(Serialize)]
pub(super) struct CalledView {
    pub(super) name: String,
    pub(super) program: Html,
}

/// A worked program.
#[derive(Serialize)]
pub(super) struct WorkedView {
    pub(super) id: String,
    /// The way to it on the page of all programs.
    pub(super) href: String,
    pub(super) title: String,
    /// What it shows, in a sentence.
    pub(super) shows: String,
    pub(super) program: Html,
    /// The programs that it calls.
    pub(super) called: Vec<CalledView>,
    /// The cycles that it defines.
    pub(super) cycles: Vec<LinkView>,
    pub(super) figures: Vec<FigureView>,
}

/// An overview.
#[derive(Serialize)]
pub(super) struct OverviewView {
    pub(super) groups: Vec<GroupView>,
    pub(super) named: Vec<LinkView>,
    pub(super) programs: Vec<TopicLink>,
    pub(super) topics: Vec<TopicLink>,
}

/// A link to a topic.
#[derive(Clone, Serialize)]
pub(super) struct TopicLink {
    pub(super) href: String,
    pub(super) title: String,
}

/// A topic.
#[derive(Serialize)]
pub(super) struct TopicView {
    pub(super) title: String,
    pub(super) body: Html,
}

/// A Q parameter with the names that it has, and the cycles that use each.
#[derive(Serialize)]
pub(super) struct QView {
    pub(super) q: String,
    pub(super) uses: Vec<UseView>,
}

/// A name with the places where it is used.
#[derive(Serialize)]
pub(super) struct UseView {
    pub(super) name: String,
    pub(super) places: Vec<LinkView>,
}

/// The entries of the index below one letter.
#[derive(Serialize)]
pub(super) struct LetterView {
    pub(super) letter: String,
    /// The id of the heading.
    pub(super) id: String,
    pub(super) entries: Vec<UseView>,
}

/// A term of the glossary.
#[derive(Serialize)]
pub(super) struct TermView {
    pub(super) id: String,
    pub(super) term: String,
    pub(super) definition: Html,
    /// The word of the source language, for those who know the trade by it.
    pub(super) source: Option<String>,
}

/// A cycle on several controls.
#[derive(Serialize)]
pub(super) struct ComparisonView {
    pub(super) key: String,
    pub(super) name: String,
    pub(super) columns: Vec<ColumnView>,
    pub(super) rows: Vec<ComparedView>,
}

/// The cycle on one of the controls.
#[derive(Serialize)]
pub(super) struct ColumnView {
    pub(super) control: String,
    pub(super) href: String,
    pub(super) nc_name: String,
    pub(super) iso: Vec<String>,
    pub(super) options: Vec<String>,
}

/// A parameter on each of the controls; nothing where it is not there.
#[derive(Serialize)]
pub(super) struct ComparedView {
    pub(super) q: String,
    /// In what the controls differ: `presence`, `reference`, `range`, `words`, `choices`, `condition`.
    pub(super) differs: Vec<&'static str>,
    pub(super) cells: Vec<Option<ParameterView>>,
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
    /// The NC software from which its manuals hold.
    pub(super) states: Vec<String>,
    /// How many cycles are described.
    pub(super) cycles: usize,
    pub(super) links: Vec<SwitchView>,
}

/// What the first page says in a language.
#[derive(Serialize)]
pub(super) struct Invitation {
    pub(super) lang: String,
    /// The name of the language.
    pub(super) name: String,
    pub(super) manual: String,
    pub(super) intro: String,
    pub(super) safety: String,
    /// That a page does not exist.
    pub(super) missing: String,
    pub(super) controls: Vec<SwitchView>,
}
