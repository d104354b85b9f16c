//! Scan conversion: edge table, scan lines, spans and pixels, whatever is interpolated.

use super::declare::Interpolated;
use super::entry::{When, entry, if_recorded, is, noted, only};
use crate::algorithms::scan_line::{Carried, Event};

vocabulary! {
    [A: Carried] Event<A> {
    };
    Event::EdgeTable { corners } => "EdgeTable" at "edge-table" scope ("edge table", "tabel sisi")
        {
            "corners" = corners,
        }
        [
            entry(
                "The edge table of a polygon of {corners} corners begins.",
                "Tabel sisi dari poligon dengan {corners} sudut dimulai.",
                &[],
            ),
        ];
    Event::CornerPlaced { corner, x, y, z, value } => "CornerPlaced" at "edge-table"
        {
            "corner" = corner,
            "x" = x,
            "y" = y,
            "z" = z,
            "I" | "N" = Interpolated(value, |names| names.corner),
        }
        [
            entry(
                "Corner {corner} on the screen, in pixels; z is its depth.",
                "Sudut {corner} di layar, dalam piksel; z kedalamannya.",
                &[
                    is("{x}"),
                    is("{y}"),
                    is("{z}"),
                    if_recorded("I", "{I}"),
                    if_recorded("N", "{N}"),
                    ],
            ),
        ];
    Event::EdgeEntered { edge, upper, lower, first, end, slope, step } => "EdgeEntered" at "edge-table"
        {
            "edge" = edge,
            "upper" = upper,
            "lower" = lower,
            "first" = first,
            "end" = end,
            "dx_dy" = slope,
            "dI_dy" | "dN_dy" = Interpolated(step, |names| names.step),
        }
        [
            entry(
                "Edge {upper}–{lower} is entered: it cuts the scan lines from {first} on, up to but not including {end}.",
                "Sisi {upper}–{lower} dimasukkan: memotong garis scan mulai {first} sampai sebelum {end}.",
                &[
                    is(
                    "{dx_dy} = [{x_2=x@corner:lower} − {x_1=x@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    ),
                    if_recorded(
                    "dI_dy",
                    "{dI_dy} = [{I_2=I@corner:lower} − {I_1=I@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    ),
                    if_recorded(
                    "dN_dy",
                    "{dN_dy} = [{N_2=N@corner:lower} − {N_1=N@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    ),
                    ],
            ),
        ];
    Event::EdgeSkipped { from, to } => "EdgeSkipped" at "edge-table"
        {
            "from" = from,
            "to" = to,
        }
        [
            entry(
                "Edge {from}–{to} passes the centre of no row: it is left out.",
                "Sisi {from}–{to} tidak melewati pusat baris mana pun: dilewati.",
                &[],
            ),
        ];
    Event::EdgeTableBuilt { edges } => "EdgeTableBuilt" at "edge-table"
        {
            "edges" = edges,
        }
        [
            entry(
                "The edge table is built; edges in it: {edges}.",
                "Tabel sisi selesai; jumlah sisi: {edges}.",
                &[],
            ),
        ];
    Event::ScanLine { y, y_4 } => "ScanLine" at "scan-line" number "y" scope ("scan line", "garis scan")
        {
            "y" = y,
            "y_4" = y_4,
        }
        [
            entry(
                "Scan line {y} begins: its pixel centres lie at y_4 = {y_4}.",
                "Garis scan {y} dimulai: pusat pikselnya pada y_4 = {y_4}.",
                &[is("{y_4} = {y} + 0.5")],
            ),
        ];
    Event::Edge { edge, upper, lower, y_1, y_2, x_4 } => "Edge" at "edge" number "edge" scope ("edge", "sisi")
        {
            "edge" = edge,
            "upper" = upper,
            "lower" = lower,
            "y_1" = y_1,
            "y_2" = y_2,
            "x_4" = x_4,
        }
        [
            only(
                When::Recorded("x_4"),
                "The scan line cuts edge {upper}–{lower} at x_4.",
                "Garis scan memotong sisi {upper}–{lower} di x_4.",
                &[is(
                    "{x_4} = {x_1=x@corner:upper} + ({y_4} − {y_1}) · {Δx/Δy=dx_dy@edge:edge}",
                    )],
            ),
        ];
    Event::EdgeEnds { a_1, a_2 } => "EdgeEnds" at "cut"
        {
            "I_1" | "N_1" = Interpolated(a_1, |names| names.one),
            "I_2" | "N_2" = Interpolated(a_2, |names| names.two),
        }
        [
            only(
                When::Recorded("N_1"),
                "The normals at the two ends of edge {upper}–{lower}.",
                "Normal di kedua ujung sisi {upper}–{lower}.",
                &[is("{N_1}"), is("{N_2}")],
            ),
            entry(
                "The intensities at the two ends of edge {upper}–{lower}.",
                "Intensitas di kedua ujung sisi {upper}–{lower}.",
                &[is("{I_1}"), is("{I_2}")],
            ),
        ];
    Event::EdgeInterpolated { direct, incremental } => "EdgeInterpolated" at "cut"
        {
            "I_4" | "N_4" = Interpolated(direct, |names| names.four),
            "I_4_incremental" | "N_4_incremental" = Interpolated(incremental, |names| names.four_incremental),
            "difference" = Interpolated(incremental - direct, |_| "difference"),
        }
        [
            only(
                When::Recorded("N_4"),
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
            entry(
                "The intensity where the scan line cuts edge {upper}–{lower}: the nearer end weighs more.",
                "Intensitas di potongan garis scan dengan sisi {upper}–{lower}: ujung yang lebih dekat lebih berbobot.",
                &[
                    is(
                    "{I_4} = [{y_4} − {y_2}; {y_1} − {y_2}] · {I_1} + [{y_1} − {y_4}; {y_1} − {y_2}] · {I_2}",
                    ),
                    is("{I_4 incremental=I_4_incremental} = I_4′ + ΔI/Δy"),
                    noted("{Δ=difference}", INCREMENTAL),
                    ],
            ),
        ];
    Event::EdgeCut => "EdgeCut" at "cut"
        {
        }
        [
            entry(
                "Edge {upper}–{lower} is cut at x_4 = {x_4}; nothing is interpolated.",
                "Sisi {upper}–{lower} terpotong di x_4 = {x_4}; tidak ada interpolasi.",
                &[],
            ),
        ];
    Event::Span { x_4, x_5, first, end } => "Span" at "span" number "first" scope ("span", "bentang")
        {
            "x_4" = x_4,
            "x_5" = x_5,
            "first" = first,
            "end" = end,
        }
        [
            entry(
                "A span begins: the pixels from {first} on, up to but not including {end}, have their centres between x_4 and x_5.",
                "Bentang dimulai: piksel mulai {first} sampai sebelum {end} berpusat di antara x_4 dan x_5.",
                &[is("{x_4}"), is("{x_5}")],
            ),
        ];
    Event::SpanEnds { a_4, a_5 } => "SpanEnds" at "span"
        {
            "I_4" | "N_4" = Interpolated(a_4, |names| names.four),
            "I_5" | "N_5" = Interpolated(a_5, |names| names.five),
        }
        [
            only(
                When::Recorded("N_4"),
                "The normals at the two ends of the span.",
                "Normal di kedua ujung bentang.",
                &[is("{N_4}"), is("{N_5}")],
            ),
            entry(
                "The intensities at the two ends of the span.",
                "Intensitas di kedua ujung bentang.",
                &[is("{I_4}"), is("{I_5}")],
            ),
        ];
    Event::Pixel { x, y, x_p } => "Pixel" at "pixel" number "x" scope ("pixel", "piksel")
        {
            "x" = x,
            "y" = y,
            "x_P" = x_p,
        }
        [
            entry(
                "Pixel ({x}, {y}) begins: its centre lies at x_P.",
                "Piksel ({x}, {y}) dimulai: pusatnya di x_P.",
                &[is("{x_P} = {x} + 0.5")],
            ),
        ];
    Event::DepthTested { z, nearest, nearer } => "DepthTested" at "depth"
        {
            "z" = z,
            "nearest" = nearest,
            "nearer" = nearer,
        }
        [
            only(
                When::True("nearer"),
                "Nearer than what was drawn here before: it is drawn.",
                "Lebih dekat daripada yang sudah digambar di sini: digambar.",
                &[is("{z} < {nearest}")],
            ),
            entry(
                "Not nearer than what was drawn here before: it stays hidden.",
                "Tidak lebih dekat daripada yang sudah digambar di sini: tersembunyi.",
                &[is("{z} ≥ {nearest}")],
            ),
        ];
    Event::SpanInterpolated { direct, incremental } => "SpanInterpolated" at "interpolation"
        {
            "I_P" | "N_P" = Interpolated(direct, |names| names.pixel),
            "I_P_incremental" | "N_P_incremental" = Interpolated(incremental, |names| names.pixel_incremental),
            "difference" = Interpolated(incremental - direct, |_| "difference"),
        }
        [
            only(
                When::Recorded("N_P"),
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
                "The intensity of the pixel, between the two ends of the span.",
                "Intensitas piksel, di antara kedua ujung bentang.",
                &[
                    is(
                    "{I_P} = [{x_5} − {x_P}; {x_5} − {x_4}] · {I_4} + [{x_P} − {x_4}; {x_5} − {x_4}] · {I_5}",
                    ),
                    is("{I_P incremental=I_P_incremental} = I_P′ + ΔI/Δx"),
                    noted("{Δ=difference}", INCREMENTAL),
                    ],
            ),
        ];
    Event::PixelColored { color } => "PixelColored" at "color"
        {
            "color" = color,
        }
        [
            only(
                When::Recorded("N_P_incremental"),
                "Pixel ({x}, {y}) takes the intensity found at its own point with its own normal.",
                "Piksel ({x}, {y}) mendapat intensitas di titiknya sendiri, dengan normalnya sendiri.",
                &[is("{pixel=color} = {I@}")],
            ),
            only(
                When::Recorded("I_textured"),
                "Pixel ({x}, {y}) takes its textured intensity.",
                "Piksel ({x}, {y}) mendapat intensitas bertekstur.",
                &[is("{pixel=color} = {I textured=I_textured}")],
            ),
            only(
                When::Recorded("x_0"),
                "Pixel ({x}, {y}) takes the ambient term and what each light adds.",
                "Piksel ({x}, {y}) mendapat suku ambien dan tambahan tiap cahaya.",
                &[is("{pixel=color}")],
            ),
            only(
                When::Recorded("I_P_incremental"),
                "Pixel ({x}, {y}) takes its intensity.",
                "Piksel ({x}, {y}) mendapat intensitasnya.",
                &[is("{pixel=color} = {I_P incremental=I_P_incremental}")],
            ),
            entry(
                "Pixel ({x}, {y}) takes the one intensity of the polygon.",
                "Piksel ({x}, {y}) mendapat intensitas poligon.",
                &[is("{pixel=color} = {I@}")],
            ),
        ];
    Event::PixelHidden => "PixelHidden" at "depth"
        {
        }
        [
            entry(
                "Pixel ({x}, {y}) keeps what was drawn there before.",
                "Piksel ({x}, {y}) tetap seperti semula.",
                &[],
            ),
        ];
    Event::SpanDone => "SpanDone" at "span"
        {
        }
        [
            entry(
                "The span is done.",
                "Bentang selesai.",
                &[],
            ),
        ];
    Event::ScanLineDone => "ScanLineDone" at "scan-line"
        {
        }
        [
            entry(
                "Scan line {y} is done.",
                "Garis scan {y} selesai.",
                &[],
            ),
        ];
}

pub(super) const INCREMENTAL: super::Sentence = super::entry::says(
    "By increments: the value before plus a constant step. Here it differs from the direct value by:",
    "Secara inkremental: nilai sebelumnya ditambah langkah tetap. Selisihnya dengan nilai langsung:",
);
