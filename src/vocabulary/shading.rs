//! What the scan-line methods that light surfaces have in common.

use super::Declared;
use super::entry::{entry, is};
use crate::algorithms::shading::{Event, Shading};
use crate::algorithms::texture;
use crate::record::{self, Fields, Line};

vocabulary! {
    [M: Shading] Event<M> {
        Event::PreparedScene(event) => event,
        Event::Normal(event) => event,
        Event::Illumination(event) => event,
        Event::ScanLine(event) => event,
        Event::Texture(event) => event,
    };
    Event::Middle { position } => "Middle" at "middle"
        {
            "P_m" = position,
        }
        [
            entry(
                "One intensity for the whole polygon, at the mean of its vertices.",
                "Satu intensitas untuk seluruh poligon, pada rata-rata titik sudutnya.",
                &[is("{P_m} = [ΣP_k; n]")],
            ),
        ];
    Event::Vertex { vertex, position } => "Vertex" at "vertex" number "vertex" scope ("vertex", "titik sudut")
        {
            "vertex" = vertex,
            "P_v" = position,
        }
        [
            entry(
                "Vertex {vertex} comes up for the first time: its normal is the mean of the faces around it.",
                "Titik sudut {vertex} muncul pertama kali: normalnya adalah rata-rata muka di sekelilingnya.",
                &[is("{P_v}")],
            ),
        ];
    Event::VertexLit { vertex, intensity } => "VertexLit" at "vertex-lit"
        {
            "vertex" = vertex,
            "I_v" = intensity,
        }
        [
            entry(
                "The vertex has its intensity: it serves all polygons that share the vertex.",
                "Titik sudut mendapat intensitasnya, untuk semua poligon yang memakainya.",
                &[is("{I_v} = illumination({P_v}, {N_v})")],
            ),
        ];
    Event::VertexReady { vertex } => "VertexReady" at "vertex-normal"
        {
            "vertex" = vertex,
        }
        [
            entry(
                "The vertex has its normal: it serves all polygons that share the vertex.",
                "Titik sudut mendapat normalnya, untuk semua poligon yang memakainya.",
                &[is("{N_v}")],
            ),
        ];
    Event::PixelPoint { position } => "PixelPoint" at "point"
        {
            "P" = position,
        }
        [
            entry(
                "P is the point of the polygon that the pixel shows: along u, the ray of the pixel, brought to the depth z.",
                "P adalah titik poligon yang tampak di piksel: sepanjang u, sinar piksel itu, sampai kedalaman z.",
                &[is("{P} = eye + {z} · [u; u · forward]")],
            ),
        ];
    Event::PixelNormal { length, normal } => "PixelNormal" at "normal"
        {
            "length" = length,
            "N" = normal,
        }
        [
            entry(
                "The interpolated normal is brought to unit length: between two unit vectors that differ it is shorter.",
                "Normal hasil interpolasi dijadikan satuan: di antara dua vektor satuan yang berbeda ia lebih pendek.",
                &[is(
                    "{N} = [{N_P incremental=N_P_incremental}; {|N_P|=length}]",
                    )],
            ),
        ];
    Event::PixelNormalLost { length, normal } => "PixelNormalLost" at "normal"
        {
            "length" = length,
            "N" = normal,
        }
        [
            entry(
                "Here opposite normals cancel out, and their mean points nowhere: the normal of the face stands for it.",
                "Di sini normal yang berlawanan saling meniadakan: normal muka menggantikannya.",
                &[is("{|N_P|=length}"), is("{N}")],
            ),
        ];
    Event::TruePoint { position, normal } => "TruePoint" at "normal"
        {
            "P" = position,
            "N" = normal,
        }
        [
            entry(
                "The ray of the pixel meets the true surface, before or behind its polygon, at P; N is the surface’s own normal there.",
                "Sinar piksel mengenai permukaan sebenarnya, di depan atau di belakang poligonnya, di P; N adalah normal permukaan itu sendiri.",
                &[is("{P}"), is("{N}")],
            ),
        ];
}

impl<M: Shading> record::Event for Event<M> {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            Event::Illumination(event) => {
                crate::algorithms::illumination::PSEUDOCODE.line(event.label())
            }
            Event::Texture(event) => texture::PSEUDOCODE.line(event.label()),
            // A method that needs P for its texture alone finds it there.
            Event::PixelPoint { .. } => {
                let own = M::LISTING.labelled(self.label());
                own.unwrap_or_else(|| texture::PSEUDOCODE.line(self.label()))
            }
            _ => M::LISTING.line(self.label()),
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
