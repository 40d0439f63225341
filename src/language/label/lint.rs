//! Whether labels can be printed by the control that they are for.
use crate::base::diag::Diagnostic;
use crate::language::locale::{Language, Locales};
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{Catalogue, Name, OnControl};

/// Signs that labels may contain besides letters, digits and blanks.
const SIGNS: &str = ".,:;-–+/=()?'\"º°ª%#&";

/// Checks every label and NC name for every control and language: character set, case and length.
/// Texts that are missing are reported by those who print them.
pub fn check(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for on in catalogue.controls.values() {
        for language in locales.iter() {
            check_control(on, language, &mut found);
        }
    }
    found
}

fn check_control(on: &OnControl, language: &Language, found: &mut Vec<Diagnostic>) {
    for cycle in on.cycles.values() {
        let vocabulary = Vocabulary::of(on, cycle, language);
        let text = CycleText::new(on, cycle, language, &vocabulary);
        check_label(&text, &text.nc_name(), &cycle.file.name, None, found);
        for param in &cycle.params {
            if let Some(label) = text.label_of(param) {
                let most = param.field.is_none().then_some(on.control.label.max_length);
                check_label(&text, &label, &param.is, most, found);
            }
        }
    }
}

fn check_label(text: &CycleText, label: &str, of: &Name, most: Option<u32>, found: &mut Vec<Diagnostic>) {
    let report = |code| {
        let diagnostic =
            Diagnostic::error(code, of.place.clone()).arg("label", label).arg("language", text.language.tag());
        diagnostic.arg("cycle", text.cycle.key.to_string()).arg("control", text.on.id())
    };
    // Latin letters with the marks of Western and Central European languages.
    let printable =
        |c: char| c == ' ' || c.is_ascii_digit() || SIGNS.contains(c) || (c.is_alphabetic() && c <= '\u{17F}');
    if let Some(c) = label.chars().find(|c| !printable(*c)) {
        found.push(report("label-character").arg("character", c.to_string()));
    }
    if label.chars().any(|c| c.is_lowercase() && !SIGNS.contains(c)) {
        found.push(report("label-lower-case"));
    }
    let length = label.chars().count();
    if let Some(most) = most.filter(|most| length > *most as usize) {
        found.push(report("label-too-long").arg("length", length).arg("most", f64::from(most)));
    }
}
