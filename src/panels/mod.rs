//! The panels: what each draws of a run at its step. A picture depends on a [`PanelInput`] and its size alone.

mod active_edges;
mod code;
mod comparison;
mod convergence;
mod difference;
mod fit;
#[cfg(test)]
pub(crate) mod fixture;
#[cfg(test)]
mod fixtures;
mod form_factor;
mod formula;
mod illumination;
mod image;
mod inspector;
pub(crate) mod labels;
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

pub use ray_tree::TreeView;
pub use ray_tree::{area as tree_area, middle as tree_middle};
pub use rays::{Grip, grip};
pub use time_line::step_at;
pub use vectors::{Held, PlaneGrip, grip as vector_grip};

use crate::algorithms::focus::Focus;
use crate::picture::Picture;
use crate::render::{DrawPatches, Finished};
use crate::replay::Run;
use glam::Vec2;
use strings::Language;

/// A panel, by what it shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Panel {
    /// The picture so far.
    Image,
    /// The current polygon, its edges, the scan line, the span and the pixel.
    ScanLine,
    /// The table of active edges.
    ActiveEdges,
    /// The current vertex: face normals, their mean, and the vectors of the illumination model.
    Vertex,
    /// The binary ray tree of the current pixel.
    RayTree,
    /// The vectors where the current ray meets a surface, in the plane of incidence.
    Vectors,
    /// The rays of the pixel among the objects, from the side and from above.
    Rays,
    /// The terms of the point that is lit, and the slide's factor against the standard one.
    Illumination,
    /// The patches of the enclosure, each in its light, with the current exchange.
    Radiosity,
    /// Two patches, and the form factor between them as it is computed.
    FormFactor,
    /// The form factors of the system, row by row.
    Matrix,
    /// Residual and error bound, iteration by iteration.
    Convergence,
    /// All solvers on the same enclosure, by iteration and by time.
    Race,
    /// The picture by several methods side by side.
    Comparison,
    /// How far each is from the reference.
    Difference,
    /// Intensity along a scan line, its slope, and how it looks.
    Profile,
    /// All values of the step, and where each comes from.
    Inspector,
    /// The pseudocode, with the current line.
    Code,
    /// The formula of the step, with symbols and with numbers.
    Formula,
    /// Scopes as nested bars, marks and the cursor.
    TimeLine,
}

impl Panel {
    pub const ALL: [Panel; 20] = [
        Panel::Image,
        Panel::ScanLine,
        Panel::ActiveEdges,
        Panel::Vertex,
        Panel::RayTree,
        Panel::Vectors,
        Panel::Rays,
        Panel::Illumination,
        Panel::Radiosity,
        Panel::FormFactor,
        Panel::Matrix,
        Panel::Convergence,
        Panel::Race,
        Panel::Comparison,
        Panel::Difference,
        Panel::Profile,
        Panel::Inspector,
        Panel::Code,
        Panel::Formula,
        Panel::TimeLine,
    ];

    /// As on the command line and in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Panel::Image => "image",
            Panel::ScanLine => "scan-line",
            Panel::ActiveEdges => "active-edges",
            Panel::Vertex => "vertex",
            Panel::RayTree => "ray-tree",
            Panel::Vectors => "vectors",
            Panel::Rays => "rays",
            Panel::Illumination => "illumination",
            Panel::Radiosity => "radiosity",
            Panel::FormFactor => "form-factor",
            Panel::Matrix => "matrix",
            Panel::Convergence => "convergence",
            Panel::Race => "race",
            Panel::Comparison => "comparison",
            Panel::Difference => "difference",
            Panel::Profile => "profile",
            Panel::Inspector => "inspector",
            Panel::Code => "code",
            Panel::Formula => "formula",
            Panel::TimeLine => "time-line",
        }
    }

    /// Whether it shows the pictures of several methods.
    pub fn compares(self) -> bool {
        matches!(self, Panel::Comparison | Panel::Difference | Panel::Profile)
    }

    pub fn from_name(name: &str) -> Option<Self> {
        Panel::ALL.into_iter().find(|panel| panel.name() == name)
    }
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

/// The picture of a panel, `size` points large, without title or frame.
pub fn draw(panel: Panel, input: &PanelInput, size: Vec2) -> Picture {
    match panel {
        Panel::Image => image::draw(input, size),
        Panel::ScanLine => scan_line::draw(input, size),
        Panel::ActiveEdges => active_edges::draw(input, size),
        Panel::Vertex => vertex::draw(input, size),
        Panel::RayTree => ray_tree::draw(input, size),
        Panel::Vectors => vectors::draw(input, size),
        Panel::Rays => rays::draw(input, size),
        Panel::Illumination => illumination::draw(input, size),
        Panel::Radiosity => radiosity::draw(input, size),
        Panel::FormFactor => form_factor::draw(input, size),
        Panel::Matrix => matrix::draw(input, size),
        Panel::Convergence => convergence::draw(input, size),
        Panel::Race => race::draw(input, size),
        Panel::Comparison => comparison::draw(input, size),
        Panel::Difference => difference::draw(input, size),
        Panel::Profile => profile::draw(input, size),
        Panel::Inspector => inspector::draw(input, size),
        Panel::Code => code::draw(input, size),
        Panel::Formula => formula::draw(input, size),
        Panel::TimeLine => time_line::draw(input, size),
    }
}
