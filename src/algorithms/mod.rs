//! The algorithms, one file each, in the terms of the literature. Each is generic over [`Recorder`](crate::record::Recorder):
//! the steps shown are those that ran.
//!
//! | file | what | source |
//! | --- | --- | --- |
//! | [`illumination`], [`incidence`], [`intensity`] | intensity at one point | Phong 1975, Blinn 1977 |
//! | [`scan_line`] | polygons to pixels: edge table, active edges, spans, depth buffer | Wylie et al. 1967, Catmull 1974 |
//! | [`wireframe`] | the edges alone | DDA, Foley et al. 1990 §3.2.1 |
//! | [`flat`] | one intensity per polygon | Bouknight 1970 |
//! | [`gouraud`] | intensity interpolated from the vertices | Gouraud 1971 |
//! | [`phong`] | normal interpolated from the vertices, lit at every pixel | Phong 1975 |
//! | [`fast_phong`] | cosines as Taylor series over a triangle | Bishop & Weimer 1986 |
//! | [`exact`] | lit with the normal of the true surface: the reference for the other three | |
//! | [`shading`], [`vertex_cache`] | what these have in common | |
//! | [`texture`] | textures on polygons, and what linear interpolation of (u, v) does to them | Heckbert & Moreton 1991 |
//! | [`primary`], [`visible`], [`surface`] | a ray per pixel, the nearest object that it meets, the point that is lit | Appel 1968 |
//! | [`ray_casting`] | the visible surface, lit | Appel 1968, Roth 1982 |
//! | [`ray_tracing`], [`ray_tree`] | shadows, reflection and refraction, and the tree of rays | Whitted 1980 |
//! | [`form_factor`] | the share of light that one patch sends to another, one file per method | Cohen & Greenberg 1985, Baum et al. 1989 |
//! | [`radiosity`] | solvers of the radiosity system: gathering, shooting, Chebyshev, conjugate gradients, LU | Goral et al. 1984, Cohen et al. 1988 |
//! | [`hierarchical`] | links between the elements of quadtrees, in place of a matrix | Hanrahan et al. 1991 |
//! | [`enclosure`], [`enclosure_needs`], [`enclosure_notes`], [`lamp_notes`], [`exchange`], [`accuracy`], [`patch_view`] | a scene's patches with their form factors and light, and the picture of it | Cohen & Greenberg 1985 |
//!
//! [`prepared_scene`] prepares a scene for its camera for all of them; [`focus`] selects the part of a frame that is drawn.

/// Makes an event type from the events of the parts that a method is made of.
macro_rules! contains_events {
    ($generics:tt $event:ty { $($part:ty => $wrap:expr,)* }) => {
        $(contains_events!($generics $event, $part, $wrap);)*
    };
    ([$($generics:tt)*] $event:ty, $part:ty, $wrap:expr) => {
        impl<$($generics)*> From<$part> for $event {
            fn from(event: $part) -> Self {
                let wrap: fn($part) -> Self = $wrap;
                wrap(event)
            }
        }
    };
}

/// Hands the scan-line methods that light surfaces to the macro `$then`, in the order of lists. A new one is a line here and its
/// file, with a function of the file's name, an `Event`, and a type that is [`shading::Shading`].
macro_rules! with_shading_methods {
    ($then:ident! { $($more:tt)* }) => {
        $then! {
            { $($more)* }
            Flat: flat,
            Gouraud: gouraud,
            Phong: phong,
            FastPhong: fast_phong,
            /// With the normals of the true surfaces.
            Exact: exact,
        }
    };
}

pub mod accuracy;
pub mod enclosure;
pub mod enclosure_needs;
pub mod enclosure_notes;
pub mod exact;
pub mod exchange;
pub mod fast_phong;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod flat;
pub mod focus;
pub mod form_factor;
pub mod frame;
pub mod gouraud;
pub mod hierarchical;
pub mod illumination;
pub mod incidence;
pub mod intensity;
pub mod lamp_notes;
pub mod patch_view;
pub mod phong;
mod place;
pub mod prepared_scene;
pub mod primary;
pub mod radiosity;
pub mod ray_casting;
pub mod ray_tracing;
pub mod ray_tree;
pub mod scan_line;
pub mod shading;
pub mod surface;
pub mod texture;
pub mod vertex_cache;
pub mod vertex_normal;
pub mod visible;
pub mod wireframe;
