//! Contours: elements, the path of the tool next to them, the ways to them and away from them.
//!
//! Start reading at [`path`] (radius compensation, roundings, chamfers); [`element`] has the geometry, [`free`] calculates
//! elements that are described by other data than their ends. Invariant: moves
//! the tool by the drives alone; knows blocks of movement, and neither parameters nor cycles.
pub(crate) mod approach;
pub(crate) mod breaks;
pub(crate) mod element;
pub(crate) mod free;
pub(crate) mod path;
pub(crate) mod recess;
pub(crate) mod undercut;
