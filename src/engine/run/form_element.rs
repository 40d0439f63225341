//! `UDC` and `GRV`: undercuts and recesses in turned contours, as a program writes them.
//!
//! Invariant: a word that is not executed is a fault, never ignored.
use crate::engine::contour::breaks::Break;
use crate::engine::contour::recess::{Deep, Recess};
use crate::engine::contour::undercut::{Form, Undercut};
use crate::engine::flow::code::FORM_ELEMENTS;
use crate::engine::flow::state::Run;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{NamedWord, Statement, StatementKind};

impl Run<'_, '_> {
    /// Whether a block is `UDC` or `GRV`.
    pub(super) fn is_form_element(&self, statement: &Statement) -> bool {
        let head = self.slice(statement.head).trim_end();
        statement.kind == StatementKind::Function && FORM_ELEMENTS.iter().any(|word| head.eq_ignore_ascii_case(word))
    }

    /// An undercut or a recess between the element that waits and the next one.
    pub(super) fn form_element(&mut self, statement: &Statement) -> Done {
        let mut words = statement.words.iter();
        let first = words.next().map_or("", |word| self.slice(word.name)).trim().to_ascii_uppercase();
        let [undercut, recess] = FORM_ELEMENTS;
        let is_undercut = self.slice(statement.head).trim_end().eq_ignore_ascii_case(undercut);
        let refused =
            |head: &str, word: &str| Fault::unsupported("unsupported-block").arg("word", format!("{head} {word}"));
        let what = match (is_undercut, first.as_str()) {
            (true, "TYPE_E") => Break::Undercut(self.undercut(Form::E, words)?),
            (true, "TYPE_F") => Break::Undercut(self.undercut(Form::F, words)?),
            (true, "TYPE_H") => Break::Undercut(self.undercut(Form::H, words)?),
            (true, "TYPE_K") => Break::Undercut(self.undercut(Form::K, words)?),
            (true, "TYPE_U") => Break::Undercut(self.undercut(Form::U, words)?),
            (true, "THREAD") => Break::Undercut(self.undercut(Form::Thread, words)?),
            (false, "RADIAL") => Break::Recess(self.recess(true, words)?),
            (false, "AXIAL") => Break::Recess(self.recess(false, words)?),
            (true, other) => return Err(Fault::unsupported("undercut-form").arg("form", other).into()),
            (false, other) => return Err(refused(recess, other).into()),
        };
        self.contour.has_corner()?;
        let speed = self.speed(None);
        self.contour.break_corner(&mut self.drives, what, speed);
        Ok(())
    }

    /// A word of such a block: its name, its number, and that as mm.
    fn measure(&self, word: &NamedWord) -> Result<(String, f64, f64), Fault> {
        let name = self.slice(word.name).trim().to_ascii_uppercase();
        let value = self.number_of(&word.value)?;
        Ok((name, value, value * self.drives.unit()))
    }

    /// `UDC TYPE_E R0.6 DEPTH0.3 BREADTH2.5 ANGLE15`: an undercut in the corner of a surface and a face.
    fn undercut<'w>(&self, form: Form, words: impl Iterator<Item = &'w NamedWord>) -> Result<Undercut, Fault> {
        let mut own = Undercut::of(form);
        for word in words {
            let (name, value, length) = self.measure(word)?;
            match (name.as_str(), form) {
                ("R", _) => own.radius = Some(length),
                ("DEPTH", Form::E | Form::F | Form::K | Form::U | Form::Thread) => own.depth = Some(length),
                ("BREADTH", Form::E | Form::F | Form::H | Form::U | Form::Thread) => own.breadth = Some(length),
                ("ANGLE", Form::E | Form::F | Form::H | Form::Thread) => own.angle = Some(value),
                ("FACEDEPTH", Form::F) => own.face_depth = Some(length),
                ("FACEANGLE", Form::F) => own.face_angle = Some(value),
                ("ROT", Form::K) => own.rotation = Some(value),
                ("ANG_WIDTH", Form::K) => own.opening = Some(value),
                ("PITCH", Form::Thread) => own.pitch = Some(length),
                ("RND" | "CHF", Form::U) => own.edge = Some((length, name == "CHF")),
                (other, _) => {
                    return Err(Fault::unsupported("unsupported-block").arg("word", format!("UDC {other}")));
                }
            }
        }
        Ok(own)
    }

    /// `GRV RADIAL CENTER-15 DEPTH-5 BREADTH10 CHF1 FAR_CHF1`: a recess in the straight element before it.
    fn recess<'w>(&self, radial: bool, words: impl Iterator<Item = &'w NamedWord>) -> Result<Recess, Fault> {
        let (mut centre, mut deep, mut breadth, mut edges) = (None, None, None, [None; 2]);
        let (mut lean, mut radius) = (0.0, 0.0);
        for word in words {
            let (name, value, length) = self.measure(word)?;
            match name.as_str() {
                // Across the axis it is a diameter.
                "CENTER" => centre = Some(if radial { length } else { length / 2.0 }),
                "DEPTH" => deep = Some(Deep::Beside(length)),
                "DIAM" if radial => deep = Some(Deep::Radius(length / 2.0)),
                "BREADTH" => breadth = Some(length),
                "ANGLE" => lean = value,
                "ANG_WIDTH" => lean = value / 2.0,
                "R" => radius = length,
                "RND" | "CHF" => edges[0] = Some((length, name == "CHF")),
                "FAR_RND" | "FAR_CHF" => edges[1] = Some((length, name == "FAR_CHF")),
                other => return Err(Fault::unsupported("unsupported-block").arg("word", format!("GRV {other}"))),
            }
        }
        match (centre, deep, breadth) {
            (Some(centre), Some(deep), Some(breadth)) => {
                Ok(Recess { radial, centre, deep, breadth, lean, radius, edges })
            }
            _ => Err(Fault::program("recess-impossible")),
        }
    }
}
