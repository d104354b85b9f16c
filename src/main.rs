//! The program: its command line, and the window behind it; in a page, the window.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    lightwalk::commands::run(std::env::args_os())
}

#[cfg(target_arch = "wasm32")]
fn main() {
    lightwalk::app::start();
}
