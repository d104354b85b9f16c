//! The methods, each as one value: its name, what it needs of a scene, which parts of its work can be recorded, and how it runs.
//!
//! Whatever depends on the method goes through [`Method`], or is a [`Visitor`] that is handed the method's type. The families in
//! which replay and panels tell methods apart are the visitor's. A new method of a family is a line in the list of that family:
//! of shading methods in [`algorithms`](crate::algorithms), of ray methods in `rays`.

mod count;
pub mod hierarchical;
mod look;
mod mistake;
mod notes;
pub mod radiosity;
mod rays;
mod settings;
mod setup;
mod shading;
mod wireframe;

use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::ray_tracing as algorithm;
use crate::algorithms::shading::ShadingEvent;
use crate::algorithms::visible::Search;
use crate::color::Rgb;
use crate::record::{self, Recorder};
use crate::scene::{Needs, Part};
use crate::vocabulary::Declared;

pub use count::Counted;
pub use hierarchical::HierarchicalRadiosity;
pub use mistake::Mistake;
pub use notes::notes_of;
pub use radiosity::Radiosity;
pub use rays::{RayCasting, RayTracing};
pub use settings::Settings;
pub use setup::{Outside, Setup};
pub use shading::*;
pub use wireframe::Wireframe;

/// What a method works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// It converts polygons, scan line by scan line.
    Polygons,
    /// It follows a ray through each pixel.
    Rays,
    /// Its patches exchange light.
    Exchange,
    /// Its elements exchange light over links.
    Hierarchy,
}

impl Family {
    /// What a lesson looks at that is made in the program, in a picture of that size.
    pub fn focus(self, size: [u32; 2]) -> Focus {
        let [x, y] = size.map(|side| side / 2);
        match self {
            Family::Polygons => Focus::ScanLine(y),
            Family::Rays => Focus::Pixel { x, y },
            Family::Exchange | Family::Hierarchy => Focus::Frame,
        }
    }

    /// By name: what a lesson shows that is made in the program.
    fn panels(self) -> [&'static str; 3] {
        match self {
            Family::Polygons => ["image", "scan-line", "inspector"],
            Family::Rays => ["image", "ray-tree", "space"],
            Family::Exchange => ["radiosity", "matrix", "convergence"],
            Family::Hierarchy => ["links", "radiosity", "image"],
        }
    }

    /// By name: what is shown of a scene that one walks through freely.
    pub fn panels_of_a_walk(self) -> [&'static str; 5] {
        match self {
            Family::Polygons => ["image", "scan-line", "active-edges", "vertex", "space"],
            Family::Rays => ["image", "ray-tree", "vectors", "illumination", "space"],
            Family::Exchange => ["radiosity", "image", "matrix", "convergence", "space"],
            Family::Hierarchy => ["links", "radiosity", "image", "inspector", "space"],
        }
    }

    /// Whether it finds the light of a room by its patches, and draws no pixel by pixel.
    pub fn exchanges_light(self) -> bool {
        matches!(self, Family::Exchange | Family::Hierarchy)
    }

    fn records(self, focus: Focus) -> bool {
        match focus {
            Focus::Frame => true,
            Focus::Polygon(_) => self == Family::Polygons,
            Focus::ScanLine(_) | Focus::Pixel { .. } => !self.exchanges_light(),
            Focus::Iterations { .. } | Focus::Patch(_) | Focus::FormFactor { .. } => {
                self == Family::Exchange
            }
        }
    }
}

/// What is known of a method without running it.
pub trait Properties {
    /// As on the command line and in lesson files.
    const NAME: &'static str;
    const FAMILY: Family;
    /// What of its work a scene may not need.
    const PARTS: &'static [Part];

    /// Hands the method's type to the visitor.
    fn visit<V: Visitor>(visitor: V) -> V::Output;
}

/// A method that draws pixels into a frame.
pub trait Draw {
    type Event: record::Event + Declared;

    /// Draws what `focus` takes of the frame. `search` finds what a ray meets, where the method follows rays.
    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        search: impl Search,
        recorder: &mut R,
    );
}

/// A scan-line method that lights surfaces.
pub trait ShadingMethod: Draw<Event: ShadingEvent> {}

/// A method that colours each pixel by itself, by the rays through it. Its events are those of ray tracing, or fewer.
pub trait RayMethod: Draw<Event: Into<algorithm::Event>> {
    type Tracer<'a, S: Search + Sync + 'a>: Sync;

    fn tracer<'a, S: Search + Sync>(
        setup: &'a Setup,
        needs: &'a Needs,
        search: S,
    ) -> Self::Tracer<'a, S>;

    fn pixel<S: Search + Sync, R: Recorder<Self::Event>>(
        tracer: &Self::Tracer<'_, S>,
        x: u32,
        y: u32,
        recorder: &mut R,
    ) -> Rgb;
}

/// Work that depends on the method's type.
pub trait Visitor: Sized {
    type Output;

    fn wireframe(self) -> Self::Output;
    fn shading<M: ShadingMethod>(self) -> Self::Output;
    fn rays<M: RayMethod>(self) -> Self::Output;
    fn radiosity(self) -> Self::Output;
    fn hierarchical(self) -> Self::Output;
}

/// Makes values of the types: of shading methods those that come from the list of `algorithms`, in their place among the others.
macro_rules! methods {
    ({ { $($first:ident)* } { $($last:ident)* } } $($(#[$about:meta])* $shading:ident: $_module:ident,)*) => {
        methods! { $($first)* $($(#[$about])* $shading)* $($last)* }
    };
    ($($(#[$about:meta])* $name:ident)*) => {
        named! {
            /// A way to make a picture of a scene.
            pub enum Method {
                $($(#[$about])* $name = $name::NAME,)*
            }
        }

        impl Method {
            pub fn family(self) -> Family {
                match self {
                    $(Method::$name => $name::FAMILY,)*
                }
            }

            /// What of its work a scene may not need.
            pub fn parts(self) -> &'static [Part] {
                match self {
                    $(Method::$name => $name::PARTS,)*
                }
            }

            pub fn visit<V: Visitor>(self, visitor: V) -> V::Output {
                match self {
                    $(Method::$name => $name::visit(visitor),)*
                }
            }
        }
    };
}

with_shading_methods! { methods! { { Wireframe } { RayCasting RayTracing Radiosity HierarchicalRadiosity } } }

impl Method {
    /// By name: what a lesson shows that is made in the program.
    pub fn panels(self) -> [&'static str; 3] {
        self.family().panels()
    }

    /// Whether it follows rays instead of converting polygons.
    pub fn follows_rays(self) -> bool {
        self.family() == Family::Rays
    }

    /// Whether it converts polygons, scan line by scan line.
    pub fn converts_polygons(self) -> bool {
        self.family() == Family::Polygons
    }

    /// Whether its runs draw pixel by pixel.
    pub fn draws_pixels(self) -> bool {
        !self.family().exchanges_light()
    }

    /// Whether that part of a run can be recorded.
    pub fn records(self, focus: Focus) -> bool {
        self.family().records(focus)
    }
}
