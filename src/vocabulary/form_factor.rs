//! Form factors, by every method.

use super::Declared;
use super::entry::{Formula, When, entry, if_recorded, is, only};
use crate::algorithms::form_factor::{
    Event, PSEUDOCODE, area_to_area, auto, contour, element_to_polygon, hemicube, monte_carlo,
    visibility,
};
use crate::record::{self, Fields, Line, Listing};

vocabulary! {
    [] Event {
    };
    Event::Reference { f } => "Reference" at "form-factor"
        {
            "F_exact" = f,
        }
        [
            entry(
                "What the form factor is, by the contour integral to ten digits: the value that follows is compared with it.",
                "Nilai faktor bentuk, dengan integral kontur sampai sepuluh angka: nilai berikut dibandingkan dengannya.",
                &[is("{F_i_j=F_exact}")],
            ),
        ];
    Event::FormFactor { i, j, method } => "FormFactor" at "form-factor" number "j" scope ("form factor", "faktor bentuk")
        {
            "i" = i,
            "j" = j,
            "method" = method,
        }
        [
            entry(
                "The form factor from patch {i} to patch {j}: the share of the light leaving patch {i} that arrives at patch {j}. V is 0 where something stands between.",
                "Faktor bentuk dari patch {i} ke patch {j}: bagian cahaya dari patch {i} yang tiba di patch {j}. V bernilai 0 bila ada penghalang.",
                &[is(
                    "F_i_j = [1; A_i] ∫∫ [cos θ_x cos θ_y; π r^2] V dA_y dA_x",
                    )],
            ),
        ];
    Event::FacesAway => "FacesAway" at "pieces"
        {
        }
        [
            entry(
                "The two pieces lie behind each other or in one plane: nothing passes between them, and nothing is integrated.",
                "Kedua bagian saling membelakangi atau sebidang: tidak ada cahaya di antaranya, dan tidak ada yang diintegralkan.",
                &[],
            ),
        ];
    Event::Pieces { corners, areas } => "Pieces" at "pieces"
        {
            "corners_i" = corners[0],
            "corners_j" = corners[1],
            "area_i" = areas[0],
            "area_j" = areas[1],
        }
        [
            entry(
                "The parts of the two patches that lie in front of each other, with {corners_i} and {corners_j} corners, and their areas.",
                "Bagian kedua patch yang saling berhadapan, dengan {corners_i} dan {corners_j} sudut, serta luasnya.",
                &[is("{A_i=area_i}"), is("{A_j=area_j}")],
            ),
        ];
    Event::Chosen { method, distance, radii, points } => "Chosen" at "contour"
        {
            "chosen" = method,
            "distance" = distance,
            "radius_i" = radii[0],
            "radius_j" = radii[1],
            "points" = points,
        }
        [
            only(
                When::Is("chosen", "area_to_area"),
                "Far from each other for their radii R: {points} pairs of points are exact enough.",
                "Berjauhan dibandingkan radius R: {points} pasang titik sudah cukup teliti.",
                BY_DISTANCE,
            ),
            only(
                When::Is("chosen", "element_to_polygon"),
                "Apart, and one small: points of the smaller patch, each with its exact form factor to the larger one.",
                "Terpisah, dan salah satunya kecil: titik-titik patch yang lebih kecil, masing-masing dengan faktor bentuk eksak ke patch yang lebih besar.",
                BY_DISTANCE,
            ),
            entry(
                "Near or touching: the double contour integral.",
                "Berdekatan atau bersentuhan: integral kontur ganda.",
                BY_DISTANCE,
            ),
        ];
    Event::Points { x, y } => "Points" at "points"
        {
            "x" = x,
            "y" = y,
        }
        [
            entry(
                "A point of either patch, at a Gauss point.",
                "Satu titik pada tiap patch, di titik Gauss.",
                &[is("{x}"), is("{y}")],
            ),
        ];
    Event::Pair { cos_x, cos_y, r, term, sum } => "Pair" at "pair"
        {
            "cos_theta_x" = cos_x,
            "cos_theta_y" = cos_y,
            "r" = r,
            "term" = term,
            "sum" = sum,
        }
        [
            entry(
                "What the two points exchange, by their weights w: the nearer and the more they face each other, the more.",
                "Pertukaran kedua titik, menurut bobot w: makin dekat dan makin berhadapan, makin besar.",
                &[
                    is("{r} = |{y} − {x}|"),
                    is("{term} = w_x w_y [{cos_theta_x} · {cos_theta_y}; π {r}^2]"),
                    is("{A_i F_i_j=sum} = A_i F_i_j′ + {term}"),
                    ],
            ),
        ];
    Event::Element { x, weight } => "Element" at "element" scope ("element", "elemen")
        {
            "x" = x,
            "w" = weight,
        }
        [
            entry(
                "A point of the smaller patch stands for an element of it, with the weight w. It sees the other patch as a polygon.",
                "Satu titik pada patch yang lebih kecil mewakili elemennya, dengan bobot w. Ia melihat patch lain sebagai poligon.",
                &[is("{x}"), is("{w}")],
            ),
        ];
    Event::Edge { edge, corner, angle, term, sum } => "Edge" at "edge"
        {
            "edge" = edge,
            "R_k" = corner,
            "Gamma_k" = angle,
            "term" = term,
            "F_x" = sum,
        }
        [
            only(
                When::Recorded("Gamma_k"),
                "Edge {edge} of the polygon, from its corner R_k on: seen from x it spans the angle |Γ_k|, and Γ_k is normal to it.",
                "Sisi {edge} poligon, mulai sudut R_k: dilihat dari x sisi ini membentang sudut |Γ_k|, dan Γ_k tegak lurus padanya.",
                &[
                    is("{R_k}"),
                    is("{|Γ_k|=Gamma_k}"),
                    is("{term} = [N · Γ_k; 2π]"),
                    is("{F_x} = F_x′ + {term}"),
                    ],
            ),
        ];
    Event::ElementSeen { f, sum } => "ElementSeen" at "element-seen"
        {
            "F_x" = f,
            "sum" = sum,
        }
        [
            entry(
                "The form factor of the element, exact for its point, is added by its weight.",
                "Faktor bentuk elemen, eksak untuk titiknya, ditambahkan menurut bobotnya.",
                &[is("{A_i F_i_j=sum} = A_i F_i_j′ + {w} · {F_x}")],
            ),
        ];
    Event::EdgePair { edges, cosine, way, integral, sum } => "EdgePair" at "edge-pair"
        {
            "edge_i" = edges[0],
            "edge_j" = edges[1],
            "e_dot_f" = cosine,
            "way" = way,
            "I" = integral,
            "sum" = sum,
        }
        [
            only(
                When::Is("way", "at right angles"),
                "Edge {edge_i} of one patch and edge {edge_j} of the other are at right angles: they add nothing.",
                "Sisi {edge_i} patch pertama dan sisi {edge_j} patch kedua saling tegak lurus: tidak menambah apa pun.",
                &[is("{e·f=e_dot_f}"), is("{A_i F_i_j=sum}")],
            ),
            only(
                When::Is("way", "on one line"),
                "Edge {edge_i} of one patch and edge {edge_j} of the other lie on one line: I is exact. Lengths are in the extent L of the two.",
                "Sisi {edge_i} patch pertama dan sisi {edge_j} patch kedua terletak pada satu garis: I eksak. Panjang dalam satuan rentang L keduanya.",
                EDGES,
            ),
            entry(
                "Edge {edge_i} of one patch with edge {edge_j} of the other: I is exact along one, by Gauss points along the other. Lengths are in the extent L of the two.",
                "Sisi {edge_i} patch pertama dengan sisi {edge_j} patch kedua: I eksak sepanjang yang satu, dengan titik Gauss sepanjang yang lain. Panjang dalam satuan rentang L keduanya.",
                EDGES,
            ),
        ];
    Event::Ray { x, direction, met, hits } => "Ray" at "ray"
        {
            "x" = x,
            "direction" = direction,
            "met" = met,
            "hits" = hits,
        }
        [
            only(
                When::True("met"),
                "The ray meets the front of patch {j}, and nothing before: it counts.",
                "Sinar mengenai sisi depan patch {j}, tanpa penghalang: dihitung.",
                RAY,
            ),
            only(
                When::Recorded("hits"),
                "The ray does not reach patch {j}: the hits stay as they are.",
                "Sinar tidak mencapai patch {j}: jumlah yang mengenai tetap.",
                RAY,
            ),
        ];
    Event::Hemicube { x, resolution } => "Hemicube" at "hemicube" scope ("hemicube", "hemicube")
        {
            "x" = x,
            "resolution" = resolution,
        }
        [
            entry(
                "A hemicube stands over the point x of patch {i}: {resolution} pixels along an edge of its top.",
                "Hemicube berdiri di atas titik x pada patch {i}: {resolution} piksel sepanjang rusuk atasnya.",
                &[is("{x}")],
            ),
        ];
    Event::Pixel { face, x, y, delta, sum } => "Pixel" at "pixel"
        {
            "face" = face,
            "pixel_x" = x,
            "pixel_y" = y,
            "delta_F" = delta,
            "F_x" = sum,
        }
        [
            only(
                When::NotPositive("face"),
                "Pixel ({pixel_x}, {pixel_y}) of the top shows patch {j}: it stands for ΔF.",
                "Piksel ({pixel_x}, {pixel_y}) sisi atas menampilkan patch {j}: nilainya ΔF.",
                &[
                    is(ACROSS),
                    is(ALONG),
                    is("{ΔF=delta_F} = [ΔA; π (u^2 + v^2 + 1)^2]"),
                    is(SEEN),
                    ],
            ),
            only(
                When::Recorded("delta_F"),
                "Pixel ({pixel_x}, {pixel_y}) of side face {face} shows patch {j}: it stands for ΔF, less the lower it lies.",
                "Piksel ({pixel_x}, {pixel_y}) sisi tegak {face} menampilkan patch {j}: nilainya ΔF, makin kecil makin rendah.",
                &[
                    is(ACROSS),
                    is(ALONG),
                    is("{ΔF=delta_F} = [v ΔA; π (u^2 + v^2 + 1)^2]"),
                    is(SEEN),
                    ],
            ),
        ];
    Event::HemicubeSeen { f, mean } => "HemicubeSeen" at "hemicube-seen"
        {
            "F_x" = f,
            "F_mean" = mean,
        }
        [
            entry(
                "The form factor of the point; the mean over all n points of patch {i} stands for the patch.",
                "Faktor bentuk titik ini; rata-rata semua n titik patch {i} mewakili patch itu.",
                &[
                    is("{F_x} = Σ ΔF"),
                    is("{F_i_j=F_mean} = F_i_j′ + [{F_x}; n]"),
                    ],
            ),
        ];
    Event::Sight { x, y, blocked, share } => "Sight" at "sight"
        {
            "x" = x,
            "y" = y,
            "blocked" = blocked,
            "share" = share,
        }
        [
            only(
                When::True("blocked"),
                "Something stands between x and y: V(x, y) = 0. K is what they would exchange, cos θ_x cos θ_y / (π r^2).",
                "Ada penghalang antara x dan y: V(x, y) = 0. K adalah pertukaran tanpa penghalang, cos θ_x cos θ_y / (π r^2).",
                SIGHT,
            ),
            entry(
                "Nothing stands between x and y: V(x, y) = 1. K is what they exchange, cos θ_x cos θ_y / (π r^2).",
                "Tidak ada penghalang antara x dan y: V(x, y) = 1. K adalah pertukarannya, cos θ_x cos θ_y / (π r^2).",
                SIGHT,
            ),
        ];
    Event::Visible { rays, share } => "Visible" at "visible"
        {
            "rays" = rays,
            "share" = share,
        }
        [
            entry(
                "Of {rays} lines of sight: the share of the light that nothing blocks.",
                "Dari {rays} garis pandang: bagian cahaya yang tidak terhalang.",
                &[is("{V_i_j=share}")],
            ),
        ];
    Event::FormFactorFound { exchange, f } => "FormFactorFound" at "found"
        {
            "A_i_F_ij" = exchange,
            "F_ij" = f,
        }
        [
            only(
                When::Is("method", "monte-carlo"),
                "The form factor: the share of n rays that met patch {j}.",
                "Faktor bentuk: bagian dari n sinar yang mengenai patch {j}.",
                &[is("{F_i_j=F_ij} = [{hits}; n]"), EXCHANGE],
            ),
            only(
                When::Is("method", "hemicube"),
                "The form factor: the mean over the hemicubes.",
                "Faktor bentuk: rata-rata dari semua hemicube.",
                &[is("{F_i_j=F_ij}"), EXCHANGE],
            ),
            entry(
                "The form factor: the exchange, by the share that nothing blocks, over the area of patch {i}.",
                "Faktor bentuk: pertukaran, menurut bagian yang tidak terhalang, dibagi luas patch {i}.",
                &[
                    if_recorded("share", "{A_i F_i_j=A_i_F_ij} = A_i F_i_j′ · {V_i_j=share}"),
                    is("{F_i_j=F_ij} = [{A_i F_i_j=A_i_F_ij}; A_i]"),
                    ],
            ),
        ];
}

const BY_DISTANCE: &[Formula] = &[
    is("{d=distance}"),
    is("{R_i=radius_i}"),
    is("{R_j=radius_j}"),
];
const EDGES: &[Formula] = &[
    is("{I} = ∫∫ ln r ds dt"),
    is("{A_i F_i_j=sum} = A_i F_i_j′ + L^2 [{e·f=e_dot_f} · {I}; 2π]"),
];
const RAY: &[Formula] = &[is("{x}"), is("{u=direction}"), is("{hits}")];
const ACROSS: &str = "u = 2 ({x=pixel_x} + 0.5) / {n=resolution} − 1";
const ALONG: &str = "v = 2 ({y=pixel_y} + 0.5) / {n=resolution} − 1";
const SEEN: &str = "{F_x} = F_x′ + {ΔF=delta_F}";
const SIGHT: &[Formula] = &[is("{V_i_j=share} = [Σ K V(x, y); Σ K]")];
const EXCHANGE: Formula = is("{A_i F_i_j=A_i_F_ij}");

/// The listings of all methods; a label stands in one of them only.
static LISTINGS: [&Listing; 8] = [
    &PSEUDOCODE,
    &auto::PSEUDOCODE,
    &area_to_area::PSEUDOCODE,
    &element_to_polygon::PSEUDOCODE,
    &contour::PSEUDOCODE,
    &monte_carlo::PSEUDOCODE,
    &hemicube::PSEUDOCODE,
    &visibility::PSEUDOCODE,
];

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        let label = match *self {
            // Each choice has a line of its own.
            Event::Chosen { method, .. } => method,
            _ => self.label(),
        };
        let line = LISTINGS.iter().find_map(|listing| listing.labelled(label));
        line.unwrap_or_else(|| PSEUDOCODE.line(label))
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
        self.push_fields(fields);
    }
}
