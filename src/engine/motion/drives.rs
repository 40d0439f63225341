//! The drives: what moves the machine in its world and reports it.
//!
//! Invariant: a position is known both in program and machine coordinates after every movement.
use glam::DVec3;

use super::blank::TurnedBlank;
use crate::engine::machine::Insert;
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::{Recorder, Touching, Way};
use crate::engine::report::event::{Coordinates, EventKind};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::report::reporter::Reporter;
use crate::engine::solid::Path;
use crate::engine::world::insert::Aligned;
use crate::engine::world::state::World;
use crate::spec::Transformation;

/// The spindle as the program set it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Spindle {
    pub(crate) speed: f64,
    pub(crate) direction: i8,
}

/// The turning spindle, which turns the workpiece, as the program set it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct TurningSpindle {
    /// 1 clockwise, -1 counter-clockwise, 0 not at all.
    pub(crate) direction: i8,
    /// 1/min, where that is constant.
    pub(crate) speed: f64,
    /// The cutting speed, m/min, where that is constant.
    pub(crate) cutting_speed: Option<f64>,
    /// The speed that is never exceeded, 1/min.
    pub(crate) limit: Option<f64>,
}

/// What M functions and tool calls switch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Switched {
    pub(crate) spindle: Spindle,
    pub(crate) coolant: bool,
    /// The angle to which M19 and M20 orient the spindle.
    pub(crate) orientation: f64,
    /// What turns the workpiece.
    pub(crate) turned: TurningSpindle,
    /// Whether feeds are mm per revolution (M136).
    pub(crate) per_revolution: bool,
}

/// What moves the machine.
pub(crate) struct Drives<'r, 'e> {
    /// The machine as it is now.
    pub(crate) world: World<'e>,
    /// Who is informed of every movement.
    pub(crate) report: Reporter<'r>,
    /// Spindle and coolant.
    pub(crate) switched: Switched,
    /// The insert as it was reported last, if one was since the tool was called.
    pub(super) held: Option<Insert>,
    /// The blank that turning updates (`FUNCTION TURNDATA BLANK`).
    pub(crate) blank: Option<TurnedBlank>,
    /// mm in the unit of the program being executed.
    pub(crate) unit: f64,
    /// mm in the unit in which the cycle being executed calculates.
    pub(crate) cycle_unit: f64,
    /// Moves so far, and how many there may be.
    pub(crate) moves: u64,
    most_moves: u64,
    /// Whether a cycle is executed that probes.
    pub(crate) probing: bool,
    /// Whether a contour is under way next to which nothing else can be executed.
    pub(crate) beside_contour: bool,
    /// What stops the probe.
    touching: Touching,
    /// The clearance that the cycle being executed adds to that of the probe, mm.
    pub(crate) clearance: f64,
    /// The ways of the cycle whose envelope is looked for.
    pub(crate) recorder: Option<Recorder>,
    /// The moves of a contour that is only read, in machine coordinates: nothing moves and nothing is reported.
    pub(crate) traced: Option<Vec<Path>>,
}

impl<'r, 'e> Drives<'r, 'e> {
    pub(crate) fn new(world: World<'e>, report: Reporter<'r>, most_moves: u64) -> Self {
        Self {
            world,
            report,
            switched: Switched::default(),
            held: None,
            blank: None,
            unit: 1.0,
            cycle_unit: 1.0,
            moves: 0,
            most_moves,
            probing: false,
            beside_contour: false,
            touching: Touching::AsScene,
            clearance: 0.0,
            recorder: None,
            traced: None,
        }
    }

    /// What stops the probe.
    pub(crate) const fn touching(&self) -> Touching {
        self.touching
    }

    /// What stops the probe from now on. Where that is not certain, all is only rehearsed.
    pub(crate) fn touch(&mut self, touching: Touching) {
        self.touching = touching;
        self.report.rehearse(matches!(touching, Touching::AtOnce | Touching::AtEnd));
    }

    /// A fault if something that cannot be executed next to a contour comes while compensation is in effect.
    pub(crate) fn not_beside_contour(&self, word: impl Into<String>) -> Done {
        if !self.beside_contour {
            return Ok(());
        }
        Err(Fault::unsupported("unsupported-compensation").arg("word", word.into()).into())
    }

    /// A fault if a cycle, or a tilted plane, comes while compensation is in effect: the position before it is to be
    /// programmed with `R0` (TNC 640 manual, line 1729 and in each cycle that machines).
    pub(crate) fn not_compensated(&self, cycle: impl Into<String>) -> Done {
        if !self.beside_contour {
            return Ok(());
        }
        Err(Fault::program("compensation-at-cycle").arg("cycle", cycle.into()).into())
    }

    /// Few blocks can move the tool without end: a pattern of many points with a cycle of many infeeds.
    pub(crate) fn count_move(&mut self) -> Done {
        self.moves += 1;
        if self.moves > self.most_moves {
            return Err(Fault::new(Class::Limit, "move-limit").arg("limit", self.most_moves as f64).into());
        }
        Ok(())
    }

    /// Main, minor and tool coordinates of a point given by axes.
    pub(crate) fn in_plane(&self, axes: DVec3) -> DVec3 {
        self.world.system.in_plane(axes)
    }

    /// After a change of the system: program coordinates follow, and the change is reported.
    pub(crate) fn transformed(&mut self, before: Coordinates) {
        if self.world.system.knows_tool() {
            // Where the rotary axes have the coordinate 0 may have changed, too.
            self.world.carry_system();
        }
        let now = self.world.system.reported();
        if now != before {
            self.world.renew();
            if !now.is_near(&before) {
                self.report.report(EventKind::Transform(now));
            }
        }
    }

    /// What programs change in the coordinate system ends with them.
    pub(crate) fn end_changes(&mut self) {
        let before = self.world.system.reported();
        self.world.system.unexecuted.clear();
        self.world.system.turning = false;
        self.world.align(Aligned::default());
        self.world.system.end_changes();
        self.world.parallels.end(self.world.machine);
        self.transformed(before);
    }

    /// Changes how turning is aligned with the tool, and reports what that changes in the coordinate system.
    pub(crate) fn align(&mut self, aligned: Aligned) {
        let before = self.world.system.reported();
        self.world.align(aligned);
        self.transformed(before);
    }

    /// From now on the insert meets the workpiece like this.
    pub(crate) fn hold_insert(&mut self, insert: Insert) {
        if self.held.replace(insert) != Some(insert) {
            self.report.report(EventKind::Insert(insert));
        }
    }

    /// Another tool was called.
    pub(crate) const fn release_insert(&mut self) {
        self.held = None;
    }

    /// A transformation that is not executed is no longer in effect.
    pub(crate) fn ends(&mut self, transformation: Transformation) {
        self.world.system.unexecuted.remove(&transformation);
    }

    /// Notes a way of the tip in machine coordinates, if someone wants to know.
    pub(crate) fn note_way(&mut self, tip: &Path, probing: bool) {
        let Some(recorder) = &mut self.recorder else { return };
        let Some(probe) = self.world.probe_if_any() else { return };
        let lift = self.world.ball_centre(DVec3::ZERO, &probe);
        let ball = match *tip {
            Path::Line { from, to } => Path::line(from + lift, to + lift),
            Path::Arc { centre, axis, from, sweep, rise } => {
                Path::Arc { centre: centre + lift, axis, from: from + lift, sweep, rise }
            }
        };
        recorder.note(Way { tip: self.world.path_of_tip(tip), ball: self.world.path_at_parts(&ball), probing });
    }
}
