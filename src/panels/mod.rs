//! The panels: what each draws of a run at its step. A picture depends on a [`PanelInput`] and its size alone.

mod active_edges;
mod channels;
mod code;
mod comparison;
mod convergence;
mod difference;
#[cfg(test)]
pub(crate) mod fixture;
#[cfg(test)]
mod fixtures;
mod form_factor;
mod formula;
mod illumination;
mod image;
mod inspector;
mod matrix;
mod message;
mod names;
mod profile;
mod race;
mod radiosity;
mod ray_tree;
mod rays;
mod scan_line;
pub mod strings;
mod time_line;
mod values;
mod vectors;
mod vertex;

pub use formula::{Evaluated, evaluated};
pub use names::kind as kind_name;
pub use ray_tree::TreeView;
pub use ray_tree::{area as tree_area, middle as tree_middle};
pub use rays::{Grip, grip};
pub use time_line::step_at;
pub use vectors::{Held, PlaneGrip, grip as vector_grip};

use crate::algorithms::focus::Focus;
use crate::language::Message;
use crate::picture::Picture;
use crate::render::{DrawPatches, Finished};
use crate::replay::Run;
use glam::Vec2;
use strings::Language;

macro_rules! panels {
    ($($(#[$doc:meta])* $panel:ident: $module:ident $name:literal titled $title:literal $(compares $compares:literal)?,)*) => {
        named! {
            /// A panel, by what it shows.
            pub enum Panel {
                $($(#[$doc])* $panel = $name,)*
            }
        }

        impl Panel {
            pub fn title(self) -> Message {
                match self {
                    $(Panel::$panel => Message($title),)*
                }
            }

            /// Whether it shows the pictures of several methods.
            pub fn compares(self) -> bool {
                match self {
                    $(Panel::$panel => false $(|| $compares)?,)*
                }
            }
        }

        /// The picture of a panel, `size` points large, without title or frame.
        pub fn draw(panel: Panel, input: &PanelInput, size: Vec2) -> Picture {
            match panel {
                $(Panel::$panel => $module::draw(input, size),)*
            }
        }
    };
}

panels! {
    /// The picture so far.
    Image: image "image" titled "app-image",
    /// The current polygon, its edges, the scan line, the span and the pixel.
    ScanLine: scan_line "scan-line" titled "app-scan-line",
    /// The table of active edges.
    ActiveEdges: active_edges "active-edges" titled "app-active-edges",
    /// The current vertex: face normals, their mean, and the vectors of the illumination model.
    Vertex: vertex "vertex" titled "app-vertex",
    /// The binary ray tree of the current pixel.
    RayTree: ray_tree "ray-tree" titled "app-ray-tree",
    /// The vectors where the current ray meets a surface, in the plane of incidence.
    Vectors: vectors "vectors" titled "app-vectors",
    /// The rays of the pixel among the objects, from the side and from above.
    Rays: rays "rays" titled "app-rays",
    /// The terms of the point that is lit, and the slide's factor against the standard one.
    Illumination: illumination "illumination" titled "app-illumination",
    /// The patches of the enclosure, each in its light, with the current exchange.
    Radiosity: radiosity "radiosity" titled "app-radiosity",
    /// Two patches, and the form factor between them as it is computed.
    FormFactor: form_factor "form-factor" titled "app-form-factor",
    /// The form factors of the system, row by row.
    Matrix: matrix "matrix" titled "common-matrix-of-form-factors",
    /// Residual and error bound, iteration by iteration.
    Convergence: convergence "convergence" titled "app-convergence",
    /// All solvers on the same enclosure, by iteration and by time.
    Race: race "race" titled "app-race",
    /// The picture by several methods side by side.
    Comparison: comparison "comparison" titled "app-comparison" compares true,
    /// How far each is from the reference.
    Difference: difference "difference" titled "app-difference" compares true,
    /// Intensity along a scan line, its slope, and how it looks.
    Profile: profile "profile" titled "app-profile" compares true,
    /// All values of the step, and where each comes from.
    Inspector: inspector "inspector" titled "app-inspector",
    /// The pseudocode, with the current line.
    Code: code "code" titled "app-code",
    /// The formula of the step, with symbols and with numbers.
    Formula: formula "formula" titled "app-formula",
    /// Scopes as nested bars, marks and the cursor.
    TimeLine: time_line "time-line" titled "app-time-line",
}

/// All that a panel's picture depends on.
#[derive(Clone, Copy)]
pub struct PanelInput<'a> {
    /// The recorded run, at the step that is shown.
    pub run: &'a Run,
    /// What was found for the run beside its steps.
    pub finished: &'a Finished,
    /// The part of the frame that the run recorded.
    pub focus: Focus,
    pub language: Language,
    /// Narrated steps, ascending.
    pub narrated: &'a [usize],
    /// Steps at which playing stops, ascending.
    pub breakpoints: &'a [usize],
    /// Which part of the ray tree is shown.
    pub tree: &'a TreeView,
    /// How patches are drawn whose light is interpolated between their corners; none where each has one colour.
    pub smooth: Option<DrawPatches>,
}
