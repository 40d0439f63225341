//! The command `ciklo`.
fn main() {}
