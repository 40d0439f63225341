//! The cells into which planes through one point divide the directions around it.
//!
//! Invariant: every cell is found, as the signs of its directions against the normals of the planes. Each
//! cell of planes that are not all parallel reaches one of the lines in which two of them meet, so it is
//! enough to walk around those lines.
use glam::DVec3;

/// Directions closer than this are the same direction: surfaces that overlap by a tenth of a nanometre
/// cross at a greater angle even if their radius is 10 m.
const SAME_DIRECTION: f64 = 1e-7;

/// Whether two unit normals belong to the same plane through a point.
pub(super) fn parallel(a: DVec3, b: DVec3) -> bool {
    a.cross(b).length() <= SAME_DIRECTION
}

/// The sign vectors of all cells; an empty list of normals has one cell without signs.
pub(super) fn cells(normals: &[DVec3]) -> Vec<Vec<i8>> {
    let Some((first, rest)) = normals.split_first() else { return vec![Vec::new()] };
    if rest.iter().all(|n| parallel(*first, *n)) {
        return [*first, -*first].map(|d| normals.iter().map(|n| sign(n.dot(d))).collect()).to_vec();
    }
    let mut found = Vec::new();
    for (k, a) in normals.iter().enumerate() {
        for b in normals.iter().skip(k + 1).filter(|b| !parallel(*a, **b)) {
            let line = a.cross(*b).normalize();
            for ray in [line, -line] {
                around(ray, normals, &mut found);
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn sign(x: f64) -> i8 {
    if x < 0.0 { -1 } else { 1 }
}

/// The cells around a ray in which planes meet.
fn around(ray: DVec3, normals: &[DVec3], found: &mut Vec<Vec<i8>>) {
    let on_ray = |n: &DVec3| n.dot(ray).abs() <= SAME_DIRECTION;
    let (x, y) = ray.any_orthonormal_pair();
    let mut angles: Vec<f64> = Vec::new();
    for n in normals.iter().filter(|n| on_ray(n)) {
        let trace = ray.cross(*n);
        let angle = libm::atan2(trace.dot(y), trace.dot(x));
        angles.extend([angle, angle + core::f64::consts::PI].map(|a| a.rem_euclid(core::f64::consts::TAU)));
    }
    angles.sort_by(f64::total_cmp);
    let Some(first) = angles.first().copied() else { return };
    angles.push(first + core::f64::consts::TAU);
    for (from, to) in angles.iter().zip(angles.iter().skip(1)) {
        if to - from <= SAME_DIRECTION {
            continue;
        }
        let middle = 0.5 * (from + to);
        let way = x * libm::cos(middle) + y * libm::sin(middle);
        let signs = normals.iter().map(|n| sign(if on_ray(n) { n.dot(way) } else { n.dot(ray) }));
        found.push(signs.collect());
    }
}
