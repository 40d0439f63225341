//! What is kept of plain movements at feed: where they have been since the last tool call, and under one transformation.
use std::collections::{BTreeSet, HashSet};

use glam::DVec3;

use super::body::{Body, SAME, SKIN};

/// So many places are remembered.
pub(super) const MOST: usize = 1 << 15;
/// Of a movement so many.
const LONGEST: f64 = 1_000.0;

/// Places of a path are so far from each other, mm, and so near to others at the same height they are the same.
const STEP: f64 = 0.5;
/// So much of a path that is in the same places makes it the same path.
const COVERED: f64 = 0.9;

/// So many feeds of a tool are remembered.
const FEEDS: usize = 16;
/// So many rotations of a tool are remembered.
const ROTATIONS: usize = 1 << 9;
/// A whole turn in hundredths of a degree, and so many equal angles in it lack none by intention.
pub(super) const TURN: i64 = 36_000;
const ANGLES: usize = 5;

/// A place, in steps; its height in hundredths of a millimetre.
type Place = [i64; 3];

/// The line of a movement and its ends, hundredths of a millimetre.
pub(super) type Stroke = (usize, [i64; 6]);

/// The plain movements of a tool.
#[derive(Default)]
pub(super) struct Ways {
    /// The line of the first movement that goes along the blank, and the lowest height of all.
    pub(super) along: Option<usize>,
    pub(super) lowest: Option<f64>,
    /// The first movement below the top of the blank, how many there are, and whether any comes to the blank.
    pub(super) below: Option<(usize, DVec3)>,
    pub(super) deep: usize,
    pub(super) meets: bool,
    /// Whether cycles machine with the tool.
    pub(super) cycles: bool,
    /// The rotation in effect, and those under which the tool has cut, hundredths of a degree.
    pub(super) rotation: i64,
    pub(super) rotations: BTreeSet<i64>,
    /// Under other transformations, and under the one in effect with the line of the first.
    pub(super) before: HashSet<Place>,
    pub(super) now: HashSet<Place>,
    /// The movements in `now`, and those under other transformations: their lines and both ends.
    pub(super) strokes: Vec<Stroke>,
    pub(super) done: HashSet<Stroke>,
    pub(super) first: Option<usize>,
    /// Whether any movement in `now` may cut, the lines of movements that may under other transformations, and these.
    pub(super) cuts: bool,
    pub(super) cutting: HashSet<usize>,
    pub(super) transformations: Vec<[[i64; 4]; 3]>,
    /// The feeds of the movements through solid material, mm/min and mm per revolution, each with its first line.
    pub(super) feeds: Vec<([f64; 2], usize)>,
    /// The transformation in effect, without its datum shift along the tool axis.
    pub(super) transformation: Option<[[i64; 4]; 3]>,
}

impl Ways {
    /// Notes a movement at feed.
    pub(super) fn note(&mut self, line: usize, (from, to): (DVec3, DVec3), body: &Body, (meets, cuts): (bool, bool)) {
        self.meets |= meets;
        let flat = (to - from).truncate().length() > SAME;
        if flat && meets {
            self.along.get_or_insert(line);
        }
        if flat && to.z < body.high.z - SKIN {
            self.below.get_or_insert((line, to));
            self.deep += 1;
        }
        if flat && to.z < body.high.z - SKIN && self.now.len() + self.before.len() < MOST {
            let count = ((to - from).length() / STEP).ceil().clamp(1.0, LONGEST);
            self.now.extend((0..=count as usize).map(|at| steps(from.lerp(to, at as f64 / count))));
            let ends = [from, to].map(|own| (own / SAME).to_array().map(|own| own.round() as i64));
            self.strokes.push((line, [ends[0][0], ends[0][1], ends[0][2], ends[1][0], ends[1][1], ends[1][2]]));
            self.first.get_or_insert(line);
            self.cuts |= cuts;
        }
    }

    /// Notes how low a movement along the plane goes; a helix may end above where it begins.
    pub(super) fn note_lowest(&mut self, from: DVec3, places: &[DVec3]) {
        if places.iter().any(|place| (*place - from).truncate().length() > SAME) {
            let low = places.iter().map(|place| place.z).fold(from.z, f64::min);
            self.lowest = Some(self.lowest.map_or(low, |lowest| lowest.min(low)));
        }
    }

    /// Notes a movement at feed of which it is not known where in the blank it goes.
    pub(super) fn note_unseen(&mut self) {
        (self.meets, self.cuts) = (true, true);
        self.lowest = Some(f64::NEG_INFINITY);
    }

    /// Notes that the tool cuts under the rotation in effect.
    pub(super) fn note_rotation(&mut self) {
        if self.rotations.len() < ROTATIONS {
            self.rotations.insert(self.rotation);
        }
    }

    /// How many equal angles there would be in a whole turn, if the tool has cut at all of them but one.
    pub(super) fn lacks_one(&self) -> Option<usize> {
        let all: Vec<i64> = self.rotations.iter().copied().collect();
        let count = all.len() + 1;
        let step = TURN / i64::try_from(count).ok()?;
        let gaps = all.windows(2).map(|pair| pair[1] - pair[0]);
        let equal = |gap: i64| (gap - step).abs() <= 1;
        let (same, twice) = gaps.fold((0, 0), |(same, twice), gap| {
            (same + usize::from(equal(gap)), twice + usize::from((gap - 2 * step).abs() <= 2))
        });
        // The one that is missing is between two others, or between the last and the first.
        let inside = twice == 1 && same + twice == all.len() - 1;
        (count >= ANGLES && (same == all.len() - 1 || inside)).then_some(count)
    }

    /// Notes the feed of a movement sideways through solid material.
    pub(super) fn note_feed(&mut self, line: usize, feed: f64, speed: f64) {
        if self.feeds.len() < FEEDS && self.feeds.iter().all(|([own, _], _)| *own != feed) {
            self.feeds.push(([feed, feed / speed], line));
        }
    }

    /// Whether nearly all of these places were passed before.
    pub(super) fn covers(&self, now: &HashSet<Place>) -> bool {
        let near = |own: &&Place| {
            let [x, y, z] = **own;
            let around = (-1..=1).flat_map(|i| (-1..=1).map(move |k| [x + i, y + k, z]));
            around.into_iter().any(|place| self.before.contains(&place))
        };
        !self.before.is_empty() && now.iter().filter(near).count() as f64 >= COVERED * now.len() as f64
    }
}

fn steps(place: DVec3) -> Place {
    let step = DVec3::new(STEP, STEP, SAME);
    (place / step).to_array().map(|own| own.round() as i64)
}
