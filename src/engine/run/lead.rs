//! Roundings, chamfers, and the ways to a contour and away from it (`APPR`, `DEP`), as a program writes them.
use glam::DVec3;

use crate::engine::contour::approach::{Form, Lead};
use crate::engine::contour::breaks::Break;
use crate::engine::flow::state::Run;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Approach, Motion};

impl Run<'_, '_> {
    /// The value of `LEN` or `CCA`.
    fn word_of(&self, motion: &Motion, name: &str) -> Result<f64, Fault> {
        let found = motion.words.iter().find(|word| self.slice(word.name).eq_ignore_ascii_case(name));
        let Some(word) = found else { return Err(Fault::program("approach-word").arg("word", name)) };
        self.number_of(&word.value)
    }

    fn form(&self, motion: &Motion, form: Approach) -> Result<Form, Fault> {
        let radius = || match &motion.radius {
            Some(radius) => Ok(self.operand(radius)? * self.drives.unit()),
            None => Err(Fault::program("approach-word").arg("word", "R")),
        };
        let length = || Ok::<_, Fault>(self.word_of(motion, "LEN")?.abs() * self.drives.unit());
        Ok(match form {
            Approach::Lt | Approach::Plt => Form::Along(length()?),
            Approach::Ln | Approach::Pln => Form::Across(length()?),
            Approach::Ct | Approach::Pct => {
                let (radius, angle) = (radius()?, self.word_of(motion, "CCA")?);
                if radius == 0.0 || angle <= 0.0 || angle > 360.0 {
                    return Err(Fault::program("approach-impossible"));
                }
                Form::Arc(radius, angle)
            }
            Approach::Lct | Approach::Plct => Form::ArcAndLine(radius()?.abs()),
        })
    }

    /// `APPR`: the way to the first point of a contour waits for its first element.
    pub(super) fn approach_contour(
        &mut self,
        motion: &Motion,
        form: Approach,
        to: DVec3,
        before: Result<Speed, Fault>,
        speed: Result<Speed, Fault>,
    ) -> Done {
        self.not_in_contour("APPR")?;
        self.drives.not_beside_contour("APPR")?;
        let form = self.form(motion, form)?;
        let side = self.contour.side_of(motion);
        if side == 0 && form.needs_side() {
            return Err(Fault::program("approach-impossible").into());
        }
        let (lead, place) = (Lead { form, before: Some(before) }, self.block_place());
        self.contour.begin(&mut self.drives, side, lead, to, motion, place, speed)
    }

    /// While a contour is read that a cycle machines, the cycle has its own ways to it and away from it.
    fn not_in_contour(&self, word: &'static str) -> Result<(), Fault> {
        if self.drives.traced.is_some() { Err(Fault::program("contour-lead").arg("word", word)) } else { Ok(()) }
    }

    /// `DEP`: the contour ends, and the tool leaves it.
    pub(super) fn leave_by(&mut self, motion: &Motion, form: Approach, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        self.not_in_contour("DEP")?;
        let along = self.contour.heading(&self.drives.world)?;
        let form = self.form(motion, form)?;
        self.contour.leave_by(&mut self.drives, form, along, to, speed)
    }

    /// `RND` and `CHF`: they change the corner between the element that waits and the next one.
    pub(super) fn rounding(&mut self, motion: &Motion, chamfer: bool) -> Done {
        self.contour.has_corner()?;
        let Some(size) = &motion.radius else { return Err(Fault::program("radius-missing").into()) };
        let size = self.operand(size)? * self.drives.unit();
        if size < 0.0 {
            return Err(Fault::program("rounding-impossible").arg("size", size).into());
        }
        // Its feed holds for the corner only.
        let feed = self.modal.feed;
        let speed = self.speed(motion.feed.as_ref());
        self.modal.feed = feed;
        let what = if chamfer { Break::Chamfer(size) } else { Break::Rounding(size) };
        self.contour.break_corner(&mut self.drives, what, speed);
        Ok(())
    }
}
