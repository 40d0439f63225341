//! The form of a run: its items, bullets, series and actions.
//!
//! Invariant: plain data, as in [`super::form`].
use serde_json::{Value, json};

use super::decode::{Context, Decode, Definitions, Entries, Formula, Name, record};
use super::vocabulary::*;
use super::yaml::{Kind, Node};

/// A condition in a list: `chip-breaking` or `not chip-breaking`.
#[derive(Clone, Debug)]
pub struct ConditionUse {
    /// The condition's id.
    pub condition: Name,
    /// Whether it must not hold.
    pub negated: bool,
}

impl Decode for ConditionUse {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let name = Name::decode(node, cx)?;
        Some(match name.text.strip_prefix("not ") {
            Some(rest) => Self { condition: Name { text: rest.trim().into(), place: name.place }, negated: true },
            None => Self { condition: name, negated: false },
        })
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "string", "pattern": "^(not )?[a-z][a-z0-9-]*$"})
    }
}

record! {
    /// One bullet of a choice.
    pub struct Case {
        /// The conditions that must all hold; none means otherwise.
        case: Vec<ConditionUse>,
        /// The sentence of the bullet, text `say-<id>`.
        say: Option<Name>,
        /// What is done.
        actions as "do": Vec<Action>,
    }
}

record! {
    /// What is collected in every turn of a series.
    pub struct Collect {
        /// The list.
        list: Name,
        /// The value.
        value: Formula,
    }
}

record! {
    /// A numbered sentence, a titled section or a series: exactly one of `step`, `group`, `each`.
    pub struct Item {
        /// A numbered sentence: its id, text `step-<id>`.
        step: Option<Name>,
        /// A titled section: its id, text `group-<id>`.
        group: Option<Name>,
        /// A series: the name of its member.
        each: Option<Name>,
        /// Who does the step.
        by: Option<Actor>,
        /// Only executed and counted if this holds.
        when: Option<Formula>,
        /// Actions of a step, or run items of a series.
        body as "do": Body,
        /// Bullets under a step.
        choose: Vec<Case>,
        /// Actions of a step after the bullets.
        then: Vec<Action>,
        /// Items of a section.
        items: Vec<Item>,
        /// The series.
        series as "in": Option<Series>,
        /// The clause of the repetition, text `until-<id>`.
        until: Option<Name>,
        /// Run items between two members.
        between: Vec<Item>,
        /// What every turn adds to a list.
        collect: Option<Collect>,
    }
}

/// The content of `do`: actions for a step, items for a series.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// Actions.
    pub actions: Vec<Action>,
    /// Run items.
    pub items: Vec<Item>,
}

impl Decode for Body {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let Kind::List(entries) = &node.kind else {
            cx.expected(node, "list");
            return None;
        };
        let mut body = Self::default();
        for entry in entries {
            if ["step", "group", "each"].iter().any(|key| entry.get(key).is_some()) {
                body.items.extend(Item::decode(entry, cx));
            } else {
                body.actions.extend(Action::decode(entry, cx));
            }
        }
        Some(body)
    }

    fn absent() -> Option<Self> {
        Some(Self::default())
    }

    fn schema(defs: &mut Definitions) -> Value {
        json!({"type": "array", "items": {"anyOf": [Item::schema(defs), Action::schema(defs)]}})
    }
}

/// A finite series: its kind and the expressions that define it.
#[derive(Clone, Debug)]
pub struct Series {
    /// `infeeds`, `angles`, `count`, …
    pub kind: Name,
    /// Its expressions by name.
    pub with: Entries<Formula>,
}

impl Decode for Series {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let mut entries = Entries::<Entries<Formula>>::decode(node, cx)?;
        if entries.0.len() != 1 {
            cx.expected(node, "one-series");
            return None;
        }
        let (kind, with) = entries.0.pop()?;
        Some(Self { kind, with })
    }

    fn schema(defs: &mut Definitions) -> Value {
        let with = Entries::<Formula>::schema(defs);
        json!({"type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": with})
    }
}

/// The argument of a verb.
#[derive(Clone, Debug)]
pub enum Argument {
    /// An expression, id or word, as written.
    One(Name),
    /// Named expressions, ids or words.
    Many(Entries<Argument>),
    /// A list of them.
    List(Vec<Argument>),
}

impl Decode for Argument {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        match &node.kind {
            Kind::Scalar(..) => Name::decode(node, cx).map(Self::One),
            Kind::Map(_) => Entries::decode(node, cx).map(Self::Many),
            Kind::List(_) => Vec::decode(node, cx).map(Self::List),
        }
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": ["string", "number", "object", "array"]})
    }
}

/// One action: a verb with its argument and modifiers.
#[derive(Clone, Debug)]
pub struct Action {
    /// The verb.
    pub verb: Verb,
    /// Its argument.
    pub argument: Argument,
    /// The feed in mm/min.
    pub at: Option<Formula>,
    /// The name that its result is bound to.
    pub bind: Option<Name>,
    /// Only executed if this holds.
    pub when: Option<Formula>,
    /// Arguments of a fragment or strategy.
    pub with: Entries<Formula>,
    /// Its place.
    pub place: crate::base::diag::Place,
}

const MODIFIERS: [&str; 4] = ["at", "as", "when", "with"];

impl Decode for Action {
    fn decode(node: &Node, cx: &mut Context<'_>) -> Option<Self> {
        let Kind::Map(entries) = &node.kind else {
            cx.expected(node, "action");
            return None;
        };
        let mut verbs = Vec::new();
        for (key, value) in entries {
            match Verb::by_word(&key.text) {
                Some(verb) => verbs.push((verb, value)),
                None if MODIFIERS.contains(&&*key.text) => {}
                None => {
                    let known: Vec<&str> = Verb::ALL.iter().map(|verb| verb.as_str()).chain(MODIFIERS).collect();
                    cx.unknown_key(key, &known);
                }
            }
        }
        let [(verb, argument)] = verbs.as_slice() else {
            cx.expected(node, "one-verb");
            return None;
        };
        let argument = Argument::decode(argument, cx);
        let at = super::decode::field(node, "at", cx);
        let bind = super::decode::field(node, "as", cx);
        let when = super::decode::field(node, "when", cx);
        let with = super::decode::field(node, "with", cx);
        Some(Self {
            verb: *verb,
            argument: argument?,
            at: at?,
            bind: bind?,
            when: when?,
            with: with?,
            place: cx.place(node),
        })
    }

    fn schema(defs: &mut Definitions) -> Value {
        if !defs.contains_key("Action") {
            defs.insert("Action".to_owned(), Value::Null);
            let formula = Formula::schema(defs);
            let mut properties = serde_json::Map::new();
            for verb in Verb::ALL {
                properties.insert(verb.as_str().to_owned(), Argument::schema(defs));
            }
            let one: Vec<Value> = Verb::ALL.iter().map(|verb| json!({"required": [verb.as_str()]})).collect();
            properties.insert("at".to_owned(), formula.clone());
            properties.insert("as".to_owned(), json!({"type": "string"}));
            properties.insert("when".to_owned(), formula);
            properties.insert("with".to_owned(), Entries::<Formula>::schema(defs));
            super::decode::filters(&mut properties);
            let schema = json!({"type": "object", "description": "One action: exactly one verb and its modifiers.",
                "properties": properties, "additionalProperties": false, "oneOf": one});
            defs.insert("Action".to_owned(), schema);
        }
        json!({"$ref": "#/$defs/Action"})
    }
}
