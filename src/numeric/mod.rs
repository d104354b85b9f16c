//! Numeric kernels that several algorithms share, written once for every quantity or precision that they serve.

mod compensated;
mod differences;
mod drift;
mod fixed;
mod plane;
mod power_table;
mod quadratic;
mod ramp;
mod taylor;

pub use compensated::CompensatedSum;
pub use differences::Differences;
pub use drift::{Arithmetic, Drift};
pub use fixed::Fixed;
pub use plane::{Plane, Setup};
pub use power_table::PowerTable;
pub use quadratic::sphere_roots;
pub use ramp::{Linear, Ramp, interpolate};
pub use taylor::{LinearNormal, Quadratic};
