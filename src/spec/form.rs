//! The form of the files: one type a record, as `docs/spec-format.md` describes them.
//!
//! Invariant: plain data of one control, already filtered; no text that a person reads.
use serde_json::{Value, json};

use super::decode::{Context, Decode, Definitions, Entries, Formula, Name, record};
use super::figure_form::{Dimension, Figure, NotShown};
use super::run_form::*;
use super::vocabulary::*;
use super::yaml::Node;
use crate::base::demand::Deferred;
use crate::base::expr::QRef;

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
        /// The letter, or `P01`; nothing for fields that are written as in Klartext: coordinates, axes. A field of
        /// several values takes `P01` and those that follow.
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
    /// A word that may replace a number.
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
    /// The values that anybody means; 0 is left to `doubtful`.
    pub struct Plausible {
        /// The least one.
        min: Option<f64>,
        /// The greatest one.
        max: Option<f64>,
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
        /// The values that anybody means, on any control, in mm, mm/min and s.
        plausible: Option<Plausible>,
        /// The characters that a text may have besides letters, digits and blanks.
        characters: Option<String>,
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
        /// What the control adds for it to programs of an earlier software version, which did not have it; empty where
        /// that is not known.
        added: Option<String>,
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
        /// Its number after the point.
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
        /// The number of blocks after it.
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
        /// When it is evaluated.
        at: Option<Moment>,
        /// The parameter at which the checker reports it, if it is not the first one that the condition measures.
        about: Option<QRef>,
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
        /// The parameter at which it is reported.
        about: QRef,
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
        /// The programs that are called, by their names.
        programs: Entries<Name>,
        /// Blocks before the definition.
        before: Vec<String>,
        /// Blocks after the definition or call.
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
    /// What a cycle wants of the contours that it machines.
    pub struct ContourWanted {
        /// It goes round them, so they end where they begin.
        closed: bool,
        /// RL or RR says on which side it goes.
        compensated: bool,
        /// It machines the first of them only.
        first_only: bool,
        /// It ends elsewhere than it began: the first position after it names both coordinates of the plane.
        displaces: bool,
        /// It turns them: they are described in Z and X.
        turned: bool,
        /// The path functions that it reads; all if there are none.
        paths: Vec<String>,
    }
}

record! {
    /// A cycle that a pattern may call.
    pub struct Combined {
        /// Its number.
        cycle: u32,
        /// A parameter whose value it must not have with the pattern.
        q: Option<QRef>,
        /// That value.
        not: Option<f64>,
    }
}

record! {
    /// A state of the control in which a manual forbids a cycle.
    pub struct RefusedState {
        /// Its name, as guards know it after `active.`.
        state: Name,
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
        /// Other groups whose overview lists it, too.
        also_in: Vec<Group>,
        /// Where it is described.
        controls: Vec<Described>,
        /// Its DIN/ISO codes.
        iso: Vec<Iso>,
        /// When it acts.
        takes_effect: TakesEffect,
        /// It works with a spindle that turns clockwise only.
        clockwise_only: bool,
        /// The cycles that it may call, if it calls the one that was defined last; any if there are none.
        combines: Vec<Combined>,
        /// Transformations that must not be active where it is defined, beyond those of its guards.
        refuses: Vec<RefusedState>,
        /// What it wants of the contours that it machines.
        contour: Option<ContourWanted>,
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
        /// Its figures.
        figures: Deferred<Vec<Figure>>,
        /// Lengths, angles and positions that no figure can show.
        not_shown: Deferred<Vec<NotShown>>,
        /// Conformance cases.
        examples: Deferred<Vec<Example>>,
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
        /// Parameters that figures show.
        dimensions: Vec<Dimension>,
        /// Actions.
        actions as "do": Vec<Action>,
        /// Bullets.
        choose: Vec<Case>,
        /// Actions after the bullets.
        then: Vec<Action>,
    }
}
