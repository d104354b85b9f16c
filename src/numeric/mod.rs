//! Numeric kernels that several algorithms share, written once for every quantity or precision that they serve.

mod highlight;
mod quadratic;
mod ramp;
mod refraction;

pub use highlight::{power_of_chord, power_of_cosine};
pub use quadratic::{plain_sphere_roots, sphere_roots};
pub use ramp::{Linear, Ramp, interpolate};
pub use refraction::{refracted, refraction_radicand};
