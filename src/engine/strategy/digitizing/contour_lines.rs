//! Strategies of digitizing contour lines: around a part, height by height.
//!
//! Invariant: as for lines; where the ball touches comes from `scan`, and how points are taken from `digitizing`.
use glam::{DVec2, DVec3};

use super::range::Row;
use super::rotary_axis::{contour_line_start, ends_in_plane, once_around, turn_back, turning_sense};
use super::scan::{Level, feel, lost};
use super::{Manner, OFF, Spent, begin, in_plane, keep_sudden, probe, range_of, scanning, stepping, sudden, take};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::signature::{Mm, strategy};

/// A level that is so little beyond the range, mm, is in it.
const BEYOND: f64 = 1e-6;

strategy! {
    /// Goes to where contour lines begin, first at the clearance height.
    ApproachContourLineStart = "approach-contour-line-start" {
        /// The starting point in the working plane.
        start: Mm<DVec3> = Length,
        /// From one contour line to the next: its sign says from which end of the range.
        spacing: Mm<f64> = Length,
        /// Whether the probe measures its deflection.
        analog: bool = Number,
    }
}

strategy! {
    /// Moves to the part at this height and stores the position.
    ApproachWorkpieceInDirection = "approach-workpiece-in-direction" {
        /// The direction, a vector of length 1.
        direction: DVec3 = Number,
    }
}

scanning! {
    /// Goes once around the part at this height.
    ScanContourLine = "scan-contour-line" {
        /// The axis and direction in which it begins, a vector of length 1.
        direction: DVec3 = Number,
        /// The direction in which the part was approached.
        approach: DVec3 = Number,
        /// How long a line may take, s; 0: any time.
        limit: f64 = Time,
    }
}

scanning! {
    /// Goes around the part at all further heights.
    ScanFurtherContourLines = "scan-further-contour-lines" {
        /// The starting point in the working plane.
        start: Mm<DVec3> = Length,
        /// The axis and direction in which lines begin, a vector of length 1.
        direction: DVec3 = Number,
        /// The direction in which the part is approached.
        approach: DVec3 = Number,
        /// How long a line may take, s; 0: any time.
        limit: f64 = Time,
    }
}

impl Action for ApproachContourLineStart {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let range = range_of(control)?;
        if range.corners.is_some() {
            return Err(Fault::program("digitizing-range-of-points").into());
        }
        let over = contour_line_start(control, &range, self.start.0.truncate(), self.analog)?;
        control.digitizing().begin();
        begin(control, &range, over, self.analog)?;
        let end = if self.spacing.0 < 0.0 { range.greatest } else { range.least };
        let level = control.in_plane(end).z;
        control.digitizing().push(Row::Down(level));
        let (_, feed) = control.stylus()?;
        control.fly(control.axes(self.start.0.truncate().extend(level)), Some(feed))
    }
}

/// Probes in a direction up to the end of the range.
fn reach(control: &mut dyn Control, direction: DVec2) -> Done {
    let range = range_of(control)?;
    let (here, feed) = control.stylus()?;
    let here = control.in_plane(here).truncate();
    let ends = ends_in_plane(control, &range, direction)?;
    let way = ends.into_iter().map(|end| (end - here).dot(direction)).fold(0.0, f64::max);
    let way = way.max(OFF);
    let began = here.extend(0.0);
    if !probe(control, direction.extend(0.0) * way, feed)? {
        return Err(Fault::control("probe-no-contact").arg("distance", way).into());
    }
    control.digitizing().first = began;
    Ok(())
}

impl Action for ApproachWorkpieceInDirection {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        let direction = in_plane(control, self.direction)?;
        reach(control, direction)
    }
}

/// How a line begins.
enum Begins {
    /// In that direction of the working plane.
    Along(DVec2),
    /// With the rotary axis turning, 1 or -1.
    Turning(f64),
}

/// What a contour line is digitized with.
struct Around {
    direction: Begins,
    approach: DVec2,
    limit: f64,
}

impl Around {
    fn new(control: &mut dyn Control, direction: DVec3, approach: DVec3, limit: f64) -> Result<Self, Fault> {
        let range = range_of(control)?;
        let direction = match turning_sense(control, &range)? {
            Some(sense) => Begins::Turning(sense),
            None => Begins::Along(in_plane(control, direction)?),
        };
        Ok(Self { direction, approach: in_plane(control, approach)?, limit })
    }
}

/// Goes once around the part from where it was touched; the least share of the line distance that it asks for where it
/// is flat.
fn around(control: &mut dyn Control, with: &Around, first: bool, manner: &Manner) -> Done<f64> {
    let range = range_of(control)?;
    let direction = match with.direction {
        Begins::Along(direction) => direction,
        Begins::Turning(sense) => {
            if let Some(travel) = manner.travel {
                control.retract(travel)?;
            }
            let mut spent = Spent { limit: (with.limit > 0.0).then_some(with.limit), ..Spent::default() };
            return once_around(control, &range, (sense, with.approach), manner, &mut spent).map(|()| 1.0);
        }
    };
    let (here, _) = control.stylus()?;
    let here = control.in_plane(here);
    // Where the ball touches, felt on the way on which the part was approached.
    let began = control.digitizing().first.truncate().extend(here.z);
    let beyond = here + with.approach.extend(0.0) * manner.points.max(OFF);
    let felt = feel(control, began, beyond)?;
    let Some(start) = felt.as_ref().and_then(Level::sample) else {
        return Err(lost(control, here).into());
    };
    if let Some(travel) = manner.travel {
        control.retract(travel)?;
    }
    let right = DVec2::new(start.away.y, -start.away.x);
    let clockwise = right.dot(direction) >= 0.0;
    let accuracy = control.setting("contour-line-accuracy").unwrap_or(0.0);
    let level = Level { control: &*control, range: &range, clockwise, accuracy };
    let samples = level.trace(start, stepping(manner))?;
    let mut spent = Spent { limit: (with.limit > 0.0).then_some(with.limit), ..Spent::default() };
    let feeds = if first { manner.first_feed } else { manner.feed };
    take(control, &samples, manner, range.height, feeds, &mut spent)?;
    keep_sudden(control, sudden(&samples));
    Ok(samples.iter().map(|sample| sample.out.truncate().length()).fold(1.0, f64::min))
}

impl Action for ScanContourLine {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        let with = Around::new(control, self.direction, self.approach, self.limit)?;
        let manner = self.manner(control)?;
        let share = around(control, &with, true, &manner)?;
        control.digitizing().next_step = self.step(share);
        Ok(())
    }
}

impl Action for ScanFurtherContourLines {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        let with = Around::new(control, self.direction, self.approach, self.limit)?;
        let (manner, range) = (self.manner(control)?, range_of(control)?);
        let (least, greatest) = (control.in_plane(range.least).z, control.in_plane(range.greatest).z);
        let mut level = if self.spacing.0 < 0.0 { greatest } else { least };
        loop {
            back_to_start(control, self.start.0.truncate(), &with)?;
            let step = control.digitizing().next_step;
            level += step * self.spacing.0.signum();
            if step <= 0.0 || level > greatest + BEYOND || level < least - BEYOND {
                return Ok(());
            }
            control.digitizing().push(Row::Down(level));
            let (_, feed) = control.stylus()?;
            control.fly(control.axes(self.start.0.truncate().extend(level)), Some(feed))?;
            reach(control, with.approach)?;
            let share = around(control, &with, false, &manner)?;
            control.digitizing().next_step = self.step(share);
        }
    }
}

/// Back to the starting point from the first point of a line.
fn back_to_start(control: &mut dyn Control, start: DVec2, with: &Around) -> Done {
    let (here, feed) = control.stylus()?;
    let here = control.in_plane(here);
    if control.touches(control.axes(here), OFF / 2.0)? {
        control.fly(control.axes(here - with.approach.extend(0.0) * OFF), Some(feed))?;
    }
    let at = control.axes(start.extend(here.z));
    control.digitizing().push(Row::Back(at));
    control.fly(at, None)?;
    turn_back(control, at)
}
