//! Whether labels can be printed by the control that they are for.
use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{Catalogue, Name, OnControl, Param, Shape};

/// Signs that labels may contain besides letters, digits and blanks.
pub const SIGNS: &str = ".,:;-–+/=()?'\"º°ª%#&";

/// Checks every label, NC name and prompt for every control and language: length, and of what programs contain character set
/// and case.
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
    let [cycle_name, prompt] =
        [&on.control.cycle_name, &on.control.prompt].map(|rules| rules.as_ref().map(|it| it.max_length));
    for cycle in on.cycles.values() {
        let vocabulary = Vocabulary::of(on, cycle, language);
        let text = CycleText::new(on, cycle, language, &vocabulary);
        let name = Label { says: &text.nc_name(), key: Some(format!("cycle-{}.nc", cycle.name())), most: cycle_name };
        check_label(&text, &name, &cycle.file.name, found);
        for param in &cycle.params {
            if let Some(label) = text.label_of(param) {
                let most = param.field.is_none().then_some(on.control.label.max_length);
                check_label(&text, &Label { says: &label, key: key_of(param), most }, &param.is, found);
            }
            if let Some(most) = prompt {
                check_prompt(&text, param, most, found);
            }
        }
    }
}

/// The question of the dialog, which is the name of the parameter where no other one is printed.
fn check_prompt(text: &CycleText, param: &Param, most: u32, found: &mut Vec<Diagnostic>) {
    let prompt = text.prompt_of(param);
    let length = prompt.chars().count();
    if length <= most as usize {
        return;
    }
    let scope = Scope::new(text.cycle.name(), text.on.id());
    let name = format!("parameter-{}", param.is.as_str());
    let keys = [format!("{name}.prompt"), name];
    let own = keys.iter().find_map(|key| Some((key, text.language.raw(Key::from(key), scope)?.1)));
    let place = own.as_ref().map_or_else(|| param.is.place.clone(), |(_, place)| place.clone());
    let diagnostic = Diagnostic::error("prompt-too-long", place).arg("label", prompt.as_ref());
    let diagnostic = diagnostic.arg("language", text.language.tag()).arg("cycle", text.cycle.key.to_string());
    let diagnostic = diagnostic.arg("control", text.on.id()).arg("length", length).arg("most", f64::from(most));
    found.push(match own {
        Some((key, _)) => diagnostic.arg("key", key.as_str()),
        None => diagnostic,
    });
}

/// The text in which the label of a parameter is; nothing if the specification has it.
fn key_of(param: &Param) -> Option<String> {
    let attribute = match &param.field {
        None => "label",
        Some(field) if field.shape == Shape::Labelled => "word",
        Some(_) => return None,
    };
    Some(format!("parameter-{}.{attribute}", param.is.as_str()))
}

/// What is looked at: a label or the name of a cycle.
struct Label<'l> {
    says: &'l str,
    key: Option<String>,
    /// The greatest number of characters.
    most: Option<u32>,
}

fn check_label(text: &CycleText, label: &Label, of: &Name, found: &mut Vec<Diagnostic>) {
    let Label { says, key, most } = label;
    let report = |code| {
        let scope = Scope::new(text.cycle.name(), text.on.id());
        let own = key.as_ref().and_then(|key| text.language.raw(Key::from(key), scope));
        let place = own.map_or_else(|| of.place.clone(), |(_, place)| place);
        let diagnostic = Diagnostic::error(code, place).arg("label", *says).arg("language", text.language.tag());
        let diagnostic = diagnostic.arg("cycle", text.cycle.key.to_string()).arg("control", text.on.id());
        match key {
            Some(key) => diagnostic.arg("key", key.as_str()),
            None => diagnostic,
        }
    };
    // Latin letters with the marks of Western and Central European languages.
    let printable =
        |c: char| c == ' ' || c.is_ascii_digit() || SIGNS.contains(c) || (c.is_alphabetic() && c <= '\u{17F}');
    if let Some(c) = says.chars().find(|c| !printable(*c)) {
        found.push(report("label-character").arg("character", c.to_string()));
    }
    if says.chars().any(|c| c.is_lowercase() && !SIGNS.contains(c)) {
        found.push(report("label-lower-case"));
    }
    let length = says.chars().count();
    if let Some(most) = most.filter(|most| length > *most as usize) {
        found.push(report("label-too-long").arg("length", length).arg("most", f64::from(most)));
    }
}
