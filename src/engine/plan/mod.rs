//! Plans: the run of a cycle on one control, compiled from its specification to slots and typed actions.
//!
//! Names become slots, types are settled, fragments are inlined with their arguments, conditions are compiled
//! where they are used. Whatever cannot be compiled is a diagnostic at its place in the file, so the same
//! stage serves the linter. Invariant: knows the form of specifications and no cycle; executes nothing.
mod act;
mod guard;
mod item;
mod measure;
mod names;
mod types;
mod verb;
mod watch;

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::base::diag::Diagnostic;
use crate::base::expr::QRef;
use crate::spec::{Catalogue, Cycle, OnControl};

pub use super::report::outcome::{Sentence, SentenceKind};
pub use act::{
    Act, Block, Calc, Cancel, Case, Collect, Cooling, Do, Fitted, Guard, Inlined, Item, Let, Series, SeriesKind,
    SpindleTurn, Step, StrategyCall, Target, Transform,
};
pub use names::Builtin;
pub use watch::{Watch, Watched};

use names::Names;

/// The index of a value while a plan is executed.
pub type Slot = usize;

/// An old-style field instead of a Q parameter of the run that it shares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StandsFor {
    /// The parameter as the run names it.
    pub q: QRef,
    /// The slot of the field.
    pub slot: Slot,
    /// Whether the field names the parameter that is meant, and is not its value.
    pub names_it: bool,
}

/// A compiled run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How many slots an execution needs.
    pub slots: usize,
    /// How many lists an execution needs.
    pub lists: usize,
    /// The known names that the run reads, with their slots.
    pub builtins: Vec<(Slot, Builtin)>,
    /// Slots of old-style fields by their ids.
    pub fields: Vec<(Slot, Arc<str>)>,
    /// Its parameters that are lengths or feeds, in the unit of the program.
    pub measures: Vec<QRef>,
    /// Parameters that this control lacks, with the values that stand for them.
    pub constants: Vec<(QRef, f64)>,
    /// Q parameters of the shared run that old-style fields stand for.
    pub stands_for: Vec<StandsFor>,
    /// Named values in order.
    pub lets: Vec<Let>,
    /// Guards in order.
    pub guards: Vec<Guard>,
    /// The run.
    pub items: Vec<Item>,
    /// Every sentence of the run in order, those of fragments included.
    pub sentences: Vec<Sentence>,
    /// The codes of its guards and errors, those of fragments included, in order.
    pub codes: Vec<Arc<str>>,
    /// Whether the run probes or reads data of the touch probe.
    pub probes: bool,
}

/// A compiled run with the mistakes that were found.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The run; it lacks whatever a mistake is about.
    pub plan: Arc<Plan>,
    /// What is wrong in the specification.
    pub mistakes: Vec<Diagnostic>,
}

impl Compiled {
    fn of((plan, mistakes): (Plan, Vec<Diagnostic>)) -> Self {
        Self { plan: Arc::new(plan), mistakes }
    }

    /// The same run with places at which values are noted, made for one look.
    pub fn watched(cycle: &Cycle, on: &OnControl, watches: &[Watch]) -> Self {
        Self::of(compile_watched(cycle, on, watches))
    }
}

/// The run of a cycle, compiled once for its control.
pub fn compiled(cycle: &Cycle, on: &OnControl) -> Arc<Compiled> {
    let make = || Compiled::of(compile(cycle, on));
    match on.cycles.get(&cycle.key) {
        Some(own) if std::ptr::eq(own, cycle) => on.made.get_or(cycle.key, make),
        // Another description under the same key.
        _ => Arc::new(make()),
    }
}

/// Compiles the run of a cycle. The plan lacks whatever a diagnostic is about.
fn compile(cycle: &Cycle, on: &OnControl) -> (Plan, Vec<Diagnostic>) {
    compile_watched(cycle, on, &[])
}

/// The same with places at which values are noted.
fn compile_watched(cycle: &Cycle, on: &OnControl, watches: &[Watch]) -> (Plan, Vec<Diagnostic>) {
    let mut compiler = Compiler::new(cycle, on, watches);
    let mut scope = names::Scope::default();
    compiler.old_fields(&mut scope);
    let mut lets = Vec::new();
    compiler.lets(&cycle.file.lets, &mut scope, &mut lets);
    let guards = compiler.guards(&cycle.file.guards, &scope, &mut lets);
    let mut items = compiler.items(&cycle.file.run, &mut scope);
    compiler.watch(None, &scope, &mut items);
    compiler.unused_conditions(&scope);
    let builtins = compiler.names.used_builtins();
    let probes = compiler.probes || builtins.iter().any(|(_, builtin)| builtin.is_of_probe());
    let plan = Plan {
        slots: compiler.names.slots(),
        lists: compiler.lists,
        builtins,
        fields: compiler.fields,
        measures: cycle.params.iter().filter(|param| param.is_measured()).filter_map(|param| param.q).collect(),
        constants: cycle.lacking.clone(),
        stands_for: compiler.stands_for,
        lets,
        guards,
        items,
        sentences: compiler.sentences,
        codes: compiler.codes,
        probes,
    };
    (plan, compiler.found)
}

/// Compiles every run of the catalogue and says what is wrong; what several controls share shows once.
pub fn check(catalogue: &Catalogue) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            found.extend(compile(cycle, on).1);
        }
    }
    measure::formulas(catalogue, &mut found);
    crate::base::diag::dedupe(&mut found);
    found
}

struct Compiler<'c> {
    cycle: &'c Cycle,
    on: &'c OnControl,
    watches: &'c [Watch],
    found: Vec<Diagnostic>,
    names: Names,
    lists: usize,
    fields: Vec<(Slot, Arc<str>)>,
    stands_for: Vec<StandsFor>,
    /// The fragments that are being inlined, for refusing recursion.
    inside: Vec<Arc<str>>,
    /// How many fragments were inlined so far.
    inlined: usize,
    used_conditions: BTreeSet<Arc<str>>,
    sentences: Vec<Sentence>,
    codes: Vec<Arc<str>>,
    probes: bool,
}

impl<'c> Compiler<'c> {
    fn new(cycle: &'c Cycle, on: &'c OnControl, watches: &'c [Watch]) -> Self {
        Self {
            cycle,
            on,
            watches,
            found: Vec::new(),
            names: Names::new(cycle, on),
            lists: 0,
            fields: Vec::new(),
            stands_for: Vec::new(),
            inside: Vec::new(),
            inlined: 0,
            used_conditions: BTreeSet::new(),
            sentences: Vec::new(),
            codes: Vec::new(),
            probes: false,
        }
    }

    fn code(&mut self, code: &Arc<str>) {
        if !self.codes.contains(code) {
            self.codes.push(Arc::clone(code));
        }
    }

    /// The index of a sentence, which several places of a run may share.
    fn sentence(&mut self, kind: SentenceKind, id: &Arc<str>) -> usize {
        let sentence = Sentence { kind, id: Arc::clone(id) };
        self.sentences.iter().position(|known| *known == sentence).unwrap_or_else(|| {
            self.sentences.push(sentence);
            self.sentences.len() - 1
        })
    }
}
