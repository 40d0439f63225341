//! Triangulated surfaces from STL files, binary and as text.
//!
//! Invariant: what is read is bounded ([`MOST_BYTES`]), a number is finite and within [`FARTHEST`], and whatever else a
//! file holds is a mistake with its place: in a text the word, in a binary file the triangle.
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::base::diag::{Arg, Diagnostic, Place, Source};
use crate::engine::read::Reader;
use crate::engine::solid::{Mesh, Shape};
use crate::spec::Node;

/// All STL files of a scene together may have so many bytes.
const MOST_BYTES: u64 = 128 << 20;
/// No coordinate of a part is farther from its origin, mm.
const FARTHEST: f64 = 1e6;
/// Bytes before the triangles of a binary file; the last four of them say how many there are.
const HEAD: usize = 84;
/// Bytes of a triangle: a normal, three corners, two bytes without a meaning.
const TRIANGLE: usize = 50;

/// Files beside a scene. A scene can name them if there are any.
pub trait Beside {
    /// How many bytes a file has, if that is known; the name is as the scene has it.
    fn size(&self, name: &str) -> Option<u64>;

    /// What is in a file.
    ///
    /// # Errors
    /// It cannot be read.
    fn bytes(&self, name: &str) -> Result<Vec<u8>, Diagnostic>;
}

/// The STL files that the parts of a scene name.
pub(super) struct Models<'m> {
    beside: Option<&'m dyn Beside>,
    left: u64,
    known: Vec<(String, Option<Arc<Mesh>>)>,
}

/// What is wrong with a file.
enum Wrong {
    /// In a text: where, and what should be there.
    Word(Range<usize>, &'static str),
    /// In a binary file: the triangle of a coordinate that is no number, or too great.
    Number(usize),
    /// A binary file is not as long as its number of triangles says.
    Length(usize),
}

type Corners = [DVec3; 3];

impl<'m> Models<'m> {
    pub(super) const fn new(beside: Option<&'m dyn Beside>) -> Self {
        Self { beside, left: MOST_BYTES, known: Vec::new() }
    }

    /// `stl: part.stl`
    pub(super) fn shape(&mut self, node: &Node, r: &mut Reader<'_>) -> Option<Shape> {
        let name = r.text(node)?;
        if let Some((_, mesh)) = self.known.iter().find(|(known, _)| known == name) {
            return mesh.clone().map(Shape::Mesh);
        }
        let mesh = self.read(name, node, r).map(Arc::new);
        self.known.push((name.to_owned(), mesh.clone()));
        mesh.map(Shape::Mesh)
    }

    fn read(&mut self, name: &str, node: &Node, r: &mut Reader<'_>) -> Option<Mesh> {
        let Some(beside) = self.beside else { return refused(name, "nowhere", 0, node, r) };
        if beside.size(name).is_some_and(|size| size > self.left) {
            return refused(name, "large", 0, node, r);
        }
        let bytes = match beside.bytes(name) {
            Ok(bytes) => bytes,
            Err(diagnostic) => {
                r.found.push(Diagnostic { place: Some(Place::new(r.source, node.span)), ..diagnostic });
                return None;
            }
        };
        let Some(left) = self.left.checked_sub(bytes.len() as u64) else { return refused(name, "large", 0, node, r) };
        self.left = left;
        match triangles(&bytes) {
            Ok(mut corners) => {
                corners.iter_mut().flatten().for_each(|corner| *corner *= r.scale);
                Mesh::new(&corners).or_else(|| refused(name, "empty", 0, node, r))
            }
            Err(Wrong::Number(triangle)) => refused(name, "number", triangle, node, r),
            Err(Wrong::Length(count)) => refused(name, "length", count, node, r),
            Err(Wrong::Word(at, wanted)) => {
                r.found.push(word(name, &bytes, at, wanted));
                None
            }
        }
    }
}

/// Reports why a file is no part: `kind` selects the words of the message.
fn refused<T>(name: &str, kind: &'static str, triangle: usize, node: &Node, r: &mut Reader<'_>) -> Option<T> {
    let most = (MOST_BYTES >> 20) as usize;
    let args = [("kind", Arg::from(kind)), ("triangle", triangle.into()), ("most", most.into())];
    r.report("scene-stl", node, [("file", Arg::from(name))].into_iter().chain(args).collect());
    None
}

/// The finding of a wrong word, in the file itself.
fn word(name: &str, bytes: &[u8], at: Range<usize>, wanted: &'static str) -> Diagnostic {
    let text = |range: Range<usize>| String::from_utf8_lossy(bytes.get(range).unwrap_or_default()).into_owned();
    let (before, found, after) = (text(0..at.start), text(at.clone()), text(at.end..bytes.len()));
    let span = before.len()..before.len() + found.len();
    let source = Source::new(name, format!("{before}{found}{after}"));
    let shown: String = found.chars().take(40).collect();
    Diagnostic::error("scene-stl-word", Place::new(&source, span)).arg("wanted", wanted).arg("found", shown)
}

/// The triangles of a file.
fn triangles(bytes: &[u8]) -> Result<Vec<Corners>, Wrong> {
    let count = bytes.get(HEAD - 4..HEAD).and_then(|four| <[u8; 4]>::try_from(four).ok()).map(u32::from_le_bytes);
    let count = count.map(|count| count as usize);
    let whole = count.and_then(|count| count.checked_mul(TRIANGLE)?.checked_add(HEAD));
    // Binary files may begin like texts, but have the length that their number of triangles says.
    match count {
        Some(_) if whole == Some(bytes.len()) => binary(bytes.get(HEAD..).unwrap_or_default()),
        Some(count) if !is_text(bytes) => Err(Wrong::Length(count)),
        _ => text(bytes),
    }
}

/// Whether a file is a text: it begins with the word, and has no byte that texts never have.
fn is_text(bytes: &[u8]) -> bool {
    let begin = bytes.trim_ascii_start().get(..5).unwrap_or_default();
    begin.eq_ignore_ascii_case(b"solid") && !bytes.contains(&0)
}

fn sound(value: f64) -> bool {
    value.is_finite() && value.abs() <= FARTHEST
}

fn binary(bytes: &[u8]) -> Result<Vec<Corners>, Wrong> {
    let one = |(index, triangle): (usize, &[u8])| {
        let mut numbers = triangle.chunks_exact(4).filter_map(|four| <[u8; 4]>::try_from(four).ok());
        let mut number = || numbers.next().map_or(0.0, |four| f64::from(f32::from_le_bytes(four)));
        let mut vector = || DVec3::new(number(), number(), number());
        let [_normal, a, b, c] = [vector(), vector(), vector(), vector()];
        let corners = [a, b, c];
        let known = corners.iter().all(|corner| corner.to_array().into_iter().all(sound));
        known.then_some(corners).ok_or(Wrong::Number(index + 1))
    };
    bytes.chunks_exact(TRIANGLE).enumerate().map(one).collect()
}

/// The words of a text with their places.
struct Words<'t> {
    bytes: &'t [u8],
    at: usize,
}

impl<'t> Words<'t> {
    fn rest(&self) -> &'t [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// The next word; at the end of the text it is empty.
    fn next(&mut self) -> (Range<usize>, &'t [u8]) {
        self.at += self.rest().len() - self.rest().trim_ascii_start().len();
        let rest = self.rest();
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let place = self.at..self.at + length;
        self.at += length;
        (place, rest.get(..length).unwrap_or_default())
    }

    fn wanted(&mut self, word: &'static str) -> Result<(), Wrong> {
        let (place, found) = self.next();
        if found.eq_ignore_ascii_case(word.as_bytes()) { Ok(()) } else { Err(Wrong::Word(place, word)) }
    }

    /// The name of a solid takes the rest of the line.
    fn skip_line(&mut self) {
        self.at += self.rest().iter().position(|byte| *byte == b'\n').unwrap_or(self.rest().len());
    }

    fn corner(&mut self) -> Result<DVec3, Wrong> {
        self.wanted("vertex")?;
        let mut number = || {
            let (place, found) = self.next();
            let number = std::str::from_utf8(found).ok().and_then(|word| word.parse::<f64>().ok());
            number.filter(|number| sound(*number)).ok_or(Wrong::Word(place, "number"))
        };
        Ok(DVec3::new(number()?, number()?, number()?))
    }
}

fn text(bytes: &[u8]) -> Result<Vec<Corners>, Wrong> {
    let mut words = Words { bytes, at: 0 };
    let mut all = Vec::new();
    words.wanted("solid")?;
    words.skip_line();
    loop {
        let (place, word) = words.next();
        if word.eq_ignore_ascii_case(b"endsolid") {
            words.skip_line();
            // Some programs write several solids into one file.
            match words.next() {
                (_, b"") => return Ok(all),
                (_, word) if word.eq_ignore_ascii_case(b"solid") => words.skip_line(),
                (place, _) => return Err(Wrong::Word(place, "solid")),
            }
            continue;
        }
        if !word.eq_ignore_ascii_case(b"facet") {
            return Err(Wrong::Word(place, "facet"));
        }
        words.wanted("normal")?;
        // What it says follows from the corners.
        (0..3).for_each(|_| _ = words.next());
        words.wanted("outer")?;
        words.wanted("loop")?;
        all.push([words.corner()?, words.corner()?, words.corner()?]);
        words.wanted("endloop")?;
        words.wanted("endfacet")?;
    }
}
