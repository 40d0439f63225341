//! What a program does to its blank when it is executed, for the checker: the engine knows the ways through
//! subprograms, called programs, patterns, transformations and parameters that the checker does not follow.
//!
//! Tools of which nothing is known, presets and the way that the tool takes after a change are assumed, so only what
//! does not depend on them is reported: what a tool has removed is taken for more than it may be, and what it meets is
//! looked at along the line of its tip. Nothing is said while a rotary axis is away from zero, while the workpiece
//! turns, while a probe is in the spindle, while a tool has another axis than the blank, and after a second preset. Of
//! a program without a blank only holes and the use of its tools are followed.
//!
//! `mod.rs` sets up the run, `body.rs` is the blank, `remains.rs` what is left of it, `watcher.rs` follows the events (`known.rs` where the tool is),
//! `cuts.rs` judges movements that cut, `work.rs` what a cycle has done, `path.rs` what plain movements have, `curves.rs` curves and
//! contours of them (`tracks.rs` keeps them),
//! `tilted.rs` what is done in a tilted plane, `turned.rs` what is turned (`lathe.rs` keeps the workpiece meanwhile),
//! `overlaps.rs` compares pockets and holes (`areas.rs`), `edges.rs` finds what open contours leave (`walls.rs`),
//! `series.rs` the holes of the whole program together, `undescribed.rs` what cycles do that are passed over, `unsure.rs`
//! forgets what is no longer known. `works.rs` is for an execution with the real stock: cycles that remove nothing.
//!
//! Invariant: a run is bounded. It goes on after a cycle that fails or that nobody describes, and what that cycle may
//! have changed is forgotten; elsewhere it ends where the engine cannot go on, and what was seen before holds.
mod areas;
mod body;
mod curves;
mod cuts;
mod edges;
mod known;
mod lathe;
mod overlaps;
mod path;
pub mod presets;
mod remains;
mod series;
mod tilted;
mod tracks;
mod turned;
mod undescribed;
mod unsure;
mod walls;
mod watcher;
mod ways;
mod work;
pub mod works;

use self::body::Body;
use self::presets::{any_preset, goes_on};
use self::watcher::Watcher;
use crate::base::diag::Source;
use crate::check::{Observed, ToolKind, TurnedPart, diameter_of};
use crate::engine::geometry::Axis;
use crate::engine::run::{Engine, Limits, NoTexts, Programs};
use crate::engine::scene::guess::{Guess, GuessedTool, Origin};
use crate::engine::scene::{ParameterValue, Scene};
use crate::engine::stock::Blank;
use crate::program::fields::key;
use crate::program::syntax::{self, Amount, BlockKind, CallForm, FeedKind, Program, ToolRef};
use crate::program::table::Table;
use crate::spec::{Catalogue, Known, OnControl};

/// Longer programs are not executed: posts write them, and their ways are all in the text.
const MOST_BLOCKS: usize = 3_000;
/// What a run may do.
const LIMITS: Limits = Limits { blocks: 50_000, jumps: 10_000, depth: 19, members: 2_000, moves: 50_000 };

/// The program, what it is executed on, and what is known of its tools.
#[derive(Clone, Copy)]
pub struct Rehearsal<'r> {
    /// The control.
    pub on: &'r OnControl,
    /// The others, for cycles that the manual of this one only names.
    pub catalogue: &'r Catalogue,
    /// The files of machines.
    pub files: &'r [(String, String)],
    /// The tool table.
    pub tools: Option<&'r Table>,
    /// The programs that it calls.
    pub programs: Option<&'r dyn Programs>,
}

impl Rehearsal<'_> {
    /// What the execution of a program shows. `beside` adds to its scene what lies beside the program.
    pub fn observed(&self, program: &Program, beside: &dyn Fn(&mut Scene)) -> Vec<Observed> {
        self.watch(program, beside).unwrap_or_default()
    }

    fn watch(&self, program: &Program, beside: &dyn Fn(&mut Scene)) -> Option<Vec<Observed>> {
        if program.blocks().len() > MOST_BLOCKS {
            return None;
        }
        let without = without_obstacles(program);
        let program = without.as_ref().unwrap_or(program);
        let blank = Blank::of_program(program, Axis::Z).and_then(Result::ok);
        let body = blank.as_ref().map(Body::of);
        if body.is_none() && !calls_a_tool(program) {
            return None;
        }
        let on = describing(self.on, self.catalogue, program);
        let mut guess = Guess::of(on, &[program], blank.and_then(|own| own.guessed()), self.tools, self.files);
        for tool in &mut guess.tools {
            tool.plunges = !tool.probes && !tool.turns;
        }
        let mut text = guess.to_yaml(&|_| String::new());
        text.push_str(&any_preset());
        text.push_str(&goes_on());
        let mut scene = Scene::parse(&Source::new("scene", text), self.files).ok()?;
        // A tool that cuts at its centre plunges in any way.
        if let Some(name) = on.datum("suppress-plunge-err") {
            scene.machine_parameters.push((name.to_owned(), ParameterValue::Number(1.0)));
        }
        guess.assume_inserts(&scene.tools, &mut scene.turning_tools);
        beside(&mut scene);
        let mut watcher = Watcher::new((on, self.catalogue), program, body, &scene);
        for tool in guess.tools.iter().filter(|tool| tool.origin != Origin::Assumed && tool.size[1] > 0.0) {
            watcher.radii.push((tool.number, tool.size[1]));
            watcher.flat.extend(self.flat(tool).map(|radius| (tool.number, radius)));
            let point = self.tools.and_then(|table| table.number(tool.number, "T-ANGLE").ok().flatten());
            watcher
                .points
                .extend(point.filter(|angle| (10.0..170.0).contains(angle)).map(|angle| (tool.number, angle)));
        }
        watcher.kinds = guess.tools.iter().filter_map(|tool| Some((tool.number, self.kind(program, tool)?))).collect();
        let called = |number: f64| guess.tools.iter().any(|tool| tool.number == number);
        watcher.spare_thread_mill = self.tools.is_some_and(|table| {
            let named = |row: f64| table.text(row, "NAME").ok().and_then(ToolKind::named);
            table.rows().any(|row| named(row) == Some(ToolKind::ThreadMill) && !called(row))
        });
        let turning = || guess.tools.iter().filter(|tool| tool.turns);
        let named = turning().filter_map(|tool| Some((tool.number, self.said(program, tool, &TurnedPart::named)?)));
        watcher.turned.named = named.collect();
        watcher.turned.bars = turning().filter_map(|tool| Some((tool.number, self.bar(program, tool)?))).collect();
        // An angle of an axis means another place of a tilted plane on every machine.
        let tilts = program
            .blocks()
            .iter()
            .any(|block| matches!(&block.kind, BlockKind::Statement(own) if own.kind == syntax::StatementKind::Plane));
        watcher.depends_on_machine = tilts && guess.positions_rotary_axes();
        watcher.probes = guess.tools.iter().filter(|tool| tool.probes).map(|tool| tool.number).collect();
        let engine = Engine::new(program, on, &scene, &NoTexts)
            .with_catalogue(self.catalogue)
            .with_limits(LIMITS)
            .touching_as_expected()
            .going_on_after_faults();
        let engine = match self.programs {
            Some(programs) => engine.with_programs(programs),
            None => engine,
        };
        engine.observe(&mut |event| watcher.see(event));
        Some(watcher.found)
    }

    /// The radius within which a tool is flat at its end, as the table has it.
    fn flat(&self, tool: &GuessedTool) -> Option<f64> {
        let table = self.tools?;
        let value = |column| table.number(tool.number, column).ok().flatten();
        (value("T-ANGLE").unwrap_or_default() == 0.0).then_some(())?;
        Some(value("R")? - value("R2").unwrap_or_default())
    }

    /// What a tool is called.
    fn kind(&self, program: &Program, tool: &GuessedTool) -> Option<ToolKind> {
        self.said(program, tool, &ToolKind::named)
    }

    /// How wide a bar for turning inside is, by its name.
    fn bar(&self, program: &Program, tool: &GuessedTool) -> Option<f64> {
        let inside = self.said(program, tool, &TurnedPart::named) == Some(TurnedPart::Inside);
        let name = self.tools.and_then(|table| table.text(tool.number, "NAME").ok()).or(tool.name.as_deref())?;
        diameter_of(name).filter(|_| inside)
    }

    /// What is read off the words for a tool: in the table, in the program, or in the comment beside its call.
    fn said<T>(&self, program: &Program, tool: &GuessedTool, read: &dyn Fn(&str) -> Option<T>) -> Option<T> {
        let cell = |column| self.tools.and_then(|table| table.text(tool.number, column).ok());
        let named = cell("NAME").and_then(read);
        named.or_else(|| tool.name.as_deref().and_then(read)).or_else(|| {
            program.blocks().iter().find_map(|block| {
                let called = match &block.kind {
                    BlockKind::ToolCall(call) => call.tool?,
                    BlockKind::ToolDef(own) => own.tool,
                    _ => return None,
                };
                let own = matches!(called, ToolRef::Number(own) if own.amount == Amount::Number(tool.number));
                let comment = block.comment().filter(|_| own)?;
                read(program.slice(comment))
            })
        })
    }
}

/// The program without what would end its execution and changes nothing of where the tool goes, if it has such: blocks
/// that only round the way to a contour and from it are comments, since the manuals do not say where the tool goes
/// there; a feed of some height stands for `FMAX` at the points of a table, which no control takes and a finding names.
pub fn without_obstacles(program: &Program) -> Option<Program> {
    let source = program.source().text();
    let mut edits = Vec::new();
    let table = program.blocks().iter().any(|block| match &block.kind {
        BlockKind::Sel(own) => program.slice(own.what).eq_ignore_ascii_case("PATTERN"),
        _ => false,
    });
    for block in program.blocks() {
        if block.is_blend() {
            let code = source.get(block.span.start..)?.find(['G', 'g'])? + block.span.start;
            edits.push((code..code + 1, ';'));
        }
        if let BlockKind::CyclCall(call) = &block.kind
            && table
            && matches!(call.form, CallForm::Pattern)
            && let Some(feed) = call.feed.as_ref().filter(|feed| matches!(feed.kind, FeedKind::Max))
        {
            edits.push((feed.span.start + 1..feed.span.end, '9'));
        }
    }
    if edits.is_empty() {
        return None;
    }
    // What else is left of DIN/ISO must not be passed over as a comment: the execution ends there.
    let left = program.blocks().iter().filter(|block| matches!(block.kind, BlockKind::Iso(_)) && !block.is_blend());
    edits.extend(left.filter_map(|block| block.comment()).map(|span| (span.start..span.start + 1, '?')));
    let mut text = source.as_bytes().to_vec();
    for (place, sign) in edits {
        text.get_mut(place)?.fill(sign as u8);
    }
    let edited = syntax::parse(&Source::new(program.source().name(), String::from_utf8(text).ok()?));
    // A program that was put into Klartext keeps the lines of the file that it was made from.
    let mut lines = program.blocks().iter().map(|block| block.line);
    let same = edited.blocks().len() == program.blocks().len();
    same.then(|| edited.with_blocks(&mut |block| block.line = lines.next().unwrap_or(block.line)))
}

/// The control itself, or the one that describes most of the cycles of a program if this one lacks some: enough to see
/// where the tool goes.
pub fn describing<'c>(own: &'c OnControl, catalogue: &'c Catalogue, program: &Program) -> &'c OnControl {
    let mut keys = std::collections::BTreeSet::new();
    program.each_cycle(|view| {
        keys.insert(key(view.keyword, view.number));
    });
    let lacks = |on: &OnControl| keys.iter().filter(|key| matches!(on.known(**key), Known::Unknown)).count();
    if lacks(own) == 0 {
        return own;
    }
    let others = catalogue.controls.values().filter(|other| other.id() != own.id()).rev();
    std::iter::once(own).chain(others).min_by_key(|on| lacks(on)).unwrap_or(own)
}

/// Whether a program calls a tool: without one, and without a blank, what is executed shows nothing.
fn calls_a_tool(program: &Program) -> bool {
    program.blocks().iter().any(|block| matches!(&block.kind, BlockKind::ToolCall(call) if call.tool.is_some()))
}
