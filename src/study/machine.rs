//! What the times were taken on.

use serde_json::{Value as Json, json};
use std::num::NonZeroUsize;

/// The seed of every random number in a study.
pub const SEED: u64 = 0;

/// The machine, and how the program was built for it.
#[derive(Clone, Debug)]
pub struct Machine {
    /// Where it can be read.
    pub cpu: Option<String>,
    pub cores: usize,
    pub arch: &'static str,
    pub os: &'static str,
    /// Whether the compiler optimised: times of a debug build say little.
    pub optimised: bool,
}

impl Machine {
    /// This one; whoever may read files says what its processor is called.
    pub fn this(cpu: Option<String>) -> Self {
        Machine {
            cpu,
            cores: std::thread::available_parallelism().map_or(1, NonZeroUsize::get),
            arch: std::env::consts::ARCH,
            os: std::env::consts::OS,
            optimised: !cfg!(debug_assertions),
        }
    }

    pub fn json(&self) -> Json {
        json!({
            "cpu": self.cpu,
            "cores": self.cores,
            "arch": self.arch,
            "os": self.os,
            "optimised": self.optimised,
        })
    }

    /// In words.
    pub fn strings(&self) -> String {
        let cpu = self.cpu.as_deref().unwrap_or("an unnamed processor");
        let build = if self.optimised {
            "a release"
        } else {
            "a debug"
        };
        format!(
            "{cpu}, {} cores, {} {}, {build} build of lightwalk {}",
            self.cores,
            self.os,
            self.arch,
            env!("CARGO_PKG_VERSION")
        )
    }
}
