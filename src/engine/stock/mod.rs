//! The stock: what is left of the blank while a program machines it.
//!
//! # The model
//! The blank is a field of columns (dexels) along one axis, one for each cell of a grid whose cells are not larger
//! than the resolution that the caller chooses. A column is a list of stretches of material with exact ends: only
//! the *places* of the columns are quantised, never a height. Tools are bodies of revolution ([`Cutter`]); their
//! envelope along lines, arcs and helices is calculated exactly for each column while the tool is along the
//! columns (see `sweep`). A tool that is otherwise, or a way about another axis, is followed in steps of a
//! quarter of the resolution (see `oblique`), which is its error.
//!
//! # Work and memory
//! Moves are collected and carried out by several threads, each of which owns rows of its own: the result does not
//! depend on their number to the last bit. Memory depends on the grid and not on the number of moves.
//!
//! Invariant: nothing here knows a control; `blank` alone reads a program, `follow` alone events.
mod arc_sweep;
mod ball_continuation;
mod bed;
mod blank;
mod columns;
mod compare;
mod cut;
mod cutter;
mod cutter_rim;
mod dexel_row;
mod follow;
mod grid;
mod kernel;
mod mesh;
mod oblique;
mod outline;
mod ramp;
mod report;
mod rim;
mod sweep;
mod timing;
mod tops;
mod turned;
mod turning;
mod watch;

pub use crate::engine::machine::Neck;
pub use blank::{Blank, StockTrouble};
pub use compare::Deviation;
pub use cutter::{Cutter, Tip};
pub use follow::Machining;
pub use outline::Plateau;
pub use report::{Finding, Greatest, Report};
pub use watch::Watch;

pub use super::report::event::FindingKind;

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::{DVec2, DVec3};

use super::geometry::{Axis, Frame, WorkingPlane};
use super::solid::{Body, Path, Shape, SolidError};
use crate::base::parallel::together;
use ball_continuation::BallContinuation;
use columns::{SLIVER, Tally};
use dexel_row::Row;
use grid::{BAND, Grid};
use oblique::Oblique;
use ramp::Ramp;
use rim::Rims;
use sweep::Sweep;

/// Lanes that can be worked on at the same time.
const LANES: usize = 8;
/// Pieces of moves below which one thread works.
const FEW: usize = 32;
/// How far from its own zero point a blank may reach, mm: farther than any machine.
pub(super) const FARTHEST: f64 = 1e9;
/// Most columns of a grid: about two gigabytes with the triangles of its part.
const MOST_COLUMNS: f64 = 1e7;
/// How deep rapid traverse must be in the material to count as contact, mm. What follows from rounding is far below.
pub const SKIN: f64 = 1e-3;

/// What one move did to the stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Volume taken away, mm³.
    pub volume: f64,
    /// The greatest height taken away from one column by a piece of the move: a line, or a quarter turn. mm.
    pub depth: f64,
    /// Extent of what was cut across the path, mm; 0 if the tool moved along its axis.
    pub width: f64,
    /// How far above the tip's highest place material was cut, mm: what the edges must be long.
    pub reach: f64,
}

impl Cut {
    /// What two pieces of a move did.
    fn and(self, other: Self) -> Self {
        Self {
            volume: self.volume + other.volume,
            depth: self.depth.max(other.depth),
            width: self.width.max(other.width),
            reach: self.reach.max(other.reach),
        }
    }
}

/// A piece of a move: which move of the batch, and what sweeps.
#[derive(Clone, Copy, Debug)]
struct Job {
    owner: usize,
    sweep: Swept,
}

#[derive(Clone, Copy, Debug)]
enum Swept {
    /// Everything above the lower envelope goes.
    Above(Sweep),
    /// Everything between the lower envelope and the upper one of a head of that height goes.
    Between(Sweep, f64),
    /// The tool is not along the columns.
    Oblique(Oblique),
}

impl Swept {
    fn bounds(&self) -> (DVec2, DVec2) {
        match self {
            Self::Above(sweep) | Self::Between(sweep, _) => (sweep.min, sweep.max),
            Self::Oblique(oblique) => oblique.bounds(),
        }
    }
}

/// Moves that wait to be carried out together.
#[derive(Debug, Default)]
pub struct Batch {
    jobs: Vec<Job>,
    moves: usize,
    /// Where the last tool ended, if its whole envelope is gone there.
    last: Option<(DVec3, Cutter)>,
    /// By move: the highest place of the tip, and whether it goes across the tool axis.
    about: Vec<(f64, bool)>,
}

impl Batch {
    /// Moves that wait.
    pub const fn len(&self) -> usize {
        self.moves
    }

    /// Takes the last move back.
    pub(super) fn take_back(&mut self) {
        self.moves = self.moves.saturating_sub(1);
        let own = self.jobs.partition_point(|job| job.owner < self.moves);
        self.jobs.truncate(own);
        self.about.truncate(self.moves);
        self.last = None;
    }

    /// Pieces of moves that wait: a helix has several a turn.
    pub(super) const fn pieces(&self) -> usize {
        self.jobs.len()
    }

    /// Whether nothing waits.
    pub const fn is_empty(&self) -> bool {
        self.moves == 0
    }
}

/// The stock.
#[derive(Clone, Debug)]
pub struct Stock {
    grid: Grid,
    lanes: Vec<Vec<Row>>,
}

/// Lane and place in it of a row.
const fn place(row: usize) -> (usize, usize) {
    let band = row / BAND;
    (band % LANES, (band / LANES) * BAND + row % BAND)
}

impl Stock {
    /// The blank as columns along the axis of its coordinates; `frame` leads from these to the machine. The box
    /// `min` to `max` holds the blank. Cells are at most as large as the resolution.
    ///
    /// # Errors
    /// The resolution is not positive or too fine, or the blank has no extent or too large a one.
    pub fn new(
        blank: &Shape,
        bounds: [DVec3; 2],
        frame: Frame,
        axis: Axis,
        resolution: f64,
    ) -> Result<Self, StockTrouble> {
        let plane = WorkingPlane::of_tool_axis(axis);
        let body = Body::new(blank)?;
        let [min, max] = bounds.map(|p| {
            let flat = plane.flat(p);
            DVec3::new(flat.x, flat.y, axis.of(p))
        });
        let extent = max - min;
        if ![min, max].iter().all(|corner| corner.is_finite() && corner.abs().max_element() <= FARTHEST) {
            return Err(StockTrouble::Extent);
        }
        let sound = resolution > 0.0 && extent.min_element() > 0.0;
        let (columns, rows) = ((extent.x / resolution).ceil(), (extent.y / resolution).ceil());
        if !sound || columns * rows > MOST_COLUMNS {
            return Err(StockTrouble::Resolution { found: resolution });
        }
        let cell = DVec2::new(extent.x / columns, extent.y / rows);
        let (columns, rows) = (columns as usize, rows as usize);
        let each = cell.recip();
        let grid = Grid { frame, back: frame.inverse(), plane, min, max, cell, each, columns, rows };
        let mut lanes = vec![Vec::new(); LANES];
        let up = grid.blank(DVec3::Z);
        let material = |column, row| body.along(grid.blank(DVec3::new(grid.x(column), grid.y(row), 0.0)), up);
        // All columns of a box are the same.
        let first = if matches!(blank, Shape::Box { .. }) { Some(material(0, 0)?) } else { None };
        for row in 0..rows {
            let mut error = None;
            let made = Row::new(columns, |column| match &first {
                Some(first) => first.clone(),
                None => material(column, row).unwrap_or_else(|found| {
                    error = Some(found);
                    Vec::new()
                }),
            });
            if let Some(error) = error {
                return Err(error.into());
            }
            if let Some(lane) = lanes.get_mut(place(row).0) {
                lane.push(made);
            }
        }
        Ok(Self { grid, lanes })
    }

    /// Gives all columns anew what `material` says that they hold, from low to high, of a point of a column and the
    /// direction of all of them in the coordinates of the blank.
    fn renew(&mut self, material: &dyn Fn(DVec3, DVec3) -> Vec<[f64; 2]>) {
        let grid = self.grid;
        let up = grid.blank(DVec3::Z);
        let mut lanes = vec![Vec::new(); LANES];
        for row in 0..grid.rows {
            let made =
                Row::new(grid.columns, |column| material(grid.blank(DVec3::new(grid.x(column), grid.y(row), 0.0)), up));
            if let Some(lane) = lanes.get_mut(place(row).0) {
                lane.push(made);
            }
        }
        self.lanes = lanes;
    }

    fn row(&self, row: usize) -> Option<&Row> {
        let (lane, at) = place(row);
        self.lanes.get(lane)?.get(at)
    }

    /// Columns and rows of the grid.
    pub const fn size(&self) -> (usize, usize) {
        (self.grid.columns, self.grid.rows)
    }

    /// The size of a cell along the main and the secondary axis.
    pub const fn cell(&self) -> DVec2 {
        self.grid.cell
    }

    /// The box of the blank in the coordinates of the grid: main axis, secondary axis, along the columns.
    pub const fn bounds(&self) -> [DVec3; 2] {
        [self.grid.min, self.grid.max]
    }

    /// The axis of the blank along which the columns are.
    pub const fn axis(&self) -> Axis {
        self.grid.plane.tool
    }

    /// Where a column is: main and secondary axis.
    pub fn place(&self, column: usize, row: usize) -> DVec2 {
        DVec2::new(self.grid.x(column), self.grid.y(row))
    }

    /// The stretches of material in a column, from low to high.
    pub fn column(&self, column: usize, row: usize) -> Vec<[f64; 2]> {
        self.row(row).map_or_else(Vec::new, |row| row.column(column))
    }

    /// The top of a column, or nothing if it is empty.
    pub fn top(&self, column: usize, row: usize) -> Option<f64> {
        self.row(row).map(|row| row.top(column)).filter(|top| top.is_finite())
    }

    /// The volume left, mm³.
    pub fn volume(&self) -> f64 {
        let mut sum = 0.0;
        for row in 0..self.grid.rows {
            for column in 0..self.grid.columns {
                sum += self.column(column, row).iter().map(|[low, high]| high - low).sum::<f64>();
            }
        }
        sum * self.grid.cell.x * self.grid.cell.y
    }

    /// Adds a move of the tool tip (machine coordinates) to a batch. `axis` points from the tip to the spindle. A
    /// move at rapid traverse takes away what is deeper in the material than [`SKIN`], or than a cell if the tool is
    /// inclined to the columns: nothing is known more exactly then.
    pub fn add(&self, batch: &mut Batch, path: &Path, axis: DVec3, cutter: &Cutter, rapid: bool) {
        let owner = batch.moves;
        batch.moves += 1;
        let tool = self.grid.vector(axis).normalize_or_zero();
        // Rounding of turned coordinates is no inclination.
        let upright = (tool - DVec3::Z).length() < 1e-12;
        let skin = if upright { SKIN } else { self.grid.cell.length() };
        let (cutter, lift) = if rapid { (cutter.shrunk(skin), skin) } else { (cutter.closed(), 0.0) };
        let up = DVec3::Z * lift;
        let before = batch.last.take();
        // Coordinates that were calculated on two ways differ by their rounding.
        let joins = |at: DVec3| before.is_some_and(|(end, tool)| tool == cutter && (end - at).length() < 1e-10);
        let mut across = true;
        let mut high = f64::NEG_INFINITY;
        match *path {
            Path::Line { from, to } => {
                let (from, to) = (self.grid.point(from), self.grid.point(to));
                high = from.z.max(to.z);
                across = libm::hypot(to.x - from.x, to.y - from.y) > SLIVER;
                if upright {
                    let mut line = Sweep::line(from + up, to + up, cutter);
                    line.joined = joins(from + up);
                    batch.last = cutter.neck.is_none().then_some((to + up, cutter));
                    upright_jobs(batch, owner, line);
                } else {
                    let bottom = self.grid.min.z;
                    oblique_jobs(batch, owner, &Oblique::new(path, &self.grid, cutter, tool, lift, bottom));
                }
            }
            Path::Arc { centre, axis, from, sweep, rise } => {
                let about = self.grid.vector(axis).normalize_or_zero();
                let standing = about.z.abs() > 1.0 - 1e-12;
                if upright && standing && sweep != 0.0 {
                    let (centre, start) = (self.grid.point(centre), self.grid.point(from));
                    let arm = DVec2::new(start.x - centre.x, start.y - centre.y);
                    let (radius, angle) = (libm::hypot(arm.x, arm.y), libm::atan2(arm.y, arm.x));
                    let (sweep, rise) = (sweep.to_radians() * about.z.signum(), rise * about.z.signum());
                    high = start.z.max(start.z + rise);
                    let mut pieces = if rise == 0.0 { 1.0 } else { (sweep.abs() / std::f64::consts::FRAC_PI_2).ceil() };
                    if let Some(neck) = cutter.neck.filter(|neck| neck.head > 0.0) {
                        pieces = f64::max(pieces, (rise.abs() / neck.head).ceil());
                    }
                    let centre = DVec2::new(centre.x, centre.y);
                    let mut joined = joins(start + up);
                    for piece in 0..pieces as usize {
                        let share = piece as f64 / pieces;
                        let (angle, z) = (angle + sweep * share, start.z + lift + rise * share);
                        let mut arc = Sweep::arc(centre, radius, angle, sweep / pieces, z, rise / pieces, cutter);
                        arc.joined = joined;
                        joined = cutter.neck.is_none();
                        upright_jobs(batch, owner, arc);
                    }
                    let (s, c) = (libm::sin(angle + sweep), libm::cos(angle + sweep));
                    let end = (centre + radius * DVec2::new(c, s)).extend(start.z + lift + rise);
                    batch.last = joined.then_some((end, cutter));
                } else {
                    let bottom = self.grid.min.z;
                    oblique_jobs(batch, owner, &Oblique::new(path, &self.grid, cutter, tool, lift, bottom));
                }
            }
        }
        batch.about.push((high, across));
    }

    /// Carries out the moves of a batch, in their order, and empties it. What each of them did.
    pub fn carry_out(&mut self, batch: &mut Batch) -> Vec<Cut> {
        let jobs = std::mem::take(&mut batch.jobs);
        let about = std::mem::take(&mut batch.about);
        let moves = std::mem::take(&mut batch.moves);
        let grid = self.grid;
        let plans: Vec<_> = jobs.iter().map(|job| Plan::new(&grid, &job.sweep)).collect();
        let lanes: Vec<_> =
            self.lanes.iter_mut().enumerate().map(|lane| std::sync::Mutex::new((lane, Vec::new()))).collect();
        let next = AtomicUsize::new(0);
        let work = || {
            while let Some(lane) = lanes.get(next.fetch_add(1, Ordering::Relaxed)) {
                let Ok(mut lane) = lane.lock() else { continue };
                let ((number, rows), tallies) = &mut *lane;
                *tallies = work_lane(&grid, *number, rows, jobs.iter().zip(&plans), moves);
            }
        };
        // A few moves are done before a thread is there.
        together(if jobs.len() < FEW { 1 } else { LANES }, work);
        let mut all = vec![Tally::NONE; moves];
        for lane in lanes {
            let tallies = lane.into_inner().map(|(_, tallies)| tallies).unwrap_or_default();
            all.iter_mut().zip(&tallies).for_each(|(sum, tally): (&mut Tally, &Tally)| sum.join(tally));
        }
        (batch.jobs, batch.about) = (jobs, about);
        batch.jobs.clear();
        let area = grid.cell.x * grid.cell.y;
        let cuts = all.iter().zip(&batch.about).map(|(tally, (high, across))| Cut {
            volume: tally.height * area,
            depth: tally.deepest,
            width: if *across && tally.left[1] >= tally.left[0] { tally.left[1] - tally.left[0] } else { 0.0 },
            reach: if high.is_finite() { tally.highest - high } else { f64::NEG_INFINITY },
        });
        let cuts = cuts.collect();
        batch.about.clear();
        cuts
    }
}

/// A tool that is along the columns: its whole envelope, or that of its head and that of its neck.
fn upright_jobs(batch: &mut Batch, owner: usize, sweep: Sweep) {
    let mut job = |sweep| batch.jobs.push(Job { owner, sweep });
    match sweep.cutter.neck {
        None => job(Swept::Above(sweep)),
        Some(neck) => {
            let thin = Cutter { radius: neck.radius, tip: Tip::Flat, neck: None, ..sweep.cutter };
            let head = Cutter { neck: None, ..sweep.cutter };
            job(Swept::Between(sweep.with(head, 0.0), neck.head));
            job(Swept::Above(sweep.with(thin, neck.head)));
        }
    }
}

fn oblique_jobs(batch: &mut Batch, owner: usize, oblique: &Oblique) {
    batch.jobs.extend(oblique.parts().map(|part| Job { owner, sweep: Swept::Oblique(part) }));
}

/// How a sweep is carried out row by row.
enum Plan<'s> {
    BallContinuation(BallContinuation),
    Ramp(Ramp<'s>),
    /// All that it covers is examined.
    Whole,
}

impl<'s> Plan<'s> {
    fn new(grid: &Grid, sweep: &'s Swept) -> Self {
        let Swept::Above(sweep) = sweep else { return Self::Whole };
        let continuation = BallContinuation::new(grid, sweep).map(Self::BallContinuation);
        continuation.or_else(|| Ramp::new(grid, sweep).map(Self::Ramp)).unwrap_or(Self::Whole)
    }
}

/// Carries out all jobs in the rows of one lane, as it is planned. What each move did there.
fn work_lane<'s>(
    grid: &Grid,
    lane: usize,
    rows: &mut [Row],
    jobs: impl Iterator<Item = (&'s Job, &'s Plan<'s>)>,
    moves: usize,
) -> Vec<Tally> {
    let mut tallies = vec![Tally::NONE; moves];
    let mut rims = Rims::new();
    for (job, plan) in jobs {
        let (min, max) = job.sweep.bounds();
        let Some((first, last)) = Grid::between(min.y, max.y, grid.min.y, grid.each.y, grid.rows) else { continue };
        let Some(tally) = tallies.get_mut(job.owner) else { continue };
        let mut across = [f64::INFINITY, f64::NEG_INFINITY];
        // The first band of this lane that is not before the first row.
        let own = first / BAND / LANES * LANES + lane;
        let begin = if own < first / BAND { own + LANES } else { own };
        let bands = (begin..=last / BAND).step_by(LANES);
        if let (Swept::Above(sweep), Plan::Ramp(ramp)) = (&job.sweep, plan) {
            let bands = bands.map(|band| (band * BAND, place(band * BAND).1));
            cut::ramp(grid, rows, bands, (sweep, ramp, &mut rims), tally, &mut across);
        } else {
            for band in bands {
                for row in (band * BAND).max(first)..=(band * BAND + BAND - 1).min(last) {
                    let Some(own) = rows.get_mut(place(row).1) else { continue };
                    own.spread();
                    match (&job.sweep, plan) {
                        (Swept::Above(sweep), Plan::BallContinuation(ball)) => {
                            cut::continue_ball(grid, own, row, (sweep, ball), tally, &mut across);
                        }
                        (Swept::Above(sweep), _) => cut::above(grid, own, row, sweep, tally, &mut across),
                        (Swept::Between(sweep, head), _) => {
                            cut::between(grid, own, row, sweep, *head, tally, &mut across);
                        }
                        (Swept::Oblique(oblique), _) => oblique.cut(grid, own, row, tally),
                    }
                }
            }
        }
        if let (Swept::Above(sweep) | Swept::Between(sweep, _), true) = (&job.sweep, across[0] <= across[1]) {
            let [least, most] = sweep.left(across);
            tally.left = [tally.left[0].min(least), tally.left[1].max(most)];
        }
    }
    rows.iter_mut().for_each(Row::spread);
    tallies
}

impl From<SolidError> for StockTrouble {
    fn from(error: SolidError) -> Self {
        Self::Solid(error)
    }
}
