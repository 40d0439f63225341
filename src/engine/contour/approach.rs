//! Ways to a contour and away from it: perpendicular to its beginning, and the forms of `APPR` and `DEP`.
//!
//! Invariant: the lines and arcs are those of the tool's centre; they join the path next to the contour.
use glam::DVec2;

use crate::base::expr::atan2d;
use crate::engine::contour::element::{length, turn_between, turned};
use crate::engine::geometry::left_of;
use crate::engine::motion::moves::Speed;
use crate::engine::report::fault::Fault;

/// A piece of a way in the working plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Leg {
    Line(DVec2),
    Arc { centre: DVec2, to: DVec2, sweep: f64 },
}

impl Leg {
    /// The same leg so far beside.
    pub(crate) fn moved(&self, by: DVec2) -> Self {
        match *self {
            Self::Line(to) => Self::Line(to + by),
            Self::Arc { centre, to, sweep } => Self::Arc { centre: centre + by, to: to + by, sweep },
        }
    }
}

/// The form of a way to a contour or away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Form {
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
pub(crate) struct Lead {
    pub(crate) form: Form,
    /// The speed before the contour is approached.
    pub(crate) before: Option<Result<Speed, Fault>>,
}

impl Lead {
    /// Straight to the point at a tool radius from the first point of the contour.
    pub(crate) const fn straight() -> Self {
        Self { form: Form::Straight, before: None }
    }

    /// How fast the tool goes to where the approach begins.
    pub(crate) fn speed_before(&self) -> Option<Result<Speed, Fault>> {
        self.before.clone()
    }

    /// The auxiliary point at which the approach begins, and its lines and arcs from there, for a tool that is at
    /// `from` and joins a path that leads from `to` into a direction.
    pub(crate) fn legs(
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
                // Without compensation the arc lies on the side on which the tool is.
                let direction = side_or(side, along.perp_dot(from - to));
                let centre = to + left_of(along) * (direction * radius);
                let start = touch(from, centre, radius, direction)?;
                Ok((Some(start), vec![arc(start, centre, direction)]))
            }
        }
    }
}

impl Form {
    /// Whether it lies to one side of the contour, the side of the tool.
    pub(crate) const fn needs_side(&self) -> bool {
        matches!(self, Self::Across(_) | Self::Arc(..))
    }

    /// The lines and arcs by which a tool leaves a contour: from its end, in whose direction, to a point.
    pub(crate) fn legs_away(&self, from: DVec2, to: DVec2, along: DVec2, side: i8) -> Result<Vec<Leg>, Fault> {
        Ok(match *self {
            Self::Straight => Vec::new(),
            Self::Along(length) => vec![Leg::Line(from + along * length)],
            Self::Across(length) => vec![Leg::Line(from + left_of(along) * (given(side)? * length))],
            Self::Arc(radius, angle) => {
                let direction = given(side)? * radius.signum();
                let centre = from + left_of(along) * (direction * radius.abs());
                let sweep = angle * direction;
                vec![Leg::Arc { centre, to: turned(from, centre, sweep), sweep }]
            }
            Self::ArcAndLine(radius) => {
                let end = to;
                let direction = side_or(side, along.perp_dot(end - from));
                let centre = from + left_of(along) * (direction * radius);
                let leave = touch(end, centre, radius, -direction)?;
                let sweep = turn_between(from - centre, leave - centre, direction) * direction;
                vec![Leg::Arc { centre, to: leave, sweep }, Leg::Line(end)]
            }
        })
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
