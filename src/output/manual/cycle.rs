//! The page of a cycle.
use minijinja::value::Serde;
use minijinja::{Value, context};

use super::edition::Edition;
use super::links::{Linker, Shown};
use super::page::Here;
use super::view::{
    CheckView, ChoiceView, CycleView, ExampleView, FigureView, FiguresView, Html, LinkView, ParameterTable,
    ParameterView, ResultView, RunView, StepView, TableView,
};
use super::{Site, highlight, inline, page, programs};
use crate::base::diag::Diagnostic;
use crate::base::expr::QRef;
use crate::language::label;
use crate::language::locale::Args;
use crate::language::text::{CycleText, RunPart, Vocabulary};
use crate::output::figure::{Medium, row};
use crate::spec::{Access, CycleKey, NcExample, Param, Reference, See, TakesEffect};

pub(super) fn page<'a>(site: &Site<'a>, edition: &Edition<'a>, at: usize) -> Result<String, Vec<Diagnostic>> {
    let Some(entry) = edition.entries.get(at) else { return Ok(String::new()) };
    let vocabulary = Vocabulary::of(edition.on, entry.cycle, edition.language);
    let text = CycleText::new(edition.on, entry.cycle, edition.language, &vocabulary);
    let group = edition.group_title(entry.cycle.file.group)?;
    let linker = Linker::new(edition, Some(entry.cycle), Shown::Here);
    let maker = Maker { text: &text, edition, site, linker: &linker };
    let (mut view, mut faults) = maker.cycle(&entry.name, group);
    view.comparison = site.comparison(edition, entry.cycle.key);
    view.programs = programs::of_cycle(site, edition, entry.cycle.key)?;
    let key = entry.cycle.key.to_string();
    let args = Args::new().text("name", entry.name.as_str()).text("key", key.as_str());
    let title = edition.text("page-title", &args.text("control", edition.on.control.title.as_str()))?.into_owned();
    let frame = site.frame(edition, title, Here::Cycle(at))?;
    let context = context! {
        page => Value::from(Serde(&frame)),
        words => edition.words.clone(),
        cycle => Value::from(Serde(&view)),
    };
    drop(view);
    faults.extend(text.faults());
    if !faults.is_empty() {
        return Err(faults);
    }
    site.render("cycle.html", context)
}

/// Makes the view of a cycle.
pub(super) struct Maker<'m, 't, 'a> {
    pub(super) text: &'m CycleText<'t>,
    pub(super) edition: &'m Edition<'a>,
    pub(super) site: &'m Site<'a>,
    pub(super) linker: &'m Linker<'m, 'a>,
}

impl Maker<'_, '_, '_> {
    pub(super) fn html(&self, text: &str) -> Html {
        Value::from_safe_string(inline::html(text, self.linker))
    }

    fn cycle<'v>(&'v self, name: &'v str, group: String) -> (CycleView<'v>, Vec<Diagnostic>) {
        let cycle = self.text.cycle;
        let mut faults = Vec::new();
        let examples = self.examples(&mut faults);
        let view = CycleView {
            key: cycle.key.to_string(),
            name,
            nc_name: self.text.nc_name().into_owned(),
            iso: cycle.iso.iter().map(String::as_str).collect(),
            on_call: cycle.file.takes_effect == TakesEffect::OnCall,
            options: cycle.described.options.iter().map(|number| self.option(*number)).collect(),
            group,
            as_used: cycle.described.as_used,
            siblings: self.siblings(),
            purpose: self.text.purpose().lines().map(|paragraph| self.html(paragraph)).collect(),
            figures: self.figures(),
            run: self.run(),
            notes: self.notes(),
            general: self.general(),
            topics: self.topics(),
            checks: self.checks(),
            parameters: self.parameters(),
            results: self.results(),
            tables: self.tables(),
            examples,
            programs: Vec::new(),
            see: cycle.file.see.iter().filter_map(|see| self.see(see)).collect(),
            comparison: None,
        };
        (view, faults)
    }

    fn siblings(&self) -> Vec<LinkView> {
        let group = self.text.cycle.file.group;
        self.edition.entries.iter().filter(|entry| entry.cycle.file.group == group).map(page::link).collect()
    }

    /// `#48`, with the name of the option where the locales have it.
    pub(super) fn option(&self, number: u32) -> String {
        let options = &self.text.on.control.options;
        let known = options.iter().find(|option| option.number == number);
        let name = known.and_then(|option| self.text.find(&format!("option-{}", option.option.as_str())));
        name.map_or_else(|| format!("#{number}"), |name| format!("#{number} {name}"))
    }

    fn figures(&self) -> FiguresView {
        let mut view = FiguresView { list: Vec::new(), pairs: Vec::new() };
        let Some(entry) = self.edition.entry(self.text.cycle.key) else { return view };
        for figure in self.site.figures.of(self.site, self.edition.on, entry.cycle) {
            let svg = figure.svg(self.text, Medium::Page);
            view.pairs.extend(svg.shown);
            view.list.push(FigureView {
                svg: Value::from_safe_string(svg.text),
                title: svg.title,
                small: figure.is_of_row(),
            });
        }
        view.pairs.sort();
        view.pairs.dedup();
        view
    }

    fn run(&self) -> Vec<RunView> {
        let mut stretches = Vec::new();
        self.stretches(&self.text.run(), &mut stretches);
        stretches
    }

    fn stretches(&self, parts: &[RunPart], stretches: &mut Vec<RunView>) {
        let mut below = false;
        for part in parts {
            let step = match part {
                RunPart::Section { title, parts, .. } => {
                    let title = Some(self.html(title));
                    stretches.push(RunView { title, start: 0, steps: Vec::new() });
                    self.stretches(parts, stretches);
                    below = false;
                    continue;
                }
                RunPart::Step(step) => StepView {
                    number: step.number,
                    text: self.html(&step.text),
                    bullets: step.bullets.iter().map(|bullet| self.html(&bullet.text)).collect(),
                    by_operator: step.by_operator,
                },
                RunPart::Repeat(repeat) => StepView {
                    number: repeat.number,
                    text: self.html(&repeat.text),
                    bullets: Vec::new(),
                    by_operator: false,
                },
            };
            match stretches.last_mut() {
                Some(stretch) if below || stretch.steps.is_empty() => {
                    if stretch.steps.is_empty() {
                        stretch.start = step.number;
                    }
                    stretch.steps.push(step);
                }
                _ => stretches.push(RunView { title: None, start: step.number, steps: vec![step] }),
            }
            below = true;
        }
    }

    fn checks(&self) -> Vec<CheckView> {
        let check = |guard: crate::language::text::GuardText| CheckView {
            outcome: guard.outcome.as_str(),
            text: self.html(&guard.text),
            switched_off: guard
                .switched_off_by
                // Not where the text names it already.
                .filter(|datum| !guard.text.contains(datum))
                .map(|datum| self.text.general("page-switched-off-by", &Args::new().text("datum", datum)).into_owned()),
        };
        self.text.guards().into_iter().map(check).collect()
    }

    /// A table for the parameters; one for each form of an old-style cycle.
    fn parameters(&self) -> Vec<ParameterTable> {
        let cycle = self.text.cycle;
        let row = |param| self.parameter(param);
        let mut tables = Vec::new();
        let new_form: Vec<_> = cycle.params.iter().filter(|param| param.field.is_none()).map(row).collect();
        if !new_form.is_empty() {
            tables.push(ParameterTable { title: None, rows: new_form });
        }
        for (at, form) in cycle.file.forms.iter().enumerate() {
            let rows: Vec<_> = cycle.fields(at).map(|(param, _)| self.parameter(param)).collect();
            let several = cycle.file.forms.len() > 1;
            if !rows.is_empty() {
                tables.push(ParameterTable { title: several.then(|| self.form_title(form)), rows });
            }
        }
        tables
    }

    fn form_title(&self, form: &crate::spec::Form) -> String {
        let name = self.text.form(&form.form);
        let codes: Vec<&str> = form.iso.iter().map(|iso| iso.code.as_str()).collect();
        if codes.is_empty() { name.into_owned() } else { format!("{name} ({})", codes.join(", ")) }
    }

    pub(super) fn parameter(&self, param: &Param) -> ParameterView {
        let texts = self.text.param(param);
        let choice =
            |(value, text): &(&str, std::borrow::Cow<str>)| ChoiceView { value: shown(value), text: self.html(text) };
        ParameterView {
            id: row(&texts.q),
            q: match (param.q, param.q_of_name()) {
                (Some(number), Some(name)) => format!("{number}/{name}"),
                _ => texts.q.split(' ').next().unwrap_or_default().to_owned(),
            },
            label: texts.label.map(std::borrow::Cow::into_owned),
            name: texts.name.into_owned(),
            help: self.html(&texts.help),
            reference: param.reference.map(Reference::as_str),
            input: self.input(param),
            range: self.text.plain_range(param),
            words: param.words.clone(),
            unit: self.text.unit(param.quantity).map(std::borrow::Cow::into_owned),
            choices: texts.choices.iter().map(choice).collect(),
            effective: texts.effective.map(|condition| self.html(&condition)),
            optional: param.field.as_ref().is_some_and(|field| field.optional),
            example: param.example.clone(),
        }
    }

    /// What may be entered: choices that the range does not contain, the range, words.
    fn input(&self, param: &Param) -> Vec<String> {
        let range = self.text.plain_range(param);
        // A choice such as `>0` is within any range.
        let within = |value: &str| {
            value.parse::<f64>().map_or(true, |value| {
                param.min.is_none_or(|min| value >= min) && param.max.is_none_or(|max| value <= max)
            })
        };
        let bounded = param.min.is_some() || param.max.is_some();
        let beside =
            param.choices.iter().map(|choice| choice.value.as_str()).filter(|value| !bounded || !within(value));
        let beside = beside.map(shown).collect::<Vec<_>>().join(", ");
        [Some(beside), range, Some(param.words.join(", "))]
            .into_iter()
            .flatten()
            .filter(|part| !part.is_empty())
            .collect()
    }

    fn results(&self) -> Vec<ResultView> {
        let cycle = self.text.cycle;
        let view = |outcome: &crate::spec::Outcomes| {
            Some(ResultView {
                q: outcome.q.map(|q| q.to_string()).or_else(|| self.field_name(outcome.field.as_ref()?.as_str()))?,
                text: self.html(&self.text.result(&outcome.is)),
                of: outcome.of.map(|q| q.to_string()),
            })
        };
        cycle.file.results.iter().filter_map(view).collect()
    }

    /// The line and name of a field, where a result names the field that the program fills in.
    fn field_name(&self, id: &str) -> Option<String> {
        let cycle = self.text.cycle;
        let fields = cycle.params.iter().filter_map(|param| Some((param, param.field.as_ref()?)));
        let (param, field) = fields.into_iter().find(|(_, field)| field.id.as_str() == id)?;
        Some(format!("{}.{} {}", cycle.key.number, field.line, self.text.param(param).name))
    }

    fn tables(&self) -> Vec<TableView> {
        let topic = |table: &str| {
            let named = |topic: &&super::edition::TopicPage| topic.tables.iter().any(|own| own.as_str() == table);
            self.edition.topics.iter().find(named).map(|topic| topic.file.clone())
        };
        let view = |table: &crate::spec::TableUse| TableView {
            href: topic(table.table.as_str()),
            name: self.text.table(&table.table).into_owned(),
            file: self.text.on.control.files.get(table.table.as_str()).map(|file| file.text.to_string()),
            columns: table.columns.clone(),
            reads: table.access == Some(Access::Reads),
        };
        self.text.cycle.file.tables.iter().map(view).collect()
    }

    fn examples(&self, faults: &mut Vec<Diagnostic>) -> Vec<ExampleView> {
        let mut views = Vec::new();
        for example in &self.text.cycle.file.nc_examples {
            match label::example_of(self.text, example) {
                Ok(block) => views.push(self.example(example, &block)),
                Err(more) => faults.extend(more),
            }
        }
        views
    }

    fn example(&self, example: &NcExample, block: &str) -> ExampleView {
        let mut klartext = self.site.relabelled(self.edition, &example.before);
        klartext.push_str(block);
        if !block.ends_with('\n') {
            klartext.push('\n');
        }
        klartext.push_str(&self.site.relabelled(self.edition, &example.after));
        let title = example.title.as_ref().map(|title| self.html(&self.text.title(title)));
        let cycle = self.text.cycle;
        let has_row = |name: &str| {
            let named = QRef::parse(name).filter(|q| q.to_string() == name);
            named.is_some() && cycle.params.iter().any(|param| param.q == named)
        };
        let marked = |program: &str| Value::from_safe_string(highlight::html(program, &has_row));
        let iso = self.iso_block(block, example.number).map(|iso| marked(&iso));
        ExampleView { title, klartext: marked(&klartext), iso }
    }

    /// The block in DIN/ISO, which follows from the Klartext block where the manual prints one code
    /// for a cycle with Q parameters: the code instead of the head, a tenfold number, `*` at the end.
    fn iso_block(&self, block: &str, number: Option<u32>) -> Option<String> {
        let [code] = self.text.cycle.iso.as_slice() else { return None };
        if self.text.cycle.is_old_style() {
            return None;
        }
        let mut iso = number.map_or_else(String::new, |number| format!("N{} ", number.saturating_mul(10)));
        iso.push_str(code);
        for line in block.lines().skip(1) {
            iso.push('\n');
            iso.push_str(line.strip_suffix(" ~").unwrap_or(line));
        }
        iso.push_str("*\n");
        Some(iso)
    }

    /// A related cycle: its page, or its printed name, or nothing if this control does not know it.
    fn see(&self, see: &See) -> Option<LinkView> {
        let key = CycleKey::new(see.keyword, see.cycle);
        if let Some(entry) = self.edition.entry(key) {
            return Some(page::link(entry));
        }
        let control = &self.edition.on.control;
        let named = control.named.iter().find(|named| named.keyword == see.keyword && named.number == see.cycle)?;
        let foreign = control.language.as_str() != self.edition.language.tag();
        if let Some(name) = self.site.name_elsewhere(self.edition, key).filter(|_| foreign) {
            return Some(LinkView { href: None, key: key.to_string(), number: key.number, name, name_lang: None });
        }
        Some(LinkView {
            href: None,
            key: key.to_string(),
            number: key.number,
            name: named.name.clone(),
            name_lang: foreign.then(|| control.language.text.to_string()),
        })
    }
}

/// The value of a choice as prose shows it, with a real minus sign.
fn shown(value: &str) -> String {
    value.replace('-', "\u{2212}")
}
