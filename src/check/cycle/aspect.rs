//! What the checker follows of the control's state, aspect by aspect.
//!
//! Invariant: an aspect is certainly so, certainly not so, or unknown; nothing here says when it changes.

/// Whether something is so: no, yes, or not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tri {
    /// Certainly not.
    No = 1,
    /// Certainly.
    Yes = 2,
    /// On some ways, or it depends on what the program does not say.
    Unknown = 3,
}

impl Tri {
    /// The answer of what is known to be true or false.
    pub fn of(known: Option<bool>) -> Self {
        known.map_or(Self::Unknown, |known| if known { Self::Yes } else { Self::No })
    }

    /// True or false, if it is known.
    pub fn known(self) -> Option<bool> {
        match self {
            Self::No => Some(false),
            Self::Yes => Some(true),
            Self::Unknown => None,
        }
    }
}

impl Aspect {
    /// The axes of a datum shift that are followed one by one, with their names.
    pub(in crate::check) const SHIFTS: [(Self, &'static str); 3] =
        [(Self::ShiftX, "X"), (Self::ShiftY, "Y"), (Self::ShiftZ, "Z")];
}

/// What is followed through the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// A tool call has named the tool axis.
    Tool,
    /// A spindle speed has been programmed.
    Speed,
    /// The spindle turns.
    Spindle,
    /// A feed has been programmed.
    Feed,
    /// A circle centre or pole has been set.
    Pole,
    /// Radius compensation is active.
    Compensation,
    /// The working plane is tilted.
    Tilting,
    /// A mirror image is active.
    Mirroring,
    /// A scaling factor is active.
    Scaling,
    /// Scaling by axes is active.
    AxisScaling,
    /// A datum shift is active.
    DatumShift,
    /// A rotation is active.
    Rotation,
    /// Turning mode.
    Turning,
    /// A pattern of points is there.
    Pattern,
    /// A contour has been named.
    Contour,
    /// The data that contour cycles share have been defined.
    ContourData,
    /// The control holds the tool tip in its place while rotary axes move (M128, TCPM).
    Tcpm,
    /// The spindle was reported to turn counter-clockwise.
    Counterclockwise,
    /// The tool axis is another one than Z.
    OtherAxis,
    /// The tool has probed a workpiece.
    Probed,
    /// The tool has machined a workpiece.
    Cut,
    /// A program has been selected.
    Selected,
    /// A tool call has given a feed that is not 0.
    ToolFeed,
    /// A basic rotation is active.
    BasicRotation,
    /// A cycle has stopped the spindle, and nothing has started it since.
    Stopped,
    /// Feeds are those of a revolution (M136).
    PerRevolution,
    /// A cycle has aligned the turning system for the tool.
    Aligned,
    /// Another tool was called, and nothing has turned the spindle on since.
    Unstarted,
    /// A datum shift along X is active.
    ShiftX,
    /// The same along Y.
    ShiftY,
    /// The same along Z.
    ShiftZ,
}
