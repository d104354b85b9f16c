//! The scan-line methods that light surfaces, as they stand in the list of `algorithms`.

use super::{Draw, Family, Properties, Setup, ShadingMethod, Visitor};
use crate::algorithms;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::shading::Shading;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

macro_rules! shading_methods {
    ({} $($(#[$about:meta])* $name:ident: $module:ident,)*) => {$(
        pub use algorithms::$module::$name;

        impl Properties for $name {
            const NAME: &'static str = <$name as Shading>::NAME;
            const FAMILY: Family = Family::Polygons;
            const PARTS: &'static [Part] = <$name as Shading>::PARTS;

            fn visit<V: Visitor>(visitor: V) -> V::Output {
                visitor.shading::<Self>()
            }
        }

        impl Draw for $name {
            type Event = algorithms::$module::Event;

            fn draw<R: Recorder<Self::Event>>(
                setup: &Setup,
                focus: Focus,
                frame: &mut Frame,
                _: impl Search,
                recorder: &mut R,
            ) {
                algorithms::$module::$module(&setup.shaded_scene(), focus, frame, recorder);
            }
        }

        impl ShadingMethod for $name {}
    )*};
}

with_shading_methods! { shading_methods! {} }
