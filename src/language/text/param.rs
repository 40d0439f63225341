//! The texts of a parameter.
use std::borrow::Cow;

use super::{CycleText, aliases};
use crate::language::locale::{Args, Digits};
use crate::spec::{Param, ParameterKind, Quantity, Shape};

/// The texts of one parameter.
#[derive(Clone, Debug)]
pub struct ParamText<'a> {
    /// Its Q number, or `31.2 height` for a field of the old form.
    pub q: String,
    /// Its name.
    pub name: Cow<'a, str>,
    /// The comment label in NC blocks; the printed word of an old-style field, if it has one.
    pub label: Option<Cow<'a, str>>,
    /// Other printed forms of the label.
    pub label_aliases: Vec<String>,
    /// The question of the dialog.
    pub prompt: Cow<'a, str>,
    /// What it means.
    pub help: Cow<'a, str>,
    /// The phrase of the condition under which it acts.
    pub effective: Option<Cow<'a, str>>,
    /// The choices with their texts.
    pub choices: Vec<(&'a str, Cow<'a, str>)>,
}

impl<'a> CycleText<'a> {
    /// The texts of a parameter of the cycle.
    pub fn param(&self, param: &'a Param) -> ParamText<'a> {
        let id = format!("parameter-{}", param.is.as_str());
        let name = self.get(&id, &param.is.place);
        let label = self.label(param, &id);
        let label_aliases = self.label_aliases_of(param);
        let prompt = self.prompt(&id, &name);
        ParamText {
            q: param.label_in(self.cycle.key.number),
            label,
            label_aliases,
            prompt,
            help: self.get(&format!("{id}.help"), &param.is.place),
            effective: param.effective.as_ref().map(|condition| self.condition(condition)),
            choices: param.choices.iter().map(|choice| (choice.value.as_str(), self.choice(&choice.choice))).collect(),
            name,
        }
    }

    /// The question with which the dialog asks for a parameter of the cycle.
    pub fn prompt_of(&self, param: &'a Param) -> Cow<'a, str> {
        self.prompt(&format!("parameter-{}", param.is.as_str()), &self.name_of(param))
    }

    fn prompt(&self, id: &str, name: &str) -> Cow<'a, str> {
        let printed = self.find(&format!("{id}.prompt"));
        printed.unwrap_or_else(|| self.general("prompt-from-name", &Args::new().text("name", name)))
    }

    /// The name of a parameter of the cycle.
    pub fn name_of(&self, param: &'a Param) -> Cow<'a, str> {
        self.get(&format!("parameter-{}", param.is.as_str()), &param.is.place)
    }

    fn label(&self, param: &'a Param, id: &str) -> Option<Cow<'a, str>> {
        match &param.field {
            None => Some(self.get(&format!("{id}.label"), &param.is.place)),
            Some(field) => match field.shape {
                Shape::Labelled => Some(self.get(&format!("{id}.word"), &param.is.place)),
                Shape::Word => field.word.as_deref().map(Cow::Borrowed),
                _ => None,
            },
        }
    }

    /// The printed word of a labelled field, or the NC label.
    pub fn label_of(&self, param: &'a Param) -> Option<Cow<'a, str>> {
        self.label(param, &format!("parameter-{}", param.is.as_str()))
    }

    /// What figures write before the letter of an axis where several parameters have a number for each, `MIN`.
    pub fn before_axis(&self, param: &Param) -> Option<Cow<'a, str>> {
        self.find(&format!("parameter-{}.figure", param.is.as_str()))
    }

    /// Other printed forms of the label.
    pub fn label_aliases_of(&self, param: &Param) -> Vec<String> {
        let id = format!("parameter-{}.label-aliases", param.is.as_str());
        self.find(&id).map_or_else(Vec::new, |list| aliases(&list))
    }

    /// The printed range with its unit, as prose shows it: `0 to 99999.9999 mm`.
    pub fn range(&self, param: &Param) -> Option<String> {
        self.range_with(param, &|value| self.with_unit(value, param.quantity))
    }

    /// The printed range as a column shows it that has the unit beside it: `0 to 99999.9999`.
    pub fn plain_range(&self, param: &Param) -> Option<String> {
        self.range_with(param, &|value| self.number(value))
    }

    fn range_with(&self, param: &Param, with_unit: &dyn Fn(f64) -> String) -> Option<String> {
        let plain = |value| self.number(value);
        let most = param.max_length.filter(|_| param.kind != ParameterKind::LabelList && !param.lists_axes());
        let text = match (param.min, param.max, most) {
            (Some(min), Some(max), _) => {
                let (min, max) = (plain(min), with_unit(max));
                self.general("range-both", &Args::new().text("min", min.as_str()).text("max", max.as_str()))
            }
            (Some(min), None, _) => {
                let min = with_unit(min);
                self.general("range-from", &Args::new().text("min", min.as_str()))
            }
            (None, Some(max), _) => {
                let max = with_unit(max);
                self.general("range-to", &Args::new().text("max", max.as_str()))
            }
            (None, None, Some(length)) => {
                return Some(
                    self.general("range-length", &Args::new().number("length", f64::from(length))).into_owned(),
                );
            }
            (None, None, None) => return None,
        };
        Some(match most {
            None => text.into_owned(),
            Some(length) => {
                let length = self.general("range-length", &Args::new().number("length", f64::from(length)));
                format!("{text}; {length}")
            }
        })
    }

    fn with_unit(&self, value: f64, quantity: Quantity) -> String {
        let unit = unit_id(quantity).and_then(|unit| self.language.unit(value, unit, Digits::default()));
        unit.unwrap_or_else(|| self.number(value))
    }

    /// The unit of a quantity as a column shows it.
    pub fn unit(&self, quantity: Quantity) -> Option<Cow<'a, str>> {
        unit_id(quantity).map(|unit| self.general(&format!("unit-{unit}.symbol"), &Args::new()))
    }
}

const fn unit_id(quantity: Quantity) -> Option<&'static str> {
    match quantity {
        Quantity::Length => Some("mm"),
        Quantity::Angle => Some("deg"),
        Quantity::Feed => Some("mm-min"),
        Quantity::Time => Some("s"),
        Quantity::Speed => Some("rpm"),
        _ => None,
    }
}
