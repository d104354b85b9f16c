//! What form factors tell of themselves.

use super::{area_to_area, auto, contour, element_to_polygon, hemicube, monte_carlo, visibility};
use crate::record::{self, Fields, Line, Listing};
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
        term: f64,
        sum: f64,
    },
    /// Opens the form factor of an element.
    Element { x: DVec3, weight: f64 },
    /// An edge of the polygon that the element sees: from `corner` to the next. `sum` is F of the element.
    Edge {
        edge: u32,
        corner: DVec3,
        angle: f64,
        term: f64,
        sum: f64,
    },
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
    /// A ray from `x`; `hits` counts those that met `j` so far.
    Ray {
        x: DVec3,
        direction: DVec3,
        met: bool,
        hits: u32,
    },
    /// Opens a hemicube over a point of `i`.
    Hemicube { x: DVec3, resolution: u32 },
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
    /// Between two points something stands, or nothing. `share` is that of what passes so far.
    Sight {
        x: DVec3,
        y: DVec3,
        blocked: bool,
        share: f64,
    },
    /// What passes between the patches, of so many rays.
    Visible { rays: u32, share: f64 },
    /// Closes `FormFactor`.
    FormFactorFound { exchange: f64, f: f64 },
}

const _: () = assert!(size_of::<Event>() <= 64);

pub static PSEUDOCODE: Listing = Listing {
    name: "form factor",
    lines: &[
        "formFactor(i, j)",
        "  for each piece of i and of j",
        "    clip both to the front of the other;  nothing left: 0",
        "    A_i F_ij ← A_i F_ij + exchange of the two",
        "  A_i F_ij ← A_i F_ij · share that nothing blocks",
        "  return A_i F_ij / A_i",
    ],
};

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self {
            Event::Reference { .. } => "Reference",
            Event::FormFactor { .. } => "FormFactor",
            Event::FacesAway => "FacesAway",
            Event::Pieces { .. } => "Pieces",
            Event::Chosen { .. } => "Chosen",
            Event::Points { .. } => "Points",
            Event::Pair { .. } => "Pair",
            Event::Element { .. } => "Element",
            Event::Edge { .. } => "Edge",
            Event::ElementSeen { .. } => "ElementSeen",
            Event::EdgePair { .. } => "EdgePair",
            Event::Ray { .. } => "Ray",
            Event::Hemicube { .. } => "Hemicube",
            Event::Pixel { .. } => "Pixel",
            Event::HemicubeSeen { .. } => "HemicubeSeen",
            Event::Sight { .. } => "Sight",
            Event::Visible { .. } => "Visible",
            Event::FormFactorFound { .. } => "FormFactorFound",
        }
    }

    fn line(&self) -> Line {
        let (listing, number) = match self {
            Event::Reference { .. } | Event::FormFactor { .. } => (&PSEUDOCODE, 0),
            Event::FacesAway | Event::Pieces { .. } => (&PSEUDOCODE, 2),
            Event::Chosen { method, .. } => (&auto::PSEUDOCODE, auto::line_of(method)),
            Event::Points { .. } => (&area_to_area::PSEUDOCODE, 3),
            Event::Pair { .. } => (&area_to_area::PSEUDOCODE, 4),
            Event::Element { .. } => (&element_to_polygon::PSEUDOCODE, 1),
            Event::Edge { .. } => (&element_to_polygon::PSEUDOCODE, 4),
            Event::ElementSeen { .. } => (&element_to_polygon::PSEUDOCODE, 5),
            Event::EdgePair { .. } => (&contour::PSEUDOCODE, 4),
            Event::Ray { .. } => (&monte_carlo::PSEUDOCODE, 4),
            Event::Hemicube { .. } => (&hemicube::PSEUDOCODE, 1),
            Event::Pixel { .. } => (&hemicube::PSEUDOCODE, 4),
            Event::HemicubeSeen { .. } => (&hemicube::PSEUDOCODE, 5),
            Event::Sight { .. } => (&visibility::PSEUDOCODE, 4),
            Event::Visible { .. } => (&visibility::PSEUDOCODE, 5),
            Event::FormFactorFound { .. } => (&PSEUDOCODE, 5),
        };
        Line { listing, number }
    }

    /// One point of many tells nothing of the next.
    fn holds_on(&self) -> bool {
        !matches!(
            self,
            Event::Points { .. }
                | Event::Pair { .. }
                | Event::Edge { .. }
                | Event::EdgePair { .. }
                | Event::Ray { .. }
                | Event::Pixel { .. }
                | Event::Sight { .. }
        )
    }

    fn fields(&self, fields: &mut Fields) {
        match *self {
            Event::Reference { f } => fields.push("F_exact", f),
            Event::FormFactor { i, j, method } => {
                fields.push("i", i).push("j", j).push("method", method)
            }
            Event::FacesAway => fields,
            Event::Pieces { corners, areas } => fields
                .push("corners_i", corners[0])
                .push("corners_j", corners[1])
                .push("area_i", areas[0])
                .push("area_j", areas[1]),
            Event::Chosen {
                method,
                distance,
                radii,
                points,
            } => fields
                .push("chosen", method)
                .push("distance", distance)
                .push("radius_i", radii[0])
                .push("radius_j", radii[1])
                .push("points", points),
            Event::Points { x, y } => fields.push("x", x).push("y", y),
            Event::Pair {
                cos_x,
                cos_y,
                r,
                term,
                sum,
            } => fields
                .push("cos_theta_x", cos_x)
                .push("cos_theta_y", cos_y)
                .push("r", r)
                .push("term", term)
                .push("sum", sum),
            Event::Element { x, weight } => fields.push("x", x).push("w", weight),
            Event::Edge {
                edge,
                corner,
                angle,
                term,
                sum,
            } => fields
                .push("edge", edge)
                .push("R_k", corner)
                .push("Gamma_k", angle)
                .push("term", term)
                .push("F_x", sum),
            Event::ElementSeen { f, sum } => fields.push("F_x", f).push("sum", sum),
            Event::EdgePair {
                edges,
                cosine,
                way,
                integral,
                sum,
            } => fields
                .push("edge_i", edges[0])
                .push("edge_j", edges[1])
                .push("e_dot_f", cosine)
                .push("way", way)
                .push("I", integral)
                .push("sum", sum),
            Event::Ray {
                x,
                direction,
                met,
                hits,
            } => fields
                .push("x", x)
                .push("direction", direction)
                .push("met", met)
                .push("hits", hits),
            Event::Hemicube { x, resolution } => fields.push("x", x).push("resolution", resolution),
            Event::Pixel {
                face,
                x,
                y,
                delta,
                sum,
            } => fields
                .push("face", face)
                .push("pixel_x", x)
                .push("pixel_y", y)
                .push("delta_F", delta)
                .push("F_x", sum),
            Event::HemicubeSeen { f, mean } => fields.push("F_x", f).push("F_mean", mean),
            Event::Sight {
                x,
                y,
                blocked,
                share,
            } => fields
                .push("x", x)
                .push("y", y)
                .push("blocked", blocked)
                .push("share", share),
            Event::Visible { rays, share } => fields.push("rays", rays).push("share", share),
            Event::FormFactorFound { exchange, f } => {
                fields.push("A_i_F_ij", exchange).push("F_ij", f)
            }
        };
    }
}
