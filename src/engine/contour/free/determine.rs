//! What several data determine together: lines and circles from the conditions on them, points from the lines and circles
//! on which they lie. Each solution is a state of its own.
use std::cmp::Ordering;

use glam::DVec2;

use super::curve::{AGREE, Circles, Contact, Curve, Locus, line_along, lines};
use super::state::{Choice, Joint, Known, State};
use super::system::Solution;
use super::{Given, MOST_SOLUTIONS};
use crate::base::expr::{cosd, sind};
use crate::engine::contour::element::turn_between;
use crate::engine::geometry::left_of;

/// Both signs, or the one that is given.
const fn signs(open: bool) -> &'static [f64] {
    if open { &[1.0, -1.0] } else { &[1.0] }
}

/// What was determined.
enum Determined {
    /// The line or circle of an element.
    Curve(usize, Curve),
    /// Points from one on.
    Points(usize, Vec<DVec2>),
    /// What several open elements determine together.
    System(Solution),
}

/// In which ways the data of an element leave signs open.
fn choices(own: &Given) -> Vec<Choice> {
    let turns: &[f64] = match (own.is_arc, own.counter_clockwise) {
        (true, None) => &[1.0, -1.0],
        (true, Some(false)) => &[-1.0],
        _ => &[1.0],
    };
    let far = own.parallel.is_some_and(|(_, far)| far.is_some_and(|far| far > 0.0));
    let mut choices = Vec::with_capacity(2);
    for turn in turns {
        for side in signs(own.beside.is_some_and(|(_, far)| far > 0.0)) {
            for along in signs(own.parallel.is_some() && own.heading.is_none()) {
                for aside in signs(far) {
                    choices.push(Choice { turn: *turn, side: *side, along: *along, aside: *aside });
                }
            }
        }
    }
    choices
}

/// A line on which a point lies by its data.
fn along_axis(point: DVec2, along: DVec2) -> Locus {
    Locus::Line { point, along, of_element: false }
}

impl State {
    /// The states with the next element, each with all that can be calculated then.
    pub(super) fn with(self, given: &[Given], element: usize, found: &mut Vec<Self>) {
        let Some(own) = given.get(element) else { return };
        let since = self.first;
        let mut choices = choices(own);
        let last = choices.pop();
        for choice in choices {
            self.clone().and(choice).settle(given, since, found);
        }
        if let Some(choice) = last {
            self.and(choice).settle(given, since, found);
        }
    }

    /// With another element.
    fn and(mut self, choice: Choice) -> Self {
        self.elements.push(Known { choice, curve: None, leaving: None, radius: None, sweep: None });
        self.joints.push(Joint::default());
        self
    }

    /// Calculates what can be calculated; keeps what agrees with all data since an element.
    fn settle(mut self, given: &[Given], since: usize, found: &mut Vec<Self>) {
        loop {
            while self.learn(given) {}
            let next = self.determined(given).or_else(|| self.determined_together(given));
            match next.as_deref() {
                None => break,
                Some([only]) => {
                    if !self.takes(given, only) {
                        return;
                    }
                }
                Some(solutions) => {
                    for solution in solutions {
                        let mut state = self.clone();
                        if found.len() <= MOST_SOLUTIONS && state.takes(given, solution) {
                            state.settle(given, since, found);
                        }
                    }
                    return;
                }
            }
        }
        if (since..self.elements.len()).all(|i| self.holds(given, i)) {
            found.push(self);
        }
    }

    /// Takes in what was determined; whether the data of its elements agree.
    fn takes(&mut self, given: &[Given], solution: &Determined) -> bool {
        match solution {
            Determined::Curve(i, curve) => {
                self.elements[*i].curve = Some(*curve);
                self.holds(given, *i)
            }
            Determined::Points(first, points) => {
                for (at, own) in points.iter().zip(&mut self.joints[*first..]) {
                    own.at = Some(*at);
                }
                let last = (first + points.len()).min(self.elements.len());
                (first.saturating_sub(1)..last).all(|i| self.holds(given, i))
            }
            Determined::System(solution) => {
                *self = self.with_solution(solution);
                (self.first..self.elements.len()).all(|i| self.holds(given, i))
            }
        }
    }

    /// What open elements determine together where none is determined by itself.
    fn determined_together(&self, given: &[Given]) -> Option<Vec<Determined>> {
        Some(self.system(given)?.into_iter().map(Determined::System).collect())
    }

    /// The next thing that data determine, in each of its solutions.
    fn determined(&self, given: &[Given]) -> Option<Vec<Determined>> {
        let elements = self.first..self.elements.len();
        for i in elements.clone().filter(|i| self.elements[*i].curve.is_none()) {
            let Some(own) = given.get(i) else { continue };
            let curves = if own.is_arc { self.circle(given, own, i) } else { self.line(given, own, i) };
            if let Some(curves) = curves {
                return Some(curves.into_iter().map(|curve| Determined::Curve(i, curve)).collect());
            }
        }
        let mut joint = elements.start;
        while joint <= elements.end {
            let run = self.rigid(given, joint);
            if let Some(points) = self.points(given, joint, &run) {
                let placed = |at: DVec2| Determined::Points(joint, run.iter().map(|offset| at + *offset).collect());
                return Some(points.into_iter().map(placed).collect());
            }
            joint += run.len();
        }
        None
    }

    /// What an element touches or passes; a neighbour that it touches at a known point gives its direction there.
    fn contacts(&self, given: &[Given], own: &Given, i: usize) -> Vec<Contact> {
        let (start, end) = (self.at(i), self.at(i + 1));
        let known = &self.elements[i];
        let mut contacts: Vec<Contact> = Vec::new();
        let from_start = own.is_arc && start.is_some() && known.leaving.is_some();
        contacts.extend(start.filter(|_| !from_start).map(Contact::point));
        let before = if own.is_tangential && start.is_none() { i.checked_sub(1) } else { None };
        contacts.extend(before.and_then(|before| self.curve(before)).map(Contact));
        contacts.extend(own.on.iter().copied().map(Contact::point));
        contacts.extend(own.beside.map(|(at, far)| Contact::aside(at, far.abs() * known.choice.side)));
        let to_end = own.is_arc && end.is_some() && self.arriving(i + 1).is_some();
        contacts.extend(end.filter(|_| !to_end).map(Contact::point));
        let after = given.get(i + 1).is_some_and(|next| next.is_tangential) && end.is_none();
        contacts.extend(self.curve(i + 1).filter(|_| after).map(Contact));
        contacts
    }

    fn line(&self, given: &[Given], own: &Given, i: usize) -> Option<Vec<Curve>> {
        let contacts = self.contacts(given, own, i);
        // A line that touches a line is the same one.
        if let Some(Contact(line)) = contacts.iter().find(|contact| matches!(contact.0, Curve::Line { .. })) {
            return Some(vec![*line]);
        }
        let Some(leaving) = self.elements[i].leaving else {
            let pairs = contacts.iter().enumerate().flat_map(|(at, a)| contacts[at + 1..].iter().map(move |b| (a, b)));
            return pairs.into_iter().find_map(|(a, b)| lines(a, b));
        };
        let choice = self.elements[i].choice;
        let parallel = own.parallel.and_then(|(joint, far)| match self.curve(joint.checked_sub(1)?)? {
            Curve::Line { point, along } => {
                Some(Curve::Line { point: point + left_of(along) * (far? * choice.aside), along: leaving })
            }
            Curve::Circle { .. } => None,
        });
        let curve = parallel.or_else(|| contacts.iter().find_map(|contact| line_along(leaving, contact)))?;
        Some(vec![curve])
    }

    fn circle(&self, given: &[Given], own: &Given, i: usize) -> Option<Vec<Curve>> {
        let known = self.elements[i];
        let (start, end) = (self.at(i), self.at(i + 1));
        let mut circles = Circles::default();
        if let Some(radius) = known.radius {
            circles.radius(radius);
        }
        let [x, y, radius, angle] = self.given(&own.centre, own.pole);
        let pole = own.pole.unwrap_or_default();
        let mut lines = Vec::with_capacity(3);
        lines.extend(x.map(|x| along_axis(DVec2::new(x, 0.0), DVec2::Y)));
        lines.extend(y.map(|y| along_axis(DVec2::new(0.0, y), DVec2::X)));
        lines.extend(angle.map(|angle| along_axis(pole, DVec2::new(cosd(angle), sind(angle)))));
        for locus in &lines {
            if let Locus::Line { point, along, .. } = locus {
                let across = left_of(*along);
                circles.row([across.x, across.y, 0.0], across.dot(*point));
            }
        }
        let about = radius.map(|radius| Locus::Circle { centre: pole, radius });
        if let Some(Locus::Circle { centre, radius }) = about {
            circles.centre_on(centre, radius);
        }
        if let Some((at, heading)) = start.zip(known.leaving) {
            circles.passes(at, heading);
        }
        if let Some((at, heading)) = end.zip(self.arriving(i + 1)) {
            circles.passes(at, heading);
        }
        for contact in self.contacts(given, own, i) {
            circles.contact(&contact);
        }
        let turn = known.choice.turn;
        // A distance from the pole and one other coordinate give the centre, or two of them.
        let mut centres = about.zip(lines.first()).and_then(|(about, line)| line.meets(&about)).unwrap_or_default();
        centres.retain(|at| self.agrees(&own.centre, own.pole, *at));
        let mut found = if about.is_some() && !lines.is_empty() {
            let at = |centre: DVec2| circles.about(centre).solve();
            centres.into_iter().map(at).collect::<Option<Vec<_>>>()?.concat()
        } else {
            circles.solve()?
        };
        found.retain(|curve| matches!(curve, Curve::Circle { radius, .. } if radius * turn > 0.0));
        // The smaller one first, then the one whose arc is the shorter.
        let way = start.zip(end).map(|(start, end)| end - start);
        found.sort_by(|a, b| {
            let (Curve::Circle { centre: m, radius: r }, Curve::Circle { centre: n, radius: s }) = (a, b) else {
                return Ordering::Equal;
            };
            if (r.abs() - s.abs()).abs() > AGREE {
                return r.abs().total_cmp(&s.abs());
            }
            let left = |centre: &DVec2| way.map_or(0.0, |way| way.perp_dot(*centre) * turn);
            left(n).total_cmp(&left(m))
        });
        Some(found)
    }

    /// The points from one on whose distances are known, with what they are away from it.
    fn rigid(&self, given: &[Given], joint: usize) -> Vec<DVec2> {
        let mut run = vec![DVec2::ZERO];
        let mut at = joint;
        while at < self.elements.len()
            && let Some(way) = given.get(at).and_then(|own| self.displacement(own, at))
        {
            run.push(run.last().copied().unwrap_or_default() + way);
            at += 1;
        }
        run
    }

    /// Where the first of points can be whose distances are known; nothing where it is known, or not yet determined.
    fn points(&self, given: &[Given], joint: usize, run: &[DVec2]) -> Option<Vec<DVec2>> {
        if (joint..joint + run.len()).any(|joint| self.at(joint).is_some()) {
            return None;
        }
        let (mut of_data, mut of_curves, mut of_chords) = (Vec::new(), Vec::new(), Vec::new());
        for (joint, offset) in (joint..).zip(run) {
            of_data.extend(self.loci_of_data(given, joint).into_iter().map(|locus| locus.moved(-*offset)));
            let curves = [joint.checked_sub(1).and_then(|before| self.curve(before)), self.curve(joint)];
            of_curves.extend(curves.into_iter().flatten().map(|curve| curve.locus().moved(-*offset)));
            of_chords.extend(self.loci_of_chords(joint).map(|locus| locus.moved(-*offset)));
        }
        let loci: Vec<Locus> = of_data.into_iter().chain(of_curves).chain(of_chords).collect();
        if let Some(Locus::Point(at)) = loci.iter().find(|locus| matches!(locus, Locus::Point(_))) {
            return Some(vec![*at]);
        }
        let mut pairs = loci.iter().enumerate().flat_map(|(at, a)| loci[at + 1..].iter().map(move |b| (a, b)));
        let (found, mut points) = pairs.find_map(|(a, b)| Some(((a, b), a.meets(b)?)))?;
        self.order(&mut points, found, joint);
        Some(points)
    }

    /// On a line of the contour the point that comes later comes first, on an arc whose beginning is known the one that
    /// comes earlier.
    fn order(&self, points: &mut [DVec2], (a, b): (&Locus, &Locus), joint: usize) {
        let line = |locus: &Locus| match *locus {
            Locus::Line { along, of_element: true, .. } => Some(along),
            _ => None,
        };
        if let Some(along) = line(a).or_else(|| line(b)) {
            points.sort_by(|p, q| along.dot(*q).total_cmp(&along.dot(*p)));
            return;
        }
        let Some(before) = joint.checked_sub(1) else { return };
        if let (Some(Curve::Circle { centre, radius }), Some(start)) = (self.curve(before), self.at(before)) {
            let swept = |at: &DVec2| turn_between(start - centre, *at - centre, radius.signum());
            points.sort_by(|p, q| swept(p).total_cmp(&swept(q)));
        }
    }

    /// Where the end of an element can be by what is given of it.
    fn loci_of_data(&self, given: &[Given], joint: usize) -> Vec<Locus> {
        let mut loci = Vec::new();
        let before = joint.checked_sub(1).and_then(|before| given.get(before).map(|own| (before, own)));
        if let Some((before, own)) = before {
            let [x, y, radius, angle] = self.given(&own.end, own.pole);
            let pole = own.pole.unwrap_or_default();
            loci.extend(x.map(|x| along_axis(DVec2::new(x, 0.0), DVec2::Y)));
            loci.extend(y.map(|y| along_axis(DVec2::new(0.0, y), DVec2::X)));
            loci.extend(radius.map(|radius| Locus::Circle { centre: pole, radius }));
            loci.extend(angle.map(|angle| along_axis(pole, DVec2::new(cosd(angle), sind(angle)))));
            loci.extend(own.length.zip(self.at(before)).map(|(radius, centre)| Locus::Circle { centre, radius }));
        }
        // Back from the end of the element that begins there.
        let after = given.get(joint).and_then(|own| own.length).zip(self.at(joint + 1));
        loci.extend(after.map(|(radius, centre)| Locus::Circle { centre, radius }));
        loci
    }

    /// Where the end of an element can be by the angle and the radius of the arcs on both sides, whose circles are open: on
    /// a circle about their other end.
    fn loci_of_chords(&self, joint: usize) -> impl Iterator<Item = Locus> {
        let before = joint.checked_sub(1).and_then(|before| self.chord(before).zip(self.at(before)));
        let after = self.chord(joint).zip(self.at(joint + 1));
        before.into_iter().chain(after).map(|(radius, centre)| Locus::Circle { centre, radius })
    }

    /// How far the ends of an arc are from each other whose radius and angle are known, but not its circle.
    fn chord(&self, i: usize) -> Option<f64> {
        let Known { curve: None, radius, sweep, .. } = self.elements.get(i)? else { return None };
        Some((2.0 * (*radius)? * sind((*sweep)? / 2.0)).abs()).filter(|chord| *chord > AGREE)
    }
}
