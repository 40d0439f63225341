//! Strategies that engrave a text in a plane, along a line or an arc.
//!
//! A character that leaves a trace has a number, from 1. Along a line the text begins at the anchor and runs along the
//! main axis; on an arc the anchor is the centre, and the text reads clockwise with its feet on the arc and its middle at
//! the angle (TNC 640 manual, lines 7141-7230). The manual does not print the font: that is [`font`](super::font).
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::font::{self, BLANK, CAPITAL, GAP, LINE, TABULATOR};
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::WorkingPlane;
use crate::engine::region::{Edge, Way};
use crate::engine::report::fault::Fault;
use crate::engine::strategy::calculation::Calculation;
use crate::engine::strategy::contour::draw;
use crate::engine::strategy::milling::{Milling, shape_impossible, too_many};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::{results, strategy};

/// A text has at most so many characters.
const MOST: usize = 4096;
/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;

/// A character at its place.
struct Placed {
    strokes: Vec<Way>,
    /// Where its lower left corner is along the text and across it, in units of the font.
    place: DVec2,
    /// Its width.
    width: f64,
}

/// Declares a strategy of engraving: how the text is laid out, and what it is given besides.
macro_rules! engraving {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The text; `\n`, `\t` and `\v` are a new line and tabulators, `\\` and `%%` one sign.
                text: Arc<str> = Text,
                /// The height of capitals, mm.
                height: f64 = Length,
                /// By how much the spaces between characters are wider than usual, as a factor.
                spacing: f64 = Number,
                /// Where a text along a line begins, or the centre of an arc.
                anchor: DVec3 = Length,
                /// Whether it runs on an arc.
                on_arc: bool = Number,
                /// The angle of the middle of the text on the arc, degrees.
                rotation: f64 = Angle,
                /// The radius of the arc, mm.
                radius: f64 = Length,
                $($more)*
            }
        }

        impl $name {
            fn layout(&self) -> Layout<'_> {
                Layout {
                    text: &self.text,
                    scale: self.height / CAPITAL,
                    gap: GAP * (1.0 + self.spacing),
                    anchor: self.anchor.truncate(),
                    arc: self.on_arc.then_some((self.rotation, self.radius)),
                }
            }
        }
    };
}

engraving! {
    /// How many characters leave a trace.
    LayOutText = "lay-out-text" {
        /// Which font: there is one.
        font: f64 = Number,
    }
}

results! {
    /// A text that was laid out.
    TextLayout {
        /// How many characters leave a trace.
        count: f64 = Number,
    }
}

engraving! {
    /// Over the beginning of a character at the present height, at rapid traverse.
    MoveOverGlyph = "move-over-glyph" {
        /// Its number, from 1.
        number: f64 = Number,
    }
}

engraving! {
    /// Engraves a character, stroke after stroke.
    EngraveGlyph = "engrave-glyph" {
        /// Its number, from 1.
        number: f64 = Number,
        /// The height of the bottom, mm.
        level: f64 = Length,
        /// The height between strokes, mm.
        lifted: f64 = Length,
        /// The feed down to the bottom, mm/min.
        plunging_feed: f64 = Feed,
        /// The feed along the strokes, mm/min.
        at: f64 = Feed,
    }
}

/// How a text is laid out.
struct Layout<'t> {
    text: &'t str,
    /// mm in a unit of the font.
    scale: f64,
    /// The space between two characters in units of the font.
    gap: f64,
    anchor: DVec2,
    /// The angle of the middle and the radius of an arc.
    arc: Option<(f64, f64)>,
}

impl Layout<'_> {
    /// The characters that leave a trace, each with its strokes in mm.
    fn glyphs(&self) -> Result<Vec<Vec<Way>>, Fault> {
        if let Some((_, radius)) = self.arc
            && radius <= 0.0
        {
            return Err(shape_impossible(0.0, radius));
        }
        let (placed, length) = self.placed()?;
        Ok(placed
            .into_iter()
            .map(|own| own.strokes.iter().map(|way| self.moved(way, &own, length)).collect())
            .collect())
    }

    /// The characters along a straight line, and the length of the longest line.
    fn placed(&self) -> Result<(Vec<Placed>, f64), Fault> {
        let mut placed = Vec::new();
        let (mut at, mut longest) = (DVec2::ZERO, 0.0_f64);
        let mut signs = self.text.chars();
        while let Some(sign) = signs.next() {
            if placed.len() >= MOST {
                return Err(too_many(MOST as f64));
            }
            let unknown = |sign: String| Fault::program("character-unknown").arg("character", sign);
            let character = match sign {
                '%' if signs.as_str().starts_with('%') => signs.next(),
                '%' => return Err(unknown(sign.to_string())),
                '\\' => match signs.next() {
                    Some('\\') => Some('\\'),
                    Some('n') => {
                        at = DVec2::new(0.0, at.y - LINE);
                        None
                    }
                    Some('t') => {
                        at.x = (libm::floor(at.x / TABULATOR) + 1.0) * TABULATOR;
                        None
                    }
                    Some('v') => {
                        at.y -= LINE;
                        None
                    }
                    other => return Err(unknown(format!("\\{}", other.map_or_else(String::new, String::from)))),
                },
                other => Some(other),
            };
            let Some(character) = character else { continue };
            let glyph = font::glyph(character).ok_or_else(|| unknown(character.to_string()))?;
            let width = if glyph.strokes.is_empty() { BLANK } else { glyph.width };
            if !glyph.strokes.is_empty() {
                placed.push(Placed { strokes: glyph.strokes, place: at, width });
            }
            longest = longest.max(at.x + width);
            at.x += width + self.gap;
        }
        Ok((placed, longest))
    }

    /// A stroke at its place in the plane, mm.
    fn moved(&self, way: &Way, own: &Placed, length: f64) -> Way {
        let place: Box<dyn Fn(DVec2) -> DVec2> = match self.arc {
            None => Box::new(|point| self.anchor + (own.place + point) * self.scale),
            Some((middle, radius)) => {
                // The middle of the character's foot is on the arc.
                let along = (own.place.x + own.width / 2.0 - length / 2.0) * self.scale;
                let angle = middle - (along / radius).to_degrees();
                let (out, right) = (DVec2::new(cosd(angle), sind(angle)), DVec2::new(sind(angle), -cosd(angle)));
                Box::new(move |point| {
                    let up = radius + (own.place.y + point.y) * self.scale;
                    self.anchor + out * up + right * (point.x - own.width / 2.0) * self.scale
                })
            }
        };
        let edge = |edge: &Edge| match *edge {
            Edge::Line(to) => Edge::Line(place(to)),
            Edge::Arc { to, centre, sweep } => Edge::Arc { to: place(to), centre: place(centre), sweep },
        };
        Way { start: place(way.start), edges: way.edges.iter().map(edge).collect() }
    }

    /// The strokes of a character; none if there are not so many.
    fn glyph(&self, number: f64) -> Result<Vec<Way>, Fault> {
        Ok(self.glyphs()?.into_iter().nth((number.max(1.0) - 1.0) as usize).unwrap_or_default())
    }
}

impl Calculation for LayOutText {
    type Results = TextLayout;

    fn calculate(&self, _: WorkingPlane) -> Result<TextLayout, Fault> {
        Ok(TextLayout { count: self.layout().glyphs()?.len() as f64 })
    }
}

impl Milling for MoveOverGlyph {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        if let Some(first) = self.layout().glyph(self.number)?.first() {
            pen.line(first.start.extend(pen.here().z), RAPID);
        }
        Ok(())
    }
}

impl Milling for EngraveGlyph {
    fn mill(&self, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        for (number, way) in self.layout().glyph(self.number)?.iter().enumerate() {
            if number > 0 {
                pen.down(self.lifted, RAPID);
            }
            pen.line(way.start.extend(pen.here().z), RAPID);
            pen.down(self.level, self.plunging_feed);
            for edge in &way.edges {
                draw(edge, self.level, self.at, pen);
            }
        }
        Ok(())
    }
}
