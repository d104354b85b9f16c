//! Numeric kernels that several algorithms share, written once for every quantity or precision that they serve.

mod compensated;
mod differences;
mod drift;
mod fixed;
mod highlight;
mod lateral_inhibition;
mod lu;
mod plane;
mod power_table;
mod quadratic;
mod ramp;
mod random;
mod refraction;
mod taylor;

pub use compensated::CompensatedSum;
pub use differences::Differences;
pub use drift::{Arithmetic, Drift};
pub use fixed::Fixed;
pub use highlight::{power_of_chord, power_of_cosine};
pub use lateral_inhibition::perceived;
pub use lu::Lu;
pub use plane::{Plane, Setup};
pub use power_table::PowerTable;
pub use quadratic::{plain_sphere_roots, sphere_roots};
pub use ramp::{Linear, Ramp, interpolate};
pub use random::Random;
pub use refraction::{refracted, refraction_radicand};
pub use taylor::{LinearNormal, Quadratic};
