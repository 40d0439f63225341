//! What is wrong with the contours that a tool goes along: approaches on arcs that do not fit, a contour that begins where
//! the tool has plunged, cutting edges that are too short, places far from the blank.
use super::{Cut, SKIN, Walk};
use crate::check::incident::Incident;
use crate::check::{Aspect, Modal, Tri};
use crate::program::syntax::{Approach, Block, BlockKind, Compensation, Motion, Path};

/// The radius of a tool that is not known, in millimetres: arcs are not looked at that fit a larger one.
const RADIUS: f64 = 10.0;
/// So far from the blank nothing is machined, in millimetres, besides its own size.
const FAR: f64 = 50.0;
/// How many places of a movement are looked at.
const SAMPLES: i32 = 8;

/// Where a contour goes.
#[derive(Default)]
pub(super) struct Course {
    /// The direction of its last line.
    heading: Option<[f64; 2]>,
    /// 1 where the tool goes on its left, -1 on its right.
    side: f64,
    /// The centre of arcs.
    pub(super) centre: Option<[f64; 2]>,
    /// Whether a place far from the blank, and cutting edges that are too short, were found.
    reported: [bool; 2],
}

/// The side of the tool.
const fn side(words: &Motion) -> Option<f64> {
    match words.compensation {
        Some(Compensation::Rl) => Some(1.0),
        Some(Compensation::Rr) => Some(-1.0),
        Some(_) => Some(0.0),
        None => None,
    }
}

fn direction(from: [f64; 2], to: [f64; 2]) -> Option<[f64; 2]> {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = libm::hypot(x, y);
    (length > SKIN).then(|| [x / length, y / length])
}

impl Walk<'_, '_> {
    /// The tool goes to a contour.
    pub(super) fn approach(&mut self, index: usize, block: &Block, form: Approach, words: &Motion, modal: &Modal) {
        let start = self.at;
        let point = self.place(words);
        self.course.side = side(words).unwrap_or(self.course.side);
        let next = self.facts.program.blocks().get(index + 1).map(|next| &next.kind);
        self.course.heading = None;
        if let (Some(point), Some(BlockKind::Motion(next))) = (point, next)
            && next.path() == Path::L
        {
            let before = self.at;
            (self.at[0], self.at[1]) = (Some(point[0]), Some(point[1]));
            self.course.heading = self.place(&next.words()).and_then(|to| direction(point, to));
            self.at = before;
        }
        if let ([Some(x), Some(y), _], Some(point)) = (start, point)
            && form == Approach::Lct
        {
            self.fit_arc(block, words, point, [x, y], modal);
        }
        let height = words.coord(super::AXES[2]).map_or(start[2], |coord| self.target(coord, start[2]));
        match form {
            Approach::Lt | Approach::Ln | Approach::Ct | Approach::Lct => {
                self.at = [point.map(|own| own[0]), point.map(|own| own[1]), height];
            }
            _ => {
                let place = self.polar(words);
                self.at = [place.map(|own| own[0]), place.map(|own| own[1]), height];
            }
        }
        self.open = true;
    }

    /// The tool leaves a contour.
    pub(super) fn depart(&mut self, block: &Block, form: Approach, words: &Motion, modal: &Modal) {
        let end = self.place(words).filter(|_| !words.coords.is_empty());
        if let ([Some(x), Some(y), _], Some(end)) = (self.at, end)
            && form == Approach::Lct
        {
            self.fit_arc(block, words, [x, y], end, modal);
        }
        let height = words.coord(super::AXES[2]).map_or(self.at[2], |coord| self.target(coord, self.at[2]));
        self.at = match (form, end) {
            (Approach::Lct, Some([x, y])) => [Some(x), Some(y), height],
            _ => [None, None, height],
        };
        self.course.heading = None;
        self.course.side = 0.0;
        self.open = true;
    }

    /// Whether a place is inside of the arc that leads to a contour or away from it: no line goes from there to the arc.
    fn fit_arc(&mut self, block: &Block, words: &Motion, point: [f64; 2], place: [f64; 2], modal: &Modal) {
        let radius = words.radius.and_then(|own| self.facts.number(&own)).or_else(|| self.named(words, "R"));
        let (Some(radius), Some([x, y])) = (radius, self.course.heading) else { return };
        if self.course.side == 0.0 || radius <= 0.0 {
            return;
        }
        let normal = [-y * self.course.side, x * self.course.side];
        let centre = [point[0] + normal[0] * radius, point[1] + normal[1] * radius];
        let tool = self.tools.as_ref().and_then(|tools| tools.get(modal.loaded)).map(|tool| tool.radius);
        let room = radius - tool.unwrap_or(RADIUS * self.unit);
        if libm::hypot(place[0] - centre[0], place[1] - centre[1]) < room - SKIN * self.unit {
            self.tell(block, Incident::ArcInMaterial(radius));
        }
    }

    /// The number of a word such as the radius of an approach.
    fn named(&self, words: &Motion, name: &str) -> Option<f64> {
        let word = words.words.iter().find(|own| self.facts.text(own.name).trim().eq_ignore_ascii_case(name))?;
        match word.value.kind {
            crate::program::syntax::ValueKind::Number(number) => Some(number),
            _ => None,
        }
    }

    /// Looks at a movement at feed that has led here.
    pub(super) fn look_at_contour(&mut self, from: [Option<f64>; 3], block: &Block, words: &Motion, modal: &Modal) {
        let here = self.place(&Motion::new(Path::L));
        let before = from[0].zip(from[1]).map(|(x, y)| [x, y]);
        let begins = side(words).filter(|side| *side != 0.0);
        self.course.side = side(words).unwrap_or(self.course.side);
        let line = before.zip(here).filter(|_| words.path == Path::L).and_then(|(one, other)| direction(one, other));
        let flat = words.coord(super::AXES[0]).is_some() || words.coord(super::AXES[1]).is_some();
        let first = begins.is_some() && modal.is(Aspect::Compensation) == Tri::No && words.path == Path::L;
        if first && flat && before.is_some() && before == here && self.below(from[2]) {
            self.tell(block, Incident::ContourStartsAtPlunge);
        }
        if line.is_some() || words.path != Path::L {
            self.course.heading = line;
        }
        let compensated = begins.is_some() || (self.course.side != 0.0 && modal.is(Aspect::Compensation) == Tri::Yes);
        if let Some(here) = here.filter(|_| compensated && self.below(self.at[2])) {
            let plan = (0..2).map(|axis| self.blank.high[axis] - self.blank.low[axis]).fold(0.0, f64::max);
            let far = self.blank.distance(here) > plan + FAR * self.unit;
            if far && !std::mem::replace(&mut self.course.reported[0], true) {
                self.tell(block, Incident::OutsideBlank(here));
            }
        }
        if let Some(height) = self.too_deep(from, modal)
            && !std::mem::replace(&mut self.course.reported[1], true)
        {
            self.tell(block, Incident::DeeperThanCuttingEdge(height));
        }
    }

    /// Whether a height is below the top of the blank.
    fn below(&self, height: Option<f64>) -> bool {
        height.is_some_and(|height| height < self.blank.high[2] - SKIN * self.unit)
    }

    /// How far the material is above the tool tip that a straight movement goes through, if that is more than its
    /// cutting edges are long.
    fn too_deep(&self, from: [Option<f64>; 3], modal: &Modal) -> Option<f64> {
        let edges = self.tools.as_ref()?.get(modal.loaded)?.cutting_length.filter(|edges| *edges > 0.0)?;
        let ([Some(a), Some(b), Some(c)], [Some(x), Some(y), Some(z)]) = (from, self.at) else { return None };
        if self.open || (a, b) == (x, y) {
            return None;
        }
        let (begin, to) = ([a, b, c], [x, y, z]);
        let (first, last) = self.clipped(begin, to, -SKIN)?;
        let covers = |cut: &&Cut, place: [f64; 3]| {
            (0..2).all(|axis| cut.low[axis] <= place[axis] && place[axis] <= cut.high[axis])
        };
        let above = (0..=SAMPLES).map(|step| {
            let part = first + (last - first) * f64::from(step) / f64::from(SAMPLES);
            let place = [0, 1, 2].map(|axis| begin[axis] + (to[axis] - begin[axis]) * part);
            let floors = self.cuts.iter().filter(|cut| covers(cut, place)).map(|cut| cut.floor);
            floors.fold(self.blank.high[2], f64::min) - place[2]
        });
        // Near its end a movement may have come into what was cut: all places count that nothing covers.
        let above = above.fold(f64::NEG_INFINITY, f64::max);
        (above > edges + SKIN * self.unit).then_some(above)
    }
}
