//! The run of a cycle as numbered sentences.
//!
//! Invariant: numbers follow from the tree alone. Every step and every repetition has one, they run
//! through all sections, and "steps 3 to 4" names what the series really contains.
use std::borrow::Cow;

use super::CycleText;
use crate::language::locale::Args;
use crate::spec::{Action, Actor, Argument, Case, Item, Verb};

/// A sentence below a step.
#[derive(Clone, Debug)]
pub struct Bullet<'a> {
    /// Its id.
    pub id: &'a str,
    /// Its text.
    pub text: Cow<'a, str>,
}

/// A numbered sentence.
#[derive(Clone, Debug)]
pub struct Step<'a> {
    /// Its number.
    pub number: usize,
    /// Its id.
    pub id: &'a str,
    /// Its text.
    pub text: Cow<'a, str>,
    /// The sentences below it.
    pub bullets: Vec<Bullet<'a>>,
    /// Whether the operator does it.
    pub by_operator: bool,
}

/// A numbered sentence that repeats steps before it.
#[derive(Clone, Debug)]
pub struct Repeat<'a> {
    /// Its number.
    pub number: usize,
    /// The id of the clause that ends it.
    pub id: &'a str,
    /// Its text.
    pub text: Cow<'a, str>,
    /// The first step that is repeated.
    pub first: usize,
    /// The last step that is repeated.
    pub last: usize,
}

/// A step or a repetition as a list shows it.
#[derive(Clone, Debug)]
pub struct Numbered<'a> {
    /// Its number.
    pub number: usize,
    /// Its id.
    pub id: &'a str,
    /// Its text.
    pub text: Cow<'a, str>,
    /// The sentences below it.
    pub bullets: Vec<Bullet<'a>>,
}

/// A part of a run.
#[derive(Clone, Debug)]
pub enum RunPart<'a> {
    /// A titled section.
    Section {
        /// Its id.
        id: &'a str,
        /// Its title.
        title: Cow<'a, str>,
        /// Its parts.
        parts: Vec<RunPart<'a>>,
    },
    /// A step.
    Step(Step<'a>),
    /// A repetition.
    Repeat(Repeat<'a>),
}

impl<'a> RunPart<'a> {
    /// Every step and repetition of the parts in order, sections dissolved.
    pub fn numbered(parts: Vec<RunPart<'a>>) -> Vec<Numbered<'a>> {
        let mut list = Vec::new();
        for part in parts {
            match part {
                RunPart::Section { parts, .. } => list.extend(Self::numbered(parts)),
                RunPart::Step(Step { number, id, text, bullets, .. }) => {
                    list.push(Numbered { number, id, text, bullets });
                }
                RunPart::Repeat(Repeat { number, id, text, .. }) => {
                    list.push(Numbered { number, id, text, bullets: Vec::new() });
                }
            }
        }
        list
    }
}

impl<'a> CycleText<'a> {
    /// The run of the cycle.
    pub fn run(&self) -> Vec<RunPart<'a>> {
        let mut parts = Vec::new();
        self.items(&self.cycle.file.run, &mut 0, &mut parts);
        parts
    }

    fn items(&self, items: &'a [Item], last: &mut usize, parts: &mut Vec<RunPart<'a>>) {
        for item in items {
            if let Some(group) = &item.group {
                let mut inside = Vec::new();
                self.items(&item.items, last, &mut inside);
                let title = self.named("group", group);
                parts.push(RunPart::Section { id: group.as_str(), title, parts: inside });
            } else if item.step.is_some() {
                parts.extend(self.step(item, last).map(RunPart::Step));
            } else {
                self.series(item, last, parts);
            }
        }
    }

    fn step(&self, item: &'a Item, last: &mut usize) -> Option<Step<'a>> {
        let name = item.step.as_ref()?;
        *last += 1;
        let mut bullets = Vec::new();
        let mut seen = Vec::new();
        self.said_by(&item.body.actions, &mut seen, &mut bullets);
        self.said_in(&item.choose, &mut seen, &mut bullets);
        self.said_by(&item.then, &mut seen, &mut bullets);
        Some(Step {
            number: *last,
            id: name.as_str(),
            text: self.named("step", name),
            bullets,
            by_operator: item.by == Some(Actor::Operator),
        })
    }

    fn series(&self, item: &'a Item, last: &mut usize, parts: &mut Vec<RunPart<'a>>) {
        let first = *last + 1;
        self.items(&item.body.items, last, parts);
        self.items(&item.between, last, parts);
        let (Some(until), true) = (&item.until, *last >= first) else { return };
        let clause = self.named("until", until);
        let args = Args::new().number("from", first as f64).number("to", *last as f64).text("until", clause.as_ref());
        let key = match *last - first {
            0 => "repeat-step",
            1 => "repeat-two-steps",
            _ => "repeat-steps",
        };
        let text = self.general(key, &args);
        let repeated = *last;
        *last += 1;
        parts.push(RunPart::Repeat(Repeat { number: *last, id: until.as_str(), text, first, last: repeated }));
    }

    fn said_in(&self, cases: &'a [Case], seen: &mut Vec<&'a str>, bullets: &mut Vec<Bullet<'a>>) {
        for case in cases {
            if let Some(say) = &case.say
                && !bullets.iter().any(|bullet| bullet.id == say.as_str())
            {
                bullets.push(Bullet { id: say.as_str(), text: self.named("say", say) });
            }
            self.said_by(&case.actions, seen, bullets);
        }
    }

    /// The sentences of the fragments that the actions use, and what the actions show or ask.
    fn said_by(&self, actions: &'a [Action], seen: &mut Vec<&'a str>, bullets: &mut Vec<Bullet<'a>>) {
        for action in actions {
            let (Verb::Use, Argument::One(name)) = (action.verb, &action.argument) else { continue };
            let Some(fragment) = self.on.fragments.get(name.as_str()) else { continue };
            // A fragment says its sentences once, however often a step uses it, and even if it contains itself.
            if seen.contains(&name.as_str()) {
                continue;
            }
            seen.push(name.as_str());
            self.said_by(&fragment.actions, seen, bullets);
            self.said_in(&fragment.choose, seen, bullets);
            self.said_by(&fragment.then, seen, bullets);
        }
    }
}
