//! The algorithms by laws, closed forms and second opinions.

#[path = "../common/mod.rs"]
mod common;
mod formulas;
mod laws;
mod needs;
mod occluded;
mod rays;
mod rooms;
mod runs;
mod scopes;
mod shading;
