//! Patterns: points of PATTERN DEF and point tables, calling the last cycle on them or at a position, and the values of
//! GLOBAL DEF.
//!
//! Invariant: a pattern is read when it is defined; a cycle that has a surface coordinate gets the coordinate of the
//! point added to it, any other one an additional datum shift.
use glam::DVec3;

use crate::base::expr::{QRef, cosd, sind};
use crate::engine::flow::state::Pattern;
use crate::engine::flow::state::Retraction;
use crate::engine::flow::state::Run;
use crate::engine::geometry::Axis;
use crate::engine::motion::moves::Speed;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::{Class, Fault};
use crate::program::syntax::{Block, Coord, Feed, FeedKind, GlobalDef, ValueKind};

/// The meanings of parameters that have to do with where a cycle is called.
const SURFACE: &str = "surface-coordinate";
const CLEARANCE: &str = "set-up-clearance";
const SECOND_CLEARANCE: &str = "second-set-up-clearance";
/// The number of the definition that says how the tool is retracted on patterns.
const POSITIONING: u32 = 125;
/// Positions of a pattern that are written one by one.
const MOST_POSITIONS: f64 = 9.0;
/// Positions of one pattern: more are refused.
const MAX_POINTS: f64 = 100_000.0;
/// The words of patterns; longer ones first.
const WORDS: [&str; 15] =
    ["START", "NUMX", "NUMY", "ROTX", "ROTY", "STEP", "NUM", "ROT", "END", "DX", "DY", "X", "Y", "Z", "D"];

/// The values of one pattern by word.
struct Values(Vec<(&'static str, f64)>);

impl Values {
    fn given(&self, word: &str) -> Option<f64> {
        self.0.iter().find(|(known, _)| *known == word).map(|(_, value)| *value)
    }

    fn or_zero(&self, word: &str) -> f64 {
        self.given(word).unwrap_or(0.0)
    }

    fn count(&self, word: &str) -> Result<u32, Fault> {
        let number = self.given(word).unwrap_or(f64::NAN);
        if number > MAX_POINTS {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_POINTS));
        }
        if number >= 1.0 && number.fract() == 0.0 { Ok(number as u32) } else { Err(unreadable(word)) }
    }

    fn start(&self) -> Result<DVec3, Fault> {
        let need = |word| self.given(word).ok_or_else(|| unreadable(word));
        Ok(DVec3::new(need("X")?, need("Y")?, self.or_zero("Z")))
    }

    /// The point of a column and a line. The main and the minor axis of the pattern may be turned by themselves.
    fn cell(&self, start: DVec3, column: u32, line: u32) -> DVec3 {
        let main = self.or_zero("ROT") + self.or_zero("ROTX");
        let minor = self.or_zero("ROT") + self.or_zero("ROTY") + 90.0;
        let (along, across) = (f64::from(column) * self.or_zero("DX"), f64::from(line) * self.or_zero("DY"));
        let x = along * cosd(main) + across * cosd(minor);
        let y = along * sind(main) + across * sind(minor);
        start + DVec3::new(x, y, 0.0)
    }
}

fn unreadable(found: &str) -> Fault {
    Fault::program("pattern-unreadable").arg("found", found)
}

impl<'e> Run<'_, 'e> {
    /// `PATTERN DEF`: its text without comments, in capitals.
    pub(crate) fn define_pattern(&mut self, block: &Block) -> Done {
        let text = self.uncommented(block);
        let body = text.find("DEF").and_then(|at| text.get(at + 3..)).unwrap_or_default();
        self.pattern_axis()?;
        let (mut points, mut positions) = (Pattern::new(), 0.0);
        let mut rest = body.trim_start();
        while !rest.is_empty() {
            let found = || unreadable(rest.get(..20).unwrap_or(rest));
            let (head, after) = rest.split_once('(').ok_or_else(found)?;
            let (inside, after) = after.split_once(')').ok_or_else(found)?;
            let kind = head.trim().trim_end_matches(|c: char| c.is_ascii_digit());
            let values = self.pattern_values(inside)?;
            pattern_points(kind, &values, &mut points)?;
            positions += f64::from(u8::from(kind == "POS"));
            rest = after.trim_start();
        }
        if positions > MOST_POSITIONS {
            return Err(Fault::program("pattern-too-long").arg("count", positions).arg("limit", MOST_POSITIONS).into());
        }
        (self.patterns.points, self.patterns.is_defined) = (Some(points), true);
        Ok(())
    }

    /// The manual allows pattern definitions with the tool axis Z only.
    fn pattern_axis(&self) -> Result<(), Fault> {
        let tool = self.drives.world.system.plane.tool;
        if tool == Axis::Z {
            return Ok(());
        }
        Err(Fault::program("pattern-tool-axis").arg("axis", tool.letter().to_string()))
    }

    /// The text of a block without comments and joins, in capitals.
    fn uncommented(&self, block: &Block) -> String {
        let lines = self.slice(block.span).lines();
        let bare = lines.map(|line| line.split([';', '\t']).next().unwrap_or_default().replace('~', " "));
        bare.collect::<Vec<_>>().join(" ").to_ascii_uppercase()
    }

    fn pattern_values(&self, inside: &str) -> Result<Values, Fault> {
        let mut values = Vec::new();
        for written in inside.split_whitespace() {
            let word = WORDS.into_iter().find(|word| written.starts_with(word)).ok_or_else(|| unreadable(written))?;
            let number = written.strip_prefix(word).unwrap_or_default();
            let value = self.written_number(number).map_err(|_| unreadable(written))?;
            let length = matches!(word, "X" | "Y" | "Z" | "D" | "DX" | "DY");
            values.push((word, if length { value * self.drives.unit() } else { value }));
        }
        Ok(Values(values))
    }

    /// `SEL PATTERN`: the points of a table that are not hidden.
    pub(crate) fn select_pattern(&mut self, name: &str) -> Done {
        let table = self.drives.world.scene.points.iter().find(|table| table.is_named(name));
        let table = table.ok_or_else(|| Fault::program("pattern-missing").arg("name", name))?;
        let mut points = Pattern::new();
        for row in table.rows() {
            let number = |column| table.number(row, column).map(Option::unwrap_or_default);
            // Tables of older software have no such column.
            let has_column = table.columns().any(|own| own == "FADE");
            let hidden = has_column.then(|| table.text(row, "FADE")).transpose()?;
            let hidden = hidden.map(|word| word.trim().to_ascii_uppercase());
            if !matches!(hidden.as_deref(), Some("Y" | "YES" | "1")) {
                points.push(self.drives.in_plane(DVec3::new(number("X")?, number("Y")?, number("Z")?)));
            }
        }
        (self.patterns.points, self.patterns.is_defined) = (Some(points), false);
        Ok(())
    }

    /// `CYCL CALL PAT`: on every point; between two of them the tool goes to the greater of the height at the call and
    /// the second set-up clearance of the cycle, unless the program chooses one of them.
    pub(crate) fn call_on_pattern(&mut self, feed: Option<&Feed>) -> Done {
        let missing = || Fault::program("pattern-missing").arg("name", "none");
        let points = self.patterns.points.clone().ok_or_else(missing)?;
        if self.patterns.is_defined {
            self.pattern_axis()?;
        }
        // The manual excludes rapid traverse between the points of a table by this word (001: 1663).
        if !self.patterns.is_defined && matches!(feed.map(|feed| feed.kind), Some(FeedKind::Max)) {
            return Err(Fault::program("word-not-offered").arg("word", "FMAX").into());
        }
        let speed = self.speed(feed);
        let called_at = self.drives.in_plane(self.drives.world.here).z;
        for point in points {
            let height = self.height_on_pattern(point, called_at);
            self.lift_to(height)?;
            self.call_shifted(point, speed.clone())?;
            if self.patterns.retraction != Retraction::Greater {
                self.lift_to(height)?;
            }
        }
        Ok(())
    }

    /// How high the tool goes to and from a point of a pattern.
    fn height_on_pattern(&self, point: DVec3, called_at: f64) -> f64 {
        let (surface, clearances) = self.call_heights();
        let second = clearances.map(|(first, second)| surface + point.z + if second == 0.0 { first } else { second });
        match (self.patterns.retraction, second) {
            (Retraction::Start, _) | (_, None) => called_at,
            (Retraction::Second, Some(second)) => second,
            (Retraction::Greater, Some(second)) => called_at.max(second),
        }
    }

    fn lift_to(&mut self, height: f64) -> Done {
        let here = self.drives.in_plane(self.drives.world.here);
        if here.z < height { self.go_in_plane(here.truncate().extend(height), Ok(Speed::Rapid)) } else { Ok(()) }
    }

    /// `CYCL CALL POS`: below the surface the tool goes to the clearance first. The coordinate of the tool axis shifts
    /// the surface.
    pub(crate) fn call_at(&mut self, coords: &[Coord], feed: Option<&Feed>) -> Done {
        let speed = self.speed_for_once(feed);
        let now = self.drives.world.here;
        let mut to = now;
        let mut given = [false; 3];
        for coord in coords {
            let axis = crate::engine::motion::axis::linear(coord.axis)?;
            to = axis.with(to, self.coordinate(coord, axis.of(now))?);
            given[Axis::ALL.iter().position(|known| *known == axis).unwrap_or_default()] = true;
        }
        if given != [true; 3] {
            return Err(Fault::program("position-incomplete").into());
        }
        let (point, here) = (self.drives.in_plane(to), self.drives.in_plane(now));
        let (surface, clearances) = self.call_heights();
        if let Some((first, second)) = clearances {
            let surface = surface + point.z;
            if here.z <= surface {
                let safe = surface + if second == 0.0 { first } else { second };
                self.go_in_plane(here.truncate().extend(safe), Ok(Speed::Rapid))?;
            }
        }
        self.call_shifted(point, speed)
    }

    /// The feed of one block that stays without effect on the next one.
    fn speed_for_once(&mut self, feed: Option<&Feed>) -> Result<Speed, Fault> {
        let before = self.modal.feed;
        let speed = self.speed(feed);
        self.modal.feed = before;
        speed
    }

    /// The surface of the last cycle, and its clearances if it has a surface.
    fn call_heights(&self) -> (f64, Option<(f64, f64)>) {
        let unit = self.unit_of_last();
        let number = |is| self.called_parameter(is).and_then(|q| self.params.number(q).ok()).unwrap_or(0.0) * unit;
        if self.called_parameter(SURFACE).is_none() {
            return (0.0, None);
        }
        (number(SURFACE), Some((number(CLEARANCE), number(SECOND_CLEARANCE))))
    }

    /// mm in the unit in which the last cycle was defined.
    fn unit_of_last(&self) -> f64 {
        self.cycles.last.as_ref().map_or(1.0, |definition| definition.unit)
    }

    /// The parameter of the last cycle with that meaning.
    fn called_parameter(&self, is: &str) -> Option<QRef> {
        self.cycles.last.as_ref()?.cycle.params.iter().find(|param| param.is.as_str() == is)?.q
    }

    fn go_in_plane(&mut self, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        self.drives.straight_to(self.drives.world.system.axes(to), None, speed)
    }

    /// Over the point in the working plane, and the cycle there.
    fn call_shifted(&mut self, point: DVec3, speed: Result<Speed, Fault>) -> Done {
        let here = self.drives.in_plane(self.drives.world.here);
        self.go_in_plane(point.truncate().extend(here.z), speed)?;
        if let Some(surface) = self.called_parameter(SURFACE) {
            let before = self.params.number(surface)?;
            self.params.set(surface, &Content::Number(before + point.z / self.unit_of_last()))?;
            let done = self.call_last_cycle();
            self.params.set(surface, &Content::Number(before))?;
            return done;
        }
        let shift = self.drives.world.system.axes(point);
        self.shift_to_point(shift);
        let done = self.call_last_cycle();
        self.shift_to_point(DVec3::ZERO);
        done
    }

    fn shift_to_point(&mut self, by: DVec3) {
        self.drives.world.system.set_point(by);
        self.drives.world.renew();
        let reported = self.drives.world.system.reported();
        self.drives.report.report(EventKind::Transform(reported));
    }

    /// `GLOBAL DEF`: values for parameters that say PREDEF, and how the tool is retracted on patterns.
    pub(crate) fn predefine(&mut self, values: &GlobalDef) -> Done {
        if let Some(error) = values.errors.first() {
            let found = self.slice(error.span).trim().to_owned();
            return Err(Fault::program("block-unreadable").arg("found", found).into());
        }
        for parameter in &values.parameters {
            if parameter.value.kind == ValueKind::Missing {
                return Err(Fault::program("value-missing").into());
            }
            let value = self.number_of(&parameter.value)?;
            if values.number == POSITIONING {
                self.patterns.retraction = match value {
                    0.0 => Retraction::Second,
                    1.0 => Retraction::Start,
                    _ => {
                        let fault = Fault::program("parameter-out-of-range").arg("q", parameter.q.to_string());
                        return Err(fault.arg("value", value).into());
                    }
                };
            }
            self.cycles.predefined.insert(parameter.q.number, (value, self.drives.unit()));
        }
        Ok(())
    }
}

/// Adds the points of one pattern.
fn pattern_points(kind: &str, values: &Values, points: &mut Pattern) -> Result<(), Fault> {
    let start = values.start()?;
    let on_circle = |angle: f64| {
        let radius = values.or_zero("D") / 2.0;
        start + DVec3::new(radius * cosd(angle), radius * sind(angle), 0.0)
    };
    match kind {
        "POS" => points.push(start),
        "ROW" => {
            let (step, angle) = (values.or_zero("D"), values.or_zero("ROT"));
            let direction = DVec3::new(cosd(angle), sind(angle), 0.0);
            points.extend((0..values.count("NUM")?).map(|i| start + direction * (f64::from(i) * step)));
        }
        "PAT" => {
            let (columns, lines) = (values.count("NUMX")?, values.count("NUMY")?);
            if f64::from(columns) * f64::from(lines) > MAX_POINTS {
                return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_POINTS));
            }
            for line in 0..lines {
                let forwards = |i| if line % 2 == 0 { i } else { columns - 1 - i };
                points.extend((0..columns).map(|i| values.cell(start, forwards(i), line)));
            }
        }
        "FRAME" => {
            let (columns, lines) = (values.count("NUMX")?, values.count("NUMY")?);
            let (right, top) = (columns - 1, lines - 1);
            points.extend((0..columns).map(|i| values.cell(start, i, 0)));
            points.extend((1..lines).map(|i| values.cell(start, right, i)));
            if top > 0 {
                points.extend((0..right).rev().map(|i| values.cell(start, i, top)));
            }
            if right > 0 {
                points.extend((1..top).rev().map(|i| values.cell(start, 0, i)));
            }
        }
        "CIRC" => {
            let count = values.count("NUM")?;
            let step = 360.0 / f64::from(count);
            points.extend((0..count).map(|i| on_circle(values.or_zero("START") + f64::from(i) * step)));
        }
        "PITCHCIRC" => {
            let (count, begin) = (values.count("NUM")?, values.or_zero("START"));
            let step = match (values.given("STEP"), values.given("END")) {
                (Some(step), _) => step,
                (None, Some(end)) => (end - begin) / f64::from((count - 1).max(1)),
                (None, None) => return Err(unreadable("STEP")),
            };
            points.extend((0..count).map(|i| on_circle(begin + f64::from(i) * step)));
        }
        other => return Err(unreadable(other)),
    }
    Ok(())
}
