//! The form of the files: one type a record, as `docs/spec-format.md` describes them.
//!
//! Invariant: plain data of one control, already filtered; no text that a person reads.
use serde_json::{Value, json};

use super::decode::{Context, Decode, Definitions, Entries, Formula, Name, record};
use super::vocabulary::*;
use super::yaml::{Kind, Node};
use crate::expr::QRef;

record! {
    /// Lines of a manual.
    pub struct ManualLines {
        /// The three-digit head of the manual's file name.
        manual: String,
        /// Lines, such as `1976-2047` or `1976-2047, 2100`.
        lines: String,
    }
}

record! {
    /// A control that describes the cycle.
    pub struct Described {
        /// The control.
        control: Name,
        /// Where its manual describes the cycle.
        sources: Vec<ManualLines>,
        /// Software options that the cycle needs.
        options: Vec<u32>,
        /// No description, but a worked program shows the cycle with its parameters.
        as_used: bool,
    }
}

record! {
    /// A DIN/ISO code.
    pub struct Iso {
        /// The code, such as `G251`.
        code: String,
        /// How DIN/ISO writes the fields of an old-style form, in its order; without it the form has no words there.
        words: Vec<IsoWord>,
    }
}

record! {
    /// A word of a DIN/ISO block.
    pub struct IsoWord {
        /// The field that it stands for.
        field: Name,
        /// The letter, or `P01`; nothing for fields that are written as in Klartext: coordinates, axes. A field of several
        /// values takes `P01` and those that follow.
        word: Option<String>,
    }
}

record! {
    /// A range of entry, both ends inclusive.
    pub struct Range {
        /// The least value.
        min: Option<f64>,
        /// The greatest value.
        max: Option<f64>,
        /// The greatest number of characters of a text, or of labels of a list.
        max_length: Option<u32>,
    }
}

record! {
    /// A word that may stand instead of a number.
    pub struct Word {
        /// The word, such as `FAUTO`.
        word: String,
    }
}

record! {
    /// One of the values that a parameter offers.
    pub struct Choice {
        /// The value, or a text such as `>0`.
        value: Name,
        /// The id of its text, `choice-<id>`.
        choice: Name,
    }
}

record! {
    /// A meaning of parameters: an entry of the dictionary.
    pub struct Meaning {
        /// What kind of entry.
        kind: Option<ParameterKind>,
        /// What it measures.
        quantity: Option<Quantity>,
        /// What it counts from.
        reference: Option<Reference>,
        /// The printed range.
        ranges: Vec<Range>,
        /// Words instead of a number.
        words: Vec<Word>,
        /// The values offered.
        choices: Vec<Choice>,
        /// Values that are hardly meant, on any control.
        doubtful: Vec<Doubtful>,
    }
}

record! {
    /// A dictionary file.
    pub struct Dictionary {
        /// The meanings by their ids.
        parameters: Entries<Meaning>,
    }
}

record! {
    /// A parameter of a cycle, or a field of an old-style line.
    pub struct Parameter {
        /// The Q parameter; new form only.
        q: Option<QRef>,
        /// The id of the field; old form only.
        id: Option<Name>,
        /// Its meaning in the dictionary.
        is: Name,
        /// The printed example value.
        example: Option<String>,
        /// The condition under which it acts.
        effective: Option<Name>,
        /// Its value on controls that lack it.
        neutral: Option<f64>,
        /// Its value in programs of older controls that the control itself reads in, where that is not the neutral one.
        imported: Option<f64>,
        /// Overrides the dictionary.
        kind: Option<ParameterKind>,
        /// Overrides the dictionary.
        quantity: Option<Quantity>,
        /// Overrides the dictionary.
        reference: Option<Reference>,
        /// Overrides the dictionary.
        ranges: Option<Vec<Range>>,
        /// Overrides the dictionary.
        words: Option<Vec<Word>>,
        /// Overrides the dictionary.
        choices: Option<Vec<Choice>>,
        /// Overrides the dictionary.
        doubtful: Option<Vec<Doubtful>>,
        /// Old form: how it is written.
        shape: Option<Shape>,
        /// Old form: the fixed word of the shape `word`.
        word: Option<String>,
        /// Old form: whether an `I` before the word or axis makes it incremental.
        incremental: bool,
        /// Old form: whether it may be left out.
        optional: bool,
        /// Old form: the Q parameter of the cycle named by `like` that it stands for.
        stands_for: Option<QRef>,
    }
}

record! {
    /// A line of the old form.
    pub struct Line {
        /// Its number behind the point.
        line: u32,
        /// Its fields in order.
        fields: Vec<Parameter>,
        /// Whether it may occur several times, with following numbers.
        repeat: bool,
    }
}

record! {
    /// One of the ways to write an old-style cycle.
    pub struct Form {
        /// Its id.
        form: Name,
        /// Its DIN/ISO codes.
        iso: Vec<Iso>,
        /// Its lines.
        lines: Vec<Line>,
    }
}

record! {
    /// A Q parameter that the cycle sets.
    pub struct Outcomes {
        /// The parameter.
        q: Option<QRef>,
        /// The field that names the parameter, if the program chooses it.
        field: Option<Name>,
        /// Its meaning, text `result-<is>`.
        is: Name,
        /// The input that it belongs to.
        of: Option<QRef>,
    }
}

record! {
    /// A table that the cycle reads or writes.
    pub struct TableUse {
        /// The table, text `table-<table>`.
        table: Name,
        /// The columns.
        columns: Vec<String>,
        /// Whether it is read or written; written if not said.
        access: Option<Access>,
    }
}

record! {
    /// A note.
    pub struct Note {
        /// How serious.
        kind: NoteKind,
        /// Its id, text `note-<id>`.
        note: Name,
    }
}

record! {
    /// A reference to another cycle.
    pub struct See {
        /// How it is written.
        keyword: Keyword,
        /// Its number.
        cycle: u32,
    }
}

record! {
    /// A printed NC example.
    pub struct NcExample {
        /// The number of its first block; none if the manual prints none.
        number: Option<u32>,
        /// The form, if the cycle has several.
        form: Option<Name>,
        /// Printed values by `Q…` or field id where they differ from the parameters' examples.
        values: Entries<String>,
        /// Fields or parameters that this example leaves out.
        without: Vec<Name>,
        /// Blocks before.
        before: Vec<String>,
        /// Blocks behind.
        after: Vec<String>,
        /// The id of its title, `title-<id>`.
        title: Option<Name>,
    }
}

record! {
    /// A condition under which the cycle is refused, skipped or doubted.
    pub struct Guard {
        /// Its code, text `guard-<code>`.
        code: Option<Name>,
        /// When it applies.
        when: Option<Formula>,
        /// What then.
        then: Option<Outcome>,
        /// The machine datum that switches it off when it is 0.
        switched_off_by: Option<Name>,
        /// When it is looked at.
        at: Option<Moment>,
        /// Guards of a fragment instead.
        r#use as "use": Option<Name>,
        /// Arguments of the fragment.
        with: Entries<Formula>,
    }
}

record! {
    /// A relation of values that is hardly meant: no control looks at it, the checker warns.
    pub struct Doubt {
        /// Its code, text `guard-<code>`.
        code: Name,
        /// When it applies: a formula of the Q parameters of the cycle.
        when: Formula,
        /// The parameter where it is told.
        about: QRef,
    }
}

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
        /// Actions of a step behind the bullets.
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

/// What stands under `do`: actions for a step, items for a series.
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
    /// Where it stands.
    pub place: crate::diag::Place,
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

record! {
    /// A clause that a conformance case proves: one of its keys.
    pub struct Clause {
        /// A step.
        step: Option<Name>,
        /// A parameter.
        parameter: Option<Name>,
        /// A guard or an error.
        guard: Option<Name>,
        /// A result.
        result: Option<Name>,
    }
}

/// A part of a conformance case that other modules read: its tree and its source.
#[derive(Clone, Debug)]
pub struct Tree(pub Node);

impl Decode for Tree {
    fn decode(node: &Node, _: &mut Context<'_>) -> Option<Self> {
        Some(Self(node.clone()))
    }

    fn schema(_: &mut Definitions) -> Value {
        json!({"type": "object"})
    }
}

record! {
    /// A conformance case.
    pub struct Example {
        /// Its name.
        name: Name,
        /// Values by `Q…` or field id where they differ from the parameters' examples.
        given: Entries<Name>,
        /// The form, if the cycle has several.
        form: Option<Name>,
        /// A whole program instead of the frame.
        program: Option<Name>,
        /// Blocks before the definition.
        before: Vec<String>,
        /// Blocks behind the definition or call.
        after: Vec<String>,
        /// The scene.
        scene: Option<Tree>,
        /// What it proves.
        proves: Vec<Clause>,
        /// What must come out.
        expect: Option<Tree>,
        /// Where the expected numbers come from.
        why: Option<String>,
        /// Why it cannot be executed here.
        skip: Option<String>,
    }
}

record! {
    /// A specification of a cycle.
    pub struct CycleFile {
        /// Its number.
        cycle: u32,
        /// How it is written.
        keyword: Keyword,
        /// Its name.
        name: Name,
        /// Its group.
        group: Group,
        /// Other groups in whose overview it stands, too.
        also_in: Vec<Group>,
        /// Where it is described.
        controls: Vec<Described>,
        /// Its DIN/ISO codes.
        iso: Vec<Iso>,
        /// When it acts.
        takes_effect: TakesEffect,
        /// Its parameters, new form.
        parameters: Vec<Parameter>,
        /// It is only its name: a definition without anything to enter.
        no_parameters: bool,
        /// Its lines, old form.
        forms: Vec<Form>,
        /// The name of the cycle whose run it shares.
        like: Option<Name>,
        /// Its results.
        results: Vec<Outcomes>,
        /// The tables it touches.
        tables: Vec<TableUse>,
        /// Its notes.
        notes: Vec<Note>,
        /// Related cycles.
        see: Vec<See>,
        /// Printed NC examples.
        nc_examples: Vec<NcExample>,
        /// Named values.
        lets as "let": Entries<Formula>,
        /// Named conditions.
        conditions: Entries<Formula>,
        /// Guards.
        guards: Vec<Guard>,
        /// Relations of values that are hardly meant.
        doubts: Vec<Doubt>,
        /// Its run.
        run: Vec<Item>,
        /// Conformance cases.
        examples: Vec<Example>,
    }
}

record! {
    /// A reusable piece of a run.
    pub struct Fragment {
        /// Its name.
        fragment: Name,
        /// Its arguments and their types: `number`, `point`, `text` or `truth`.
        takes: Entries<Name>,
        /// Named values of its own.
        lets as "let": Entries<Formula>,
        /// Named conditions of its own.
        conditions: Entries<Formula>,
        /// Guards.
        guards: Vec<Guard>,
        /// Actions.
        actions as "do": Vec<Action>,
        /// Bullets.
        choose: Vec<Case>,
        /// Actions behind the bullets.
        then: Vec<Action>,
    }
}
