//! Strategies that turn: shoulders, contours, recesses and threads.
//!
//! Start reading at [`shoulder`], which says what is turned, then [`cuts`], which turns it; [`groove_shape`] and [`recess`]
//! do the same for grooves. [`profile`] and [`groove`] are what is turned as the cuts see it. Invariant: coordinates of
//! the main axis are radii, whatever the program says.
pub mod contour;
pub mod cuts;
pub mod groove;
pub mod groove_shape;
mod insert;
pub mod profile;
pub mod recess;
pub mod shoulder;
pub mod system;
pub mod thread;
