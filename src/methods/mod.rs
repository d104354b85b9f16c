//! The methods, each as one value: its name, what it needs of a scene, which parts of its work can be recorded, and how it runs.
//!
//! Whatever depends on the method goes through [`Method`], or is a [`Visitor`] that is handed the method's type. The families in
//! which replay and panels tell methods apart are the visitor's: a new shading method is one file here, and one line in the list.

mod count;
pub mod exact;
pub mod fast_phong;
pub mod flat;
pub mod gouraud;
mod notes;
pub mod phong;
pub mod radiosity;
pub mod ray_casting;
pub mod ray_tracing;
mod setup;
pub mod wireframe;

use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::ray_tracing as algorithm;
use crate::algorithms::shading::{self, Shading};
use crate::algorithms::visible::Search;
use crate::color::Rgb;
use crate::record::{self, Recorder};
use crate::scene::{Needs, Part};
use crate::vocabulary::Declared;

pub use count::Counted;
pub use notes::notes_of;
pub use setup::{Outside, Settings, Setup};

/// What a method works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// It converts polygons, scan line by scan line.
    Polygons,
    /// It follows a ray through each pixel.
    Rays,
    /// Its patches exchange light.
    Exchange,
}

impl Family {
    /// What a lesson looks at that is made in the program, in a picture of that size.
    pub fn focus(self, size: [u32; 2]) -> Focus {
        let [x, y] = size.map(|side| side / 2);
        match self {
            Family::Polygons => Focus::ScanLine(y),
            Family::Rays => Focus::Pixel { x, y },
            Family::Exchange => Focus::Frame,
        }
    }

    fn records(self, focus: Focus) -> bool {
        match focus {
            Focus::Frame => true,
            Focus::Polygon(_) => self == Family::Polygons,
            Focus::ScanLine(_) | Focus::Pixel { .. } => self != Family::Exchange,
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
    /// By name: what a lesson shows that is made in the program.
    const PANELS: &'static [&'static str];

    /// Whether it does that part of the work, where the scene needs it.
    fn does(part: Part) -> bool;

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

/// An event of such a method: one that all of them have, or one of its own.
pub trait ShadingEvent: record::Event {
    type Shading: Shading;

    fn shading(&self) -> Option<&shading::Event<Self::Shading>>;
}

impl<M: Shading> ShadingEvent for shading::Event<M> {
    type Shading = M;

    fn shading(&self) -> Option<&Self> {
        Some(self)
    }
}

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
}

macro_rules! methods {
    ($($(#[$doc:meta])* $name:ident: $module:ident,)*) => {
        named! {
            /// A way to make a picture of a scene.
            pub enum Method {
                $($(#[$doc])* $name = $module::$name::NAME,)*
            }
        }

        impl Method {
            /// By name: what a lesson shows that is made in the program.
            pub fn panels(self) -> &'static [&'static str] {
                match self {
                    $(Method::$name => $module::$name::PANELS,)*
                }
            }

            pub fn family(self) -> Family {
                match self {
                    $(Method::$name => $module::$name::FAMILY,)*
                }
            }

            /// Whether it does that part of the work, where the scene needs it.
            pub fn does(self, part: Part) -> bool {
                match self {
                    $(Method::$name => $module::$name::does(part),)*
                }
            }

            pub fn visit<V: Visitor>(self, visitor: V) -> V::Output {
                match self {
                    $(Method::$name => $module::$name::visit(visitor),)*
                }
            }
        }
    };
}

methods! {
    Wireframe: wireframe,
    Flat: flat,
    Gouraud: gouraud,
    Phong: phong,
    FastPhong: fast_phong,
    /// With the normals of the true surfaces.
    Exact: exact,
    RayCasting: ray_casting,
    RayTracing: ray_tracing,
    Radiosity: radiosity,
}

impl Method {
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
        self.family() != Family::Exchange
    }

    /// Whether that part of a run can be recorded.
    pub fn records(self, focus: Focus) -> bool {
        self.family().records(focus)
    }
}
