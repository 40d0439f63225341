//! The command `ciklo` as users start it: arguments, files, streams, signals, other programs.
mod bounds;
#[path = "../support/built.rs"]
mod built;
mod cli;
mod conform_protocol;
mod files;
mod hostile;
mod processes;
mod serve;
mod texts;
