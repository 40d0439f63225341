//! How a stylus follows a part: in a vertical plane over it, along a rotary axis, and at one height around it.
//!
//! What is followed is the curve on which the south pole of the stylus goes while the ball touches the part, found point
//! by point by contacts of the ball. Points are main, minor and tool coordinate. Invariant: nothing moves here.
use glam::{DVec2, DVec3};

use super::range::{Range, SAME};
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::RotaryAxis;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::strategy::action::{Control, Course, Felt};

/// A step is looked through in so many parts for where it becomes too long.
const PARTS: u32 = 4;
/// Where a step becomes too long is looked for until it is known so exactly, mm.
const EXACT: f64 = 1e-11;
/// The search for it ends after so many steps at the latest.
const SEARCHES: usize = 120;
/// A surface that turns by more than this between two points, degrees, has an inside corner between them.
const CORNER: f64 = 10.0;
/// A notch whose walls are at a smaller angle, degrees, has no inside corner.
const NOTCH: f64 = 60.0;
/// A direction this near to another one, as a cosine, is that one.
const STEEP: f64 = 0.999;
/// A ball that is farther from a surface, mm, does not touch it.
const TOUCHES: f64 = 1e-6;
/// The least step around a part, mm.
const LEAST: f64 = 1e-3;
/// The most points of one line.
const MOST: usize = 400_000;
/// A ball is moved off a surface so far before it is felt whether its way is free, mm.
const OFF: f64 = 1e-4;
/// A line that comes back to a place of its own, but not to its first one, is gone through again so often, each time
/// with half the step.
const FINER: i32 = 6;
/// Such a place is looked for from so many points of a line.
const RETURNS: usize = 16;
/// Gaps and notches that are narrower, mm, are gone over; each time less.
const NARROW: f64 = 0.01;
/// The least step out of a notch that was gone over, mm.
const TINY: f64 = LEAST / 16.0;
/// Between two places where a surface turns by less than this, degrees, it goes on without a gap.
const SMOOTH: f64 = 20.0;
/// The way around a part at one place, degrees.
const AROUND: f64 = 355.0;

/// What is below the stylus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ground {
    /// The part.
    Part,
    /// Nothing down to the least coordinate of the range, at which it goes.
    Floor,
    /// Nothing: it is beside an overhang.
    Nothing,
}

/// A place of the stylus on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// The south pole.
    pub at: DVec3,
    /// The direction out of the material, of length 1.
    pub out: DVec3,
    /// The same in the plane in which the stylus follows the part.
    pub away: DVec3,
    /// What it touches.
    pub on: Ground,
}

/// The fault of a position beyond the range.
pub(super) fn beyond(control: &dyn Control, at: DVec3) -> Fault {
    let at = control.axes(at);
    Fault::control("digitizing-range-left").arg("x", at.x).arg("y", at.y).arg("z", at.z)
}

/// The fault of a part that the stylus cannot follow.
pub(super) fn lost(control: &dyn Control, at: DVec3) -> Fault {
    let at = control.axes(at);
    Fault::control("digitizing-contour-lost").arg("x", at.x).arg("y", at.y).arg("z", at.z)
}

/// The fault of a line that never ends.
fn too_long() -> Fault {
    Fault::new(Class::Limit, "move-limit").arg("limit", MOST)
}

/// What is felt on a straight way.
pub(super) fn feel(control: &dyn Control, from: DVec3, to: DVec3) -> Result<Option<Felt>, Fault> {
    let felt = control.feel(Course::Line { from: control.axes(from), to: control.axes(to) })?;
    Ok(felt.map(|felt| Felt { at: control.in_plane(felt.at), out: control.in_plane(felt.out) }))
}

/// A straight line of the plan, followed from above.
pub(super) struct Profile<'c> {
    pub control: &'c dyn Control,
    /// Where it begins and where it ends.
    pub from: DVec2,
    pub to: DVec2,
    /// From where the stylus comes down.
    pub top: f64,
    /// The limits of the range.
    pub floor: f64,
    pub ceiling: f64,
    /// The rotary axis that is turned along the line, if it is not straight: then `x` of places is its angle and `z`
    /// counts against the direction in which the stylus goes to the part.
    pub turned: Option<Chart>,
}

/// A line along which a rotary axis turns while the stylus stays where it is, but for the direction in which it touches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chart {
    pub axis: RotaryAxis,
    /// The place of the stylus where `z` is 0.
    pub base: DVec3,
    /// Away from the part, of length 1.
    pub up: DVec3,
    /// Whether the line goes around a part that is there at every angle.
    pub around: bool,
}

impl Chart {
    /// The place of the stylus at a height.
    pub(super) fn place(&self, height: f64) -> DVec3 {
        self.base + self.up * height
    }

    /// Where a stylus that comes from the top touches at an angle.
    fn down(&self, profile: &Profile<'_>, angle: f64) -> Result<Sample, Fault> {
        let control = profile.control;
        let [from, to] = [profile.top, profile.floor].map(|height| control.axes(self.place(height)));
        let at = |height: f64| DVec3::new(angle, 0.0, height);
        let Some(felt) = control.feel_turned((self.axis, angle), from, to)? else {
            if self.around {
                return Err(lost(control, self.place(profile.floor)));
            }
            return Ok(Sample { at: at(profile.floor), out: self.up, away: DVec3::Z, on: Ground::Floor });
        };
        let height = (control.in_plane(felt.at) - self.base).dot(self.up);
        if height > profile.ceiling + TOUCHES {
            return Err(beyond(control, control.in_plane(felt.at)));
        }
        let out = control.in_plane(felt.out);
        let lean = out.dot(control.in_plane(control.way_in_degree(self.axis, felt.at)?));
        let away = DVec3::new(lean, 0.0, out.dot(self.up)).try_normalize().unwrap_or(DVec3::Z);
        Ok(Sample { at: at(height), out, away, on: Ground::Part })
    }
}

impl Profile<'_> {
    fn along(&self) -> DVec2 {
        (self.to - self.from).normalize_or_zero()
    }

    /// Where a stylus that comes down touches at that way along the line.
    pub(super) fn down(&self, way: f64) -> Result<Sample, Fault> {
        let place = self.from + self.along() * way;
        if let Some(chart) = &self.turned {
            return chart.down(self, place.x);
        }
        match feel(self.control, place.extend(self.top), place.extend(self.floor))? {
            None => Ok(Sample { at: place.extend(self.floor), out: DVec3::Z, away: DVec3::Z, on: Ground::Floor }),
            Some(felt) if felt.at.z > self.ceiling + TOUCHES => Err(beyond(self.control, felt.at)),
            Some(felt) => {
                let along = self.along();
                let lean = along.dot(felt.out.truncate());
                let away = (along * lean).extend(felt.out.z).try_normalize().unwrap_or(DVec3::Z);
                Ok(Sample { at: place.extend(felt.at.z), out: felt.out, away, on: Ground::Part })
            }
        }
    }

    /// All places from the start of the line to its end, at most that far from each other where the part is touched.
    pub(super) fn trace(&self, spacing: f64) -> Result<Vec<Sample>, Fault> {
        let length = (self.to - self.from).length();
        let mut all = vec![self.down(0.0)?];
        let mut way = 0.0;
        while length - way > SAME {
            let Some(now) = all.last().copied() else { break };
            match self.step(way, &now, length, spacing)? {
                Step::To(next, sample) => {
                    let corner = self.inside_corner((&now, way), (&sample, next), spacing)?;
                    let (next, sample) = corner.unwrap_or((next, sample));
                    all.push(sample);
                    way = next;
                }
                Step::Wall(next, end) => {
                    self.climb(&now, &end, spacing, &mut all)?;
                    all.push(end);
                    way = next;
                }
            }
            if all.len() > MOST {
                return Err(too_long());
            }
        }
        Ok(all)
    }

    /// The next place: as far as the spacing lets it, or what is at the other end of a wall.
    fn step(&self, way: f64, now: &Sample, length: f64, spacing: f64) -> Result<Step, Fault> {
        let excess = |way_there: f64, there: &Sample| libm::hypot(way_there - way, there.at.z - now.at.z) - spacing;
        let mut low = (way, *now, -spacing);
        let mut high = None;
        for part in 1..=PARTS {
            let there = (way + spacing * f64::from(part) / f64::from(PARTS)).min(length);
            let sample = self.down(there)?;
            let over = excess(there, &sample);
            if over > SAME {
                high = Some((there, sample, over));
                break;
            }
            low = (there, sample, over);
            if there >= length {
                break;
            }
        }
        let Some(mut high) = high else { return Ok(Step::To(low.0, low.1)) };
        for search in 0..SEARCHES {
            if high.0 - low.0 <= EXACT || low.2 > -SAME {
                break;
            }
            let share = if search % 3 == 2 { 0.5 } else { (-low.2 / (high.2 - low.2)).clamp(0.01, 0.99) };
            let middle = low.0 + (high.0 - low.0) * share;
            let sample = self.down(middle)?;
            let over = excess(middle, &sample);
            if over > 0.0 { high = (middle, sample, over) } else { low = (middle, sample, over) }
        }
        let rise = if high.0 - low.0 <= EXACT { high.1.at.z - low.1.at.z } else { 0.0 };
        if low.0 - way > SAME {
            Ok(Step::To(low.0, if rise > TOUCHES { self.at_foot(low.1, -self.along())? } else { low.1 }))
        } else {
            Ok(Step::Wall(high.0, if rise < -TOUCHES { self.at_foot(high.1, self.along())? } else { high.1 }))
        }
    }

    /// A place at the foot of a wall from which that direction leads away: it is left, and touched, at an angle.
    fn at_foot(&self, sample: Sample, away: DVec2) -> Result<Sample, Fault> {
        let off = away.extend(0.0) * TOUCHES;
        // What turns is touched in one direction only.
        if self.turned.is_some() || feel(self.control, sample.at + off, sample.at - off)?.is_none() {
            return Ok(sample);
        }
        let beside = away.extend(0.0);
        // What is felt from above may be the wall itself.
        let below = if sample.away.dot(beside) > STEEP { DVec3::Z } else { sample.away };
        let away = (beside + below).try_normalize().unwrap_or(below);
        Ok(Sample { away, out: away, on: Ground::Part, ..sample })
    }

    /// The places along a wall between its ends.
    fn climb(&self, from: &Sample, to: &Sample, spacing: f64, all: &mut Vec<Sample>) -> Result<(), Fault> {
        if self.turned.is_some() {
            return Ok(());
        }
        let rise = to.at.z - from.at.z;
        // The ball is on the side of the wall that is lower.
        let (place, away) = if rise > 0.0 { (from.at, -self.along()) } else { (to.at, self.along()) };
        let away = away.extend(0.0);
        for count in 1..MOST {
            let way = spacing * count as f64;
            if rise.abs() - way <= SAME {
                return Ok(());
            }
            let at = place.truncate().extend(from.at.z + way * rise.signum());
            let touches = self.control.touches(self.control.axes(at), TOUCHES)?;
            let on = if touches { Ground::Part } else { Ground::Nothing };
            all.push(Sample { at, out: away, away, on });
        }
        Err(too_long())
    }

    /// The place in an inside corner between two others, and where along the line it is.
    fn inside_corner(
        &self,
        (a, from): (&Sample, f64),
        (b, to): (&Sample, f64),
        spacing: f64,
    ) -> Result<Option<(f64, Sample)>, Fault> {
        let along = self.along();
        let flat = |sample: &Sample| DVec2::new(along.dot(sample.away.truncate()), sample.away.z);
        let (first, second) = (flat(a), flat(b));
        if a.on == Ground::Nothing || b.on == Ground::Nothing || first.perp_dot(second) < sind(CORNER) {
            return Ok(None);
        }
        // Where the surface has turned by half: in the corner, if there is one.
        let (mut low, mut high) = ((from, *a), (to, *b));
        while high.0 - low.0 > EXACT.max(high.0.abs() * f64::EPSILON * 4.0) {
            let middle = low.0.midpoint(high.0);
            let sample = self.down(middle)?;
            if flat(&sample).dot(second) > flat(&sample).dot(first) {
                high = (middle, sample);
            } else {
                low = (middle, sample);
            }
        }
        // At the foot of a wall, not on it.
        let (way, mut corner) = if low.1.at.z < high.1.at.z { low } else { high };
        let far = |other: &Sample| (corner.at - other.at).length();
        if far(a).min(far(b)) <= TOUCHES || far(a) > spacing || way - from <= SAME || to - way <= SAME {
            return Ok(None);
        }
        corner.away = (a.away + b.away).try_normalize().unwrap_or(corner.away);
        // Beside an overhang nothing is touched at the foot.
        let touches = || self.control.touches(self.control.axes(corner.at), TOUCHES);
        if corner.on == Ground::Floor && (self.turned.is_some() || touches()?) {
            corner.on = Ground::Part;
        }
        Ok(Some((way, corner)))
    }
}

/// What comes next on a line.
enum Step {
    /// A place, that way along the line.
    To(f64, Sample),
    /// The other end of a wall, that way along the line.
    Wall(f64, Sample),
}

/// Where two lines meet, given by a point and the normal of each.
fn meeting(a: DVec2, out_of_a: DVec2, b: DVec2, out_of_b: DVec2) -> Option<DVec2> {
    let cross = out_of_a.perp_dot(out_of_b);
    let along = DVec2::new(out_of_a.y, -out_of_a.x);
    let way = (b - a).dot(out_of_b) / along.dot(out_of_b);
    (cross.abs() > SAME && way.is_finite()).then(|| a + along * way)
}

/// How a line around a part has ended.
enum Line {
    /// At its first place.
    Closed(Vec<Sample>),
    /// There, at a place where it has been before, without the first one.
    Missed(DVec3),
}

/// A part that is followed around at one height.
pub(super) struct Level<'c> {
    pub control: &'c dyn Control,
    pub range: &'c Range,
    /// Whether the material is on the right of the way of the stylus.
    pub clockwise: bool,
    /// A place that is so near to the first one is there, mm.
    pub accuracy: f64,
}

impl Level<'_> {
    fn sign(&self) -> f64 {
        if self.clockwise { -1.0 } else { 1.0 }
    }

    /// A place where the stylus touches the part at this height; nothing where it touches it from above only.
    pub(super) fn sample(felt: &Felt) -> Option<Sample> {
        let away = felt.out.truncate().try_normalize()?.extend(0.0);
        Some(Sample { at: felt.at, out: felt.out, away, on: Ground::Part })
    }

    /// The next place at that distance.
    fn next(&self, now: &Sample, spacing: f64) -> Result<Option<Sample>, Fault> {
        let control = self.control;
        let start = now.at + now.away * spacing;
        let free = !control.touches(control.axes(start), 0.0)?
            && feel(control, now.at + now.away * OFF.min(spacing / 2.0), start)?.is_none();
        if !free {
            return Ok(None);
        }
        let (from, centre) = (control.axes(start), control.axes(now.at));
        let felt = control.feel(Course::Arc { centre, from, sweep: self.sign() * AROUND })?;
        Ok(felt.and_then(|felt| Self::sample(&Felt { at: control.in_plane(felt.at), out: control.in_plane(felt.out) })))
    }

    /// All places from the first one around the part and back to it, at most that far from each other.
    pub(super) fn trace(&self, first: Sample, spacing: f64) -> Result<Vec<Sample>, Fault> {
        // With a finer step the stylus follows what it went past.
        let (mut step, mut narrow) = (spacing, NARROW);
        for finer in 0.. {
            match self.trace_once(first, step, narrow)? {
                Line::Closed(all) => return Ok(all),
                Line::Missed(at) if finer == FINER => return Err(lost(self.control, at)),
                Line::Missed(_) => (step, narrow) = ((step / 2.0).max(LEAST), (narrow / 2.0).max(LEAST)),
            }
        }
        Err(too_long())
    }

    /// The same with that step, over gaps that are so narrow.
    fn trace_once(&self, first: Sample, spacing: f64, narrow: f64) -> Result<Line, Fault> {
        let mut all = vec![first];
        let (mut has_left, mut has_crossed) = (false, false);
        // A place to which the stylus may return instead of the first one, farther on whenever the way has doubled.
        let mut known = 0;
        while all.len() < MOST {
            let Some(now) = all.last().copied() else { break };
            let back = (now.at - first.at).length();
            if has_left && back <= self.accuracy {
                return Ok(Line::Closed(all));
            }
            has_left |= back > self.accuracy.max(spacing);
            let near = all.len() > 2 && back <= spacing + SAME;
            if near && self.is_next(&now, &first, back)? {
                all.extend(self.inside_corner(&now, &first, spacing)?);
                all.push(first);
                return Ok(Line::Closed(all));
            }
            if self.has_returned(&all, known, spacing)? {
                return Ok(Line::Missed(now.at));
            }
            if all.len() >= 2 * known.max(RETURNS) {
                known = all.len() - 1;
            }
            // Not past the first place.
            let step = if near && has_left { spacing.min(back / 2.0) } else { spacing };
            let (next, crossed) = self.follow(&now, step, narrow, has_crossed)?;
            has_crossed = crossed;
            let axes = self.control.axes(next.at);
            if (self.range.least - axes).max_element() > SAME || (axes - self.range.greatest).max_element() > SAME {
                return Err(beyond(self.control, next.at));
            }
            all.push(self.inside_corner(&now, &next, spacing)?.unwrap_or(next));
        }
        Err(too_long())
    }

    /// Whether a place before the last ones, not the first, comes next again.
    fn has_returned(&self, all: &[Sample], known: usize, spacing: f64) -> Result<bool, Fault> {
        let (Some(now), Some(place)) = (all.last(), all.get(known)) else { return Ok(false) };
        let distance = (now.at - place.at).length();
        if known == 0 || known + 3 > all.len() || distance > spacing {
            return Ok(false);
        }
        self.is_next(now, place, distance)
    }

    /// The next place at that distance, or nearer where there is another wall before it is reached along this one; on the
    /// other side of a narrow notch where the ball has no room for a step. With `has_crossed` it has come from there and
    /// goes out again; whether it still does comes back.
    fn follow(&self, now: &Sample, spacing: f64, narrow: f64, has_crossed: bool) -> Result<(Sample, bool), Fault> {
        let least = if has_crossed { TINY } else { narrow.min(spacing) };
        let mut step = spacing;
        loop {
            match self.next(now, step)? {
                Some(next) if step <= narrow || self.is_joined(now, &next, step, narrow)? => {
                    return Ok((next, has_crossed && step < 2.0 * narrow));
                }
                None if step <= least => break,
                _ => step = (step / 2.0).max(least),
            }
        }
        let off = |way: f64| now.at + now.away * way;
        let felt = if has_crossed { None } else { feel(self.control, off(OFF.min(step / 2.0)), off(step))? };
        let across = felt.as_ref().and_then(Self::sample).filter(|across| across.away.dot(now.away) < 0.0);
        across.map(|across| (across, true)).ok_or_else(|| lost(self.control, now.at))
    }

    /// Whether the stylus stays in contact on the way to a place at that distance, and does not go over a gap.
    fn is_joined(&self, from: &Sample, to: &Sample, distance: f64, narrow: f64) -> Result<bool, Fault> {
        let way = (to.at - from.at).normalize_or_zero();
        let leans = way.dot(from.away).abs().max(way.dot(to.away).abs());
        if distance <= narrow || (from.away.dot(to.away) > cosd(SMOOTH) && leans < sind(SMOOTH)) {
            return Ok(true);
        }
        let half = distance / 2.0;
        let Some(middle) = self.next(from, half)? else { return Ok(false) };
        let rest = (to.at - middle.at).length();
        let comes = self.next(&middle, rest)?.is_some_and(|next| (next.at - to.at).length() < TOUCHES);
        Ok(comes && self.is_joined(from, &middle, half, narrow)? && self.is_joined(&middle, to, rest, narrow)?)
    }

    /// Whether the first place comes next.
    fn is_next(&self, now: &Sample, first: &Sample, distance: f64) -> Result<bool, Fault> {
        if distance <= LEAST {
            return Ok(true);
        }
        Ok(self.next(now, distance)?.is_some_and(|next| (next.at - first.at).length() < TOUCHES))
    }

    /// The place in an inside corner between two others.
    fn inside_corner(&self, a: &Sample, b: &Sample, spacing: f64) -> Result<Option<Sample>, Fault> {
        let (first, second) = (a.away.truncate(), b.away.truncate());
        // On a way with the material on the right, the normal turns to the left in an inside corner.
        // In the tip of a notch nothing says in which direction the ball comes out.
        if first.perp_dot(second) * -self.sign() < sind(CORNER) || first.dot(second) < -cosd(NOTCH) {
            return Ok(None);
        }
        let corner = meeting(a.at.truncate(), first, b.at.truncate(), second);
        let (Some(corner), Some(bisector)) = (corner, (a.away + b.away).try_normalize()) else { return Ok(None) };
        let corner = corner.extend(a.at.z);
        let near = |other: &Sample| (corner - other.at).length();
        if near(a).max(near(b)) > spacing || near(a).min(near(b)) < TOUCHES {
            return Ok(None);
        }
        let half = bisector * (0.5 * near(a).min(near(b)));
        let found = feel(self.control, corner + half, corner - half)?.as_ref().and_then(Self::sample);
        let fits = |sample: &Sample| (sample.at - a.at).length().max((sample.at - b.at).length()) <= spacing;
        Ok(found.filter(fits).map(|sample| Sample { away: bisector, ..sample }))
    }
}

/// Of places close together those that are stored: no farther from each other than the spacing, and as few as the way
/// between them deviates by no more than the tolerance.
pub(super) fn stored(samples: &[Sample], spacing: f64, tolerance: f64) -> Vec<bool> {
    let mut keep = vec![false; samples.len()];
    let mut anchor = 0;
    for (index, sample) in samples.iter().enumerate() {
        if index == 0 || samples[index - 1].on == Ground::Nothing || sample.on == Ground::Nothing {
            keep[index] = sample.on != Ground::Nothing;
            if index > 0 && samples[index - 1].on != Ground::Nothing {
                keep[index - 1] = true;
            }
            anchor = index;
            continue;
        }
        let (from, to) = (samples[anchor].at, sample.at);
        let chord = (to - from).normalize_or_zero();
        let deviates = |between: &Sample| {
            let way = between.at - from;
            (way - chord * way.dot(chord)).length() > tolerance
        };
        let too_far = (to - from).length() > spacing + SAME;
        if index > anchor + 1 && (too_far || samples[anchor + 1..index].iter().any(deviates)) {
            keep[index - 1] = true;
            anchor = index - 1;
        }
    }
    if let (Some(last), Some(sample)) = (keep.last_mut(), samples.last()) {
        *last = sample.on != Ground::Nothing;
    }
    keep
}
