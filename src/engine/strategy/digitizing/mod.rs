//! Strategies of digitizing: the range, the way to the part, and lines over it. Contour lines are in `contour_lines`.
//!
//! A touch-trigger probe probes every point and goes back from it by the travel in the direction of the normal; a stylus
//! that measures its deflection (it has a feed) stays on the part. Invariant: where the ball touches comes from `scan`,
//! what is kept and written from `range`; here the stylus moves.
pub mod contour_lines;
pub mod range;
mod rotary_axis;
mod scan;

use std::iter::successors;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use self::range::{Lines, Range, Row};
use self::rotary_axis::{go_over, in_working_plane, line_direction, rotary_range, take_turned};
use self::scan::{Chart, Ground, Profile, Sample, feel, lost, stored};
use crate::base::expr::{cosd, sind};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control, Felt};
use crate::engine::strategy::signature::{Mm, strategy};

/// The least way by which a probe leaves a point that it has touched, mm.
const OFF: f64 = 2e-3;
/// Positions nearer to each other, mm, need no way around.
const SAME: f64 = 1e-9;
/// A table of points bounds a range with at least and at most so many of them (003: 3163).
const CORNERS: (usize, usize) = (3, 893);
/// Places are looked through for the way between two points of a line with retractions of so many sizes.
const TRIES: usize = 12;
/// The least step with which a line is followed whose points are stored within a tolerance, mm, and its share of the
/// greatest distance.
const FINE: (f64, f64) = (0.02, 0.125);
/// The angle from which a change of direction is sudden, degrees.
const SUDDEN: f64 = 30.0;
/// The most such places of a line for which the feed is reduced in the next one (003: 3223, 3257).
const MOST_SUDDEN: usize = 1000;

/// A length, and each time twice the one before: how far a probe gives way, try after try.
fn doubled(first: f64) -> impl Iterator<Item = f64> {
    successors(Some(first), |way| Some(way * 2.0))
}

strategy! {
    /// Keeps a block-shaped range for the cycles that digitize.
    RememberDigitizingRange = "remember-digitizing-range" {
        /// The name of the file of digitized data.
        file: Arc<str> = Text,
        /// The touch probe axis, a vector of length 1.
        axis: DVec3 = Number,
        /// The MIN point.
        minimum: Mm<DVec3> = Length,
        /// The MAX point.
        maximum: Mm<DVec3> = Length,
        /// The clearance height.
        height: Mm<f64> = Length,
    }
}

strategy! {
    /// Keeps a range whose boundary is a polygon of a point table.
    RememberRangeFromPoints = "remember-range-from-points" {
        /// The name of the file of digitized data.
        file: Arc<str> = Text,
        /// The touch probe axis, a vector of length 1.
        axis: DVec3 = Number,
        /// The name of the table.
        table: Arc<str> = Text,
        /// The least tool coordinate.
        minimum: Mm<f64> = Length,
        /// The greatest.
        maximum: Mm<f64> = Length,
        /// The clearance height.
        height: Mm<f64> = Length,
    }
}

strategy! {
    /// Goes over the beginning of the first line, first to the clearance height.
    ApproachDigitizingStart = "approach-digitizing-start" {
        /// The direction of the lines, a vector of length 1.
        direction: DVec3 = Number,
        /// By how much they are turned, degrees.
        angle: Option<f64> = Angle,
        /// Whether the probe measures its deflection.
        analog: bool = Number,
        /// Whether each line goes back from where the one before has ended.
        meander: bool = Number,
    }
}

strategy! {
    /// Moves down to the part, or to the end of the range, and stores the position.
    ApproachWorkpieceDownwards = "approach-workpiece-downwards" {
        /// By how much a touch-trigger probe is retracted from it, mm.
        travel: Option<Mm<f64>> = Length,
    }
}

/// How points of lines are taken.
struct Manner {
    points: f64,
    travel: Option<f64>,
    feed: f64,
    first_feed: f64,
    tolerance: f64,
    corner: f64,
}

/// Declares a strategy that scans, with the arguments that all of them have.
macro_rules! scanning {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($(#[$of:meta])* $field:ident: $ty:ty = $quantity:ident,)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                $($(#[$of])* $field: $ty = $quantity,)*
                /// The distance of the lines, mm.
                spacing: Mm<f64> = Length,
                /// The greatest distance of points, mm.
                points: Mm<f64> = Length,
                /// By how much a touch-trigger probe is retracted from each, mm.
                travel: Option<Mm<f64>> = Length,
                /// The feed of a probe that measures its deflection, mm/min.
                feed: Option<Mm<f64>> = Feed,
                /// The same on the first line and near sudden changes of direction.
                first_feed: Option<Mm<f64>> = Feed,
                /// The least distance of lines where the part is steep, mm; 0 reduces nothing.
                least: Option<Mm<f64>> = Length,
                /// How far the way between stored points may deviate, mm; 0 stores all of them.
                tolerance: Option<Mm<f64>> = Length,
                /// How far from a sudden change of direction in the line before the feed is reduced, mm.
                corner: Option<Mm<f64>> = Length,
            }
        }

        impl $name {
            fn manner(&self, control: &dyn Control) -> Result<Manner, Fault> {
                let (_, probing) = control.stylus()?;
                let mm = |value: Option<Mm<f64>>| value.map(|value| value.0);
                let feed = mm(self.feed);
                Ok(Manner {
                    points: self.points.0,
                    travel: if feed.is_none() { Some(mm(self.travel).unwrap_or(0.0).max(OFF)) } else { None },
                    feed: feed.unwrap_or(probing),
                    first_feed: mm(self.first_feed).or(feed).unwrap_or(probing),
                    tolerance: mm(self.tolerance).unwrap_or(0.0),
                    corner: mm(self.corner).unwrap_or(0.0),
                })
            }

            /// The distance to the next line, where the part leans so much across the lines: a share of the length along
            /// its surface.
            fn step(&self, share: f64) -> f64 {
                let most = self.spacing.0.abs();
                match self.least {
                    Some(least) if least.0 > 0.0 && least.0 < most => (most * share).max(least.0),
                    _ => most,
                }
            }
        }
    };
}

use scanning;

scanning! {
    /// Digitizes all lines, each back from where the one before has ended.
    ScanMeander = "scan-meander" {}
}

scanning! {
    /// Digitizes the first line.
    ScanLine = "scan-line" {}
}

scanning! {
    /// Digitizes all further lines, each in the same direction, with a way back at the clearance height.
    ReturnForNextLine = "return-for-next-line" {
        /// Down to here the way to the part is at rapid traverse.
        height: Mm<f64> = Length,
    }
}

strategy! {
    /// Goes to the clearance height, to a point in the working plane if there is one, and writes the digitized data.
    LeaveDigitizing = "leave-digitizing" {
        /// That point.
        to: Option<Mm<DVec3>> = Length,
    }
}

impl Action for RememberDigitizingRange {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let rotary = rotary_range(control)?;
        let points = [self.minimum.0, self.maximum.0].map(|point| control.axes(point));
        let (axis, [least, greatest]) = (control.axes(self.axis), points);
        let (file, height) = (self.file.to_string(), self.height.0);
        let range = Range { file, axis, least, greatest, corners: None, height, rotary };
        range.check()?;
        control.digitizing().range = Some(range);
        Ok(())
    }
}

impl Action for RememberRangeFromPoints {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let corners = control.points_of_table(&self.table)?;
        if corners.len() < CORNERS.0 || corners.len() > CORNERS.1 {
            let fault = Fault::program("digitizing-range-points").arg("count", corners.len());
            return Err(fault.arg("least", CORNERS.0).arg("most", CORNERS.1).into());
        }
        let axis = control.axes(self.axis);
        let bound = |first: fn(DVec3, DVec3) -> DVec3, tool: f64| {
            let flat = corners.iter().copied().reduce(first).unwrap_or_default();
            flat - axis * flat.dot(axis) + axis * tool
        };
        let (least, greatest) = (bound(DVec3::min, self.minimum.0), bound(DVec3::max, self.maximum.0));
        let file = self.file.to_string();
        let height = self.height.0;
        let range = Range { file, axis, least, greatest, corners: Some(corners), height, rotary: None };
        range.check()?;
        control.digitizing().range = Some(range);
        Ok(())
    }
}

/// The range of the last definition, for lines in the working plane.
fn range_of(control: &mut dyn Control) -> Result<Range, Fault> {
    let range = control.digitizing().range.clone().ok_or_else(|| Fault::program("digitizing-range-missing"))?;
    let tool = control.axes(DVec3::Z);
    if range.axis != tool {
        return Err(axis_wrong(control, range.axis));
    }
    Ok(range)
}

/// The fault of an axis that is not where one of the plane, or the tool axis, belongs.
fn axis_wrong(control: &dyn Control, axis: DVec3) -> Fault {
    let plane = control.plane();
    let letters = crate::engine::geometry::Axis::ALL.into_iter();
    let named = letters.max_by(|a, b| a.of(axis).abs().total_cmp(&b.of(axis).abs()));
    let letter = named.unwrap_or(plane.tool).letter().to_string();
    Fault::program("digitizing-axis-wrong").arg("axis", letter).arg("tool", plane.tool.letter().to_string())
}

/// A direction in the working plane.
fn in_plane(control: &dyn Control, direction: DVec3) -> Result<DVec2, Fault> {
    if direction.z == 0.0 { Ok(direction.truncate()) } else { Err(axis_wrong(control, control.axes(direction))) }
}

/// Begins a file of data: over the start of the first line, at the clearance height.
fn begin(control: &mut dyn Control, range: &Range, over: DVec2, analog: bool) -> Done {
    let depth = if analog { control.setting("stylus-deflection-depth").unwrap_or(0.0) } else { 0.0 };
    let (here, _) = control.stylus()?;
    let kept = control.digitizing();
    (kept.enlarged, kept.began) = (2.0 * depth, here);
    kept.push(Row::Height(range.height));
    let up = control.in_plane(here).truncate().extend(range.height);
    control.fly(control.axes(up), None)?;
    go_over(control, range, over)
}

impl Action for ApproachDigitizingStart {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let range = range_of(control)?;
        let axis = line_direction(control, &range, self)?;
        let angle = self.angle.unwrap_or(0.0);
        let lines = Lines::new(axis, DVec2::new(cosd(angle), sind(angle)), range.boundary(control.plane()));
        let first = lines.stretches().first().map_or_else(|| lines.corners.first().copied(), |line| Some(line.0));
        control.digitizing().begin();
        begin(control, &range, first.unwrap_or_default(), self.analog)?;
        control.digitizing().lines = Some(lines);
        Ok(())
    }
}

/// Stores a position of the stylus.
fn store(control: &mut dyn Control, at: DVec3) {
    let at = control.axes(at);
    control.digitizing().push(Row::Point(at));
}

/// Probes on a way and stores the position where the probe triggers; the fault of nothing there.
fn probe(control: &mut dyn Control, way: DVec3, feed: f64) -> Done<bool> {
    let (began, _) = control.stylus()?;
    let centre = control.ball()?;
    let stopped = control.stroke(control.axes(way), feed)?;
    if stopped.touched {
        let at = control.in_plane(began + (stopped.centre - centre));
        store(control, at);
    }
    Ok(stopped.touched)
}

/// Moves down over a place until the part is touched or the range ends, and stores where that is.
fn down(control: &mut dyn Control, travel: Option<f64>) -> Done {
    let range = range_of(control)?;
    let (here, feed) = control.stylus()?;
    let floor = control.in_plane(range.least).z;
    let way = control.in_plane(here).z - floor;
    if way > SAME && probe(control, DVec3::NEG_Z * way, feed)? {
        return travel.map_or(Ok(()), |travel| control.retract(travel.max(OFF)));
    }
    let (here, _) = control.stylus()?;
    let here = control.in_plane(here);
    store(control, here);
    Ok(())
}

impl Action for ApproachWorkpieceDownwards {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        down(control, self.travel.map(|travel| travel.0))
    }
}

/// What it costs to take the points of a line.
#[derive(Default)]
struct Spent {
    minutes: f64,
    limit: Option<f64>,
}

impl Spent {
    fn add(&mut self, way: f64, feed: f64) -> Result<(), Fault> {
        self.minutes += way / feed;
        match self.limit {
            Some(limit) if self.minutes * 60.0 > limit => {
                Err(Fault::control("digitizing-time-exceeded").arg("limit", limit))
            }
            _ => Ok(()),
        }
    }
}

/// Where a probe waits before it touches a place: as far from it as the travel, or half as far as it is free.
fn before(control: &dyn Control, sample: &Sample, travel: f64) -> Result<DVec3, Fault> {
    if sample.on != Ground::Part {
        return Ok(sample.at);
    }
    let (from, to) = (sample.at + sample.away * (OFF / 2.0), sample.at + sample.away * travel);
    Ok(match feel(control, from, to)? {
        None => to,
        Some(felt) => from.midpoint(felt.at),
    })
}

/// Moves a touch-trigger probe through the air to where it waits before a place, beside another one at which it was
/// retracted, and gives the way on which it touches it.
fn wait_before(
    control: &mut dyn Control,
    [last, sample]: [&Sample; 2],
    travel: f64,
    top: f64,
    spent: &mut Spent,
) -> Done<DVec3> {
    let (from, feed) = control.stylus()?;
    let from = control.in_plane(from);
    // Less in narrow places, more where the part bulges between the two.
    let smaller = successors(Some(travel), |way| Some(way / 2.0)).take(TRIES).take_while(|way| *way > OFF);
    let larger = doubled(travel.max(OFF)).take(TRIES).filter(|way| *way > travel);
    for way in smaller.chain([OFF]).chain(larger) {
        let (via, to) = (before(control, last, way)?, before(control, sample, way)?);
        if feel(control, from, via)?.is_none() && feel(control, via, to)?.is_none() {
            let legs = if via.distance(from) > SAME && way != travel { vec![via, to] } else { vec![to] };
            if legs.len() == 1 && feel(control, from, to)?.is_some() {
                continue;
            }
            spent.add((via - from).length() + (to - via).length(), feed)?;
            for leg in legs {
                control.fly(control.axes(leg), Some(feed))?;
            }
            return Ok(sample.at - to);
        }
    }
    // Over what is between them: a place that is touched from above is free upwards.
    let up = DVec3::Z * OFF;
    let (off, to) = (last.at + up, sample.at + up);
    let mut here = from;
    for place in [off, off.truncate().extend(top), to.truncate().extend(top), to] {
        if feel(control, here, place)?.is_some() {
            return Err(lost(control, sample.at).into());
        }
        control.fly(control.axes(place), Some(feed))?;
        here = place;
    }
    Ok(-up)
}

/// Takes the points of a line: the first of the places is where the stylus is.
fn take(
    control: &mut dyn Control,
    samples: &[Sample],
    manner: &Manner,
    top: f64,
    feeds: f64,
    spent: &mut Spent,
) -> Done {
    let keep = stored(samples, manner.points, manner.tolerance);
    let everything = manner.travel.is_some() || manner.tolerance == 0.0;
    let corners = control.digitizing().corners.clone();
    let near = |at: DVec3| corners.iter().any(|corner| corner.distance(at.truncate()) <= manner.corner);
    for (index, sample) in samples.iter().enumerate().skip(1) {
        let wanted = sample.on != Ground::Nothing && (everything || keep.get(index).copied().unwrap_or(true));
        match manner.travel {
            Some(travel) if sample.on == Ground::Part => {
                let way = wait_before(control, [&samples[index - 1], sample], travel, top, spent)?;
                let far = way.length();
                let reach = far + travel.max(manner.points);
                if !probe(control, way / far * reach, manner.feed)? {
                    return Err(Fault::control("probe-no-contact").arg("distance", reach).into());
                }
                spent.add(far, manner.feed)?;
                control.retract(travel)?;
            }
            Some(travel) => {
                wait_before(control, [&samples[index - 1], sample], travel, top, spent)?;
                if wanted {
                    store(control, sample.at);
                }
            }
            None => {
                let feed = if near(sample.at) { manner.first_feed.min(feeds) } else { feeds };
                let (here, _) = control.stylus()?;
                spent.add((control.axes(sample.at) - here).length(), feed)?;
                control.slide(control.axes(sample.at), control.axes(sample.out), feed)?;
                if wanted {
                    store(control, sample.at);
                }
            }
        }
    }
    Ok(())
}

/// Where the direction of a line changes suddenly.
fn sudden(samples: &[Sample]) -> Vec<DVec2> {
    let turns = |three: &[Sample]| match three {
        [a, b, c] => (b.at - a.at).angle_between(c.at - b.at).to_degrees() > SUDDEN,
        _ => false,
    };
    samples.windows(3).filter(|three| turns(three)).map(|three| three[1].at.truncate()).collect()
}

/// Keeps where a line changed its direction suddenly for the next one; nothing if that were too many places.
fn keep_sudden(control: &mut dyn Control, places: Vec<DVec2>) {
    control.digitizing().corners = if places.len() > MOST_SUDDEN { Vec::new() } else { places };
}

/// The step with which a line is followed.
fn stepping(manner: &Manner) -> f64 {
    if manner.tolerance > 0.0 { (manner.points * FINE.1).max(FINE.0).min(manner.points) } else { manner.points }
}

/// Digitizes along the plan from where the stylus is, and gives what it has gone through.
fn along(control: &mut dyn Control, to: DVec2, from: DVec2, manner: &Manner) -> Done<Vec<Sample>> {
    let range = range_of(control)?;
    let (floor, ceiling) = (control.in_plane(range.least).z, control.in_plane(range.greatest).z);
    let turns = range.rotary.filter(|_| (to.y - from.y).abs() > SAME);
    let flat = (in_working_plane(control, &range, from), in_working_plane(control, &range, to));
    if let Some(rotary) = turns {
        let chart = Chart { axis: rotary.axis, base: flat.0.extend(0.0), up: DVec3::Z, around: false };
        let (from, to) = (DVec2::new(from.y, 0.0), DVec2::new(to.y, 0.0));
        let profile = Profile { control: &*control, from, to, top: range.height, floor, ceiling, turned: Some(chart) };
        let samples = profile.trace(stepping(manner))?;
        take_turned(control, &chart, &samples, manner, [floor, range.height], &mut Spent::default())?;
        return Ok(samples);
    }
    let (from, to) = flat;
    let profile = Profile { control: &*control, from, to, top: range.height, floor, ceiling, turned: None };
    let samples = profile.trace(stepping(manner))?;
    let is_first = control.digitizing().lines.as_ref().is_none_or(|lines| lines.count == 0);
    let feeds = if is_first { manner.first_feed } else { manner.feed };
    take(control, &samples, manner, range.height, feeds, &mut Spent::default())?;
    Ok(samples)
}

/// The least share of the line distance that the part asks for where it leans across the lines.
fn leaning(control: &mut dyn Control, samples: &[Sample], across: DVec2) -> Result<f64, Fault> {
    let rotary = range_of(control)?.rotary;
    let mut least: f64 = 1.0;
    for sample in samples.iter().filter(|sample| sample.on == Ground::Part && sample.away.z.abs() > SAME) {
        let across = match rotary {
            None => across.extend(0.0),
            Some(rotary) => control.in_plane(control.way_in_degree(rotary.axis, control.axes(sample.at))?),
        };
        let lean = across.dot(sample.out);
        least = least.min(sample.out.z / libm::hypot(sample.out.z, lean).max(SAME));
    }
    Ok(least.max(0.0))
}

/// Leaves the part upwards.
fn lift(control: &mut dyn Control, range: &Range) -> Done {
    let (here, feed) = control.stylus()?;
    let here = control.in_plane(here);
    // A stylus on a wall leaves it first.
    if control.touches(control.axes(here), OFF / 2.0)?
        && let Some(Felt { out, .. }) = nearest(control, here)?
    {
        control.fly(control.axes(here + out * OFF), Some(feed))?;
    }
    let (here, _) = control.stylus()?;
    let up = control.in_plane(here).truncate().extend(range.height);
    control.digitizing().push(Row::Height(range.height));
    control.fly(control.axes(up), None)
}

/// What is touched beside or below a place.
fn nearest(control: &dyn Control, here: DVec3) -> Result<Option<Felt>, Fault> {
    for away in [DVec3::Z, DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y] {
        if let Some(felt) = feel(control, here + away * OFF, here - away * OFF)? {
            return Ok(Some(felt));
        }
    }
    Ok(None)
}

/// The fault of lines without a distance.
fn checked(spacing: f64) -> Done {
    if spacing > 0.0 {
        return Ok(());
    }
    Err(Fault::program("parameter-out-of-range").arg("q", "line-spacing").arg("value", spacing).into())
}

/// Goes over a place at the clearance height, down at rapid traverse to a height, and from there to the part.
fn come_down(control: &mut dyn Control, over: DVec2, height: f64, travel: Option<f64>) -> Done {
    let range = range_of(control)?;
    lift(control, &range)?;
    go_over(control, &range, over)?;
    let floor = control.in_plane(range.least).z;
    let height = height.clamp(floor, range.height.max(floor));
    let flat = in_working_plane(control, &range, over);
    control.fly(control.axes(flat.extend(height)), None)?;
    down(control, travel)
}

/// The stretches of the present line.
fn stretches(control: &mut dyn Control) -> Vec<(DVec2, DVec2)> {
    control.digitizing().lines.as_ref().map(Lines::stretches).unwrap_or_default()
}

/// Digitizes the stretches of a line after the first of them is begun.
fn whole_line(control: &mut dyn Control, line: &[(DVec2, DVec2)], height: f64, manner: &Manner) -> Done<f64> {
    let across = control.digitizing().lines.as_ref().map_or(DVec2::ZERO, |lines| lines.across);
    let (mut share, mut places): (f64, _) = (1.0, Vec::new());
    for (index, (from, to)) in line.iter().enumerate() {
        if index > 0 {
            come_down(control, *from, height, manner.travel)?;
        }
        let samples = along(control, *to, *from, manner)?;
        share = share.min(if manner.travel.is_none() { leaning(control, &samples, across)? } else { 1.0 });
        places.extend(sudden(&samples));
    }
    keep_sudden(control, places);
    Ok(share)
}

impl Action for ScanMeander {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        checked(self.spacing.0)?;
        let (manner, range) = (self.manner(control)?, range_of(control)?);
        let mut line = stretches(control);
        loop {
            let share = whole_line(control, &line, range.height, &manner)?;
            let end = line.last().map(|(_, to)| *to);
            let step = self.step(share);
            if !control.digitizing().lines.as_mut().is_some_and(|lines| lines.go_on(step)) {
                return Ok(());
            }
            let back = control.digitizing().lines.as_ref().is_some_and(|lines| lines.count % 2 == 1);
            line = stretches(control);
            if back {
                line = line.iter().rev().map(|(from, to)| (*to, *from)).collect();
            }
            let (Some(end), Some((next, _))) = (end, line.first().copied()) else { continue };
            let leaves = control.digitizing().lines.as_ref().is_some_and(|lines| lines.leaves(end, next));
            if leaves {
                come_down(control, next, range.height, manner.travel)?;
            } else {
                along(control, next, end, &manner)?;
            }
        }
    }
}

impl Action for ScanLine {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        checked(self.spacing.0)?;
        let (manner, range) = (self.manner(control)?, range_of(control)?);
        let line = stretches(control);
        let share = whole_line(control, &line, range.height, &manner)?;
        let step = self.step(share);
        control.digitizing().next_step = step;
        Ok(())
    }
}

impl Action for ReturnForNextLine {
    type Results = ();
    const PROBES: bool = true;

    fn act(&self, control: &mut dyn Control) -> Done {
        let manner = self.manner(control)?;
        loop {
            let step = control.digitizing().next_step;
            if !control.digitizing().lines.as_mut().is_some_and(|lines| lines.go_on(step)) {
                return Ok(());
            }
            let line = stretches(control);
            let Some((start, _)) = line.first().copied() else { continue };
            come_down(control, start, self.height.0, manner.travel)?;
            let share = whole_line(control, &line, self.height.0, &manner)?;
            control.digitizing().next_step = self.step(share);
        }
    }
}

impl Action for LeaveDigitizing {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let range = range_of(control)?;
        lift(control, &range)?;
        if let Some(to) = self.to {
            control.fly(control.axes(to.0.truncate().extend(range.height)), None)?;
        }
        control.write_data()
    }
}
