//! Questions to a body: the distance of a point, and where a moving ball touches first.
//!
//! Invariant: an answer is exact or an error. A reported contact always is one, because its point belongs
//! to the body and lies one ball radius from the centre; none is missed, because every first contact is on
//! the foot of a perpendicular to a face or an edge, or on a corner, and all of them are examined.
use super::SolidError;
use super::body::{Body, Feature};
use super::path::{Path, Piece};
use glam::DVec3;

/// Where a ball touches, and how far along its path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Parameter of the path, 0 at its start and 1 at its end.
    pub t: f64,
    /// The centre of the ball at that moment.
    pub ball_centre: DVec3,
    /// The point of the solid that is touched.
    pub point: DVec3,
    /// Unit vector out of the material, from the point to the ball centre.
    pub normal: DVec3,
    /// The ball overlapped the solid before it moved.
    pub deflected: bool,
}

/// The nearest point of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance in mm; 0 inside the solid.
    pub distance: f64,
    /// The nearest point; the asked point itself inside the solid.
    pub point: DVec3,
}

/// A ball that is closer or deeper than this touches, in mm: the accuracy that is promised.
pub(super) const TOUCH: f64 = 1e-9;
/// A motion whose angle to a surface is below this (as a sine) may only graze it: the way ahead decides.
pub(super) const SHALLOW: f64 = 1e-5;
/// A root of the polynomial is one of the distance only if the gap there is below this, in mm, before it is sharpened.
const NEAR_ROOT: f64 = 1e-3;
/// Unsupported edges are distinguished from the ball down to this share of its radius.
const EDGE_SHARE: f64 = 1.0 / 64.0;
/// The search for unsupported edges gives up (and reports them) after so many cells.
const MAX_CELLS: usize = 200_000;
/// A ball that goes any way and comes closer than this, in mm, counts as touching.
const NEAR: f64 = 1e-6;
/// More stretches of such a path are not examined.
const MAX_STRETCHES: usize = 1_000_000;
/// A helix is proven free in steps not shorter than this, in mm.
const MIN_STEP: f64 = 1e-3;

/// Pieces are examined in so many stretches before their features are calculated with.
const STRETCHES: usize = 6;

/// A moment at which the ball is at the right distance from a feature.
pub(super) struct Candidate {
    pub(super) t: f64,
    pub(super) centre: DVec3,
    pub(super) point: DVec3,
}

impl Body {
    /// The nearest point of the solid; nothing if it is empty.
    ///
    /// # Errors
    /// An edge that is not supported may be nearer, or a number is not finite.
    pub fn nearest(&self, p: DVec3) -> Result<Option<Nearest>, SolidError> {
        let nearest = self.nearest_within(p, f64::INFINITY)?;
        let reach = nearest.map_or(1e9, |nearest| nearest.distance);
        self.no_edge_within(p, reach)?;
        Ok(nearest)
    }

    /// Whether a ball standing there overlaps the solid by more than the accuracy (a probe that is already deflected).
    ///
    /// # Errors
    /// An edge that is not supported may touch the ball, or a number is not finite.
    pub fn touches(&self, ball_radius: f64, centre: DVec3) -> Result<bool, SolidError> {
        if self.nearest_within(centre, ball_radius - TOUCH)?.is_some() {
            return Ok(true);
        }
        self.no_edge_within(centre, ball_radius)?;
        Ok(false)
    }

    /// The nearest point of the solid that is closer than `limit`, apart from edges that are not supported.
    fn nearest_within(&self, p: DVec3, limit: f64) -> Result<Option<Nearest>, SolidError> {
        if !p.is_finite() {
            return Err(SolidError::NotFinite);
        }
        if self.contains(p)? {
            return Ok(Some(Nearest { distance: 0.0, point: p }));
        }
        let mut found = self.nearest_beside_meshes(p, limit)?;
        for mesh in &self.meshes {
            let limit = found.map_or(limit, |nearest| nearest.distance);
            found = mesh.nearest(p, limit).or(found);
        }
        Ok(found)
    }

    /// The same apart from triangulated surfaces.
    fn nearest_beside_meshes(&self, p: DVec3, limit: f64) -> Result<Option<Nearest>, SolidError> {
        if self.holds(p)? {
            return Ok(Some(Nearest { distance: 0.0, point: p }));
        }
        let feet = self.features.iter().map(|f| f.foot(p));
        let feet = feet.map(|foot| ((foot - p).length(), foot));
        let mut feet: Vec<(f64, DVec3)> = feet.filter(|(distance, _)| *distance < limit).collect();
        feet.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (distance, point) in feet {
            if self.holds(point)? {
                return Ok(Some(Nearest { distance, point }));
            }
        }
        Ok(None)
    }

    fn no_edge_within(&self, p: DVec3, reach: f64) -> Result<(), SolidError> {
        let near = |(a, b): &(usize, usize)| self.edge_within(*a, *b, p, reach);
        if self.unsupported.iter().any(near) { Err(SolidError::Edge(p)) } else { Ok(()) }
    }

    /// Where a ball that moves along a straight line touches first.
    ///
    /// # Errors
    /// As for [`Body::first_contact_on`].
    pub fn first_contact(&self, ball_radius: f64, from: DVec3, to: DVec3) -> Result<Option<Contact>, SolidError> {
        self.first_contact_on(ball_radius, &Path::line(from, to))
    }

    /// Where a ball that moves along a path touches first: where it begins to penetrate. Touching while it
    /// slides along a face or leaves it is no contact. A ball that overlaps the solid at the start has its
    /// contact there, marked `deflected`.
    ///
    /// # Errors
    /// The ball radius is not positive, a number is not finite, an edge that is not supported lies within
    /// reach, or a helix cannot be proven free. There is no approximate answer.
    pub fn first_contact_on(&self, ball_radius: f64, path: &Path) -> Result<Option<Contact>, SolidError> {
        if !(ball_radius.is_finite() && ball_radius > 0.0 && path.is_finite()) {
            return Err(SolidError::NotFinite);
        }
        if path.is_helix() {
            return self.helix_is_free(ball_radius, path, 0.0, 1.0).map(|()| None);
        }
        let mut first: Option<Contact> = None;
        for mesh in &self.meshes {
            let sooner = |contact: &Contact| first.is_none_or(|first| contact.t < first.t);
            first = mesh.first_contact(ball_radius, path)?.filter(sooner).or(first);
        }
        let found = self.first_contact_beside_meshes(ball_radius, path, first.map_or(1.0, |contact| contact.t))?;
        Ok(match (first, found) {
            (Some(first), Some(found)) if first.t <= found.t => Some(first),
            (first, found) => found.or(first),
        })
    }

    /// The first contact apart from triangulated surfaces, of which one is touched at `latest`.
    fn first_contact_beside_meshes(
        &self,
        ball_radius: f64,
        path: &Path,
        latest: f64,
    ) -> Result<Option<Contact>, SolidError> {
        let pieces = path.pieces();
        let near = |piece: &Piece| {
            let whole = Stretch::whole(piece);
            self.features.iter().filter(|feature| !whole.is_clear(feature, ball_radius)).collect::<Vec<_>>()
        };
        // What is far from all of the first piece is far from the start as well.
        let at_start = pieces.first().map_or_else(|| self.features.iter().collect(), &near);
        let mut candidates = Vec::new();
        for (index, piece) in pieces.iter().enumerate() {
            if index == 0 {
                candidates_on(piece, ball_radius, &at_start, &mut candidates);
            } else {
                candidates_on(piece, ball_radius, &near(piece), &mut candidates);
            }
        }
        candidates.sort_by(|a, b| a.t.total_cmp(&b.t));
        let next = candidates.first().map_or(1.0, |candidate| candidate.t);
        if let Some(contact) = self.contact_at_start(ball_radius, path, pieces.first(), &at_start, next)? {
            return Ok(Some(contact));
        }
        let mut found = None;
        for Candidate { t, centre, point } in candidates {
            if self.holds(point)? {
                let normal = (centre - point) / ball_radius;
                found = Some(Contact { t, ball_centre: centre, point, normal, deflected: false });
                break;
            }
        }
        let until = found.map_or(latest, |contact: Contact| contact.t.min(latest));
        for (a, b) in &self.unsupported {
            self.edge_is_clear(*a, *b, ball_radius, path, 0.0, until)?;
        }
        Ok(found)
    }

    /// The contact at the start of the path, if the ball is there already.
    fn contact_at_start(
        &self,
        radius: f64,
        path: &Path,
        piece: Option<&Piece>,
        near: &[&Feature],
        next: f64,
    ) -> Result<Option<Contact>, SolidError> {
        let start = path.at(0.0);
        let way = piece.map_or(DVec3::ZERO, |piece| {
            if piece.backwards() { -piece.speed(piece.high) } else { piece.speed(piece.low) }
        });
        let way = way.normalize_or_zero();
        if self.holds(start)? {
            let contact = Contact { t: 0.0, ball_centre: start, point: start, normal: -way, deflected: true };
            return Ok(Some(contact));
        }
        let (mut best, mut sliding): (Option<(f64, Contact)>, Option<Contact>) = (None, None);
        for feature in near {
            let point = feature.foot(start);
            let distance = (start - point).length();
            let gap = distance - radius;
            if gap > TOUCH || !self.holds(point)? {
                continue;
            }
            let normal = (start - point) / distance;
            let deflected = gap < -TOUCH;
            let contact = Contact { t: 0.0, ball_centre: start, point, normal, deflected };
            if deflected || normal.dot(way) < -SHALLOW {
                if best.is_none_or(|(least, _)| gap < least) {
                    best = Some((gap, contact));
                }
            } else {
                sliding = Some(contact);
            }
        }
        if let Some((_, contact)) = best {
            return Ok(Some(contact));
        }
        // A motion along a touched face may still lead or bend into it.
        let bends_in = sliding.is_some() && {
            let half_way = path.at(0.5 * next);
            let touches = self.nearest_beside_meshes(half_way, radius - TOUCH)?.is_some();
            if !touches {
                self.no_edge_within(half_way, radius)?;
            }
            touches
        };
        Ok(sliding.filter(|_| bends_in))
    }

    /// Proves that no point of an unsupported edge comes within the ball between two moments.
    fn edge_is_clear(
        &self,
        a: usize,
        b: usize,
        radius: f64,
        path: &Path,
        from: f64,
        to: f64,
    ) -> Result<(), SolidError> {
        let half = 0.5 * (to - from) * path.length();
        let middle = 0.5 * (from + to);
        if !self.edge_within(a, b, path.at(middle), radius + half) {
            return Ok(());
        }
        if half <= radius * EDGE_SHARE {
            return Err(SolidError::Edge(path.at(middle)));
        }
        self.edge_is_clear(a, b, radius, path, from, middle)?;
        self.edge_is_clear(a, b, radius, path, middle, to)
    }

    /// Whether a point on both surfaces that may bound the solid may lie within `reach` of `p`. Never denies wrongly.
    fn edge_within(&self, a: usize, b: usize, p: DVec3, reach: f64) -> bool {
        let (Some(first), Some(second)) = (self.surfaces.get(a), self.surfaces.get(b)) else { return false };
        let mut open = vec![(p, reach)];
        let mut looked = 0;
        while let Some((middle, half)) = open.pop() {
            looked += 1;
            let around = half * 1.733;
            let excluded = first.signed(middle).abs() > around
                || second.signed(middle).abs() > around
                || (middle - p).length() - around > reach
                || self.certain(middle, around, a, b).is_some();
            if excluded {
                continue;
            }
            if half <= reach * EDGE_SHARE * 0.25 || looked > MAX_CELLS {
                return true;
            }
            let quarter = half * 0.5;
            for corner in 0..8_u8 {
                let offset = |bit: u8| if corner & bit == 0 { -quarter } else { quarter };
                open.push((middle + DVec3::new(offset(1), offset(2), offset(4)), quarter));
            }
        }
        false
    }

    /// A place where a ball touches whose centre goes any way; nothing if it stays free. It need not be the first one.
    /// `at` says where the centre is when a share of the way is done, `reach` how far it is from there at most, not
    /// more than another share before or after. A ball that comes nearer than [`NEAR`] counts as touching.
    ///
    /// # Errors
    /// As for [`Body::first_contact_on`]; and a ball that goes so near to the solid for so long that
    /// it cannot be proven free.
    pub fn contact_on_course(
        &self,
        ball_radius: f64,
        at: &dyn Fn(f64) -> DVec3,
        reach: &dyn Fn(f64, f64) -> f64,
    ) -> Result<Option<Contact>, SolidError> {
        if !(ball_radius.is_finite() && ball_radius > 0.0) {
            return Err(SolidError::NotFinite);
        }
        let (mut open, mut looked) = (vec![(0.5, 0.5)], 0);
        while let Some((middle, half)) = open.pop() {
            let (centre, reach) = (at(middle), reach(middle, half));
            looked += 1;
            if looked > MAX_STRETCHES {
                return Err(SolidError::Helix(centre));
            }
            let edges = match self.nearest_within(centre, ball_radius + reach)? {
                Some(Nearest { distance, point }) if distance < ball_radius - TOUCH || reach < NEAR => {
                    let normal = (centre - point).normalize_or_zero();
                    return Ok(Some(Contact { t: middle, ball_centre: centre, point, normal, deflected: false }));
                }
                Some(_) => Ok(()),
                None => match self.no_edge_within(centre, ball_radius + reach) {
                    Ok(()) => continue,
                    edges => edges,
                },
            };
            if reach < NEAR {
                edges?;
            }
            open.extend([(middle + half / 2.0, half / 2.0), (middle - half / 2.0, half / 2.0)]);
        }
        Ok(None)
    }

    /// Proves that a ball on a helix touches nothing; a helix that would touch is a limit.
    fn helix_is_free(&self, radius: f64, path: &Path, from: f64, to: f64) -> Result<(), SolidError> {
        let half = 0.5 * (to - from) * path.length();
        let middle = 0.5 * (from + to);
        let distance =
            self.nearest_within(path.at(middle), radius + half)?.map_or(f64::INFINITY, |nearest| nearest.distance);
        if distance >= radius + half {
            return self.no_edge_within(path.at(middle), radius + half);
        }
        if distance < radius || half <= MIN_STEP {
            return Err(SolidError::Helix(path.at(middle)));
        }
        self.helix_is_free(radius, path, from, middle)?;
        self.helix_is_free(radius, path, middle, to)
    }
}

/// A stretch of a piece: all of it lies within `reach` of `middle`.
struct Stretch {
    middle: DVec3,
    reach: f64,
}

impl Stretch {
    /// A piece as one stretch.
    fn whole(piece: &Piece) -> Self {
        let (from, middle, to) = (piece.at(piece.low), piece.at(0.5 * (piece.low + piece.high)), piece.at(piece.high));
        Self { middle, reach: (from - middle).length().max((to - middle).length()) }
    }

    /// A piece in stretches: many features are too far from each of them, and need not be calculated with.
    fn of(piece: &Piece) -> [Self; STRETCHES] {
        let step = (piece.high - piece.low) / STRETCHES as f64;
        core::array::from_fn(|k| {
            let low = piece.low + step * k as f64;
            let (from, middle, to) = (piece.at(low), piece.at(low + 0.5 * step), piece.at(low + step));
            // No arc of a piece is so long that it goes farther from its middle than its ends.
            Self { middle, reach: (from - middle).length().max((to - middle).length()) }
        })
    }

    fn is_clear(&self, feature: &Feature, radius: f64) -> bool {
        (feature.foot(self.middle) - self.middle).length() > self.reach + radius + TOUCH
    }
}

/// Adds all moments at which the ball begins to be closer to a feature near the piece than its radius.
pub(super) fn candidates_on(piece: &Piece, radius: f64, near: &[&Feature], all: &mut Vec<Candidate>) {
    if near.is_empty() {
        return;
    }
    let stretches = Stretch::of(piece);
    for feature in near {
        if stretches.iter().all(|stretch| stretch.is_clear(feature, radius)) {
            continue;
        }
        let Some(poly) = feature.at_distance(piece, radius) else { continue };
        let roots = poly.roots_and_extrema(piece.low, piece.high);
        all.extend(roots.into_iter().filter_map(|u| candidate(feature, piece, radius, u)));
    }
}

/// The ball at one place of a piece, and a feature.
struct State {
    centre: DVec3,
    point: DVec3,
    /// Distance less radius.
    gap: f64,
    /// Change of the gap by the parameter of the piece.
    slope: f64,
}

impl State {
    fn new(feature: &Feature, piece: &Piece, radius: f64, u: f64) -> Self {
        let centre = piece.at(u);
        let point = feature.foot(centre);
        let away = centre - point;
        let distance = away.length();
        let slope = if distance > 0.0 { away.dot(piece.speed(u)) / distance } else { 0.0 };
        Self { centre, point, gap: distance - radius, slope }
    }
}

/// A root of a feature's polynomial, sharpened on the true distance and kept if it is an approach.
fn candidate(feature: &Feature, piece: &Piece, radius: f64, root: f64) -> Option<Candidate> {
    let (mut u, mut here) = (root, State::new(feature, piece, radius, root));
    if here.gap.abs() > NEAR_ROOT {
        return None;
    }
    for _ in 0..8 {
        let next = u - here.gap / here.slope;
        if !next.is_finite() || next < piece.low || next > piece.high {
            break;
        }
        let there = State::new(feature, piece, radius, next);
        if there.gap.abs() >= here.gap.abs() {
            break;
        }
        (u, here) = (next, there);
    }
    let forward = if piece.backwards() { -here.slope } else { here.slope };
    let steep = SHALLOW * piece.speed(u).length();
    let approach = forward < -steep || (forward < steep && deepens(feature, piece, radius, u));
    (here.gap.abs() <= TOUCH && approach).then(|| Candidate { t: piece.t(u), centre: here.centre, point: here.point })
}

/// Whether a ball that barely approaches a feature gets deeper into it than the accuracy before it leaves again.
fn deepens(feature: &Feature, piece: &Piece, radius: f64, u: f64) -> bool {
    let (end, sign) = if piece.backwards() { (piece.low, -1.0) } else { (piece.high, 1.0) };
    let room = (end - u).abs();
    let mut ahead = room * 1e-9;
    while ahead < room {
        let there = State::new(feature, piece, radius, u + sign * ahead);
        if there.gap.abs() > TOUCH {
            return there.gap < 0.0;
        }
        ahead *= 1.5;
    }
    let last = State::new(feature, piece, radius, end);
    last.gap < 0.0 && sign * last.slope < 0.0
}
