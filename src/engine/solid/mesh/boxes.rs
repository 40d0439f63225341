//! A hierarchy of boxes about things in space.
//!
//! Invariant: things are sorted so that those of a box are next to each other; a box holds all of its things and the
//! boxes of its halves. How deep it is grows with the logarithm of their number.
use glam::DVec3;

/// So many things are not divided any further.
const FEW: usize = 4;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    min: DVec3,
    max: DVec3,
}

impl Bounds {
    const NOTHING: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    pub(super) fn of(points: &[DVec3]) -> Self {
        points.iter().fold(Self::NOTHING, |all, point| Self { min: all.min.min(*point), max: all.max.max(*point) })
    }

    fn with(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    fn middle(&self) -> DVec3 {
        self.min.midpoint(self.max)
    }

    /// How far a point is from the box.
    fn distance(&self, p: DVec3) -> f64 {
        (p - p.clamp(self.min, self.max)).length()
    }

    /// Whether a point lies in the box, or nearer to it than `reach`.
    pub(super) fn holds(&self, p: DVec3, reach: f64) -> bool {
        self.distance(p) <= reach
    }

    /// Whether the line `origin + s direction` may go through, of a ray only where `s` is not negative.
    fn is_met_by(&self, origin: DVec3, direction: DVec3, ray: bool) -> bool {
        let (mut low, mut high) = (if ray { 0.0 } else { f64::NEG_INFINITY }, f64::INFINITY);
        let room = 1e-9 * (1.0 + self.max.abs().max(self.min.abs()).max_element());
        let (min, max) = (self.min - origin - DVec3::splat(room), self.max - origin + DVec3::splat(room));
        for ((min, max), way) in min.to_array().into_iter().zip(max.to_array()).zip(direction.to_array()) {
            if way == 0.0 {
                if min > 0.0 || max < 0.0 {
                    return false;
                }
                continue;
            }
            let (a, b) = (min / way, max / way);
            (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        }
        low <= high
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    bounds: Bounds,
    /// The first of its things.
    first: u32,
    /// How many it has, if it is not divided.
    count: u32,
    /// Its other half; the first one comes next.
    other: u32,
}

/// The hierarchy.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Boxes {
    nodes: Vec<Node>,
}

impl Boxes {
    /// Sorts things into boxes.
    pub(super) fn of<T: Copy>(things: &mut [T], bounds: impl Fn(&T) -> Bounds) -> Self {
        let mut nodes = Vec::new();
        divide(things, 0, &bounds, &mut nodes);
        Self { nodes }
    }

    /// The box about everything.
    pub(super) fn bounds(&self) -> Bounds {
        self.nodes.first().map_or(Bounds::NOTHING, |node| node.bounds)
    }

    /// Goes through the boxes that are `wanted`.
    fn visit(&self, wanted: &mut dyn FnMut(&Bounds) -> bool, thing: &mut dyn FnMut(usize) -> bool) {
        let mut open = vec![0_usize];
        while let Some(index) = open.pop() {
            let Some(node) = self.nodes.get(index).filter(|node| wanted(&node.bounds)) else { continue };
            if node.count == 0 {
                open.extend([node.other as usize, index + 1]);
                continue;
            }
            for index in node.first..node.first + node.count {
                if !thing(index as usize) {
                    return;
                }
            }
        }
    }

    /// Goes through things from near to far: `look` is given a limit of distances and gives the new one.
    pub(super) fn nearest(&self, p: DVec3, limit: f64, look: &mut dyn FnMut(usize, f64) -> f64) {
        let mut limit = limit;
        let mut open = vec![(self.bounds().distance(p), 0_usize)];
        while let Some((distance, index)) = open.pop() {
            let Some(node) = self.nodes.get(index).filter(|_| distance < limit) else { continue };
            if node.count > 0 {
                for index in node.first..node.first + node.count {
                    limit = look(index as usize, limit);
                }
                continue;
            }
            let mut halves = [index + 1, node.other as usize].map(|half| {
                let distance = self.nodes.get(half).map_or(f64::INFINITY, |node| node.bounds.distance(p));
                (distance, half)
            });
            // The nearer one is looked at first.
            halves.sort_by(|one, other| other.0.total_cmp(&one.0));
            open.extend(halves);
        }
    }

    /// Goes through things whose box a point is near, until `thing` is false.
    pub(super) fn within(&self, p: DVec3, reach: f64, thing: &mut dyn FnMut(usize) -> bool) {
        self.visit(&mut |bounds| bounds.distance(p) <= reach, thing);
    }

    /// Goes through things that a line, or a ray, may meet.
    pub(super) fn along(&self, origin: DVec3, direction: DVec3, ray: bool, thing: &mut dyn FnMut(usize)) {
        self.visit(&mut |bounds| bounds.is_met_by(origin, direction, ray), &mut |index| {
            thing(index);
            true
        });
    }
}

/// Adds the box of things and those of its halves.
fn divide<T: Copy>(things: &mut [T], first: usize, bounds: &impl Fn(&T) -> Bounds, nodes: &mut Vec<Node>) {
    let all = things.iter().map(bounds).fold(Bounds::NOTHING, Bounds::with);
    let index = nodes.len();
    let count = if things.len() > FEW { 0 } else { things.len() as u32 };
    nodes.push(Node { bounds: all, first: first as u32, count, other: 0 });
    if count > 0 || things.is_empty() {
        return;
    }
    let middles = things.iter().map(|thing| bounds(thing).middle());
    let middles = Bounds::of(&middles.collect::<Vec<_>>());
    let extent = (middles.max - middles.min).to_array();
    let widest = (0..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best });
    let half = things.len() / 2;
    let place = |thing: &T| bounds(thing).middle().to_array()[widest];
    things.select_nth_unstable_by(half, |one, other| place(one).total_cmp(&place(other)));
    let (low, high) = things.split_at_mut(half);
    divide(low, first, bounds, nodes);
    let other = nodes.len() as u32;
    if let Some(node) = nodes.get_mut(index) {
        node.other = other;
    }
    divide(high, first + half, bounds, nodes);
}
