//! Whether what a figure shows is so: each dimension measured in the run is the value of its parameter, and each of its
//! ends is a place that the run reached or a face of the workpiece.
use glam::{DVec2, DVec3};

use super::half_plane::distance;
use super::shot::{BAR, CORNERS, CUT, Shot, TOP, number};
use super::stroke::Stroke;
use super::{axonometric, rotary, slice};
use crate::base::diag::Diagnostic;
use crate::base::expr::{Value, tand};
use crate::spec::{Along, Cycle, Dimension, DimensionKind, Figure, FigureView};

/// What is measured is exact but for rounding.
const NEAR: f64 = 1e-6;
/// Ways are chords of arcs, which leave them by that much.
const ON_WAY: f64 = 0.05;

/// Where a dimension begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spot {
    /// At a coordinate along its axis, or at a direction.
    Coordinate(f64),
    /// At a point.
    Point(DVec3),
}

/// A dimension that was measured.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    /// The parameter as programs write it, or the id of the field.
    pub(super) of: String,
    /// The datum of the touch probe that is added to it.
    pub(super) plus: Option<String>,
    /// The parameter that it makes less.
    pub(super) reduces: Option<String>,
    /// Whether `of` is the id of a field.
    pub(super) field: bool,
    /// How it is measured.
    pub(super) kind: DimensionKind,
    /// The axis along which it is measured; none of a distance between points.
    pub(super) along: Option<Along>,
    /// Its first place.
    pub(super) from: Spot,
    /// Its second place.
    pub(super) to: Spot,
    /// The centre of an angle.
    pub(super) centre: DVec3,
    /// Whether it is measured from the datum.
    pub(super) from_datum: bool,
}

impl Measured {
    /// Whether it is a diameter of which the drawing shows the half.
    pub(super) fn is_half(&self) -> bool {
        self.kind == DimensionKind::Diameter && self.along == Some(Along::Main)
    }

    /// Whether it is measured from the datum, or from a place that has the coordinate 0 as the datum has.
    pub(super) fn begins_at_datum(&self) -> bool {
        let beside = |axis| matches!(self.from, Spot::Point(point) if along(point, axis).abs() <= NEAR);
        self.from_datum || self.along.is_some_and(beside)
    }
}

/// The coordinate of a point along an axis.
pub(super) const fn along(point: DVec3, axis: Along) -> f64 {
    match axis {
        Along::Main => point.x,
        Along::Minor => point.y,
        Along::Tool => point.z,
    }
}

/// The axes that a view shows: to the right and upwards.
pub(super) const fn axes(view: FigureView) -> [Along; 2] {
    match view {
        FigureView::Section | FigureView::Side | FigureView::Rotary | FigureView::RotaryB => [Along::Main, Along::Tool],
        FigureView::Plan | FigureView::RotaryC | FigureView::ThreeD => [Along::Main, Along::Minor],
        FigureView::RotaryA => [Along::Minor, Along::Tool],
        FigureView::Turned => [Along::Tool, Along::Main],
    }
}

/// A coordinate of a turned part as the view has it: of the main axis a radius.
fn seen(spot: Spot, axis: Option<Along>, figure: &Figure) -> Spot {
    match spot {
        Spot::Coordinate(diameter) if figure.view == FigureView::Turned && axis == Some(Along::Main) => {
            Spot::Coordinate(diameter / 2.0)
        }
        _ => spot,
    }
}

fn spot(value: &Option<Value>) -> Option<Spot> {
    match value {
        Some(Value::Number(number)) => Some(Spot::Coordinate(*number)),
        Some(Value::Point(point)) => Some(Spot::Point(*point)),
        _ => None,
    }
}

/// Whether what is measured is an angle.
const fn is_angle(kind: DimensionKind) -> bool {
    matches!(kind, DimensionKind::Angle | DimensionKind::Turn)
}

/// Measures all dimensions of a figure.
pub(super) fn measure(
    cycle: &Cycle,
    figure: &Figure,
    dimensions: &[&Dimension],
    shot: &Shot,
) -> (Vec<Measured>, Vec<Diagnostic>) {
    let (mut measured, mut found) = (Vec::new(), Vec::new());
    for (dimension, values) in dimensions.iter().zip(&shot.places) {
        match one(figure, dimension, values, shot) {
            Ok(one) => measured.push(one),
            Err(Wrong { code, args }) => {
                let diagnostic = Diagnostic::error(code, dimension.place.clone()).arg("name", name(dimension));
                let diagnostic = diagnostic.arg("cycle", cycle.key.to_string()).arg("figure", figure.name.as_str());
                found.push(args.into_iter().fold(diagnostic, |made, (key, value)| made.arg(key, value)));
            }
        }
    }
    (measured, found)
}

/// The parameter or field of a dimension.
pub(super) fn name(dimension: &Dimension) -> String {
    match (&dimension.q, &dimension.field) {
        (Some(q), _) => q.to_string(),
        (None, field) => field.as_ref().map(|field| field.as_str().to_owned()).unwrap_or_default(),
    }
}

struct Wrong {
    code: &'static str,
    args: Vec<(&'static str, String)>,
}

impl Wrong {
    const fn new(code: &'static str) -> Self {
        Self { code, args: Vec::new() }
    }
}

/// A number as messages show it.
fn shown(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn one(
    figure: &Figure,
    dimension: &Dimension,
    [value, from, to, centre]: &[Option<Value>; 4],
    shot: &Shot,
) -> Result<Measured, Wrong> {
    let kind = dimension.kind.unwrap_or(DimensionKind::Length);
    let no_value = || Wrong::new("figure-no-value");
    let to = spot(to).ok_or_else(no_value)?;
    let from = match (spot(from), to) {
        (Some(from), _) => from,
        (None, _) if dimension.from.is_some() => return Err(no_value()),
        (None, Spot::Coordinate(_)) => Spot::Coordinate(0.0),
        (None, Spot::Point(_)) => Spot::Point(DVec3::ZERO),
    };
    let centre = match centre {
        Some(Value::Point(centre)) => *centre,
        _ if kind == DimensionKind::Angle => return Err(Wrong::new("figure-no-centre")),
        _ => DVec3::ZERO,
    };
    let visible = axes(figure.view);
    let axis = match (from, to) {
        (Spot::Coordinate(_), Spot::Coordinate(_)) if !is_angle(kind) => Some(dimension.along.unwrap_or(visible[1])),
        _ => dimension.along,
    };
    if figure.view != FigureView::ThreeD && axis.is_some_and(|axis| !visible.contains(&axis)) {
        return Err(Wrong::new("figure-axis-not-visible"));
    }
    let [from, to] = [from, to].map(|spot| seen(spot, axis, figure));
    // Where radii are drawn, a diameter is twice as long.
    let is_diameter = figure.view == FigureView::Turned && kind == DimensionKind::Diameter;
    let wanted = match value {
        Some(Value::Number(number)) => *number,
        Some(Value::Point(point)) => along(*point, axis.ok_or_else(no_value)?),
        _ => return Err(no_value()),
    };
    let signed = match (from, to, axis) {
        (Spot::Coordinate(a), Spot::Coordinate(b), _) if kind == DimensionKind::Turn => {
            let rotary = rotary::axis(figure.view).zip(shot.rotary.as_ref());
            let turned = match axis.filter(|_| figure.view == FigureView::ThreeD) {
                // What is drawn is what the plane is turned by.
                Some(axis) => axonometric::tilt(shot, axis).filter(|tilt| (b - a - tilt).abs() <= NEAR),
                None => rotary.and_then(|(axis, rotary)| rotary.between(axis, a, b)),
            };
            turned.ok_or_else(|| Wrong {
                code: "figure-place-not-reached",
                args: vec![("place", format!("{} {}", shown(a), shown(b)))],
            })?
        }
        (Spot::Coordinate(a), Spot::Coordinate(b), _) => b - a,
        (Spot::Point(a), Spot::Point(b), Some(axis)) => along(b, axis) - along(a, axis),
        (Spot::Point(a), Spot::Point(b), None) => (b - a).length(),
        _ => return Err(Wrong::new("figure-mixed-places")),
    };
    let signed = if is_diameter { 2.0 * signed } else { signed };
    let agrees = match kind {
        DimensionKind::Angle | DimensionKind::Turn => ((signed - wanted) / 360.0 + 0.5).rem_euclid(1.0) * 360.0 - 180.0,
        _ if wanted < 0.0 && axis.is_some() => signed - wanted,
        _ => signed.abs() - wanted.abs(),
    };
    if agrees.abs() > NEAR {
        let args = vec![("measured", shown(signed)), ("value", shown(wanted))];
        return Err(Wrong { code: "figure-measured-otherwise", args });
    }
    if wanted.abs() <= NEAR {
        return Err(Wrong::new("figure-nothing-to-see"));
    }
    let measured = Measured {
        of: name(dimension),
        plus: dimension.plus.as_ref().map(|datum| datum.as_str().to_owned()),
        reduces: dimension.reduces.map(|whole| whole.to_string()),
        field: dimension.q.is_none(),
        kind,
        along: axis,
        from,
        to,
        centre,
        from_datum: dimension.from.is_none() && !is_angle(kind),
    };
    let ends: &[Spot] = match kind {
        DimensionKind::Angle | DimensionKind::Turn => &[],
        DimensionKind::Radius => &[to],
        _ => &[from, to],
    };
    if let Some(end) = ends.iter().find(|end| !is_reached(**end, axis, shot)) {
        let place = match end {
            Spot::Coordinate(coordinate) => shown(*coordinate),
            Spot::Point(p) => format!("{} {} {}", shown(p.x), shown(p.y), shown(p.z)),
        };
        return Err(Wrong { code: "figure-place-not-reached", args: vec![("place", place)] });
    }
    Ok(measured)
}

/// Whether the run came to a place with the tool, or the workpiece or the datum is there.
fn is_reached(spot: Spot, axis: Option<Along>, shot: &Shot) -> bool {
    match (spot, axis) {
        (Spot::Coordinate(at), Some(axis)) => at.abs() <= NEAR || coordinate_is_reached(at, axis, shot),
        (Spot::Point(point), Some(axis)) if is_reached(Spot::Coordinate(along(point, axis)), Some(axis), shot) => true,
        (Spot::Point(point), _) => point_is_reached(point, shot),
        (Spot::Coordinate(_), None) => false,
    }
}

/// The coordinates of the blank that the figure gives.
fn blank_coordinates(shot: &Shot, axis: Along) -> impl Iterator<Item = f64> {
    shot.own.iter().skip(TOP).take(CORNERS[1] - CUT).flatten().filter_map(move |value| match value {
        Value::Number(number) => (axis == Along::Tool).then_some(*number),
        Value::Point(point) => Some(along(*point, axis)),
        _ => None,
    })
}

fn coordinate_is_reached(at: f64, axis: Along, shot: &Shot) -> bool {
    let near = |other: f64| (other - at).abs() <= NEAR;
    let by_stroke = |stroke: &Stroke| {
        let reach =
            if axis == Along::Tool { shot.ball.unwrap_or(0.0) } else { shot.ball.unwrap_or(stroke.tool.radius) };
        stroke.points.iter().any(|point| {
            let own = along(*point, axis);
            near(own) || near(own + reach) || near(own - reach)
        })
    };
    let middles = slice::middles(shot);
    let edge = number(shot, BAR + 3).filter(|_| axis == Along::Tool);
    shot.strokes.iter().chain(&shot.later).any(by_stroke)
        || shot.strokes.iter().flat_map(|stroke| &stroke.points).any(|p| edge.is_some_and(|edge| near(p.z + edge)))
        || shot.contacts.iter().chain(&shot.centres).chain(&shot.datum).any(|point| near(along(*point, axis)))
        || middles.iter().any(|point| near(along(*point, axis)))
        || blank_coordinates(shot, axis).any(near)
        || shot.round.as_ref().is_some_and(|round| axis != Along::Minor && near(at.signum() * round.radius))
        || shot.turned.as_ref().is_some_and(|turned| turned.has(usize::from(axis == Along::Main), at))
}

fn point_is_reached(point: DVec3, shot: &Shot) -> bool {
    let at = point.truncate();
    let by_stroke = |stroke: &Stroke| {
        let reach = shot.ball.unwrap_or(stroke.tool.radius);
        let gap = stroke.points.windows(2).map(|pair| distance(at, pair[0].truncate(), pair[1].truncate()));
        let gap = gap.fold(f64::INFINITY, f64::min);
        // A pointed tool is narrower near its tip.
        let low = stroke.points.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
        let cone = (point.z - low) * tand(stroke.tool.point / 2.0);
        gap <= ON_WAY || (gap - reach).abs() <= ON_WAY || (cone < reach && (gap - cone).abs() <= ON_WAY)
    };
    let corner = || {
        let [xs, ys] = [Along::Main, Along::Minor].map(|axis| blank_coordinates(shot, axis).collect::<Vec<_>>());
        let on = |list: &[f64], value: f64| list.iter().any(|own| (own - value).abs() <= NEAR);
        on(&xs, at.x) && on(&ys, at.y)
    };
    if let Some(turned) = &shot.turned {
        let at = DVec2::new(point.z, point.x);
        let ways = shot.strokes.iter().chain(&shot.later).flat_map(|stroke| stroke.points.windows(2));
        let flat = |p: DVec3| DVec2::new(p.z, p.x);
        let on_way = |pair: &[DVec3]| distance(at, flat(pair[0]), flat(pair[1])) <= ON_WAY;
        return turned.distance(at) <= ON_WAY || ways.into_iter().any(on_way);
    }
    at.length() <= NEAR
        || shot.strokes.iter().chain(&shot.later).any(by_stroke)
        || shot
            .contacts
            .iter()
            .chain(&shot.centres)
            .chain(&shot.datum)
            .chain(&slice::middles(shot))
            .any(|own| (own.truncate() - at).length() <= ON_WAY)
        || corner()
        || shot.is_on_part(point)
}
