//! Strategies as actions of cycles: their arguments are evaluated, paths are milled, results become values.
//!
//! Invariant: what strategies do is in `engine::strategy`; here they are only called. The legs before a fault are
//! milled, and the fault ends the run then.
use crate::base::expr::Value;
use crate::engine::cycle::control::OfRun;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::WorkingPlane;
use crate::engine::motion::moves::{Speed, Turn};
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::{Cutter, Does, Given, Leg, Path};

impl<'e> Run<'_, 'e> {
    pub(crate) fn strategy(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let mut values = self.arguments(call, exec)?;
        let mm = self.drives.cycle_unit();
        let given = Given::new(&mut values, mm);
        let results = match call.strategy.does {
            Does::Mill(mill) => {
                let from = self.drives.in_plane(self.drives.world.here);
                return self.follow(mill(given, self.cutter(), from)?);
            }
            Does::MillOver(mill) => {
                let from = self.drives.in_plane(self.drives.world.here);
                let path = mill(given, &self.cycles.contours, self.cutter(), from)?;
                return self.follow(path);
            }
            Does::Calculate(calculate) => calculate(given, self.drives.world.system.plane)?,
            Does::Act(act) => act(given, &mut OfRun { run: self, exec }, mm)?,
        };
        for (slot, number) in call.results.iter().zip(results) {
            exec.put(*slot, Value::Number(number));
        }
        Ok(())
    }

    /// The values of the arguments that are given, in the order of the parameters.
    fn arguments(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Vec<Option<Value>>, Fault> {
        let mut values = Vec::with_capacity(call.with.len());
        for calc in &call.with {
            values.push(calc.as_ref().map(|calc| self.value(calc, exec)).transpose()?);
        }
        Ok(values)
    }

    /// The tool in the units of the program, which may be scaled.
    pub(super) fn cutter(&self) -> Cutter {
        let world = &self.drives.world;
        Cutter { radius: world.tool().map_or(0.0, |tool| tool.radius) / world.system.plane_scale().unwrap_or(1.0) }
    }

    /// Moves along a path; then comes why it ends early.
    fn follow(&mut self, path: Path) -> Done {
        let switched = self.drives.switched;
        let ended = self.follow_legs(path);
        // Moves in step with the turning spindle end with their path.
        (self.drives.switched.turned, self.drives.switched.per_revolution) = (switched.turned, switched.per_revolution);
        ended
    }

    fn follow_legs(&mut self, path: Path) -> Done {
        for leg in path.legs {
            let system = &self.drives.world.system;
            match leg {
                Leg::Line { to, feed } => {
                    let to = system.axes(to);
                    self.drives.straight_to(to, None, Speed::of_feed(feed))?;
                }
                Leg::Upright { centre, to, sweep, feed } => {
                    let plane = WorkingPlane::of_tool_axis(system.plane.secondary);
                    let (centre, to) = (system.axes(centre), system.axes(to));
                    let turn = Turn { plane, centre, direction: sweep.signum(), sweep: Some(sweep) };
                    self.drives.arc_by(turn, to, Speed::of_feed(feed))?;
                }
                Leg::InStep { angle, diameter, .. } => self.drives.keep_step(angle, diameter),
                Leg::Arc { centre, to, direction, sweep, feed } => {
                    let (centre, to) = (system.axes(centre), system.axes(to));
                    self.drives.arc_to(centre, to, direction, sweep, Speed::of_feed(feed))?;
                }
            }
        }
        path.fault.map_or(Ok(()), |fault| Err(fault.into()))
    }
}
