//! Definitions of the old form on a control that has the same form: words are replaced, fields compared.
use super::Writer;
use crate::base::diag::{Edit, Severity};
use crate::check::Definition;
use crate::spec::{Cycle, Field, Param};

impl Writer<'_, '_> {
    pub(super) fn lines(&mut self, definition: &Definition<'_>, own: &Cycle, other: &Cycle) {
        let own_labels = self.labels(&self.request.from, own.key);
        let labels = self.labels(&self.request.to, other.key);
        let mut edits = Vec::new();
        if let (Some(span), Some(own), Some(new)) = (definition.view.name, own_labels, labels)
            && own.name.matches(self.program.slice(span))
            && !new.name.matches(self.program.slice(span))
            && let Some(name) = &new.name.label
        {
            edits.push((span, name.clone()));
        }
        for item in &definition.items {
            let Some((param, field)) = item.param.and_then(|param| Some((param, param.field.as_ref()?))) else {
                continue;
            };
            let Some((at, target)) = counterpart(own, other, field) else {
                let refused =
                    self.at("convert-field-not-on-control", Severity::Error, item.span).arg("parameter", &*item.name);
                let refused = refused.arg("value", item.printed.as_ref()).arg("cycle", definition.key.to_string());
                self.found.push(refused.arg("control", self.request.to.on.control.title.as_str()));
                continue;
            };
            self.judge(definition.key, &item.name, &item.printed, item.value_span, param, target);
            let old = item.index.zip(own_labels).and_then(|(at, labels)| labels.params.get(at));
            let new = labels.and_then(|labels| labels.params.get(at));
            if let (Some(span), Some(old), Some(new)) = (item.label, old, new)
                && old.matches(self.program.slice(span))
                && !new.matches(self.program.slice(span))
                && let Some(label) = &new.label
            {
                edits.push((span, label.clone()));
            }
        }
        let form = definition.items.iter().find_map(|item| item.param?.field.as_ref()).map_or(0, |field| field.form);
        for (param, field) in other.fields(form_of(own, other, form)) {
            let there =
                own.params.iter().filter_map(|own| own.field.as_ref()).any(|own| own.id.as_str() == field.id.as_str());
            if !there && !field.optional {
                self.no_value(definition.key, &param.label_in(definition.key.number), definition.view.head);
            }
        }
        for (span, text) in edits {
            if self.writable(&text, span) {
                self.edits.push(Edit { span, text });
            }
        }
    }
}

/// The form of the other control's cycle with the same id.
fn form_of(own: &Cycle, other: &Cycle, form: usize) -> usize {
    let id = own.file.forms.get(form).map(|form| form.form.as_str());
    other.file.forms.iter().position(|other| Some(other.form.as_str()) == id).unwrap_or(0)
}

/// The same field of the other control, with its place among the parameters.
fn counterpart<'o>(own: &Cycle, other: &'o Cycle, field: &Field) -> Option<(usize, &'o Param)> {
    let form = form_of(own, other, field.form);
    other.params.iter().enumerate().find(|(_, param)| {
        param.field.as_ref().is_some_and(|new| {
            new.form == form
                && new.id.as_str() == field.id.as_str()
                && new.line == field.line
                && new.shape == field.shape
        })
    })
}
