//! Executing plans: values in slots, guards, steps, choices.
//!
//! Invariant: a slot without a value is never read; an error in a named value shows only where it is needed.
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::{Type, Value};
use crate::engine::flow::definition::{Definition, FieldValue};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::memory::Spare;
use crate::engine::flow::state::Run;
use crate::engine::plan::{Block, Builtin, Calc, Case, Do, Guard, Item, Let, Slot, Step, Watched};
use crate::engine::report::ending::Done;
use crate::engine::report::ending::Leave;
use crate::engine::report::event::EventKind;
use crate::engine::report::event::MessageKind;
use crate::engine::report::event::PASSED_OVER;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::report::outcome::Noted;
use crate::engine::scene::{Orientation, ParameterValue};
use crate::engine::world::state::Tables;
use crate::engine::world::stylus::ProbeData;
use crate::spec::{Group, Moment, Outcome, TakesEffect, Transformation};

/// Cycles that call cycles go no deeper than this.
const MAX_NESTED: usize = 8;
/// The meaning of the parameter that a probing cycle adds to the clearance of the probe.
const PROBING_CLEARANCE: &str = "probing-clearance";

impl<'e> Run<'_, 'e> {
    /// Calls the last call-active cycle.
    pub(crate) fn call_last_cycle(&mut self) -> Done {
        self.drives.not_compensated("CYCL CALL")?;
        if self.cycles.last.is_none() && self.cycles.passed_over {
            if self.settings.after_faults || self.settings.only_assumes() {
                self.drives.report.report(EventKind::Function(PASSED_OVER.into()));
            }
            return Ok(());
        }
        let Some(definition) = self.cycles.last.clone() else { return Err(Fault::program("no-cycle-to-call").into()) };
        self.execute(&definition)
    }

    /// Says that a cycle is passed over, to those who go on after it.
    pub(crate) fn pass_over(&mut self) {
        if self.settings.after_faults {
            self.drives.report.report(EventKind::Function(PASSED_OVER.into()));
        }
    }

    /// The guards that look when the cycle is defined.
    pub(crate) fn at_definition(&mut self, definition: &Definition<'e>) -> Done {
        let plan = &definition.plan;
        if !plan.guards.iter().any(|guard| guard.at == Moment::Definition) {
            return Ok(());
        }
        self.in_unit_of(definition, |run| {
            let mut exec = run.exec(definition);
            run.prepare(&mut exec);
            run.guards(&plan.guards, Moment::Definition, &mut exec).map(|_| ())
        })
    }

    /// Executes a cycle; one that probes is rehearsed before, if its envelope is asked for.
    pub(crate) fn execute(&mut self, definition: &Definition<'e>) -> Done {
        if self.settings.envelope && definition.plan.probes && self.cycles.inside == 0 && self.drives.recorder.is_none()
        {
            return self.with_envelope(definition);
        }
        if !self.settings.after_faults || definition.cycle.file.takes_effect != TakesEffect::OnCall {
            return self.execute_in_scene(definition);
        }
        let before = (self.cycles.inside, self.drives.probing, self.drives.report.at().cycle.clone());
        let place = (self.calls.depth(), self.calls.program, self.calls.block);
        let done = self.execute_in_scene(definition);
        let now = (self.calls.depth(), self.calls.program, self.calls.block);
        match done {
            // What the cycle still does is not known, but the blocks after it are there.
            Err(Leave::Fault(fault)) if !matches!(fault.class, Class::Limit | Class::Internal) && now == place => {
                self.drives.report.report(EventKind::Error(fault));
                (self.cycles.inside, self.drives.probing, self.drives.report.at_mut().cycle) = before;
                Ok(())
            }
            done => done,
        }
    }

    /// Executes a cycle in the scene, or as a rehearsal.
    pub(crate) fn execute_in_scene(&mut self, definition: &Definition<'e>) -> Done {
        self.in_unit_of(definition, |run| run.execute_plan(definition))
    }

    fn execute_plan(&mut self, definition: &Definition<'e>) -> Done {
        if self.cycles.inside >= MAX_NESTED {
            return Err(Fault::new(Class::Internal, "cycle-depth-limit").arg("limit", MAX_NESTED as f64).into());
        }
        let plan = &definition.plan;
        let (outer_at, outer_probing) = (self.drives.report.at().cycle.clone(), self.drives.probing);
        self.drives.report.at_mut().cycle = Some((definition.cycle.key, None));
        let mut exec = self.exec(definition);
        if !self.memory.recall(&self.params, &mut exec) {
            self.prepare(&mut exec);
            match self.guards(&plan.guards, Moment::Call, &mut exec)? {
                Verdict::Skip => {
                    self.drives.report.at_mut().cycle = outer_at;
                    return Ok(());
                }
                Verdict::Told => {}
                Verdict::GoOn => self.memory.remember(&self.params, &exec),
            }
        }
        if plan.probes {
            self.drives.world.probe()?;
            self.drives.clearance = self.probing_clearance(definition);
        }
        let cycle = &definition.cycle.file;
        let mills = cycle.group != Group::Turning && (plan.probes || cycle.takes_effect == TakesEffect::OnCall);
        if mills && self.drives.world.system.turning {
            return Err(Fault::program("milling-mode-missing").arg("cycle", definition.cycle.key.to_string()).into());
        }
        let radius = |(_, builtin): &(Slot, Builtin)| *builtin == Builtin::ToolRadius;
        if plan.builtins.iter().any(radius) && self.drives.world.system.plane_scale().is_none() {
            return Err(Fault::program("arc-scaled-unequally").into());
        }
        self.drives.probing |= plan.probes;
        let tables = (self.cycles.inside == 0).then(|| self.drives.world.tables());
        self.cycles.inside += 1;
        let ended = self.items(&plan.items, &mut exec);
        self.executed(definition, &exec.sentences);
        if let Some(tables) = tables {
            self.conclude(&ended, tables);
        }
        self.memory.spare = Spare { cells: exec.cells, sentences: exec.sentences };
        ended?;
        self.cycles.inside -= 1;
        self.drives.probing = outer_probing;
        self.drives.report.at_mut().cycle = outer_at;
        Ok(())
    }

    /// The clearance that a probing cycle adds to that of the probe, mm.
    fn probing_clearance(&self, definition: &Definition<'e>) -> f64 {
        let own = definition.cycle.params.iter().find(|param| param.is.as_str() == PROBING_CLEARANCE);
        let value = own.and_then(|param| self.params.number(param.q?).ok());
        value.unwrap_or_default() * self.drives.cycle_unit
    }

    /// Tables keep what a cycle wrote if it came to its end, or to one that its specification names; otherwise they
    /// are again what they were.
    fn conclude(&mut self, ended: &Done, tables: Tables) {
        let writing = std::mem::take(&mut self.cycles.writing);
        match ended {
            Err(Leave::Fault(fault)) if !fault.of_cycle => self.drives.world.restore(tables),
            Err(Leave::Stopped) => self.drives.world.restore(tables),
            _ => writing.into_iter().for_each(|event| self.drives.report.report_waiting(event)),
        }
    }

    /// Adds the sentences that an execution has shown to those of the run.
    fn executed(&mut self, definition: &Definition<'e>, sentences: &[bool]) {
        let all = self.records.executed.entry(definition.cycle.key).or_insert_with(|| vec![false; sentences.len()]);
        all.iter_mut().zip(sentences).for_each(|(known, shown)| *known |= shown);
    }

    fn exec<'d>(&mut self, definition: &'d Definition<'e>) -> Exec<'d, 'e> {
        let switched = self.drives.switched;
        let spare = std::mem::take(&mut self.memory.spare);
        Exec::new(
            definition,
            self.drives.to_program(self.drives.world.here),
            self.drives.world.probe_if_any(),
            switched,
            spare,
        )
    }

    fn prepare(&mut self, exec: &mut Exec<'_, 'e>) {
        let plan = exec.plan();
        for (slot, id) in &plan.fields {
            let value = match exec.definition.field(id) {
                None => continue,
                Some(FieldValue::Number { value, length, .. }) => {
                    Value::Number(if *length { exec.definition.in_run(*value) } else { *value })
                }
                Some(FieldValue::Q(q)) => Value::Number(f64::from(q.number)),
                Some(FieldValue::Text(text)) => Value::Text(Arc::clone(text)),
                Some(FieldValue::Direction(direction)) => Value::Point(self.drives.in_plane(*direction)),
                Some(FieldValue::Coords(coords)) if !coords.is_empty() && coords.iter().all(|coord| coord.rotary) => {
                    // Angles of rotary axes, which no system of coordinates changes.
                    Value::Point(coords.iter().fold(DVec3::ZERO, |angles, coord| coord.axis.with(angles, coord.value)))
                }
                Some(FieldValue::Coords(coords)) => {
                    let mut point = self.drives.world.here;
                    for coord in coords.iter().filter(|coord| !coord.rotary) {
                        let from = if coord.incremental { coord.axis.of(self.drives.world.here) } else { 0.0 };
                        point = coord.axis.with(point, from + coord.value);
                    }
                    Value::Point(self.drives.to_program(point))
                }
            };
            exec.put(*slot, value);
        }
        for (slot, builtin) in &plan.builtins {
            if let Builtin::MachinePoint(name) = builtin
                && self.machine_point(name, exec).is_none()
            {
                let printed = exec.definition.on.datum(name).unwrap_or(name);
                exec.fail(*slot, Fault::control("machine-parameter-missing").arg("name", printed));
                continue;
            }
            let value = self.builtin(builtin, exec);
            exec.put(*slot, value);
        }
        self.lets(&plan.lets, exec);
    }

    /// Gives the known names that change while a cycle runs their present values.
    fn refresh(&self, exec: &mut Exec<'_, 'e>) {
        if !exec.changing {
            return;
        }
        for (slot, builtin) in exec.plan().builtins.iter().filter(|(_, builtin)| builtin.changes()) {
            let value = self.builtin(builtin, exec);
            exec.put(*slot, value);
        }
    }

    fn builtin(&self, builtin: &Builtin, exec: &Exec<'_, 'e>) -> Value {
        let world = &self.drives.world;
        let system = &world.system;
        let unit = self.drives.cycle_unit();
        let tool = || world.tool().unwrap_or_default();
        let probe = |of: fn(&ProbeData) -> f64| Value::Number(exec.probe.as_ref().map_or(0.0, of));
        let length = |of: fn(&ProbeData) -> f64| Value::Number(exec.probe.as_ref().map_or(0.0, of) / unit);
        match builtin {
            Builtin::Here => Value::Point(self.drives.to_program(world.here)),
            Builtin::Start => Value::Point(exec.start),
            // The tool is not scaled with the program.
            Builtin::ToolRadius => Value::Number(tool().radius / system.plane_scale().unwrap_or(1.0) / unit),
            Builtin::ToolLength => Value::Number(tool().length / unit),
            Builtin::ToolAngle => Value::Number(tool().angle),
            Builtin::ToolLcuts => Value::Number(tool().lcuts / system.depth_scale() / unit),
            Builtin::ToolCornerRadius => {
                Value::Number(tool().corner_radius / system.plane_scale().unwrap_or(1.0) / unit)
            }
            Builtin::ToolNumber => Value::Number(tool().number),
            Builtin::ToolCalled => Value::Bool(world.tool().is_some()),
            Builtin::ProbeSetUp => length(|probe| probe.set_up),
            Builtin::ProbeFeed => length(|probe| probe.feed),
            Builtin::ProbeFmax => length(|probe| probe.fmax),
            Builtin::ProbeDist => length(|probe| probe.dist),
            Builtin::ProbeBallRadius => length(|probe| probe.effective_radius),
            Builtin::ProbeAngle => probe(|probe| probe.angle),
            Builtin::ProbeTurns => Value::Bool(exec.probe.is_some_and(|probe| probe.orientation != Orientation::Fixed)),
            Builtin::ProbeOffset => {
                let offset = exec.probe.as_ref().map_or(DVec3::ZERO, |probe| world.calibrated_offset(probe));
                Value::Point(self.drives.to_program(offset))
            }
            Builtin::ProbeUp => Value::Point(system.in_plane(world.up())),
            Builtin::FurtherAxis(index) => Value::Number(world.further_axes().nth(*index).unwrap_or(0.0)),
            Builtin::ProbeMachineRapid => Value::Bool(exec.probe.is_some_and(|probe| probe.machine_rapid)),
            Builtin::ActiveDatumShift => Value::Bool(system.datum() != DVec3::ZERO),
            Builtin::ActiveRotation => Value::Bool(system.rotation() != 0.0),
            Builtin::ActiveBasicRotation => Value::Bool(system.basic != DVec3::ZERO),
            Builtin::ActiveMirror => Value::Bool(system.has(Transformation::Mirroring)),
            Builtin::ActiveScaling => Value::Bool(system.has(Transformation::Scaling)),
            Builtin::ActiveAxisScaling => Value::Bool(system.has(Transformation::AxisScaling)),
            Builtin::ActiveTilting => Value::Bool(system.has(Transformation::Tilting)),
            Builtin::ActiveReversed => Value::Bool(system.frame().mirrors()),
            Builtin::ActiveAskew => Value::Bool(self.drives.world.is_askew()),
            Builtin::ActiveTcpm => Value::Bool(system.tip_held),
            Builtin::ActiveTurning => Value::Bool(system.has(Transformation::Turning)),
            Builtin::MachinePoint(name) => {
                let point = self.machine_point(name, exec).unwrap_or(DVec3::ZERO);
                Value::Point(self.drives.to_program(system.back().point(point)))
            }
            Builtin::MachineLength(name) => Value::Number(self.machine_datum(name, exec).unwrap_or(0.0) / unit),
            Builtin::Machine(name) => Value::Number(self.machine_datum(name, exec).unwrap_or(0.0)),
            Builtin::Form(form) => Value::Bool(exec.definition.form == Some(*form)),
            Builtin::Given(id) => Value::Bool(exec.definition.field(id).is_some()),
        }
    }

    /// The value of a machine datum in the scene, by its neutral name.
    pub(crate) fn machine_datum(&self, neutral: &str, exec: &Exec<'_, 'e>) -> Option<f64> {
        let printed = exec.definition.on.datum(neutral)?;
        self.drives.world.machine_parameter(printed)
    }

    /// A place of the machine that a machine datum names, by its neutral name.
    fn machine_point(&self, neutral: &str, exec: &Exec<'_, 'e>) -> Option<DVec3> {
        match self.drives.world.scene.machine_parameter(exec.definition.on.datum(neutral)?)? {
            ParameterValue::List(list) => match list.as_slice() {
                [x, y, z] => Some(DVec3::new(*x, *y, *z)),
                _ => None,
            },
            _ => None,
        }
    }

    /// Evaluates named values; one that fails says so when it is needed.
    pub(crate) fn lets(&self, lets: &[Let], exec: &mut Exec<'_, 'e>) {
        for named in lets {
            if named.value.code.ty() == Type::Number {
                match self.number(&named.value, exec) {
                    Ok(number) => exec.put_number(named.slot, number),
                    Err(fault) => exec.fail(named.slot, fault),
                }
                continue;
            }
            match self.value(&named.value, exec) {
                Ok(value) => exec.put(named.slot, value),
                Err(fault) => exec.fail(named.slot, fault),
            }
        }
    }

    pub(crate) fn guards(&mut self, guards: &[Guard], at: Moment, exec: &mut Exec<'_, 'e>) -> Done<Verdict> {
        let mut verdict = Verdict::GoOn;
        for guard in guards.iter().filter(|guard| guard.at == at) {
            let off = |name: &Arc<str>| self.machine_datum(name, exec) == Some(0.0);
            if guard.switched_off_by.as_ref().is_some_and(off) || !self.truth(&guard.when, exec)? {
                continue;
            }
            self.records.guards.insert((exec.definition.cycle.key, Arc::clone(&guard.code)));
            verdict = Verdict::Told;
            let message = |run: &mut Self, kind, answer| {
                run.drives.report.report(EventKind::Message { kind, id: Arc::clone(&guard.code), answer });
            };
            match guard.then {
                Outcome::Error => return Err(Fault::of_cycle(&guard.code).into()),
                Outcome::Skip => {
                    message(self, MessageKind::Skip, None);
                    return Ok(Verdict::Skip);
                }
                Outcome::Warn => message(self, MessageKind::Warning, None),
                Outcome::Confirm => {
                    let answer = self.ask(&guard.code).or_else(|| self.ask("confirm"));
                    message(self, MessageKind::Confirm, answer);
                    if answer != Some(true) {
                        return Err(Leave::Stopped);
                    }
                }
            }
        }
        Ok(verdict)
    }

    pub(crate) fn items(&mut self, items: &[Item], exec: &mut Exec<'_, 'e>) -> Done {
        for item in items {
            self.refresh(exec);
            match item {
                Item::Step(step) => self.step(step, exec)?,
                Item::Group { when, items } => {
                    if self.holds(when.as_ref(), exec)? {
                        self.items(items, exec)?;
                    }
                }
                Item::Each(series) => self.series(series, exec)?,
                Item::Watch(watched) => self.note(watched, exec),
            }
        }
        Ok(())
    }

    /// Notes values; one that is not there is noted as nothing.
    fn note(&mut self, watched: &Watched, exec: &Exec<'_, 'e>) {
        let value = |calc: &Option<Calc>| calc.as_ref().and_then(|calc| self.value(calc, exec).ok());
        let values = watched.values.iter().map(value).collect();
        let events = self.drives.report.count();
        self.records.noted.push(Noted { watch: watched.index, events, values });
    }

    fn step(&mut self, step: &Step, exec: &mut Exec<'_, 'e>) -> Done {
        if !self.holds(step.when.as_ref(), exec)? {
            return Ok(());
        }
        let key = exec.definition.cycle.key;
        self.drives.report.at_mut().cycle = Some((key, Some(Arc::clone(&step.id))));
        exec.show(step.sentence);
        self.acts(&step.block, exec)
    }

    pub(crate) fn acts(&mut self, block: &Block, exec: &mut Exec<'_, 'e>) -> Done {
        self.each_act(&block.first, exec)?;
        self.choose(&block.choose, exec)?;
        self.each_act(&block.then, exec)
    }

    fn choose(&mut self, cases: &[Case], exec: &mut Exec<'_, 'e>) -> Done {
        self.refresh(exec);
        for case in cases {
            let mut all = true;
            for (condition, negated) in &case.when {
                all = self.truth(condition, exec)? != *negated;
                if !all {
                    break;
                }
            }
            if !all {
                continue;
            }
            if let Some(say) = case.say {
                exec.show(say);
            }
            self.each_act(&case.acts, exec)?;
            case.exports.iter().for_each(|(from, to)| exec.copy(*from, *to));
            return Ok(());
        }
        Ok(())
    }

    fn each_act(&mut self, acts: &[Do], exec: &mut Exec<'_, 'e>) -> Done {
        for action in acts {
            self.refresh(exec);
            if self.holds(action.when.as_ref(), exec)? {
                self.act(&action.act, exec)?;
            }
        }
        Ok(())
    }

    /// Does something with a cycle in the unit in which it calculates.
    fn in_unit_of<T>(&mut self, definition: &Definition<'e>, work: impl FnOnce(&mut Self) -> T) -> T {
        let outer = std::mem::replace(&mut self.drives.cycle_unit, definition.calculates_in());
        let done = work(self);
        self.drives.cycle_unit = outer;
        done
    }

    pub(crate) fn value(&self, calc: &Calc, exec: &Exec<'_, 'e>) -> Result<Value, Fault> {
        exec.value(calc, &self.params)
    }

    #[inline]
    pub(crate) fn number(&self, calc: &Calc, exec: &Exec<'_, 'e>) -> Result<f64, Fault> {
        exec.number(calc, &self.params)
    }

    /// A point: main, minor, tool axis.
    pub(crate) fn point(&self, calc: &Calc, exec: &Exec<'_, 'e>) -> Result<DVec3, Fault> {
        exec.point(calc, &self.params)
    }

    fn truth(&self, calc: &Calc, exec: &Exec<'_, 'e>) -> Result<bool, Fault> {
        exec.truth(calc, &self.params)
    }

    pub(super) fn holds(&self, when: Option<&Calc>, exec: &Exec<'_, 'e>) -> Result<bool, Fault> {
        exec.holds(when, &self.params)
    }
}

/// What guards decide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// The cycle goes on: none of them applies.
    GoOn,
    /// It goes on after a message.
    Told,
    /// It is not executed.
    Skip,
}
