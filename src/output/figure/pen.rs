//! Marks on paper: SVG elements in pixels, and which stretches of the sheet texts have taken.
//!
//! Invariant: the same strokes give the same bytes; no element has an id and no style, so figures can stand side by side.
use std::fmt::Write as _;

use glam::DVec2;

/// The height of a label.
pub(super) const FONT: f64 = 12.0;
/// The length of an arrowhead.
pub(super) const ARROW: f64 = 7.0;

/// A rectangle with sides along the edges of the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rect {
    pub(super) min: DVec2,
    pub(super) max: DVec2,
}

impl Rect {
    pub(super) fn around(centre: DVec2, size: DVec2) -> Self {
        Self { min: centre - size / 2.0, max: centre + size / 2.0 }
    }

    pub(super) fn meets(&self, other: &Self) -> bool {
        self.min.x < other.max.x && other.min.x < self.max.x && self.min.y < other.max.y && other.min.y < self.max.y
    }

    /// The rectangle with so much more around it.
    pub(super) fn grown(&self, by: f64) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    pub(super) fn holds(&self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    fn inside(&self, outer: &Self) -> bool {
        outer.holds(self.min) && outer.holds(self.max)
    }
}

/// The distance of the lines of a label.
const LINE: f64 = 13.0;

/// How high a label is.
pub(super) fn height(text: &str) -> f64 {
    FONT + LINE * text.matches('\n').count() as f64
}

/// About how wide a text is in a sans-serif type, on the safe side: its widest line.
pub(super) fn width(text: &str) -> f64 {
    text.split('\n').map(line_width).fold(0.0, f64::max)
}

fn line_width(text: &str) -> f64 {
    let em: f64 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '!' | '\'' | ' ' => 0.33,
            'f' | 't' | 'r' | '-' | '(' | ')' => 0.42,
            'm' | 'w' | 'M' | 'W' | '\u{2300}' => 0.95,
            c if c.is_uppercase() => 0.75,
            _ => 0.6,
        })
        .sum();
    em * FONT
}

/// A coordinate with one place, without what is not needed.
pub(super) fn short(value: f64) -> String {
    let mut out = String::new();
    tenth(tenths(value), &mut out);
    out
}

/// The number of tenths that is nearest.
fn tenths(value: f64) -> i64 {
    (value * 10.0).round() as i64
}

/// Writes a number of tenths, without what is not needed.
fn tenth(value: i64, out: &mut String) {
    let (whole, rest) = (value.unsigned_abs() / 10, value.unsigned_abs() % 10);
    let mut digits = itoa::Buffer::new();
    if value < 0 {
        out.push('-');
    }
    if whole > 0 || rest == 0 {
        out.push_str(digits.format(whole));
    }
    if rest > 0 {
        out.push('.');
        out.push_str(digits.format(rest));
    }
}

/// Writes two numbers of tenths; a sign parts them as well as a blank.
fn pair([x, y]: [i64; 2], out: &mut String) {
    tenth(x, out);
    if y >= 0 {
        out.push(' ');
    }
    tenth(y, out);
}

/// A sheet with what is drawn on it so far.
#[derive(Clone, Debug)]
pub(super) struct Pen {
    /// The elements.
    pub(super) body: String,
    /// Where texts are.
    pub(super) texts: Vec<Rect>,
    /// Where no text should be.
    pub(super) blocked: Vec<Rect>,
    /// The edges of the sheet.
    pub(super) sheet: Rect,
}

impl Pen {
    pub(super) fn new(size: DVec2) -> Self {
        let sheet = Rect { min: DVec2::ZERO, max: size };
        Self { body: String::new(), texts: Vec::new(), blocked: Vec::new(), sheet }
    }

    /// The data of a path through points.
    pub(super) fn data(points: &[DVec2], closed: bool) -> String {
        let mut data = String::new();
        let mut last = None;
        for p in points {
            let place = [tenths(p.x), tenths(p.y)];
            if last == Some(place) {
                continue;
            }
            last = Some(place);
            data.push(if data.is_empty() { 'M' } else { 'L' });
            tenth(place[0], &mut data);
            data.push(' ');
            tenth(place[1], &mut data);
        }
        if closed {
            data.push('Z');
        }
        data
    }

    /// A closed outline by the differences between its places, which is shorter; nothing if they are all the same.
    pub(super) fn outline(points: &[DVec2]) -> String {
        let mut places = points.iter().map(|p| [p.x, p.y].map(tenths));
        let Some(first) = places.next() else { return String::new() };
        let (mut data, mut last) = ("M".to_owned(), first);
        pair(first, &mut data);
        for place in places {
            let way = [place[0] - last[0], place[1] - last[1]];
            last = place;
            match way {
                [0, 0] => {}
                [across, 0] => {
                    data.push('h');
                    tenth(across, &mut data);
                }
                [0, down] => {
                    data.push('v');
                    tenth(down, &mut data);
                }
                _ => {
                    data.push('l');
                    pair(way, &mut data);
                }
            }
        }
        if data.contains(['h', 'v', 'l']) { data + "Z" } else { String::new() }
    }

    pub(super) fn path(&mut self, class: &str, data: &str) {
        if data.contains('L') || data.contains('A') {
            let _ = writeln!(self.body, "<path class=\"{class}\" d=\"{data}\"/>");
        }
    }

    pub(super) fn line(&mut self, class: &str, points: &[DVec2]) {
        self.path(class, &Self::data(points, false));
    }

    pub(super) fn area(&mut self, class: &str, points: &[DVec2]) {
        self.path(class, &Self::data(points, true));
    }

    pub(super) fn circle(&mut self, class: &str, centre: DVec2, radius: f64) {
        let [x, y, r] = [centre.x, centre.y, radius].map(short);
        let _ = writeln!(self.body, "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
    }

    /// A filled arrowhead that points along `way`.
    pub(super) fn arrow(&mut self, class: &str, tip: DVec2, way: DVec2) {
        let way = way.normalize_or_zero();
        let back = tip - way * ARROW;
        let side = way.perp() * (ARROW * 0.32);
        self.area(class, &[tip, back + side, back - side]);
    }

    /// An arrowhead of two lines.
    pub(super) fn chevron(&mut self, class: &str, tip: DVec2, way: DVec2) {
        let way = way.normalize_or_zero();
        let back = tip - way * ARROW;
        let side = way.perp() * (ARROW * 0.5);
        self.line(class, &[back + side, tip, back - side]);
    }

    /// The sign of the datum: a circle with two of its quarters filled.
    pub(super) fn datum(&mut self, place: DVec2, radius: f64) {
        self.circle("z", place, radius);
        let r = short(radius);
        let quarter = |turn: f64| {
            let (a, b) = (place + DVec2::new(0.0, -radius * turn), place + DVec2::new(radius * turn, 0.0));
            format!("{}A{r} {r} 0 0 1 {} {}Z", Self::data(&[place, a], false), short(b.x), short(b.y))
        };
        self.path("q", &(quarter(1.0) + &quarter(-1.0)));
    }

    /// Lines from lower left to upper right inside closed lines: a line within another one is a hole.
    pub(super) fn hatch(&mut self, lines: &[Vec<DVec2>]) {
        const STEP: f64 = 7.0;
        let turned = |p: DVec2| p.x + p.y;
        let (low, high) = lines
            .iter()
            .flatten()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(turned(*p)), high.max(turned(*p))));
        if !(low < high) {
            return;
        }
        let mut data = String::new();
        let mut line = (low / STEP).ceil() * STEP + 0.35;
        while line < high {
            let mut crossings: Vec<DVec2> = Vec::new();
            for (a, b) in lines.iter().flat_map(|line| line.iter().zip(line.iter().cycle().skip(1))) {
                let (from, to) = (turned(*a) - line, turned(*b) - line);
                if (from < 0.0) != (to < 0.0) {
                    crossings.push(a.lerp(*b, from / (from - to)));
                }
            }
            crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
            for pair in crossings.chunks_exact(2).filter(|pair| (pair[0] - pair[1]).length() > 1.5) {
                data.push_str(&Self::data(pair, false));
            }
            line += STEP;
        }
        self.path("h", &data);
    }

    /// How much room a label takes.
    pub(super) fn size(text: &str) -> DVec2 {
        DVec2::new(width(text) + 4.0, height(text) + 2.0)
    }

    /// Whether a text may be there.
    pub(super) fn is_free(&self, rect: &Rect) -> bool {
        rect.inside(&self.sheet) && self.texts.iter().chain(&self.blocked).all(|other| !other.meets(rect))
    }

    /// Whether a text there would meet no other.
    fn is_clear(&self, rect: &Rect) -> bool {
        rect.inside(&self.sheet) && self.texts.iter().all(|other| !other.meets(rect))
    }

    /// The first of the places at which a text is free or, failing that, meets no other text; else one below all.
    pub(super) fn place(&self, text: &str, candidates: &[DVec2]) -> DVec2 {
        let size = Self::size(text);
        let rect = |centre: &&DVec2| Rect::around(**centre, size);
        let free = candidates.iter().find(|centre| self.is_free(&rect(centre)));
        let found = free.or_else(|| candidates.iter().find(|centre| self.is_clear(&rect(centre))));
        found.copied().unwrap_or_else(|| self.anywhere(size, candidates.first().copied().unwrap_or_default()))
    }

    /// The place nearest to a point at which a text of that size meets no other.
    fn anywhere(&self, size: DVec2, near: DVec2) -> DVec2 {
        let mut best = (f64::INFINITY, near);
        for column in 0..60 {
            for row in 0..80 {
                let centre = DVec2::new(f64::from(column), f64::from(row)) * 6.0;
                let away = (centre - near).length();
                if away < best.0 && self.is_clear(&Rect::around(centre, size)) {
                    best = (away, centre);
                }
            }
        }
        best.1
    }

    /// Writes a text with its middle there, on paper of its own.
    pub(super) fn text(&mut self, class: &str, text: &str, centre: DVec2) {
        let size = Self::size(text);
        let rect = Rect::around(centre, size);
        let [x, y, w, h] = [rect.min.x, rect.min.y, size.x, size.y].map(short);
        let _ = writeln!(self.body, "<rect class=\"b\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/>");
        let first = centre.y - (height(text) - FONT) / 2.0;
        for (n, line) in text.split('\n').enumerate() {
            let [x, y] = [centre.x, first + LINE * n as f64 + FONT * 0.36].map(short);
            let _ = writeln!(self.body, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\">{}</text>", escaped(line));
        }
        self.texts.push(rect);
    }
}

/// A text as XML has it.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
