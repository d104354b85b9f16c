//! Numeric kernels that several algorithms share, written once for every quantity or precision that they serve.

mod differences;
mod highlight;
mod lateral_inhibition;
mod lu;
mod power_table;
mod quadratic;
mod ramp;
mod random;
mod refraction;
mod slopes;
mod taylor;

pub use differences::Differences;
pub use highlight::{power_of_chord, power_of_cosine};
pub use lateral_inhibition::perceived;
pub use lu::Lu;
pub use power_table::PowerTable;
pub use quadratic::{plain_sphere_roots, sphere_roots};
pub use ramp::{Linear, Ramp, interpolate};
pub use random::Random;
pub use refraction::{refracted, refraction_radicand};
pub use slopes::slopes;
pub use taylor::{LinearNormal, Quadratic};
