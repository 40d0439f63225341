//! Strategies that turn: shoulders, contours, recesses and threads.
//!
//! Start reading at [`shoulder`], which says what is turned, then [`cuts`], which turns it; [`contour`] does both for the
//! contour of a subprogram, [`groove_shape`] and [`recess`] for grooves, [`thread`] for threads. [`area`] and [`groove`] are
//! what is turned as the cuts see it; [`system`] sets up the coordinate system before. Invariant: coordinates of
//! the main axis are radii, whatever the program says.
pub mod area;
pub mod contour;
pub mod cuts;
pub mod groove;
pub mod groove_shape;
mod insert_report;
pub mod recess;
pub mod shoulder;
pub mod system;
pub mod thread;
