//! Axes, frames, and circles through points.
//!
//! Invariant: lengths are mm, angles are degrees, and all trigonometry goes through `expr`, so the same
//! input gives the same bits on every machine. Frames are rigid: they shift and rotate, they never scale.
use glam::{DAffine3, DMat3, DVec2, DVec3};

use crate::base::expr::{atan2d, cosd, sind};

/// mm in an inch.
pub(in crate::engine) const INCH: f64 = crate::spec::MM_PER_INCH;

/// Positions that differ by less, in mm, are the same: nothing moves for that.
pub(in crate::engine) const SAME_POSITION: f64 = 1e-10;

/// A linear axis of the machine or of the workpiece.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// X
    X,
    /// Y
    Y,
    /// Z
    Z,
}

impl Axis {
    /// All axes in the order of their letters.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The axis of an upper-case letter.
    pub const fn from_letter(letter: char) -> Option<Self> {
        match letter {
            'X' => Some(Self::X),
            'Y' => Some(Self::Y),
            'Z' => Some(Self::Z),
            _ => None,
        }
    }

    /// The upper-case letter.
    pub const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
            Self::Z => 'Z',
        }
    }

    /// The unit vector of the axis.
    pub const fn unit(self) -> DVec3 {
        match self {
            Self::X => DVec3::X,
            Self::Y => DVec3::Y,
            Self::Z => DVec3::Z,
        }
    }

    /// The component of a vector along the axis.
    pub const fn of(self, v: DVec3) -> f64 {
        match self {
            Self::X => v.x,
            Self::Y => v.y,
            Self::Z => v.z,
        }
    }

    /// The vector with the component along the axis replaced.
    pub const fn with(self, v: DVec3, value: f64) -> DVec3 {
        match self {
            Self::X => DVec3::new(value, v.y, v.z),
            Self::Y => DVec3::new(v.x, value, v.z),
            Self::Z => DVec3::new(v.x, v.y, value),
        }
    }
}

/// A rotary axis: A turns about a parallel of X, B of Y, C of Z.
/// Positions of rotary axes are kept as vectors, in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RotaryAxis(
    /// The linear axis that it turns about.
    pub Axis,
);

impl RotaryAxis {
    /// All rotary axes in the order of their letters.
    pub const ALL: [Self; 3] = [Self(Axis::X), Self(Axis::Y), Self(Axis::Z)];

    /// The axis of an upper-case letter.
    pub const fn from_letter(letter: char) -> Option<Self> {
        match letter {
            'A' => Some(Self(Axis::X)),
            'B' => Some(Self(Axis::Y)),
            'C' => Some(Self(Axis::Z)),
            _ => None,
        }
    }

    /// The upper-case letter.
    pub const fn letter(self) -> char {
        match self.0 {
            Axis::X => 'A',
            Axis::Y => 'B',
            Axis::Z => 'C',
        }
    }

    /// The angle of the axis among those of all.
    pub const fn of(self, angles: DVec3) -> f64 {
        self.0.of(angles)
    }

    /// The angles with the one of the axis replaced.
    pub const fn with(self, angles: DVec3, value: f64) -> DVec3 {
        self.0.with(angles, value)
    }
}

/// The tip of a tool across a rotary axis of the table: what cylinder coordinates are to the workpiece.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Around {
    /// The coordinate of the rotary axis in the program, degrees.
    pub turn: f64,
    /// How far the tool is beside the rotary axis, mm; positive in the direction in which a growing coordinate takes the
    /// tool over the workpiece.
    pub across: f64,
    /// The position along the rotary axis, mm from the datum; positive as the letter of the axis counts.
    pub along: f64,
    /// The distance from the rotary axis in the direction of the tool, mm.
    pub height: f64,
}

/// The working plane that belongs to a tool axis: main and secondary axis turn right-handed about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkingPlane {
    /// The main axis (abscissa).
    pub main: Axis,
    /// The secondary axis (ordinate).
    pub secondary: Axis,
    /// The tool axis.
    pub tool: Axis,
}

impl WorkingPlane {
    /// Z: X, Y; Y: Z, X; X: Y, Z.
    pub const fn of_tool_axis(tool: Axis) -> Self {
        let (main, secondary) = match tool {
            Axis::X => (Axis::Y, Axis::Z),
            Axis::Y => (Axis::Z, Axis::X),
            Axis::Z => (Axis::X, Axis::Y),
        };
        Self { main, secondary, tool }
    }

    /// The components of a point in the plane: (main, secondary).
    pub const fn flat(self, point: DVec3) -> DVec2 {
        DVec2::new(self.main.of(point), self.secondary.of(point))
    }

    /// The point with these plane components at a height along the tool axis.
    pub fn lift(self, flat: DVec2, height: f64) -> DVec3 {
        self.main.unit() * flat.x + self.secondary.unit() * flat.y + self.tool.unit() * height
    }
}

/// A quarter turn to the left.
pub const fn left_of(direction: DVec2) -> DVec2 {
    DVec2::new(-direction.y, direction.x)
}

/// A transform: first rotate (mirror, scale), then shift. It maps coordinates of the inner system to the outer one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame(DAffine3);

/// A main axis is upright if the level part of its direction is smaller.
const UPRIGHT: f64 = 1e-9;

impl Frame {
    /// The system itself.
    pub const IDENTITY: Self = Self(DAffine3::IDENTITY);

    /// The inner system has its datum at `by`.
    pub fn shift(by: DVec3) -> Self {
        Self(DAffine3::from_translation(by))
    }

    /// The inner system is turned about an axis through the datum, counter-clockwise seen against the axis.
    pub fn rotate(axis: Axis, degrees: f64) -> Self {
        let (s, c) = (sind(degrees), cosd(degrees));
        let columns = match axis {
            Axis::X => [DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c)],
            Axis::Y => [DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c)],
            Axis::Z => [DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z],
        };
        let [x, y, z] = columns;
        Self(DAffine3::from_mat3(DMat3::from_cols(x, y, z)))
    }

    /// Turned about the fixed X axis, then the fixed Y axis, then the fixed Z axis (degrees), then shifted.
    pub fn placed(shift: DVec3, rotate: DVec3) -> Self {
        Self::shift(shift)
            .of(Self::rotate(Axis::Z, rotate.z))
            .of(Self::rotate(Axis::Y, rotate.y))
            .of(Self::rotate(Axis::X, rotate.x))
    }

    /// A right-handed system at the same datum with this main and tool axis of a working plane, perpendicular to each
    /// other and of length 1.
    pub fn with_axes(plane: WorkingPlane, main: DVec3, tool: DVec3) -> Self {
        let turned = [(plane.main, main), (plane.secondary, tool.cross(main)), (plane.tool, tool)];
        let column =
            |wanted: Axis| turned.iter().find(|(axis, _)| *axis == wanted).map_or(DVec3::ZERO, |(_, column)| *column);
        Self(DAffine3::from_mat3(DMat3::from_cols(column(Axis::X), column(Axis::Y), column(Axis::Z))))
    }

    /// The angles in degrees about the fixed X axis, then the fixed Y axis, then the fixed Z axis that turn to a system
    /// without other units: what [`placed`](Self::placed) takes. Where only the sum or the difference of the first and
    /// the last one matters the last one is 0.
    pub fn spatial_angles(&self) -> DVec3 {
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = self.0.matrix3;
        let level = libm::hypot(x.x, x.y);
        let b = atan2d(-x.z, level);
        if level <= UPRIGHT {
            return DVec3::new(atan2d(-z.y, y.y), b, 0.0);
        }
        DVec3::new(atan2d(y.z, z.z), b, atan2d(x.y, x.x))
    }

    /// A system inside this one: `outer.of(inner)` maps coordinates of `inner` to those outside `outer`.
    pub fn of(self, inner: Self) -> Self {
        Self(self.0 * inner.0)
    }

    /// Where a point of the inner system lies in the outer one.
    pub fn point(&self, inner: DVec3) -> DVec3 {
        self.0.transform_point3(inner)
    }

    /// The direction of the inner system as seen in the outer one.
    pub fn vector(&self, inner: DVec3) -> DVec3 {
        self.0.transform_vector3(inner)
    }

    /// The inner system has other units on its axes, negative ones point the other way, about a point that stays.
    pub fn scaled(factors: DVec3, about: DVec3) -> Self {
        Self(DAffine3::from_mat3_translation(DMat3::from_diagonal(factors), about - factors * about))
    }

    /// Whether it neither scales nor distorts.
    pub fn is_rigid(&self) -> bool {
        let product = self.0.matrix3.transpose() * self.0.matrix3;
        product.abs_diff_eq(DMat3::IDENTITY, 1e-12)
    }

    /// Whether it makes a left-handed system of a right-handed one.
    pub fn mirrors(&self) -> bool {
        self.0.matrix3.determinant() < 0.0
    }

    /// What it does, row by row: the last number of a row is the shift.
    pub fn rows(&self) -> [[f64; 4]; 3] {
        let DAffine3 { matrix3: m, translation: t } = self.0;
        [
            [m.x_axis.x, m.y_axis.x, m.z_axis.x, t.x],
            [m.x_axis.y, m.y_axis.y, m.z_axis.y, t.y],
            [m.x_axis.z, m.y_axis.z, m.z_axis.z, t.z],
        ]
    }

    /// The transform of such rows.
    pub fn of_rows(rows: [[f64; 4]; 3]) -> Self {
        let [x, y, z] = rows;
        Self(DAffine3::from_cols(
            DVec3::new(x[0], y[0], z[0]),
            DVec3::new(x[1], y[1], z[1]),
            DVec3::new(x[2], y[2], z[2]),
            DVec3::new(x[3], y[3], z[3]),
        ))
    }

    /// The way back. Of a rigid transform the transpose is the inverse to the last bit.
    pub fn inverse(&self) -> Self {
        let back = if self.is_rigid() { self.0.matrix3.transpose() } else { self.0.matrix3.inverse() };
        Self(DAffine3::from_mat3_translation(back, -(back * self.0.translation)))
    }
}

/// A circle in the working plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre in mm.
    pub centre: DVec2,
    /// Radius in mm.
    pub radius: f64,
}

/// Why no circle fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitError {
    /// Fewer than three points.
    TooFew,
    /// All points on one line, or two of three coincide.
    Collinear,
    /// A coordinate is not a finite number.
    NotFinite,
    /// The iteration found no minimum: the points are no circle.
    NoConvergence,
}

/// Points count as collinear when their deviation from a line is below this share of their extent.
const COLLINEAR: f64 = 1e-12;
/// A fit is near its minimum when a step is below this share of the extent of the points: the sum of squares
/// is too flat there to choose by, and the gradient decides.
pub(super) const NEAR_MINIMUM: f64 = 1e-5;
/// A fit that has not come near its minimum by then will not.
pub(super) const MAX_STEPS: usize = 512;
/// Newton doubles the digits with each step; more steps only repeat the rounding.
pub(super) const NEWTON_STEPS: usize = 8;

/// The circle with the least sum of squared distances from the points (geometric fit): Levenberg's damped
/// Gauss-Newton iteration, started from the algebraic fit of Kåsa and finished by Newton's method.
///
/// # Errors
/// Too few points, points on a line, or no minimum; see [`FitError`].
pub fn fit_circle(points: &[DVec2]) -> Result<Circle, FitError> {
    if points.len() < 3 {
        return Err(FitError::TooFew);
    }
    if !points.iter().all(|p| p.is_finite()) {
        return Err(FitError::NotFinite);
    }
    let mean = points.iter().sum::<DVec2>() / points.len() as f64;
    let scale = points.iter().map(|p| (p - mean).length()).fold(0.0, f64::max);
    if scale == 0.0 {
        return Err(FitError::Collinear);
    }
    let local: Vec<DVec2> = points.iter().map(|p| (p - mean) / scale).collect();
    let unit = refine(kasa(&local)?, &local)?;
    Ok(Circle { centre: mean + unit.centre * scale, radius: unit.radius * scale })
}

/// The algebraic fit of points whose mean is the origin: linear in centre and radius squared.
fn kasa(points: &[DVec2]) -> Result<Circle, FitError> {
    let (mut xx, mut xy, mut yy, mut right, mut square) = (0.0, 0.0, 0.0, DVec2::ZERO, 0.0);
    for p in points {
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
        right += *p * p.length_squared();
        square += p.length_squared();
    }
    let det = xx * yy - xy * xy;
    if det <= COLLINEAR * (xx + yy) * (xx + yy) {
        return Err(FitError::Collinear);
    }
    let centre = DVec2::new(yy * right.x - xy * right.y, xx * right.y - xy * right.x) / (2.0 * det);
    let radius = libm::sqrt(square / points.len() as f64 + centre.length_squared());
    Ok(Circle { centre, radius })
}

/// Sum of squared distances from the circle.
fn cost(circle: Circle, points: &[DVec2]) -> f64 {
    points
        .iter()
        .map(|p| {
            let gap = (p - circle.centre).length() - circle.radius;
            gap * gap
        })
        .sum()
}

/// Damped Gauss-Newton until the minimum is near, then Newton.
fn refine(start: Circle, points: &[DVec2]) -> Result<Circle, FitError> {
    let (mut best, mut best_cost, mut damping) = (start, cost(start, points), 0.0);
    for _ in 0..MAX_STEPS {
        let step = gauss_newton_step(best, points, damping).ok_or(FitError::NoConvergence)?;
        if step.length() <= NEAR_MINIMUM * (1.0 + best.radius) {
            return newton(best, points).ok_or(FitError::NoConvergence);
        }
        let next = moved(best, step);
        let next_cost = cost(next, points);
        if next_cost <= best_cost {
            (best, best_cost) = (next, next_cost);
            damping = if damping < 1e-8 { 0.0 } else { damping / 10.0 };
        } else {
            damping = if damping == 0.0 { 1e-4 } else { damping * 10.0 };
        }
    }
    Err(FitError::NoConvergence)
}

fn moved(circle: Circle, step: DVec3) -> Circle {
    Circle { centre: circle.centre + DVec2::new(step.x, step.y), radius: circle.radius + step.z }
}

/// Newton's method on the gradient; nothing where the sum of squares does not curve upwards.
fn newton(start: Circle, points: &[DVec2]) -> Option<Circle> {
    let mut circle = start;
    for _ in 0..NEWTON_STEPS {
        let (mut hessian, mut gradient) = (DMat3::ZERO, DVec3::ZERO);
        for p in points {
            let away = p - circle.centre;
            let distance = away.length();
            let (n, gap) = (away / distance, distance - circle.radius);
            let row = DVec3::new(n.x, n.y, 1.0);
            let side = DVec3::new(-n.y, n.x, 0.0);
            // The distance itself curves across the normal, by one over the distance.
            let bend = side * (gap / distance);
            hessian += outer(row, row) + outer(bend, side);
            gradient -= row * gap;
        }
        let step = hessian.inverse() * gradient;
        let minimum = hessian.determinant() > 0.0 && step.is_finite() && step.dot(hessian * step) >= 0.0;
        if !minimum {
            return None;
        }
        circle = moved(circle, -step);
    }
    Some(circle)
}

fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

fn gauss_newton_step(circle: Circle, points: &[DVec2], damping: f64) -> Option<DVec3> {
    let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for p in points {
        let away = p - circle.centre;
        let distance = away.length();
        if distance == 0.0 {
            return None;
        }
        let row = DVec3::new(away.x / distance, away.y / distance, 1.0);
        normal += outer(row, row);
        right += row * (distance - circle.radius);
    }
    let damped = normal + DMat3::from_diagonal(DVec3::splat(damping * points.len() as f64));
    let step = damped.inverse() * right;
    step.is_finite().then_some(step)
}
