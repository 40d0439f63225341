//! Ways to a contour and away from it: perpendicular to its beginning, and the forms of `APPR` and `DEP`.
//!
//! Invariant: the lines and arcs are those of the tool's centre; they join the path beside the contour.
use glam::{DVec2, DVec3};

use crate::base::expr::atan2d;
use crate::engine::contour::element::{length, turn_between, turned};
use crate::engine::contour::outline::left_of;
use crate::engine::motion::moves::Speed;
use crate::engine::report::fault::Fault;
use crate::engine::run::{Done, Run};
use crate::program::syntax::{Approach, Motion};

/// A piece of a way in the working plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) enum Leg {
    Line(DVec2),
    Arc { centre: DVec2, to: DVec2, sweep: f64 },
}

/// The form of a way to a contour or away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// Straight to the point itself.
    Straight,
    /// A line of that length along the contour.
    Along(f64),
    /// A line of that length across the contour.
    Across(f64),
    /// An arc: radius, positive on the side of the tool, and angle.
    Arc(f64, f64),
    /// An arc of that radius and a line.
    ArcAndLine(f64),
}

/// The way to a contour.
#[derive(Clone, Debug)]
pub(in crate::engine) struct Lead {
    form: Form,
    /// The speed before the contour is approached.
    before: Option<Result<Speed, Fault>>,
}

impl Lead {
    /// Straight to the point beside the first point of the contour.
    pub(in crate::engine) const fn straight() -> Self {
        Self { form: Form::Straight, before: None }
    }

    /// How fast the tool goes to where the approach begins.
    pub(in crate::engine) fn speed_before(&self) -> Option<Result<Speed, Fault>> {
        self.before.clone()
    }

    /// The auxiliary point at which the approach begins, and its lines and arcs from there, for a tool that stands at
    /// `from` and joins a path that leads from `to` into a direction.
    pub(in crate::engine) fn legs(
        &self,
        from: DVec2,
        to: DVec2,
        heading: Option<DVec2>,
        side: i8,
    ) -> Result<(Option<DVec2>, Vec<Leg>), Fault> {
        let Some(along) = heading else { return Err(Fault::program("contour-missing")) };
        let arc = |start: DVec2, centre: DVec2, direction: f64| {
            let sweep = turn_between(start - centre, to - centre, direction) * direction;
            Leg::Arc { centre, to, sweep }
        };
        match self.form {
            Form::Straight => Ok((None, vec![Leg::Line(to)])),
            Form::Along(length) => Ok((Some(to - along * length), vec![Leg::Line(to)])),
            Form::Across(length) => {
                let aside = left_of(along) * given(side)?;
                Ok((Some(to + aside * length), vec![Leg::Line(to)]))
            }
            Form::Arc(radius, angle) => {
                let direction = given(side)? * radius.signum();
                let centre = to + left_of(along) * (direction * radius.abs());
                let sweep = angle * direction;
                Ok((Some(turned(to, centre, -sweep)), vec![Leg::Arc { centre, to, sweep }]))
            }
            Form::ArcAndLine(radius) => {
                // Without compensation the arc lies on the side on which the tool stands.
                let direction = side_or(side, along.perp_dot(from - to));
                let centre = to + left_of(along) * (direction * radius);
                let start = touch(from, centre, radius, direction)?;
                Ok((Some(start), vec![arc(start, centre, direction)]))
            }
        }
    }
}

/// The side, where one is needed.
fn given(side: i8) -> Result<f64, Fault> {
    if side == 0 { Err(Fault::program("approach-impossible")) } else { Ok(f64::from(side)) }
}

fn side_or(side: i8, other: f64) -> f64 {
    match side {
        0 if other < 0.0 => -1.0,
        0 => 1.0,
        side => f64::from(side),
    }
}

/// Where a line from a point joins a circle that is gone round in a direction.
fn touch(from: DVec2, centre: DVec2, radius: f64, direction: f64) -> Result<DVec2, Fault> {
    let arm = from - centre;
    let far = length(arm);
    // Rounding apart, the point may lie on the circle.
    if far < radius * (1.0 - 1e-12) || radius <= 0.0 {
        return Err(Fault::program("approach-impossible"));
    }
    let line = libm::sqrt((far * far - radius * radius).max(0.0));
    Ok(turned(centre + arm * (radius / far), centre, direction * atan2d(line, radius)))
}

impl Run<'_, '_> {
    /// The value of `LEN` or `CCA`.
    fn word_of(&self, motion: &Motion, name: &str) -> Result<f64, Fault> {
        let found = motion.words.iter().find(|word| self.slice(word.name).eq_ignore_ascii_case(name));
        let Some(word) = found else { return Err(Fault::program("approach-word").arg("word", name)) };
        self.number_of(&word.value)
    }

    fn form(&self, motion: &Motion, form: Approach) -> Result<Form, Fault> {
        let radius = || match &motion.radius {
            Some(radius) => Ok(self.operand(radius)? * self.unit()),
            None => Err(Fault::program("approach-word").arg("word", "R")),
        };
        let length = || Ok::<_, Fault>(self.word_of(motion, "LEN")?.abs() * self.unit());
        Ok(match form {
            Approach::Lt | Approach::Plt => Form::Along(length()?),
            Approach::Ln | Approach::Pln => Form::Across(length()?),
            Approach::Ct | Approach::Pct => {
                let (radius, angle) = (radius()?, self.word_of(motion, "CCA")?);
                if radius == 0.0 || angle <= 0.0 || angle > 360.0 {
                    return Err(Fault::program("approach-impossible"));
                }
                Form::Arc(radius, angle)
            }
            Approach::Lct | Approach::Plct => Form::ArcAndLine(radius()?.abs()),
        })
    }

    /// `APPR`: the way to the first point of a contour waits for its first element.
    pub(in crate::engine) fn approach_contour(
        &mut self,
        motion: &Motion,
        form: Approach,
        to: DVec3,
        before: Result<Speed, Fault>,
        speed: Result<Speed, Fault>,
    ) -> Done {
        self.not_beside_contour("APPR")?;
        let side = self.side(motion);
        let form = self.form(motion, form)?;
        if side == 0 && matches!(form, Form::Across(_) | Form::Arc(..)) {
            return Err(Fault::program("approach-impossible").into());
        }
        self.begin_contour(side, Lead { form, before: Some(before) }, to, motion, speed)
    }

    /// `DEP`: the contour ends, and the tool leaves it.
    pub(in crate::engine) fn leave_by(
        &mut self,
        motion: &Motion,
        form: Approach,
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let side = self.contour.side();
        let along = self.heading()?;
        let form = self.form(motion, form)?;
        self.end_contour()?;
        let plane = self.world.system.plane;
        let (from, height) = (plane.flat(self.world.here), plane.tool.of(self.world.here));
        let legs = match form {
            Form::Straight => Vec::new(),
            Form::Along(length) => vec![Leg::Line(from + along * length)],
            Form::Across(length) => vec![Leg::Line(from + left_of(along) * (given(side)? * length))],
            Form::Arc(radius, angle) => {
                let direction = given(side)? * radius.signum();
                let centre = from + left_of(along) * (direction * radius.abs());
                let sweep = angle * direction;
                vec![Leg::Arc { centre, to: turned(from, centre, sweep), sweep }]
            }
            Form::ArcAndLine(radius) => {
                let end = plane.flat(to);
                let direction = side_or(side, along.perp_dot(end - from));
                let centre = from + left_of(along) * (direction * radius);
                let leave = touch(end, centre, radius, -direction)?;
                let sweep = turn_between(from - centre, leave - centre, direction) * direction;
                vec![Leg::Arc { centre, to: leave, sweep }, Leg::Line(end)]
            }
        };
        for leg in &legs {
            self.leg(leg, height, height, speed.clone())?;
        }
        self.contour.forget();
        // A height that is programmed, too, is reached last.
        self.straight_to(plane.tool.with(self.world.here, plane.tool.of(to)), None, speed)
    }
}
