//! Strategies of the tool setter: going to it, measuring length and radius of a tool, calibrating it.
//!
//! Invariant: one length or radius at a time, which may be that of one edge of all; how it compares with the tool table, wear
//! and what is written are formulas of the cycles (`cycle-specs/tool-measurement`). Spindle speed
//! and feed are those of the manuals (001:14853-14897).
use glam::{DVec2, DVec3};

use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control, KnownSetter};
use crate::engine::strategy::signature::{Mm, results, strategy};
use crate::engine::table::TableKind;

strategy! {
    /// Over the centre of the tool setter: at rapid traverse at a height, and down to the safety distance above it.
    ApproachToolSetter = "approach-tool-setter" {
        /// The height in program coordinates; one below the setter is that of the safety distance.
        height: Mm<f64> = Length,
    }
}

strategy! {
    /// Beside the tool setter, on the side of the positive main axis, so deep that it touches with its side.
    ApproachToolSetterSide = "approach-tool-setter-side" {}
}

strategy! {
    /// Measures the length on the face of the setter: turning if the tool is put aside for it, else standing.
    MeasureToolLength = "measure-tool-length" {}
}

strategy! {
    /// Measures the length of each edge with the spindle standing.
    MeasureLengthOfTeeth = "measure-length-of-teeth" {
        /// 0: the longest edge counts; else the one that differs most from the tool table.
        check: f64 = Number,
        /// How many edges can be measured one by one.
        most: Option<f64> = Number,
    }
}

strategy! {
    /// Measures the radius with the tool turning, beside the setter; a tool without edges stands.
    MeasureToolRadius = "measure-tool-radius" {}
}

strategy! {
    /// Measures the radius of each edge with the spindle standing.
    MeasureRadiiOfTeeth = "measure-radii-of-teeth" {
        /// The radius of the turning tool, mm.
        rotating: Mm<f64> = Length,
        /// 0: the widest edge counts; else the one that differs most from the tool table.
        check: f64 = Number,
        /// How many edges can be measured one by one.
        most: Option<f64> = Number,
    }
}

strategy! {
    /// The radius of the turning tool is the result.
    TakeRotatingRadius = "take-rotating-radius" {
        /// That radius, mm.
        rotating: Mm<f64> = Length,
    }
}

strategy! {
    /// Touches the face and the four sides of the setter with a calibration tool.
    CalibrateToolSetter = "calibrate-tool-setter" {
        /// Whether the tool is over the setter already, which has no known place.
        by_hand: bool = Number,
    }
}

strategy! {
    /// The same with the spindle turned, so that the place of the tool in the spindle cancels out.
    CalibrateToolSetterTurned = "calibrate-tool-setter-turned" {
        /// By how much, degrees.
        angle: f64 = Angle,
        /// The centre found before, in the machine.
        main: Mm<f64> = Length,
        /// Its minor coordinate.
        minor: Mm<f64> = Length,
        /// The height of the face.
        tool: Mm<f64> = Length,
        /// Its radius.
        radius: Mm<f64> = Length,
    }
}

strategy! {
    /// Keeps what a calibration has found for the measurements that follow.
    StoreToolSetterCalibration = "store-tool-setter-calibration" {
        /// The centre in the machine.
        main: Mm<f64> = Length,
        /// Its minor coordinate.
        minor: Mm<f64> = Length,
        /// The height of the face.
        tool: Mm<f64> = Length,
        /// Its radius.
        radius: Mm<f64> = Length,
    }
}

results! {
    /// A length.
    LengthResults {
        /// The length of the tool.
        length: Mm<f64> = Length,
    }
}

results! {
    /// A radius.
    RadiusResults {
        /// The radius of the tool.
        radius: Mm<f64> = Length,
    }
}

results! {
    /// Where the setter is.
    CalibrationResults {
        /// The main coordinate of its centre in the machine.
        main: Mm<f64> = Length,
        /// The minor coordinate.
        minor: Mm<f64> = Length,
        /// The height of its face.
        tool: Mm<f64> = Length,
        /// The radius of its face.
        radius: Mm<f64> = Length,
    }
}

/// mm per metre and turns per circumference, as the manuals round it.
const CIRCUMFERENCE: f64 = 0.0063;
/// Up to each multiple of this radius, mm, the measuring tolerance is the same multiple.
const STEP_OF_TOLERANCE: f64 = 30.0;
/// The multiples end here.
const MOST_TOLERANCES: f64 = 4.0;
/// The radius, mm, for which the least tolerance is meant where the feed is constant.
const RADIUS_OF_CONSTANT_FEED: f64 = 5.0;
/// How much farther than the safety distance a tool goes to touch.
const BEYOND: f64 = 2.0;

/// A tool at the setter.
struct Work<'c> {
    control: &'c mut dyn Control,
    setter: KnownSetter,
    safety: f64,
}

impl<'c> Work<'c> {
    fn new(control: &'c mut dyn Control) -> Result<Self, Fault> {
        let (setter, safety) = (control.setter()?, control.setting("setter-safety-distance")?);
        Ok(Self { control, setter, safety })
    }

    /// A point of the machine beside the centre of the face and above it.
    fn point(&self, beside: DVec2, above: f64) -> DVec3 {
        let plane = self.control.plane();
        let (centre, top) = (plane.flat(self.setter.at), plane.tool.of(self.setter.at));
        plane.lift(centre + beside, top + above)
    }

    /// Up to a height above the face if the tip is below it, across, and down.
    fn go(&mut self, beside: DVec2, above: f64) -> Done {
        let plane = self.control.plane();
        let (tip, to) = (self.control.tip()?, self.point(beside, above));
        let over = plane.tool.of(tip).max(plane.tool.of(self.point(beside, self.safety)));
        self.control.go(plane.tool.with(tip, over))?;
        self.control.go(plane.tool.with(to, over))?;
        self.control.go(to)
    }

    /// Touches along a way of length 1, and goes back to where it began; where the tip was.
    fn touch(&mut self, way: DVec3, feed: f64, at: Option<f64>) -> Done<DVec3> {
        let begin = self.control.tip()?;
        let path = BEYOND * self.safety;
        let Some(found) = self.control.touch_setter(way * path, feed, at)? else {
            return Err(Fault::control("probe-no-contact").arg("distance", path).into());
        };
        self.control.go(begin)?;
        Ok(found)
    }

    /// A column of the tool table; nothing if its cell is empty.
    fn column(&self, column: &str) -> Result<Option<f64>, Fault> {
        self.control.number(TableKind::Tool, self.control.tool().unwrap_or_default(), column)
    }

    /// How many edges the tool table says.
    fn edges(&self) -> Result<f64, Fault> {
        Ok(self.column("CUT")?.unwrap_or_default())
    }

    /// An error of more edges than can be measured one by one.
    fn can_measure_edges(&self, most: Option<f64>) -> Result<(), Fault> {
        let count = self.edges()?;
        match most.filter(|most| count > *most) {
            Some(most) => Err(Fault::control("tool-edges-too-many").arg("count", count).arg("most", most)),
            None => Ok(()),
        }
    }

    /// How far the tool is put aside when its length is measured: by its radius where nothing else is entered.
    fn aside(&self) -> Result<f64, Fault> {
        Ok(self.column("R-OFFS")?.unwrap_or_else(|| self.control.reckoned().0))
    }

    /// Rotary speed and feed of a turning tool: the speed that keeps its circumference to the greatest admissible one,
    /// and the feed that keeps the measuring tolerance.
    fn speed_and_feed(&self) -> Result<(f64, f64), Fault> {
        let radius = self.control.reckoned().0;
        let speed = self.control.setting("max-peripheral-speed")? / (radius * CIRCUMFERENCE);
        let least = self.control.setting("measuring-tolerance")?;
        let tolerance = match self.control.setting_word("probing-feed-calculation").as_deref() {
            Some("VariableTolerance" | "VariableTolreance" | "1") => {
                least * (radius / STEP_OF_TOLERANCE).ceil().clamp(1.0, MOST_TOLERANCES)
            }
            Some("ConstantFeed" | "2") => radius * least / RADIUS_OF_CONSTANT_FEED,
            _ => least,
        };
        Ok((speed, tolerance * speed))
    }

    /// Touches with the tool turning against its cutting direction.
    fn touch_turning(&mut self, way: DVec3) -> Done<DVec3> {
        let (speed, feed) = self.speed_and_feed()?;
        let before = self.control.running().speed;
        // An edge that cuts with M4 (DIRECT. +) turns with M3.
        let cuts_counter_clockwise = self.control.cuts_counter_clockwise()?;
        self.control.turn(if cuts_counter_clockwise { 1 } else { -1 }, speed);
        let found = self.touch(way, feed, None);
        self.control.turn(0, before);
        found
    }

    /// Touches with the spindle standing at an angle.
    fn touch_standing(&mut self, way: DVec3, angle: f64) -> Done<DVec3> {
        let feed = self.control.setting("stationary-probing-feed")?;
        self.control.orient(angle);
        self.touch(way, feed, Some(angle))
    }

    fn down(&self) -> DVec3 {
        -self.control.plane().tool.unit()
    }

    /// The length that a tip over the face means.
    fn length(&self, tip: DVec3) -> f64 {
        let tool = self.control.plane().tool;
        self.control.reckoned().1 + tool.of(tip) - tool.of(self.setter.at)
    }

    /// How far from the centre a tool begins that touches the side.
    fn beside(&self) -> f64 {
        self.setter.radius + self.control.reckoned().0 + self.safety
    }

    /// The angles at which each edge points from the positive main axis towards the setter.
    fn angles(&self) -> Result<Vec<f64>, Fault> {
        let count = self.edges()?.max(1.0) as u32;
        let first = self.control.first_edge()?;
        Ok((0..count)
            .map(|edge| (180.0 - first - 360.0 / f64::from(count) * f64::from(edge)).rem_euclid(360.0))
            .collect())
    }
}

/// The greatest value, or the one that is farthest from the nominal one.
fn decisive(values: &[f64], nominal: f64, check: f64) -> f64 {
    let greater = |a: &f64, b: &f64| {
        if check == 0.0 { a.total_cmp(b) } else { (a - nominal).abs().total_cmp(&(b - nominal).abs()) }
    };
    values.iter().copied().max_by(greater).unwrap_or(nominal)
}

impl Action for ApproachToolSetter {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let plane = control.plane();
        let (frame, tip, mounted) = (control.frame(), control.tip()?, control.setter_frame()?);
        let here = frame.inverse().point(mounted.point(tip));
        let height = frame.point(plane.tool.with(here, self.height.0));
        let height = plane.tool.of(mounted.inverse().point(height));
        let mut work = Work::new(control)?;
        let least = plane.tool.of(work.point(DVec2::ZERO, work.safety));
        let over = height.max(least);
        let highest = plane.tool.of(tip).max(over);
        let above = work.point(DVec2::ZERO, work.safety);
        work.control.go(plane.tool.with(tip, highest))?;
        work.control.go(plane.tool.with(above, highest))?;
        work.control.go(plane.tool.with(above, over))?;
        work.go(DVec2::ZERO, work.safety)
    }
}

impl Action for ApproachToolSetterSide {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        Work::new(control)?.go_beside()
    }
}

impl Action for MeasureToolLength {
    type Results = LengthResults;

    fn act(&self, control: &mut dyn Control) -> Done<LengthResults> {
        let mut work = Work::new(control)?;
        let aside = work.aside()?;
        work.go(DVec2::new(aside, 0.0), work.safety)?;
        let down = work.down();
        let tip = if aside == 0.0 { work.touch_standing(down, 0.0)? } else { work.touch_turning(down)? };
        Ok(LengthResults { length: Mm(work.length(tip)) })
    }
}

impl Action for MeasureLengthOfTeeth {
    type Results = LengthResults;

    fn act(&self, control: &mut dyn Control) -> Done<LengthResults> {
        let mut work = Work::new(control)?;
        work.can_measure_edges(self.most)?;
        work.go_beside()?;
        let inwards = -work.control.plane().main.unit();
        // Turning, it finds where the edges are.
        work.touch_turning(inwards)?;
        let aside = work.aside()?;
        work.go(DVec2::new(aside, 0.0), work.safety)?;
        let down = work.down();
        let mut lengths = Vec::new();
        for angle in work.angles()? {
            let tip = work.touch_standing(down, angle)?;
            lengths.push(work.length(tip));
        }
        let nominal = work.column("L")?.unwrap_or_default();
        Ok(LengthResults { length: Mm(decisive(&lengths, nominal, self.check)) })
    }
}

impl Work<'_> {
    /// Beside the setter, as deep as its offset and that of the tool say.
    fn go_beside(&mut self) -> Done {
        let deep = self.control.setting("setter-axis-offset")? + self.column("L-OFFS")?.unwrap_or_default();
        self.go(DVec2::new(self.beside(), 0.0), -deep)
    }

    /// The radius that a tip beside the setter means.
    fn radius(&self, tip: DVec3) -> f64 {
        let main = self.control.plane().main;
        main.of(tip - self.setter.at) - self.setter.radius
    }
}

impl Action for MeasureToolRadius {
    type Results = RadiusResults;

    fn act(&self, control: &mut dyn Control) -> Done<RadiusResults> {
        let mut work = Work::new(control)?;
        let inwards = -work.control.plane().main.unit();
        let stands = work.edges()? == 0.0;
        let tip = if stands { work.touch_standing(inwards, 0.0)? } else { work.touch_turning(inwards)? };
        Ok(RadiusResults { radius: Mm(work.radius(tip)) })
    }
}

impl Action for MeasureRadiiOfTeeth {
    type Results = RadiusResults;

    fn act(&self, control: &mut dyn Control) -> Done<RadiusResults> {
        let mut work = Work::new(control)?;
        work.can_measure_edges(self.most)?;
        let inwards = -work.control.plane().main.unit();
        let mut radii = Vec::new();
        for angle in work.angles()? {
            let tip = work.touch_standing(inwards, angle)?;
            radii.push(work.radius(tip));
        }
        if radii.is_empty() {
            radii.push(self.rotating.0);
        }
        let nominal = work.column("R")?.unwrap_or_default();
        Ok(RadiusResults { radius: Mm(decisive(&radii, nominal, self.check)) })
    }
}

impl Action for TakeRotatingRadius {
    type Results = RadiusResults;

    fn act(&self, _: &mut dyn Control) -> Done<RadiusResults> {
        Ok(RadiusResults { radius: self.rotating })
    }
}

/// Touches face and sides with the spindle at an angle.
fn calibrate(control: &mut dyn Control, around: Option<KnownSetter>, angle: f64) -> Done<CalibrationResults> {
    let mut work = Work::new(control)?;
    if let Some(around) = around {
        work.setter = around;
    }
    let plane = work.control.plane();
    let down = work.down();
    let (radius, length) = work.control.reckoned();
    // The face first: how deep the sides are touched counts from it.
    let tip = work.touch_standing(down, angle)?;
    let face = work.control.reckoned().1 + plane.tool.of(tip) - length;
    work.setter.at = plane.tool.with(work.setter.at, face);
    let deep = work.control.setting("setter-axis-offset")?;
    let far = work.beside();
    let side = |work: &mut Work<'_>, way: DVec2| -> Done<f64> {
        work.go(way * far, -deep)?;
        let inwards = plane.lift(-way, 0.0);
        let tip = work.touch_standing(inwards, angle)?;
        work.go(way * far, work.safety)?;
        Ok(plane.flat(tip).dot(way))
    };
    let (right, left) = (side(&mut work, DVec2::X)?, side(&mut work, DVec2::NEG_X)?);
    let (upper, lower) = (side(&mut work, DVec2::Y)?, side(&mut work, DVec2::NEG_Y)?);
    let centre = DVec2::new(right - left, upper - lower) / 2.0;
    let tried = plane.flat(work.setter.at);
    // A tool that goes past the centre of a disc touches it later: the half chord and the distance give the radius.
    let (across, along) = ((right + left) / 2.0, (upper + lower) / 2.0);
    let is_round = work.setter.is_round;
    let of_face = |half: f64, off: f64| if is_round { libm::hypot(half, off) } else { half } - radius;
    let found = (of_face(across, centre.y - tried.y) + of_face(along, centre.x - tried.x)) / 2.0;
    work.go(DVec2::ZERO, work.safety)?;
    Ok(CalibrationResults { main: Mm(centre.x), minor: Mm(centre.y), tool: Mm(face), radius: Mm(found) })
}

impl Action for CalibrateToolSetter {
    type Results = CalibrationResults;

    fn act(&self, control: &mut dyn Control) -> Done<CalibrationResults> {
        let around = if self.by_hand { Some(KnownSetter { at: control.tip()?, ..control.setter()? }) } else { None };
        calibrate(control, around, 0.0)
    }
}

impl Action for CalibrateToolSetterTurned {
    type Results = CalibrationResults;

    fn act(&self, control: &mut dyn Control) -> Done<CalibrationResults> {
        let plane = control.plane();
        let first = DVec2::new(self.main.0, self.minor.0);
        let around = KnownSetter { at: plane.lift(first, self.tool.0), radius: self.radius.0, ..control.setter()? };
        let second = calibrate(control, Some(around), self.angle)?;
        let mean = |a: f64, b: Mm<f64>| Mm((a + b.0) / 2.0);
        Ok(CalibrationResults {
            main: mean(first.x, second.main),
            minor: mean(first.y, second.minor),
            tool: mean(self.tool.0, second.tool),
            radius: mean(self.radius.0, second.radius),
        })
    }
}

impl Action for StoreToolSetterCalibration {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let at = control.plane().lift(DVec2::new(self.main.0, self.minor.0), self.tool.0);
        let known = KnownSetter { at, radius: self.radius.0, ..control.setter()? };
        control.calibrate_setter(known);
        Ok(())
    }
}
