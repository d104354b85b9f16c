//! Drivers that try the program with random input of every kind, deterministic: a case is its seed.
//!
//! `cargo test` tries some thousand cases of each kind in about a minute. By hand for as long as one likes, behind those:
//! `ATTACK_SECONDS=3600 cargo test --release --test attack -- --nocapture`. `ATTACK_SEED=N` begins at another case, such as one that
//! failed.

mod command_lines;
mod commands;
mod glb;
mod json;
mod kit;
mod lessons;
mod line;
mod meshes;
mod panels;
mod scenes;
mod written;
