//! Where a normal is interpolated, and the illumination model applied at every pixel.

use super::{Entry, INCREMENTAL, When, entry, is, noted, only};

pub const TABLE: &[Entry] = &[
    entry(
        "VertexReady",
        "The vertex has its normal: it serves all polygons that share the vertex.",
        "Titik sudut mendapat normalnya, untuk semua poligon yang memakainya.",
        &[is("{N_v}")],
    ),
    only(
        "EdgeEnds",
        When::Told("N_1"),
        "The normals at the two ends of edge {upper}–{lower}.",
        "Normal di kedua ujung sisi {upper}–{lower}.",
        &[is("{N_1}"), is("{N_2}")],
    ),
    only(
        "EdgeInterpolated",
        When::Told("N_4"),
        "The normal where the scan line cuts edge {upper}–{lower}: the nearer end weighs more.",
        "Normal di potongan garis scan dengan sisi {upper}–{lower}: ujung yang lebih dekat lebih berbobot.",
        &[
            is(
                "{N_4} = [{y_4} − {y_2}; {y_1} − {y_2}] · {N_1} + [{y_1} − {y_4}; {y_1} − {y_2}] · {N_2}",
            ),
            is("{N_4 incremental=N_4_incremental} = N_4′ + ΔN/Δy"),
            noted("{Δ=difference}", INCREMENTAL),
        ],
    ),
    only(
        "SpanEnds",
        When::Told("N_4"),
        "The normals at the two ends of the span.",
        "Normal di kedua ujung bentang.",
        &[is("{N_4}"), is("{N_5}")],
    ),
    only(
        "SpanInterpolated",
        When::Told("N_P"),
        "The normal of the pixel, between the two ends of the span; it is no longer of unit length.",
        "Normal piksel, di antara kedua ujung bentang; panjangnya tidak lagi satu satuan.",
        &[
            is(
                "{N_P} = [{x_5} − {x_P}; {x_5} − {x_4}] · {N_4} + [{x_P} − {x_4}; {x_5} − {x_4}] · {N_5}",
            ),
            is("{N_P incremental=N_P_incremental} = N_P′ + ΔN/Δx"),
            noted("{Δ=difference}", INCREMENTAL),
        ],
    ),
    entry(
        "PixelNormal",
        "The interpolated normal is brought to unit length: between two unit vectors that differ it is shorter.",
        "Normal hasil interpolasi dijadikan satuan: di antara dua vektor satuan yang berbeda ia lebih pendek.",
        &[is(
            "{N} = [{N_P incremental=N_P_incremental}; {|N_P|=length}]",
        )],
    ),
    entry(
        "PixelNormalLost",
        "Here opposite normals cancel out, and their mean points nowhere: the normal of the face stands for it.",
        "Di sini normal yang berlawanan saling meniadakan: normal muka menggantikannya.",
        &[is("{|N_P|=length}"), is("{N}")],
    ),
    only(
        "PixelColored",
        When::Told("N_P_incremental"),
        "Pixel ({x}, {y}) takes the intensity found at its own point with its own normal.",
        "Piksel ({x}, {y}) mendapat intensitas di titiknya sendiri, dengan normalnya sendiri.",
        &[is("{pixel=color} = {I@}")],
    ),
];
