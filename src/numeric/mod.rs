//! Numeric kernels that several algorithms share, written once for every quantity or precision that they serve.

mod lateral_inhibition;
mod quadratic;
mod ramp;

pub use lateral_inhibition::perceived;
pub use quadratic::sphere_roots;
pub use ramp::{Linear, Ramp, interpolate};
