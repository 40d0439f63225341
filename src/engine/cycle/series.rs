//! Series: their members, and what is done for and between them.
//!
//! Invariant: every series ends; one that would not is a fault before anything moves.
use crate::base::expr::Value;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::plan::{Series, SeriesKind, Slot};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// Below this, in mm, the rest of a way is rounding and no infeed of its own.
const NO_INFEED: f64 = 1e-9;
/// Series of that many infeeds need memory once.
const USUAL: usize = 8;

/// The members of a series.
#[derive(Clone, Debug)]
enum Members {
    /// Where each infeed ends; the first one begins at `from`.
    Infeeds {
        from: f64,
        ends: Vec<f64>,
    },
    Angles {
        start: f64,
        step: f64,
        count: u32,
    },
    Count(u32),
}

impl Members {
    fn count(&self) -> usize {
        match self {
            Self::Infeeds { ends, .. } => ends.len(),
            Self::Angles { count, .. } | Self::Count(count) => *count as usize,
        }
    }

    /// Puts the values of a member's fields into its slots, in their order.
    fn put(&self, index: usize, first: Slot, exec: &mut Exec<'_, '_>) {
        let count = self.count();
        exec.put_number(first, (index + 1) as f64);
        exec.put_number(first + 1, count as f64);
        exec.put(first + 2, Value::Bool(index == 0));
        exec.put(first + 3, Value::Bool(index + 1 == count));
        match self {
            Self::Infeeds { from, ends } => {
                let begin = index.checked_sub(1).and_then(|before| ends.get(before)).unwrap_or(from);
                exec.put_number(first + 4, *begin);
                exec.put_number(first + 5, ends.get(index).copied().unwrap_or(*begin));
            }
            Self::Angles { start, step, .. } => exec.put_number(first + 4, start + index as f64 * step),
            Self::Count(_) => {}
        }
    }
}

/// The ends of infeeds from one coordinate to another.
fn infeeds(from: f64, to: f64, by: f64, less: f64, least: f64, limit: u32) -> Result<Vec<f64>, Fault> {
    let (way, sign) = ((to - from).abs(), if to < from { -1.0 } else { 1.0 });
    if by <= 0.0 {
        return Ok(vec![to]);
    }
    let (mut ends, mut done, mut infeed) = (Vec::with_capacity(USUAL), 0.0, by);
    while way - done > NO_INFEED || ends.is_empty() {
        if infeed <= 0.0 {
            let fault = Fault::control("infeeds-never-reach-depth").arg("reached", done).arg("depth", way);
            return Err(fault.arg("first", by).arg("less", less).arg("least", least));
        }
        if ends.len() >= limit as usize {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", f64::from(limit)));
        }
        done += infeed;
        ends.push(if way - done > NO_INFEED { from + sign * done } else { to });
        infeed = (infeed - less).max(least.min(infeed));
    }
    Ok(ends)
}

impl<'e> Run<'_, 'e> {
    fn members(&self, kind: &SeriesKind, exec: &Exec<'_, 'e>) -> Result<Members, Fault> {
        let limit = self.settings.limits.members;
        let count = |number: f64| {
            if number > f64::from(limit) {
                return Err(Fault::new(Class::Limit, "series-limit").arg("limit", f64::from(limit)));
            }
            if number >= 0.0 && number.fract() == 0.0 {
                return Ok(number as u32);
            }
            // Parameters that count are whole numbers; a specification that calculates something else is wrong.
            Err(Fault::new(Class::Internal, "series-count").arg("found", number))
        };
        Ok(match kind {
            SeriesKind::Infeeds { from, to, by, less, least } => {
                let optional = |calc: &Option<_>| calc.as_ref().map_or(Ok(0.0), |calc| self.number(calc, exec));
                let (from, to) = (self.number(from, exec)?, self.number(to, exec)?);
                let by = self.number(by, exec)?;
                let ends = infeeds(from, to, by, optional(less)?, optional(least)?, limit)?;
                Members::Infeeds { from, ends }
            }
            SeriesKind::Angles { start, step, count: of } => Members::Angles {
                start: self.number(start, exec)?,
                step: self.number(step, exec)?,
                count: count(self.number(of, exec)?)?,
            },
            SeriesKind::Count { of } => Members::Count(count(self.number(of, exec)?)?),
        })
    }

    pub(crate) fn series(&mut self, series: &Series, exec: &mut Exec<'_, 'e>) -> Done {
        if !self.holds(series.when.as_ref(), exec)? {
            return Ok(());
        }
        let members = self.members(&series.kind, exec)?;
        let count = members.count();
        for index in 0..count {
            members.put(index, series.member, exec);
            self.items(&series.body, exec)?;
            if let Some(collect) = &series.collect {
                let value = self.value(&collect.value, exec)?;
                if let Some(list) = exec.lists.get_mut(collect.list) {
                    list.push(value);
                }
            }
            if index + 1 < count {
                self.items(&series.between, exec)?;
            }
        }
        Ok(())
    }
}
