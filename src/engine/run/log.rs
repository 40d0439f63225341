//! Logs: templates filled with the values of a cycle and the words of the program's language.
//!
//! Invariant: layout stands in templates and words in locale files; here are neither.
use std::collections::BTreeMap;
use std::sync::Arc;

use minijinja::{Environment, UndefinedBehavior};

use super::cycle::Exec;
use super::fault::{Class, Fault};
use super::{Done, EventKind, Run};
use crate::diag::Arg;
use crate::expr::Value;

/// How a template asks for a word.
const TEXT: &str = "text[\"";

impl<'e> Run<'_, 'e> {
    /// Writes a log: into the file of the cycle, behind what is there.
    pub(super) fn log(&mut self, name: &str, values: &[(Arc<str>, Value)], exec: &Exec<'_, 'e>) -> Done {
        let Some((extension, template)) = self.engine.texts.template(name) else {
            return Err(Fault::new(Class::Internal, "log-template").arg("name", name).into());
        };
        let number = exec.definition.cycle.key.number;
        let context = self.context(&template, number, values)?;
        let failed = |error: minijinja::Error| {
            let fault = Fault::new(Class::Internal, "log-failed").arg("name", name);
            fault.arg("reason", error.to_string())
        };
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        environment.add_filter("fixed", fixed);
        let path = format!("{name}.{extension}");
        let mut text = environment.render_named_str(&path, &template, context).map_err(failed)?;
        // The engine of templates drops the last line end.
        text.push('\n');
        let ending = if extension == "txt" { "TXT" } else { &extension };
        let file = format!("TCHPR{number}.{ending}");
        match self.logs.iter_mut().find(|(known, _)| *known == file) {
            Some((_, all)) => all.push_str(&text),
            None => self.logs.push((file.clone(), text)),
        }
        self.tell(EventKind::Log { file });
        Ok(())
    }

    fn context(&self, template: &str, cycle: u32, values: &[(Arc<str>, Value)]) -> Result<minijinja::Value, Fault> {
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
        let clock = self.world.scene.clock;
        context.insert("date".to_owned(), format!("{:02}-{:02}-{:04}", clock.day, clock.month, clock.year).into());
        context.insert("time".to_owned(), format!("{}:{:02}:{:02}", clock.hour, clock.minute, clock.second).into());
        context.insert("program".to_owned(), (*self.at.program).into());
        let mut words: BTreeMap<String, minijinja::Value> = BTreeMap::new();
        for part in template.split(TEXT).skip(1) {
            let Some((id, _)) = part.split_once('"') else { continue };
            let arguments = [("cycle", Arg::from(cycle.to_string()))];
            let text = self.engine.texts.message(id, &arguments).map_err(|diagnostic| {
                Fault::new(Class::Internal, "log-text").arg("name", id).arg("reason", diagnostic.code)
            })?;
            words.insert(id.to_owned(), text.into());
        }
        context.insert("text".to_owned(), minijinja::Value::from(words));
        Ok(minijinja::Value::from(context))
    }
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
