//! Cosines as Taylor series over a triangle, and by differences along its spans.

use super::Declared;
use super::entry::{When, entry, is, noted, only};
use super::scan_line::INCREMENTAL;
use crate::algorithms::fast_phong::{Event, PSEUDOCODE};
use crate::algorithms::shading;
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::Shading(event) => event,
    };
    Event::Triangle { corners: [a, b, c] } => "Triangle" at "triangle" scope ("triangle", "segitiga")
        {
            "a" = a,
            "b" = b,
            "c" = c,
        }
        [
            entry(
                "Triangle {a}–{b}–{c} of the polygon begins: a normal that is linear over it, and a series for each cosine.",
                "Segitiga {a}–{b}–{c} dari poligon dimulai: satu normal linear dan satu deret untuk tiap kosinus.",
                &[],
            ),
        ];
    Event::NormalAtMiddle { middle, n_0, vanished } => "NormalAtMiddle" at "normal-series"
        {
            "x_0" = middle.x,
            "y_0" = middle.y,
            "N_0" = n_0,
            "vanished" = vanished,
        }
        [
            entry(
                "The series are expanded about the triangle's middle on the screen, with the normal N_0 there.",
                "Deret dikembangkan di tengah segitiga pada layar, dengan normal N_0 di sana.",
                &[is("{x_0}"), is("{y_0}"), is("{N_0}")],
            ),
        ];
    Event::NormalSlopes { n_x, n_y } => "NormalSlopes" at "normal-series"
        {
            "N_x" = n_x,
            "N_y" = n_y,
        }
        [
            entry(
                "What a pixel to the right and a row down add to the normal.",
                "Tambahan pada normal untuk satu piksel ke kanan dan satu baris ke bawah.",
                &[is("{N_x}"), is("{N_y}")],
            ),
        ];
    Event::Series { cosine, series } => "Series" at "series"
        {
            "cosine" = cosine.name(),
            "T_0" = series.0[0],
            "T_1" = series.0[1],
            "T_2" = series.0[2],
            "T_3" = series.0[3],
            "T_4" = series.0[4],
            "T_5" = series.0[5],
        }
        [
            only(
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
        ];
    Event::LightExpanded => "LightExpanded" at "light"
        {
        }
        [
            entry(
                "Both cosines of light {light} are polynomials now; its direction holds for the whole triangle.",
                "Kedua kosinus cahaya {light} kini polinomial; arahnya berlaku untuk seluruh segitiga.",
                &[],
            ),
        ];
    Event::Expanded => "Expanded" at "triangle"
        {
        }
        [
            entry(
                "Every light is expanded; the triangle can be filled.",
                "Semua cahaya sudah dikembangkan; segitiga dapat diisi.",
                &[],
            ),
        ];
    Event::DifferencesStarted { light, cosine, running } => "DifferencesStarted" at "differences"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
        }
        [
            entry(
                "At the span's first pixel the polynomial gives the cosine and its two differences.",
                "Pada piksel pertama bentang, polinomial memberi kosinus dan kedua selisihnya.",
                &[is("{c}"), is("{Δc=dc}"), is("{Δ^2c=d2c}")],
            ),
        ];
    Event::CosineEvaluated { light, cosine, running, direct, exact } => "CosineEvaluated" at "increments"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
            "c_direct" = direct,
            "c_exact" = exact,
            "difference" = running.value - direct,
            "error" = running.value - exact,
        }
        [
            only(
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
                "The highlight's cosine at the pixel: two additions from the pixel before.",
                "Kosinus sorotan di piksel: dua penjumlahan dari piksel sebelumnya.",
                &[
                    is("{c} = c′ + Δc′"),
                    is("{Δc=dc} = Δc′ + {Δ^2c=d2c}"),
                    noted("{Δ=difference}", INCREMENTAL),
                    noted("{error}", APPROXIMATE),
                    ],
            ),
        ];
    Event::LightSummed { power, i_d, i_s } => "LightSummed" at "sum"
        {
            "power" = power,
            "I_d" = i_d,
            "I_s" = i_s,
        }
        [
            entry(
                "What light {light} adds here; the power of the highlight's cosine comes from a table.",
                "Tambahan cahaya {light} di sini; pangkat kosinus sorotan diambil dari tabel.",
                &[is("{c^n=power}"), is("{I_d}"), is("{I_s}")],
            ),
        ];
    Event::TriangleDone => "TriangleDone" at "triangle"
        {
        }
        [
            entry(
                "Triangle {a}–{b}–{c} is done.",
                "Segitiga {a}–{b}–{c} selesai.",
                &[],
            ),
        ];
}

const APPROXIMATE: super::Sentence = super::entry::says(
    "how far the series is from the cosine of a unit normal",
    "jarak deret dari kosinus normal satuan",
);

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            // The directions have lines of their own here, for they are found once a triangle.
            Event::Shading(shading::Event::Illumination(event)) => PSEUDOCODE
                .labelled(event.label())
                .unwrap_or_else(|| PSEUDOCODE.line("expansion")),
            Event::Shading(event) => event.line(),
            _ => PSEUDOCODE.line(self.label()),
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
