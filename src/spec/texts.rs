//! Which texts a cycle needs: the ids that the locales must have for it.
use super::catalogue::{Cycle, OnControl};
use super::form::Fragment;
use super::lint::walk;
use super::run_form::{Action, Argument, Case, Item};
use super::vocabulary::Verb;
use super::worked::Worked;

/// A text that must exist: a message id and, if it is not the message's value, an attribute.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Text {
    /// The message id without variant suffixes.
    pub id: String,
    /// The attribute.
    pub attribute: Option<&'static str>,
}

impl Text {
    /// The key by which the locales know it: `id` or `id.attribute`.
    pub fn key(&self) -> String {
        self.attribute.map_or_else(|| self.id.clone(), |attribute| format!("{}.{attribute}", self.id))
    }
}

struct Collector<'c> {
    on: &'c OnControl,
    found: Vec<Text>,
    fragments: Vec<String>,
}

/// All texts that the cycle needs in every language, without repetition, sorted.
pub fn texts(cycle: &Cycle, on: &OnControl) -> Vec<Text> {
    let mut all = Collector { on, found: Vec::new(), fragments: Vec::new() };
    all.cycle(cycle);
    for item in &cycle.file.run {
        walk(item, &mut |item| all.item(item));
    }
    for guard in &cycle.file.guards {
        match (&guard.code, &guard.r#use) {
            (Some(code), _) => all.value("guard", code.as_str()),
            (None, Some(fragment)) => all.fragment(fragment.as_str()),
            (None, None) => {}
        }
    }
    cycle.file.doubts.iter().for_each(|doubt| all.value("guard", doubt.code.as_str()));
    on.worked_of(cycle.key).for_each(|worked| all.worked(worked));
    all.found.sort();
    all.found.dedup();
    all.found
}

impl Collector<'_> {
    fn value(&mut self, space: &str, id: &str) {
        self.found.push(Text { id: format!("{space}-{id}"), attribute: None });
    }

    fn attribute(&mut self, space: &str, id: &str, attribute: &'static str) {
        self.found.push(Text { id: format!("{space}-{id}"), attribute: Some(attribute) });
    }

    fn cycle(&mut self, cycle: &Cycle) {
        self.value("cycle", cycle.name());
        self.attribute("cycle", cycle.name(), "nc");
        self.attribute("cycle", cycle.name(), "purpose");
        self.value("cycle-group", cycle.file.group.as_str());
        for param in &cycle.params {
            self.value("parameter", param.is.as_str());
            self.attribute("parameter", param.is.as_str(), "help");
            match &param.field {
                None => self.attribute("parameter", param.is.as_str(), "label"),
                Some(field) if field.shape == super::vocabulary::Shape::Labelled => {
                    self.attribute("parameter", param.is.as_str(), "word");
                }
                Some(_) => {}
            }
            param.choices.iter().for_each(|choice| self.value("choice", choice.choice.as_str()));
            param.effective.iter().for_each(|condition| self.value("condition", condition.as_str()));
        }
        if cycle.file.forms.len() > 1 {
            cycle.file.forms.iter().for_each(|form| self.value("form", form.form.as_str()));
        }
        cycle.file.results.iter().for_each(|result| self.value("result", result.is.as_str()));
        cycle.file.notes.iter().for_each(|note| self.value("note", note.note.as_str()));
        cycle.file.figures.iter().for_each(|figure| self.value("figure", figure.name.as_str()));
        cycle.file.tables.iter().for_each(|table| self.value("table", table.table.as_str()));
        let titles = cycle.file.nc_examples.iter().filter_map(|example| example.title.as_ref());
        titles.for_each(|title| self.value("title", title.as_str()));
    }

    fn worked(&mut self, worked: &Worked) {
        self.value("program", worked.name());
        self.attribute("program", worked.name(), "shows");
        worked.comments().for_each(|id| self.value("comment", id));
        worked.figures.iter().for_each(|figure| self.value("figure", figure.name.as_str()));
    }

    fn item(&mut self, item: &Item) {
        item.step.iter().for_each(|id| self.value("step", id.as_str()));
        item.group.iter().for_each(|id| self.value("group", id.as_str()));
        item.until.iter().for_each(|id| self.value("until", id.as_str()));
        self.cases(&item.choose);
        item.body.actions.iter().chain(&item.then).for_each(|action| self.action(action));
    }

    fn cases(&mut self, cases: &[Case]) {
        for case in cases {
            case.say.iter().for_each(|id| self.value("say", id.as_str()));
            case.actions.iter().for_each(|action| self.action(action));
        }
    }

    fn action(&mut self, action: &Action) {
        let Argument::One(name) = &action.argument else { return };
        match action.verb {
            Verb::Use => self.fragment(name.as_str()),
            Verb::Message | Verb::Ask => self.value("message", name.as_str()),
            Verb::Fail => self.value("guard", name.as_str()),
            _ => {}
        }
    }

    fn fragment(&mut self, name: &str) {
        let Some(fragment) = self.on.fragments.get(name) else { return };
        if self.fragments.iter().any(|known| known == name) {
            return;
        }
        self.fragments.push(name.to_owned());
        let Fragment { guards, actions, choose, then, .. } = fragment;
        guards.iter().filter_map(|guard| guard.code.as_ref()).for_each(|code| self.value("guard", code.as_str()));
        guards.iter().filter_map(|guard| guard.r#use.as_ref()).for_each(|used| self.fragment(used.as_str()));
        self.cases(choose);
        actions.iter().chain(then).for_each(|action| self.action(action));
    }
}
