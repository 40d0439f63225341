//! Strategies as actions of cycles: their arguments are calculated, they are executed by the drives.
//!
//! Start reading at [`strategy`], which names all of them. Invariant: each does one thing with the values that it is
//! given; none knows which cycle asked for it.
mod align;
mod clear;
mod face;
mod measure;
mod plunge;
mod strategy;
mod stud;
mod thread;
