//! The events of form factors.

use crate::record::Listing;
use glam::DVec3;

/// One event a sample, an edge, a pair of edges, a pixel. Exchanges and sums are A_i F_ij, unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// What F_ij is by a method more exact than the one that is looked at.
    Reference { f: f64 },
    /// Opens F from patch `i` to patch `j`.
    FormFactor {
        i: u32,
        j: u32,
        method: &'static str,
    },
    /// Nothing passes between two pieces, and nothing was integrated.
    FacesAway,
    /// A piece of each patch, as far as they lie in front of each other: corners and areas.
    Pieces { corners: [u32; 2], areas: [f64; 2] },
    /// The centres of the two pieces.
    Centers { i: DVec3, j: DVec3 },
    /// What an automatic choice fell on, by distance and radii.
    Chosen {
        method: &'static str,
        distance: f64,
        radii: [f64; 2],
        points: u32,
    },
    /// The two points of a sample.
    Points { x: DVec3, y: DVec3 },
    /// What a pair of points exchanges.
    Pair {
        cos_x: f64,
        cos_y: f64,
        r: f64,
        /// Weights of the points x and y.
        weights: [f64; 2],
        term: f64,
        sum: f64,
    },
    /// Opens the form factor of an element; `element` counts within the form factor between the patches.
    Element { element: u32, x: DVec3, weight: f64 },
    /// An edge of the polygon that the element sees, and the angle that it spans.
    Edge {
        edge: u32,
        from: DVec3,
        to: DVec3,
        angle: f64,
    },
    /// What the edge adds to `sum`, F of the element.
    EdgeAdded { term: f64, sum: f64 },
    /// Closes `Element`.
    ElementSeen { f: f64, sum: f64 },
    /// An edge of one patch with an edge of the other.
    EdgePair {
        edges: [u32; 2],
        cosine: f64,
        way: &'static str,
        integral: f64,
        sum: f64,
    },
    /// Opens a batch of rays, which are counted from 1.
    Rays { first: u32, last: u32 },
    /// Closes `Rays`: F_ij by all rays so far, and its standard error, if they were independent.
    RaysCast { rays: u32, f: f64, error: f64 },
    /// A ray from `x`; `hits` counts those that met `j` so far.
    Ray {
        x: DVec3,
        direction: DVec3,
        met: bool,
        hits: u32,
    },
    /// Opens a hemicube over a point of `i`; `hemicube` counts them, row by row.
    Hemicube {
        hemicube: u32,
        x: DVec3,
        resolution: u32,
    },
    /// A pixel that shows `j`; `sum` is F of the point.
    Pixel {
        face: u32,
        x: u32,
        y: u32,
        delta: f64,
        sum: f64,
    },
    /// Closes `Hemicube`; `mean` is over the points so far.
    HemicubeSeen { f: f64, mean: f64 },
    /// Opens a batch of lines of sight, which are counted from 1.
    Sights { first: u32, last: u32 },
    /// Closes `Sights`: the share that passes by all so far, and its standard error.
    SightsTaken { rays: u32, share: f64, error: f64 },
    /// Between two points something stands, or nothing. `share` is that of what passes so far.
    Sight {
        x: DVec3,
        y: DVec3,
        blocked: bool,
        share: f64,
    },
    /// What the element at `x` sees of the polygon: F of the whole, and of what no blocker hides.
    Seen { x: DVec3, whole: f64, visible: f64 },
    /// What passes between the patches, by so many rays, or by views from so many points.
    Visible { rays: u32, share: f64 },
    /// Closes `FormFactor`.
    FormFactorFound { exchange: f64, f: f64 },
}

const _: () = assert!(size_of::<Event>() <= 64);

pub static PSEUDOCODE: Listing = Listing {
    name: "form factor",
    lines: &[
        ("form-factor", "formFactor(i, j)"),
        ("", "  {for-each-piece-of-i-and-of-j}"),
        (
            "pieces",
            "    {clip-both-to-the-front-of-the-other-nothing-left-0}",
        ),
        ("", "    A_i F_ij ← A_i F_ij + {exchange-of-the-two}"),
        ("", "  A_i F_ij ← A_i F_ij · {share-that-nothing-blocks}"),
        ("found", "  {return} A_i F_ij / A_i"),
    ],
};
