//! Cosines as Taylor series over a triangle, and by differences along its spans.

use super::{Entry, INCREMENTAL, When, entry, is, noted, only};
use crate::panels::strings::Words;

const APPROXIMATE: Words = Words::new(
    "how far the series is from the cosine of a unit normal",
    "jarak deret dari kosinus normal satuan",
);

pub const TABLE: &[Entry] = &[
    entry(
        "Triangle",
        "Triangle {a}–{b}–{c} of the polygon begins: a normal that is linear over it, and a series for each cosine.",
        "Segitiga {a}–{b}–{c} dari poligon dimulai: satu normal linear dan satu deret untuk tiap kosinus.",
        &[],
    ),
    entry(
        "TriangleDone",
        "Triangle {a}–{b}–{c} is done.",
        "Segitiga {a}–{b}–{c} selesai.",
        &[],
    ),
    entry(
        "NormalAtMiddle",
        "The series are expanded about the triangle's middle on the screen, with the normal N_0 there.",
        "Deret dikembangkan di tengah segitiga pada layar, dengan normal N_0 di sana.",
        &[is("{x_0}"), is("{y_0}"), is("{N_0}")],
    ),
    entry(
        "NormalSlopes",
        "What a pixel to the right and a row down add to the normal.",
        "Tambahan pada normal untuk satu piksel ke kanan dan satu baris ke bawah.",
        &[is("{N_x}"), is("{N_y}")],
    ),
    only(
        "Series",
        When::Is("cosine", "N_dot_L"),
        "N·L/|N| near the middle, up to second order: what every pixel's division and square root would find.",
        "N·L/|N| di sekitar titik tengah, sampai orde kedua: pengganti pembagian dan akar tiap piksel.",
        &[
            is("{T_0}"),
            is("{T_1}"),
            is("{T_2}"),
            is("{T_3}"),
            is("{T_4}"),
            is("{T_5}"),
        ],
    ),
    entry(
        "Series",
        "The highlight's cosine near the middle, up to second order.",
        "Kosinus sorotan di sekitar titik tengah, sampai orde kedua.",
        &[
            is("{T_0}"),
            is("{T_1}"),
            is("{T_2}"),
            is("{T_3}"),
            is("{T_4}"),
            is("{T_5}"),
        ],
    ),
    entry(
        "LightExpanded",
        "Both cosines of light {light} are polynomials now; its direction holds for the whole triangle.",
        "Kedua kosinus cahaya {light} kini polinomial; arahnya berlaku untuk seluruh segitiga.",
        &[],
    ),
    entry(
        "Expanded",
        "Every light is expanded; the triangle can be filled.",
        "Semua cahaya sudah dikembangkan; segitiga dapat diisi.",
        &[],
    ),
    entry(
        "DifferencesStarted",
        "At the span's first pixel the polynomial gives the cosine and its two differences.",
        "Pada piksel pertama bentang, polinomial memberi kosinus dan kedua selisihnya.",
        &[is("{c}"), is("{Δc=dc}"), is("{Δ^2c=d2c}")],
    ),
    only(
        "CosineEvaluated",
        When::Is("cosine", "N_dot_L"),
        "N·L at the pixel: two additions from the pixel before.",
        "N·L di piksel: dua penjumlahan dari piksel sebelumnya.",
        &[
            is("{c} = c′ + Δc′"),
            is("{Δc=dc} = Δc′ + {Δ^2c=d2c}"),
            noted("{Δ=difference}", INCREMENTAL),
            noted("{error}", APPROXIMATE),
        ],
    ),
    entry(
        "CosineEvaluated",
        "The highlight's cosine at the pixel: two additions from the pixel before.",
        "Kosinus sorotan di piksel: dua penjumlahan dari piksel sebelumnya.",
        &[
            is("{c} = c′ + Δc′"),
            is("{Δc=dc} = Δc′ + {Δ^2c=d2c}"),
            noted("{Δ=difference}", INCREMENTAL),
            noted("{error}", APPROXIMATE),
        ],
    ),
    entry(
        "LightSummed",
        "What light {light} adds here; the power of the highlight's cosine comes from a table.",
        "Tambahan cahaya {light} di sini; pangkat kosinus sorotan diambil dari tabel.",
        &[is("{c^n=power}"), is("{I_d}"), is("{I_s}")],
    ),
    only(
        "PixelColored",
        When::RecordedField("x_0"),
        "Pixel ({x}, {y}) takes the ambient term and what each light adds.",
        "Piksel ({x}, {y}) mendapat suku ambien dan tambahan tiap cahaya.",
        &[is("{pixel=color}")],
    ),
];
