//! The parts of which figures are composed, for panels and studies alike: a panel says what is plotted, this floor knows how.
//!
//! It uses [`crate::picture`], colours and the writing of numbers, and knows no algorithm: values and labels come in ready to be drawn.

mod arrow;
mod colors;
mod fit;
mod labels;
mod plot;
mod scale;
mod series;
mod solid;
mod space;
mod table;
mod view;

pub use arrow::{Arrow, cross, disc};
pub use colors::{color_strip, diverging, gradient, viridis};
pub use fit::{Fit, Projection};
pub use labels::{Labels, crosses, within};
pub use plot::{Axis, Plot};
pub use scale::{Scale, Unit};
pub use series::{LEGEND_ROW, LEGEND_SAMPLE, Mark, Series, legend};
pub use solid::{Depths, Solids};
pub use space::{Seen, Space};
pub use table::{Cell, Row, elided, joined, mono_or_narrow};
pub use view::View;
