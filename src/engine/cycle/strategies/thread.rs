//! Strategies of thread milling: the height where the helix begins, its turns, joining and leaving it.
//!
//! Invariant: the helix has the hand of the pitch; which way it is milled follows from the milling type (TNC 640
//! manual, lines 2728-2739), or from the side of the surface where no milling type is given. Feeds are those of the
//! cutting edge at the thread: the tool centre goes slower inside and faster outside.
use glam::DVec2;

use crate::engine::contour::outline::Place;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::motion::moves::Speed;
use crate::engine::plan::StrategyCall;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

/// What calculation may add to a whole number of turns.
const SPARE: f64 = 1e-9;
/// More turns or helices than this are refused.
const MAX_TURNS: f64 = 10_000.0;
/// Inside, the half turn onto the thread is at most so many tool radii wide: with a tool of a quarter of the thread
/// diameter it begins at the centre, with a smaller one next to it.
const WIDEST_JOIN: f64 = 3.0;

/// A thread to be milled.
struct Thread {
    place: Place,
    /// Heights of surface and bottom.
    surface: f64,
    floor: f64,
    /// Radius of the path of the tool centre.
    radius: f64,
    /// How wide the half turn is that joins the thread, and + where that is inside, - where it is outside.
    join: f64,
    side: f64,
    /// Rise of a turn.
    pitch: f64,
    /// + counter-clockwise.
    rotation: f64,
    /// + along the tool axis.
    rise: f64,
    /// Turns for which the tool is displaced: 0 one turn, 1 a continuous helix.
    threads: f64,
    /// Feed of the tool centre per feed of the cutting edge.
    slower: f64,
}

impl Thread {
    /// From the bottom to the surface: + along the tool axis.
    fn out(&self) -> f64 {
        if self.floor < self.surface { 1.0 } else { -1.0 }
    }

    /// The turns of a helix, and how many helices.
    fn turns(&self) -> Result<(f64, u32), Fault> {
        let whole = |way: f64| libm::ceil((self.surface - self.floor).abs() / way - SPARE).max(1.0);
        let (turns, helices) = if self.threads > 1.0 {
            (1.0, whole(self.threads * self.pitch))
        } else if self.threads > 0.0 {
            (whole(self.pitch), 1.0)
        } else {
            (1.0, 1.0)
        };
        if turns.max(helices) > MAX_TURNS || turns.is_nan() {
            return Err(Fault::new(Class::Limit, "series-limit").arg("limit", MAX_TURNS));
        }
        Ok((turns, helices as u32))
    }

    /// Where the helix of that number begins: the lowest one ends or begins at the bottom of the thread.
    fn start(&self, helix: u32) -> Result<f64, Fault> {
        let (turns, helices) = self.turns()?;
        let outwards = self.rise == self.out();
        let above = f64::from(if outwards { helix } else { helices - 1 - helix }) * self.threads;
        let above = if outwards { above } else { above + turns };
        Ok(self.floor + self.out() * above * self.pitch)
    }

    /// The height gained in half a turn.
    fn half_rise(&self) -> f64 {
        self.rise * self.pitch / 2.0
    }

    /// Where the half turns to the thread begin and end, and where the thread is joined.
    fn ends(&self) -> (DVec2, DVec2) {
        let joined = DVec2::new(self.radius, 0.0);
        (DVec2::new(self.radius - self.side * self.join, 0.0), joined)
    }
}

impl<'e> Run<'_, 'e> {
    fn thread(&self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Result<Thread, Fault> {
        let centre = self.point_given(call, 0, exec)?;
        let [surface, depth, diameter, pitch, outside, climb, threads] = self.all_given(call, 1, exec)?;
        let tool = self.tool_radius();
        if pitch == 0.0 {
            return Err(self.drives.shape_impossible(0.0, pitch));
        }
        let side = if outside > 0.0 { -1.0 } else { 1.0 };
        let radius = diameter / 2.0 - side * tool;
        if radius <= 0.0 {
            return Err(self.drives.shape_impossible(2.0 * tool, diameter));
        }
        let hand = pitch.signum();
        let (rotation, rise) = if climb == 0.0 {
            (hand * depth.signum(), depth.signum())
        } else {
            let rotation = side * climb.signum();
            (rotation, hand * rotation)
        };
        let join = if outside > 0.0 { tool + pitch.abs() } else { radius.min(WIDEST_JOIN * tool) };
        Ok(Thread {
            place: Place::new(centre, 0.0),
            surface,
            floor: surface + depth,
            radius,
            join,
            side,
            pitch: pitch.abs(),
            rotation,
            rise,
            threads,
            slower: radius / (diameter / 2.0),
        })
    }

    pub(super) fn move_to_thread_start_plane(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let thread = self.thread(call, exec)?;
        let feed = self.feed_given(call, exec)?;
        self.drives.mill_down(thread.start(0)?, feed)
    }

    /// Beside the thread if it is much wider than the tool, back by half a turn of the helix, and onto it.
    pub(super) fn approach_thread_on_helix(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let thread = self.thread(call, exec)?;
        let feed = self.feed_given(call, exec)?;
        self.join_thread(&thread, feed)
    }

    fn join_thread(&mut self, thread: &Thread, feed: f64) -> Done {
        let (begin, joined) = thread.ends();
        let height = self.drives.in_plane(self.drives.world.here).z;
        self.drives.mill_to(&thread.place, begin, feed * thread.slower)?;
        self.drives.mill_down(height - thread.half_rise(), feed * thread.slower)?;
        let way = ((begin + joined) / 2.0, joined);
        self.drives.mill_around(&thread.place, way, height, thread.rotation * thread.side, feed * thread.slower)
    }

    pub(super) fn depart_thread_tangentially(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let thread = self.thread(call, exec)?;
        let feed = self.feed_given(call, exec)?;
        self.leave_thread(&thread, feed)
    }

    /// Off the thread on a half turn that goes on rising, and back to the starting point.
    fn leave_thread(&mut self, thread: &Thread, feed: f64) -> Done {
        let (begin, joined) = thread.ends();
        let height = self.drives.in_plane(self.drives.world.here).z + thread.half_rise();
        let way = ((begin + joined) / 2.0, begin);
        self.drives.mill_around(&thread.place, way, height, thread.rotation * thread.side, feed * thread.slower)?;
        if thread.side > 0.0 { self.drives.mill_to(&thread.place, DVec2::ZERO, feed * thread.slower) } else { Ok(()) }
    }

    pub(super) fn mill_thread_helix(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let thread = self.thread(call, exec)?;
        let (feed, between) = (self.feed_given(call, exec)?, self.given(call, 8, exec)?);
        let (turns, helices) = thread.turns()?;
        for helix in 0..helices {
            if helix > 0 {
                self.leave_thread(&thread, feed)?;
                self.drives.mill_down(thread.start(helix)?, between)?;
                self.join_thread(&thread, feed)?;
            }
            let here = self.drives.in_plane(self.drives.world.here);
            let to = here.truncate().extend(here.z + thread.rise * turns * thread.pitch);
            let centre = thread.place.centre.extend(here.z);
            let (centre, to) = (self.drives.world.system.axes(centre), self.drives.world.system.axes(to));
            let sweep = Some(360.0 * turns * thread.rotation);
            self.drives.arc_to(centre, to, thread.rotation, sweep, Speed::of_feed(feed * thread.slower))?;
        }
        Ok(())
    }

    /// From the centre on a half circle to a circle, once around, and back on a half circle.
    pub(super) fn countersink_on_circle(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let place = Place::new(self.point_given(call, 0, exec)?, 0.0);
        let radius = self.given(call, 1, exec)?;
        if radius < 0.0 {
            return Err(self.drives.shape_impossible(self.tool_radius(), self.tool_radius() + radius).into());
        }
        if radius == 0.0 {
            return Ok(());
        }
        let feed = self.feed_given(call, exec)?;
        let height = self.drives.in_plane(self.drives.world.here).z;
        let out = DVec2::new(radius, 0.0);
        for (centre, to) in [(out / 2.0, out), (DVec2::ZERO, out), (out / 2.0, DVec2::ZERO)] {
            self.drives.mill_around(&place, (centre, to), height, 1.0, feed)?;
        }
        Ok(())
    }
}
