//! M functions: what each number does.
//!
//! Invariant: a number that is not listed here is a fault where it is programmed, never ignored.

/// Where the feed of an arc next to a contour is that of the cutting edge instead of the tool centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ArcFeed {
    /// Nowhere (`M111`).
    #[default]
    Centre,
    /// On all arcs (`M109`).
    Edge,
    /// On arcs inside which the tool runs, where the edge is faster than the centre (`M110`).
    EdgeInside,
}

/// What an M function does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    Stop,
    End,
    Spindle(i8),
    Coolant(bool),
    /// The spindle is at the angle of the last orientation that was defined.
    Orient,
    SpindleAndCoolant(i8),
    CallAlways,
    CallOnce,
    /// Coordinates of the block are machine coordinates.
    MachineCoordinates,
    /// The same from the second datum of the machine.
    SecondDatum,
    /// Coordinates of the block are those of the system that is not tilted.
    Untilted,
    /// The tool tip is held on the workpiece while rotary axes turn, or no longer.
    HoldTip(bool),
    /// Positions count from where the rotary axes have brought tool and workpiece, or no longer.
    CountAxes(bool),
    /// The tool moves away from the workpiece along its axis.
    Retract,
    /// Corners of the block are gone round in another way.
    Corner,
    /// On arcs the feed is that of the cutting edge: nowhere, everywhere, or only where the edge is faster.
    ArcFeed(ArcFeed),
    /// A slower feed downwards along the tool axis, by a factor.
    PlungeFactor,
    /// Rotary axes take the shorter way, or again the one that is written.
    ShorterWay(bool),
    /// Rotary axes are displayed below 360 degrees.
    ReduceDisplay,
    /// The basic rotation ends.
    EndBasicRotation,
    /// The turning spindle turns the workpiece: 1 clockwise, -1 counter-clockwise, 0 no longer.
    TurnWorkpiece(i8),
    /// Feeds are mm per revolution, or mm/min again.
    PerRevolution(bool),
    /// The feed of a rotary axis that turns alone is that at the tool, in mm/min; or in degrees/min again.
    FeedAtTool(bool),
    /// Only these rotary axes take part in tilting.
    TiltingAxes,
    /// It changes nothing that events say (tool change at the machine, display, look-ahead).
    Nothing,
}

pub(crate) fn effect(number: u16) -> Option<Effect> {
    Some(match number {
        0 | 1 => Effect::Stop,
        2 | 30 => Effect::End,
        3 => Effect::Spindle(1),
        4 => Effect::Spindle(-1),
        5 => Effect::Spindle(0),
        8 => Effect::Coolant(true),
        19 | 20 => Effect::Orient,
        9 => Effect::Coolant(false),
        13 => Effect::SpindleAndCoolant(1),
        14 => Effect::SpindleAndCoolant(-1),
        89 => Effect::CallAlways,
        99 => Effect::CallOnce,
        91 => Effect::MachineCoordinates,
        92 => Effect::SecondDatum,
        130 => Effect::Untilted,
        97 | 98 => Effect::Corner,
        140 => Effect::Retract,
        128 => Effect::HoldTip(true),
        129 => Effect::HoldTip(false),
        136 => Effect::PerRevolution(true),
        144 => Effect::CountAxes(true),
        145 => Effect::CountAxes(false),
        137 => Effect::PerRevolution(false),
        303 => Effect::TurnWorkpiece(1),
        304 => Effect::TurnWorkpiece(-1),
        305 => Effect::TurnWorkpiece(0),
        94 => Effect::ReduceDisplay,
        103 => Effect::PlungeFactor,
        109 => Effect::ArcFeed(ArcFeed::Edge),
        110 => Effect::ArcFeed(ArcFeed::EdgeInside),
        111 => Effect::ArcFeed(ArcFeed::Centre),
        126 => Effect::ShorterWay(true),
        127 => Effect::ShorterWay(false),
        116 => Effect::FeedAtTool(true),
        117 => Effect::FeedAtTool(false),
        138 => Effect::TiltingAxes,
        143 => Effect::EndBasicRotation,
        // 118: the handwheel; 124: points nearer than a tolerance may be left out; 134, 135: exact stop; 148, 149: lift-off.
        6 | 90 | 101 | 102 | 105 | 106 | 107 | 108 | 118 | 120 | 124 | 134 | 135 | 148 | 149 => Effect::Nothing,
        _ => return None,
    })
}
