//! What happens to the blank where the tool goes, as `travel.rs` finds it and rules report it.

/// What happens to the blank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Incident {
    /// A rapid movement goes into it, down to a height.
    Rapid(f64),
    /// A movement at feed goes into it while the spindle is stationary.
    Standing,
    /// A tool call while the tool is inside of it, at a height.
    ToolChange(f64),
    /// A rotary axis turns at rapid while the tool is inside of it, at a height.
    Turn(f64),
    /// A hole next to it, at a place.
    Beside([f64; 2]),
    /// A hole that begins above it or below it, at a height.
    Surface(f64),
    /// A hole that goes through it, down to a height.
    Through(f64),
}
