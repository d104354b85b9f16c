//! A recorded run, walked forward and back: [`Timeline`] finds the state at any step, [`Replay`] stands at one of them and
//! walks by [`moves`], [`query`] searches, and [`Canvas`] keeps pictures whose copies cost little.
//!
//! A state is a fold: what it is at a step follows from the events up to that step alone. Going back is seeking.

mod canvas;
mod cow_vec;
mod current;
mod cursor;
mod fan;
pub mod form_factor;
#[cfg(test)]
mod generators;
pub mod hierarchical;
pub mod moves;
pub mod query;
pub mod radiosity;
pub mod rays;
mod run;
pub mod shading;
mod timeline;
mod vector_plane;
pub mod wireframe;

pub use canvas::{Canvas, MAX_SIDE};
pub use cursor::{Replay, Walk};
pub use fan::{FanRay, fan};
pub use query::{Comparison, Condition, Operand, Query, QueryError};
pub use run::{Run, WalkOf};
pub use timeline::{Fold, RecordedField, Timeline};
pub use vector_plane::VectorPlane;
