//! What happens to the blank where the tool goes, as `travel` finds it, or an execution shows it, and rules report it.
use super::toolwords::ToolKind;
use crate::spec::CycleKey;

/// What an execution of a program shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// The first line of the block, from 1.
    pub line: usize,
    /// What happens there.
    pub incident: Incident,
}

/// What happens to the blank. Lengths are in the unit of the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Incident {
    /// A rapid movement goes into it, down to a height.
    RapidInMaterial(f64),
    /// A movement at feed goes into it while the spindle is stationary.
    FeedWithoutSpindle,
    /// The same after a tool call that nothing has followed which turns the spindle on.
    FeedBeforeSpindleStart,
    /// A tool call while the tool is inside of it, at a height.
    ToolChangeInMaterial(f64),
    /// A rotary axis turns at rapid while the tool is inside of it, at a height.
    AxisTurnsInMaterial(f64),
    /// The plane is tilted with a compensating movement while the tool is inside of it, at a height.
    TiltsInMaterial(f64),
    /// The program ends while the tool is inside of it, at a height.
    EndsInMaterial(f64),
    /// A place that the same definition has machined before.
    MachinedAgain([f64; 2]),
    /// A hole or pocket in which a thread is cut, as wide as the thread.
    WideCore {
        /// The diameter of the thread.
        thread: f64,
        /// That of the hole.
        hole: f64,
    },
    /// A drill that goes through a thread which was cut before, at least as wide as its core.
    ThreadRemoved {
        /// The diameter of the thread.
        thread: f64,
        /// That of the drill.
        hole: f64,
    },
    /// A round pocket that is cut by the edge of the blank, or a rectangular one that covers all of it.
    CoversBlank([f64; 2]),
    /// A pocket, or a place of a contour, far from it.
    OutsideBlank([f64; 2]),
    /// An approach or a departure on an arc that begins or ends inside of it, with its radius.
    ArcInMaterial(f64),
    /// A contour that begins where the tool has plunged.
    ContourStartsAtPlunge,
    /// Material higher above the tool tip than its cutting edges are long.
    DeeperThanCuttingEdge(f64),
    /// A tap where no hole was made, though holes were made elsewhere.
    NoHole([f64; 2]),
    /// A tap that goes deeper than its hole.
    HoleTooShallow {
        /// How deep the tap goes.
        tap: f64,
        /// The bottom of the hole.
        hole: f64,
    },
    /// A hole next to it, at a place.
    HoleBesideBlank([f64; 2]),
    /// A hole that begins above it or below it, at a height.
    HoleOffSurface(f64),
    /// A hole that goes through it, down to a height.
    HoleThroughBlank(f64),
    /// A movement cuts while the spindle is stationary, or, if it is not started, was not turned on since the tool
    /// call.
    CutsWithoutSpindle {
        /// Whether the spindle still turns for the tool before.
        unstarted: bool,
    },
    /// A cycle that stays above the blank, and its lowest height.
    AboveBlank(f64),
    /// A movement that cuts far below the blank, at a height.
    BelowBlank(f64),
    /// A contour or element that the control cannot calculate.
    Incalculable(&'static str),
    /// A thread in a hole that is too narrow for it.
    NarrowCore {
        /// The diameter of the thread.
        thread: f64,
        /// That of the hole.
        hole: f64,
    },
    /// A thread mill that is wider than the core hole into which it goes.
    ToolWiderThanCore {
        /// The diameter of the tool.
        tool: f64,
        /// That of the hole.
        hole: f64,
    },
    /// A thread mill outside of a stud that goes into the floor around it.
    ThreadIntoFloor {
        /// How deep the tool goes.
        thread: f64,
        /// The height of the floor.
        floor: f64,
    },
    /// A cycle that goes down to a height where everything has been removed already.
    InAir(f64),
    /// Two holes of the same tool that overlap.
    Overlap {
        /// How far their centres are apart.
        distance: f64,
        /// How wide they are.
        width: f64,
    },
    /// Pockets or slots of one definition that run into each other, with the middle of the later one.
    PocketsOverlap([f64; 2]),
    /// A hole that a pocket cuts which was milled before.
    HoleCutByPocket([f64; 2]),
    /// A hole that a wider and deeper one cuts which was made before.
    HoleCutByHole([f64; 2]),
    /// A pocket or slot that lies in a deeper one for the most part, unlike another one of the same definition.
    PocketInPocket([f64; 2]),
    /// A wall that a contour leaves at the edge of the blank, and how wide it is.
    WallLeft(f64),
    /// A block that plunges into a hole on one pass and into solid material at this place.
    PlungeBesideHoles([f64; 2]),
    /// The edge of a bar that goes through a hole beside its axis, and reaches farther than the hole.
    EdgeWiderThanHole {
        /// How far the edge is from the axis of the hole.
        edge: f64,
        /// The radius of the hole.
        hole: f64,
    },
    /// A cut after the plane was reset, while the rotary axes are still where they were in it.
    AxesLeftTurned,
    /// A movement along a contour above the blank, at a height, where the same tool has cut below its top before.
    PassInAir(f64),
    /// A tool that is narrower than the hole in which it works, and goes no deeper.
    NothingLeft {
        /// The diameter of the tool.
        tool: f64,
        /// That of the hole.
        hole: f64,
    },
    /// A reamer without a hole, one that goes deeper than its hole, or one that has to take away too much.
    ReamedWrongly {
        /// Which of these.
        what: &'static str,
        /// How deep it goes, or its diameter.
        value: f64,
        /// The same of the hole.
        other: f64,
    },
    /// A hole that is milled as if it were drilled before, at a place where no hole is, though there are such holes.
    NotPreDrilled([f64; 2]),
    /// A tool that plunges into material by so much per revolution.
    FastPlunge(f64),
    /// A tool that goes sideways through solid material with so many times the feed of its call.
    FastCut(f64),
    /// A tool that cuts sideways, and takes so much per revolution.
    FastMilling(f64),
    /// A tool that goes sideways through solid material with so many times the feed of its other cuts.
    TenfoldFeed(f64),
    /// A hole in a tilted plane that does not meet the blank, at a place of that plane.
    MissesBlankInTiltedPlane,
    /// A tool that only cuts along its axis goes sideways through material.
    SidewaysWithDrill,
    /// The tip of a tool for chamfers goes through solid material beside an edge of the blank.
    ChamferInside {
        /// How deep it is in there.
        depth: f64,
        /// How far inside of the edge.
        edge: f64,
    },
    /// The tool goes down to a height before it was positioned in the plane.
    DownBeforePositioned(f64),
    /// A tool that has cut at all of so many equal angles of a turn but one.
    RotationsLackOne(usize),
    /// A path that the same tool has gone under another transformation.
    PathTwice,
    /// A contour with RL or RR that is gone along at a height below the top of the blank.
    ContourAt {
        /// The line of its block.
        line: usize,
        /// The line of the tool call.
        call: usize,
        /// How high the tool is.
        height: f64,
    },
    /// Lines to and fro over the blank that leave ribs.
    RibsLeft {
        /// How far they are apart.
        step: f64,
        /// How wide the tool is.
        width: f64,
    },
    /// The only hole of a tool, at a place whose exchanged coordinates are those of a pocket.
    PilotHoleExchanged([f64; 2]),
    /// How many holes are made after a tool call, all cycles and places together.
    HolesMade(usize),
    /// A contour that other blocks of the same tool have gone before, from another place.
    ContourCopied,
    /// A curve that begins in the blank and comes back there, but is outside of it at a place.
    CurveLeavesBlank([f64; 2]),
    /// A path that removes nothing, though the same blocks have cut under another transformation.
    PathInAir,
    /// A movement through material that has come back to the same way for the second time.
    PathRepeated,
    /// A tool call with an oversize that is greater than the radius of the tool.
    Oversize {
        /// The number of the tool.
        tool: f64,
        /// The oversize.
        value: f64,
        /// The radius in the table.
        radius: f64,
    },
    /// A tool whose name says that it is there for something else.
    Misused {
        /// Its number.
        tool: f64,
        /// What its name says.
        kind: ToolKind,
        /// The cycle with which it cuts.
        cycle: CycleKey,
    },
    /// A tool that has done before what no such tool does.
    ToolHasOtherJob {
        /// The cycle with which it cuts.
        cycle: CycleKey,
        /// The one with which it has cut before.
        before: CycleKey,
    },
    /// A deepened starting point below the bottom of the hole that is there.
    StartBelowPilotHole {
        /// The height at which it starts.
        start: f64,
        /// The bottom of the hole.
        bottom: f64,
    },
    /// A contour that comes back to a corner which it has already.
    CornerPassedTwice([f64; 2]),
    /// A hole that was not centred, while a place that was centred stays without one.
    NotCentred([f64; 2]),
    /// A core hole in which no thread is cut, although it is cut in others of the same row.
    Untapped([f64; 2]),
    /// The only hole of a row that was not centred.
    OnlyOneNotCentred([f64; 2]),
    /// The only centred place of a row to which no tool comes.
    CentredInVain([f64; 2]),
    /// The same as `Untapped` of a hole that is not reamed.
    Unreamed([f64; 2]),
    /// A place that a circle of holes lacks.
    GapInCircle([f64; 2]),
    /// The corner of a rectangle of four holes, of which one lies elsewhere.
    CornerOfRectangleOff([f64; 2]),
    /// A hole that the edge of the blank cuts.
    HoleCutByEdge([f64; 2]),
    /// A tool that turns inside or outside, and is named or was used for the other side: which of these.
    TurnedOnOtherSide(&'static str),
    /// A bar that goes below the bottom of the hole which was drilled.
    BoredBelowHole {
        /// How deep it goes.
        bar: f64,
        /// The bottom of the hole.
        hole: f64,
    },
    /// A bar that is wider than its hole, or begins to turn beside it.
    BarBesideHole {
        /// Which of these.
        what: &'static str,
        /// The diameter of the bar, or that at which it begins.
        bar: f64,
        /// That of the hole.
        hole: f64,
    },
    /// A turning tool that cuts through the wall of the part.
    WallTurnedThrough {
        /// The diameter of the other side.
        other: f64,
    },
    /// A cycle that turns only where nothing of the part is.
    TurnedInAir {
        /// The diameter at which it comes nearest.
        tool: f64,
        /// That of the part.
        part: f64,
    },
    /// A movement for which the feed 0 is active.
    NoFeed,
    /// A tool drills or mills while the spindle turns counter-clockwise.
    SpindleBackwards,
    /// The control refuses a cycle with a message of its own, with the cycle and the code of the message.
    Refused(CycleKey, &'static str),
}
