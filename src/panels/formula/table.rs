//! What each kind of step says, and its formulas. An entry is taken by its kind and condition; the first that fits holds.

mod form_factor;
mod pixels;
mod radiosity;
mod rays;
mod series;

use super::super::strings::Words;

/// The sentence and the formulas of one kind of step.
pub struct Entry {
    pub kind: &'static str,
    pub when: When,
    /// `{name}` stands for a told value.
    pub says: Words,
    pub formulas: &'static [Formula],
}

/// `left = right`, a value alone, or a relation.
pub struct Formula {
    pub template: &'static str,
    pub when: When,
    pub note: Option<Words>,
}

/// Where an entry or a formula holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum When {
    Always,
    RecordedField(&'static str),
    Untold(&'static str),
    /// The word told under the name.
    Is(&'static str, &'static str),
    True(&'static str),
    Negative(&'static str),
    NotPositive(&'static str),
    Finite(&'static str),
}

const fn is(template: &'static str) -> Formula {
    Formula {
        template,
        when: When::Always,
        note: None,
    }
}

const fn if_told(name: &'static str, template: &'static str) -> Formula {
    Formula {
        template,
        when: When::RecordedField(name),
        note: None,
    }
}

const fn if_finite(name: &'static str, template: &'static str) -> Formula {
    Formula {
        template,
        when: When::Finite(name),
        note: None,
    }
}

const fn noted(template: &'static str, note: Words) -> Formula {
    Formula {
        template,
        when: When::Always,
        note: Some(note),
    }
}

const fn entry(
    kind: &'static str,
    en: &'static str,
    id: &'static str,
    formulas: &'static [Formula],
) -> Entry {
    only(kind, When::Always, en, id, formulas)
}

const fn only(
    kind: &'static str,
    when: When,
    en: &'static str,
    id: &'static str,
    formulas: &'static [Formula],
) -> Entry {
    let says = Words::new(en, id);
    Entry {
        kind,
        when,
        says,
        formulas,
    }
}

const INCREMENTAL: Words = Words::new(
    "By increments: the value before plus a constant step. Here it differs from the direct value by:",
    "Secara inkremental: nilai sebelumnya ditambah langkah tetap. Selisihnya dengan nilai langsung:",
);

const ON_THE_SLIDE: Words = Words::new(
    "As on the slide, in place of f_{att} · (N·L); it grows with the distance:",
    "Seperti pada slide, sebagai ganti f_{att} · (N·L); nilainya membesar dengan jarak:",
);

/// Those of one method go first: they say more where a step of the same kind occurs in others too.
pub const TABLES: [&[Entry]; 6] = [
    radiosity::TABLE,
    form_factor::TABLE,
    pixels::TABLE,
    rays::TABLE,
    series::TABLE,
    TABLE,
];

const TABLE: &[Entry] = &[
    // Stage
    entry(
        "Frame",
        "The frame begins: {width} × {height} pixels, lit by the ambient light A.",
        "Gambar dimulai: {width} × {height} piksel, dengan cahaya ambien A.",
        &[is("{A}")],
    ),
    entry("FrameDone", "The frame is done.", "Gambar selesai.", &[]),
    entry(
        "Polygon",
        "Polygon {polygon} begins; it belongs to object {object}.",
        "Poligon {polygon} dimulai; bagian dari objek {object}.",
        &[],
    ),
    entry(
        "PolygonDone",
        "Polygon {polygon} is done.",
        "Poligon {polygon} selesai.",
        &[],
    ),
    // Normals
    entry(
        "Vertex",
        "Vertex {vertex} comes up for the first time: its normal is the mean of the faces around it.",
        "Titik sudut {vertex} muncul pertama kali: normalnya adalah rata-rata muka di sekelilingnya.",
        &[is("{P_v}")],
    ),
    entry(
        "FaceNormalAdded",
        "Face {face} shares the vertex: its unit normal is added.",
        "Muka {face} memiliki titik sudut ini: normal satuannya ditambahkan.",
        &[is("{S=sum_N} = {ΣN_k=*N_k}")],
    ),
    entry(
        "VertexNormal",
        "The vertex normal: the mean direction of the face normals, of unit length.",
        "Normal titik sudut: arah rata-rata normal muka, sepanjang satu satuan.",
        &[is("{N_v} = [{ΣN_k=sum_N}; {|ΣN_k|=length}]")],
    ),
    entry(
        "NormalVanished",
        "The face normals cancel out: the first one stands for their mean.",
        "Normal muka saling meniadakan: normal pertama menggantikan rata-ratanya.",
        &[is("{|ΣN_k|=length}"), is("{N_v} = N_1")],
    ),
    entry(
        "VertexLit",
        "The vertex has its intensity: it serves all polygons that share the vertex.",
        "Titik sudut mendapat intensitasnya, untuk semua poligon yang memakainya.",
        &[is("{I_v} = illumination({P_v}, {N_v})")],
    ),
    entry(
        "Middle",
        "One intensity for the whole polygon, at the mean of its vertices.",
        "Satu intensitas untuk seluruh poligon, pada rata-rata titik sudutnya.",
        &[is("{P_m} = [ΣP_k; n]")],
    ),
    // Illumination model
    entry(
        "Illumination",
        "The illumination model at the point P with the unit normal N.",
        "Model pencahayaan di titik P dengan normal satuan N.",
        &[is("{P}"), is("{N}")],
    ),
    only(
        "Viewer",
        When::True("turned"),
        "The eye sees the other side: N was turned toward it.",
        "Mata melihat sisi sebaliknya: N dibalik ke arahnya.",
        &[is("{V} = [eye − P; |eye − P|]"), is("{N}")],
    ),
    entry(
        "Viewer",
        "The unit vector from the point to the eye; N is on its side already.",
        "Vektor satuan dari titik ke mata; N sudah di sisi yang sama.",
        &[is("{V} = [eye − P; |eye − P|]")],
    ),
    entry(
        "Ambient",
        "The ambient term: light from all around.",
        "Suku ambien: cahaya dari segala arah.",
        &[is("{I_a} = {k_a} · {A}")],
    ),
    only(
        "Light",
        When::Finite("d"),
        "Light {light} at the distance d, weakened by the attenuation f_{att}.",
        "Cahaya {light} pada jarak d, dilemahkan oleh atenuasi f_{att}.",
        &[
            is("{d} = |light − P|"),
            is("{f_{att}=f_att} = [1; a_0 + a_1·d + a_2·d^2]"),
            is("{I_{light}=I_light}"),
        ],
    ),
    entry(
        "Light",
        "Light {light} is infinitely far: nothing weakens it.",
        "Cahaya {light} jauh tak berhingga: tidak ada pelemahan.",
        &[is("{f_{att}=f_att}"), is("{I_{light}=I_light}")],
    ),
    entry(
        "ToLight",
        "The unit vector to the light, and its cosine with the normal.",
        "Vektor satuan ke cahaya, dan kosinusnya dengan normal.",
        &[is("{L}"), is("{N_dot_L} = {N} · {L}")],
    ),
    entry(
        "Diffuse",
        "The diffuse term: proportional to the cosine between normal and light.",
        "Suku difus: sebanding dengan kosinus antara normal dan cahaya.",
        &[
            is("{I_d} = {k_d} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {N_dot_L})"),
            Formula {
                template: "{slide factor=slide_factor} = [{d} · {cos φ=N_dot_L}; √{d}]",
                when: When::Finite("d"),
                note: Some(ON_THE_SLIDE),
            },
        ],
    ),
    entry(
        "Mirrored",
        "The light's direction mirrored at the normal, and its cosine with the direction of the eye (Phong).",
        "Arah cahaya dicerminkan pada normal, dan kosinusnya dengan arah mata (Phong).",
        &[
            is("{R} = 2 ({N_dot_L}) {N} − {L}"),
            is("{R_dot_V} = {R} · {V}"),
        ],
    ),
    entry(
        "Halfway",
        "Half-way between light and eye, and its cosine with the normal (Blinn).",
        "Tengah antara cahaya dan mata, dan kosinusnya dengan normal (Blinn).",
        &[
            is("{H} = [{L} + {V}; |{L} + {V}|]"),
            is("{N_dot_H} = {N} · {H}"),
        ],
    ),
    only(
        "Specular",
        When::NotPositive("N_dot_L"),
        "No highlight: the light is behind the surface, N·L ≤ 0.",
        "Tanpa sorotan: cahaya di balik permukaan, N·L ≤ 0.",
        &[is("{I_s}")],
    ),
    only(
        "Specular",
        When::RecordedField("R_dot_V"),
        "The specular term: the highlight, narrower the larger n is.",
        "Suku spekular: sorotan, makin sempit bila n makin besar.",
        &[is(
            "{I_s} = {k_s} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {R_dot_V})^{n=n_s}",
        )],
    ),
    entry(
        "Specular",
        "The specular term: the highlight, narrower the larger n is.",
        "Suku spekular: sorotan, makin sempit bila n makin besar.",
        &[is(
            "{I_s} = {k_s} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {N_dot_H})^{n=n_s}",
        )],
    ),
    only(
        "LightAdded",
        When::RecordedField("I_s"),
        "What light {light} adds to the intensity.",
        "Yang ditambahkan cahaya {light} pada intensitas.",
        &[is("{I_d + I_s=I_added} = {I_d} + {I_s}")],
    ),
    only(
        "Illuminated",
        When::RecordedField("I_a"),
        "The intensity of the point: the ambient term and what each light adds.",
        "Intensitas titik: suku ambien dan yang ditambahkan tiap cahaya.",
        &[is("{I} = {I_a} + {Σ(I_d + I_s)=+I_added}")],
    ),
    // Edge table
    entry(
        "EdgeTable",
        "The edge table of a polygon of {corners} corners begins.",
        "Tabel sisi dari poligon dengan {corners} sudut dimulai.",
        &[],
    ),
    entry(
        "CornerPlaced",
        "Corner {corner} on the screen, in pixels; z is its depth.",
        "Sudut {corner} di layar, dalam piksel; z kedalamannya.",
        &[
            is("{x}"),
            is("{y}"),
            is("{z}"),
            if_told("I", "{I}"),
            if_told("N", "{N}"),
        ],
    ),
    entry(
        "EdgeEntered",
        "Edge {upper}–{lower} is entered: it cuts the scan lines from {first} on, up to but not including {end}.",
        "Sisi {upper}–{lower} dimasukkan: memotong garis scan mulai {first} sampai sebelum {end}.",
        &[
            is(
                "{dx_dy} = [{x_2=x@corner:lower} − {x_1=x@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
            ),
            if_told(
                "dI_dy",
                "{dI_dy} = [{I_2=I@corner:lower} − {I_1=I@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
            ),
            if_told(
                "dN_dy",
                "{dN_dy} = [{N_2=N@corner:lower} − {N_1=N@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
            ),
        ],
    ),
    entry(
        "EdgeSkipped",
        "Edge {from}–{to} passes the centre of no row: it is left out.",
        "Sisi {from}–{to} tidak melewati pusat baris mana pun: dilewati.",
        &[],
    ),
    entry(
        "EdgeTableBuilt",
        "The edge table is built; edges in it: {edges}.",
        "Tabel sisi selesai; jumlah sisi: {edges}.",
        &[],
    ),
    // Scan line and edges
    entry(
        "ScanLine",
        "Scan line {y} begins: its pixel centres lie at y_4 = {y_4}.",
        "Garis scan {y} dimulai: pusat pikselnya pada y_4 = {y_4}.",
        &[is("{y_4} = {y} + 0.5")],
    ),
    only(
        "Edge",
        When::RecordedField("x_4"),
        "The scan line cuts edge {upper}–{lower} at x_4.",
        "Garis scan memotong sisi {upper}–{lower} di x_4.",
        &[is(
            "{x_4} = {x_1=x@corner:upper} + ({y_4} − {y_1}) · {Δx/Δy=dx_dy@edge:edge}",
        )],
    ),
    entry(
        "EdgeEnds",
        "The intensities at the two ends of edge {upper}–{lower}.",
        "Intensitas di kedua ujung sisi {upper}–{lower}.",
        &[is("{I_1}"), is("{I_2}")],
    ),
    entry(
        "EdgeInterpolated",
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
    entry(
        "EdgeCut",
        "Edge {upper}–{lower} is cut at x_4 = {x_4}; nothing is interpolated.",
        "Sisi {upper}–{lower} terpotong di x_4 = {x_4}; tidak ada interpolasi.",
        &[],
    ),
    // Span and pixels
    entry(
        "Span",
        "A span begins: the pixels from {first} on, up to but not including {end}, have their centres between x_4 and x_5.",
        "Bentang dimulai: piksel mulai {first} sampai sebelum {end} berpusat di antara x_4 dan x_5.",
        &[is("{x_4}"), is("{x_5}")],
    ),
    entry(
        "SpanEnds",
        "The intensities at the two ends of the span.",
        "Intensitas di kedua ujung bentang.",
        &[is("{I_4}"), is("{I_5}")],
    ),
    entry(
        "Pixel",
        "Pixel ({x}, {y}) begins: its centre lies at x_P.",
        "Piksel ({x}, {y}) dimulai: pusatnya di x_P.",
        &[is("{x_P} = {x} + 0.5")],
    ),
    only(
        "DepthTested",
        When::True("nearer"),
        "Nearer than what was drawn here before: it is drawn.",
        "Lebih dekat daripada yang sudah digambar di sini: digambar.",
        &[is("{z} < {nearest}")],
    ),
    entry(
        "DepthTested",
        "Not nearer than what was drawn here before: it stays hidden.",
        "Tidak lebih dekat daripada yang sudah digambar di sini: tersembunyi.",
        &[is("{z} ≥ {nearest}")],
    ),
    entry(
        "SpanInterpolated",
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
    only(
        "PixelColored",
        When::RecordedField("I_P_incremental"),
        "Pixel ({x}, {y}) takes its intensity.",
        "Piksel ({x}, {y}) mendapat intensitasnya.",
        &[is("{pixel=color} = {I_P incremental=I_P_incremental}")],
    ),
    entry(
        "PixelColored",
        "Pixel ({x}, {y}) takes the one intensity of the polygon.",
        "Piksel ({x}, {y}) mendapat intensitas poligon.",
        &[is("{pixel=color} = {I@}")],
    ),
    entry(
        "PixelHidden",
        "Pixel ({x}, {y}) keeps what was drawn there before.",
        "Piksel ({x}, {y}) tetap seperti semula.",
        &[],
    ),
    entry("SpanDone", "The span is done.", "Bentang selesai.", &[]),
    entry(
        "ScanLineDone",
        "Scan line {y} is done.",
        "Garis scan {y} selesai.",
        &[],
    ),
    // Wireframe
    entry(
        "Edge",
        "The edge between vertices {from} and {to} is not drawn yet.",
        "Sisi antara titik sudut {from} dan {to} belum digambar.",
        &[],
    ),
    entry(
        "EdgeClipped",
        "The part of the edge within the frame, in pixels.",
        "Bagian sisi yang di dalam gambar, dalam piksel.",
        &[is("{x_1}"), is("{y_1}"), is("{x_2}"), is("{y_2}")],
    ),
    entry(
        "EdgeUnseen",
        "Nothing of this edge is within the frame.",
        "Tidak ada bagian sisi ini di dalam gambar.",
        &[],
    ),
    entry(
        "StepChosen",
        "One pixel a step, along the longer of the two directions.",
        "Satu piksel tiap langkah, sepanjang arah yang lebih panjang.",
        &[
            is("{n} = ⌈max(|{x_2} − {x_1}|, |{y_2} − {y_1}|)⌉"),
            is("{Δx/n=dx} = [{x_2} − {x_1}; {n}]"),
            is("{Δy/n=dy} = [{y_2} − {y_1}; {n}]"),
        ],
    ),
    entry(
        "PixelPlotted",
        "Pixel ({x}, {y}) is plotted: the one in which the exact point lies.",
        "Piksel ({x}, {y}) digambar: piksel yang memuat titik tepatnya.",
        &[
            is("{x} = min(⌊{x_exact}⌋, {width} − 1)"),
            is("{y} = min(⌊{y_exact}⌋, {height} − 1)"),
        ],
    ),
    entry(
        "EdgeDone",
        "The edge is drawn.",
        "Sisi selesai digambar.",
        &[],
    ),
];
