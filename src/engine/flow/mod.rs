//! A program under execution: where it is, what it has called, which values it has given, which cycles it has defined.
//!
//! Start reading at [`state`]: its `Run` has the parts of a run, each of which can be borrowed apart. Invariant: no block
//! and no action of a cycle is executed here; `engine::cycle` executes plans, `engine::run` blocks.
pub(crate) mod access;
pub(crate) mod calling;
pub(crate) mod calls;
pub(crate) mod code;
pub(crate) mod definition;
pub(crate) mod exec;
pub(crate) mod memory;
pub(crate) mod settings;
pub(crate) mod sources;
pub(crate) mod state;
mod values;
