//! The program: its command line, and the window behind it.

use std::process::ExitCode;

fn main() -> ExitCode {
    lightwalk::commands::run(std::env::args_os())
}
