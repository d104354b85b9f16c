//! The parts of which figures are composed, for panels and studies alike: a panel says what is plotted, this floor knows how.
//!
//! It uses [`crate::picture`], colours and numbers, and knows no algorithm: values and labels come in ready to be drawn.

mod log_axes;
mod viridis;

pub use log_axes::LogAxes;
pub use viridis::viridis;
