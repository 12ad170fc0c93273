//! The command line: exit code and error chain, no more.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::main() {
        Ok(code) => code.into(),
        Err(error) => {
            cli::complain(&error);
            cli::Code::of(&error).into()
        }
    }
}
