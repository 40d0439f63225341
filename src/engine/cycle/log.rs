//! Logs: templates filled with the values of a cycle and the words of the program's language.
//!
//! Invariant: layout is in templates and words in locale files; here are neither.
use std::collections::BTreeMap;
use std::sync::Arc;

use minijinja::{Environment, UndefinedBehavior};

use crate::base::diag::Arg;
use crate::base::expr::Value;
use crate::engine::cycle::kinematics_log;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::{Class, Fault};

/// How many instructions of its template a log may take; a template of a working copy may loop without end.
const FUEL: u64 = 10_000_000;

/// How a template asks for a word.
const TEXT: &str = "text[\"";
/// How a template names the one that it fills in.
const EXTENDS: &str = "extends \"";
/// How a template asks for what was measured or saved of the kinematics.
const KINEMATICS: &str = "kinematics";
/// The log that is named after the cycle.
const OF_CYCLE: &str = "of-cycle";

/// A template with those that it extends: file names and texts, itself first.
type Templates = Vec<(String, String)>;

impl<'e> Run<'_, 'e> {
    /// Writes a log: into the file of the cycle, after what is there, or on the screen.
    pub(crate) fn log(&mut self, name: &str, screen: bool, values: &[(Arc<str>, Value)], exec: &Exec<'_, 'e>) -> Done {
        // What is only assumed is worth no log.
        if self.settings.only_assumes() {
            return Ok(());
        }
        let cycle = exec.definition.cycle;
        let name = if name == OF_CYCLE { cycle.name() } else { name };
        let (extension, templates) = self.templates(name)?;
        let context = self.context(&templates, values, exec)?;
        let failed = |error: minijinja::Error| {
            let fault = Fault::new(Class::Internal, "log-failed").arg("name", name);
            fault.arg("reason", error.to_string())
        };
        let mut environment = Environment::new();
        environment.set_fuel(Some(FUEL));
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        environment.add_filter("fixed", fixed);
        for (file, template) in &templates {
            environment.add_template(file, template).map_err(failed)?;
        }
        let main = templates.first().map_or("", |(file, _)| file);
        let mut text = environment.get_template(main).and_then(|main| main.render(context)).map_err(failed)?;
        // The engine of templates drops the last line end.
        text.push('\n');
        if screen {
            self.records.screens.push(text.clone());
            self.drives.report.report(EventKind::Log { file: None, text });
            return Ok(());
        }
        let ending = if extension == "txt" { "TXT" } else { &extension };
        let file = format!("TCHPR{}.{ending}", cycle.key.number);
        match self.records.logs.iter_mut().find(|(known, _)| *known == file) {
            Some((_, all)) => all.push_str(&text),
            None => self.records.logs.push((file.clone(), text.clone())),
        }
        self.drives.report.report(EventKind::Log { file: Some(file), text });
        Ok(())
    }

    /// Writes a file of a cycle, in place of one of that name.
    pub(crate) fn write_file(&mut self, file: String, text: String) {
        self.records.logs.retain(|(known, _)| *known != file);
        self.records.logs.push((file.clone(), text.clone()));
        self.drives.report.report(EventKind::Log { file: Some(file), text });
    }

    /// The extension of a log, its template, and the templates that this one fills in.
    fn templates(&self, name: &str) -> Result<(String, Templates), Fault> {
        let template = |name: &str| {
            let missing = || Fault::new(Class::Internal, "log-template").arg("name", name);
            self.settings.texts.template(name).ok_or_else(missing)
        };
        let (extension, text) = template(name)?;
        let mut found = vec![(format!("{name}.{extension}"), text)];
        while let Some(file) = found.last().and_then(|(_, text)| extended(text)) {
            // A template that extends itself would never end.
            if found.iter().any(|(known, _)| *known == file) {
                break;
            }
            let text = template(file.rsplit_once('.').map_or(&*file, |(stem, _)| stem))?.1;
            found.push((file, text));
        }
        Ok((extension, found))
    }

    fn context(
        &self,
        templates: &Templates,
        values: &[(Arc<str>, Value)],
        exec: &Exec<'_, 'e>,
    ) -> Result<minijinja::Value, Fault> {
        let cycle = exec.definition.cycle;
        let mut context: BTreeMap<String, minijinja::Value> = BTreeMap::new();
        for (number, value) in self.params.numbers() {
            context.insert(format!("Q{number}"), value.into());
        }
        for (number, value) in self.params.texts() {
            context.insert(format!("QS{number}"), value.into());
        }
        for (name, value) in values {
            context.insert(name.to_string(), plain(value));
        }
        let results = cycle.file.results.iter().filter_map(|result| result.q).map(|q| q.to_string());
        context.insert("results".to_owned(), results.collect::<Vec<_>>().into());
        let clock = self.drives.world.scene.clock;
        context.insert("date".to_owned(), format!("{:02}-{:02}-{:04}", clock.day, clock.month, clock.year).into());
        context.insert("time".to_owned(), format!("{}:{:02}:{:02}", clock.hour, clock.minute, clock.second).into());
        context.insert("program".to_owned(), (*self.drives.report.at().program).into());
        if templates.iter().any(|(_, template)| template.contains(KINEMATICS)) {
            context.insert(KINEMATICS.to_owned(), kinematics_log::context(&self.drives.world));
        }
        let mut words: BTreeMap<String, minijinja::Value> = BTreeMap::new();
        let asked = templates.iter().flat_map(|(_, template)| template.split(TEXT).skip(1));
        for part in asked {
            let Some((id, _)) = part.split_once('"') else { continue };
            let arguments = [("cycle", Arg::from(cycle.key.number.to_string()))];
            let text = self.settings.texts.message(id, &arguments).map_err(|diagnostic| {
                Fault::new(Class::Internal, "log-text").arg("name", id).arg("reason", diagnostic.code)
            })?;
            words.insert(id.to_owned(), text.into());
        }
        context.insert("text".to_owned(), minijinja::Value::from(words));
        Ok(minijinja::Value::from(context))
    }
}

/// The file that a template fills in.
fn extended(template: &str) -> Option<String> {
    let (_, rest) = template.split_once(EXTENDS)?;
    rest.split_once('"').map(|(file, _)| file.to_owned())
}

fn plain(value: &Value) -> minijinja::Value {
    match value {
        Value::Number(number) => (*number).into(),
        Value::Bool(truth) => (*truth).into(),
        Value::Text(text) => (**text).into(),
        Value::Point(point) => {
            minijinja::Value::from(BTreeMap::from([("main", point.x), ("minor", point.y), ("tool", point.z)]))
        }
    }
}

/// Four decimals and a point in every language, as the printed logs have them.
fn fixed(number: f64) -> String {
    let text = format!("{number:.4}");
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}
