//! Numeric kernels that several algorithms share, written once for every quantity that can be interpolated.

mod ramp;

pub use ramp::{Linear, Ramp, interpolate};
