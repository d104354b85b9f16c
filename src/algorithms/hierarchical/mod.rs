//! Hierarchical radiosity (Hanrahan, Salzman & Aupperle 1991, "A rapid hierarchical radiosity algorithm"): patches that are far apart
//! exchange their light as one, so that n patches need some multiple of n links instead of n² form factors.
//!
//! | file | what | the paper's name |
//! | --- | --- | --- |
//! | [`tree`] | each surface as a quadtree of elements | `Quadnode`, `Subdiv` |
//! | [`link`] | the exchange of two elements as one number | `Linknode`, `FormFactorEstimate`, `VisibilityEstimate` |
//! | `oracle` | the error that a link may have | `OracleF`, `OracleBF` |
//! | `refine` | a pair is linked, or the larger one divided | `Refine`, `RefineLink` |
//! | `gather` | light over the links, at the level of each | `GatherRad` |
//! | `push_pull` | the light of all levels put together | `PushPullRad` |
//! | [`hierarchy`] | passes from coarse to fine (multigridding) | `SolveSystem`, `Bs`, `Bg` |
//!
//! A link that is allowed no light at all leads to the finest patches, where the result is that of the full matrix.

mod event;
mod gather;
pub mod hierarchy;
pub mod link;
mod oracle;
mod push_pull;
mod refine;
mod settings;
#[cfg(test)]
mod tests;
pub mod tree;

pub use event::{Event, PSEUDOCODE};
pub use hierarchy::{Hierarchy, Unsolved};
pub use settings::{NotAllowed, Settings};
