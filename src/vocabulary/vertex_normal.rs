//! The mean of the normals around a vertex.

use super::entry::{entry, is};
use crate::algorithms::vertex_normal::Event;

vocabulary! {
    [] Event {
    };
    Event::FaceNormalAdded { face, normal, sum } => "FaceNormalAdded" at "vertex-normal"
        {
            "face" = face,
            "N_k" = normal,
            "sum_N" = sum,
        }
        [
            entry(
                "Face {face} shares the vertex: its unit normal is added.",
                "Muka {face} memiliki titik sudut ini: normal satuannya ditambahkan.",
                &[is("{S=sum_N} = {ΣN_k=*N_k}")],
            ),
        ];
    Event::VertexNormal { faces, length, normal } => "VertexNormal" at "vertex-normal"
        {
            "faces" = faces,
            "length" = length,
            "N_v" = normal,
        }
        [
            entry(
                "The vertex normal: the mean direction of the face normals, of unit length.",
                "Normal titik sudut: arah rata-rata normal muka, sepanjang satu satuan.",
                &[is("{N_v} = [{ΣN_k=sum_N}; {|ΣN_k|=length}]")],
            ),
        ];
    Event::NormalVanished { faces, length, normal } => "NormalVanished" at "vertex-normal"
        {
            "faces" = faces,
            "length" = length,
            "N_v" = normal,
        }
        [
            entry(
                "The face normals cancel out: the first one stands for their mean.",
                "Normal muka saling meniadakan: normal pertama menggantikan rata-ratanya.",
                &[is("{|ΣN_k|=length}"), is("{N_v} = N_1")],
            ),
        ];
}
