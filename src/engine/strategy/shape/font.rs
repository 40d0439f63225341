//! The font of engraved texts: one stroke wide, each character of its own width.
//!
//! Characters are drawn on a grid: the baseline is at 4, capitals reach up to 16, small letters to 12, descenders down
//! to 0. A stroke is a list of places of two digits to the base 36, main and minor coordinate; before a place `+` and `-`
//! lead there on a quarter circle counter-clockwise and clockwise, `(` and `)` on half a circle.
use glam::DVec2;

use crate::engine::region::{Edge, Way};

/// From the baseline to the top of capitals.
pub(super) const CAPITAL: f64 = 12.0;
/// The space between two characters.
pub(super) const GAP: f64 = 3.0;
/// The width of a blank.
pub(super) const BLANK: f64 = 6.0;
/// From a line to the next one.
pub(super) const LINE: f64 = 20.0;
/// A tabulator leads to a multiple of so many characters of the width of most capitals.
pub(super) const TABULATOR: f64 = 8.0 * (8.0 + GAP);
/// Where the baseline is on the grid.
const BASELINE: f64 = 4.0;

/// Each character with its width and its strokes.
const GLYPHS: &[(char, u8, &str)] = &[
    ('A', 8, "044g84 1777"),
    ('B', 8, "040g5g)5a0a 5a)5404"),
    ('C', 8, "8c+4g+0c08+44+88"),
    ('D', 8, "040g4g-8c88-4404"),
    ('E', 8, "8g0g0484 0a6a"),
    ('F', 8, "8g0g04 0a6a"),
    ('G', 8, "8c+4g+0c08+44+888a5a"),
    ('H', 8, "040g 848g 0a8a"),
    ('I', 0, "040g"),
    ('J', 6, "6g67-34-07"),
    ('K', 8, "040g 8g08 3b84"),
    ('L', 8, "0g0484"),
    ('M', 10, "040g58aga4"),
    ('N', 8, "040g848g"),
    ('O', 8, "4g+0c08+44+888c+4g"),
    ('P', 8, "040g5g)5a0a"),
    ('Q', 8, "4g+0c08+44+888c+4g 5784"),
    ('R', 8, "040g5g)5a0a 4a84"),
    ('S', 8, "8d+5g3g(3a5a)5434-07"),
    ('T', 8, "4g44 0g8g"),
    ('U', 8, "0g08+44+888g"),
    ('V', 8, "0g448g"),
    ('W', 12, "0g346c94cg"),
    ('X', 8, "048g 0g84"),
    ('Y', 8, "0g4a8g 4a44"),
    ('Z', 8, "0g8g0484"),
    ('a', 6, "69+3c+0907+34+67 6c64"),
    ('b', 6, "0g04 07+34+6769+3c+09"),
    ('c', 6, "69+3c+0907+34+67"),
    ('d', 6, "69+3c+0907+34+67 6g64"),
    ('e', 6, "086869+3c+0907+3454"),
    ('f', 5, "5g+2d24 0c4c"),
    ('g', 6, "69+3c+0907+34+67 6c63-3010"),
    ('h', 6, "0g04 09-3c-6964"),
    ('i', 0, "0c04 0f0g"),
    ('j', 3, "3c33-00 3f3g"),
    ('k', 6, "0g04 6c06 2864"),
    ('l', 2, "0g06+24"),
    ('m', 8, "0c04 0a-2c-4a44 4a-6c-8a84"),
    ('n', 6, "0c04 09-3c-6964"),
    ('o', 6, "3c+0907+34+6769+3c"),
    ('p', 6, "0c00 07+34+6769+3c+09"),
    ('q', 6, "69+3c+0907+34+67 6c60"),
    ('r', 4, "0c04 09-3c4c"),
    ('s', 6, "6a+4c2c(2848)4424-06"),
    ('t', 4, "2g26+44 0c4c"),
    ('u', 6, "0c07+34+67 6c64"),
    ('v', 6, "0c346c"),
    ('w', 8, "0c244c648c"),
    ('x', 6, "046c 0c64"),
    ('y', 6, "0c07+34+67 6c63-3010"),
    ('z', 6, "0c6c0464"),
    ('0', 8, "4g+0c08+44+888c+4g 266e"),
    ('1', 4, "0c4g44"),
    ('2', 8, "0c-4g-8c0484"),
    ('3', 8, "0g8g4a5a)5434-07"),
    ('4', 8, "646g0888"),
    ('5', 8, "8g0g0a5a)5434-07"),
    ('6', 8, "6g+0a08+44+88+4c+08"),
    ('7', 8, "0g8g34"),
    ('8', 8, "4g(4a)44)4a(4g"),
    ('9', 8, "24+8a8c+4g+0c+48+8c"),
    ('!', 0, "0g08 0504"),
    ('#', 8, "242g 646g 0888 0c8c"),
    ('$', 8, "8d+5g3g(3a5a)5434-07 4h43"),
    ('%', 8, "048g 2g(2c(2g 68(64(68"),
    ('&', 8, "841c1e3g5e5c0806245488"),
    ('\'', 0, "0g0d"),
    ('(', 3, "3g+34"),
    (')', 3, "0g-04"),
    ('*', 6, "3d37 0c68 086c"),
    ('+', 8, "4e46 0a8a"),
    (',', 1, "1502"),
    ('-', 6, "0a6a"),
    ('.', 0, "0504"),
    ('/', 6, "046g"),
    (':', 0, "0504 0c0b"),
    (';', 1, "1c1b 1502"),
    ('<', 6, "6e0a66"),
    ('=', 6, "0c6c 0868"),
    ('>', 6, "0e6a06"),
    ('?', 8, "0c-4g-8c-4847 4544"),
    ('@', 10, "7a+5c+3a+58+7a 7c78a8aa+5f+0a+5585"),
    ('[', 3, "3g0g0434"),
    ('\\', 6, "0g64"),
    (']', 3, "0g3g3404"),
    ('_', 8, "0282"),
];

/// A character of the font.
pub struct Glyph {
    /// From its left to its right.
    pub width: f64,
    /// Its strokes from the baseline at its left; none of a blank.
    pub strokes: Vec<Way>,
}

/// All characters but the blank, in the order of the table.
pub fn characters() -> impl Iterator<Item = char> {
    GLYPHS.iter().map(|(character, ..)| *character)
}

/// A character; nothing if the font does not have it.
pub fn glyph(character: char) -> Option<Glyph> {
    if character == ' ' {
        return Some(Glyph { width: BLANK, strokes: Vec::new() });
    }
    let (_, width, strokes) = GLYPHS.iter().find(|(own, ..)| *own == character)?;
    Some(Glyph { width: f64::from(*width), strokes: strokes.split(' ').map(stroke).collect() })
}

/// The way of a stroke.
fn stroke(text: &str) -> Way {
    let mut way: Option<Way> = None;
    let mut signs = text.chars();
    let mut sweep = 0.0;
    while let Some(sign) = signs.next() {
        match sign {
            '+' => sweep = 90.0,
            '-' => sweep = -90.0,
            '(' => sweep = 180.0,
            ')' => sweep = -180.0,
            _ => {
                let digit = |sign: char| f64::from(sign.to_digit(36).unwrap_or_default());
                let to = DVec2::new(digit(sign), signs.next().map_or(BASELINE, digit) - BASELINE);
                match &mut way {
                    None => way = Some(Way { start: to, edges: Vec::new() }),
                    Some(way) => way.edges.push(edge(way.end(), to, sweep)),
                }
                sweep = 0.0;
            }
        }
    }
    way.unwrap_or_default()
}

/// A line, or an arc of a quarter or half a turn.
fn edge(from: DVec2, to: DVec2, sweep: f64) -> Edge {
    if sweep == 0.0 {
        return Edge::Line(to);
    }
    // The centre is beside the middle of the chord: by half of it for a quarter turn, by nothing for half a turn.
    let beside = if sweep.abs() > 90.0 { 0.0 } else { 0.5 * sweep.signum() };
    Edge::Arc { to, centre: from.midpoint(to) + (to - from).perp() * beside, sweep }
}
