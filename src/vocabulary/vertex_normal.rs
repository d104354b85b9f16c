//! The mean of the normals around a vertex.

use super::entry::{When, entry, is};
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
            entry("event-face-normal-added", &[is("N_k = [Σ{face_fan}; |Σ{face_fan}|]").when(When::Not(&When::Zero("N_k"))), is("{S=sum_N} = Σ{*N_k}")]),
        ];
    Event::VertexNormal { faces, length, normal } => "VertexNormal" at "vertex-normal"
        {
            "faces" = faces,
            "length" = length,
            "N_v" = normal,
        }
        [
            entry("event-vertex-normal", &[is("{|ΣN_k|=length} = |sum_N|"), is("N_v = [sum_N; {|ΣN_k|=length}]")]),
        ];
    Event::FileNormal { normal } => "FileNormal" at "vertex-normal"
        {
            "N_v" = normal,
        }
        [
            entry("event-file-normal", &[]),
        ];
    Event::NormalVanished { faces, length, normal } => "NormalVanished" at "vertex-normal"
        {
            "faces" = faces,
            "length" = length,
            "N_v" = normal,
        }
        [
            entry("event-normal-vanished", &[is("{|ΣN_k|=length} = |sum_N|"), is("N_v = {N_1=N_k!}")]),
        ];
}
