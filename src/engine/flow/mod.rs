//! The flow of a program: calls and repeats, prepared programs, Q parameters, units, definitions of cycles.
pub(in crate::engine) mod calls;
pub(in crate::engine) mod code;
pub(in crate::engine) mod definition;
pub(in crate::engine) mod params;
pub(in crate::engine) mod unit;
