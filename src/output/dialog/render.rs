//! A dialog as a terminal shows it.
use std::fmt::Write as _;

use serde_json::Value;

use super::{Dialog, DialogField};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Language, Scope};

/// The dialog as text, ending with a line break.
///
/// # Errors
/// Every caption that is missing.
pub fn render(dialog: &Dialog, language: &Language) -> Result<String, Vec<Diagnostic>> {
    let mut page = Page { language, text: String::new(), faults: Vec::new() };
    let _ = writeln!(page.text, "{} {} {}", dialog.keyword, dialog.number, dialog.nc_name);
    let _ = writeln!(page.text, "{}", dialog.title);
    for field in &dialog.fields {
        page.field(field);
    }
    if page.faults.is_empty() { Ok(page.text) } else { Err(page.faults) }
}

struct Page<'l> {
    language: &'l Language,
    text: String,
    faults: Vec<Diagnostic>,
}

impl Page<'_> {
    fn caption(&mut self, key: &str) -> String {
        match self.language.text(key, &Scope::NONE, &Args::new()) {
            Ok(caption) => caption.into_owned(),
            Err(error) => {
                self.faults.push(error.into());
                String::new()
            }
        }
    }

    fn line(&mut self, caption: &str, value: &str) {
        let caption = self.caption(caption);
        let _ = writeln!(self.text, "      {caption}: {value}");
    }

    fn field(&mut self, field: &DialogField) {
        let form = field.form_name.as_ref().map_or_else(String::new, |form| format!(" ({form})"));
        let _ = writeln!(self.text, "\n{}{form}  {}", field.q, field.prompt);
        if field.prompt.trim_end_matches(['?', ' ']) != field.name {
            let _ = writeln!(self.text, "      {}", field.name);
        }
        let _ = writeln!(self.text, "      {}", field.help.replace('\n', "\n      "));
        if let Some(reference) = field.reference {
            let reference = self.caption(&format!("reference-{reference}"));
            self.line("caption-reference", &reference);
        }
        match (&field.range, &field.unit) {
            (Some(range), _) => self.line("caption-range", range),
            (None, Some(unit)) => self.line("caption-unit", unit),
            (None, None) => {}
        }
        for choice in &field.choices {
            let value = match &choice.value {
                Value::String(text) => text.clone(),
                value => value.to_string(),
            };
            let _ = writeln!(self.text, "      {value:>4} = {}", choice.text);
        }
        if !field.words.is_empty() {
            self.line("caption-words", &field.words.join(", "));
        }
        if let Some(effective) = &field.effective {
            self.line("caption-effective", effective);
        }
        if field.optional {
            let optional = self.caption("optional-field");
            let _ = writeln!(self.text, "      {optional}");
        }
        if let Some(example) = &field.example {
            self.line("caption-example", example);
        }
    }
}
