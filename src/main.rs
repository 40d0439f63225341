//! The command `ciklo`.
use std::process::ExitCode;

fn main() -> ExitCode {
    ciklo::cli::main(ciklo::system::arguments())
}
