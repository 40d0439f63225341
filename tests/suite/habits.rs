//! Programs as people and post-processors write them (`tests/habits.txt`).
use ciklo::base::diag::{Diagnostic, Severity, Source};
use ciklo::check::{Against, LabelBook, check};
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::{Program, json, parse};
use ciklo::tools::translate::translate;

const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };

struct Habit {
    name: &'static str,
    text: String,
    /// Codes of what must be found; nothing else may be.
    expected: Vec<&'static str>,
}

impl Habit {
    /// A whole program with the habit in its middle.
    fn program(&self) -> String {
        let head = "0 BEGIN PGM HABIT MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+100 Y+100 Z+0\n3 TOOL CALL 3 Z S2000 F200\n3 M3\n";
        format!("{head}{}999 END PGM HABIT MM\n", self.text)
    }
}

fn habits() -> Vec<Habit> {
    let mut all: Vec<Habit> = Vec::new();
    for line in include_str!("../habits.txt").split_inclusive('\n').filter(|line| !line.starts_with("; ")) {
        if let Some(name) = line.strip_prefix("== ") {
            all.push(Habit { name: name.trim(), text: String::new(), expected: Vec::new() });
            continue;
        }
        let habit = all.last_mut().expect("a name stands first");
        match line.strip_prefix('!') {
            Some(code) => habit.expected.push(code.trim()),
            None => {
                habit.text += &line
                    .replace("[TAB]", "\t")
                    .replace("[CR]", "\r")
                    .replace("[BOM]", "\u{feff}")
                    .replace("[ETX]", "\u{3}")
                    .replace("[DC1]", "\u{11}")
            }
        }
    }
    all
}

fn program(text: &str) -> Program {
    parse(&Source::new("habit.h", text))
}

#[test]
fn every_habit_is_understood() {
    let habits = habits();
    assert!(habits.len() > 20);
    for habit in &habits {
        let text = habit.program();
        let program = program(&text);
        assert_eq!(program.text(), text, "{}", habit.name);
        let unknown: Vec<_> = json::document(&program).unknown.iter().map(|it| it.text.to_owned()).collect();
        assert!(unknown.is_empty(), "{}: {unknown:?}", habit.name);
    }
}

/// The findings of every habit on the control.
fn with_data(each: impl Fn(&Habit, &Against<'_>)) {
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    let on = catalogue.on("tnc640").expect("the control");
    let labels = LabelBook::new(on, locales);
    let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    habits().iter().for_each(|habit| each(habit, &against));
}

#[test]
fn the_checker_gives_no_false_alarm() {
    with_data(|habit, against| {
        let found = check(&program(&habit.program()), against);
        let told = |it: &Diagnostic| {
            let line = it.place.as_ref().map_or(0, |place| place.start().line);
            format!("{line}: {} {:?}", it.code, it.args)
        };
        // A reader may be told more; these are pieces, not programs of their own.
        let found: Vec<&Diagnostic> = found.iter().filter(|it| it.severity == Severity::Error).collect();
        let codes: Vec<_> = found.iter().map(|it| it.code).collect();
        assert_eq!(codes, habit.expected, "{}: {:?}", habit.name, found.iter().map(|it| told(it)).collect::<Vec<_>>());
    });
}

#[test]
fn translating_there_and_back_keeps_every_byte() {
    let changed = std::cell::Cell::new(0);
    with_data(|habit, against| {
        let text = habit.program();
        // Labels in lower case come back in capitals, those of other languages in the first one.
        let first = translate(&program(&text), against, "en", UTF_8).text;
        let mut now = first.clone();
        for to in ["fi", "sl", "it", "pt", "en"] {
            let there = translate(&program(&now), against, to, UTF_8);
            assert_eq!(there.text.lines().count(), now.lines().count(), "{}", habit.name);
            changed.set(changed.get() + there.changes.len());
            now = there.text;
        }
        assert_eq!(now, first, "{}", habit.name);
        let rewritten = ["lower case", "labels in another language"].contains(&habit.name);
        assert!(rewritten || first == text, "{}:\n{first}", habit.name);
    });
    assert!(changed.get() > 200, "only {} labels were replaced", changed.get());
}
