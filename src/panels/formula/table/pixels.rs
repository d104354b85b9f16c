//! What happens at a pixel of its own: a normal interpolated there, a texture looked up, the illumination model applied.

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
        When::RecordedField("N_1"),
        "The normals at the two ends of edge {upper}–{lower}.",
        "Normal di kedua ujung sisi {upper}–{lower}.",
        &[is("{N_1}"), is("{N_2}")],
    ),
    only(
        "EdgeInterpolated",
        When::RecordedField("N_4"),
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
        When::RecordedField("N_4"),
        "The normals at the two ends of the span.",
        "Normal di kedua ujung bentang.",
        &[is("{N_4}"), is("{N_5}")],
    ),
    only(
        "SpanInterpolated",
        When::RecordedField("N_P"),
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
        "PixelPoint",
        "P is the point of the polygon that the pixel shows: along u, the ray of the pixel, brought to the depth z.",
        "P adalah titik poligon yang tampak di piksel: sepanjang u, sinar piksel itu, sampai kedalaman z.",
        &[is("{P} = eye + {z} · [u; u · forward]")],
    ),
    entry(
        "TruePoint",
        "The ray of the pixel meets the true surface, before or behind its polygon, at P; N is the surface’s own normal there.",
        "Sinar piksel mengenai permukaan sebenarnya, di depan atau di belakang poligonnya, di P; N adalah normal permukaan itu sendiri.",
        &[is("{P}"), is("{N}")],
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
        When::RecordedField("N_P_incremental"),
        "Pixel ({x}, {y}) takes the intensity found at its own point with its own normal.",
        "Piksel ({x}, {y}) mendapat intensitas di titiknya sendiri, dengan normalnya sendiri.",
        &[is("{pixel=color} = {I@}")],
    ),
    // Textures
    only(
        "Textured",
        When::RecordedField("x_P"),
        "The object’s own chart at P, and the texture’s colour there: what a ray through the pixel finds.",
        "Peta objek itu sendiri di P, dan warna tekstur di sana: yang juga ditemukan sinar melalui piksel.",
        &[is("{u=u_texture}"), is("{v=v_texture}"), is("{texture}")],
    ),
    entry(
        "TexturedLinearly",
        "Beside it the plain way: (u, v) of the corners, carried here linearly on the screen. Where the depth changes they are wrong.",
        "Di sampingnya cara polos: (u, v) sudut, dibawa ke sini secara linear di layar. Bila kedalaman berubah, nilainya salah.",
        &[is("{u_linear}"), is("{v_linear}"), is("{texture_linear}")],
    ),
    only(
        "TextureTaken",
        When::True("linear"),
        "This picture is to show the mistake: the texture of the plain (u, v) is taken. It multiplies k_d alone.",
        "Gambar ini menunjukkan kesalahannya: dipakai tekstur dari (u, v) polos. Tekstur hanya mengalikan k_d.",
        &[is("{T} = {texture_linear}")],
    ),
    entry(
        "TextureTaken",
        "The texture at P is taken. It multiplies k_d alone.",
        "Dipakai tekstur di P. Tekstur hanya mengalikan k_d.",
        &[is("{T} = {texture}")],
    ),
    entry(
        "TextureApplied",
        "The diffuse part of the intensity takes the texture; ambient and highlight stay as they are.",
        "Bagian difus dari intensitas dikalikan tekstur; ambien dan sorotan tetap.",
        &[is("{I textured=I_textured} = I − {I_d} + {T} · {I_d}")],
    ),
    only(
        "PixelColored",
        When::RecordedField("I_textured"),
        "Pixel ({x}, {y}) takes its textured intensity.",
        "Piksel ({x}, {y}) mendapat intensitas bertekstur.",
        &[is("{pixel=color} = {I textured=I_textured}")],
    ),
];
