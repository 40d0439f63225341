//! Strategies of thread milling: the height where the helix begins, its turns, joining and leaving it.
//!
//! Invariant: the helix has the hand of the pitch; which way it is milled follows from the milling type (TNC 640
//! manual, lines 2728-2739), or from the side of the surface where no milling type is given. Feeds are those of the
//! cutting edge at the thread: the tool centre goes slower inside and faster outside.
use glam::{DVec2, DVec3};

use crate::engine::report::fault::Fault;
use crate::engine::strategy::milling::{Milling, shape_impossible, too_many};
use crate::engine::strategy::outline::Place;
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::strategy;

/// What calculation may add to a whole number of turns.
const SPARE: f64 = 1e-9;
/// More turns or helices than this are refused.
const MAX_TURNS: f64 = 10_000.0;
/// Inside, the half turn onto the thread is at most so many tool radii wide: with a tool of a quarter of the thread
/// diameter it begins at the centre, with a smaller one next to it.
const WIDEST_JOIN: f64 = 3.0;

/// Declares a strategy of threads: what all of them are given, and what it is given besides.
macro_rules! of_thread {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The axis of the thread.
                centre: DVec3 = Length,
                /// The height of the surface, mm.
                surface: f64 = Length,
                /// The signed depth of the thread below it, mm.
                depth: f64 = Length,
                /// The nominal diameter, mm.
                diameter: f64 = Length,
                /// The pitch, mm: positive for a right-hand thread.
                pitch: f64 = Length,
                /// 1 for an outside thread, 0 for an inside one.
                outside: f64 = Number,
                /// Climb milling if positive, up-cut if negative; 0: from the surface into the workpiece.
                climb: f64 = Number,
                /// 0: one turn; 1: a continuous helix; more: helices of one turn, so many pitches apart.
                threads: f64 = Number,
                /// The feed of the cutting edge at the thread, mm/min.
                at: f64 = Feed,
                $($more)*
            }
        }

        impl $name {
            fn thread(&self, tool: Cutter) -> Result<Thread, Fault> {
                let Self { centre, surface, depth, diameter, pitch, outside, climb, threads, at: feed, .. } = *self;
                Thread::new(&Wanted { centre, surface, depth, diameter, pitch, outside, climb, threads, feed }, tool)
            }
        }
    };
}

of_thread! {
    /// Moves to the height at which the helix of a thread begins.
    MoveToThreadStartPlane = "move-to-thread-start-plane" {}
}

of_thread! {
    /// Onto the diameter of a thread on a half turn that rises with it: beside the thread if it is much wider than the
    /// tool, back by half a turn of the helix, and onto it.
    ApproachThreadOnHelix = "approach-thread-on-helix" {}
}

of_thread! {
    /// Mills a thread: one turn, a continuous helix or several helices.
    MillThreadHelix = "mill-thread-helix" {
        /// The feed from helix to helix, mm/min.
        between: f64 = Feed,
    }
}

of_thread! {
    /// Away from a thread on a half turn that goes on rising, and back to the starting point.
    DepartThreadTangentially = "depart-thread-tangentially" {}
}

strategy! {
    /// Countersinks a hole on a circle: from the centre on a half circle to it, once around, and back on a half circle.
    CountersinkOnCircle = "countersink-on-circle" {
        /// The axis of the hole.
        centre: DVec3 = Length,
        /// The radius of the path of the tool centre, mm.
        radius: f64 = Length,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

impl Milling for MoveToThreadStartPlane {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = self.thread(tool)?;
        pen.down(thread.start(0)?, self.at);
        Ok(())
    }
}

impl Milling for ApproachThreadOnHelix {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.thread(tool)?.join(pen);
        Ok(())
    }
}

impl Milling for DepartThreadTangentially {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        self.thread(tool)?.leave(pen);
        Ok(())
    }
}

impl Milling for MillThreadHelix {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let thread = self.thread(tool)?;
        let (turns, helices) = thread.turns()?;
        for helix in 0..helices {
            if helix > 0 {
                thread.leave(pen);
                pen.down(thread.start(helix)?, self.between);
                thread.join(pen);
            }
            let here = pen.here();
            let to = here.truncate().extend(here.z + thread.rise * turns * thread.pitch);
            let centre = thread.place.centre.extend(here.z);
            let sweep = Some(360.0 * turns * thread.rotation);
            pen.arc((centre, to), thread.rotation, sweep, thread.feed);
        }
        Ok(())
    }
}

impl Milling for CountersinkOnCircle {
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (place, radius) = (Place::new(self.centre, 0.0), self.radius);
        if radius < 0.0 {
            return Err(shape_impossible(tool.radius, tool.radius + radius));
        }
        if radius == 0.0 {
            return Ok(());
        }
        let height = pen.here().z;
        let out = DVec2::new(radius, 0.0);
        for (centre, to) in [(out / 2.0, out), (DVec2::ZERO, out), (out / 2.0, DVec2::ZERO)] {
            pen.around(&place, (centre, to), height, 1.0, self.at);
        }
        Ok(())
    }
}

/// A thread as it is asked for; the fields are those of the strategies.
struct Wanted {
    centre: DVec3,
    surface: f64,
    depth: f64,
    diameter: f64,
    pitch: f64,
    outside: f64,
    climb: f64,
    threads: f64,
    feed: f64,
}

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
    /// The feed of the tool centre, mm/min.
    feed: f64,
}

impl Thread {
    fn new(wanted: &Wanted, tool: Cutter) -> Result<Self, Fault> {
        let Wanted { centre, surface, depth, diameter, pitch, outside, climb, threads, feed } = *wanted;
        if pitch == 0.0 {
            return Err(shape_impossible(0.0, pitch));
        }
        let side = if outside > 0.0 { -1.0 } else { 1.0 };
        let radius = diameter / 2.0 - side * tool.radius;
        if radius <= 0.0 {
            return Err(shape_impossible(2.0 * tool.radius, diameter));
        }
        let hand = pitch.signum();
        let (rotation, rise) = if climb == 0.0 {
            (hand * depth.signum(), depth.signum())
        } else {
            let rotation = side * climb.signum();
            (rotation, hand * rotation)
        };
        let join = if outside > 0.0 { tool.radius + pitch.abs() } else { radius.min(WIDEST_JOIN * tool.radius) };
        Ok(Self {
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
            feed: feed * (radius / (diameter / 2.0)),
        })
    }

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
            return Err(too_many(MAX_TURNS));
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

    /// Beside the thread, back by half a turn of the helix, and onto it on a half turn.
    fn join(&self, pen: &mut Pen) {
        let (begin, joined) = self.ends();
        let height = pen.here().z;
        pen.to(&self.place, begin, self.feed);
        pen.down(height - self.half_rise(), self.feed);
        pen.around(&self.place, ((begin + joined) / 2.0, joined), height, self.rotation * self.side, self.feed);
    }

    /// Off the thread on a half turn that goes on rising, and back to the starting point.
    fn leave(&self, pen: &mut Pen) {
        let (begin, joined) = self.ends();
        let height = pen.here().z + self.half_rise();
        pen.around(&self.place, ((begin + joined) / 2.0, begin), height, self.rotation * self.side, self.feed);
        if self.side > 0.0 {
            pen.to(&self.place, DVec2::ZERO, self.feed);
        }
    }
}
