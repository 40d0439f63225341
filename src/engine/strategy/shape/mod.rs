//! Strategies that mill a shape given by the values of a cycle: pockets, slots, studs, faces, threads, engraved text.
//!
//! Start reading at [`pocket_and_slot`]. Invariant: none of them knows a contour of a program.
pub mod engraving;
pub mod face;
pub mod font;
pub mod plunge;
pub mod pocket_and_slot;
pub mod stud;
pub mod thread;
