//! Strategies that mill around a stud at one level, from the blank to the stud.
//!
//! Invariant: the stud with its allowance is never crossed; the laps have equal distances, none greater than asked for.
use glam::DVec2;

use super::clear::MAX_OUTLINES;
use crate::base::expr::atan2d;
use crate::engine::contour::outline::{Outline, Place, Tangent, left_of};
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// What calculation may add to a whole number of laps.
const SPARE: f64 = 1e-9;
/// How far next to the blank the tool begins, mm.
const BESIDE: f64 = 2.0;

/// A rectangular stud with its blank.
struct Stud {
    place: Place,
    /// Half the sides of the path along the stud.
    half: DVec2,
    /// The radius of the path about the corners.
    corner: f64,
    /// Half the sides of the blank.
    blank: DVec2,
    tool_radius: f64,
    /// The distance of the laps, and how many there are.
    step: f64,
    laps: u32,
    direction: f64,
    feed: f64,
}

impl Stud {
    /// How far a lap lies outside of the last one.
    fn outside(&self, lap: u32) -> f64 {
        f64::from(self.laps - lap) * self.step
    }

    fn outline(&self, lap: u32) -> Outline {
        let outside = self.outside(lap);
        Outline::rectangle(self.half + DVec2::splat(outside), self.corner + outside).towards(self.direction)
    }
}

impl<'e> Run<'_, 'e> {
    pub(super) fn mill_rectangular_stud_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let (stud, approach) = self.stud(call, exec)?;
        match approach {
            1.0 => self.stud_from_corner(&stud, DVec2::new(-1.0, -1.0)),
            2.0 => self.stud_from_corner(&stud, DVec2::new(1.0, -1.0)),
            3.0 => self.stud_from_corner(&stud, DVec2::new(1.0, 1.0)),
            4.0 => self.stud_from_corner(&stud, DVec2::new(-1.0, 1.0)),
            _ => self.stud_from_right(&stud),
        }
    }

    fn stud(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<(Stud, f64), Fault> {
        let centre = self.point_given(call, 0, exec)?;
        let [climb, length, width, corner, rotation, stepover] = self.all_given(call, 1, exec)?;
        let [allowance, blank_length, blank_width, approach] = self.all_given(call, 7, exec)?;
        let tool_radius = self.tool_radius();
        if 2.0 * corner > length.min(width) + SPARE {
            return Err(self.drives.shape_impossible(2.0 * corner, length.min(width)));
        }
        let (size, blank) = (DVec2::new(length, width) / 2.0, DVec2::new(blank_length, blank_width) / 2.0);
        let corner = corner + allowance;
        let over = (blank - size - DVec2::splat(allowance)).max(DVec2::ZERO);
        let room = over.max_element();
        let least = libm::ceil(room / stepover - SPARE).max(1.0);
        let step = room / least;
        // The corners of the blank lie farther out than its sides: laps outside of them reach these.
        let arm = over + DVec2::splat(corner);
        let beyond = libm::hypot(arm.x, arm.y) - corner - 2.0 * tool_radius;
        let more = if step > 0.0 { libm::ceil(beyond / step - SPARE) } else { 0.0 };
        let laps = least.max(more + 1.0);
        if laps.is_nan() || laps > MAX_OUTLINES {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_OUTLINES));
        }
        let stud = Stud {
            place: Place::new(centre, rotation),
            half: size + DVec2::splat(allowance + tool_radius),
            corner: corner + tool_radius,
            blank,
            tool_radius,
            step,
            laps: laps as u32,
            direction: if climb < 0.0 { 1.0 } else { -1.0 },
            feed: self.feed_given(call, exec)?,
        };
        Ok((stud, approach))
    }

    /// From the right of the blank on a quarter circle to the first lap, lap by lap, and away on a quarter circle.
    fn stud_from_right(&mut self, stud: &Stud) -> Done {
        let Stud { place, feed, .. } = stud;
        let beside = stud.blank.x + BESIDE + stud.tool_radius;
        let tangent = |outline: &Outline| {
            let room = beside - outline.start.x;
            Tangent::at(outline, if room > SPARE { room } else { BESIDE }, -stud.direction)
        };
        for lap in 1..=stud.laps {
            let outline = stud.outline(lap);
            if lap == 1 {
                self.drives.mill_join(place, &tangent(&outline), &outline, *feed)?;
            } else {
                self.drives.mill_to(place, outline.start, *feed)?;
            }
            self.drives.mill_outline(place, &outline, *feed)?;
            if lap == stud.laps {
                self.drives.mill_leave(place, &tangent(&outline), *feed)?;
            }
        }
        Ok(())
    }

    /// From a corner along the first side of the first lap, lap by lap inwards, and away on a quarter circle.
    fn stud_from_corner(&mut self, stud: &Stud, corner: DVec2) -> Done {
        let Stud { place, feed, direction, .. } = stud;
        // Along the first side, and from it towards the stud.
        let first =
            if corner.x * corner.y * direction < 0.0 { DVec2::new(0.0, -corner.y) } else { DVec2::new(-corner.x, 0.0) };
        let inwards = left_of(first) * *direction;
        let point = |x: f64, y: f64| first * x + inwards * y;
        let along = |half: DVec2| DVec2::new((half * first).abs().element_sum(), (half * inwards).abs().element_sum());
        let height = self.drives.in_plane(self.drives.world.here).z;
        let begin = along(stud.blank).x + BESIDE + stud.tool_radius;
        for lap in 1..=stud.laps {
            let outside = stud.outside(lap);
            let (half, c) = (along(stud.half) + DVec2::splat(outside), stud.corner + outside);
            let (a, b) = (half.x, half.y);
            if lap == 1 {
                self.drives.mill_to(place, point(-begin, -b), *feed)?;
            }
            let around = |run: &mut Self, x: f64, y: f64, to: DVec2| {
                run.drives.mill_around(place, (point(x, y), to), height, *direction, *feed)
            };
            self.drives.mill_to(place, point(a - c, -b), *feed)?;
            around(self, a - c, c - b, point(a, c - b))?;
            self.drives.mill_to(place, point(a, b - c), *feed)?;
            around(self, a - c, b - c, point(a - c, b))?;
            self.drives.mill_to(place, point(c - a, b), *feed)?;
            around(self, c - a, b - c, point(-a, b - c))?;
            self.drives.mill_to(place, point(-a, c - b), *feed)?;
            around(self, c - a, c - b, point(c - a, -b))?;
            if lap < stud.laps {
                self.drives.mill_to(place, point(c - a, stud.step - b), *feed)?;
            } else {
                let (centre, to) = (point(c - a, -b - BESIDE), point(c - a + BESIDE, -b - BESIDE));
                self.drives.mill_around(place, (centre, to), height, -direction, *feed)?;
            }
        }
        Ok(())
    }

    /// From where the tool is on a spiral of half circles to the stud, and once around it.
    pub(super) fn mill_circular_stud_level(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [climb, diameter, stepover] = self.all_given(call, 1, exec)?;
        let (place, from) = self.polar_place(call, exec)?;
        let feed = self.feed_given(call, exec)?;
        let to = diameter / 2.0 + self.tool_radius();
        let direction = if climb < 0.0 { 1.0 } else { -1.0 };
        let halves = libm::ceil(2.0 * (from - to).abs() / stepover - SPARE).max(1.0);
        if halves.is_nan() || halves > 2.0 * MAX_OUTLINES {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_OUTLINES).into());
        }
        let halves = halves as u32;
        let at = |half: u32| {
            let share = f64::from(half) / f64::from(halves);
            let distance = if half == halves { to } else { from + (to - from) * share };
            DVec2::new(if half.is_multiple_of(2) { distance } else { -distance }, 0.0)
        };
        let height = self.drives.in_plane(self.drives.world.here).z;
        for half in 1..=halves {
            let (now, next) = (at(half - 1), at(half));
            self.drives.mill_around(&place, ((now + next) / 2.0, next), height, direction, feed)?;
        }
        self.drives.mill_around(&place, (DVec2::ZERO, at(halves)), height, direction, feed)
    }

    /// Half a turn to the other side of the centre, to a point at that distance from it.
    pub(super) fn half_turn(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [direction, radius] = self.all_given(call, 1, exec)?;
        let (place, from) = self.polar_place(call, exec)?;
        let feed = self.feed_given(call, exec)?;
        let (now, next) = (DVec2::new(from, 0.0), DVec2::new(-radius, 0.0));
        let height = self.drives.in_plane(self.drives.world.here).z;
        let direction = if direction < 0.0 { -1.0 } else { 1.0 };
        self.drives.mill_around(&place, ((now + next) / 2.0, next), height, direction, feed)
    }

    /// The centre that is given, with the first axis towards the tool, and how far the tool is from it.
    fn polar_place(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<(Place, f64), Fault> {
        let centre = self.point_given(call, 0, exec)?;
        let arm = (self.drives.in_plane(self.drives.world.here) - centre).truncate();
        let distance = libm::hypot(arm.x, arm.y);
        if distance == 0.0 {
            return Err(self.drives.shape_impossible(self.tool_radius(), distance));
        }
        Ok((Place::new(centre, atan2d(arm.y, arm.x)), distance))
    }
}
